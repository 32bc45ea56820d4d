"""Shapes of real stations: their routes, what `check` says of them, their verdict; slips blade by blade."""

from __future__ import annotations

import csv
import io
import re
from itertools import pairwise
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.io import channels_csv
from interlock.frontend import load_text
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable
from interlock.verify import Rejected
from tests.grow import grow
from tests.layouts import built, grown
from tests.written import told


def text_of(name: str) -> str:
    """A layout of the tests."""
    return Path(f"tests/layouts_for_tests/{name}.yaml").read_text("utf-8")


def said(text: str) -> tuple[Layout, InterlockingTable, set[str]]:
    """Layout and table of a text that has no errors, and the codes of what is said of it."""
    sink = Sink()
    layout, source = load_text("station.yaml", text, sink)
    assert layout is not None, sink.diagnostics
    table = derive(layout, sink)
    source.check_allowed(sink)
    assert not sink.has_errors and audit(layout, table) == ()
    return layout, table, {d.code for d in sink.diagnostics}


def proved(layout: Layout, table: InterlockingTable) -> bool:
    """Every claim, with every invariant."""
    result = prove(System(layout, lower(layout, table)), Limits(search_s=0))
    return {c.verdict for c in result.claims} == {Verdict.PROVED} and not result.dropped


STATIONS: dict[str, tuple[int, set[str]]] = {
    "bare_signal": (2, {"IL7004", "IL7006"}),  # an overlap beyond a signal that starts nothing
    "both_ways": (5, {"IL4010", "IL7004", "IL7006"}),  # substitute protection, from two sections of one route
    "branches": (8, {"IL4010", "IL7004"}),  # a diamond, a derailer, a siding that no route reaches
    "dead_end": (7, set()),  # four signals towards one buffer; a track joined to another, end to end
    "door": (14, {"IL3025"}),  # a road that is no berth
    "loading_loop": (9, set()),  # a balloon loop at a mine, both ways round
    "parallel": (4, {"IL4005", "IL7006"}),  # two trains side by side past a crossover
    "scissors_apart": (12, {"IL7006"}),
    "slip": (12, set()),
    "slow_barrier": (10, set()),  # machines with times of supervision of their own
    "throat": (78, set()),  # six tracks, ladders, crossovers between up and down
    "turning_loop": (9, set()),
    "wye": (15, set()),
}


@pytest.mark.parametrize("name", STATIONS)
def test_a_station_has_its_routes_says_what_it_should_and_is_proved(name: str) -> None:
    layout, table, codes = said(text_of(name))
    assert (len(table.routes), codes) == STATIONS[name]
    assert proved(layout, table)


def test_trains_turn_in_a_loop_over_the_same_point() -> None:
    _, table, _ = said(text_of("turning_loop"))
    chain = ("W1-W2", "W2-W3", "W3-A1", "A1-C1", "C1-WO", "WO-W")
    assert set(chain) <= set(table.route)
    assert all(table.route[a].exit == table.route[b].entry for a, b in pairwise(chain))  # type: ignore[index]


def test_loaded_trains_leave_every_cross_cut_of_the_mine_with_five() -> None:
    layout, table, _ = built("heishan")
    for k, name in enumerate(("XL1", "XL2", "XL3", "XL4", "XL5"), 1):
        reached, todo = set(), [name]
        while todo:
            at = todo.pop()
            ends = {r.exit for r in table.routes if r.entry == at and r.kind == "main"} - reached
            reached |= ends
            todo += sorted(ends)
        assert "OUT" in reached, f"cross-cut {k}"
    assert len(table.routes) == 19 and layout.declared.zones[0].trains == 4


@pytest.mark.parametrize(
    ("near", "far"),
    [
        ("[W, k1 150, k2 150, far.start]", "[k3 150, k4 150, B]"),
        ("[W, k1 150, k2 150, far.start]", "[near.end, k3 150, k4 150, B]"),
        ("[W, k1 150, k2 150, far.end]", "[B, k4 150, k3 150]"),
        ("[W, k1 150, k2 80]", "[near.end, k2 70, k3 150, k4 150, B]"),
    ],
)
def test_tracks_are_joined_end_to_end_from_either_side(near: str, far: str) -> None:
    text = text_of("dead_end")
    other = text.replace("[W, k1 150, k2 150]", near).replace("[near.end, k3 150, k4 150, B]", far)
    (_, one, _), (_, two, _) = said(text), said(other)
    assert [r.id for r in one.routes] == [r.id for r in two.routes]
    assert agree(*told(other), specification.shipped()).left == ()


