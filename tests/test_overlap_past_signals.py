"""An overlap that leads past the next signal: shared with what leads on along it, and with nothing else; each of those
who hold a section holds it for itself (R4)."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.emit.python.runtime import runtime_py
from interlock.logic.expr import conj, neg, var
from interlock.logic.lower import lower
from interlock.proof.claims import Claim
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.search import search
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.proof.witnesses.availability import availability
from tests.grow_all import grow_all
from tests.layouts import grown
from tests.written import told

PATH = Path("tests/layouts_for_tests/overlap_past_signals.yaml")
TEXT = PATH.read_text("utf-8")
BOTH_WAYS = Path("tests/layouts_for_tests/overlap_past_both_ways.yaml").read_text("utf-8")
# trains come in between 2 and 3 from another line, are called on and shunted past 3, and go two ways behind 4
MIXED = """interlock: 1
name: mixed
profile: uk
principles: {line_speed_kmh: 60, overlap_m: 180, restart_delay_s: 199}
boundaries:
  W: {trains: in, approach: wa 800}
  SIDE: {trains: in, approach: sa 800}
  EAST: {trains: out}
  NORTH: {trains: out}
tracks:
  line: [W, a 400, b 60]
  side: [SIDE, s 400]
  mid: [c 60]
  on: [e 100, f 300, EAST]
  off: [h 300, NORTH]
points:
  Q: {section: q, toe: mid.start, normal: line.end, reverse: side.end}
  P: {section: p, toe: mid.end, normal: on.start, reverse: off.start}
signals:
  1: {from: W, into: a}
  2: {from: a, into: b}
  M0: {from: SIDE, into: s}
  M: {from: s, into: q}
  3: {from: q, into: c, kind: combined, call_on: yes}
  4: {from: c, into: p}
  5: {from: e, into: f}
overlaps:
  2: {length: 130}
