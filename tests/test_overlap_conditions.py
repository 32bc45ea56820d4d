"""What lies over an overlap: a train that overruns its signal meets the condition (R17) or the crossing there, too."""

from __future__ import annotations

from collections.abc import Collection
from copy import deepcopy
from dataclasses import replace
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable
from tests.layouts import built, grown
from tests.test_runtime import module_of

PLAIN = "../tests/layouts_for_tests/overlap_condition"
SWING = (Path(__file__).parent / "layouts_for_tests" / "swing.yaml").read_text(encoding="utf-8")


def asked(table: InterlockingTable, route: str) -> list[str]:
    return [c.condition for c in table.route[RouteId(route)].conditions.external]


def not_proved(layout: Layout, table: InterlockingTable) -> set[str]:
    found = prove(System(layout, lower(layout, table)))
    return {c.id for c in found.claims if c.verdict is not Verdict.PROVED}


def without(table: InterlockingTable, routes: Collection[str]) -> InterlockingTable:
    """The table in which some routes ask for nothing from outside."""
    bare = (replace(r, conditions=replace(r.conditions, external=())) if r.id in routes else r for r in table.routes)
    return replace(table, routes=tuple(bare))


def swinging(more: str) -> tuple[Layout, InterlockingTable]:
    made = grown(SWING + more)
    assert made is not None
    return made[:2]


def test_a_route_asks_for_a_condition_over_its_overlap() -> None:
    _, table, _ = built(PLAIN)
    assert asked(table, "B-C") == ["GATE"] and asked(table, "C-E") == ["GATE"] and asked(table, "A-B") == []
    (cell,) = table.route[RouteId("B-C")].conditions.external
    assert cell.because.text == "a train that overruns C may come to q1"


def test_a_table_without_it_is_found_out_by_the_audit_and_by_the_proof() -> None:
    layout, table, _ = built(PLAIN)
    weak = without(table, ["B-C"])
    assert [(f.route, f.column) for f in audit(layout, weak)] == [("B-C", "conditions")]
    assert not_proved(layout, weak) == {"S-OVERLAP"}


def test_where_the_overlap_swings_a_route_asks_for_what_each_alternative_needs() -> None:
    layout, table = swinging("conditions:\n  DRAG: {text: sand drag in order, over: [q7]}\n")
    those = [r.id for r in table.routes if r.exit == "X3"]
    assert len(those) == 2 and all(asked(table, r) == ["DRAG"] for r in those)
    assert audit(layout, table) == ()
    for r in those:
        assert [(f.route, f.column) for f in audit(layout, without(table, [r]))] == [(r, "conditions")]
    assert not_proved(layout, table) == set()
    assert not_proved(layout, without(table, those)) == {"S-OVERLAP"}


def test_where_it_does_not_swing_each_route_asks_for_its_own() -> None:
    made = grown(SWING.replace(", swing: yes", "") + "conditions:\n  DRAG: {text: sand drag in order, over: [q7]}\n")
    assert made is not None
    layout, table, _ = made
    those = {r.id: asked(table, r.id) for r in table.routes if r.exit == "X3"}
    assert sorted(those.values()) == [[], ["DRAG"]]
    assert audit(layout, table) == () and not_proved(layout, table) == set()


@pytest.mark.parametrize("key", ["level_crossings", "interlocks"])
def test_a_crossing_over_an_overlap_is_claimed_to_be_closed(key: str) -> None:
    layout, table = swinging(f"{key}:\n  L1: {{over: [q7]}}\n")
    assert not_proved(layout, table) == set()
    locks = tuple(replace(t, points=tuple(p for p in t.points if p.machine != "L1")) for t in table.locks)
    assert "S-OVERLAP" in not_proved(layout, replace(table, locks=locks))


@pytest.mark.parametrize("name", [PLAIN, "../tests/layouts_for_tests/swing_condition"])
def test_a_signal_shows_stop_when_its_overlap_is_blocked(name: str) -> None:
    """Whoever works there is as much in the way as a train; for what is only another alternative it stays open."""
    _, table, controller = built(name)
    one, sym = module_of(name).Controller(), controller.symbols
    route = next(r for r in sym.routes if r.path.overlap is not None)
    lying = [sym.machines.detected[d.machine, d.position] for d in table.route[route.id].locking.points]
    quiet = dict.fromkeys([sym.valid, *sym.sections.clear.values(), *sym.condition.values(), *lying], 1)
    quiet = {n: quiet.get(n, 0) for n in (i.name for i in controller.inputs)}
    for _ in range(max(t.preset_ms for t in controller.timers) // 1000 + 5):
        one.scan(quiet, 1000)
    one.scan({**quiet, sym.sections.release_all: 1}, 1000)
    one.scan(quiet, 1000)
    one.scan({**quiet, **one.request(route.id)}, 100)
    assert route.path.overlap is not None
    under = {s for s, _ in sym.overlaps.ways[route.path.overlap]}
    beside = {s for o, ways in sym.overlaps.ways.items() if o[0] == route.path.overlap[0] for s, _ in ways} - under
    lamps = sym.aspects.main_lamps(route.entry)
    for _ in range(30):
        shown = one.scan(quiet, 100)
    assert any(shown[n] for n in lamps), one.status(route.id)
    for s in beside:
        shown = deepcopy(one).scan({**quiet, sym.sections.blocked[s]: 1}, 100)
        assert any(shown[n] for n in lamps)
    for s in under:
        shown = deepcopy(one).scan({**quiet, sym.sections.blocked[s]: 1}, 100)
        assert not any(shown[n] for n in lamps)