def test_trains_close_up_towards_a_buffer() -> None:
    _, table, _ = said(text_of("dead_end"))
    assert {r.id for r in table.routes} >= {"A1-A2", "A2-A3", "A3-A4", "A4-B"}
    assert not {"A3-A4", "A4-B"} & {h.route for h in table.route[RouteId("A1-A2")].locking.hostile}


# --- a first signal that stands further in ---------------------------------------------------------------

FURTHER_IN = """interlock: 1
name: further_in
principles: {line_speed_kmh: 30}
boundaries:
  W: {approach: w0 600}
  E: {approach: e0 600}
tracks:
  line: [W, q1 150, q2 200, q3 200, E]
signals:
  A: {from: q1, into: q2}
  B: {from: E, into: q3}
  C: {from: q2, into: q3}
  D: {from: q3, into: q2}
"""


def test_what_is_advised_for_a_first_signal_further_in_is_a_layout_that_is_proved() -> None:
    sink = Sink()
    assert load_text("line.yaml", FURTHER_IN, sink)[0] is None
    (found,) = sink.diagnostics
    advice = dict(re.findall(r"`(\w+): (\{.*?\})`", found.fix or ""))
    (begins,) = re.findall(r"begins `\[(.*?) \.\.\.", found.fix or "")
    assert found.code == "IL3011" and advice == {"W": "{approach: q1 150}", "A": "{from: W, ...}"} and begins == "W, q2"
    text = FURTHER_IN.replace("{approach: w0 600}", advice["W"]).replace("W, q1 150, q2", begins)
    layout, table, _ = said(text.replace("A: {from: q1,", "A: {from: W,"))
    assert proved(layout, table)
    assert table.route[RouteId("A-C")].locking.approach.sections == ("q1",), "whoever is in q1 may be on his way"
    assert [b.section for b in table.route[RouteId("D-W")].conditions.block] == ["q1"], "a departure needs it clear"


# --- supervision ---------------------------------------------------------------------------------------


def test_each_machine_is_watched_for_its_own_time() -> None:
    layout, table, _ = said(text_of("slow_barrier"))
    controller = lower(layout, table)
    presets = {t.name: t.preset_ms for t in controller.timers}
    watched = {str(m): presets[name] for m, name in controller.symbols.machines.late_timer.items()}
    assert watched == {"1": 6000, "7a": 7000, "7b": 7000, "D": 8000, "LC": 20000}


def test_a_controller_that_watches_a_machine_for_less_is_not_accepted() -> None:
    text = text_of("slow_barrier")
    for stated in ("supervision: 20", "supervision: 7"):
        _, system, written = told(text.replace(f", {stated}", ""))
        with pytest.raises(Rejected):
            agree(loaded(text), system, written, specification.shipped())


def test_a_machine_is_watched_for_no_less_than_it_runs() -> None:
    for stated in ("supervision: 20", "supervision: 6", "supervision: 7"):
        sink = Sink()
        load_text("station.yaml", text_of("slow_barrier").replace(stated, "supervision: 3"), sink)
        assert {d.code for d in sink.diagnostics} == {"IL3023"}, stated


@pytest.mark.parametrize(("point", "codes"), [("P2", {"IL3024"}), ("P1", set())])
def test_an_overlap_that_swings_waits_for_its_slowest_machine_and_for_no_other(point: str, codes: set[str]) -> None:
    sink = Sink()
    text = text_of("swing").replace(f"  {point}: {{", f"  {point}: {{supervision: 200, ")
    load_text("swing.yaml", text, sink)
    assert {d.code for d in sink.diagnostics if d.severity == "error"} == codes


def test_no_overlap_swings_where_machines_wait_for_each_other() -> None:
    """A machine that waits for its start could turn under a train that has come in meanwhile."""
    sink = Sink()
    load_text("swing.yaml", text_of("swing") + "principles: {point_start_gap_s: 0.5}\n", sink)
    assert {d.code for d in sink.diagnostics if d.severity == "error"} == {"IL3024"}
    assert "one after the other" in sink.diagnostics[-1].message


# --- slips ---------------------------------------------------------------------------------------------

