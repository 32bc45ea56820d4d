"""Why a route that is set has its signal at stop, and why a section stays locked that is occupied: the runtime and the
panel say the same, and what is to be done."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest

from interlock.app.reasons import Moment
from interlock.field.plc import Memory
from interlock.logic.words import SET
from tests.test_left_behind import STATION
from tests.test_left_behind import Desk as _Desk

LOOP = Path("layouts/passing_loop.yaml").read_text("utf-8")
STOP = "set, its signal at stop: "
AGAIN = "it has closed once, and opens only when it is asked for again"


class Desk(_Desk):
    """With what is asked of a signal at stop."""

    def at_stop(self, route: str) -> list[str]:
        """What the panel says."""
        moment = Moment(self.runtime._last[2], Memory(*self.runtime._last[:2]), 1000)
        return [r.text for r in self.reasons.of_stop(self.number[route], moment)]

    def asks(self, route: str) -> None:
        """Asks for a route, and waits until its points lie."""
        self.scan(REQ=self.number[route])
        self.scan(REQ=0)
        self.scans(6)

    def says(self, route: str) -> tuple[str, str]:
        """The sentence of a signal at stop, and its rule; the panel says it too."""
        code, sentence, rule = self.runtime.why_not(route)
        assert code == SET and self.runtime.status(route) == (code, sentence) and sentence.startswith(STOP)
        told = sentence.removeprefix(STOP)
        panel = self.at_stop(route)
        assert all(any(x.startswith(part) for x in panel) for part in told.split("; "))
        assert self.runtime.countdown_ms(route) is None
        return told, rule


def loop(**read: int) -> Desk:
    desk = Desk(LOOP)
    desk.scan(**{"NN_W": 1, "LC_W": 1, "E_BF_E": 1} | read)
    desk.scans(3)
    return desk


def test_nobody_has_the_direction_after_a_restart() -> None:
    desk = loop()
    desk.asks("S1-W")
    by_hand = "after a restart agree with him, then special manual change (hold TKN_W)"
    assert desk.says("S1-W") == (
        f"the direction at W is not ours, and the neighbour does not have it: {by_hand}",
        "R12",
    )
    desk.scan(TKN_W=1)
    desk.scans(100)
    assert desk.runtime.status("S1-W")[1] == "open" and desk.runtime.why_not("S1-W") is None


def test_the_neighbour_has_the_direction() -> None:
    desk = loop(NH_W=1)
    desk.asks("S1-W")
    assert desk.says("S1-W") == ("the direction at W is not ours: the neighbour has it, wait until he gives it", "R12")


def test_the_line_beyond_is_occupied_and_then_it_is_asked_for_again() -> None:
    desk = loop(CLR_SJG=0)
    desk.asks("X1-E")
    assert desk.says("X1-E") == ("section SJG is occupied", "R3")
    desk.scan(CLR_SJG=1)
    desk.scans(8)
    assert desk.runtime.status("X1-E")[1] == "open", "it waited"
    desk.scan(E_BF_E=0)
    desk.scans(2)
    assert desk.says("X1-E") == (f"condition BF/E does not hold; {AGAIN}", "R12")
    desk.scan(E_BF_E=1)
    desk.scans(2)
    assert desk.says("X1-E") == (AGAIN, "R14")
    desk.asks("X1-E")
    assert desk.runtime.status("X1-E")[1] == "open"


def test_what_was_blocked_before_it_opened_is_asked_for_again() -> None:
    desk = loop(E_BF_E=0)
    desk.asks("X1-E")
    desk.scan(BLK_IIAG=1)
    assert desk.says("X1-E")[0].startswith("section IIAG is blocked")
    desk.scan(BLK_IIAG=0)
    desk.scan(E_BF_E=1)
    desk.scans(2)
    hindered = "its way was blocked, or a point in it trailed: it opens only when it is asked for again"
    assert desk.says("X1-E") == (hindered, "R14")


def test_inputs_were_lost_while_it_was_set() -> None:
    desk = loop()
    desk.asks("X-X1")
    assert desk.runtime.status("X-X1")[1] == "open"
    desk.scan(VALID=0)
    assert desk.says("X-X1")[0].startswith("inputs are not valid: a substation is lost")
    desk.scan(VALID=1)
    desk.scans(8)
    lost = ("inputs were lost while it was set: cancel it, and set it again", "R16")
    assert desk.says("X-X1") == lost and desk.at_stop("X-X1") == [lost[0]]
    desk.asks("X-X1")
    assert desk.says("X-X1") == lost, "asked for again it stays"
    desk.scan(CAN_X=1)
    desk.scan(CAN_X=0)
    desk.scans(200)
    desk.asks("X-X1")
    assert desk.runtime.status("X-X1")[1] == "open"


def test_a_call_on_serves_one_train_and_then_says_that_the_section_is_occupied() -> None:
    """R2: what is reported occupied is not released; it is, in order, when it reads clear again."""
    desk = loop(CLR_1DG=0)
    desk.asks("X-X1.c")
    assert desk.runtime.status("X-X1.c")[1] == "open"
    desk.runs("IAG")
    desk.scan(CLR_IG=0)
    desk.scan(CLR_IAG=1)
    desk.scan(CAN_X=1)
    desk.scan(CAN_X=0)
    desk.scans(200)
    desk.asks("X1-E")
    desk.scan(CLR_2DG=0)
    desk.scan(CLR_IG=1)
    desk.runs("2DG", "IIAG")
    desk.scan(CLR_IIAG=1)
    desk.scans(200)
    occupied = "section 1DG is occupied (by a train, or its detector is out of order)"
    said = f"{occupied}, and stays locked until it has been clear"
    for hand in ("REL_1DG", "RELALL", "CAN_X"):
        desk.scan(**{hand: 1})
        desk.scans(9)
        desk.scan(**{hand: 0})
        for route in ("X-X1.c", "X-X3.c", "X-X1"):
            assert desk.runtime.why_not(route)[1] == said, (hand, route)
            assert desk.told(route)[0] == said
    desk.scan(CLR_1DG=1)
    desk.scans(9)
    assert desk.runtime.why_not("X-X1") is None


def test_while_a_route_is_set_over_it_its_lock_is_told() -> None:
    desk = Desk(STATION)
    desk.scan(CLR_q1=0)
    desk.set("X2-X3")
    desk.scan(CLR_q3=0)
    assert desk.runtime.why_not("X2-X4")[1] == "section q2 is locked from q1 to q3 for route X2-X3"


def test_what_stands_on_points_at_a_restart_is_moved_under_local_rules() -> None:
    desk = loop()
    desk.runtime = desk.runtime.__class__()
    desk.scan(CLR_2DG=0, CLR_IG=0)
    desk.scans(700)
    desk.scan(RELALL=1)
    desk.scan(RELALL=0)
    there = "it is occupied and has points: move what stands there under local rules, then release it"
    said = f"section 2DG is not released since the restart: {there}"
    assert desk.runtime.why_not("X1-E")[1:] == (said, "R16") and desk.told("X1-E")[0] == said
    plain = desk.runtime.why_not("X-X1")[1]
    assert plain == "section IG is not released since the restart", "from there a train is called"
    desk.scan(CLR_2DG=1)
    assert desk.runtime.why_not("X1-E")[1] == "section 2DG is not released since the restart"


@pytest.mark.parametrize("name", ("passing_loop", "pit_bottom", "flank_lab"))
def test_whatever_happens_runtime_and_panel_say_the_same(name: str) -> None:
    """Inputs come and go by chance: what the runtime tells of a signal at stop, the panel tells, too."""
    desk, chance, told = Desk(Path(f"layouts/{name}.yaml").read_text("utf-8")), Random(5), set()
    base = {n: 1 for n in desk.inputs if n.startswith(("E_", "RL_", "GL_", "UL_", "SH_", "CL_", "VL_"))}
    desk.scan(**base)
    desk.scan(RELALL=1)
    desk.scan(RELALL=0)
    told_off = [n for n in desk.inputs if n.startswith(("CLR_", "BLK_", "E_", "RL_", "GL_", "VALID"))]
    for _ in range(150):
        route = chance.choice(list(desk.number))
        desk.scan(REQ=desk.number[route])
        desk.scan(REQ=0)
        name_, scans = chance.choice(told_off), chance.randrange(1, 5)
        rest = desk.inputs[name_]
        desk.scan(**{name_: 1 - rest})
        for _ in range(scans):
            desk.scan()
            for r, n in desk.number.items():
                why = desk.runtime.why_not(r)
                if why is not None and why[0] == SET:
                    parts = why[1].removeprefix(STOP).split("; ")
                    panel = "; ".join(desk.at_stop(r))
                    assert parts[0] in panel or desk.runtime._last[2]["VALID"] == 0, (r, n, why, panel)
                    told.add(why[1])
        desk.scan(**{name_: rest})
        for g in [n for n in desk.inputs if n.startswith("CAN_") and chance.random() < 0.2]:
            desk.scan(**{g: 1})
            desk.scan(**{g: 0})
        if chance.random() < 0.3:
            desk.scan(RELALL=1)
            desk.scans(3)
            desk.scan(RELALL=0)
    assert len(told) >= 4, told


RELEASE_POINTS = """interlock: 1
name: release_points
boundaries: {W: {approach: wa 800}}
buffers: [BB]
tracks: {w: [W, w1 300], g: [g1 150], h: [h1 150], n: [nb 80, BB]}
points:
  P1: {section: T1, toe: w.end, normal: g.start, reverse: h.start}
  P2: {section: T2, toe: n.start, normal: g.end, reverse: h.end}
