"""Which point decides whether a section beyond a foul joint, or across a diamond, must be clear (R6, R7)."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.cells import FoulCell
from interlock.table.rows import InterlockingTable
from tests.layouts import built, grown
from tests.test_diamonds import SQUARE

CROSSOVER = (Path(__file__).parent / "diagnostics" / "IL3042.yaml").read_text(encoding="utf-8")
"""A crossover of two sections: the joint lies `legs` of point 1 away from it, and point 2 as far again."""

JUNCTION = (Path(__file__).parent.parent / "layouts" / "junction.yaml").read_text(encoding="utf-8")
"""Point 102 leads to the diamond X1 in normal, `legs` of X1 away from it."""


def foul(table: InterlockingTable, route: str) -> list[str]:
    cells = table.route[RouteId(route)].clear.foul
    return [f"{c.section}{f' if {c.when[0]} {c.when[1]}' if c.when else ''}" for c in cells]


@pytest.mark.parametrize(
    ("legs", "asked"), [(5, ["BC"]), (7, ["BC"]), (8, ["BC if 2 R"]), (15, ["BC if 2 R"]), (15.5, [])]
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


NEAR = """interlock: 1
name: near
profile: uk
principles: {overlap_m: 0}
boundaries:
  W: {approach: wa 800, trains: in}
  E: {trains: out}
  F: {trains: out}
  N: {approach: na 800, trains: in}
  S: {trains: out}
tracks: {west: [W, w1 300], main: [m1 300, E], branch: [b1 300, F], north: [N, n1 300], south: [s1 300, S]}
points:
  1: {section: AC, toe: west.end, normal: main.start, reverse: X.1a, legs: LEGS}
crossings:
  X:
    legs: LEGS
    arms: [{section: AC, ends: [1.reverse, branch.start]}, {section: BC, ends: [north.end, south.start]}]
signals:
  A1: {from: W, into: w1}
  A2: {from: w1, into: AC}
  B1: {from: N, into: n1}
  B2: {from: n1, into: BC}
