"""Independent pieces of work, on several processes where that is asked for."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Sequence
from typing import Any

Task = Callable[[], Any]
"""A piece of work; its result can be pickled."""

_tasks: Sequence[Task] = ()


def _work(n: int) -> tuple[int, Any]:
    return n, _tasks[n]()


class Begun:
    """Work that goes on in a process of its own beside what its owner does, until the end of a `with` block; without
    forks it is done when its results are asked for."""

    def __init__(self, tasks: Sequence[Task], jobs: int) -> None:
        """`jobs`: one process only means no process beside it."""
        global _tasks
        self._tasks, self._pool, self._answers = tasks, None, []
        if jobs > 1 and _forks():
            _tasks = tasks
            self._pool = multiprocessing.get_context("fork").Pool(1)
            _tasks = ()
            self._answers = [self._pool.apply_async(_work, (n,)) for n in range(len(tasks))]

    def results(self) -> list[Any]:
        """The results in the order of the tasks."""
        if self._pool is None:
            return [task() for task in self._tasks]
        return [answer.get()[1] for answer in self._answers]

    def __enter__(self) -> Begun:
        return self

    def __exit__(self, *error: object) -> None:
        """What is not done yet is given up."""
        if self._pool is not None:
            self._pool.terminate()


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
