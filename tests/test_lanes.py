"""Vehicles that run away over inclined lanes, and rings behind them (R5): what protects from them, what does not."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.checker.specification import shipped
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.verify import Rejected
from tests.layouts import grown
from tests.test_flank import without_flank
from tests.written import told as written


@pytest.mark.parametrize("lane", ["level", "inclined"])
@pytest.mark.parametrize("end", ["trains: out", "a buffer"])
def test_what_ends_behind_an_inclined_lane_protects_from_nothing(lane: str, end: str) -> None:
    """Wagons run back over the lane: a boundary where no train comes in was taken for protection, and so was the end of
    the track; derivation, audit and claims alike."""
    text = """
interlock: 1
name: down
boundaries:
  W: {approach: wa 600}
  E: {approach: ea 600}
  D: {approach: da 300, trains: out}
tracks:
  west: [W, q1 200]
  east: [q4 200, E]
  incl: [i1 300, D]
points:
  1: {section: q2, toe: west.end, normal: east.start, reverse: incl.start}
sections:
  i1: {lane: LANE}
signals:
  A: {from: W, into: q1}
  AA: {from: q1, into: q2}
  B: {from: E, into: q4}
  BB: {from: q4, into: q2}
"""
    if end == "a buffer":
        text = text.replace("  D: {approach: da 300, trains: out}\n", "").replace("tracks:", "buffers: [D]\ntracks:")
    made = grown(text.replace("LANE", "level"))
    assert made is not None and not made[2].has_errors
    layout, table, _ = made
    assert audit(layout, table) == () and prove(System(layout, lower(layout, table))).proved
    if lane == "inclined":
        steep, _ = load_text("down.yaml", text.replace("LANE", "inclined"), Sink())
        assert steep is not None and {f.column for f in audit(steep, table)} == {"flank"}
        found = prove(System(steep, lower(steep, table)), Limits(search_depth=0))
        assert {"T-FLANK", "S-FLANK"} <= {c.id for c in found.claims if c.verdict is not Verdict.PROVED}
        again = grown(text.replace("LANE", "inclined"))
        assert again is None or "IL4001" in {d.code for d in again[2].diagnostics}


LOOP_AT_A_LANE = """
interlock: 1
name: loop
profile: mine
boundaries:
  W: {approach: wa 200}
  E: {approach: ea 200}
tracks:
  in: [W, q1 100, P.toe]
  out: [P.normal, r1 100, E]
  neck: [P.reverse, k 60, Q.toe]
  loop: [Q.normal, l1 200, l2 200, Q.reverse]
points:
  P: {section: tp}
  Q: {section: tq}
sections:
  l1: {lane: inclined}
signals:
  D: {from: W, into: q1}
  D2: {from: q1, into: tp}
  S: {from: E, into: r1}
  S2: {from: r1, into: tp}
  M: {from: l1, into: l2}
  X: {from: l2, into: tq}
  O: {from: tp, into: q1}
"""
"""A balloon loop at a mine, run one way round; trains wait in it on an inclined lane, before M."""
AT_THE_LOOP = "loop: [Q.normal, l1 200"

RING_WITH_A_LANE = """
interlock: 1
name: ring
principles: {line_speed_kmh: 20, restart_delay_s: 300}
boundaries: {W: {approach: wa 200, trains: in}}
buffers: [N]
tracks:
  in: [W, q1 100, J.reverse]
  s5: [J.toe, g5 60, P.toe]
  n: [P.reverse, gn 100, N]
  loop: [P.normal, g6 100, J.normal]
points:
  J: {section: tj}
  P: {section: tp}
sections: {g6: {lane: inclined}}
signals:
  D: {from: W, into: q1}
  D2: {from: q1, into: tj}
  E: {from: g6, into: tj}
exclude:
  - {from: E, to: E, reason: own train}
"""
AT_THE_RING = "loop: [P.normal, g6 100"

BELOW_A_SIGNAL = """
interlock: 1
name: below
principles: {line_speed_kmh: 20, restart_delay_s: 300}
boundaries:
  W: {approach: wa 200}
  U: {approach: ua 200}
buffers: [N]
tracks:
  in: [W, q1 100, P.toe]
  n: [P.reverse, gn 100, N]
  up: [P.normal, g6 100, g7 100, U]
points:
  P: {section: tp}
sections: {g6: {lane: inclined}}
signals:
  D: {from: W, into: q1}
  D2: {from: q1, into: tp}
  N1: {from: gn, into: tp}
  O: {from: tp, into: q1}
  E: {from: g6, into: g7}
  H: {from: g7, into: g6}
  V: {from: U, into: g7}