"""


def hostile(text: str) -> dict[str, set[str]]:
    """For each route those that are hostile to it; the audit finds no others."""
    found = grown(text)
    assert found is not None and not found[2].has_errors, found and found[2].diagnostics
    layout, table, _ = found
    assert list(audit(layout, table)) == []
    return {str(r.id): {str(x) for x in r.locking.hostile.routes} for r in table.routes}


def runtime(text: str) -> SimpleNamespace:
    """The emitted controller, every section clear and released after the restart, no route set."""
    found = grown(text)
    assert found is not None
    names: dict[str, Any] = {}
    exec(compile(runtime_py(lower(found[0], found[1]), []), "runtime.py", "exec"), names)
    controller = names["Controller"]()
    controller.state |= {n: False for n in controller.state if n.startswith(("K_", "U_"))}
    inputs = dict.fromkeys((n for n in names["INPUTS"] if n.startswith(("CLR_", "VALID", "DN_"))), 1)
    inputs |= dict.fromkeys((n for n in names["INPUTS"] if n.startswith("BLK_")), 0)
    r = SimpleNamespace(controller=controller, inputs=inputs, ask=names["Controller"].request, out={})
    r.scan = lambda n=1, **x: [r.out.update(controller.scan(inputs | x, 500)) for _ in range(n)]
    r.scan(8)
    return r


def put(r: SimpleNamespace, *routes: str) -> None:
    for route in routes:
        r.scan(**r.ask(route))
        r.scan(3)


def occupied(r: SimpleNamespace, *sections: str) -> None:
    r.inputs |= {n: int(n[4:] not in sections) for n in r.inputs if n.startswith("CLR_")}
    r.scan(8)


LINE = ["1-2", "2-3", "3-4", "4-5", "5-6", "6-EAST"]


@pytest.mark.parametrize(
    "routes", [LINE, LINE[::-1], [LINE[k] for k in (2, 0, 4, 1, 5, 3)]], ids=["near", "far", "any"]
)
def test_a_train_runs_through_at_clear_and_so_does_the_next(routes: list[str]) -> None:
    """In whatever order its routes are set; behind it everything is free again."""
    r = runtime(TEXT)
    over = ["wa", "a", "b", "c", "d", "e", "f", "g"]
    signal = dict(zip("abcdfg", range(1, 7), strict=True))
    for _ in range(2):
        occupied(r, "wa")
        put(r, *routes)
        assert [r.out[f"YP_{g}"] for g in (1, 2, 3, 4, 5, 6)] == [1] * 6 and r.out["YD_2R"] == 1
        for k, (here, ahead) in enumerate(pairwise(over), 1):
            assert all(r.out[f"YS_{signal[s]}"] == 0 for s in over[k:] if s in signal), here
            occupied(r, here, ahead)
            occupied(r, ahead)
        occupied(r)
        assert not any(r.out[f"YL_{s}"] for s in over[1:])


def test_each_holds_the_shared_track_for_itself() -> None:
    r = runtime(TEXT)
    held = ("V_2_1", "V_3_1")
    occupied(r, "wa")
    put(r, "1-2", "2-3")
    assert all(r.controller.state[v] for v in held)
    r.scan(CAN_2=1)
    r.scan(400)  # until no train can be on its way to 2
    assert [r.controller.state[v] for v in held] == [True, False] and r.out["YL_c"] == 1
    put(r, "2-3")
    occupied(r, "wa", "a")
    occupied(r, "a")
    occupied(r, "a", "b")
    occupied(r, "b")
    assert all(r.controller.state[v] for v in held)  # the train stands in the overlap of 2
    put(r, "3-4", "1-2")
    assert r.controller.state["A_R4"] and not r.controller.state["A_R1"]  # nobody follows it
    occupied(r, "b", "c")
    assert all(r.controller.state[v] for v in held)
    occupied(r, "c")  # the last section of the first one: the route onward keeps it
    assert [r.controller.state[v] for v in held] == [False, True] and not r.out["YL_b"] and r.out["YL_c"]
    put(r, "4-5")
    occupied(r, "c", "d")
    occupied(r, "d")
    assert [r.controller.state[v] for v in held] == [False, True] and r.out["YL_d"]


def test_a_point_under_two_overlaps_stays_while_one_is_held() -> None:
    r = runtime(TEXT)
    occupied(r, "b")
    r.controller.state |= {"L_b_1": True, "F_b": True, "U_b": True, "B_R2": False}
    r.controller.state |= {"V_3_1": True, "VF_3": True, "CN_P": True, "V_4_1": True, "VF_4": True}
    r.scan(8)
    assert [r.controller.state[v] for v in ("V_3_1", "V_4_1")] == [True, False]
    r.scan(20, MR_P=1)
    assert r.controller.state["CN_P"] and not r.controller.state["CR_P"]
    put(r, "4-SOUTH")
    assert not r.controller.state["A_R7"]


def test_only_what_leads_on_along_it_is_set_beside_it() -> None:
    h = hostile(TEXT)
    assert h["1-2"] == set()
    assert h["2-3"] == {"2-3.o2", "3-4.o2", "4-SOUTH"} and h["3-4.o2"] == {"3-4", "2-3", "4-5"}
    both = hostile(BOTH_WAYS)
    assert {"Y1-Y2", "Y2-Y3", "Y3-Y4", "Y4-W"} <= both["X1-X2"]
    assert both["X1-X2"].isdisjoint({"X2-X3", "X3-X4", "X4-EAST"}) and "Y1-Y2" in both["X2-X3"]
    mixed = hostile(MIXED)
    assert mixed["1-2"].isdisjoint({"2-3", "2-3.o2", "3-4", "4-5", "4-NORTH"})
    assert {"M0-M", "M-3", "M-3.o2", "3-4.c", "3-4.s"} <= mixed["1-2"]
    assert {"2-3", "3-4.c"} <= mixed["M0-M"] and mixed["M0-M"].isdisjoint({"M-3", "3-4"})


# the overlap of G leads past K and M; that of M goes on round the loop, and over the diamond under the first one
EIGHT = """interlock: 1
name: eight
profile: mine
principles: {line_speed_kmh: 20, overlap_m: 0}
boundaries:
  A: {approach: aa 300, trains: in}
  B: {approach: bb 300, trains: in}
  D: {trains: out}
tracks:
  in: [A, a1 100]
  loop: [m0 30, m1 30, m2 30]
  side: [B, b1 100]
  out: [d1 100, D]
points:
  Q: {section: q, toe: loop.start, reverse: side.end}
crossings:
  X: {arms: [{section: x, ends: [in.end, Q.normal]}, {section: x, ends: [loop.end, out.start]}]}
signals:
  GA: {from: A, into: a1}
  G: {from: a1, into: x}
  GB: {from: B, into: b1}
  H: {from: b1, into: q}
  K: {from: m0, into: m1}
  M: {from: m1, into: m2}
