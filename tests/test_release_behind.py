"""The first section behind a signal is released behind a train that has come in wholly, and nothing else (R9)."""

from __future__ import annotations

from typing import Any

import pytest

from interlock.emit.python.runtime import runtime_py
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.mutation import forgotten
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.layouts import built

SCAN_MS = 200
X3_D, X3_X5 = "X3-D", "X3-X5"


class Bench:
    """The emitted runtime of `fig2_3_split`: from SB the signal X3 leads over III and its point P1 to IV or SC."""

    def __init__(self) -> None:
        space: dict[str, Any] = {}
        exec(runtime_py(built("fig2_3_split")[2], []), space)
        self.routes, self.controller = space["ROUTES"], space["Controller"]()
        clear = ("CLR_III", "CLR_IV", "CLR_SB", "CLR_SC", "CLR_SD")
        self.inputs = {"VALID": 1, "DN_P1": 1} | dict.fromkeys(clear, 1)
        self.inputs |= dict.fromkeys(("DR_P1", "REQ", "BLK_III", "BLK_IV", "BLK_SC"), 0)
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

    def seconds_until_free(self, most: float) -> float:
        """How long section III stays locked from now on."""
        for n in range(round(most * 1000 / SCAN_MS)):
            if not self.outputs["YL_III"]:
                return n * SCAN_MS / 1000
            self.go(SCAN_MS / 1000)
        return most


def before_the_open_signal() -> Bench:
    """A train has come before X3, which is open."""
    b = Bench()
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
    b.go(50, CLR_III=1, CLR_IV=1)
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


@pytest.mark.parametrize("name", ["fig2_3_split", "junction"])
def test_a_controller_that_does_not_ask_for_the_rear_is_refuted(name: str) -> None:
    layout, table, _ = built(name)

    for _, wrong in forgotten.rear_not_asked(layout, table):
        found = prove(System(layout, wrong), Limits(search_depth=0))
        assert "L-APPROACH" in {c.id for c in found.claims if c.verdict is not Verdict.PROVED}
