"""How substations are asked: in turn, or beside each other, so that one that does not answer holds nobody up."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from concurrent.futures import Future, wait
from queue import SimpleQueue
from threading import Thread
from typing import Any, Protocol

Call = Callable[[], Any]

LIMIT_S = 0.2
"""Seconds for which a substation is waited for in a cycle (our choice)."""

LAST_S = 1.0
"""The same for the last words of a run."""

CLOSE_S = 1.0
"""Seconds for which calls that are still under way then are waited for."""


class LinkLost(Exception):
    """A substation did not answer, or not as it should."""


class Poll(Protocol):
    """A way of asking substations."""

    def ask(self, calls: Mapping[str, Call], last: bool = False) -> dict[str, Any]:
        """What each call gives, or a `LinkLost` where it raises anything: nothing that happens with one substation
        keeps the others from being asked.  `last`: nothing will be asked any more."""
        ...

    def close(self) -> None:
        """Nothing is asked any more."""
        ...


class InTurn:
    """One after the other: for substations that answer at once."""

    def ask(self, calls: Mapping[str, Call], last: bool = False) -> dict[str, Any]:
        """See `Poll`."""
        del last
        return {name: _answer(call) for name, call in calls.items()}

    def close(self) -> None:
        """See `Poll`."""


def _answer(call: Call) -> Any:
    try:
        return call()
    except LinkLost as lost:
        return lost
    except Exception as error:  # whatever it is: the others are asked and written all the same
        return LinkLost(f"it cannot be asked: {in_short(error)}")


def in_short(error: Exception) -> str:
    """An exception that nobody has foreseen, on one line."""
    return f"{type(error).__name__}: {error}".replace("\n", " ")


class _Worker:
    """The thread of a substation: one call after the other.  The process may end while one of them hangs."""

    def __init__(self, name: str) -> None:
        self._calls: SimpleQueue[tuple[Future[Any], Call] | None] = SimpleQueue()
        self._thread = Thread(target=self._work, name=f"substation {name}", daemon=True)
        self._given_up = False
        self._thread.start()

    def submit(self, call: Call) -> Future[Any]:
        """What the call gives, once it has had its turn."""
        future: Future[Any] = Future()
        self._calls.put((future, call))
        return future

    def _work(self) -> None:
        while (one := self._calls.get()) is not None and not self._given_up:
            future, call = one
            future.set_result(_answer(call))

    def ends(self) -> None:
        """Nothing comes any more."""
        self._calls.put(None)

    def wait(self, seconds: float) -> None:
        """Until all is done, for so long at most; what has not begun by then is not done any more."""
        self._thread.join(seconds)
        self._given_up = True


class Beside:
    """Each substation in a thread of its own, all for a limited time.

    What comes later is thrown away: it says how things were in an earlier cycle.  A substation that was lost is asked
    again and again, and waited for only after it has answered once: so it costs the others its time once, not in each
    cycle.  A call that is still under way is not joined by a second one.
    """

    def __init__(self, limit_s: float = LIMIT_S, now: Callable[[], float] = time.monotonic) -> None:
        self.limit_s, self.now = limit_s, now
        self._workers: dict[str, _Worker] = {}
        self._under_way: dict[str, Future[Any]] = {}
        self._lost: dict[str, LinkLost] = {}

    def ask(self, calls: Mapping[str, Call], last: bool = False) -> dict[str, Any]:
        """See `Poll`."""
        until = self.now() + (LAST_S if last else self.limit_s)
        out: dict[str, Any] = {}
        for name, call in calls.items():
            before = self._under_way.get(name)
            if before is not None and before.done() and not isinstance(before.result(), LinkLost):
                self._lost.pop(name, None)
            if before is None or before.done() or last:
                self._under_way[name] = self._submit(name, call)
            if name in self._lost and not last:
                out[name] = self._lost[name]
        for name in calls:
            if name not in out:
                out[name] = self._result(name, until)
                if isinstance(out[name], LinkLost):
                    self._lost[name] = out[name]
        return out

    def _result(self, name: str, until: float) -> Any:
        future = self._under_way[name]
        done, _ = wait((future,), max(0.0, until - self.now()))
        return future.result() if done else LinkLost("no answer in time")

    def _submit(self, name: str, call: Call) -> Future[Any]:
        try:
            if name not in self._workers:
                self._workers[name] = _Worker(name)
            return self._workers[name].submit(call)
        except RuntimeError as error:  # the system gives no more threads
            failed: Future[Any] = Future()
            failed.set_result(LinkLost(f"it cannot be asked: {in_short(error)}"))
            return failed

    def close(self) -> None:
        """See `Poll`.  Calls that are under way end by their own limits; one that has none, such as a name that is
        looked up, is left behind."""
        until = time.monotonic() + CLOSE_S
        for worker in self._workers.values():
            worker.ends()
        for worker in self._workers.values():
            worker.wait(max(0.0, until - time.monotonic()))
