"""What a run counts as time: never more than has passed, and with what a sleeping computer slept (A-CLOCK, R16)."""

from __future__ import annotations

import time
from contextlib import closing
from itertools import accumulate

import pytest

from interlock.app.run import Ready, run, since_boot
from interlock.field.plc import LATE_CYCLE, Cycle
from interlock.panel.desk import Desk
from tests.panels import AUTOMATIC, unproved


@pytest.fixture(scope="module")
def line() -> Ready:
    return unproved(AUTOMATIC)


@pytest.mark.parametrize("period", [0.0102, 0.0104999, 0.0105, 0.01051, 0.0109, 0.1006, 0.3333333])
def test_of_many_cycles_no_more_time_is_counted_than_has_passed(line: Ready, period: float) -> None:
    """Each cycle's milliseconds were rounded by themselves: 10.51 ms counted 11, and a delay of 600 s was over after
    573 s."""
    now, counted, links = [1000.0], list[int](), Desk(line).links

    def ask(last: Cycle | None, passed_ms: int) -> dict[str, int]:
        counted.append(passed_ms)
        return {}

    def sleep(seconds: float) -> None:
        now[0] += period

    with closing(run(line, links, 10, 400, ask, lambda: now[0], sleep)) as cycles:
        assert all(cycle is not None for cycle, _ in cycles)
    for k, total in enumerate(accumulate(counted[1:]), 1):
        assert 0 <= 1000 * period * k - total < 1.001, (k, total)


def test_a_cycle_that_the_computer_slept_through_was_too_long(line: Ready, monkeypatch: pytest.MonkeyPatch) -> None:
    """The usual clock stands still meanwhile: the cycle looked like any other."""
    slept = [0.0]
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.setattr(time, "CLOCK_BOOTTIME", 7, raising=False)
    monkeypatch.setattr(time, "clock_gettime", lambda which: time.monotonic() + slept[0], raising=False)
    with closing(run(line, Desk(line).links, 10, 3, lambda last, ms: {}, since_boot)) as cycles:
        lost = []
        for cycle, _ in cycles:
            lost.append(any(LATE_CYCLE in x for x in cycle.lost))
            slept[0] = 3600.0
    assert lost == [False, True, False]
    monkeypatch.setattr("sys.platform", "darwin")
    assert abs(since_boot() - time.monotonic()) < 1.0
