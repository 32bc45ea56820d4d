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


@pytest.mark.parametrize(("legs", "lamps", "clear"), [("15.4", {"Z"}, {"y2"}), ("15.5", {"Y"}, set())])
def test_the_signal_that_just_stands_clear_is_the_one_whose_lamp_must_be_intact(
    legs: str, lamps: set[str], clear: set[str]
) -> None:
    """12 m to the fouling point and 3.5 m of clearance: at 15.5 m it is Y that protects, and not Z beyond it."""
    text = TOO_NEAR.replace("legs: 6", f"legs: {legs}").replace("yes}", "yes, flank_lamp: yes, lamp_proof: yes}")
    made = grown(text)
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    layout, table, _ = made
    assert audit(layout, table) == () and protection(table, "X2-E", "P.reverse") == lamps
    space = table.route[RouteId("X2-E")].clear.space
    assert {c.name for c in space if c.lamp} == lamps and {c.name for c in space if not c.lamp} == clear


RING_BEHIND_POINTS = """
interlock: 1
name: ring_behind
boundaries: {W: {approach: wa 600}, E: {trains: out}}
tracks: {west: [W, m1 300], east: [m2 300, E], stem: [y1 100], ring: [r1 200, r2 200]}
points:
  P: {section: p, toe: west.end, normal: east.start, reverse: stem.start}
  T: {section: t, toe: ring.start, normal: ring.end, reverse: stem.end}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: p}
  X3: {from: r1, into: r2}
BACKexclude:
  - {from: X3, to: X3, reason: own train}
"""


@pytest.mark.parametrize(("back", "protected"), [("", set()), ("  Y2: {from: y1, into: p}\n", {"Y2"})])
def test_the_search_ends_where_it_has_gone_round_a_ring_behind_points(back: str, protected: set[str]) -> None:
    """It comes to T over the stem, runs round the ring and comes to T again: nothing comes from outside, but what has
    been brought there may, and of that the author is told."""
    made = grown(RING_BEHIND_POINTS.replace("BACK", back))
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    layout, table, sink = made
    assert audit(layout, table) == () and protection(table, "X2-E", "P.reverse") == protected
    said = [d for d in sink.diagnostics if "the ring in which the track closes protects P.reverse" in d.message]
    assert bool(said) is (not protected)


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


ONE_WAY_SIDING = """
interlock: 1
name: one_way
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}, S: {trains: out}}
tracks: {west: [W, m1 300], east: [m2 300, E], side: [g1 300, S]}
points: {P: {section: p, toe: west.end, normal: east.start, reverse: side.start}}
sections: {g1: {one_way: forward}}
signals: {X1: {from: W, into: m1}, X2: {from: m1, into: p}}
"""
"""A siding over which trains leave P one way."""


def test_a_one_way_track_protects_and_a_derailer_before_it_is_laid_nevertheless() -> None:
    """Against its one way no train comes; vehicles do that roll, and whoever puts a derailer expects them to."""
    level = grown(ONE_WAY_SIDING)
    assert level is not None and not level[2].has_errors and audit(level[0], level[1]) == ()
    assert protection(level[1], "X2-E", "P.reverse") == {"g1"}
    text = ONE_WAY_SIDING.replace(", reverse: side.start", "")
    made = grown(
        text.replace("sections:", "derailers: {D: {section: d, inner: P.reverse, outer: side.start}}\nsections:")
    )
    assert made is not None and not made[2].has_errors and audit(made[0], made[1]) == ()
    assert protection(made[1], "X2-E", "P.reverse") == {"D N"}
    assert {(str(p.machine), str(p.position)) for p in made[1].route[RouteId("X2-E")].locking.points} >= {("D", "N")}


def test_a_one_way_track_does_not_protect_beyond_an_inclined_lane_in_the_section_of_the_points() -> None:
    """Vehicles run away over the lane against the one way that trains keep, as over a lane with its own section."""
    made = grown(ONE_WAY_SIDING.replace("sections: {", "sections: {p: {lane: inclined}, "))
    assert made is not None
    bare = {d.message.split(";")[0] for d in made[2].diagnostics if d.code == "IL4001"}
    assert "nothing keeps vehicles away from P.reverse" in bare
    assert protection(made[1], "X2-E", "P.reverse") == set()