"""
"""Trains wait on an inclined lane between P and H."""
BELOW = "up: [P.normal, g6 100"

BELOW_ONE_WAY = (
    BELOW_A_SIGNAL.replace("  U: {approach: ua 200}\n", "  U: {approach: ua 200, trains: out}\n")
    .replace("{lane: inclined}}", "{lane: inclined}, g7: {one_way: forward}}")
    .replace("  H: {from: g7, into: g6}\n  V: {from: U, into: g7}\n", "")
)
"""Beyond the lane trains run one way only."""

BELOW_POINTS = (
    BELOW_A_SIGNAL.replace("g7 100, U]", "T.normal]\n  on: [T.toe, g7 100, U]\n  side: [T.reverse, g8 100, B8]")
    .replace("buffers: [N]", "buffers: [N, B8]")
    .replace("  P: {section: tp}", "  P: {section: tp}\n  T: {section: tt}")
    .replace(
        "  E: {from: g6, into: g7}\n  H: {from: g7, into: g6}\n",
        "  E: {from: g6, into: tt}\n  H: {from: g7, into: tt}\n",
    )
)
"""Beyond the lane points can be turned away."""


def with_derailer(text: str, at: str) -> str:
    """A derailer between a point and the inclined lane beside it."""
    (leg, lane) = at.split("[")[1].split(", ")
    track = at.split(":")[0]
    text = text.replace(at, f"{track}: [{lane}")
    return text.replace("signals:", f"derailers: {{D9: {{section: t9, inner: {leg}, outer: {track}.start}}}}\nsignals:")


def with_trap(text: str, at: str) -> str:
    """A point that leads into a trap there, for whatever comes from the lane."""
    (leg, lane) = at.split("[")[1].split(", ")
    track = at.split(":")[0]
    text = text.replace(at, f"{track}: [{lane}").replace("tracks:", "traps: [SAND]\ntracks:\n  sand: [sa 30, SAND]")
    return text.replace(
        "points:\n", f"points:\n  T9: {{section: t9, toe: {track}.start, normal: sand.start, reverse: {leg}}}\n"
    )


def with_signal(text: str, at: str) -> str:
    """A stop board between them, for whatever comes from the lane."""
    point, lane = at.split("[")[1].split(".")[0].lower(), at.split(", ")[1].split()[0]
    return text.replace("signals:\n", f"signals:\n  R9: {{from: {lane}, into: t{point}, kind: board}}\n")


AT_LANES = {
    "balloon loop": (LOOP_AT_A_LANE, AT_THE_LOOP, ["P.reverse", "Q.normal"], "l1"),
    "ring": (RING_WITH_A_LANE, AT_THE_RING, ["P.normal"], "g6"),
    "signal": (BELOW_A_SIGNAL, BELOW, ["P.normal"], "g6"),
    "one way": (BELOW_ONE_WAY, BELOW, ["P.normal"], "g6"),
    "points": (BELOW_POINTS, BELOW, ["P.normal"], "g6"),
}


@pytest.mark.parametrize("beyond", AT_LANES)
def test_what_is_beyond_an_inclined_lane_does_not_hold_what_stands_on_it(beyond: str) -> None:
    """A ring, a signal, one way, points that turn away: what stands on the lane runs back over the points before it.
    Derivation, audit, claims and second checker took each of them for protection."""
    text, _, places, lane = AT_LANES[beyond]
    flat = text.replace("lane: inclined", "lane: level")
    level = grown(flat)
    assert level is not None and not level[2].has_errors, level and level[2].diagnostics
    steep = grown(text)
    assert steep is not None
    found = {d.message.split(" from ")[1].split(";")[0]: d.fix for d in steep[2].diagnostics if d.code == "IL4001"}
    assert sorted(found) == places
    for name, fix in found.items():
        assert fix.endswith(f"or a derailer on each way that leads to {name}, before the inclined lane {lane}"), fix
        assert fix.startswith("add a signal or stop board, 1")
    layout, table = steep[0], level[1]
    assert {f.column for f in audit(layout, table)} == {"flank"}
    result = prove(System(layout, lower(layout, table)), Limits(search_depth=0))
    assert {"T-FLANK", "S-FLANK"} <= {c.id for c in result.claims if c.verdict is not Verdict.PROVED}
    assert agree(*written(text), shipped()).left == ()
    with pytest.raises(Rejected, match=r"[TS]-FLANK"):
        agree(loaded(text), *written(flat)[1:], shipped())


@pytest.mark.parametrize("mend", [with_derailer, with_trap, with_signal])
@pytest.mark.parametrize("beyond", AT_LANES)
def test_what_stands_between_points_and_an_inclined_lane_protects(beyond: str, mend: Callable[[str, str], str]) -> None:
    """A derailer, a point before a trap, or a signal; the second checker agrees."""
    text, at, _, _ = AT_LANES[beyond]
    made = grown(mend(text, at))
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    assert audit(made[0], made[1]) == ()
    assert prove(System(made[0], lower(made[0], made[1])), Limits(search_depth=0)).proved
    assert agree(*written(mend(text, at)), shipped()).left == ()


def test_points_in_the_section_of_an_inclined_lane_do_not_keep_it_empty() -> None:
    """The other end of a crossover between inclined lanes: after a restart a vehicle may stand on its leg (R5)."""
    text = """
