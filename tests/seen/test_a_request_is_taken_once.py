"""A panel that holds the number of a route asks for it once: it is not set again by itself for the next train."""

from __future__ import annotations

from interlock.logic.eval import Machine
from tests.layouts import built


def drive(machine: Machine, scans: int, **inputs: int) -> dict[str, bool]:
    """Scans of half a second on an empty railway, points normal."""
    out: dict[str, bool] = {}
    for _ in range(scans):
        given = {i.name: 1 for i in machine.controller.inputs if i.name.startswith(("CLR_", "VALID", "DN_"))}
        given |= {i.name: 0 for i in machine.controller.inputs if i.name.startswith("BLK_")}
        out = machine.scan(given | inputs, 500)
    return out


def ready() -> Machine:
    """fig2_2 after its restart, everything released."""
    _, _, controller = built("fig2_2")
    machine = Machine(controller)
    drive(machine, 2 * 600 + 4)
    drive(machine, 10, RELALL=1)
    return machine


def test_a_number_that_is_held_asks_once() -> None:
    machine = ready()
    assert drive(machine, 4, REQ=1)["YP_X1"]
    drive(machine, 4, REQ=1, CLR_SC=0)  # a train before the signal goes in, the request still held
    drive(machine, 2, REQ=1, CLR_SC=0, CLR_DP=0)
    drive(machine, 2, REQ=1, CLR_DP=0, CLR_SA=0)
    out = drive(machine, 20, REQ=1, CLR_SA=0)
    assert not any(machine.state[n] for (_, _), n in machine.controller.symbols.sections.lock.items())
    assert not out["YP_X1"]
    out = drive(machine, 20, REQ=1)
    assert not out["YP_X1"] and not machine.state["A_R1"]


def test_a_number_that_is_held_at_power_up_does_not_ask() -> None:
    _, _, controller = built("fig2_2")
    machine = Machine(controller)
    drive(machine, 2 * 600 + 4, REQ=1)
    drive(machine, 10, RELALL=1, REQ=1)
    assert not drive(machine, 4, REQ=1)["YP_X1"]
    out = drive(machine, 1)
    assert not out.get("YRQ", True)
    assert drive(machine, 4, REQ=1)["YP_X1"] and drive(machine, 1, REQ=1)["YRQ"]
