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


def run(tasks: Sequence[Task], jobs: int, done: Callable[[int], None] = lambda n: None) -> list[Any]:
    """The results in the order of the tasks; long ones should come first.  `done` is told each one's number.

    The processes are forks: they inherit what the tasks read.  Without forks, or for one job, the tasks run in turn.
    """
    global _tasks
    results: list[Any] = [None] * len(tasks)
    if jobs < 2 or len(tasks) < 2 or "fork" not in multiprocessing.get_all_start_methods():
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