interlock: 1
name: crossover
profile: mine
boundaries: {A: {approach: aa 300}, B: {approach: ba 300}, C: {approach: ca 300}, D: {approach: da 300}}
tracks: {a: [A, a1 100], b: [b1 100, B], c: [C, c1 100], d: [d1 100, D]}
points:
  K: {machine: M, section: t1, toe: a.end, normal: b.start}
  L: {machine: M, section: t2, toe: d.start, normal: c.end, reverse: K.reverse}
sections: {t1: {lane: inclined}, t2: {lane: inclined}}
signals:
  SA: {from: A, into: a1}
  XA: {from: a1, into: t1}
  SB: {from: B, into: b1}
  XB: {from: b1, into: t1}
  SC: {from: C, into: c1}
  XC: {from: c1, into: t2}
  SD: {from: D, into: d1}
  XD: {from: d1, into: t2}
"""
    steep, level = grown(text), grown(text.replace("inclined", "level"))
    assert steep is not None and "IL4001" in {d.code for d in steep[2].diagnostics}
    assert level is not None and not level[2].has_errors and audit(level[0], level[1]) == ()
    assert {f.column for f in audit(steep[0], level[1])} == {"flank"}
    result = prove(System(steep[0], lower(steep[0], level[1])), Limits(search_depth=0))
    assert {"T-FLANK", "S-FLANK"} <= {c.id for c in result.claims if c.verdict is not Verdict.PROVED}
    with pytest.raises(Rejected, match="FLANK"):
        agree(loaded(text), *written(text.replace("inclined", "level"))[1:], shipped())


def test_an_inclined_lane_that_ends_in_a_trap_holds_nothing() -> None:
    """Nobody is called into a trap: a catch siding may rise."""
    text = BELOW_A_SIGNAL.replace("buffers: [N]", "traps: [N]").replace("{g6: {lane", "{gn: {lane")
    text = text.replace("  N1: {from: gn, into: tp}\n", "")
    made = grown(text)
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    assert audit(made[0], made[1]) == ()
    assert {
        str(p) for r in made[1].routes for c in r.locking.flank if c.requester == "P.reverse" for p in c.providers
    } == {"N"}
    assert prove(System(made[0], lower(made[0], made[1])), Limits(search_depth=0)).proved
    assert agree(*written(text), shipped()).left == ()


def test_a_ring_behind_a_derailer_protects_from_nothing() -> None:
    """The derailer stands there since nobody trusts what is left behind it to stay; it was not laid."""
    text = with_derailer(RING_WITH_A_LANE.replace("lane: inclined", "lane: level"), AT_THE_RING)
    made = grown(text)
    assert made is not None and not made[2].has_errors and audit(made[0], made[1]) == ()
    table = made[1]
    laid = {(str(p.machine), str(p.position)) for p in table.route[RouteId("D2-N")].locking.points}
    assert laid == {("J", "R"), ("P", "R"), ("D9", "N")}
    assert prove(System(made[0], lower(made[0], table)), Limits(search_depth=0)).proved
    assert agree(*written(text), shipped()).left == ()
    weak = without_flank(table, {"D9"})
    assert "a vehicle can reach P.N" in {f.text for f in audit(made[0], weak)}
    result = prove(System(made[0], lower(made[0], weak)), Limits(search_depth=0))
    assert {"T-FLANK", "S-FLANK"} <= {c.id for c in result.claims if c.verdict is not Verdict.PROVED}


@pytest.mark.parametrize(
    ("text", "at", "places"),
    [(LOOP_AT_A_LANE, AT_THE_LOOP, ["P.reverse", "Q.normal"]), (RING_WITH_A_LANE, AT_THE_RING, ["P.normal"])],
    ids=["balloon loop", "ring"],
)
def test_a_ring_into_which_vehicles_are_brought_is_told_of_where_only_it_protects(
    text: str, at: str, places: list[str]
) -> None:
    """As the end of a track is: nothing comes from beyond, but trains stand in it."""
    text = text.replace("lane: inclined", "lane: level")
    for mended, told_of in ((text, places), (with_signal(text, at), [])):
        made = grown(mended)
        assert made is not None and not made[2].has_errors
        spoken = [d.message for d in made[2].diagnostics if d.code == "IL4017"]
        ring = "and nothing but the ring in which the track closes protects "
        assert [m.split(ring)[1] for m in spoken if ring in m] == [f"{p} from them" for p in told_of], spoken


CROSSOVER_IS_A_LANE = """
interlock: 1
name: scissors
profile: mine
boundaries: {A: {approach: aa 300}, B: {approach: ba 300}, C: {approach: ca 300}, D: {approach: da 300}}
tracks: {c: [c1 60]}
points:
  1A: {section: T1, toe: A, normal: 2B.normal}
  2B: {machine: 2, section: T1, toe: B}
  2A: {machine: 2, section: T2, toe: C, normal: 1B.normal}
  1B: {section: T2, toe: D, reverse: c.end}
