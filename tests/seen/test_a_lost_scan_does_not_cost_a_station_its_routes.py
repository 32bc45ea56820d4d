"""After one scan without valid inputs every section that a train was in had to be released by hand, one by one."""

from __future__ import annotations

from interlock.logic.eval import Machine
from tests.layouts import built

ROUTE = 3
"""Of mine11: X2-W, from q5 over q3, q2 and q1."""


def drive(machine: Machine, seconds: float, **inputs: int) -> dict[str, bool]:
    """Half-second scans on an empty railway."""
    out: dict[str, bool] = {}
    quiet = {i.name: 1 for i in machine.controller.inputs if i.name.startswith(("CLR_", "VALID", "HLT_", "DN_", "RL_"))}
    quiet |= {i.name: 0 for i in machine.controller.inputs if i.name.startswith("BLK_")}
    for _ in range(round(seconds * 2)):
        out = machine.scan(quiet | inputs, 500)
    return out


def started() -> tuple[Machine, list[str]]:
    """A machine in operation with the route set, and the names of its locks."""
    _, _, controller = built("mine11")
    machine = Machine(controller)
    drive(machine, 700)  # the restart delay is 600 s
    drive(machine, 1, RELALL=1)
    assert not any(machine.state[k] for k in controller.symbols.sections.restart.values())
    route = next(r for r in controller.symbols.routes if r.number == ROUTE)
    drive(machine, 0.5, REQ=ROUTE)
    drive(machine, 20)
    locked = [controller.symbols.sections.lock[w] for w in route.path.ways]
    assert all(machine.state[name] for name in locked)
    return machine, locked


def test_a_route_that_no_train_has_used_is_cancelled_as_ever() -> None:
    machine, locked = started()
    out = drive(machine, 0.5, VALID=0)
    assert not any(on for name, on in out.items() if name.startswith(("YP_", "YY_")))
    drive(machine, 0.5, CAN_X2=1)
    drive(machine, 100)
    assert not any(machine.state[name] for name in locked)


def test_one_command_gives_back_what_a_train_has_left_locked() -> None:
    machine, locked = started()
    drive(machine, 5, CLR_q5=0)
    drive(machine, 5, CLR_q5=0, CLR_q3=0)
    drive(machine, 0.5, VALID=0)
    for here in (("q3",), ("q3", "q2"), ("q2",), ("q2", "q1"), ("q1",)):
        drive(machine, 5, **{f"CLR_{s}": 0 for s in here})
    drive(machine, 100)
    left = [name for name in locked if machine.state[name]]
    assert left, "a train may have been missed"
    drive(machine, 10, RELALL=1)  # from rear to front
    assert not any(machine.state[name] for name in locked)


def test_the_command_gives_back_nothing_that_is_occupied_or_set() -> None:
    machine, locked = started()
    drive(machine, 0.5, VALID=0)
    drive(machine, 60, RELALL=1)
    assert all(machine.state[name] for name in locked), "the route is still set"
    drive(machine, 5, CLR_q5=0, CLR_q3=0)
    drive(machine, 60, CLR_q3=0, RELALL=1)
    assert all(machine.state[name] for name in locked), "something stands there"
