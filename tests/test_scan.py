"""One-scan semantics, written down in logic/controller.py: inputs, steps in order, next state from the old, outputs."""

from __future__ import annotations

import pytest

from interlock.logic.controller import (
    Controller,
    Equation,
    Input,
    Join,
    MalformedController,
    Output,
    StateVar,
    Term,
    Timer,
)
from interlock.logic.eval import Machine
from interlock.logic.expr import neg, var
from tests.layouts import built


def small(steps: tuple[Equation | Timer, ...], state: tuple[str, ...], following: tuple[Equation, ...]) -> Controller:
    return Controller(
        "small",
        (Input("I", "an input"), Input("J", "another")),
        tuple(StateVar(s, False, s) for s in state),
        steps,
        following,
        tuple(Output(f"Y_{s}", var(s), False, s) for s in state),
        built("fig2_2")[2].symbols,
    )


def eqn(name: str, *terms: object) -> Equation:
    return Equation(name, Join.ALL, tuple(Term(t, "term") for t in terms), "test")  # type: ignore[arg-type]


def test_next_state_reads_the_old_state_even_of_variables_computed_before_it() -> None:
    c = small((), ("A", "B"), (eqn("A", var("I")), eqn("B", var("A"))))
    m = Machine(c)
    assert m.scan({"I": 1}, 10) == {"Y_A": True, "Y_B": False}
    assert m.scan({"I": 0}, 10) == {"Y_A": False, "Y_B": True}


def test_outputs_show_the_new_state_of_the_same_scan() -> None:
    m = Machine(small((), ("A",), (eqn("A", var("I")),)))
    assert m.scan({"I": 1}, 10)["Y_A"] is True


def test_steps_see_earlier_steps_of_the_same_scan() -> None:
    c = small((eqn("V", var("I")), eqn("W", var("V"), neg(var("J")))), ("A",), (eqn("A", var("W")),))
    assert Machine(c).scan({"I": 1, "J": 0}, 10)["Y_A"] is True


def test_a_timer_needs_its_input_without_a_break() -> None:
    c = small((eqn("V", var("I")), Timer("T", "V", 300)), ("A",), (eqn("A", var("T")),))
    m = Machine(c)
    assert [m.scan({"I": i}, 100)["Y_A"] for i in (1, 1, 0, 1, 1, 1, 1, 0)] == [
        False,
        False,
        False,
        False,
        False,
        False,
        True,
        False,
    ]


@pytest.mark.parametrize(
    ("steps", "state", "following", "what"),
    [
        ((eqn("V", var("W")), eqn("W", var("V"))), (), (), "reads W before it is computed"),
        ((eqn("V", var("I")), eqn("V", var("J"))), (), (), "defined twice"),
        ((), ("A",), (), "differ"),
        ((), ("A",), (eqn("A", var("nothing")),), "not defined"),
    ],
)
def test_a_malformed_controller_cannot_be_built(
    steps: tuple[Equation, ...], state: tuple[str, ...], following: tuple[Equation, ...], what: str
) -> None:
    with pytest.raises(MalformedController, match=what):
        small(steps, state, following)


def test_an_output_that_is_not_restrictive_at_a_restart_is_refused() -> None:
    good = small((), ("A",), (eqn("A", var("I")),))
    with pytest.raises(MalformedController, match="not restrictive"):
        Controller(
            "bad", good.inputs, good.state, (), good.next, (Output("Y", neg(var("A")), False, ""),), good.symbols
        )
