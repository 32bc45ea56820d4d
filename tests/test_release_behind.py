"""The first section behind a signal is released behind a train that has come in wholly, and nothing else (R9)."""

from __future__ import annotations

from typing import Any

import pytest

from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.mutation import forgotten
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.layouts import built

SCAN_MS = 200
X3_D, X3_X5 = "X3-D", "X3-X5"


class Bench:
    """An emitted runtime after its restart: all is clear, every lamp whole, every machine normal, nothing is asked."""

    def __init__(self, controller: Controller) -> None:
        space: dict[str, Any] = {}
        exec(runtime_py(controller, []), space)
        self.routes, self.controller = space["ROUTES"], space["Controller"]()
        on = ("VALID", "CLR_", "SH_", "DN_", "RL_", "GL_", "CL_", "UL_")
        self.inputs = {x.name: int(x.name.startswith(on)) for x in controller.inputs}
        self.outputs: dict[str, int] = {}
        self.go(605)
        self.go(4, RELALL=1)
        self.go(1, RELALL=0)

    def go(self, seconds: float, **inputs: int) -> None:
        """Scans for so long, with these inputs from now on."""
        self.inputs |= inputs
        for _ in range(round(seconds * 1000 / SCAN_MS)):
            self.outputs = self.controller.scan(dict(self.inputs), SCAN_MS)

    def ask(self, route: str) -> None:
        self.go(0.4, REQ=self.routes[route])
        self.go(5, REQ=0)

    def seconds_until_free(self, most: float, section: str = "III") -> float:
        """How long a section stays locked from now on."""
        for n in range(round(most * 1000 / SCAN_MS)):
            if not self.outputs[f"YL_{section}"]:
                return n * SCAN_MS / 1000
            self.go(SCAN_MS / 1000)
        return most


def before_the_open_signal() -> Bench:
    """`fig2_3_split`: from SB the signal X3 leads over III and its point P1 to IV or SC.  A train has come before X3,
    which is open."""
    b = Bench(built("fig2_3_split")[2])
    b.ask(X3_X5)
    assert b.outputs["YP_X3"] and b.outputs["YL_III"]
    b.go(10, CLR_SB=0)
    assert b.outputs["YP_X3"]
    return b


@pytest.mark.parametrize("lasts", [0.4, 2.0, 20.0])
def test_a_joint_that_fails_before_a_train_releases_nothing_until_it_must_stand(lasts: float) -> None:
    """Both sections beside a failed joint, or a failed counting head, read occupied from the same scan, as if a train
    had run over them; the train whose signal falls is still on its way.  III was unlocked after 5 s, and its point
    driven."""
    b = before_the_open_signal()
    b.go(lasts, CLR_III=0, CLR_IV=0)
    b.go(50 - lasts, CLR_III=1, CLR_IV=1)
    assert b.outputs["YL_III"] and not b.outputs["YP_X3"]
    b.ask(X3_D)
    assert not b.outputs["YR_P1"]
    b.go(15)
    assert not b.outputs["YL_III"], "the delay of approach locking is over"


def test_behind_a_train_it_is_released_as_soon_as_it_is_clear() -> None:
    b = before_the_open_signal()
    b.go(2, CLR_III=0)
    b.go(2, CLR_IV=0)
    b.go(2, CLR_SB=1)
    b.go(0.2, CLR_III=1)
    assert b.seconds_until_free(60) <= 3.6, "the release delay"


def test_a_following_train_holds_it_no_longer() -> None:
    """What was in rear has been seen clear; that the next train stands there already does not matter."""
    b = before_the_open_signal()
    b.go(2, CLR_III=0)
    b.go(2, CLR_IV=0)
    b.go(5, CLR_SB=1)
    b.go(2, CLR_SB=0)
    b.go(0.2, CLR_III=1)
    assert b.seconds_until_free(60) <= 3.6