RING_BEHIND_A_DERAILER = """
interlock: 1
name: ring
boundaries: {W: {approach: wa 600}, E: {trains: out}, F: {trains: out}}
tracks: {west: [W, m1 300], east: [m2 300, E], far: [f1 300, F], stem: [s1 100], ring: [r1 200, r2 200]}
points:
  P: {section: p, toe: west.end, normal: Q.toe}
  Q: {section: p, machine: M, normal: east.start, reverse: far.start}
  N: {section: n, toe: stem.end, normal: ring.start, reverse: ring.end}
derailers: {D: {section: p, inner: P.reverse, outer: stem.start, machine: M}}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: p}
  T: {from: p, into: s1}
  U: {from: r1, into: r2}
"""
"""The machine of D moves it off for X2-F.  T governs who runs into the ring, U who runs round it with the clock."""


def test_a_ring_behind_a_derailer_is_not_left_by_its_stem_as_if_it_were_another_track() -> None:
    """What stands in the ring comes out at N over either leg: T, at the stem, governs the other direction."""
    made = grown(RING_BEHIND_A_DERAILER)
    assert made is not None
    assert protection(made[1], "X2-E", "P.reverse") == {"M N"}
    assert "P.reverse cannot be protected in route X2-F: M would have to lie N, and lies R on the path" in {
        d.message for d in made[2].diagnostics if d.code == "IL4002"
    }
    assert protection(made[1], "X2-F", "P.reverse") == set()


BESIDE_POINTS = """
interlock: 1
name: beside
profile: cn
boundaries:
  W: {approach: wa 600, trains: in}
  E: {trains: out}
  A: {approach: aa 600, trains: in}
  C: {trains: out}
  B: {trains: out}
tracks: {west: [W, m1 300], east: [m2 300, E], a: [A, a1 300], c: [c1 300, C], b: [b1 300, B]}
points:
  P: {section: tp, toe: a.end, normal: c.start}
crossings: {X: {arms: [{section: tx, ends: [west.end, east.start]}, {section: ty, ends: [P.reverse, b.start]}]}}
signals: {X1: {from: W, into: m1}, X2: {from: m1, into: tx}, A1: {from: A, into: a1}, A2: {from: a1, into: tp}}
"""
CROSSED = next(line for line in BESIDE_POINTS.splitlines() if line.startswith("crossings:"))


def test_a_diamond_is_protected_by_a_point_where_the_leg_of_a_point_is_by_the_signal_before_it() -> None:
    """In `cn`, where a signal at stop is preferred: of Q, which lies where the diamond did, A2 protects the leg."""
    joined = BESIDE_POINTS.replace("  B: {trains: out}\n", "").replace(", b: [b1 300, B]", "")
    joined = joined.replace(CROSSED, "  Q: {section: tx, toe: east.start, normal: west.end, reverse: P.reverse}")
    for text, requester, protected in ((BESIDE_POINTS, "X.2a", {"P N"}), (joined, "Q.reverse", {"A2"})):
        made = grown(text)
        assert made is not None and not made[2].has_errors and audit(made[0], made[1]) == ()
        assert protection(made[1], "X2-E", requester) == protected


PARTNER_WITH_A_DERAILER = """
interlock: 1
name: shared_machine
boundaries:
  A: {approach: aa 600, trains: in}
  B: {trains: out}
  C: {approach: ca 600, trains: in}
  D: {trains: out}
tracks: {a: [A, a1 150], c: [C, c1 150], d: [d1 150, D], b: [b1 150, B]}
points:
  11: {section: q1, toe: a.end, normal: 12.normal}
  12: {section: q2, toe: b.start}
  13: {section: q3, machine: M, toe: c.end, normal: 14.normal}
  14: {section: q4}
crossings: {X: {arms: [{section: q1, ends: [11.reverse, 14.reverse]}, {section: q3, ends: [13.reverse, 12.reverse]}]}}
derailers: {K: {section: q4, inner: 14.toe, outer: d.start, machine: M}}
signals: {SA: {from: A, into: a1}, SA2: {from: a1, into: q1}, SC: {from: C, into: c1}, SC2: {from: c1, into: q3}}
"""


def test_a_route_that_lays_the_partner_of_its_scissors_reverse_is_refused() -> None:
    """M works the partner 13, to lie normal for the other crossover (防护道岔), and the derailer K, to be off."""
    made = grown(PARTNER_WITH_A_DERAILER)
    assert made is not None
    told = [d.message for d in made[2].diagnostics if d.code == "IL4002" and d.message.startswith("X.2a")]
    assert len(told) == 1 and "route SA2-D: M would have to lie N, and lies R on the path" in told[0]
    assert protection(made[1], "SA2-D", "X.2a") == set()


BEYOND_ONE_WAY = """
interlock: 1
name: beyond
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}, S: {trains: out}}
tracks: {west: [W, m1 300], east: [m2 300, E], side: [g1 200, g2 300, S]}
points: {P: {section: p, toe: west.end, normal: east.start, reverse: side.start}}
sections: {g1: {one_way: forward}, g2: {lane: inclined}}
conditions: {HOIST: {text: hoist stopped, over: [g2]}}
signals: {X1: {from: W, into: m1}, X2: {from: m1, into: p}}
"""