crossings:
  X: {arms: [{section: T3, ends: [1A.reverse, c.start]}, {section: T4, ends: [2A.reverse, 2B.reverse]}]}
sections: {c1: {lane: inclined}}
signals:
  SA: {from: A, into: T1}
  SB: {from: B, into: T1}
  SC: {from: C, into: T2}
  SD: {from: D, into: T2}
"""


def test_a_crossover_of_a_scissors_that_is_an_inclined_lane_is_kept_off_at_both_ends() -> None:
    """Its points lie normal all the same; but what stands between them and the diamond runs away."""
    bare = grown(CROSSOVER_IS_A_LANE)
    assert bare is not None
    named = {d.message.split(" from ")[1].split(";")[0]: d.fix for d in bare[2].diagnostics if d.code == "IL4001"}
    assert sorted(named) == ["1A.reverse", "1B.reverse", "X.1b"]
    for name, fix in named.items():
        assert fix.endswith(f"or a derailer on each way that leads to {name}, before the inclined lane c1"), fix
    derailers = (
        "derailers:\n  D8: {section: T8, outer: c.start}\n  D9: {section: T9, inner: 1B.reverse, outer: c.end}\n"
    )
    kept = CROSSOVER_IS_A_LANE.replace("1A.reverse, c.start", "1A.reverse, D8.inner").replace(", reverse: c.end", "")
    for text in (CROSSOVER_IS_A_LANE.replace("inclined", "level"), kept.replace("signals:", derailers + "signals:")):
        made = grown(text)
        assert made is not None and not made[2].has_errors, made and made[2].diagnostics
        assert audit(made[0], made[1]) == ()
        assert prove(System(made[0], lower(made[0], made[1])), Limits(search_depth=0)).proved
        assert agree(*written(text), shipped()).left == ()


BEYOND_AN_END = """interlock: 1
name: beyond
profile: mine
boundaries:
  W: {approach: wa 200, trains: in}
  E: {trains: out}
tracks:
  line: [W, q1 100, q2 50, q3 60, i1 200, E]
sections: {i1: {lane: inclined}}
signals:
  X1: {from: W, into: q1}
  X2: {from: q1, into: q2}
"""
BOTH_WAYS = BEYOND_AN_END.replace(", trains: in", "").replace("{trains: out}", "{approach: ea 200}")
BOTH_WAYS += "  S: {from: E, into: i1}\n"
TURNED = """interlock: 1
name: turned
profile: mine
boundaries:
  W: {approach: wa 200, trains: in}
  E: {trains: out}
buffers: [N]
tracks:
  in: [W, q1 100]
  up: [q3 60, i1 200, E]
  side: [q4 100, N]
points:
  P: {section: q2, toe: up.start, normal: in.end, reverse: side.start}
sections: {i1: {lane: inclined}}
signals:
  X1: {from: W, into: q1}
  X2: {from: q1, into: q2}
