"""A machine that loses its detection without a command counts as trailed, whatever else happens then (R10)."""

from __future__ import annotations

from tests.layouts import built
from tests.test_release_behind import Bench

ROUTE, CLOSED = "X1-A", "YS_X1"


def bench() -> Bench:
    """`fig2_2`: from X1 the one point P1 leads to A, as it has lain since the restart."""
    return Bench(built("fig2_2")[2])


def commanded() -> Bench:
    """A route has commanded the point, and is given back."""
    b = bench()
    b.ask(ROUTE)
    assert not b.outputs[CLOSED]
    b.go(1, CAN_X1=1)
    b.go(200, CAN_X1=0)
    assert not b.outputs["YL_DP"] and not b.outputs["YT_P1"]
    return b


def kept_back(b: Bench) -> None:
    """Detection is back: no signal opens over the point before somebody has looked at it."""
    assert b.outputs["YT_P1"]
    b.ask(ROUTE)
    assert b.outputs[CLOSED]
    b.go(1, TC_P1=1)
    b.go(1, TC_P1=0)
    assert not b.outputs["YT_P1"]
    b.ask(ROUTE)
    assert not b.outputs[CLOSED]


def test_one_that_nobody_has_commanded_since_the_restart_counts_as_trailed() -> None:
    b = bench()
    b.go(5, DN_P1=0)
    b.go(5, DN_P1=1)
    kept_back(b)


def test_one_that_changes_over_between_two_scans_counts_as_trailed() -> None:
    b = bench()
    b.go(5, DN_P1=0, DR_P1=1)
    b.go(5, DN_P1=1, DR_P1=0)
    kept_back(b)


def test_one_that_is_run_through_while_inputs_are_lost_counts_as_trailed() -> None:
    b = commanded()
    b.go(0.2, VALID=0, DN_P1=0)
    b.go(5, VALID=1)
    b.go(5, DN_P1=1)
    kept_back(b)


def test_one_that_is_detected_as_before_when_inputs_come_back_does_not() -> None:
    b = commanded()
    b.go(5, VALID=0, DN_P1=0)
    b.go(5, VALID=1, DN_P1=1)
    assert not b.outputs["YT_P1"]


def test_before_the_restart_delay_is_over_nobody_has_looked_at_the_points() -> None:
    """Contacts come one after the other when cabinets are switched on; whoever releases sections looks at them all."""
    b = bench()
    b.controller = type(b.controller)()
    b.go(5, DN_P1=1)
    b.go(5, DN_P1=0)
    b.go(5, DN_P1=1)
    assert b.outputs["YL_DP"] and not b.outputs["YT_P1"]
