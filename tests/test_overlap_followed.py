"""A train that stands wholly before its signal gives up its overlap, whoever comes behind it (R4)."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from interlock.logic import names
from interlock.logic.controller import Controller
from interlock.logic.expr import FALSE, Substitution
from interlock.logic.lower import lower
from interlock.model.elements import SectionId
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.mutation.weakenings import without
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.layouts import grown
from tests.test_release_behind import Bench

STATION = """interlock: 1
name: followed
boundaries:
  W: {approach: wa 800}
buffers: [B1, B2]
tracks:
  west: [W, q1 300]
  odd:  [q3 300, B1]
  even: [q4 300, B2]
points:
  P1: {section: q2, toe: west.end, normal: odd.start, reverse: even.start}
signals:
  X1: {from: W,  into: q1}
  X2: {from: q1, into: q2}
  Y3: {from: q3, into: q2}
  Y4: {from: q4, into: q2}
overlaps:
  X2: {length: 30}
"""
BERTH = Path("tests/layouts_for_tests/berth_before.yaml").read_text("utf-8") + "overlaps:\n  X3: {length: 50}\n"
# X1, behind another signal, closes when the train has passed it wholly
WHOLE = (
    STATION.replace("name: followed", "name: followed\nprinciples: {main_closes: whole-movement}")
    .replace("west: [W, q1", "west: [W, q0 300, q1")
    .replace("X1: {from: W,  into: q1}", "X0: {from: W, into: q0}\n  X1: {from: q0, into: q1}")
)
RELEASE_S = 60


def controller(text: str) -> Controller:
    found = grown(text)
    assert found is not None and not found[2].has_errors
    return lower(found[0], found[1])


def before_x2(text: str = STATION) -> Bench:
    """X1-X2 is set with its overlap over q2, and a train has come into q1 and is still in rear of X1."""
    b = Bench(controller(text))
    b.ask("X1-X2")
    assert not b.outputs["YS_X1"] and b.outputs["YL_q2"]
    b.go(10, CLR_wa=0)
    b.go(5, CLR_q1=0)
    assert b.outputs["YS_X1"]
    return b


@pytest.mark.parametrize("after", [4, 10, 30, 55])
def test_it_is_given_up_though_the_next_train_comes_to_the_signal_in_rear(after: int) -> None:
    """The most ordinary thing there is: the next train waits at X1.  The overlap was held until the first one went on,
    and every route of others over q2 refused."""
    b = before_x2()
    b.go(after, CLR_wa=1)
    b.go(0.2, CLR_wa=0)
    left = b.seconds_until_free(300, "q2")
    assert abs(after + left - RELEASE_S - 3) <= 1, "the time of the overlap, after the release delay of the approach"
    assert b.outputs["YL_q1"] and b.outputs["YS_X1"], "nobody else is let into q1"


def test_the_one_behind_comes_and_goes() -> None:
    """That the approach reads clear and occupied again does not begin the time anew."""
    b = before_x2()
    b.go(5, CLR_wa=1)
    for n in range(30):
        b.go(1, CLR_wa=n % 2)
    assert b.seconds_until_free(300, "q2") <= RELEASE_S - 30


@pytest.mark.parametrize("clear", [0.2, 2])
def test_it_is_held_where_the_approach_is_never_seen_clear(clear: float) -> None:
    """The next train follows so closely, or the first is longer than q1: nothing tells that all of it is in."""
    b = before_x2()
    b.go(clear, CLR_wa=1)
    b.go(0.2, CLR_wa=0)
    assert b.seconds_until_free(400, "q2") == 400
    b.go(4, CLR_wa=1)
    assert b.seconds_until_free(400, "q2") <= RELEASE_S


def test_it_is_held_while_what_came_in_may_be_a_joint_that_failed() -> None:
    """The joint at X1 fails before a train that has seen it open.  The train is still to come."""
    b = Bench(controller(STATION))
    b.ask("X1-X2")
    b.go(10, CLR_wa=0)
    b.go(20, CLR_q1=0)
    b.go(200, CLR_q1=1)
    assert b.outputs["YL_q2"] and b.outputs["YS_X1"]
    b.go(200, CLR_q1=0)
    assert b.outputs["YL_q2"], "it has come, and is longer than q1"
    b.go(20, CLR_wa=1)
    b.go(20, CLR_wa=0)
    assert b.outputs["YL_q2"], "the time counts from when it was seen to be in"
    assert b.seconds_until_free(400, "q2") <= RELEASE_S - 30


def test_the_next_train_finds_it_anew() -> None:
    """What was seen of one train says nothing of the next: behind it q1 is released, and forgets."""
    b = before_x2()
    b.go(10, CLR_wa=1)
    assert b.seconds_until_free(300, "q2") > 0
    b.ask("X2-B1")
    b.go(5, CLR_wa=0, CLR_q2=0)
    b.go(5, CLR_q1=1)
    b.go(5, CLR_q3=0)
    b.go(5, CLR_q2=1)
    assert not b.outputs["YL_q1"] and not b.outputs["YL_q2"]
    b.ask("X1-X2.o2")
    b.go(5, DN_P1=0, DR_P1=1)
    assert not b.outputs["YS_X1"]
    b.go(200, CLR_q1=0)
    assert b.outputs["YL_q2"], "it stands across the joint at X1"


def test_so_it_is_in_a_berth() -> None:
    """In q4, where a train that has arrived is not told from vehicles any more."""
    b = Bench(controller(BERTH))
    b.ask("X2-X3")
    b.ask("X1-X2")
    b.go(5, CLR_wa=0)
    b.go(5, CLR_q1=0)
    b.go(5, CLR_wa=1)
    b.go(5, CLR_q2=0)
    b.go(5, CLR_q1=1)
    b.go(5, CLR_q4=0)
    assert b.outputs["YL_q6"]
    b.go(10, CLR_q2=1)
    b.ask("X1-X2")
    b.go(0.2, CLR_q2=0)
    assert b.seconds_until_free(300, "q6") <= RELEASE_S


@pytest.mark.parametrize("text", [STATION, BERTH, WHOLE], ids=["station", "berth", "whole movement"])
def test_the_controller_is_proved(text: str) -> None:
    found = grown(text)
    assert found is not None
    result = prove(System(found[0], lower(found[0], found[1])), Limits(search_depth=0))
    assert result.proved and not result.dropped


def test_one_that_does_not_ask_whether_the_approach_was_seen_clear_is_not_proved() -> None:
    found = grown(STATION)
    assert found is not None
    wrong = list(without("OTI", "approach seen clear")(found[0], found[1]))
    assert len(wrong) == 1
    claims = prove(System(found[0], wrong[0][1]), Limits(search_depth=0)).claims
    assert {c.id for c in claims if c.verdict is not Verdict.PROVED} >= {"L-APPROACH", "T-COLLISION"}


def test_one_that_looks_at_the_approach_while_the_signal_is_still_open_is_not_proved() -> None:
    """Whoever comes next may have seen it until it closed, and would come in behind the first train, running."""
    found = grown(WHOLE)
    assert found is not None
    right = lower(found[0], found[1])
    cleared = right.symbols.cancellation.rear_cleared[SectionId("q1")]
    shut = Substitution({x.name: FALSE for x in right.state if x.name.family is names.PASSING})
    old = next(e for e in right.next if e.name == cleared)
    wrong = replace(old, terms=tuple(t._replace(expr=shut(t.expr)) for t in old.terms))
    assert wrong != old
    following = tuple(wrong if e is old else e for e in right.next)
    claims = prove(System(found[0], replace(right, next=following)), Limits(search_depth=0)).claims
    assert "T-COLLISION" in {c.id for c in claims if c.verdict is not Verdict.PROVED}
