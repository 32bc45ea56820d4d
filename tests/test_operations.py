"""What an operator may do with a route works on every shipped layout; where a key or a bit is cut, a run tells."""

from __future__ import annotations

from dataclasses import replace

import pytest

from interlock.logic.controller import Controller, Join, Term
from interlock.logic.expr import FALSE, Expr, Substitution, variables
from interlock.proof.system.loop import closed_loop
from interlock.proof.witnesses.operations import OPERATIONS, operations
from interlock.sim.lanes import Lanes
from tests.layouts import SHIPPED, built


@pytest.mark.parametrize("name", SHIPPED)
def test_every_operation_works_with_every_route_that_a_train_can_take(name: str) -> None:
    layout, _, controller = built(name)
    found = operations(closed_loop(layout, controller))
    assert found and all(those.keys() == OPERATIONS.keys() for those in found.values())
    assert {(r, what, why) for r, those in found.items() for what, why in those.items() if why is not None} == set()


@pytest.mark.parametrize("name", SHIPPED)
def test_inputs_tell_of_movements_that_read_no_inputs(name: str) -> None:
    """A run of many reads its inputs once, after the railway has moved: from the step before there is nothing left."""
    layout, _, controller = built(name)
    lanes = Lanes(controller, closed_loop(layout, controller).plant)
    flat = Substitution(lanes.plant.events.definitions)
    todo, read = {*lanes.told.values()}, set()
    while todo:
        read |= {*variables(todo)}
        todo = {flat(x) for x in todo} - todo
    assert lanes.told and read.isdisjoint({x.name for x in (*controller.inputs, *controller.timers)})


def put(controller: Controller, name: str, x: Expr) -> Controller:
    """The controller with another value of a wire or of a next state."""

    def changed(e: object) -> object:
        return replace(e, join=Join.ALL, terms=(Term(x, "changed"),)) if getattr(e, "name", "") == name else e  # type: ignore[type-var]

    steps, following = map(changed, controller.steps), map(changed, controller.next)
    return replace(controller, steps=tuple(steps), next=tuple(following))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("operation", "wire", "words"),
    [
        ("released by hand", "HR_q2", "stay locked"),
        ("trailed", "TR_P1", "does not count as trailed"),
        ("turned by hand", "MAR_P1", "not moved"),
    ],
)
def test_an_operation_that_does_not_work_is_told(operation: str, wire: str, words: str) -> None:
    layout, _, controller = built("mine11")
    found = operations(closed_loop(layout, put(controller, wire, FALSE)))
    assert any(words in (those[operation] or "") for those in found.values())
