"""A restart with trains: no claim exempts them, nothing opens from what does not lie, time passes before a release."""

from __future__ import annotations

from dataclasses import replace

import pytest

from interlock.logic.controller import Controller, Equation
from interlock.logic.eval import Machine
from tests.layouts import built
from tests.left_open import left_open


def without_terms(controller: Controller, *kinds: str) -> Controller:
    """The controller as it was: without some kinds of terms."""
    steps = tuple(
        replace(s, terms=tuple(t for t in s.terms if t.kind not in kinds)) if isinstance(s, Equation) else s
        for s in controller.steps
    )
    return replace(controller, steps=steps)


@pytest.mark.parametrize(
    "name", ["crossing_line", "depot", "heishan", "cn6502", "../tests/layouts_for_tests/foul_siding"]
)
def test_a_signal_that_opens_over_what_a_standing_train_does_not_find_in_order_is_not_proved(name: str) -> None:
    layout, _, controller = built(name)
    old = without_terms(controller, "rear released", "rear device closed", "stands alone")
    assert left_open(layout, old)


def run(machine: Machine, seconds: float, **inputs: int) -> dict[str, bool]:
    out: dict[str, bool] = {}
    clear = {i.name: 1 for i in machine.controller.inputs if i.name.startswith(("CLR_", "VALID", "DN_", "RL_", "GL_"))}
    quiet = {i.name: 0 for i in machine.controller.inputs if i.name.startswith("BLK_")}
    for _ in range(round(seconds * 2)):
        out = machine.scan(clear | quiet | inputs, 500)
    return out


def test_a_crossing_can_be_closed_while_its_section_is_occupied() -> None:
    _, _, controller = built("crossing_line")
    machine = Machine(controller)
    out = run(machine, 2, CLR_s2=0, DN_LC1=1)
    assert not out["YR_LC1"]
    out = run(machine, 1, CLR_s2=0, DN_LC1=1, MR_LC1=1)
    assert out["YR_LC1"]


def test_nothing_is_released_while_trains_that_ran_may_still_run() -> None:
    """junction: a second after power-on no signal may open, whatever the operator does."""
    _, _, controller = built("junction")
    machine = Machine(controller)
    delay = 180
    for _ in range(4):
        run(machine, 0.5, RELALL=1)
        for r in controller.symbols.routes:
            out = run(machine, 0.5, REQ=r.number)
            assert not any(v for n, v in out.items() if n.startswith(("YP_", "YY_", "YO_", "YW_")))
    out = run(machine, delay)
    assert all(machine.state[k] for k in controller.symbols.sections.restart.values())
    run(machine, 1, RELALL=1)
    assert not any(machine.state[k] for k in controller.symbols.sections.restart.values())


@pytest.mark.parametrize(("beside", "opens"), [("p", False), ("a", True)])
def test_a_train_is_called_only_with_nothing_foul_of_it(beside: str, opens: bool) -> None:
    """foul_siding: one stands in r since the restart, another over the point P, where it may lie on the leg over which
    no route leads: S opened for the first."""
    layout, _, controller = built("../tests/layouts_for_tests/foul_siding")
    machine, stand = Machine(controller), {"CLR_r": 0, f"CLR_{beside}": 0}
    run(machine, layout.principles.restart_delay_s + 1, **stand)
    run(machine, 5, **stand, RELALL=1)
    (route,) = (r for r in controller.symbols.routes if r.id == "S-E")
    run(machine, 5, **stand, REQ=route.number)
    assert run(machine, 1, **stand)["YS_S"] is not opens
