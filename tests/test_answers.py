"""What `interlock run` says of requests, on the simulated railway: refused, or set and at stop, and why."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from interlock.app.answers import Answers
from interlock.app.reasons import Moment, Reasons
from interlock.app.run import BadCommand, Operator, Ready, prepare
from interlock.cli.run import _text
from interlock.field.plc import Cycle, SoftPlc, runtime_scan
from interlock.panel.simulated import SimulatedField

STEP_MS = 200


@pytest.fixture(scope="module")
def loop() -> Ready:
    """A passing loop whose line towards W is worked with a direction token."""
    found = prepare("layouts/passing_loop.yaml")
    assert found.proved.green
    return found


class Desk:
    """Somebody types commands, and reads what is said."""

    def __init__(self, ready: Ready) -> None:
        assert ready.layout is not None and ready.controller is not None and ready.allocation is not None
        inputs = {str(i.name): (i.restrictive, i.size) for i in ready.controller.inputs}
        runtime = runtime_scan(ready.runtime)
        self.field = SimulatedField(ready.layout, ready.allocation, inputs, runtime.restrictive, STEP_MS / 1000)
        self.plc = SoftPlc(runtime, ready.allocation, self.field.links, ready.controller.symbols.valid)
        self.operator, self.answers = Operator(ready), Answers(ready)
        self.last: Cycle | None = None

    def cycles(self, count: int) -> list[dict[str, Any]]:
        """So many cycles, and what is said in them."""
        said: list[dict[str, Any]] = []
        for _ in range(count):
            written = self.operator.inputs(self.last, STEP_MS)
            self.field.step(STEP_MS / 1000, written)
            self.last = self.plc.cycle(written, STEP_MS)
            said += self.answers.after(self.last, STEP_MS)
        return said

    def type(self, line: str) -> list[dict[str, Any]]:
        """A line is typed; what is said in a minute after it."""
        self.operator.type(line)
        return self.cycles(60_000 // STEP_MS)


def test_a_route_that_is_set_says_what_its_signal_waits_for(loop: Ready) -> None:
    desk = Desk(loop)
    assert loop.layout is not None
    desk.cycles(round(loop.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    assert desk.type("release") == []
    nobody = "the direction at W is not ours, and the neighbour does not have it: after a restart agree with him, then"
    waits = {"route": "S1-W", "at_stop": [f"{nobody} special manual change (hold TKN_W)"]}
    assert desk.type("set S1-W") == [waits], "said once"
    assert desk.type("set S1-W") == [waits], "and when it is asked for again"
    (no,) = desk.type("set S3-W")
    assert no["route"] == "S3-W" and no["refused"].endswith("for route S1-W") and no["rule"] == "R6"
    assert desk.type("set S-S3") == [], "its signal opens: nothing is to be said"


def test_it_is_said_for_people() -> None:
    assert _text({"route": "A-E", "automatic": False}) == "  route A-E no longer works automatically"
    stop = {"route": "S1-W", "at_stop": ["the direction at W is not ours", "section 1DG is occupied"]}
    told = "  route S1-W is set, its signal at stop: the direction at W is not ours; section 1DG is occupied"
    assert _text(stop) == told


def test_stop_cancels_every_route(loop: Ready) -> None:
    desk = Desk(loop)
    assert loop.layout is not None
    desk.cycles(round(loop.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    desk.type("release")
    desk.type("set S-S3")
    assert desk.last is not None and not desk.last.outputs["YS_S"]
    desk.type("stop")
    assert desk.last.outputs["YS_S"] and not any(v for n, v in desk.last.memory.state.items() if n.startswith("A_R"))
    with pytest.raises(BadCommand, match="stop, release"):
        desk.type("stop S")


AUTOMATIC = """
interlock: 1
name: automatic
boundaries: {W: {approach: wa 600}, E: {approach: ea 600, trains: out}}
tracks: {line: [W, q1 300, q2 300, E]}
signals: {A: {from: W, into: q1}}
automatic: [{from: A, to: E}]
"""


def test_stop_and_cancel_switch_automatic_working_off(tmp_path: Path) -> None:
    """It would set its route again as soon as that is cancelled."""
    (tmp_path / "automatic.yaml").write_text(AUTOMATIC, "utf-8")
    ready = prepare(str(tmp_path / "automatic.yaml"))
    assert ready.proved.green and ready.layout is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    desk.type("release")
    desk.type("AUTO_R1=1")
    assert desk.last is not None and not desk.last.outputs["YS_A"]
    assert desk.operator.type("stop") == ("A-E",)
    desk.cycles(300)
    assert desk.last.outputs["YS_A"] and desk.operator.held == {}
    desk.type("AUTO_R1=1")
    assert not desk.last.outputs["YS_A"]
    assert desk.operator.type("cancel A") == ("A-E",), "it would be set again in the next scan"
    desk.cycles(300)
    assert desk.last.outputs["YS_A"] and desk.operator.held == {}
    assert desk.operator.type("cancel A") == ()


TWO = """
interlock: 1
name: two
boundaries: {W: {approach: wa 600}, E: {approach: ea 600, trains: out}}
tracks: {line: [W, q1 300, q2 300, q3 400, E]}
signals: {A: {from: W, into: q1}, X: {from: q2, into: q3}}
"""


def test_a_signal_that_has_closed_opens_only_when_it_is_asked_for_while_everything_is_in_order(tmp_path: Path) -> None:
    """Asked for while its section is blocked, it is not to open by itself when the block is taken off, hours later."""
    (tmp_path / "two.yaml").write_text(TWO, "utf-8")
    ready = prepare(str(tmp_path / "two.yaml"))
    assert ready.proved.green and ready.layout is not None and ready.controller is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)

    def is_open() -> bool:
        assert desk.last is not None
        return desk.last.outputs["YP_X"]

    desk.type("release")
    assert desk.type("set X-E") == [] and is_open()
    blocked, closed = "section q3 is blocked", "it has closed once, and opens only when it is asked for again"
    assert desk.type("BLK_q3=1") == [{"route": "X-E", "at_stop": [blocked, closed]}]
    assert desk.type("set X-E") == [{"route": "X-E", "at_stop": [blocked, closed]}] and not is_open()
    desk.type("BLK_q3=0")
    assert not is_open(), "what was asked for while the section was blocked has come to nothing"
    desk.type("set X-E")
    assert is_open()


def test_an_overlap_that_does_not_swing_is_told() -> None:
    ready = prepare("tests/layouts_for_tests/swing.yaml")
    assert ready.proved.green and ready.layout is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    desk.type("release")
    (no,) = desk.type("swing X3")
    assert no["swing"] == "X3" and no["refused"] == "no overlap of X3 is held: there is nothing to swing"
    assert desk.type("set X2-X3") == []
    (stop,) = desk.type("swing X3")
    at_stop = [f"the overlap of X3: {p} is not detected reverse" for p in ("P2", "P3")]
    assert stop["route"] == "X2-X3" and stop["at_stop"][:2] == at_stop, "it swings"
    assert desk.type("set X2-X3") == [], "and the signal opens again"


def test_what_is_held_longer_says_for_how_long() -> None:
    """While the train comes in nobody knows how long it takes; from then on it is 30 s."""
    ready = prepare("tests/layouts_for_tests/held_longer.yaml")
    assert ready.proved.green and ready.layout is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    desk.type("release")
    assert desk.type("set A-N") == []
    desk.field.stock.bring("W", 80, "T")
    route, told = "route A-N, which demands 2 normal (overrun; held 30 s longer)", list[str]()
    held = f"points 2 cannot move: {route}, is set or not yet cleared"
    for _ in range(60):
        desk.operator.type("set Y-E")
        told += [x["refused"] for x in desk.cycles(5_000 // STEP_MS) if x.get("route") == "Y-E" and "refused" in x]
    to_go = [x for x in told if x.startswith(held)]
    assert to_go[0] == held, told
    left = [int(x.removeprefix(f"{held}: ").removesuffix(" s to go")) for x in to_go if x != held]
    assert len(left) > 4 and left[0] > 24 and all(b == a - 5 for a, b in pairwise(left)), told


def test_a_route_whose_way_past_a_signal_was_cancelled_says_what_to_do() -> None:
    """It cannot open again; cancelled and set again, as it says, it does."""
    ready = prepare("tests/layouts_for_tests/identifier.yaml")
    assert ready.proved.green and ready.layout is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    desk.type("release")
    assert desk.type("set X-Y-Z") == []
    waits = {"route": "X-Y-Z", "at_stop": ["what lies past Y is no longer set: cancel X, then set X-Y-Z again"]}
    assert desk.type("cancel Y") == [waits]
    assert desk.type("set X-Y-Z") == [waits]
    assert desk.type("cancel X") == []
    assert desk.type("set X-Y-Z") == []
    assert desk.last is not None and desk.last.outputs["YI_Y"]


def test_a_train_on_its_way_past_a_signal_whose_identifier_light_goes_out() -> None:
    """Nobody can ask for its route again: it stops at the signal, and goes on with a route from there."""
    ready = prepare("tests/layouts_for_tests/identifier.yaml")
    assert ready.proved.green and ready.layout is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    desk.type("release")
    assert desk.type("set X-Y-Z") == []
    desk.field.stock.bring("W", 80, "T")
    desk.operator.type("set A-X")
    assert any(desk.cycles(1) == [] and desk.last and not desk.last.inputs["CLR_T1"] for _ in range(500))
    desk.field.faults.fail("lamp", "NL_Y", True)
    says = [
        "the identifier lamp of Y is out",
        "its train has passed the signal before Y: cancel Y, then set a route from Y",
    ]
    assert desk.cycles(300) == [{"route": "Y-Z.i", "at_stop": says}]
    desk.type("cancel Y")
    desk.cycles(5 * 200)
    desk.operator.type("set Y-Z")
    assert desk.cycles(100) == [] and desk.last is not None
    assert not desk.last.inputs["CLR_p2"], "the train goes on"


CROSSOVER = """
interlock: 1
name: crossover
principles: {line_speed_kmh: 40}
boundaries:
  A1: {approach: u1 300}
  A2: {approach: u2 300}
  B1: {trains: out}
  B2: {trains: out}