"""
"""A branch leaves over a diamond, 2 LEGS m behind point 1; another line runs over it from north to south."""


@pytest.mark.parametrize("legs", [3, 8])
def test_what_passes_a_diamond_too_near_to_a_point_is_foul_of_its_other_leg(legs: float) -> None:
    made = grown(NEAR.replace("LEGS", str(legs)))
    assert made is not None
    layout, table, sink = made
    near = legs == 3
    assert ("BC" in foul(table, "A2-E")) is near
    assert ("A2-E" in table.route[RouteId("B2-S")].locking.hostile.routes) is near
    assert ("AC" in foul(table, "B2-S")) is near, "farther away, point 1 tells, which it holds in normal"
    told = sorted(d.message.partition(",")[0] for d in sink.diagnostics if d.code == "IL3042")
    assert told == (["1 leads to the diamond X", "diamond X lies only 6 m from point 1"] if near else [])
    assert audit(layout, table) == ()
    proved = prove(System(layout, lower(layout, table)))
    assert all(c.verdict is Verdict.PROVED for c in proved.claims)


def test_of_a_diamond_too_near_to_two_points_each_is_told_with_its_own_distance() -> None:
    text = NEAR.replace("LEGS", "3").replace("branch.start]}", "2.normal]}")
    text = text.replace("  1: {", "  2: {section: AC, toe: branch.start, reverse: back.end, legs: 5}\n  1: {")
    text = text.replace("branch: [", "back: [C, c1 300], branch: [").replace(
        "  F: {", "  C: {approach: ca 800}\n  F: {"
    )
    made = grown(f"{text}  C1: {{from: C, into: c1}}\n  C2: {{from: c1, into: AC}}\n")
    assert made is not None
    told = [d.message.partition(",")[0] for d in made[2].diagnostics if d.code == "IL3042"]
    assert {"diamond X lies only 6 m from point 1", "diamond X lies only 8 m from point 2"} <= {*told}


@pytest.mark.parametrize(("fouling", "asked"), [(12, False), (45, True)])
def test_a_point_whose_own_legs_are_still_too_near_where_the_diamond_lies_decides_nothing(
    fouling: float, asked: bool
) -> None:
    """40 m behind point 1: its legs are clear of each other 12 m behind it, or 45 m."""
    made = grown(NEAR.replace("LEGS", "20").replace("legs: 20}", f"legs: 20, fouling: {fouling}}}"))
    assert made is not None
    layout, table, _ = made
    assert ("AC" in foul(table, "B2-S")) is asked and ("BC" in foul(table, "A2-E")) is asked
    assert audit(layout, table) == ()


def test_a_table_that_does_not_ask_for_it_is_found_out_by_the_audit_and_by_the_proof() -> None:
    made = grown(NEAR.replace("LEGS", "3"))
    assert made is not None
    layout, table, _ = made

    def bare(cells: tuple[FoulCell, ...]) -> tuple[FoulCell, ...]:
        return tuple(c for c in cells if c.section != "BC")

    locks = tuple(replace(t, foul=bare(t.foul)) for t in table.locks)
    routes = tuple(replace(r, clear=replace(r.clear, foul=bare(r.clear.foul))) for r in table.routes)
    weak = replace(table, locks=locks, routes=routes)
    assert {(f.route, f.column) for f in audit(layout, weak)} == {("A2-E", "foul"), ("A2-F", "foul")}
    found = prove(System(layout, lower(layout, weak)))
    assert {c.id for c in found.claims if c.verdict is not Verdict.PROVED} == {"S-CONDITION"}


FACING = {
    "trains before two signals": ("../tests/diagnostics/IL3045", "S0-S1", "V0-V1", "v1", "q1"),
    "an overlap, and a train before a signal": ("../tests/layouts_for_tests/foul_overlap", "S0-S1", "V0-V1", "v1", "o"),
    "a train on one leg, and one over a diamond on the other": (
        "../tests/layouts_for_tests/foul_facing",
        "SP-SR",
        "SC-S",
        "c",
        "r2",
    ),
}


@pytest.mark.parametrize("which", FACING)
def test_who_stands_at_the_joints_of_both_legs_is_in_each_others_way(which: str) -> None:
    name, one, other, beyond, own = FACING[which]
    layout, table, controller = built(name)
    assert beyond in foul(table, one) and own in foul(table, other)
    assert other in table.route[RouteId(one)].locking.hostile.routes
    assert audit(layout, table) == ()
    proved = prove(System(layout, controller))
    assert all(c.verdict is Verdict.PROVED for c in proved.claims)


@pytest.mark.parametrize("which", FACING)
def test_a_table_that_does_not_keep_them_apart_is_found_out(which: str) -> None:
    name, _, other, _, own = FACING[which]
    layout, table, _ = built(name)

    def bare(cells: tuple[FoulCell, ...]) -> tuple[FoulCell, ...]:
        return tuple(c for c in cells if c.section != own)

    locks = tuple(replace(t, foul=bare(t.foul)) for t in table.locks)
    routes = tuple(replace(r, clear=replace(r.clear, foul=bare(r.clear.foul))) for r in table.routes)
    weak = replace(table, locks=locks, routes=routes)
    assert (other, "foul") in {(f.route, f.column) for f in audit(layout, weak)}
    found = prove(System(layout, lower(layout, weak)))
    assert "S-CONDITION" in {c.id for c in found.claims if c.verdict is not Verdict.PROVED}


def test_an_overlap_that_may_end_foul_of_a_train_is_claimed_to_be_clear_of_it() -> None:
    """The path of S0-S1 comes near to nothing; its overlap ends 5 m from P, and trains wait at V1 on the other leg."""
    layout, table, _ = built("../tests/layouts_for_tests/foul_overlap")

    def bare(cells: tuple[FoulCell, ...]) -> tuple[FoulCell, ...]:
        return tuple(c for c in cells if c.section != "v1")

    locks = tuple(replace(t, foul=bare(t.foul)) if t.section == "o" else t for t in table.locks)
    found = prove(System(layout, lower(layout, replace(table, locks=locks))))
    assert {c.id for c in found.claims if c.verdict is not Verdict.PROVED} >= {"S-OVERLAP"}


def test_where_the_legs_are_drawn_as_long_as_they_are_nothing_is_foul() -> None:
    made = grown(Path("tests/diagnostics/IL3045.yaml").read_text(encoding="utf-8").replace("legs: 5", "legs: 20"))
    assert made is not None
    assert "V0-V1" not in made[1].route[RouteId("S0-S1")].locking.hostile.routes
    assert foul(made[1], "S0-S1") == []


SLIP = """interlock: 1
name: slip
boundaries:
  A: {approach: aa 800}
  B: {approach: ab 800}
  C: {approach: ac 800}
  D: {approach: ad 800}
