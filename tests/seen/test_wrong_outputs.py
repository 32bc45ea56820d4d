"""Controllers whose outputs are wrong are not proved: the world hangs on the terminals, not on the controller."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from interlock.logic.controller import Controller
from interlock.logic.expr import FALSE, TRUE, Expr, neg
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.layouts import built
from tests.left_open import left_open

Change = Callable[[dict[str, Expr]], dict[str, Expr]]


def with_outputs(controller: Controller, change: Change) -> Controller:
    """The controller with other outputs; those that are on at the restart would be found by the controller itself."""
    new = change({o.name: o.expr for o in controller.outputs})
    wrong = tuple(replace(o, expr=new[o.name]) for o in controller.outputs)
    object.__setattr__(controller := replace(controller, outputs=()), "outputs", wrong)
    return controller


def tells(name: str, change: Change) -> set[str]:
    """The claims that a controller with wrong outputs leaves open."""
    layout, _, controller = built(name)
    return left_open(layout, with_outputs(controller, change))


def swapped(a: str, b: str) -> Change:
    return lambda old: old | {a: old[b], b: old[a]}


def all_yellow(old: dict[str, Expr]) -> dict[str, Expr]:
    """Every signal shows caution and its stop lamp is dark."""
    return {n: TRUE if n.startswith("YY_") else FALSE if n.startswith("YS_") else x for n, x in old.items()}


def driven_under_a_train(old: dict[str, Expr]) -> dict[str, Expr]:
    """A machine is driven reverse whenever it is not driven normal."""
    return old | {"YR_101": neg(old["YN_101"])}


def telegrams_cut(old: dict[str, Expr]) -> dict[str, Expr]:
    """The words to the neighbour never leave the cabinet."""
    return {n: FALSE if n.startswith("YT") and n.endswith("_W") else x for n, x in old.items()}


def dark_lamp(old: dict[str, Expr]) -> dict[str, Expr]:
    return old | {"YS_S1": FALSE}


def undriven(old: dict[str, Expr]) -> dict[str, Expr]:
    return old | {"YN_101": FALSE}


def never_told(old: dict[str, Expr]) -> dict[str, Expr]:
    return old | {"YL_AC": FALSE}


@pytest.mark.parametrize(
    ("name", "change"),
    [
        pytest.param("junction", swapped("YN_101", "YR_101"), id="drives swapped"),
        pytest.param("junction", swapped("YS_S1", "YP_S1"), id="lamps swapped"),
        pytest.param("junction", driven_under_a_train, id="machine driven under a train"),
        pytest.param("junction", all_yellow, id="all yellow, stop lamps dark"),
        pytest.param("junction", dark_lamp, id="one stop lamp dark"),
        pytest.param("junction", undriven, id="a machine that is never driven"),
        pytest.param("junction", never_told, id="an indication that is never lit"),
        pytest.param("passing_loop", telegrams_cut, id="telegrams to the neighbour cut"),
    ],
)
def test_a_controller_with_wrong_outputs_is_not_proved(name: str, change: Change) -> None:
    assert tells(name, change)


def test_the_outputs_as_they_are_are_proved() -> None:
    layout, _, controller = built("junction")
    assert prove(System(layout, with_outputs(controller, lambda old: old))).proved


def test_every_output_is_read_by_the_plant_or_a_claim() -> None:
    from interlock.logic.expr import variables
    from interlock.proof.claims import Facts, claims

    for name in ("junction", "passing_loop", "pit_bottom", "heishan", "flank_lab"):
        layout, _, controller = built(name)
        system = System(layout, controller)
        read = set(variables([*(c.expr for c in claims(Facts(system))), *system.loop.plant.next.values()]))
        read |= set(variables(system.loop.plant.events.definitions.values()))
        unread = [o.name for o in controller.outputs if not {o.name, o.name + "'"} & read]
        assert not unread, (name, unread)
