"""Which point decides whether a section beyond a foul joint, or across a diamond, must be clear (R6, R7)."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable
from tests.layouts import grown

CROSSOVER = (Path(__file__).parent / "diagnostics" / "IL3042.yaml").read_text(encoding="utf-8")
"""A crossover of two sections: the joint lies `legs` of point 1 away from it, and point 2 as far again."""

JUNCTION = (Path(__file__).parent.parent / "layouts" / "junction.yaml").read_text(encoding="utf-8")
"""Point 102 leads to the diamond X1 in normal, `legs` of X1 away from it."""


def foul(table: InterlockingTable, route: str) -> list[str]:
    cells = table.route[RouteId(route)].clear.foul
    return [f"{c.section}{f' if {c.when[0]} {c.when[1]}' if c.when else ''}" for c in cells]


@pytest.mark.parametrize(
    ("legs", "asked"), [(5, ["BC"]), (7, ["BC"]), (8, ["BC if 2 R"]), (13, ["BC if 2 R"]), (16, [])]
)
def test_a_point_decides_where_it_lies_far_enough_away_itself(legs: float, asked: list[str]) -> None:
    """12 m to the fouling point and 3.5 m of clearance: 15.5 m, from point 1 to the joint or to point 2."""
    made = grown(CROSSOVER.replace("legs: 5", f"legs: {legs}"))
    assert made is not None
    layout, table, sink = made
    assert foul(table, "A2-E") == asked
    assert any(d.code == "IL3042" for d in sink.diagnostics) is (asked == ["BC"])
    assert audit(layout, table) == ()
    proved = prove(System(layout, lower(layout, table)))
    assert all(c.verdict is Verdict.PROVED for c in proved.claims)


def test_whoever_is_beyond_a_point_that_decides_nothing_keeps_a_route_from_being_set() -> None:
    """A train over 2 in normal stands 10 m from point 1."""
    near, far = (grown(CROSSOVER.replace("legs: 5", f"legs: {legs}")) for legs in (5, 10))
    assert near is not None and far is not None
    assert "B2-S" in near[1].route[RouteId("A2-E")].locking.hostile.routes
    assert "B2-S" not in far[1].route[RouteId("A2-E")].locking.hostile.routes


@pytest.mark.parametrize(("legs", "asked"), [(20, "BC if 102 N"), (5, "BC")])
def test_a_point_too_near_to_a_diamond_does_not_decide_who_is_on_it(legs: float, asked: str) -> None:
    text = JUNCTION.replace("legs: 25", "legs: 5")
    made = grown(text.replace("reverse: upb.end, hand: left", f"reverse: upb.end, hand: left, legs: {legs}"))
    assert made is not None
    layout, table, sink = made
    assert asked in foul(table, "S1J-S5")
    told = [d.message for d in sink.diagnostics if d.code == "IL3042" and "102 leads to the diamond X1" in d.message]
    assert len(told) == (1 if legs == 5 else 0)
    assert audit(layout, table) == ()
    hostile = table.route[RouteId("S1J-S5")].locking.hostile.routes
    assert ("S4J-S6" in hostile) is (legs == 5), "its train, in BC, would make S1J show stop"
