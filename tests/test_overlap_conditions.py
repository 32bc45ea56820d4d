"""What lies over an overlap: a train that overruns its signal meets the condition (R17) or the crossing there, too."""

from __future__ import annotations

from collections.abc import Collection
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
