"""Lines that are typed to a run, and requests over Modbus: what waits, what does not, and what comes too late."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from interlock.app.run import LATE_S, Operator, Ready, operate
from interlock.cli.lines import MOST, Lines
from interlock.cli.run import _Typed
from interlock.field.plc import Cycle


@pytest.fixture
def clock() -> list[float]:
    return [0.0]


@pytest.fixture
def lines(clock: list[float]) -> Lines:
    return Lines(lambda text: text in ("stop", "cancel A", "cancel B", "BLK_q=1"), lambda: clock[0])


def due(lines: Lines) -> list[str]:
    return [x.text + (f": {why}" if why else "") for x, why in lines.due()]


STOPPED = ": all signals were put to stop after it"


def test_a_line_a_cycle_but_requests_from_elsewhere_at_once(lines: Lines) -> None:
    for text in ("set A-1", "", "set A-2\n"):
        lines.put("", text)
    lines.put("scada", "set B-1")
    assert [due(lines) for _ in range(4)] == [["set A-1", "set B-1"], [""], ["set A-2"], []]


def test_to_stop_waits_for_nothing_and_what_came_before_it_is_not_done(lines: Lines) -> None:
    """Three hundred lines were before it, and each had its cycle."""
    for k in range(90):
        lines.put("", f"set A-{k}")
    for text in ("BLK_q=1", "voyage v", "stop", "set A-1", "set A-2"):
        lines.put("", text)
    assert due(lines) == [*(f"set A-{k}{STOPPED}" for k in range(90)), "BLK_q=1", f"voyage v{STOPPED}", "stop"]
    assert [due(lines) for _ in range(3)] == [["set A-1"], ["set A-2"], []]


def test_to_cancel_waits_for_nothing_and_nothing_before_it_comes_true_after_it(lines: Lines) -> None:
    for text in ("set A-1", "voyage v", "set A-2", "cancel A", "set A-3"):
        lines.put("", text)
    assert [due(lines) for _ in range(4)] == [["set A-1", "set A-2", "cancel A"], ["voyage v"], ["set A-3"], []]
    lines.put("", "set A-1")
    lines.put("", "set A-2")
    lines.put("scada", "cancel A")
    lines.put("scada", "set A-3")
    assert [due(lines) for _ in range(3)] == [["set A-1", "set A-2", "cancel A"], ["set A-3"], []]
    for text in ("stop it", "stop"):
        lines.put("", text)
        lines.put("", "set A-1")
    assert due(lines) == [f"stop it{STOPPED}", f"set A-1{STOPPED}", "stop"]


def test_what_waits_too_long_is_not_done_but_to_stop_to_cancel_and_to_block(lines: Lines, clock: list[float]) -> None:
    for text in ("set A-1", "BLK_q=1"):
        lines.put("", text)
    clock[0] = LATE_S + 1
    assert due(lines) == ["set A-1: it was asked for 6 s ago, and is not done now: ask again", "BLK_q=1"]
    lines.put("", "cancel A")
    clock[0] = 99.0
    assert due(lines) == ["cancel A"]


def test_no_more_wait_than_can_be_done(lines: Lines) -> None:
    for k in range(MOST):
        assert lines.put("", f"set A-{k}") == ""
    assert lines.put("", "set A") == "set A: 100 lines wait already: it is not done, type it again"
    for _ in range(1000):
        for text in ("cancel A", "stop", "cancel B"):
            assert lines.put("", text) == ""
    assert len(due(lines)) == MOST + 3


def typed_at(mine: Ready) -> tuple[_Typed, list[dict[str, object]], Callable[[], dict[str, int]]]:
    said: list[dict[str, object]] = []
    typed = _Typed(mine, said.append)
    return typed, said, lambda: dict(typed.ask(Cycle({"VALID": 1}, {}, True, ()), 100))


def test_what_is_cancelled_is_not_asked_for_afterwards(mine: Ready) -> None:
    """Of what is asked for one is made at a time: the route whose turn came after it was cancelled opened then."""
    assert mine.controller is not None
    request = mine.controller.symbols.requests.request
    typed, said, cycle = typed_at(mine)
    for line in ("set X7-X1", "set X1-X5", "cancel X1"):
        typed.take(line)
    found = cycle()
    assert found["CAN_X1"] == 1 and found[request] == operate(mine, "set X7-X1")[request]
    why = "is not asked for any more: signal X1 was cancelled after it"
    assert said == [{"refused": f"route {name} {why}"} for name in ("X1-X5",)]
    for seen in ({"YRQ": True}, {}, {}, {}):
        assert not typed.ask(Cycle({"VALID": 1}, seen, True, ()), 100)[request]


def test_what_is_asked_for_and_waits_too_long_is_told_and_not_made(mine: Ready) -> None:
    clock = [0.0]
    operator = Operator(mine, lambda: clock[0])
    request = mine.controller.symbols.requests.request if mine.controller else ""
    quiet, heard = (Cycle({"VALID": 1}, {"YRQ": x}, True, ()) for x in (False, True))
    for line in ("set X7-X1", "set X1-X5"):
        operator.type(line)
    assert operator.inputs(quiet, 100)[request] and not operator.withdrawn()
    clock[0] = LATE_S + 0.1
    assert not operator.inputs(heard, 100)[request]
    assert [(w.name, w.why) for w in operator.withdrawn()] == [
        ("route X1-X5", "it was asked for more than 5 s ago, and is not done now: ask again")
    ]
    assert not operator.inputs(quiet, 100)[request]


def test_a_request_is_answered_however_it_ends(mine: Ready) -> None:
    typed, said, cycle = typed_at(mine)
    answers: list[bool] = []
    typed.asked("modbus 1", "set", "X7-X1", answers.append)
    typed.take("stop")
    cycle()
    assert answers == [False] and {"refused": f"set X7-X1{STOPPED}"} in said
    typed.asked("modbus 1", "set", "X7-X1", answers.append)
    typed.asked("modbus 1", "cancel", "X7", answers.append)
    assert cycle()["CAN_X7"] == 1 and answers == [False, True, True]
