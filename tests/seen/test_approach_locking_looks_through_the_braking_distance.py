"""A train at full speed two sections in rear of an open signal keeps its route from being given up at once."""

from __future__ import annotations

import pytest

from interlock.logic.eval import Machine
from tests.layouts import built

SCAN_MS = 500


class Running:
    """A layout after its restart; machines lie where they were last driven."""

    def __init__(self, name: str = "slip_junction") -> None:
        _, self.table, controller = built(name)
        self.machine = Machine(controller)
        self.lies = {i.name[3:]: "N" for i in controller.inputs if i.name.startswith("DN_")}
        self.run(2 * 600 + 4)
        self.run(20, RELALL=1)

    def run(self, scans: int, **inputs: int) -> dict[str, bool]:
        """Scans of half a second; inputs otherwise as on an empty railway."""
        out: dict[str, bool] = {}
        for _ in range(scans):
            given = {i.name: 1 for i in self.machine.controller.inputs if i.name.startswith(("CLR_", "VALID"))}
            given |= {i.name: 0 for i in self.machine.controller.inputs if i.name.startswith("BLK_")}
            given |= {f"D{x}_{m}": int(lies == x) for m, lies in self.lies.items() for x in "NR"}
            out = self.machine.scan(given | inputs, SCAN_MS)
            self.lies |= {m: x for m in self.lies for x in "NR" if out[f"Y{x}_{m}"]}
        return out

    def number(self, entry: str, exit_: str) -> int:
        """A route, by its ends."""
        return next(r.number for r in self.table.routes if (r.entry, r.exit) == (entry, exit_))


def both_open() -> Running:
    """S1 is open, and S1J beyond it."""
    r = Running()
    ahead = next(x for x in r.table.routes if x.entry == "S1J")
    for number in (r.number("S1", "S1J"), ahead.number):
        r.run(1, REQ=number)
        r.run(20)
    out = r.run(1)
    assert not out["YS_S1"] and not out["YS_S1J"]
    return r


def test_a_train_before_the_signal_in_rear_keeps_the_route_for_the_delay() -> None:
    r = both_open()
    r.run(4, CLR_AA=0)  # the train is before S1, at 80 km/h, and has seen it at clear
    r.run(1, CLR_AA=0, CAN_S1J=1)
    assert all(r.run(1, CLR_AA=0)["YL_SC"] for _ in range(120)), "released ahead of a train that cannot stop"


@pytest.mark.parametrize("coming", ["none", "not called"])
def test_with_nobody_on_the_way_it_is_given_up_at_once(coming: str) -> None:
    r = both_open()
    if coming == "not called":
        r.run(1, CAN_S1=1)
        r.run(20)
    beyond = {"CLR_AA": 0} if coming == "not called" else {}
    r.run(4, **beyond)
    r.run(1, CAN_S1J=1, **beyond)
    assert not r.run(10, **beyond)["YL_SC"]


def test_a_train_that_the_signal_in_rear_has_told_clear_keeps_the_route_however_far_it_is() -> None:
    """A clear that goes back to caution just before a train passes it is not noticed any more: the train comes to the
    signal beyond, a kilometre on, at full speed (found by trains in metres)."""
    r = Running("passing_loop")
    line = {"LC_W": 1}  # the line to W is clear, and the neighbour there gives the direction when it is asked for
    r.run(1, REQ=r.number("S", "S3"), NN_W=1, **line)
    r.run(30, NN_W=1, **line)
    r.run(1, REQ=r.number("S3", "W"), NN_W=1, **line)
    out = r.run(30, NG_W=1, **line)
    assert out["YP_S"] and not out["YS_S3"]
    r.run(4, CLR_SJG=0, **line)
    r.run(1, CLR_SJG=0, CAN_S3=1, **line)
    held = [r.run(1, CLR_SJG=0, **line)["YL_1DG"] for _ in range(120)]
    assert all(held), "released ahead of a train that was told clear"