slips:
  K: {section: XX, arms: [[A, B], [C, D]], legs: 10}
signals:
  A1: {from: A, into: XX}
  B1: {from: B, into: XX}
  C1: {from: C, into: XX}
  D1: {from: D, into: XX}
"""
"""A double slip right at the boundaries, its signals 10 m from its points."""
JOINTS = """interlock: 1
name: joints
boundaries:
  A: {trains: in, approach: aa 800}
  B: {trains: out}
  C: {trains: in, approach: ac 800}
  D: {trains: out}
tracks: {a: [A, a1 200], b: [b1 200, B], c: [C, c1 200], d: [d1 200, D]}
slips:
  K: {section: XX, arms: [[a.end, b.start], [c.end, d.start]], legs: 10}
signals:
  A0: {from: A, into: a1}
  A1: {from: a1, into: XX}
  C0: {from: C, into: c1}
  C1: {from: c1, into: XX}
"""
ON_A_LEG = """interlock: 1
name: derailer
boundaries:
  W: {approach: wa 300}
  E: {approach: ea 300}
tracks: {west: [W, w1 200], east: [e1 200, E]}
derailers:
  D: {section: d, inner: west.end, outer: east.start, legs: 3}
signals:
  X: {from: W, into: w1}
  A: {from: w1, into: d}
  Y: {from: E, into: e1}
  B: {from: e1, into: d}
"""


@pytest.mark.parametrize(
    ("text", "codes", "key", "applied"),
    [
        (SLIP, {"IL3041", "IL4001"}, "slips: {K: {fouling: ", ("legs: 10", "legs: 10, fouling: 6.5")),
        (JOINTS, {"IL3018", "IL3045"}, "slips: {K: {fouling: ", ("legs: 10", "legs: 10, fouling: 6.5")),
        (SQUARE.replace("FOULING ", ""), {"IL3042", "IL3045"}, "crossings: {X", ("{legs: 3", "{fouling: 2, legs: 3")),
        (ON_A_LEG, {"IL3018"}, "", ("legs: 3", "legs: 4.5")),
    ],
    ids=["slip at boundaries", "slip before joints", "square of diamonds", "derailer"],
)
def test_what_states_a_fouling_point_is_a_key_of_the_language(
    text: str, codes: set[str], key: str, applied: tuple[str, str]
) -> None:
    """`points: {Ka: {fouling: ...}}` was offered for a slip K, and `fouling` for a diamond and a derailer; the place
    was that of the layout's name."""
    sink = Sink()
    layout, _ = load_text("it.yaml", text, sink)
    assert layout is not None
    derive(layout, sink)
    found = [d for d in sink.diagnostics if d.code in codes]
    assert {d.code for d in found} == codes
    for d in found:
        assert (f"`{key}" in str(d.fix)) if key else ("fouling" not in str(d.fix)), d
        assert d.span is not None and d.span.line > 3, d
    after = Sink()
    mended, _ = load_text("it.yaml", text.replace(*applied), after)
    assert mended is not None
    derive(mended, after)
    assert codes.isdisjoint({d.code for d in after.diagnostics}), after.diagnostics
