"""Work beside work: what processes tell each other."""

from __future__ import annotations

import multiprocessing
import os
import signal
import time
from functools import partial

import pytest

from interlock.proof.engines.pool import NOTE, Board, run

NOTES = [bytes([n]) * NOTE for n in range(4)]


def test_a_note_is_seen_by_a_process_that_was_begun_before_it_was_written() -> None:
    board = Board()
    fork = multiprocessing.get_context("fork")
    ours, theirs = fork.Pipe()

    def look() -> None:
        theirs.recv()
        first = [n in board for n in NOTES[:3]]
        board.write(NOTES[2])
        theirs.send(first)

    process = fork.Process(target=look)
    process.start()
    board.write(NOTES[0])
    board.write(NOTES[1])
    assert NOTES[1] in board and NOTES[2] not in board
    ours.send(0)
    assert ours.poll(20) and ours.recv() == [True, True, False]
    process.join(20)
    assert [n in board for n in NOTES] == [True, True, True, False]


def test_what_finds_no_room_is_forgotten() -> None:
    board = Board(2)
    for n in NOTES:
        board.write(n)
    assert [n in board for n in NOTES] == [True, True, False, False]
    with pytest.raises(AssertionError):
        board.write(b"short")


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
