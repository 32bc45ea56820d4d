"""An overlap is a lock like any other: a single clear reading neither gives it up nor lets it swing (R15)."""

from __future__ import annotations

from typing import Any

from interlock.simulate.run import load
from tests.campaigns.simulate import Case


def _runtime(path: str, **state: bool) -> tuple[Any, dict[str, int]]:
    """A controller with these bits set, and inputs that permit the most."""
    names = load(Case.of(path).runtime)
    controller = names["Controller"]()
    controller.state |= {n: False for n in controller.state if n.startswith("K_")} | state
    inputs = dict.fromkeys((n for n in names["INPUTS"] if n.startswith(("CLR_", "VALID", "RL_", "GL_", "CL_"))), 1)
    return controller, inputs | dict.fromkeys((n for n in names["INPUTS"] if n.startswith("BLK_")), 0)


def test_an_overlap_under_a_vehicle_is_not_given_up_on_a_single_clear_reading() -> None:
    """Without a route to the signal any more, as when a train has overrun it and its route was given back."""
    controller, inputs = _runtime("layouts/junction.yaml", V_S2J_1=True, VF_S2J=True)
    for clear, held in ((0, True), (1, True), (0, True), (1, True)):
        inputs["CLR_BC"] = clear
        controller.scan(inputs, 500)
        assert controller.state["V_S2J_1"] is held
    for _ in range(6):
        controller.scan(inputs, 500)
    assert controller.state["V_S2J_1"] is False  # clear for three seconds without a break


def test_an_overlap_does_not_swing_on_a_single_clear_reading() -> None:
    """A vehicle that has overrun the signal stands on points which a swing would turn."""
    held = {"V_F_1": True, "VF_F": True, "L_g4_1": True, "CN_6": True, "CR_LC1": True}
    controller, inputs = _runtime("layouts/flank_lab.yaml", **held)
    for clear, number in ((0, 0), (1, 11), (1, 0), (1, 0), (1, 0), (1, 0), (1, 0), (1, 0)):
        controller.state |= held
        controller.scan(inputs | {"DN_6": 1, "CLR_w6": clear, "REQ": number}, 500)
        assert controller.state["V_F_1"] and not controller.state["V_F_2"]
    controller.state |= held
    controller.scan(inputs | {"DN_6": 1, "REQ": 11}, 500)
    assert controller.state["V_F_2"] and not controller.state["V_F_1"]
