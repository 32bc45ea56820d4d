"""Independent pieces of work, on several processes where that is asked for."""

from __future__ import annotations

import multiprocessing
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from multiprocessing.context import ForkProcess
from queue import Empty
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

Task = Callable[[], Any]
"""A piece of work; its result can be pickled."""


def undisturbed() -> None:
    """An interrupt from the keyboard reaches all processes; it is for the first one, which ends the others: at once,
    whatever handler this one has inherited, since a handler would not run while a lock is waited for."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


class Begun:
    """Work that goes on in processes of their own beside what its owner does, until the end of a `with` block; what is
    not begun there when its results are asked for, and all of it without forks, its owner does."""

    def __init__(self, tasks: Sequence[Task], beside: int) -> None:
        """`beside`: the number of processes.  They are forks: they inherit what the tasks read."""
        self._tasks = tasks
        self._processes: list[ForkProcess] = []
        if beside > 0 and _forks():
            fork = multiprocessing.get_context("fork")
            self._next = fork.Value("i", 0)
            self._answers = fork.Queue()
            self._processes = [fork.Process(target=self._work, daemon=True) for _ in range(beside)]
            for process in self._processes:
                process.start()

    def _take(self) -> int | None:
        """The number of the first task that nobody has begun."""
        with self._next.get_lock():
            n = self._next.value
            self._next.value += 1
        return n if n < len(self._tasks) else None

    def _work(self) -> None:
        undisturbed()
        while (n := self._take()) is not None:
            try:
                self._answers.put((n, self._tasks[n](), None))
            except Exception as error:
                self._answers.put((n, None, error))

    def results(self, done: Callable[[int], None] = lambda n: None) -> list[Any]:
        """The results in the order of the tasks; raises what a task raised.  `done` is told each one's number."""
        found: dict[int, Any] = {}

        def note(n: int, result: Any) -> None:
            found[n] = result
            done(n)

        if not self._processes:
            for n, task in enumerate(self._tasks):
                note(n, task())
        else:
            while (own := self._take()) is not None:
                note(own, self._tasks[own]())
                while len(found) < len(self._tasks) and self._told(note, wait=False):
                    pass
            while len(found) < len(self._tasks):
                self._told(note, wait=True)
        return [found[n] for n in range(len(self._tasks))]

    def _told(self, note: Callable[[int, Any], None], wait: bool) -> bool:
        """Take an answer of the processes, if there is one."""
        codes = [p.exitcode for p in self._processes]  # before the last look: all that a process has told is there
        try:
            n, result, error = self._answers.get(timeout=1) if wait else self._answers.get_nowait()
        except Empty:
            if None not in codes or any(codes):
                raise RuntimeError("a process has ended before its work was done") from None
            return False
        if error is not None:
            raise error
        note(n, result)
        return True

    def __enter__(self) -> Begun:
        return self

    def __exit__(self, *error: object) -> None:
        """What is not done yet is given up."""
        for process in self._processes:
            process.terminate()
            process.join()


def _forks() -> bool:
    """Whether this process can be forked: not by every system, nor a worker of somebody's pool, which ends with it."""
    return "fork" in multiprocessing.get_all_start_methods() and not multiprocessing.current_process().daemon


def run(tasks: Sequence[Task], jobs: int, done: Callable[[int], None] = lambda n: None) -> list[Any]:
    """The results in the order of the tasks; long ones should come first.  `done` is told each one's number.

    One of the processes is this one.  Without forks, or for one job, the tasks run in turn.
    """
    with Begun(tasks, min(jobs, len(tasks)) - 1) as begun:
        return begun.results(done)


def apart(
    work: Callable[..., Any],
    calls: Sequence[tuple[object, ...]],
    jobs: int,
    done: Callable[[int], None] = lambda n: None,
) -> list[Any]:
    """Calls that share nothing, on processes of their own; the results are in the order of the calls.  `done` is told
    each one's number."""
    from concurrent.futures import as_completed

    with processes(min(jobs, len(calls))) as pool:
        begun = {pool.submit(work, *c): n for n, c in enumerate(calls)}
        for finished in as_completed(begun):
            done(begun[finished])
        return [f.result() for f in begun]


@contextmanager
def processes(jobs: int, method: str | None = None) -> Iterator[ProcessPoolExecutor]:
    """Processes of their own, begun by a `method` of `multiprocessing`.  No interrupt from the keyboard reaches them,
    from before they run a line of Python; whatever ends the `with` block in its midst ends them at once."""
    from concurrent.futures import ProcessPoolExecutor

    with ProcessPoolExecutor(jobs, multiprocessing.get_context(method), initializer=undisturbed) as pool:
        here = threading.current_thread() is threading.main_thread()
        before = signal.signal(signal.SIGINT, signal.SIG_IGN) if here else None
        try:
            for _ in range(jobs):
                pool.submit(undisturbed)  # begins a process
        finally:
            if before is not None:
                signal.signal(signal.SIGINT, before)
        try:
            yield pool
        except BaseException:
            for process in multiprocessing.active_children():
                process.terminate()
            pool.shutdown(cancel_futures=True)
            raise