overlaps:
  G: {length: 150}
  M: {length: 60}
"""


def test_two_overlaps_that_share_one_section_and_cross_in_another_are_not_held_together() -> None:
    """What overruns G stands on the diamond, over which what overruns M comes round: that both lie in m2 the same way
    is not enough.  Where that of M ends before the diamond, they are."""
    assert "K-M" in hostile(EIGHT)["GA-G"]
    assert "K-M" not in hostile(EIGHT.replace("M: {length: 60}", "M: {length: 30}"))["GA-G"]


def test_what_swings_and_what_passes_an_identifier_light_stay_apart() -> None:
    longer = TEXT.replace("b 120", "b 240").replace("distants:", "overlaps:\n  2: {length: 300}\ndistants:")
    assert hostile(longer)["1-2"] == set()
    swing = hostile(longer.replace("distants:", "  3: {length: 180, swing: yes}\ndistants:"))
    assert swing["1-2"] == {"2-3", "2-3.o2"} and {"3-4", "4-5"} <= swing["2-3"]
    light = TEXT.replace("3: {from: b, into: c}", "3: {from: b, into: c, identifier: yes}")
    passed = hostile(light.replace("distants:", "overlaps:\n  3: {length: 60}\ndistants:"))
    past = {r for r in passed if r.startswith("2-3-")}
    assert past and past <= passed["1-2"] and passed["1-2"].isdisjoint({"2-3", "3-4", "3-4.o2"})


@pytest.mark.parametrize("text", [TEXT, BOTH_WAYS, MIXED], ids=["line", "both ways", "mixed"])
def test_it_is_proved_asked_for_by_the_second_checker_and_every_pair_is_driven(text: str) -> None:
    found = grown(text)
    assert found is not None
    controller = lower(found[0], found[1])
    system = System(found[0], controller)
    result = prove(system, Limits(search_s=0))
    assert result.proved and not result.dropped
    assert agree(*told(text), specification.shipped()).left == ()
    assert availability(system.loop, found[1]).shown


@pytest.mark.parametrize(
    "holds",
    [
        ("overruns.X2.a|b@line.0.a", "A_R4", "S_R4"),
        ("overruns.X2.b|c@line.1.b", "A_R4"),
        ("over.X2.b", "V_X2_1", "V_X3_1", "B_R3"),
        ("over.X2.c", "V_X2_1", "V_X3_1"),
    ],
    ids=["a route onward is open", "on into that route", "both overlaps are held", "it stands in both"],
)
def test_the_world_of_the_proof_has_a_train_that_overruns_into_a_shared_overlap(holds: tuple[str, ...]) -> None:
    found = grown(BOTH_WAYS)
    assert found is not None
    controller = lower(found[0], found[1])
    numbers = {r.id: r.number for r in controller.symbols.routes}
    assert (numbers["X2-X3"], numbers["X3-X4"]) == (2, 3)
    never = Claim("scenario", "here", neg(conj(var(name) for name in holds)))
    assert search(System(found[0], controller), [never], 16, 300) is not None


TERMINUS = """interlock: 1
name: terminus
profile: uk
principles: {line_speed_kmh: 60, overlap_m: 180, restart_delay_s: 199}
boundaries:
  W: {approach: wa 800}
buffers: [B]
tracks:
  line: [W, a 400, b 120, c 300, B]
signals:
  X1: {from: W, into: a}
  X2: {from: a, into: b}
  X3: {from: b, into: c}
  Y3: {from: c, into: b}
  Y4: {from: b, into: a}
"""
# the same without a signal on the way; with two tracks behind a point; with vehicles that are shunted where trains end
PLAIN = re.sub(r"(?m)^  X3:.*\n", "", TERMINUS)
TRACKS = """interlock: 1
name: two_tracks
profile: uk
principles: {line_speed_kmh: 60, overlap_m: 180, restart_delay_s: 199}
boundaries:
  W: {approach: wa 800}
buffers: [B1, B2]
tracks:
  line: [W, a 400]
  one: [c 300, B1]
  two: [d 300, B2]
points:
  P: {section: b, toe: line.end, normal: one.start, reverse: two.start}
signals:
  X1: {from: W, into: a}
  X2: {from: a, into: b}
  Y3: {from: c, into: b}
  Y4: {from: d, into: b}
  Y5: {from: b, into: a}
