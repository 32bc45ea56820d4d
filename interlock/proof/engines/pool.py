"""Independent pieces of work, on several processes where that is asked for."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from multiprocessing import connection
from multiprocessing.connection import Connection
from multiprocessing.context import ForkProcess
from queue import SimpleQueue
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
    not begun there when its results are asked for, and all of it without forks, its owner does.

    Each process tells its answers through a pipe of its own, which ends with it, also in the midst of an answer.
    """

    def __init__(self, tasks: Sequence[Task], beside: int) -> None:
        """`beside`: the number of processes.  They are forks: they inherit what the tasks read."""
        self._tasks = tasks
        self._processes: list[ForkProcess] = []
        self._pipes: list[Connection] = []
        if beside > 0 and _forks():
            fork = multiprocessing.get_context("fork")
            self._next = fork.Value("i", 0)
            for _ in range(beside):
                pipe, end = fork.Pipe(duplex=False)
                process = fork.Process(target=self._work, args=(pipe, end), daemon=True)
                process.start()
                end.close()  # before the next fork: nobody else holds it
                self._processes.append(process)
                self._pipes.append(pipe)

    def _take(self) -> int | None:
        """The number of the first task that nobody has begun."""
        with self._next.get_lock():
            n = self._next.value
            self._next.value += 1
        return n if n < len(self._tasks) else None

    def _work(self, pipe: Connection, end: Connection) -> None:
        """Do tasks while there are some; answers are told beside it, since their owner may be at a task of its own."""
        undisturbed()
        pipe.close()
        answers: SimpleQueue[bytes] = SimpleQueue()
        telling = threading.Thread(target=_tell, args=(answers, end), daemon=True)
        telling.start()
        while (n := self._take()) is not None:
            answers.put(_answer(n, self._tasks[n]))
        answers.put(_DONE)
        telling.join()

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
                while self._told(note, wait=False):
                    pass
            while len(found) < len(self._tasks):
                self._told(note, wait=True)
        return [found[n] for n in range(len(self._tasks))]

    def _told(self, note: Callable[[int, Any], None], wait: bool) -> bool:
        """Take the answers that the processes have begun to tell; whether there were some."""
        if wait and not self._pipes:
            raise RuntimeError("what no process does any more is waited for")
        ready = connection.wait(self._pipes, None if wait else 0)
        for pipe in [p for p in self._pipes if p in ready]:
            try:
                answer = pipe.recv_bytes()
            except (EOFError, OSError):
                raise RuntimeError("a process has ended before its work was done") from None
            if answer == _DONE:
                self._pipes.remove(pipe)
                pipe.close()
                continue
            n, result, error = pickle.loads(answer)
            if error is not None:
                raise error
            note(n, result)
        return bool(ready)

    def __enter__(self) -> Begun:
        return self

    def __exit__(self, *error: object) -> None:
        """What is not done yet is given up."""
        for process in self._processes:
            process.terminate()
            process.join()
        for pipe in self._pipes:
            pipe.close()


_DONE = b""
"""What a process tells last."""


def _tell(answers: SimpleQueue[bytes], end: Connection) -> None:
    """Tell answers as they come, until the last; where nobody hears them the process ends."""
    while True:
        answer = answers.get()
        try:
            end.send_bytes(answer)
        except OSError:
            os._exit(1)
        if answer == _DONE:
            return


def _answer(n: int, task: Task) -> bytes:
    """The result of the task of a number, or what it raised."""
    try:
        return pickle.dumps((n, task(), None), pickle.HIGHEST_PROTOCOL)
    except Exception as error:
        return pickle.dumps((n, None, error), pickle.HIGHEST_PROTOCOL)


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
