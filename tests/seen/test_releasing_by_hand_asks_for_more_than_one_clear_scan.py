"""A section is released by hand, by cancelling, or after a restart only when it has been clear without a break."""

from __future__ import annotations

import pytest

from interlock.logic.eval import Machine
from tests.layouts import built

SCAN_MS = 500


def drive(machine: Machine, scans: int, **inputs: int) -> dict[str, bool]:
    """Scans of half a second on an empty railway, points normal."""
    out: dict[str, bool] = {}
    for _ in range(scans):
        given = {i.name: 1 for i in machine.controller.inputs if i.name.startswith(("CLR_", "VALID", "DN_"))}
        given |= {i.name: 0 for i in machine.controller.inputs if i.name.startswith("BLK_")}
        out = machine.scan(given | inputs, SCAN_MS)
    return out


def held() -> Machine:
    """fig2_2, a route set, its train in DP when the inputs were lost for a scan: only a hand releases DP now."""
    _, _, controller = built("fig2_2")
    machine = Machine(controller)
    drive(machine, 2 * 600 + 4)
    drive(machine, 10, RELALL=1)
    drive(machine, 4, REQ=1)
    drive(machine, 4, CLR_SC=0, CLR_DP=0)
    drive(machine, 1, CLR_DP=0, VALID=0)
    assert drive(machine, 20, CLR_DP=0)["YL_DP"]
    return machine


def scans_of_the_delay() -> int:
    """Scans in the release delay."""
    layout, _, _ = built("fig2_2")
    return round(layout.principles.release_delay_s * 1000 / SCAN_MS)


def test_a_single_clear_reading_does_not_release_by_hand() -> None:
    machine = held()
    assert drive(machine, 1, REL_DP=1)["YL_DP"], "released under a train that lost its shunt for a scan"


@pytest.mark.parametrize("flicker", [2, 3])
def test_a_section_that_flickers_is_not_released(flicker: int) -> None:
    machine = held()
    for _ in range(10):
        drive(machine, 1, REL_DP=1, CLR_DP=0)
        assert drive(machine, min(flicker, scans_of_the_delay()), REL_DP=1)["YL_DP"]


def test_clear_without_a_break_it_is_released() -> None:
    machine = held()
    assert not drive(machine, scans_of_the_delay() + 3, REL_DP=1)["YL_DP"]


def test_a_single_clear_reading_does_not_release_after_a_restart() -> None:
    _, _, controller = built("fig2_2")
    machine = Machine(controller)
    drive(machine, 2 * 600 + 4, CLR_DP=0)
    assert drive(machine, 1, RELALL=1)["YL_DP"], "released under a train that lost its shunt for a scan"
    assert not drive(machine, scans_of_the_delay() + 3, RELALL=1)["YL_DP"]