"""
BERTHS = TRACKS.replace("into: b}", "into: b, kind: combined}").replace("two_tracks", "berths")
SPEEDS = f"{TERMINUS}overlaps: {{X2: {{length: 60, entry_speed: 40, ways: [{{over: [c], length: 180}}]}}}}\n"
ENDS = [TERMINUS, PLAIN, TRACKS, BERTHS, SPEEDS]
ENDS_CALLED = ["past a signal", "no signal", "two tracks", "berths", "two lengths"]


@pytest.mark.parametrize(
    ("text", "there", "back"),
    [
        (TERMINUS, ["X1-X2", "X2-X3", "X3-B"], ["Y3-Y4", "Y4-W"]),
        (PLAIN, ["X1-X2", "X2-B"], ["Y3-Y4", "Y4-W"]),
        (TRACKS, ["X1-X2", "X2-B1"], ["Y3-Y5", "Y5-W"]),
        (BERTHS, ["X1-X2", "X2-B1"], ["Y3-Y5", "Y5-W"]),
        (SPEEDS, ["X1-X2.o2", "X2-X3", "X3-B"], ["Y3-Y4", "Y4-W"]),
    ],
    ids=ENDS_CALLED,
)
def test_a_train_that_runs_on_to_the_end_of_its_track_within_the_overlap_comes_back(
    text: str, there: list[str], back: list[str]
) -> None:
    """The overlap of a signal that it has passed is given up when it stands wholly in the last section, which its own
    route keeps; and not before."""
    r = runtime(text)
    held = "V_X2_2" if there[0].endswith(".o2") else "V_X2_1"
    occupied(r, "wa")
    put(r, *there)
    assert r.out["YP_X2"] or r.out["YY_X2"]
    for here, ahead in pairwise(("wa", "a", "b", "c")):
        occupied(r, here, ahead)
        r.scan(400)
        assert r.controller.state[held], (here, ahead)
        occupied(r, ahead)
    assert not r.controller.state[held] and not r.out["YL_b"] and r.out["YL_c"]
    put(r, *back)
    assert r.out["YP_Y3"] or r.out["YY_Y3"]
    for here, ahead in pairwise(("c", "b", "a", "wa")):
        occupied(r, here, ahead)
        occupied(r, ahead)
    occupied(r)
    assert not any(r.out[f"YL_{s}"] for s in "abc")


@pytest.mark.parametrize("text", ENDS, ids=ENDS_CALLED)
def test_at_the_end_of_a_track_it_is_proved_and_asked_for_by_the_second_checker(text: str) -> None:
    found = grown(text)
    assert found is not None and not any(d.code == "IL7014" for d in found[2].diagnostics)
    controller = lower(found[0], found[1])
    system = System(found[0], controller)
    result = prove(system, Limits(search_s=0))
    assert result.proved and not result.dropped
    assert agree(*told(text), specification.shipped()).left == ()
    assert availability(system.loop, found[1]).shown


@pytest.mark.parametrize(
    ("text", "holds", "never"),
    [
        (PLAIN, ("over.X2.c", "L_c_2"), ("V_X2_1",)),
        (BERTHS, ("over.X2.c", "L_c_2"), ("V_X2_1",)),
        (BERTHS, ("over.X2.c", "shunts.b|c@P.normal.b"), ("V_X2_1",)),
    ],
    ids=["alone", "in a berth", "vehicles are shunted to it"],
)
def test_what_has_overrun_into_the_last_section_is_kept_by_the_lock_alone(
    text: str, holds: tuple[str, ...], never: tuple[str, ...]
) -> None:
    """A run of the world of the proof in which the overlap is given up under a train that has overrun the signal."""
    found = grown(text)
    assert found is not None
    system = System(found[0], lower(found[0], found[1]))
    there = conj((*(var(name) for name in holds), *(neg(var(name)) for name in never)))
    assert search(system, [Claim("scenario", "here", neg(there))], 20, 300) is not None


@pytest.mark.parametrize("seed", [1143, 1196])
def test_what_has_overrun_one_signal_has_overrun_no_other(seed: int) -> None:
    """Grown at random: the last section of one overlap lies on the way of another; no invariant is lost."""
    found = grown(grow_all(seed))
    assert found is not None
    result = prove(System(found[0], lower(found[0], found[1])), Limits(search_s=0))
    assert result.proved and not result.dropped
