"""What is to happen, in the order of time; at one time in the order in which it was planned."""

from __future__ import annotations

from collections.abc import Callable
from heapq import heappop, heappush
from math import ceil


def not_before(seconds: float) -> int:
    """The first millisecond at which the clock, in seconds, shows so many or more, however products are rounded."""
    ms = ceil(1000 * seconds)
    return ms if ms / 1000 >= seconds else ms + 1


class Agenda:
    """Things to be done at times in milliseconds.  A thing with a name replaces the one of that name before it."""

    def __init__(self) -> None:
        self.now_ms = 0
        self._count = 0
        self._heap: list[tuple[int, int, str, Callable[[], None]]] = []
        self._named: dict[str, int] = {}

    @property
    def clock(self) -> float:
        """Seconds."""
        return self.now_ms / 1000

    def at(self, time_ms: float, what: Callable[[], None], name: str = "") -> None:
        """Plan something; what is in the past is done next."""
        self._count += 1
        if name:
            self._named[name] = self._count
        heappush(self._heap, (max(self.now_ms, ceil(time_ms)), self._count, name, what))

    def after(self, seconds: float, what: Callable[[], None], name: str = "") -> None:
        """Plan something so many seconds from now."""
        self.at(self.now_ms + 1000 * seconds, what, name)

    def forget(self, name: str) -> None:
        """What was planned under a name is not to happen."""
        self._named.pop(name, None)

    def next_ms(self) -> int | None:
        """When something happens next."""
        while self._heap:
            time, count, name, _ = self._heap[0]
            if not name or self._named.get(name) == count:
                return time
            heappop(self._heap)
        return None

    def step(self) -> None:
        """Do what is next; the clock must stand at its time."""
        _, _, name, what = heappop(self._heap)
        if name:
            self._named.pop(name, None)
        what()