def test_where_wagons_stay_behind_it_is_held_for_the_delay_of_approach_locking() -> None:
    """Nobody can tell them from a train that is still to come."""
    b = before_the_open_signal()
    b.go(2, CLR_III=0)
    b.go(2, CLR_IV=0)
    b.go(0.2, CLR_III=1)
    assert 55 <= b.seconds_until_free(120) <= 64


def two_before() -> Bench:
    """Before X2 lie q2, of 100 m, and q1: less than the braking distance, so that a train in q1 that X1 has called is
    about to pass X2.  One is there, and both signals are open."""
    b = Bench(built("../tests/layouts_for_tests/two_before")[2])
    b.ask("X2-X3")
    b.ask("X1-X2")
    assert not b.outputs["YS_X2"] and not b.outputs["YS_X1"]
    b.go(5, CLR_wa=0)
    b.go(5, CLR_q1=0)
    b.go(5, CLR_wa=1)
    assert not b.outputs["YS_X2"] and b.outputs["YL_q3"]
    return b


@pytest.mark.parametrize("lasts", [0.4, 2.0, 20.0])
def test_a_card_that_fails_before_a_train_further_away_releases_nothing_until_it_must_stand(lasts: float) -> None:
    """A card reports the section before the signal, the one behind it and the next occupied, and all clear again: as if
    a train had run over them.  The one that is called to X2 is still in q1, and X2 has fallen in its face.  That the
    section before the signal alone was seen clear since released q3 after 3 s."""
    b = two_before()
    b.go(lasts, CLR_q2=0, CLR_q3=0, CLR_q4=0)
    b.go(20, CLR_q2=1, CLR_q3=1, CLR_q4=1)
    assert b.outputs["YL_q3"] and b.outputs["YS_X2"]
    b.ask("Y4-W")
    assert not b.outputs["YR_P1"]


def test_behind_a_train_the_next_one_that_is_called_later_holds_nothing() -> None:
    """As soon as it has come in the approach is seen clear, since what lies before is not locked any more."""
    b = two_before()
    for section in ("q2", "q3", "q4"):
        b.go(2, **{f"CLR_{section}": 0})
    b.go(2, CLR_q1=1)
    b.go(5, CLR_q2=1)
    b.go(2, CLR_wa=0)
    b.ask("X1-X2")
    assert not b.outputs["YS_X1"]
    b.go(5, CLR_q1=0)
    b.go(0.2, CLR_q3=1)
    assert b.seconds_until_free(60, "q3") <= 3.6


def berth_before() -> Bench:
    """As `two_before`, but X2 leads straight into the station track q4, to which vehicles are shunted from S5."""
    b = Bench(built("../tests/layouts_for_tests/berth_before")[2])
    b.ask("X2-X3")
    b.ask("X1-X2")
    b.go(5, CLR_wa=0)
    b.go(5, CLR_q1=0)
    b.go(5, CLR_wa=1)
    assert not b.outputs["YS_X2"]
    return b


def test_a_joint_that_fails_lets_nobody_shunt_into_the_track_of_a_train_that_is_still_coming() -> None:
    """The joint at X2 fails and is whole again: as if the train had come from q2 into q4.  It is in q1, its signal has
    fallen in its face.  It counted as arrived, and vehicles were shunted towards it."""
    b = berth_before()
    b.go(2, CLR_q2=0, CLR_q4=0)
    b.go(20, CLR_q2=1, CLR_q4=1)
    b.ask("S5-Y3")
    said = "section q4 is locked for a train, until it stands: 60 s after it has come in wholly"
    assert b.controller.why_not("S5-Y3")[1] == said
    b.go(200)
    assert b.controller.why_not("S5-Y3")[1] == said, "nothing has come in"
    b.go(5, DN_P2=0, DR_P2=1)
    assert not b.outputs["YW_S5"]


