"""Trains of which nothing tells that they do not stand foul, though their way does not lead there (R6, R7): a point
decides where a vehicle goes that is in the section, and a point that is held towards the joint sends it there."""

from __future__ import annotations

import re

import pytest

from interlock.audit import audit
from interlock.logic.lower import lower
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.layouts import grown
from tests.test_foul import foul

BASE = """interlock: 1
name: held
profile: mine
boundaries:
  W: {approach: aw 100, trains: in}
  C: {approach: ac 100, trains: in}
  A: {approach: aa 100}
  B: {trains: out}
tracks: {outa: [a1 60, A], outb: [b1 60, B], west: [W, q1 60], south: [C, q2 60, s17 20]}
points:
  P9: {section: s10, normal: west.end, reverse: P11.toe, toe: outa.start}
POINTS
signals:
  SA: {from: A, into: a1}
  SW: {from: W, into: q1}
  S0: {from: C, into: q2}
  S1: {from: q1, into: s10}
  S2: {from: q2, into: s17}
"""
"""S1 leads from W through s10 to A, over P9 in normal, never over P11, which lies in s10, too.  S2: from C to B."""

ELSEWHERE = """  P11: {section: s10, normal: P20.reverse, reverse: P16.normal}
  P16: {section: s17, reverse: south.end, toe: P20.normal, fouling: 25}
  P20: {section: m1, toe: outb.start}"""
"""P11 leads in reverse to the joint with s17, foul of P16; for P20, further on, the route from S2 has it lie so."""

ACROSS = """  P11: {section: s10, normal: P20.reverse, reverse: X.2a}
  P20: {section: m1, normal: X.1b, toe: outb.start}
crossings:
  X: {arms: [{section: s17, ends: [south.end, P20.normal]}, {section: s10, ends: [P11.reverse, north.start]}]}"""
"""The same, where P11 leads to a diamond."""

BESIDE = """  P11: {section: s10, normal: P20.reverse, reverse: P.reverse}
  P20: {section: m1, normal: south.end, toe: on.start}
  P: {section: t1, normal: on.end, toe: outb.start, legs: 5}"""
"""The same, where a train waits before P on the other leg, as near to it."""

OWN = BASE.replace(
    "P9: {section: s10, normal: west.end, reverse: P11.toe", "P9: {section: s10, normal: west.end, reverse: P11.normal"
)
"""P11 lies between P9 and a stub: the route from S1 itself turns it away from P9, towards what is behind it."""

STUB = "south: [C, q2 60, s17 20], stub: [q3 40, Z]}\nbuffers: [Z]"

HELD = {
    "a joint, by the other route's flank": (BASE.replace("POINTS", ELSEWHERE), "S1-A", "S2-B"),
    "a joint, by the flank of an overlap": (
        BASE.replace("POINTS", ELSEWHERE)
        .replace("profile: mine", "profile: mine\nprinciples: {overlap_m: 70}")
        .replace("S2: {from: q2, into: s17", "S2: {from: q2, into: s17, kind: board"),
        "S1-A",
        "S0-S2",
    ),
    "a diamond, by the other route's flank": (
        BASE.replace("POINTS", ACROSS).replace("s17 20]}", "s17 20], north: [n1 60, N]}\nbuffers: [N]"),
        "S1-A",
        "S2-B",
    ),
    "a diamond, by its own flank": (
        OWN.replace(
            "POINTS",
            """  P11: {section: s10, toe: stub.start, reverse: X.2a}
crossings:
  X: {arms: [{section: s17, ends: [south.end, outb.start]}, {section: s10, ends: [P11.reverse, north.start]}]}""",
        )
        .replace("south: [C, q2 60, s17 20]}", STUB.replace("[Z]", "[Z, N]").replace("Z]}", "Z], north: [n1 60, N]}"))
        .replace("signals:", "signals:\n  T: {from: q3, into: s10, kind: limit}"),
        "S1-A",
        "S2-B",
    ),
    "beside, by the other route's flank": (
        BASE.replace("POINTS", BESIDE)
        .replace("q2 60, s17 20]", "q2 60], on: [s17 60]")
        .replace("S2: {from: q2, into: s17}", "S2: {from: q2, into: m1}\n  S3: {from: s17, into: t1}"),
        "S1-A",
        "S2-S3",
    ),
    "beside, by its own flank": (
        OWN.replace(
            "POINTS",
            """  P11: {section: s10, toe: stub.start, reverse: P.reverse}
  P: {section: t1, normal: south.end, toe: outb.start, legs: 5}""",
        )
        .replace("south: [C, q2 60, s17 20]}", STUB)
        .replace("signals:", "signals:\n  T: {from: q3, into: s10, kind: limit}\n  S3: {from: s17, into: t1}"),
        "S1-A",
        "S2-S3",
    ),
}