def test_a_one_way_track_does_not_protect_from_an_inclined_lane_beyond_it() -> None:
    """What runs away on g2 comes over g1, against the one way that trains keep; on level track it does not."""
    made = grown(BEYOND_ONE_WAY)
    assert made is not None and protection(made[1], "X2-E", "P.reverse") == set()
    assert "nothing keeps vehicles away from P.reverse" in {
        d.message.split(";")[0] for d in made[2].diagnostics if d.code == "IL4001"
    }
    level = grown(BEYOND_ONE_WAY.replace(", g2: {lane: inclined}", ""))
    assert level is not None and not level[2].has_errors and audit(level[0], level[1]) == ()
    assert protection(level[1], "X2-E", "P.reverse") == {"g1"}


LANE_BEFORE_POINTS = """
interlock: 1
name: before_points
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}, S: {trains: out}, T: {trains: out}}
tracks: {west: [W, m1 300], east: [m2 300, E], side: [g1 200, S], spare: [h1 200, T]}
points:
  P: {section: p, toe: west.end, normal: east.start, reverse: Q.reverse}
  Q: {section: q, toe: side.start, normal: spare.start}
sections: {p: {lane: inclined}}
conditions: {HOIST: {text: hoist stopped, over: [p]}}
signals: {X1: {from: W, into: m1}, X2: {from: m1, into: p}}
exclude: [{from: X2, to: S, reason: out of use}]
"""


def test_past_an_inclined_lane_and_points_an_exit_still_does_not_protect() -> None:
    """No train comes in at S, but what stands before it may run over the lane in p; Q turns it away."""
    made = grown(LANE_BEFORE_POINTS)
    assert made is not None and protection(made[1], "X2-E", "P.reverse") == {"Q N"}
    level = grown(LANE_BEFORE_POINTS.replace("sections: {p: {lane: inclined}}\n", ""))
    assert level is not None and protection(level[1], "X2-E", "P.reverse") == {"S"}


@pytest.mark.parametrize(("leg", "protected"), [("normal", {"Y2"}), ("reverse", {"Q N"})])
def test_points_worked_by_hand_protect_as_their_key_locks_them_and_not_in_reverse(
    leg: str, protected: set[str]
) -> None:
    """The key is locked in while they lie normal: nobody holds them in reverse."""
    other = "reverse" if leg == "normal" else "normal"
    text = f"""
interlock: 1
name: by_hand
boundaries: {{W: {{approach: wa 600, trains: in}}, E: {{trains: out}}, V: {{approach: va 600, trains: in}}}}
buffers: [B]
tracks: {{west: [W, m1 300], east: [m2 300, E], side: [V, y1 300], spare: [h1 200, B]}}
points:
  P: {{section: p, toe: east.start, normal: west.end, reverse: Q.{leg}}}
  Q: {{section: q, work: hand, toe: side.end, {other}: spare.start}}
signals:
  X1: {{from: W, into: m1}}
  X2: {{from: m1, into: p}}
  Y1: {{from: V, into: y1}}
  Y2: {{from: y1, into: q}}
"""
    made = grown(text)
    assert made is not None and protection(made[1], "X2-E", "P.reverse") == protected


ONE_LEG_ONE_WAY = """
interlock: 1
name: one_leg
principles: {flank_space: yes}
boundaries: {W: {approach: wa 600, trains: in}, E: {trains: out}, V: {approach: va 600, trains: in}, S: {trains: out}}
tracks: {west: [W, m1 300], east: [m2 300, E], side: [V, y1 300, y2 300], out: [g1 300, S]}
points:
  P: {section: p, toe: east.start, normal: west.end, reverse: T.toe}
  T: {section: t, normal: side.end, reverse: out.start}
sections: {g1: {one_way: forward}}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: p}
  Y1: {from: V, into: y1}
  Y2: {from: y1, into: y2}
"""


@pytest.mark.parametrize("exchanged", [False, True])
def test_the_flank_space_lies_behind_one_leg_where_nothing_comes_over_the_other(exchanged: bool) -> None:
    """Whichever leg of T it is over which trains leave one way: what lies before Y2 has to be clear."""
    text = ONE_LEG_ONE_WAY
    if exchanged:
        text = text.replace("normal: side.end, reverse: out.start", "reverse: side.end, normal: out.start")
    made = grown(text)
    assert made is not None and protection(made[1], "X2-E", "P.reverse") == {"g1", "Y2"}
    assert {c.name for c in made[1].route[RouteId("X2-E")].clear.space} == {"t", "y2"}
