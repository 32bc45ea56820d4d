"""The clock of a simulated railway: it runs up to sixty times as fast as the one on the wall."""

from __future__ import annotations

import time
from collections.abc import Callable

SPEEDS = (1, 2, 5, 10, 60)
"""How many times as fast as on the wall."""

MOST_S = 0.4
"""Simulated seconds that pass at most from one cycle to the next: however busy the computer is, the controller's cycle
is not too long for it (R16), and it sees what the trains do meanwhile (A-SCAN).  Simulated time then runs slower than
it was asked to."""


class Clock:
    """Seconds of simulated time, and sleep in them.  A cycle begins with the first look at the clock after a sleep."""

    def __init__(
        self,
        most_s: float = MOST_S,
        wall: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        """`most_s`: simulated seconds of a cycle at most.  `wall`, `sleep`: the clock on the wall, in seconds."""
        self.speed, self.most_s, self._look, self._sleep = 1, most_s, wall, sleep
        self._wall, self._now, self._until = wall(), 0.0, most_s
        self._begins = True

    def now(self) -> float:
        """Seconds since it was made."""
        wall = self._look()
        if self._begins:
            self._begins, self._until = False, self._now + self.most_s
        else:
            self._now = min(self._now + (wall - self._wall) * self.speed, self._until)
        self._wall = wall
        return self._now

    def sleep(self, seconds: float) -> None:
        """Let so much simulated time pass; the next look at the clock begins a cycle."""
        self._sleep(seconds / self.speed)
        self.now()
        self._begins = True
