"""Independent pieces of work, on several processes where that is asked for."""

from __future__ import annotations

import mmap
import multiprocessing
from collections.abc import Callable, Sequence
from multiprocessing.context import ForkProcess
from queue import Empty
from typing import Any

Task = Callable[[], Any]
"""A piece of work; its result can be pickled."""

NOTE = 32  # bytes

_tasks: Sequence[Task] = ()


def _work(n: int) -> tuple[int, Any]:
    return n, _tasks[n]()


class Begun:
    """Work that goes on in a process of its own beside what its owner does, until the end of a `with` block; what is
    not begun there when its results are asked for, and all of it without forks, its owner does."""

    def __init__(self, tasks: Sequence[Task], jobs: int) -> None:
        """`jobs`: one process only means no process beside it."""
        self._tasks = tasks
        self._process: ForkProcess | None = None
        if jobs > 1 and _forks():
            fork = multiprocessing.get_context("fork")
            self._next = fork.Value("i", 0)
            self._answers = fork.Queue()
            self._process = fork.Process(target=self._work, daemon=True)
            self._process.start()

    def _take(self) -> int | None:
        """The number of the first task that nobody has begun."""
        with self._next.get_lock():
            n = self._next.value
            self._next.value += 1
        return n if n < len(self._tasks) else None

    def _work(self) -> None:
        while (n := self._take()) is not None:
            try:
                self._answers.put((n, self._tasks[n](), None))
            except Exception as error:
                self._answers.put((n, None, error))

    def results(self) -> list[Any]:
        """The results in the order of the tasks; raises what a task raised."""
        if self._process is None:
            return [task() for task in self._tasks]
        found: dict[int, Any] = {}
        while (n := self._take()) is not None:
            found[n] = self._tasks[n]()
        while len(found) < len(self._tasks):
            alive = self._process.is_alive()
            try:
                n, result, error = self._answers.get(timeout=1)
            except Empty:
                if alive:
                    continue
                raise RuntimeError("a process has ended before its work was done") from None
            if error is not None:
                raise error
            found[n] = result
        return [found[n] for n in range(len(self._tasks))]

    def __enter__(self) -> Begun:
        return self

    def __exit__(self, *error: object) -> None:
        """What is not done yet is given up."""
        if self._process is not None:
            self._process.terminate()
            self._process.join()


class Board:
    """Notes of 32 bytes that processes share: each sees what another wrote, if both were begun after the board."""

    def __init__(self, most: int = 4096) -> None:
        """`most`: notes; what is written after that many is forgotten."""
        self._most = most
        self._notes = mmap.mmap(-1, NOTE * most)
        fork = multiprocessing.get_context("fork" if _forks() else None)
        self._count = fork.Value("i", 0)
        self._read = 0
        self._seen: set[bytes] = set()

    def write(self, note: bytes) -> None:
        """Tell all others."""
        assert len(note) == NOTE
        with self._count.get_lock():
            n = self._count.value
            if n < self._most:
                self._notes[NOTE * n : NOTE * (n + 1)] = note
                self._count.value += 1

    def __contains__(self, note: object) -> bool:
        """Whether it was written."""
        with self._count.get_lock():
            count = self._count.value
        for n in range(self._read, count):
            self._seen.add(self._notes[NOTE * n : NOTE * (n + 1)])
        self._read = count
        return note in self._seen


def _forks() -> bool:
    return "fork" in multiprocessing.get_all_start_methods()


def run(tasks: Sequence[Task], jobs: int, done: Callable[[int], None] = lambda n: None) -> list[Any]:
    """The results in the order of the tasks; long ones should come first.  `done` is told each one's number.

    The processes are forks: they inherit what the tasks read.  Without forks, or for one job, the tasks run in turn.
    """
    global _tasks
    results: list[Any] = [None] * len(tasks)
    if jobs < 2 or len(tasks) < 2 or not _forks():
        for n, task in enumerate(tasks):
            results[n] = task()
            done(n)
        return results
    _tasks = tasks
    with multiprocessing.get_context("fork").Pool(min(jobs, len(tasks))) as pool:
        for n, result in pool.imap_unordered(_work, range(len(tasks))):
            results[n] = result
            done(n)
    _tasks = ()
    return results