def test_vehicles_are_shunted_to_a_train_that_has_arrived() -> None:
    b = berth_before()
    b.go(5, CLR_q2=0)
    b.go(5, CLR_q1=1)
    b.go(5, CLR_q4=0)
    b.go(5, CLR_q2=1)
    b.ask("S5-Y3")
    assert not b.outputs["YW_S5"], "it may still run to X3, towards them"
    b.go(60)
    b.ask("S5-Y3")
    b.go(5, DN_P2=0, DR_P2=1)
    assert b.outputs["YW_S5"]


def before_the_white_light() -> Bench:
    """`shunt_yard`: S1 shows white, and vehicles stand before it in g1, which they will partly stay in."""
    b = Bench(built("../tests/layouts_for_tests/shunt_yard")[2])
    b.go(5, CLR_g1=0)
    b.ask("S1-D3.s")
    assert b.outputs["YW_S1"] and b.outputs["YL_p1"]
    return b


@pytest.mark.parametrize("apart", [0, 0.2, 0.4])
def test_a_joint_that_fails_before_a_shunting_movement_releases_nothing_until_it_must_stand(apart: float) -> None:
    """The joint between p1 and l2 fails, and the two detectors tell it up to `detection_delay_s` apart.  Who has seen
    the white light is on his way; P1 was thrown under him after 4 s."""
    b = before_the_white_light()
    b.go(apart, CLR_p1=0)
    b.go(1, CLR_p1=0, CLR_l2=0)
    b.go(20, CLR_p1=1, CLR_l2=1)
    assert b.outputs["YL_p1"] and not b.outputs["YW_S1"]
    b.ask("D2-E2")
    assert not b.outputs["YR_P1"]
    b.go(200)
    assert not b.outputs["YL_p1"], "the delay of approach locking is over"


@pytest.mark.parametrize(("first", "second"), [("l2", "p1"), ("p1", "l2")])
@pytest.mark.parametrize("apart", [0.2, 1, 3])
def test_a_joint_that_recovers_on_one_side_first_shows_no_movement(first: str, second: str, apart: float) -> None:
    """It failed at once on both sides, as if the movement had come into both.  That p1 alone is occupied afterwards
    tells nothing: what is alone must be so before it is read in the next section."""
    b = before_the_white_light()
    b.go(2, CLR_p1=0, CLR_l2=0)
    b.go(apart, **{f"CLR_{first}": 1})
    b.go(20, **{f"CLR_{second}": 1})
    assert b.outputs["YL_p1"] and not b.outputs["YW_S1"]
    b.ask("D2-E2")
    assert not b.outputs["YR_P1"]


@pytest.mark.parametrize("both", [0.2, 0.4, 2.0])
@pytest.mark.parametrize("apart", [1.0, 10.0])
def test_a_joint_that_bounces_shows_no_movement(both: float, apart: float) -> None:
    """It failed at once on both sides, be it for a single scan; on the far side it was whole again for a while, and
    failed once more.  What is read occupied at once with what is ahead of it is never taken for a movement that was
    alone in it."""
    b = before_the_white_light()
    b.go(both, CLR_p1=0, CLR_l2=0)
    b.go(apart, CLR_l2=1)
    b.go(2, CLR_l2=0)
    b.go(20, CLR_p1=1)
    assert b.outputs["YL_p1"] and not b.outputs["YW_S1"]
    b.go(0.2, CLR_l2=1)
    b.ask("D2-E2")
    assert not b.outputs["YR_P1"]


@pytest.mark.parametrize("both", [0.2, 2.0])
def test_a_joint_that_fails_twice_shows_no_movement(both: float) -> None:
    """It is whole again on both sides before it fails once more."""
    b = before_the_white_light()
    b.go(both, CLR_p1=0, CLR_l2=0)
    b.go(10, CLR_l2=1)
    b.go(2, CLR_p1=1)
    b.go(2, CLR_p1=0, CLR_l2=0)
    b.go(20, CLR_p1=1, CLR_l2=1)
    assert b.outputs["YL_p1"] and not b.outputs["YW_S1"]


