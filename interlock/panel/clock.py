"""The clock of a simulated railway: it runs up to sixty times as fast as the one on the wall."""

from __future__ import annotations

import time
from collections.abc import Callable

SPEEDS = (1, 2, 5, 10, 60)
"""How many times as fast as on the wall."""

MOST_S = 0.4
"""Simulated seconds that pass at most between two looks at the clock: whatever else the computer does meanwhile, the
controller's cycle is not too long for it."""


class Clock:
    """Seconds of simulated time, and sleep in them."""

    def __init__(self, wall: Callable[[], float] = time.monotonic) -> None:
        """`wall`: seconds by the clock on the wall."""
        self.speed, self._look = 1, wall
        self._wall, self._now = wall(), 0.0

    def now(self) -> float:
        """Seconds since it was made."""
        wall = self._look()
        self._now += min((wall - self._wall) * self.speed, MOST_S)
        self._wall = wall
        return self._now

    def sleep(self, seconds: float) -> None:
        """Let so much simulated time pass."""
        time.sleep(seconds / self.speed)