"""


def head_on(text: str) -> list[str]:
    """What is told of wagons that run into a train at the end of its route."""
    found = grown(text)
    assert found is not None and not found[2].has_errors, found and found[2].diagnostics
    return [d.message for d in found[2].diagnostics if d.code == "IL7019"]


def demanded(text: str, point: str, lies: str, to: str) -> str:
    return f"{text}demand:\n  - {{point: {point}, lies: {lies}, routes: {{to: {to}}}, reason: runaways}}\n"


DERAILER = BEYOND_AN_END.replace("q3 60, i1 200, E]", "q3 60]\n  on: [i1 200, E]").replace(
    "sections:", "derailers:\n  D: {section: q5, inner: line.end, outer: on.start}\nsections:"
)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (BEYOND_AN_END, "over q2, q3 to X2"),
        (BEYOND_AN_END.replace("q2 50, q3 60, ", "").replace("into: q2", "into: i1"), "at once to X2"),
        (BEYOND_AN_END.replace("lane: inclined", "lane: level"), None),
        (f"{BEYOND_AN_END}  O: {{from: q3, into: q2, kind: board}}\n", None),
        (f"{BOTH_WAYS}  O: {{from: i1, into: q3}}\n", None),
        (f"{BOTH_WAYS}  O: {{from: q2, into: q1}}\n", None),
        (BEYOND_AN_END.replace("i1: {lane", "q3: {one_way: forward}, i1: {lane"), "over q2, q3 to X2"),
        (TURNED, "over q2, q3 to X2"),
        (demanded(TURNED, "P", "reverse", "X2"), None),
        (demanded(TURNED, "P", "normal", "X2"), "over q2, q3 to X2"),
        (DERAILER, "over q2, q3, q5 to X2"),
        (demanded(DERAILER, "D", "normal", "X2"), None),
        (f"{BEYOND_AN_END}overlaps: {{X2: {{length: 50}}}}\n", "over q3 to X2"),
        (f"{BEYOND_AN_END}overlaps: {{X2: {{length: 300}}}}\n", None),
    ],
    ids=[
        "from a lane",
        "at once",
        "level",
        "a board",
        "a signal on the lane",
        "a signal at the end",
        "one way",
        "a point",
        "turned away",
        "turned to it",
        "a derailer",
        "laid on",
        "an overlap before it",
        "an overlap over it",
    ],
)
def test_wagons_that_run_head_on_into_a_train_at_the_end_of_its_route(text: str, told: str | None) -> None:
    """Protection is asked for beside a way; beyond its end a signal, or what the route turns away, keeps them off."""
    found = head_on(text)
    assert bool(found) is (told is not None), found
    assert told is None or any(told in m for m in found)


BEHIND_A_DERAILER = """interlock: 1
name: siding
boundaries:
  W: {approach: wa 300}
  E: {approach: ea 300}
buffers: [Z]
tracks:
  west: [W, w1 200]
  east: [e1 200, E]
  sid: [s1 150, Z]
points:
  P: {section: p, toe: west.end, normal: east.start, reverse: D.inner}
derailers:
  D: {section: d, outer: sid.start}
signals:
  X: {from: W, into: w1}
  A: {from: w1, into: p, kind: combined}
  Y: {from: E, into: e1}
  B: {from: e1, into: p, kind: combined}
"""
"""X-A ends before the points of the siding; the derailer is off after a movement into it."""
BARE_SIDING = BEHIND_A_DERAILER.replace("reverse: D.inner", "reverse: sid.start").replace(
    "derailers:\n  D: {section: d, outer: sid.start}\n", ""
)
RING = BEHIND_A_DERAILER.replace("buffers: [Z]\n", "").replace(
    "s1 150, Z]\n", "s1 150]\n  loop: [Q.normal, s2 150, Q.reverse]\n"
)
RING = RING.replace("points:\n", "points:\n  Q: {section: q, toe: sid.end}\n")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (BEHIND_A_DERAILER, "roll from section s1, behind derailer D while it is off, come over p, d to A"),
        (RING, "behind derailer D while it is off, come over p, d, s1, s2 to A"),
        (BEHIND_A_DERAILER.replace("buffers: [Z]", "traps: [Z]"), None),
        (BEHIND_A_DERAILER + "  S: {from: s1, into: d, kind: shunt}\n", None),
        (BEHIND_A_DERAILER + "overlaps: {A: {length: 10}}\n", "that comes there by X-A.o2:"),
        (BARE_SIDING, None),
        (demanded(BEHIND_A_DERAILER, "D", "normal", "A"), None),
        (demanded(BEHIND_A_DERAILER, "D", "reverse", "A"), "behind derailer D"),
        (demanded(BEHIND_A_DERAILER, "P", "normal", "A"), "behind derailer D"),
    ],
    ids=["a siding", "a ring", "a trap", "a signal", "an overlap", "no derailer", "laid on", "laid off", "the point"],
)
def test_vehicles_behind_a_derailer_that_no_route_lays_run_head_on_into_a_train(text: str, told: str | None) -> None:
    """It was told of inclined lanes alone; a derailer stands where vehicles may roll, and no rule lays it for X-A."""
    found = head_on(text)
    assert bool(found) is (told is not None), found
    assert told is None or any(told in m for m in found), found


def test_the_demand_that_is_offered_for_a_derailer_helps() -> None:
    found = grown(BEHIND_A_DERAILER)
    assert found is not None
    (told,) = [d for d in found[2].diagnostics if d.code == "IL7019"]
    line = re.search(r"`(demand: .*)`$", told.fix or "")
    assert line is not None and head_on(f"{BEHIND_A_DERAILER}{line[1]}\n") == []


def test_no_wagons_run_from_a_lane_that_leads_to_a_trap_alone() -> None:
    turned = "toe: up.start, normal: in.end, reverse: side.start"
    text = TURNED.replace(turned, "toe: in.end, normal: side.start, reverse: up.start").replace(
        "i1 200, E]", "i1 200, T]"
    )
    text = text.replace("q4 100, N]", "q4 100, E]").replace("buffers: [N]", "traps: [T]")
    assert head_on(text) == []


def test_wagons_run_from_a_lane_on_which_trains_come_to_stand_before_a_trap() -> None:
    """A board keeps them from the trap, which lies in the next section: there are wagons on the lane."""
    text = BEYOND_AN_END.replace("i1 200, E]", "i1 200, r1 50, T]").replace("  E: {trains: out}\n", "")
    text = text.replace("tracks:", "traps: [T]\ntracks:") + "  B: {from: i1, into: r1, kind: board}\n"
    assert any("over q2, q3 to X2" in m for m in head_on(text))


@pytest.mark.parametrize(
    ("text", "offered"),
    [
        (TURNED, True),
        (TURNED.replace("reverse: side.start}", "reverse: side.start, machine: M}"), True),
        (TURNED.replace("reverse: side.start}", "reverse: side.start, work: hand}"), False),
        (DERAILER, True),
    ],
    ids=["a point", "with a machine of another name", "by hand, locked the other way", "a derailer"],
)
def test_the_demand_that_is_offered_can_be_written_and_helps(text: str, offered: bool) -> None:
    """It named the machine of the point, and a hand-worked point in the position in which no key holds it."""
    found = grown(text)
    assert found is not None
    (told,) = [d for d in found[2].diagnostics if d.code == "IL7019"]
    line = re.search(r"`(demand: .*)`$", told.fix or "")
    assert (line is not None) is offered
    if line is not None:
        assert head_on(f"{text}{line[1]}\n") == []


AGAINST = """
interlock: 1
name: against
boundaries:
  W: {approach: wa 600}
  E: {approach: ea 600}
  N: {approach: na 600, trains: out}
