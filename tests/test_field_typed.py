"""What an operator types to a run: what stays, what lasts a cycle, what is refused, and how."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.presses import Presses
from interlock.app.run import BadCommand, Operator, Ready, operate
from interlock.cli.run import _Typed
from interlock.field.plc import Cycle
from interlock.model.elements import Position
from tests.layouts import built
from tests.panels import unproved


def test_what_the_operator_types(mine: Ready) -> None:
    assert operate(mine, "set j1") == operate(mine, "set X1-X5")
    assert operate(mine, "cancel X1") == {"CAN_X1": 1} and operate(mine, "BLK_q1=1") == {"BLK_q1": 1}
    for line in ("set nonsense", "voyage in", "cancel X99", "CLR_q1=1", "BLK_q1=2", "hello"):
        with pytest.raises(BadCommand):
            operate(mine, line)
    operator = Operator(mine)
    for line in ("voyage nowhere", "voyage in end", "voyage"):
        with pytest.raises(BadCommand, match="voyages: in, out"):
            operator.type(line)
    operator.type("voyage in")
    operator.type("voyage in end")


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("BLK_q1=2", "BLK_q1=2: BLK_q1 is 0 or 1"),
        ("BLK_q1 = x", "BLK_q1=x: BLK_q1 is 0 or 1"),
        ("BLK_q1=", "BLK_q1=: BLK_q1 is 0 or 1"),
        ("REQ=99", "REQ=99: REQ is a number from 0 to "),
        ("REQ=" + "9" * 5000, "REQ is a number from 0 to "),
        ("BLK_qq1=1", "there is no variable BLK_qq1: did you mean BLK_q1?"),
        (
            "BLK_ap_W=1",
            "no variable BLK_ap_W: section ap_W cannot be blocked: it is an approach section, which no route",
        ),
        ("CLR_q1=1", "CLR_q1 is read from a substation: it is not set by hand"),
        ("YP_X7=1", "YP_X7 is written by the controller: it is not set by hand"),
        ("VALID=1", "VALID says whether inputs are valid: it is not set by hand"),
        ("set X1-X55", "there is no route X1-X55: did you mean X1-X5?"),
        ("cancel", "write cancel SIGNAL"),
    ],
)
def test_what_is_wrong_with_a_command_is_said(mine: Ready, line: str, said: str) -> None:
    with pytest.raises(BadCommand) as told:
        operate(mine, line)
    assert said in str(told.value)
    assert operate(mine, "BLK_q1 = 1") == {"BLK_q1": 1}


def test_where_trains_stand_is_not_known_while_inputs_are_lost(mine: Ready) -> None:
    operator = Operator(mine)
    with pytest.raises(BadCommand, match="no inputs have been read yet: whether a train stands in q1 is not known"):
        operator.type("train 12 q1")
    operator.inputs(Cycle({"VALID": 0}, {}, False, ("west: no connection",)), 100)
    with pytest.raises(
        BadCommand, match=r"inputs are lost \(west: no connection\): .* say it again when they are valid"
    ):
        operator.type("train 12 q1")
    operator.inputs(Cycle({"VALID": 1, "CLR_q1": 1}, {}, True, ()), 100)
    with pytest.raises(BadCommand, match="q1 is clear: no train stands there"):
        operator.type("train 12 q1")


def test_commands_are_for_one_cycle_and_values_stay(mine: Ready) -> None:
    operator = Operator(mine)
    operator.type("BLK_q1=1")
    operator.type("set j1")
    request = next(iter(operate(mine, "set j1")))
    quiet, heard = (Cycle({"VALID": 1}, {"YRQ": x}, True, ()) for x in (False, True))
    first, second = operator.inputs(quiet, 100), operator.inputs(heard, 100)
    assert first["BLK_q1"] == 1 and first[request] and second["BLK_q1"] == 1 and second[request] == 0
    operator.type("BLK_q1=0")
    assert operator.inputs(quiet, 100)["BLK_q1"] == 0 and not operator.held


def test_a_run_starts_with_every_section_blocked_as_the_text_does(mine: Ready) -> None:
    """What was blocked before a restart is not known: somebody may still work there."""
    assert mine.controller is not None
    text, blocked = dict[str, object](), mine.controller.symbols.sections.blocked
    typed = _Typed(mine, text.update)
    typed.begin()
    assert text == {"blocked": {str(s): str(n) for s, n in blocked.items()}} and len(blocked) > 3
    found = typed.ask(None, 100)
    assert all(found[n] for n in blocked.values())
    assert all(i.restrictive for i in mine.controller.inputs if i.name in blocked.values())
    typed.take("BLK_q1=0")
    assert [n for n in blocked.values() if not typed.ask(None, 100)[n]] == ["BLK_q1"]
    typed.take("free")
    assert not any(typed.ask(None, 100)[n] for n in blocked.values())


def test_a_button_is_pressed_and_does_not_stay(mine: Ready) -> None:
    """A release, a confirmation, a move by hand: what was forgotten acted hours later, when its conditions held."""
    assert mine.allocation is not None
    said: list[dict[str, object]] = []
    typed = _Typed(mine, said.append)
    for name in ("REL_q1", "RELALL", "TC_P1", "MN_P1", "MR_P1", "REQ", "CAN_X1"):
        assert name in mine.allocation.written
        seconds = 13 if name[0] == "M" else 2  # points turn as long as they are ordered to, where somebody works (R10)
        typed.take(f"{name}=1")
        read = [typed.ask(None, 500)[name] for _ in range(2 * seconds + 2)]
        assert read == [1] * (2 * seconds) + [0, 0], name
        assert said == [{"pressed": name, "value": 1, "for_s": float(seconds)}, {"let_go": name}]
        said.clear()
        typed.take(f"{name}=1")
        assert typed.ask(None, 60_000)[name], "a cycle reads it, however late"
        typed.take(f"{name}=0")
        assert not typed.ask(None, 100)[name] and {"let_go": name} in said
        said.clear()
    typed.take("BLK_q1=1")
    assert all(typed.ask(None, 60_000)["BLK_q1"] for _ in range(3)), "a switch"


def test_a_direction_is_pressed_until_it_is_here_and_a_crossing_is_held_closed() -> None:
    """The special manual change asks for a hold of a minute; a crossing opens by itself when nobody holds it closed."""
    layout, _, controller = built("passing_loop")
    presses = Presses(layout, controller.symbols)
    token = next(iter(controller.symbols.token.values()))
    presses.press(token.manual, 1)
    times = layout.principles.token_delay_s + 2
    assert presses.press_ms(token.manual) == 1000 * times
    assert all(presses.inputs({}, 1000) for _ in range(int(times)))
    assert not presses.inputs({}, 1000) and presses.let_go() == [token.manual]
    presses.press(token.manual, 1)
    assert presses.inputs({}, 100) and not presses.inputs({token.have: True}, 100)
    layout, _, controller = built("crossing_line")
    by_hand = controller.symbols.machines.by_hand
    presses = Presses(layout, controller.symbols)
    held = {(m in layout.machines.device, x) for (m, x), n in by_hand.items() if presses.is_switch(n)}
    assert held == {(True, Position.REVERSE)}


@pytest.mark.parametrize("valid", [True, False], ids=["refused", "inputs lost"])
def test_what_was_refused_is_not_asked_for_again(mine: Ready, valid: bool) -> None:
    """An operator who was refused has gone on to something else: a route that is set by itself later is no service."""
    operator = Operator(mine)
    request = next(iter(operate(mine, "set j1")))

    def asked(heard: bool, is_valid: bool = True) -> int:
        seen = Cycle({"VALID": int(is_valid)}, {"YRQ": heard}, is_valid, ())
        return operator.inputs(seen, 100)[request]

    operator.type("set j1")
    assert asked(False, valid), "asked for at once, so that the controller says why not"
    assert not asked(True, valid)
    assert not any(asked(False) for _ in range(200)), "20 s"
    operator.type("set j1")
    assert asked(False)


def test_stop_cancels_the_routes_of_every_signal_once() -> None:
    ready = unproved(Path("layouts/heishan.yaml").read_text("utf-8"))
    assert ready.controller is not None
    operator = Operator(ready)
    operator.type("stop")
    cancels = {str(n) for n in ready.controller.symbols.cancellation.cancel.values()}
    pressed, later = ({n for n, v in operator.inputs(None, 100).items() if v} for _ in range(2))
    assert len(cancels) > 4 and cancels <= pressed and not cancels & later


def test_who_cancels_at_a_signal_ends_the_automatic_working_of_routes_that_lead_past_it() -> None:
    """The longer route would be set again at once, and with it what was cancelled."""
    text = Path("tests/layouts_for_tests/identifiers.yaml").read_text("utf-8")
    ready = unproved(text + "automatic:\n  - {from: X, to: W}\n  - {from: Q, to: F}\n")
    assert ready.controller is not None
    y = ready.controller.symbols
    past = {number for number in y.requests.automatic if y.routes.number[number].path.onward is not None}
    for signal in ("Z", "Y", "X", "Q"):
        operator = Operator(ready)
        for name in y.requests.automatic.values():
            operator.type(f"{name}=1")
        ends = operator.type(f"cancel {signal}")
        left = set(operator.automatic())
        assert past and bool(past & left) is (signal == "Q") and bool(ends), (signal, ends)
        assert left == set(y.requests.automatic) - {
            n for n in y.requests.automatic if str(y.routes.number[n].id) in ends
        }