def test_the_delay_counts_from_when_the_signal_has_closed() -> None:
    """A train follows so closely that nobody sees the approach clear.  What the first one leaves is free when stop has
    stood for the delay of approach locking, not that long after it was left."""
    b = before_the_open_signal()
    b.go(3, CLR_SB=0)
    b.go(20, CLR_III=0)
    b.go(20, CLR_IV=0)
    b.go(0.2, CLR_III=1)
    assert 19 <= b.seconds_until_free(300) <= 21, "60 s, of which 40 are over"


def test_after_a_flicker_the_section_can_be_released_by_hand_when_the_delay_is_over() -> None:
    """A train stands before the signal, and the section behind it reads occupied for a moment: as if it had come in and
    gone back.  One press is enough; nobody has to keep pressing for as long as the delay."""
    b = before_the_open_signal()
    b.go(3, CLR_SB=0)
    b.go(0.6, CLR_III=0)
    b.go(5, CLR_III=1)
    assert not b.outputs["YP_X3"] and b.outputs["YL_III"]
    b.go(1, REL_III=1)
    b.go(20, REL_III=0)
    assert b.outputs["YL_III"], "whoever has seen the signal may still come"
    b.go(200)
    assert b.outputs["YL_III"], "not by itself"
    b.go(1, REL_III=1)
    b.go(1, REL_III=0)
    assert not b.outputs["YL_III"]


def test_behind_a_shunting_movement_that_leaves_wagons_it_is_released_as_soon_as_it_is_clear() -> None:
    """It was in p1 alone before it came into l2."""
    b = before_the_white_light()
    b.go(1.2, CLR_p1=0)
    b.go(3, CLR_l2=0)
    b.go(0.2, CLR_p1=1)
    assert not b.inputs["CLR_g1"] and b.seconds_until_free(60, "p1") <= 3.6, "the release delay"


@pytest.mark.parametrize("apart", [0, 0.2, 0.4])
def test_a_joint_that_fails_before_a_train_that_nobody_sees_releases_nothing_until_it_must_stand(apart: float) -> None:
    """From W trains come unseen.  The joint between q1 and q2 fails, and the two detectors tell it apart."""
    b = Bench(built("../tests/layouts_for_tests/unseen_before")[2])
    b.ask("X1-X2")
    assert not b.outputs["YS_X1"]
    b.go(apart, CLR_q1=0)
    b.go(1, CLR_q1=0, CLR_q2=0)
    b.go(20, CLR_q1=1, CLR_q2=1)
    assert b.outputs["YL_q1"] and b.outputs["YS_X1"]
    b.go(200)
    assert not b.outputs["YL_q1"]


def test_behind_a_train_from_where_nobody_sees_it_is_released_as_soon_as_it_is_clear() -> None:
    b = Bench(built("../tests/layouts_for_tests/unseen_before")[2])
    b.ask("X1-X2")
    b.go(3, CLR_q1=0)
    b.go(3, CLR_q2=0)
    b.go(0.2, CLR_q1=1)
    assert b.seconds_until_free(60, "q1") <= 3.6


@pytest.mark.parametrize("name", ["fig2_3_split", "junction"])
def test_a_controller_that_does_not_ask_for_the_rear_is_refuted(name: str) -> None:
    layout, table, _ = built(name)

    for _, wrong in forgotten.rear_not_asked(layout, table):
        found = prove(System(layout, wrong), Limits(search_depth=0))
        assert "L-APPROACH" in {c.id for c in found.claims if c.verdict is not Verdict.PROVED}


def test_a_controller_that_asks_for_the_section_in_rear_alone_is_refuted() -> None:
    layout, table, _ = built("../tests/layouts_for_tests/two_before")
    wrong = dict(forgotten.rear_alone(layout, table))
    assert "q3" in wrong
    found = prove(System(layout, wrong["q3"]), Limits(search_depth=0))
    assert {c.id for c in found.claims if c.verdict is not Verdict.PROVED} == {"L-REASON"}
