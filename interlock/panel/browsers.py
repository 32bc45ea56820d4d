"""Whoever looks on: told after a cycle what has changed, all by one text."""

from __future__ import annotations

import json
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from typing import Any

from interlock.app.run import since_boot
from interlock.panel.event import Event
from interlock.panel.picture import Shown

EVENTS = 200
"""Events that a browser is told when it comes."""

TELL_S = 0.05
"""Seconds between two messages at least, where simulated time runs fast."""

Listener = Callable[[str], None]


def sent(message: Mapping[str, Any]) -> str:
    """A message as it is sent.  Half a surrogate, as in the name of a file, would reach nobody: it becomes `?`."""
    return json.dumps(message, ensure_ascii=False, separators=(",", ":")).encode(errors="replace").decode()


_BEGAN = time.time() - since_boot()


def now_s() -> float:
    """The clock here, by which ages are reckoned: the time on the wall when the program was started, and the seconds
    since.  Nobody sets it."""
    return _BEGAN + since_boot()


def clock(mark: int | str | None) -> str:
    """The answer to a browser that asks for the clock here: the ages of what it is told are reckoned by it."""
    return sent({"re": mark, "clock": now_s()})


class Browsers:
    """Of one desk.  still: what never changes; shown: what was told last of each element; rest: of all else."""

    def __init__(self, still: dict[str, Any], shown: Shown, rest: dict[str, Any]) -> None:
        self.still, self.shown = still, shown
        self.events: deque[Event] = deque(maxlen=EVENTS)
        self._other = rest
        self._numbers = 0
        self._lock = threading.Lock()
        self._fresh: list[Event] = []
        self._listeners: set[Listener] = set()
        self._told_at = 0.0

    def note(self, event: Event) -> None:
        """Something has happened: it gets its number, and is told with the next message."""
        self._numbers += 1
        event.number = self._numbers
        self._fresh.append(event)

    def listen(self, listener: Listener) -> dict[str, Any]:
        """From now on tell somebody what changes; everything as it is now."""
        with self._lock:
            self._listeners.add(listener)
            return {
                "still": self.still,
                "t": now_s(),
                "c": self.shown,
                "events": [e.told() for e in self.events],
                **self._other,
            }

    def forget(self, listener: Listener) -> None:
        """Tell somebody nothing more."""
        with self._lock:
            self._listeners.discard(listener)

    def tell(self, shown: Shown, rest: Callable[[], dict[str, Any]]) -> None:
        """What is shown now, and the rest, which belongs to no element; not more often than every `TELL_S`."""
        now = time.monotonic()
        if now - self._told_at < TELL_S:
            return
        self._told_at = now
        other = rest()
        with self._lock:
            message: dict[str, Any] = {k: v for k, v in other.items() if self._other.get(k) != v}
            message["c"] = {k: v for k, v in shown.items() if self.shown.get(k) != v}
            message["t"] = now_s()
            if self._fresh:
                message["events"] = [e.told() for e in self._fresh]
                self.events.extend(self._fresh)
                self._fresh = []
            self.shown, self._other = shown, other
            if self._listeners:
                text = sent(message)
                for listener in self._listeners:
                    listener(text)
