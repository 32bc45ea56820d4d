"""The book of tests leaves nothing out: what each row asks for, each wire and each delay is looked for in its steps."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.commissioning.book import book
from interlock.commissioning.step import Sheet, Step
from interlock.diag.called import called
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import Allocation, allocate
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.table.cells import RouteKind, Shows
from interlock.table.rows import InterlockingTable, RouteRow

Made = tuple[Layout, InterlockingTable, Controller, Allocation, list[Step]]
FOR_TESTS = ("token", "overlap_past_signals", "identifier", "identifiers", "called_on", "held_apart")
NAMES = [
    *("layouts/flank_lab", "layouts/depot", "layouts/incline_hoist", "layouts/crossing_line"),
    *(f"tests/layouts_for_tests/{n}" for n in FOR_TESTS),
]


@cache
def made(name: str) -> Made:
    """A layout with its table, controller, addresses and book."""
    found = check_file(f"{name}.yaml")
    assert found.layout is not None and found.table is not None
    controller = lower(found.layout, found.table)
    allocation, text = allocate(found.layout, controller), runtime_py(controller, [])
    return (
        found.layout,
        found.table,
        controller,
        allocation,
        list(book(found.layout, found.table, controller, allocation, text)),
    )


def tried_alone(table: InterlockingTable) -> list[RouteRow]:
    """The routes that have tests of their own: what lies past a signal is tested with the route that leads there."""
    return [r for r in table.routes if r.kind is not RouteKind.IDENTIFIER]


def of(steps: list[Step], r: RouteRow) -> list[Step]:
    """The tests of a route."""
    return [s for s in steps if s.sheet is Sheet.ROUTES and s.of == r.id]


def asked(layout: Layout, table: InterlockingTable, r: RouteRow) -> set[str]:
    """What a route asks for, as it is taken away, but for foul sections with a condition and the direction."""
    parts = table.parts(r)
    over = {s for p in parts if p.locking.overlap is not None for s, _ in p.locking.overlap.ways}
    clear: set[str] = {c.section for p in parts for c in (*p.clear.sections, *(p.clear.demanded or ()))} | over
    clear |= {c.section for p in parts for c in p.clear.foul if c.when is None}
    clear |= {c.section for p in parts for c in p.conditions.block}
    clear |= {c.name for p in parts for c in p.clear.space if not c.lamp}
    seen = {s.id for s in layout.track.sections if s.detected}
    out = {f"{called('section', s)} reported occupied" for s in clear & seen}
    out |= {f"{layout.machines.named(d.machine)} without detection" for p in parts for d in p.locking.points}
    out |= {f"condition {c.condition} not fulfilled" for p in parts for c in p.conditions.external}
    locked = {s for p in parts for s, _ in p.path.locked} | over
    out |= {f"{called('section', s)} blocked by the operator" for s in locked}
    return out | {"inputs lost"}


@pytest.mark.parametrize("name", NAMES)
def test_whatever_a_row_asks_for_is_taken_away_before_the_signal_opens_and_after(name: str) -> None:
    layout, table, _, _, steps = made(name)
    for r in tried_alone(table):
        mine = of(steps, r)
        falls = {s.do for s in mine if s.expect.startswith("it shows stop in the same scan")}
        stays = {s.do for s in mine if s.expect.endswith("stays at stop") and ": ask for " in s.do}
        for what in sorted(asked(layout, table, r)):
            assert any(what in x for x in falls), (r.id, what)
            assert any(x.startswith(what) for x in stays), (r.id, what)
        tokens = {p.conditions.token.boundary for p in table.parts(r) if p.conditions.token is not None}
        assert all(any(f"the direction at {b} not asked for" in x for x in stays) for b in tokens), r.id


@pytest.mark.parametrize("name", NAMES)
def test_every_hostile_route_is_asked_for_and_every_machine_is_tried(name: str) -> None:
    _, table, _, _, steps = made(name)
    for r in tried_alone(table):
        mine = of(steps, r)
        refused = [s.do for s in mine if "hostile" in s.do]
        for h in r.locking.hostile.routes:
            assert any(x.endswith(f"hostile {called('route', h)}") for x in refused), (r.id, h)
        tried = [s.do for s in mine if ": try to " in s.do]
        assert len(tried) == len({d.machine for p in table.parts(r) for d in p.locking.points}), r.id


@pytest.mark.parametrize("name", NAMES)
def test_a_train_drives_over_each_section_and_each_that_it_leaves_is_released_after_its_delay(name: str) -> None:
    _, table, _, _, steps = made(name)
    several = 0
    for r in (r for r in tried_alone(table) if r.kind is not RouteKind.CALL_ON):
        parts = table.parts(r)
        path = list(dict.fromkeys(s for p in parts for s in p.path.section_ids))
        drives = [s for s in of(steps, r) if " comes into " in s.do]
        assert [re.split(",| where", s.do.split(" comes into ")[1])[0] for s in drives] == path, r.id
        held = {s for p in parts if p.locking.overlap is not None for s, _ in p.locking.overlap.ways}
        later = {x.section: x.delay_s for p in parts for x in p.locking.release}
        released = {s: later[s] for s in path[:-1] if s in later and s not in held}
        told = [m for s in drives for m in re.findall(r"(?:^|; )(\S+) is released after (\S+) s", s.expect)]
        assert {s: float(x) for s, x in told} == released and len(told) == len(released), r.id
        several = max(several, len(released))
    assert several > 1 or name not in NAMES[:2]


@pytest.mark.parametrize("name", NAMES)
def test_a_cancelled_route_stays_locked_for_the_delay_of_its_row(name: str) -> None:
    _, table, _, _, steps = made(name)
    for r in tried_alone(table):
        told = [s.expect for s in of(steps, r) if s.expect.startswith("stop at once; ")]
        found = {float(x) for s in told for x in re.findall(r"stays locked for (\S+) s,", s)}
        assert found == {r.locking.approach.delay_s}, r.id


@pytest.mark.parametrize("name", NAMES)
def test_the_first_step_says_where_each_machine_comes_to_lie_and_what_is_lit(name: str) -> None:
    layout, table, controller, _, steps = made(name)
    lamps = controller.symbols.aspects
    for r in tried_alone(table):
        first = of(steps, r)[0]
        for d in (d for p in table.parts(r) for d in p.locking.points):
            said = f"{layout.machines.named(d.machine)} {layout.machines.word(d.machine, d.position)};"
            assert said in first.expect, (r.id, said)
        if r.signal.aspect.shows is Shows.NEXT and r.entry in lamps.caution:
            assert "caution" in first.expect and str(lamps.caution[r.entry]) in first.expect, r.id
        if r.kind is RouteKind.CALL_ON:
            assert str(lamps.stop[r.entry]) in first.expect, r.id


@pytest.mark.parametrize("name", NAMES[:2])
def test_each_wire_has_its_steps_at_its_address_and_an_input_reads_0_when_its_circuit_is_open(name: str) -> None:
    _, _, _, allocation, steps = made(name)
    alive = {c.variable for c in (*allocation.heartbeats, *allocation.diagnoses, *allocation.sent)}
    for c in allocation.wires:
        words = re.compile(rf"\b{re.escape(c.variable)}\b")
        mine = [s for s in steps if s.sheet is Sheet.WIRES and (words.search(s.do) or words.search(s.expect))]
        assert all(c.substation in s.of and f"{c.direction}{c.byte}.{c.bit}" in s.of for s in mine), c
        if c.variable in alive:
            assert len(mine) == 1 and "while all runs" in mine[0].do
        elif c.direction == "I":
            assert [s.expect.split(",")[0] for s in mine] == [f"{c.variable} reads {v}" for v in (1, 0, 0)], c
            assert all(c.note in s.do for s in mine[:2]), c
            assert "contrary" in mine[1].do and "open the circuit" in mine[2].do, c
        else:
            assert [s.do.split(",")[0] for s in mine] == [f"set {c.variable} to {v}" for v in (1, 0)], c
            assert all(c.note in s.expect for s in mine) and mine[0].expect.endswith("nothing else"), c
            assert mine[1].expect.startswith("no more"), c


@pytest.mark.parametrize("name", [*NAMES, "layouts/terminus"])
def test_a_machine_is_tried_with_a_vehicle_over_each_of_its_ends_and_late(name: str) -> None:
    layout, _, _, _, steps = made(name)
    several = 0
    for m in layout.machines:
        mine = [s for s in steps if s.sheet is Sheet.MACHINES and s.of == m]
        if mine and m not in layout.machines.device:
            for s in layout.machines.sections[m]:
                assert any(x.do.startswith(f"{called('section', s)} reported occupied") for x in mine), (m, s)
            several = max(several, len(layout.machines.sections[m]))
        late = [float(x) for s in mine for x in re.findall(r"^an alarm after (\S+) s", s.expect)]
        stated = dict(layout.pointwork.supervision).get(m, layout.principles.point_supervision_s)
        assert late == [stated] * bool(mine), m
    assert several > 1 or name != "layouts/terminus"


@pytest.mark.parametrize("name", NAMES)
def test_each_timer_is_timed(name: str) -> None:
    _, _, controller, _, steps = made(name)
    told = {s.of: s.expect.removeprefix("no less than ").removesuffix(" s") for s in steps if s.sheet is Sheet.TIMES}
    assert {k: float(x) for k, x in told.items()} == {str(t.name): t.preset_ms / 1000 for t in controller.timers}


@pytest.mark.parametrize("name", ["layouts/junction", "tests/layouts_for_tests/foul_driven"])
def test_a_section_that_is_foul_while_a_point_lies_so_is_tested_where_the_point_lies_so(name: str) -> None:
    """On the bench points lie normal where the route does not want them."""
    _, table, _, _, steps = made(name)
    for r in tried_alone(table):
        parts = table.parts(r)
        lies = {d.machine: d.position for p in parts for d in (*p.locking.points, *p.locking.driven)}
        for c in (c for p in parts for c in p.clear.foul):
            foul = c.when is None or lies.get(c.when[0], Position.NORMAL) is c.when[1]
            what = f"{called('section', c.section)} reported occupied"
            told = any(what in s.do for s in of(steps, r) if s.expect.startswith("it shows stop"))
            assert told is foul, (r.id, c)
    conditional = [c for r in table.routes for c in r.clear.foul if c.when is not None]
    assert conditional or name.endswith("foul_driven")


PAST = """interlock: 1
name: past
principles: {line_speed_kmh: 40}
boundaries: {W: {approach: apw 300}, E: {approach: ape 300, block: token}}
tracks: {t: [W, a 100, b 100, c 100, d 100, f 100, E]}
signals:
  X: {from: W, into: a}
  Y: {from: E, into: f}
  S: {from: b, into: c}
  T: {from: d, into: f, identifier: yes}
level_crossings: {LC9: {over: [f]}}
conditions: {BRIDGE: {text: bridge locked, over: [f]}}
overlaps: {T: {length: 0}}
"""


def test_what_lies_past_a_signal_that_a_route_passes_is_tested_with_it(tmp_path: Path) -> None:
    (tmp_path / "past.yaml").write_text(PAST, "utf-8")
    _, table, _, _, steps = made(str(tmp_path / "past"))
    mine = [s.do for s in of(steps, next(r for r in table.routes if r.path.onward is not None))]
    for what in ("condition BRIDGE not fulfilled", "LC9 without detection", "section ape reported occupied"):
        assert any(what in x and "at proceed" in x for x in mine), what
    assert any("the direction at E not asked for" in x for x in mine)
    assert "the direction at E asked for" in mine[0]
