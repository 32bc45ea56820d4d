"""Work beside work: what becomes of tasks."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from types import FrameType

import pytest

from interlock.proof.engines.pool import Begun, run


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


@contextmanager
def within(seconds: int) -> Iterator[None]:
    """What hangs raises TimeoutError."""

    def late(number: int, frame: FrameType | None) -> None:
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize("beside", [1, 3])
def test_a_process_that_is_killed_while_it_tells_its_answer_is_noticed(beside: int) -> None:
    """The rest of the answer never comes: nobody waits for it."""
    own, told = os.getpid(), list[int]()

    def task(n: int) -> bytes:
        if os.getpid() == own:
            time.sleep(1.5)  # the pipe is full, and nobody reads it
            return b""
        if told:
            time.sleep(60)
        told.append(n)
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGKILL)).start()
        return bytes(1 << 24)

    tasks = [partial(task, n) for n in range(2 * beside + 1)]
    with within(20), pytest.raises(RuntimeError, match="has ended before"), Begun(tasks, beside) as begun:
        time.sleep(0.2)  # every process takes a task, and then another
        begun.results()


@pytest.mark.parametrize("code", [0, 1])
def test_a_process_that_ends_in_the_midst_of_a_task_is_noticed_at_once(code: int) -> None:
    """Its task is lost, whatever the others are still at, and whatever it says of itself."""

    def task(n: int) -> int:
        if n == 0:
            os._exit(code)
        time.sleep(60)
        return n

    for others in (0, 1):
        tasks = [partial(task, n) for n in range(1 + others)]
        with within(20), pytest.raises(RuntimeError, match="has ended before"), Begun(tasks, 1 + others) as begun:
            time.sleep(0.3)  # each has taken a task
            begun.results()


def test_a_process_goes_on_while_nobody_takes_its_answers() -> None:
    """Large ones too: its owner looks at them when its own task is done."""
    own = os.getpid()

    def task(n: int) -> tuple[bool, bytes]:
        if os.getpid() == own:
            time.sleep(1)
        return os.getpid() == own, bytes(1 << 20)

    with within(60), Begun([partial(task, n) for n in range(8)], 1) as begun:
        found = begun.results()
    assert sum(mine for mine, _ in found) <= 2 and all(answer == bytes(1 << 20) for _, answer in found)


def test_an_answer_that_cannot_be_told_is_raised() -> None:
    with within(20), pytest.raises(Exception, match="pickle"), Begun([lambda: lambda: 0], 1) as begun:
        time.sleep(0.3)
        begun.results()


def test_what_a_process_has_done_counts_when_it_has_ended_before_it_is_asked() -> None:
    with within(20), Begun([partial(pow, n, 2) for n in range(5)], 2) as begun:
        time.sleep(0.5)
        assert begun.results() == [0, 1, 4, 9, 16]
        with pytest.raises(RuntimeError):
            begun.results()


def test_processes_end_when_their_owner_is_gone() -> None:
    """Nobody hears the answer, so that the next task is not worth doing."""
    heard, alive = os.pipe()

    def task(n: int) -> bytes:
        if n:
            time.sleep(60)
        return bytes(1 << 20)

    def owner() -> None:
        Begun([partial(task, n) for n in range(2)], 1)
        time.sleep(0.5)
        os.kill(os.getpid(), signal.SIGKILL)

    process = multiprocessing.get_context("fork").Process(target=owner)
    process.start()
    os.close(alive)
    with within(20):
        process.join()
        assert os.read(heard, 1) == b""  # what is begun holds the other end
    os.close(heard)
