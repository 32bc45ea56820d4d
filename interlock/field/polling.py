"""How substations are asked: in turn, or beside each other, so that one that does not answer holds nobody up."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor, wait
from typing import Any, Protocol

Call = Callable[[], Any]

LIMIT_S = 0.2
"""Seconds for which a substation is waited for in a cycle (our choice)."""

LAST_S = 1.0
"""The same for the last words of a run."""


class LinkLost(Exception):
    """A substation did not answer, or not as it should."""


class Poll(Protocol):
    """A way of asking substations."""

    def ask(self, calls: Mapping[str, Call], last: bool = False) -> dict[str, Any]:
        """What each call gives, or the `LinkLost` that it raises.  `last`: nothing will be asked any more."""
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


class Beside:
    """Each substation in a thread of its own, all for a limited time.

    What comes later is thrown away: it says how things were in an earlier cycle.  A substation that was lost is asked
    again and again, and waited for only after it has answered once: so it costs the others its time once, not in each
    cycle.  A call that is still under way is not joined by a second one.
    """

    def __init__(self, limit_s: float = LIMIT_S, now: Callable[[], float] = time.monotonic) -> None:
        self.limit_s, self.now = limit_s, now
        self._threads: dict[str, ThreadPoolExecutor] = {}
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
                self._under_way[name] = self._thread(name).submit(_answer, call)
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

    def _thread(self, name: str) -> ThreadPoolExecutor:
        if name not in self._threads:
            self._threads[name] = ThreadPoolExecutor(1, f"substation {name}")
        return self._threads[name]

    def close(self) -> None:
        """See `Poll`.  Calls that are under way end by their own limits."""
        for thread in self._threads.values():
            thread.shutdown(wait=True, cancel_futures=True)