signals:
  X0: {from: W, into: w1}
  X1: {from: w1, into: T1, kind: combined}
  N: {from: nb, into: T2, kind: shunt}
  H1: {from: h1, into: T1, kind: shunt}
  H2: {from: h1, into: T2, kind: shunt}
  G1: {from: g1, into: T1, kind: combined}
"""


def test_points_behind_which_an_engine_has_left_its_coaches_say_what_they_wait_for() -> None:
    """Sections are released in order: nothing but the coaches' way out of g1 lets go of T2, and no operator's input."""
    desk = Desk(RELEASE_POINTS)
    desk.scan(CLR_w1=0)
    desk.set("X1-BB")
    for read in ({"CLR_T1": 0}, {"CLR_g1": 0}, {"CLR_T1": 1}, {"CLR_w1": 1}):
        desk.scan(**read)
    desk.scans(9)
    on_its_way = desk.runtime.why_not("N-H1")[1]
    assert on_its_way == "section T2 is locked from g1 to nb for route X1-BB or X1-BB.s", "the train is still to come"
    for read in ({"CLR_T2": 0}, {"CLR_nb": 0}, {"CLR_T2": 1}):
        desk.scan(**read)
    left = "that is occupied (by what was left there, or its detector is out of order)"
    away = "take away what stands there, or move over T2 under local rules"
    said = f"section T2 stays locked until section g1 in rear has been clear: {left}; {away}"
    for hand in ("REL_T2", "REL_g1", "CAN_X1", "RELALL"):
        desk.scan(**{hand: 1})
        desk.scans(300)
        desk.scan(**{hand: 0})
        assert desk.runtime.why_not("N-H1")[1] == said and desk.told("N-H1")[0] == said, hand
    desk.set("G1-W")
    for read in ({"CLR_T1": 0}, {"CLR_g1": 1}, {"CLR_w1": 0}, {"CLR_T1": 1}, {"CLR_w1": 1}):
        desk.scan(**read)
    desk.scans(300)
    assert desk.runtime.why_not("N-H1") is None


def test_with_a_signal_before_the_release_points_the_engine_runs_round_its_coaches() -> None:
    desk = Desk(f"{RELEASE_POINTS}  S: {{from: g1, into: T2, kind: combined}}\n")
    desk.scan(CLR_w1=0)
    desk.set("X1-S")
    for read in ({"CLR_T1": 0}, {"CLR_g1": 0}, {"CLR_T1": 1}, {"CLR_w1": 1}):
        desk.scan(**read)
    desk.scans(9)
    desk.set("S-BB.s")
    for read in ({"CLR_T2": 0}, {"CLR_nb": 0}, {"CLR_T2": 1}):
        desk.scan(**read)
    desk.scans(300)
    desk.set("N-H1")
