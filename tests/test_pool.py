"""Work beside work: what becomes of tasks."""

from __future__ import annotations

import os
import signal
import time
from functools import partial

import pytest

from interlock.proof.engines.pool import run


@pytest.mark.parametrize("jobs", [1, 2, 4])
def test_results_stand_in_the_order_of_the_tasks_and_each_is_told_once(jobs: int) -> None:
    told: list[int] = []

    def task(n: int) -> int:
        time.sleep(0.002 * (n % 3))
        return n * n

    assert run([partial(task, n) for n in range(20)], jobs, told.append) == [n * n for n in range(20)]
    assert sorted(told) == list(range(20))
    assert run([], jobs) == []


@pytest.mark.parametrize("jobs", [1, 3])
def test_what_a_task_raises_is_raised(jobs: int) -> None:
    def task(n: int) -> int:
        if n == 5:
            raise ValueError("five")
        return n

    with pytest.raises(ValueError, match="five"):
        run([partial(task, n) for n in range(9)], jobs)


def test_a_process_that_is_killed_is_noticed() -> None:
    """With what it had begun nobody is left who could do it."""
    own = os.getpid()

    def task(n: int) -> int:
        if os.getpid() != own:
            os.kill(os.getpid(), signal.SIGKILL)
        time.sleep(0.05)
        return n

    with pytest.raises(RuntimeError, match="has ended before"):
        run([partial(task, n) for n in range(6)], 2)
