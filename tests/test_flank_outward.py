"""Where the search for protection goes outward from a place beside the path (R5): what ends it, and what does not."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.model.elements import RouteId
from interlock.table.rows import InterlockingTable
from tests.layouts import grown


def protection(table: InterlockingTable, route: str, requester: str) -> set[str]:
    """What protects a place of a route, as the table tells it."""
    cells = table.route[RouteId(route)].locking.flank
    return {str(p) for c in cells if c.requester == requester for p in c.providers}


LOOP_BEHIND_POINTS = """
interlock: 1
name: loop
profile: cn
boundaries: {W: {approach: wa 600}, E: {trains: out}, V: {approach: va 600, trains: in}}
tracks: {west: [W, m1 300], east: [m2 300, E], side: [V, u1 300], stem: [s1 300], loop: [l1 300, l2 300]}
points:
  P: {section: p, toe: west.end, normal: east.start, reverse: Q.normal}
  Q: {section: q, toe: stem.start, reverse: side.end}
  N: {section: n, toe: stem.end, normal: loop.start, reverse: loop.end}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: p}
  U1: {from: V, into: u1}
  U2: {from: u1, into: q}
  T: {from: s1, into: n}
  L: {from: l1, into: l2}
"""


def test_a_balloon_loop_is_walked_round_since_vehicles_come_back_over_it() -> None:
    """Who runs into the loop past T comes back to P over N's other leg: that the way closes at N protects nothing."""
    made = grown(LOOP_BEHIND_POINTS)
    assert made is not None and not made[2].has_errors and audit(made[0], made[1]) == ()
    assert protection(made[1], "X2-E", "P.reverse") == {"T", "L"}


TWO_LEGS_ONE_MACHINE = """
interlock: 1
name: both_legs
boundaries: {W: {approach: wa 600}, E: {trains: out}, A: {approach: aa 600}, B: {approach: ba 600}, C: {trains: out}}
buffers: [D]
tracks: {west: [W, m1 300], east: [m2 300, E], a: [A, a1 300], b: [B, b1 300], c: [c1 300, C], d: [d1 300, D]}
points:
  P: {section: p, toe: east.start, normal: west.end, reverse: T.toe}
  T: {section: t, normal: 2A.normal, reverse: 2B.reverse}
  2A: {machine: 2, section: ta, toe: a.end, reverse: c.start}
  2B: {machine: 2, section: tb, toe: b.end, normal: d.start}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: p}
  A1: {from: A, into: a1}
  A2: {from: a1, into: ta}
  B1: {from: B, into: b1}
  B2: {from: b1, into: tb}
exclude: [{from: A2, to: C, reason: out of use}, {from: B2, to: D, reason: out of use}]
"""


def test_one_machine_does_not_turn_away_in_both_positions() -> None:
    """Turned away from T.normal by 2 R and from T.reverse by 2 N: no machine lies both ways, so that a signal guards
    one of the two."""
    made = grown(TWO_LEGS_ONE_MACHINE)
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    assert audit(made[0], made[1]) == ()
    assert protection(made[1], "X2-E", "P.reverse") in ({"2 R", "B2"}, {"2 N", "A2"})


ARM_BETWEEN_TOES = """
interlock: 1
name: toes
boundaries:
  W: {approach: wa 600, trains: in}
  E: {trains: out}
  A: {approach: aa 600, trains: in}
  B: {approach: ba 600, trains: in}
  C: {trains: out}
  D: {trains: out}
tracks: {west: [W, m1 300], east: [m2 300, E], a: [A, a1 300], b: [B, b1 300], c: [c1 300, C], d: [d1 300, D]}
points:
  P: {section: tp, normal: a.end, reverse: b.end}
  Q: {section: tp, normal: c.start, reverse: d.start}
crossings: {X: {arms: [{section: tx, ends: [west.end, east.start]}, {section: tp, ends: [P.toe, Q.toe]}]}}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: tx}
  A1: {from: A, into: a1}
  A2: {from: a1, into: tp}
  B1: {from: B, into: b1}
  B2: {from: b1, into: tp}
"""


def test_points_that_turn_their_toes_to_a_diamond_make_no_scissors_and_keep_nobody_off_it() -> None:
    """Over a toe vehicles come however the points lie: the signals before both legs protect."""
    made = grown(ARM_BETWEEN_TOES)
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    assert audit(made[0], made[1]) == ()
    assert protection(made[1], "X2-E", "X.2a") == {"A2", "B2"}
    assert not {str(p.machine) for p in made[1].route[RouteId("X2-E")].locking.points} & {"P", "Q"}


@pytest.mark.parametrize(("legs", "clear"), [("11.4", False), ("11.5", True)])
def test_a_signal_nearer_than_the_fouling_point_and_the_clearance_by_whatever_little_protects_nothing(
    legs: str, clear: bool
) -> None:
    text = Path("tests/diagnostics/IL4001.yaml").read_text("utf-8")
    made = grown(text.replace("legs: 6", f"legs: {legs}"))
    assert made is not None and ("IL4001" in {d.code for d in made[2].diagnostics}) is not clear


TOO_NEAR = """
interlock: 1
name: too_near
principles: {flank_space: yes}
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}, V: {approach: va 600, trains: in}}
tracks: {west: [W, m1 300], east: [m2 300, E], side: [V, y1 300, y2 300]}
points: {P: {section: p, toe: east.start, normal: west.end, reverse: side.end, legs: 6}}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: p}
  Y1: {from: V, into: y1}
  Z: {from: y1, into: y2}
  Y: {from: y2, into: p}
"""


def test_the_flank_space_goes_on_past_a_signal_that_stands_too_near_to_protect() -> None:
    """Z protects, since Y stands within the fouling point: what is between them is in the flank space."""
    made = grown(TOO_NEAR)
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    assert audit(made[0], made[1]) == ()
    assert protection(made[1], "X2-E", "P.reverse") == {"Z"}
    assert {c.name for c in made[1].route[RouteId("X2-E")].clear.space} == {"y2"}


LANE_IN_A_SCISSORS = """
interlock: 1
name: lane_in_scissors
boundaries: {A: {approach: aa 300}, B: {approach: ba 300}, C: {approach: ca 300}, D: {approach: da 300}}
tracks: {lane: [k1 50, k2 250]}
sections: {k2: {lane: inclined}}
points:
  1A: {machine: 1, section: T1, toe: A, normal: 2B.normal}
  2B: {machine: 2, section: T1, toe: B}
  2A: {machine: 2, section: T3, toe: C, normal: 1B.normal, reverse: lane.start}
  1B: {machine: 1, section: T3, toe: D}
crossings:
  X: {arms: [{section: T1, ends: [1A.reverse, 1B.reverse]}, {section: T2, ends: [lane.end, 2B.reverse]}]}
signals:
  SA: {from: A, into: T1}
  SB: {from: B, into: T1}
  SC: {from: C, into: T3}
  SD: {from: D, into: T3}
  SK: {from: k2, into: T2}
  SL: {from: k2, into: k1}
"""


def test_what_stands_on_a_lane_within_the_crossover_of_a_scissors_is_kept_off_by_its_signal() -> None:
    """That the crossover lies normal keeps nobody off who stands between it and the diamond."""
    made = grown(LANE_IN_A_SCISSORS)
    assert made is not None and not made[2].has_errors
    assert audit(made[0], made[1]) == ()
    assert protection(made[1], "SA-D", "X.2a") == {"2 N", "SK"}
    assert protection(made[1], "SA-D", "X.2b") == {"2 N"}
