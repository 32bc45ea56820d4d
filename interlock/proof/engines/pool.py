"""Independent pieces of work, on several processes where that is asked for."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future, as_completed
from contextlib import contextmanager, suppress
from functools import partial
from multiprocessing import connection
from multiprocessing.connection import Connection
from multiprocessing.context import ForkProcess
from multiprocessing.process import BaseProcess
from queue import SimpleQueue
from typing import Any

from interlock.exceptions import Ended

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
        self._of: list[Connection] = []
        """The pipe of each process, also when it has told its last answer."""
        if beside > 0 and _forks():
            with suppress(OSError):  # no place for what they share, no file or process more: the owner does the rest
                self._begin(beside)
        self._of += self._pipes

    def _begin(self, beside: int) -> None:
        """Begin processes.  Raises OSError where the system has no room for another."""
        fork = multiprocessing.get_context("fork")
        self._next = fork.Value("i", 0)
        for _ in range(beside):
            pipe, end = fork.Pipe(duplex=False)
            process = fork.Process(target=self._work, args=(pipe, end), daemon=True)
            with end:  # closed before the next fork: nobody else holds it
                process.start()
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
                process = self._processes[self._of.index(pipe)]
                raise ended(process) from None
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
        try:
            return pickle.dumps((n, None, error), pickle.HIGHEST_PROTOCOL)
        except Exception:
            told = RuntimeError(f"{type(error).__name__}: {error}")
            return pickle.dumps((n, None, told), pickle.HIGHEST_PROTOCOL)


def _forks() -> bool:
    """Whether this process can be forked: not by every system, nor a worker of somebody's pool, which ends with it."""
    return "fork" in multiprocessing.get_all_start_methods() and not multiprocessing.current_process().daemon


def run(tasks: Sequence[Task], jobs: int, done: Callable[[int], None] = lambda n: None) -> list[Any]:
    """The results in the order of the tasks; long ones should come first.  `done` is told each one's number.

    One of the processes is this one.  Without forks, or for one job, the tasks run in turn.
    """
    with Begun(tasks, min(jobs, len(tasks)) - 1) as begun:
        return begun.results(done)


def ended(process: BaseProcess) -> Ended:
    """What is said of a process that has ended before its work was done."""
    process.join(ENDS_S)
    code = process.exitcode
    if code is None or code >= 0:
        return Ended(f"a process has ended before its work was done (exit code {code})")
    name = next((s.name for s in signal.Signals if s == -code), f"signal {-code}")
    memory = ", as when memory runs out: try fewer jobs" if name == "SIGKILL" else ""
    return Ended(f"a process has ended before its work was done ({name}{memory})")


ENDS_S = 5.0
"""So long is waited for the exit code of a process that has closed its pipe."""


class Pool(Executor):
    """Calls on processes of their own, each with a pipe of its own, which ends with it, also in the midst of an answer:
    then all that is not done raises `Ended`, since the process is likely to be killed again wherever that is done.
    """

    def __init__(self, jobs: int, method: str | None) -> None:
        context = multiprocessing.get_context(method)
        self._calls: SimpleQueue[tuple[Future[Any], bytes] | None] = SimpleQueue()
        self._ended: Ended | None = None
        self._closed = False
        self._processes: list[BaseProcess] = []
        self._pipes: list[Connection] = []
        for _ in range(jobs):
            pipe, end = context.Pipe()
            self._pipes.append(pipe)
            inherited = self._pipes if context.get_start_method() == "fork" else []
            process = context.Process(target=_serve, args=(end, inherited), daemon=True)  # type: ignore[attr-defined]
            process.start()
            end.close()  # before the next one: nobody else holds it
            self._processes.append(process)
        both = zip(self._processes, self._pipes, strict=True)
        self._attending = [threading.Thread(target=self._attend, args=x, daemon=True) for x in both]
        for thread in self._attending:
            thread.start()

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Have a call done when a process is free."""
        if self._closed:
            raise RuntimeError("the pool is closed")
        future: Future[Any] = Future()
        self._calls.put((future, pickle.dumps((fn, args, kwargs), pickle.HIGHEST_PROTOCOL)))
        return future

    def _attend(self, process: BaseProcess, pipe: Connection) -> None:
        """Hand calls to a process, one after the other, and take its answers."""
        while (asked := self._calls.get()) is not None:
            future, call = asked
            if not future.set_running_or_notify_cancel():
                continue
            if self._ended is not None:
                future.set_exception(self._ended)
                continue
            try:
                pipe.send_bytes(call)
                answer = pipe.recv_bytes()
            except (EOFError, OSError):
                self._ended = self._ended or ended(process)
                self.end()
                future.set_exception(self._ended)
                continue
            result, error = _read(answer)
            if error is not None:
                future.set_exception(error)
            else:
                future.set_result(result)

    def end(self) -> None:
        """End the processes in the midst of their work."""
        for process in self._processes:
            process.terminate()

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """No more calls; those that were asked for are done, or given up."""
        self._closed = True
        while cancel_futures and not self._calls.empty():
            asked = self._calls.get()
            if asked is not None:
                asked[0].cancel()
        for _ in self._attending:
            self._calls.put(None)
        for thread in self._attending if wait else ():
            thread.join()
        for pipe in self._pipes if wait else ():
            pipe.close()
        for process in self._processes if wait else ():
            process.join()


def _read(answer: bytes) -> tuple[Any, Exception | None]:
    """What a call has returned or raised; an exception may be none that can be read again."""
    try:
        _, result, error = pickle.loads(answer)
    except Exception as unreadable:
        return None, unreadable
    return result, error


def _serve(end: Connection, inherited: Sequence[Connection]) -> None:
    """Do calls until nobody asks any more; `inherited`: what a fork holds and must not, or nobody would notice the end
    of the process that asks."""
    undisturbed()
    for pipe in inherited:
        pipe.close()
    while True:
        try:
            call = end.recv_bytes()
        except (EOFError, OSError):
            return
        answer = _answer(0, partial(_called, call))
        try:
            end.send_bytes(answer)
        except OSError:
            return


def _called(call: bytes) -> Any:
    work, args, kwargs = pickle.loads(call)
    return work(*args, **kwargs)


def apart(
    work: Callable[..., Any],
    calls: Sequence[tuple[object, ...]],
    jobs: int,
    done: Callable[[int], None] = lambda n: None,
) -> list[Any]:
    """Calls that share nothing, on processes of their own; the results are in the order of the calls.  `done` is told
    each one's number."""
    with processes(min(jobs, len(calls))) as pool:
        begun = {pool.submit(work, *c): n for n, c in enumerate(calls)}
        for finished in as_completed(begun):
            done(begun[finished])
        return [f.result() for f in begun]


@contextmanager
def processes(jobs: int, method: str | None = None) -> Iterator[Pool]:
    """Processes of their own, begun by a `method` of `multiprocessing`.  No interrupt from the keyboard reaches them,
    from before they run a line of Python; whatever ends the `with` block in its midst ends them at once."""
    here = threading.current_thread() is threading.main_thread()
    before = signal.signal(signal.SIGINT, signal.SIG_IGN) if here else None
    try:
        pool = Pool(jobs, method)
    finally:
        if before is not None:
            signal.signal(signal.SIGINT, before)
    try:
        yield pool
    except BaseException:
        pool.end()
        pool.shutdown(cancel_futures=True)
        raise
    pool.shutdown()
