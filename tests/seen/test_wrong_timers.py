"""Controllers whose timers are wrong are not proved: assumptions speak of the world's clocks, not of the timers."""

from __future__ import annotations

from dataclasses import replace

import pytest

from interlock.logic.controller import Controller, Equation, Join, Term, Timer
from interlock.logic.expr import TRUE, Expr, disj, var
from interlock.proof.system.loop import closed_loop
from tests.layouts import SHIPPED, built
from tests.left_open import left_open


def with_input(controller: Controller, timer: str, expr: Expr) -> Controller:
    """The timer's input is something else."""
    name = next(t.input for t in controller.timers if t.name == timer)
    steps = tuple(
        Equation(s.name, Join.ALL, (Term(expr, "changed"),), s.group) if s.name == name else s for s in controller.steps
    )
    return replace(controller, steps=steps)


def with_presets(controller: Controller, ms: int, only: str = "") -> Controller:
    """Presets of so many milliseconds, of all timers or of those whose names begin so."""
    steps = tuple(
        replace(s, preset_ms=ms) if isinstance(s, Timer) and s.name.startswith(only) else s for s in controller.steps
    )
    return replace(controller, steps=steps)


def tells(name: str, controller: Controller) -> set[str]:
    """The claims that a wrong controller of a layout leaves open."""
    layout, _, _ = built(name)
    return left_open(layout, controller)


def test_an_approach_delay_that_counts_from_the_setting_of_the_route_is_not_proved() -> None:
    _, _, controller = built("junction")
    routes = [r for r in controller.symbols.routes if r.entry == "S1J"]
    set_ = disj(var(r.active) for r in routes)
    assert tells("junction", with_input(controller, "AT_S1J", set_))


@pytest.mark.parametrize("name", SHIPPED)
def test_an_approach_delay_whose_input_is_constant_is_not_proved(name: str) -> None:
    _, _, controller = built(name)
    timer = next(iter(controller.symbols.cancellation.approach_timer.values()))
    assert tells(name, with_input(controller, timer, TRUE))


def test_presets_of_one_millisecond_are_not_proved() -> None:
    _, _, controller = built("junction")
    assert tells("junction", with_presets(controller, 1))
    for prefix in ("AT_", "RT_", "OT_", "ST_"):
        assert tells("junction", with_presets(controller, 1, prefix)), prefix


def test_the_special_change_of_direction_without_the_operators_hand_is_not_proved() -> None:
    _, _, controller = built("passing_loop")
    b, token = next(iter(controller.symbols.token.items()))
    name = next(t.input for t in controller.timers if t.name == token.timer)
    old = next(s for s in controller.steps if s.name == name)
    assert isinstance(old, Equation)
    without = [t.expr for t in old.terms if t.kind != "operator"]
    joined = Equation(name, Join.ALL, tuple(Term(x, "kept") for x in without), old.group)
    steps = tuple(joined if s.name == name else s for s in controller.steps)
    assert tells("passing_loop", replace(controller, steps=steps)), b


def test_no_assumption_reads_a_symbol_of_the_controller_but_inputs_and_outputs() -> None:
    from interlock.logic.expr import variables

    for name in SHIPPED:
        layout, _, controller = built(name)
        plant = closed_loop(layout, controller).plant
        own = {s.name for s in controller.state} | {s.name for s in controller.steps}
        definitions = plant.events.definitions
        todo = [v for a in plant.assumptions for v in variables((a.expr,))]
        seen: set[str] = set()
        while todo:
            v = todo.pop()
            if v not in seen:
                seen.add(v)
                todo += variables((definitions[v],)) if v in definitions else []
        assert not seen & own, (name, sorted(seen & own)[:5])