tracks:
  west: [W, q1 200]
  east: [q4 200, E]
  loop: [5.reverse, q3 200, i1 100, N]
points:
  5: {section: q2, toe: west.end, normal: east.start}
sections:
  q3: {one_way: forward}
  i1: {lane: LANE}
signals:
  A: {from: W, into: q1}
  AA: {from: q1, into: q2}
  B: {from: E, into: q4}
  BB: {from: q4, into: q2}
"""
"""Trains leave to N over q3, one way; i1 lies behind it."""


def test_wagons_run_away_against_the_one_way_of_a_section() -> None:
    """What lay behind a one-way section was taken not to come over it; derivation, audit and claims alike."""
    made = grown(AGAINST.replace("LANE", "level"))
    assert made is not None and not made[2].has_errors
    layout, table, _ = made
    assert audit(layout, table) == () and prove(System(layout, lower(layout, table))).proved
    steep, _ = load_text("against.yaml", AGAINST.replace("LANE", "inclined"), Sink())
    assert steep is not None and {f.column for f in audit(steep, table)} == {"flank"}
    found = prove(System(steep, lower(steep, table)), Limits(search_depth=0))
    assert {"T-FLANK", "S-FLANK"} <= {c.id for c in found.claims if c.verdict is not Verdict.PROVED}
    again = grown(AGAINST.replace("LANE", "inclined"))
    assert again is None or "IL4001" in {d.code for d in again[2].diagnostics}
    with pytest.raises(Rejected, match="FLANK"):
        agree(loaded(AGAINST.replace("LANE", "inclined")), *written(AGAINST.replace("LANE", "level"))[1:], shipped())


def test_a_derailer_behind_a_one_way_section_keeps_them_off() -> None:
    """It lies on, and is asked for by every route over the points."""
    text = AGAINST.replace("LANE", "inclined").replace(
        "q3 200, i1 100, N]", "q3 200, D.inner]\n  lane: [D.outer, i1 100, N]"
    )
    text = text.replace("signals:", "derailers:\n  D: {section: q3}\nsignals:")
    made = grown(text)
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    layout, table, _ = made
    assert audit(layout, table) == () and prove(System(layout, lower(layout, table))).proved
    assert agree(*written(text), shipped()).left == ()
    over = [r for r in table.routes if ("5", "N") in {(str(p.machine), str(p.position)) for p in r.locking.points}]
    assert over and all(("D", "N") in {(str(p.machine), str(p.position)) for p in r.locking.points} for r in over)
    weak = without_flank(table, {"D"})
    assert "a vehicle can reach 5.R" in {f.text for f in audit(layout, weak)}
    found = prove(System(layout, lower(layout, weak)), Limits(search_depth=0))
    assert {"T-FLANK", "S-FLANK"} <= {c.id for c in found.claims if c.verdict is not Verdict.PROVED}


BOARD_BEFORE_THE_LANE = (
    AGAINST.lstrip().replace("LANE", "inclined").replace("q3 200, i1 100, N]", "q3 200, q5 100, i1 100, N]")
    + "  R: {from: i1, into: q5, kind: board}\n"
)
"""Beyond the section that runs one way a board stands before the lane."""
POINTS_BEFORE_THE_LANE = (
    AGAINST.lstrip()
    .replace("LANE", "inclined")
    .replace("q3 200, i1 100, N]", "q3 200]\n  on: [i1 100, N]\n  yard: [y1 200, Y]")
    .replace("tracks:", "buffers: [Y]\ntracks:")
    .replace("sections:", "  6: {section: q5, toe: on.start, normal: loop.end, reverse: yard.start}\nsections:")
    .replace("trains: out}", "trains: both}")
    + "  NN: {from: N, into: i1}\n  Z: {from: y1, into: q5}\n  R: {from: i1, into: q5}\n"
)
"""Trains come from the lane, too, past R into a yard."""


@pytest.mark.parametrize(
    ("text", "protected", "alone"),
    [(BOARD_BEFORE_THE_LANE, {"R"}, True), (POINTS_BEFORE_THE_LANE, {"6 R"}, False)],
    ids=["a board", "points that turn away"],
)
def test_a_signal_between_a_one_way_section_and_a_lane_is_what_protects(
    text: str, protected: set[str], alone: bool
) -> None:
    """The one way was told to protect, as if nothing ran away past the signal: of a signal alone nobody was told, and
    points that turn wagons away were not laid."""
    made = grown(text)
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    layout, table, sink = made
    assert audit(layout, table) == () and prove(System(layout, lower(layout, table)), Limits(search_s=0)).proved
    assert agree(*written(text), shipped()).left == ()
    assert {
        str(p) for r in table.routes if r.id in ("AA-E", "BB-W") for c in r.locking.flank for p in c.providers
    } == protected
    told = [d.message for d in sink.diagnostics if d.code == ALONE]
    assert any("signal R at stop" in m and "off 5.reverse, beside AA-E and BB-W" in m for m in told) is alone


@pytest.mark.parametrize("one_way", ["  q3: {one_way: forward}\n", ""], ids=["one way", "both ways"])
def test_of_a_derailer_behind_the_signal_that_is_trusted_it_is_told_that_it_lies_idle(one_way: str) -> None:
    """Beyond a section that runs one way nobody looked for it: it keeps off what runs away, if a route lays it."""
    text = BOARD_BEFORE_THE_LANE.replace("q5 100, i1 100, N]", "q5 100, q6 50]\n  lane: [i1 100, N]")
    text = text.replace("from: i1, into: q5", "from: q6, into: q5").replace("  q3: {one_way: forward}\n", one_way)
    made = grown(
        text.replace("signals:", "derailers:\n  D: {section: q7, inner: loop.end, outer: lane.start}\nsignals:")
    )
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    (told,) = [d.message for d in made[2].diagnostics if d.code == "IL7016"]
    assert told.endswith("signal R stands between it and 5.reverse, and is trusted instead")


TWO_BEYOND = (
    AGAINST.lstrip()
    .replace("LANE", "inclined")
    .replace(
        "q3 200, i1 100, N]",
        "q3 200, 7.toe]\n  on: [7.normal, q6 50, D.inner]\n  lane: [D.outer, i1 100, N]\n  yard: [7.reverse, y1 90, Y]",
    )
    .replace("tracks:", "buffers: [Y]\ntracks:")
    .replace("sections:", "  7: {section: q5}\nsections:")
    .replace("signals:", "derailers:\n  D: {section: q7}\nsignals:")
)
"""Beyond the section that runs one way one leg of 7 leads to a derailer before the lane, the other into a yard."""


@pytest.mark.parametrize(
    ("text", "space"),
    [
        (BOARD_BEFORE_THE_LANE, {("q3", False), ("q5", False), ("R", True)}),
        (POINTS_BEFORE_THE_LANE, {("q3", False)}),
        (TWO_BEYOND, {("q3", False), ("q5", False), ("q6", False)}),
    ],
    ids=["a board", "points that turn away", "a derailer behind one of two legs"],
)
def test_the_flank_space_goes_on_over_a_one_way_section_as_far_as_vehicles_may_run_away(
    text: str, space: set[tuple[str, bool]]
) -> None:
    """The claim asked for what lies there; derivation, audit and second checker did not, so that nothing was proved of
    such a layout.  What lies beyond 7 in the yard stays there: it does not run away."""
    text += "principles: {flank_space: yes, flank_lamp: yes, lamp_proof: yes}\n"
    made = grown(text)
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    layout, table, _ = made
    assert audit(layout, table) == () and prove(System(layout, lower(layout, table)), Limits(search_s=0)).proved
    assert agree(*written(text), shipped()).left == ()
    assert {(c.name, c.lamp) for c in table.route[RouteId("AA-E")].clear.space} == space


def test_a_signal_alone_before_an_inclined_lane_is_told_unless_a_condition_speaks_of_the_hoist() -> None:
    """The signal is the flank protection, and the proof trusts it; wagons that run away do not read it (IL7020)."""
    whole = Path("layouts/incline_hoist.yaml").read_text(encoding="utf-8")
    bare = whole[: whole.index("conditions:")]

    def told(text: str) -> list[str]:
        made = grown(text)
        assert made is not None and not made[2].has_errors
        return [
            d.message.split(" keeps")[0] + d.message.split(" off")[1] for d in made[2].diagnostics if d.code == ALONE
        ]

    assert told(whole) == []
    assert told(bare) == [
        "nothing but signal XN1 at stop PU.normal, beside XU-UB and XU3-U: wagons pass a signal",
    ]
    hoist = "conditions: {HOIST: {text: hoist stopped, signals: [XU, XU3]}}\n"
    assert told(bare + hoist) == []
    catcher = "derailers:\n  D: {section: u2, outer: slope.start, inner: PU.normal}\npoints:"
    assert told(bare.replace("points:", catcher).replace("normal: slope.start, ", "normal: D.inner, ")) == []


ALONE = "IL7020"


LANE_BEHIND_A_TOE = """interlock: 1
name: lane_behind_a_toe
profile: mine
boundaries:
  W: {approach: wa 200, trains: in}
  V: {approach: va 200, trains: in}
  U: {approach: ua 200, trains: in}
  E: {trains: out}
