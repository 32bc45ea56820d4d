"""Where a train loses its shunt for a moment, nothing is shown, locked, moved or given back for it.

Seen by trains in metres: a route was cancelled in the very moment in which the section before its signal read clear,
and was given back at once under the eyes of a driver who ran towards it; a signal opened over a section in which
wagons stood that read clear for a second.
"""

from __future__ import annotations

from interlock.logic.eval import Machine
from tests.layouts import built
from tests.seen.test_releasing_by_hand_asks_for_more_than_one_clear_scan import drive, scans_of_the_delay


def released() -> Machine:
    """fig2_2 long after a restart, its section released, points normal."""
    _, _, controller = built("fig2_2")
    machine = Machine(controller)
    drive(machine, 2 * 600 + 4)
    drive(machine, 10, RELALL=1)
    return machine


def test_a_route_is_not_cancelled_at_once_for_a_moment_of_clear_in_the_approach() -> None:
    machine = released()
    assert drive(machine, 6, REQ=1, CLR_SC=0)["YL_DP"]
    drive(machine, 2, CAN_X1=1)  # the train before X1 is lost for two scans, a second in all
    assert drive(machine, 20, CLR_SC=0)["YL_DP"], "given back at once, though a train runs towards the signal"


def test_with_the_approach_steadily_clear_it_is_cancelled_at_once() -> None:
    machine = released()
    assert drive(machine, 6, REQ=1)["YL_DP"]
    assert not drive(machine, 3, CAN_X1=1)["YL_DP"]


def test_no_signal_opens_over_a_section_that_reads_clear_for_a_moment() -> None:
    machine = released()
    drive(machine, 20, CLR_DP=0)
    for _ in range(10):
        drive(machine, 2, CLR_DP=0)
        for _ in range(min(3, scans_of_the_delay())):
            out = drive(machine, 1, REQ=1)
            assert not any(out[f"Y{lamp}_X1"] for lamp in "GY" if f"Y{lamp}_X1" in out)
            assert not out["YL_DP"], "locked for a train while wagons stand in it"


def test_no_point_moves_while_a_section_reads_clear_for_a_moment() -> None:
    machine = released()
    drive(machine, 20, CLR_DP=0)
    for _ in range(10):
        drive(machine, 2, CLR_DP=0)
        assert not any(drive(machine, 1, MR_P1=1)[n] for n in ("YN_P1", "YR_P1")), "driven under wagons"