@pytest.mark.parametrize("which", HELD)
def test_a_train_counts_as_foul_where_the_point_that_decides_is_held_towards_the_joint(which: str) -> None:
    """The ways share no point, section or direction, and no flank contradicts another: but with both routes set P11
    lies reverse, and s10 is occupied.  Nothing then tells the train in s10 from a vehicle at the joint, so that it
    would close the other route's signal; the two are hostile, whoever of them it is that holds P11."""
    text, one, other = HELD[which]
    made = grown(text)
    assert made is not None
    layout, table, _ = made
    assert "s10 if P11 R" in foul(table, other)
    hostile = {r.id: r.locking.hostile.routes for r in table.routes}
    assert other in hostile[one] and one in hostile[other]
    assert audit(layout, table) == ()
    proved = prove(System(layout, lower(layout, table)))
    assert all(c.verdict is Verdict.PROVED for c in proved.claims)


@pytest.mark.parametrize("which", HELD)
def test_it_does_not_matter_which_of_the_two_has_the_lower_number(which: str) -> None:
    """Routes are numbered in the order of their names: each of two ways says of the other that they are foul."""
    text, one, other = HELD[which]
    found: list[dict[str, set[str]]] = []
    lower = set[bool]()
    for name in ("R1", "S9"):
        made = grown(re.sub(r"\bS1\b", name, text))
        assert made is not None
        ids = [r.id.replace(name, "S1") for r in made[1].routes]
        lower.add(ids.index(one) < ids.index(other))
        hostile = [{x.replace(name, "S1") for x in r.locking.hostile.routes} for r in made[1].routes]
        found.append(dict(zip(ids, hostile, strict=True)))
    assert lower == {True, False} and found[0] == found[1]


def test_where_no_point_decides_whoever_is_in_the_section_counts_as_foul() -> None:
    """As the last one, but that P11 lies 7 m from P, where 11.5 m are needed: whatever passes it comes too near."""
    text, one, other = HELD["beside, by its own flank"]
    made = grown(text.replace("reverse: P.reverse}", "reverse: P.reverse, legs: 2}"))
    assert made is not None
    layout, table, _ = made
    assert "s10" in foul(table, other)
    assert other in table.route[one].locking.hostile.routes  # type: ignore[index]
    assert audit(layout, table) == ()


BOTH_SIDES = """interlock: 1
name: both_sides
profile: mine
boundaries: {W: {approach: aw 100, trains: in}, E: {trains: out}, N: {approach: an 100, trains: in}, S: {trains: out}}
tracks: {west: [W, w1 60], east: [e1 60, E], north: [N, n1 60], south: [s1 60, S]}
points:
  P: {section: c, toe: north.end, normal: X.2a, reverse: Q.reverse, work: hand}
  Q: {section: c, toe: south.start, normal: X.2b, work: hand}
crossings:
  X: {arms: [{section: x, ends: [west.end, east.start]}, {section: c, ends: [P.normal, Q.normal]}]}
signals:
  SW: {from: W, into: w1}
  SX: {from: w1, into: x}
  SN: {from: N, into: n1}
  SC: {from: n1, into: c}
"""
"""On either side of X a hand-worked point in normal leads to it, and in reverse past it: no route locks it so."""