tracks: {west: [W, m1 100], east: [m2 100, E], side: [V, y1 100], slope: [U, u1 100]}
points:
  P: {section: p, toe: east.start, normal: west.end, reverse: T.toe}
  T: {section: t, normal: side.end, reverse: slope.end}
sections: {u1: {lane: inclined}}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: p}
  Y1: {from: V, into: y1}
  Y2: {from: y1, into: t}
  Z1: {from: U, into: u1}
  Z2: {from: u1, into: t}
"""


@pytest.mark.parametrize("legs", ["normal: side.end, reverse: slope.end", "normal: slope.end, reverse: side.end"])
def test_of_two_signals_that_protect_each_is_asked_for_the_lane_behind_it(legs: str) -> None:
    """P.reverse is protected by Y2 and Z2, behind the legs of T: wagons run past Z2, whichever of them it is."""
    made = grown(LANE_BEHIND_A_TOE.replace("normal: side.end, reverse: slope.end", legs))
    assert made is not None and not made[2].has_errors, made and made[2].diagnostics
    told = [d.message for d in made[2].diagnostics if d.code == ALONE]
    assert any("signal Z2 at stop" in m and "off P.reverse, beside X2-E:" in m for m in told), told
    assert not any("signal Y2" in m for m in told)


NEAR_LANE = (
    LANE_BEHIND_A_TOE.replace("  U: {approach: ua 200, trains: in}\n", "")
    .replace("tracks:", "buffers: [U]\ntracks:")
    .replace("  Z1: {from: U, into: u1}\n  Z2: {from: u1, into: t}\n", "")
    .replace("reverse: T.toe}", "reverse: T.toe, legs: 2}")
    .replace("reverse: slope.end}", "reverse: slope.end, legs: 2}")
)
"""No signal keeps off what comes from u1, which begins 6 m from P; Y2 stands as near on the other leg of T."""
TWO_LANES = (
    NEAR_LANE.replace("  V: {approach: va 200, trains: in}\n", "")
    .replace("[U]", "[U, V]")
    .replace("side: [V, y1 100]", "side: [V, y1 100, y2 50]")
    .replace("{u1: {lane", "{y1: {lane: inclined}, u1: {lane")
    .replace("  Y1: {from: V, into: y1}\n  Y2: {from: y1, into: t}\n", "")
)
"""Nor from y1, which begins 56 m from P."""


@pytest.mark.parametrize(
    ("text", "advice"),
    [
        (NEAR_LANE, "add a derailer on each way that leads to P.reverse, before the inclined lane u1"),
        (TWO_LANES, "add a derailer on each way that leads to P.reverse, before the inclined lanes u1 and y1"),
        (
            TWO_LANES.replace(", u1: {lane: inclined}", ""),
            "add a signal or stop board, 11.5 m away or more, or a derailer on each way that leads to P.reverse, "
            "before the inclined lane y1",
        ),
    ],
    ids=["too near", "one of two too near", "far enough"],
)
def test_a_signal_is_advised_before_a_lane_where_it_would_stand_clear_of_the_points(text: str, advice: str) -> None:
    """Not where the lane begins within 11.5 m; and that Y2 would do farther out is not said, since that leaves u1."""
    made = grown(text)
    assert made is not None
    (fix,) = [d.fix for d in made[2].diagnostics if d.code == "IL4001" and "from P.reverse;" in d.message]
    assert fix == advice