tracks:
  north: [n2 200, B1]
  south: [s2 200, B2]
points:
  1: {section: x1, machine: "1/2", toe: A1, normal: north.start, reverse: 2.reverse, legs: 30}
  2: {section: x2, machine: "1/2", toe: south.start, normal: A2, legs: 30}
signals:
  XA1: {from: A1, into: x1}
  XA2: {from: A2, into: x2}
"""


def test_a_point_of_a_blocked_section_moves_by_hand_and_for_no_route(tmp_path: Path) -> None:
    """A crossover with one machine, its far end in a blocked section: a route on the other track does not throw it."""
    (tmp_path / "crossover.yaml").write_text(CROSSOVER, "utf-8")
    ready = prepare(str(tmp_path / "crossover.yaml"))
    assert ready.proved.green and ready.layout is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)

    def driven() -> list[str]:
        assert desk.last is not None
        return [x for x in "NR" if desk.last.outputs[f"Y{x}_1_2"]]

    desk.type("release")
    desk.type("MR_1_2=1")
    desk.type("MR_1_2=0")
    assert driven() == ["R"]
    desk.type("BLK_x2=1")
    assert driven() == []
    (no,) = desk.type("set XA1-B1")
    assert no == {"route": "XA1-B1", "refused": "points 1/2 cannot move: section x2 is blocked", "rule": "R10"}
    assert driven() == []
    desk.type("MN_1_2=1")
    assert desk.last is not None and desk.last.inputs["DN_1_2"], "those who work there may have it moved"
    assert driven() == [], "as long as they order it"
    assert desk.type("set XA1-B1") == [] and desk.last is not None
    assert not desk.last.outputs["YS_XA1"], "where it lies it is used"


def test_a_drive_that_has_not_started_says_what_it_waits_for(tmp_path: Path) -> None:
    """Two machines that start one after the other; before the turn of the second its section is occupied."""
    text = CROSSOVER.replace("kmh: 40", "kmh: 40, point_start_gap_s: 4").replace('machine: "1/2", ', "")
    (tmp_path / "apart.yaml").write_text(text, "utf-8")
    ready = prepare(str(tmp_path / "apart.yaml"))
    assert ready.proved.green and ready.layout is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    desk.type("release")
    assert ready.controller is not None
    reasons = Reasons(ready.layout, ready.controller)
    number = next(r.number for r in ready.controller.symbols.routes if str(r.id) == "XA1-B2")

    def waits() -> list[str]:
        assert desk.last is not None
        return [reason.text for reason in reasons.of_stop(number, Moment(desk.last.inputs, desk.last.memory, STEP_MS))]

    desk.operator.type("set XA1-B2")
    desk.cycles(10)
    assert waits()[-1] == "the drive of 2 waits for its turn to start"
    desk.field.faults.fail("section", "x2", True)
    desk.cycles(50)
    assert waits()[-1] == "the drive of 2 has not started: section x2 is occupied"
    desk.field.faults.fail("section", "x2", False)
    desk.cycles(100)
    assert desk.last is not None and not desk.last.outputs["YS_XA1"]


def test_a_blocked_overlap_is_the_reason_not_that_it_is_held() -> None:
    ready = prepare("tests/layouts_for_tests/swing.yaml")
    assert ready.proved.green and ready.layout is not None
    desk = Desk(ready)
    desk.cycles(round(ready.layout.principles.restart_delay_s * 1000 / STEP_MS) + 50)
    desk.type("release")
    assert desk.type("set X2-X3") == []
    (waits,) = desk.type("BLK_q4=1")
    assert waits["at_stop"][0] == "section q4 is blocked"