@pytest.mark.parametrize(
    ("near", "asked"), [("", ["c if P N", "c if Q N"]), ("P", ["c", "n1"]), ("Q", ["c", "s1"])], ids=["far", "P", "Q"]
)
def test_a_vehicle_may_come_to_a_diamond_from_either_side(near: str, asked: list[str]) -> None:
    """One that came over Q stands on the diamond, however P lies: both must lie away, if c is not clear.  And where one
    of them lies within 11.5 m of the diamond, whatever passes it is foul, however the other one lies."""
    text = BOTH_SIDES if not near else BOTH_SIDES.replace("  X: {arms", "  X: {legs: 5, arms")
    lines = [
        x.replace("work: hand", "work: hand, legs: 2") if near and x.startswith(f"  {near}: {{section") else x
        for x in text.split("\n")
    ]
    made = grown("\n".join(lines))
    assert made is not None
    layout, table, _ = made
    assert foul(table, "SX-E") == asked
    assert audit(layout, table) == ()


SHORT_ARMS = """interlock: 1
name: short_arms
profile: mine
boundaries: {W: {approach: aw 100, trains: in}, E: {trains: out}, N: {approach: an 100, trains: in}, S: {trains: out}}
tracks: {west: [W, w1 60], east: [e1 60, E], north: [N, n1 60], south: [s1 60, S]}
crossings:
  X: {legs: 5, arms: [{section: XA, ends: [west.end, east.start]}, {section: XB, ends: [north.end, south.start]}]}
signals:
  SW: {from: W, into: w1}
  SA: {from: w1, into: XA}
  SN: {from: N, into: n1}
  SB: {from: n1, into: XB}
"""


def test_all_four_joints_of_a_short_diamond_are_foul() -> None:
    """Each of them lies 5 m from the diamond, and 11.5 m are needed: what waits before it on the one arm, or has just
    passed it, is in the way of what runs over the other."""
    made = grown(SHORT_ARMS)
    assert made is not None
    layout, table, _ = made
    assert foul(table, "SA-E") == ["XB", "n1", "s1"] and foul(table, "SB-S") == ["XA", "w1", "e1"]
    assert foul(table, "SW-SA") == ["n1", "s1"] and foul(table, "SN-SB") == ["w1", "e1"]
    assert "SN-SB" in table.route["SW-SA"].locking.hostile.routes  # type: ignore[index]
    assert audit(layout, table) == ()


TWO_JOINTS = """interlock: 1
name: two_joints
profile: mine
boundaries: {W: {approach: aw 100, trains: in}, C: {approach: ac 100, trains: in}, A: {trains: out}, B: {trains: out}}
tracks: {west: [W, q1 60], south: [C, q2 60, s17 20], stub: [q3 40, Z]}
buffers: [Z]
points:
  P9: {section: s10, normal: west.end, reverse: P11.toe, toe: A}
  P11: {section: s10, normal: P12.toe, reverse: Q.normal}
  P12: {section: s10, normal: stub.start, reverse: P.reverse}
  Q: {section: s17, reverse: south.end, toe: P.normal, fouling: 25}
  P: {section: t1, toe: B, legs: 5}
signals:
  SW: {from: W, into: q1}
  S0: {from: C, into: q2}
  S1: {from: q1, into: s10}
  S2: {from: q2, into: s17}
  S3: {from: s17, into: t1}
"""


def test_one_section_is_foul_of_a_way_at_two_joints() -> None:
    """Over P11 in reverse a vehicle comes to the joint beside Q, which the route passes; over P12 in reverse to the
    one beside P, before which its train comes to stand."""
    made = grown(TWO_JOINTS)
    assert made is not None
    layout, table, _ = made
    assert foul(table, "S2-S3") == ["s10 if P11 R", "s10 if P12 R"]
    assert audit(layout, table) == ()