ARMS = "arms: [[nw.end, se.start], [sw.end, ne.start]]"
WAYS = {("N1", "SE"), ("N1", "NE"), ("N2", "NE"), ("N2", "SE"), ("P3", "SW"), ("P3", "NW"), ("P4", "NW"), ("P4", "SW")}
SLIPS = {
    "": (WAYS, {"7a": ("1b and 2b", "1a", "2a"), "7b": ("1a and 2a", "1b", "2b")}),
    "blades: near": (WAYS, {"7a": ("1a and 2a", "1b", "2b"), "7b": ("1b and 2b", "1a", "2a")}),
    "single: 1a-2b": (WAYS - {("N2", "SE"), ("P4", "SW")}, {"7a": ("1a", "1b", "2b"), "7b": ("2b", "2a", "1a")}),
    "single: 2a-1b": (WAYS - {("N1", "NE"), ("P3", "NW")}, {"7a": ("2a", "2b", "1b"), "7b": ("1b", "1a", "2a")}),
    "machines: [7]": (WAYS, {"7": ("1a", "1b", "2b")}),
    "machines: [7, 7]": (WAYS, {"7": ("2b", "2a", "1a")}),
}


def slip(kind: str) -> str:
    """The layout with a kind of slip."""
    return text_of("slip").replace(ARMS, f"{ARMS}, {kind}" if kind else ARMS)


@pytest.mark.parametrize("kind", SLIPS)
def test_a_slip_of_any_kind_has_all_its_routes_is_proved_and_wired_blade_by_blade(kind: str) -> None:
    layout, table, _ = said(slip(kind))
    ways, blades = SLIPS[kind]
    assert {(r.entry, r.exit) for r in table.routes if r.entry[0] in "NP"} == ways
    assert proved(layout, table)
    assert agree(*told(slip(kind)), specification.shipped()).left == ()
    controller = lower(layout, table)
    rows = csv.DictReader(io.StringIO(channels_csv(layout, controller, allocate(layout, controller))))
    when = {row["Variable"]: row["When 1"] for row in rows}
    for machine, (at, normal, reverse) in blades.items():
        for wire, to in (("DN", normal), ("DR", reverse), ("YN", normal), ("YR", reverse)):
            assert f"blades at {at} to {to}" in when[f"{wire}_{machine}"]


def test_a_slip_leads_where_the_blades_of_the_wiring_list_lead() -> None:
    """The position of a machine in a route's row, and the end to which its blades then lead: along the path."""
    leads = {("N1", "SE"): "1a 1b", ("N1", "NE"): "1a 2b", ("N2", "NE"): "2a 2b", ("N2", "SE"): "2a 1b"}
    for kind in SLIPS:
        layout, table, _ = said(slip(kind))
        for r in table.routes:
            path = leads.get((r.entry, r.exit), "").split()
            lies = {p.machine: p.position for p in r.locking.points if p.role == "path"}
            for b in layout.pointwork.blades if path else ():
                machine, first = layout.pointwork.point[b.point].machine, set(b.at) & set(path)
                if len(b.at) == 2 or first:  # blades beside the path lead nowhere that matters
                    assert b.to(lies[machine]) in path and b.to(lies[machine]) not in first, (kind, r.id, b)


def test_a_controller_wired_after_the_other_convention_is_not_accepted() -> None:
    for one, other in (("", "blades: near"), ("", "machines: [7]"), ("single: 1a-2b", "single: 2a-1b")):
        _, system, text = told(slip(one))
        with pytest.raises(Rejected):
            agree(loaded(slip(other)), system, text, specification.shipped())


@pytest.mark.parametrize("kind", ["machines: [{}m]", "blades: near"])
def test_slips_of_layouts_that_grow_at_random(kind: str) -> None:
    spec = re.compile(r"(?m)^  (\w+): \{(section: \w+, arms: \[\[[^\]]*\], \[[^\]]*\]\])[^}]*\}")
    seen = 0
    for seed in range(60):
        text = grow(seed)
        changed = spec.sub(lambda m: f"  {m[1]}: {{{m[2]}, {kind.format(m[1])}}}", text)
        made = grown(changed) if "slips:" in text else None
        if made is None or made[2].has_errors:
            continue
        layout, table, _ = made
        assert audit(layout, table) == (), seed
        if not seen and kind != "blades: near":
            assert proved(layout, table), seed
        seen += 1
    assert seen > 1


def test_machines_of_a_slip_that_are_named_the_other_way_round_are_told_how() -> None:
    sink = Sink()
    text = text_of("slip").replace("start]]}", "start]], machines: [7b, 7a]}")
    load_text("slip.yaml", text, sink)
    told_ = [d for d in sink.diagnostics if d.code == "IL2002"]
    assert len(told_) == 2 and all("blades: near" in str(d.fix) for d in told_)
    assert {d.span.line for d in told_ if d.span} == {text[: text.index("machines")].count("\n") + 1}
