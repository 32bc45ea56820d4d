"""Lines that wait for a cycle: those that are typed one for each, but to stop or to cancel waits for none of them."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Iterator

from interlock.app.run import LATE_S, spoken
from interlock.dataclass import dataclass

MOST = 100
"""Lines that are kept (our choice); one more is refused at once, but to stop or to cancel."""

Reply = Callable[[bool], None]


@dataclass(frozen=True)
class Line:
    """What was typed, or asked for by `who`; `at`: when."""

    who: str
    text: str
    reply: Reply
    at: float


class Lines:
    """Those of one run.  harmless: whether a line does nothing but put signals to stop, or block, so that it may come
    late.  Any thread may put one."""

    def __init__(self, harmless: Callable[[str], bool], now: Callable[[], float] = time.monotonic) -> None:
        self._harmless, self._now = harmless, now
        self._waiting: deque[Line] = deque()
        self._lock = threading.Lock()

    def put(self, who: str, text: str, reply: Reply = lambda taken: None) -> str:
        """Keep a line for the next cycle; why it is not kept, or nothing."""
        line = Line(who, text.strip(), reply, self._now())
        with self._lock:
            if not who and self._harmless(line.text):
                if any(line.text == x.text and not x.who for x in self._behind()):
                    return ""
            elif not who and sum(not self._harmless(x.text) for x in self._waiting) >= MOST:
                return f"{line.text}: {MOST} lines wait already: it is not done, type it again"
            self._waiting.append(line)
        return ""

    def _behind(self) -> Iterator[Line]:
        """The last lines, as far as they are harmless: one that is among them need not be done twice."""
        for x in reversed(self._waiting):
            if not self._harmless(x.text):
                return
            yield x

    def due(self) -> list[tuple[Line, str]]:
        """The lines of this cycle, in their order, each with why it is not done, or nothing: the first that was typed,
        all that were asked for otherwise, and where one is to stop or to cancel, that and all before it, so that none
        of them comes true after it.  What a stop would undo is not begun."""
        with self._lock:
            waiting, self._waiting = tuple(self._waiting), deque()
            stops = self._last(waiting, lambda text: spoken(text) == ("stop", ""))
            haste = max(stops, self._last(waiting, lambda text: spoken(text)[0] == "cancel"))
            found, typed = list[tuple[Line, str]](), False
            for k, x in enumerate(waiting):
                harmless = self._harmless(x.text)
                if k < haste:
                    now = k < stops or spoken(x.text)[0] != "voyage"  # nothing is asked for a voyage yet
                else:
                    now = harmless or (not haste and (bool(x.who) or not typed))
                    typed |= now and not x.who and not harmless
                if now:
                    found.append((x, self._why_not(x, k < stops) if x.text and not harmless else ""))
                else:
                    self._waiting.append(x)
        return found

    @staticmethod
    def _last(waiting: tuple[Line, ...], such: Callable[[str], bool]) -> int:
        """How many lines there are up to the last such."""
        return max((k for k, x in enumerate(waiting, 1) if such(x.text)), default=0)

    def _why_not(self, x: Line, stopped: bool) -> str:
        age = self._now() - x.at
        if stopped:
            return "all signals were put to stop after it"
        return f"it was asked for {age:.0f} s ago, and is not done now: ask again" if age > LATE_S else ""


__all__ = ["Line", "Lines", "Reply"]
