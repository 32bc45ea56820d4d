"""One scan without valid inputs left every section that was locked then to be released by hand, one by one."""

from __future__ import annotations

from interlock.logic.eval import Machine
from tests.layouts import built

ROUTES = (3, 4)
"""Of mine11: two routes that are set at the same time."""


def drive(machine: Machine, seconds: float, **inputs: int) -> dict[str, bool]:
    """Half-second scans on an empty railway."""
    out: dict[str, bool] = {}
    quiet = {i.name: 1 for i in machine.controller.inputs if i.name.startswith(("CLR_", "VALID", "HLT_", "DN_", "RL_"))}
    quiet |= {i.name: 0 for i in machine.controller.inputs if i.name.startswith("BLK_")}
    for _ in range(round(seconds * 2)):
        out = machine.scan(quiet | inputs, 500)
    return out


def test_one_command_gives_back_what_a_lost_scan_has_left_locked() -> None:
    _, _, controller = built("mine11")
    symbols, machine = controller.symbols, Machine(controller)
    drive(machine, 700)  # the restart delay is 600 s
    drive(machine, 1, RELALL=1)
    assert not any(machine.state[k] for k in symbols.restart.values())
    wanted = [r for r in symbols.routes if r.number in ROUTES]
    for r in wanted:
        drive(machine, 0.5, REQ=r.number)
        drive(machine, 20)
    locked = [name for r in wanted for name in (symbols.lock[w] for w in r.ways)]
    assert all(machine.state[name] for name in locked)

    out = drive(machine, 0.5, VALID=0)
    assert not any(on for name, on in out.items() if name.startswith(("YP_", "YY_")))
    for r in wanted:
        drive(machine, 0.5, **{symbols.cancel[r.entry]: 1})
    drive(machine, 300)
    assert all(machine.state[name] for name in locked), "a train may have been missed"
    drive(machine, 1, RELALL=1)
    assert not any(machine.state[name] for name in locked)


def test_the_command_gives_back_nothing_that_is_occupied_or_that_a_signal_was_open_for() -> None:
    _, _, controller = built("mine11")
    symbols, machine = controller.symbols, Machine(controller)
    drive(machine, 700)  # the restart delay is 600 s
    drive(machine, 1, RELALL=1)
    route = next(r for r in symbols.routes if r.number == ROUTES[0])
    drive(machine, 0.5, REQ=route.number)
    drive(machine, 20)
    locked = [symbols.lock[w] for w in route.ways]
    drive(machine, 0.5, VALID=0)
    drive(machine, 60, RELALL=1)
    assert all(machine.state[name] for name in locked), "the route is still set"
    drive(machine, 0.5, **{symbols.cancel[route.entry]: 1})
    occupied = {symbols.clear[s]: 0 for s, _ in route.ways}
    drive(machine, 300, RELALL=1, **occupied)
    assert all(machine.state[name] for name in locked), "something stands there"
