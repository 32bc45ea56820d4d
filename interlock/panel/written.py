"""The lines of a panel's record on their way to the file, which may be full, cut or gone at any moment.

What cannot be written is kept, and written in its order when that is possible again, so much of it in a cycle that the
cycle is not too long.  A file that is gone, or was emptied, begins anew; one that was changed otherwise takes nothing
any more until it is moved away.  Whatever begins anew, and whatever follows lines that were dropped, begins with all
that is so then: changes of something that is not known would show a railway that never was.
"""

from __future__ import annotations

import sys
from collections import deque
from contextlib import suppress
from pathlib import Path
from typing import Any

from interlock.panel.journal import BEGIN, GAP, PICTURE
from interlock.panel.standing import KEPT
from interlock.record.log import END, Log

WAITING = 100_000
"""Lines that are kept at most while nothing can be written."""

IN_A_CYCLE = 1000
"""Lines of those that are written in one cycle at most: some ten milliseconds (our choice)."""

Fields = dict[str, Any]


class Written:
    """A record's lines.  `heading`: the fields of the event with which a file begins; `kept`: what stands at the end of
    the log, where something does."""

    def __init__(self, path: Path, log: Log, heading: Fields, kept: Fields | None) -> None:
        self._path, self._heading = path, heading
        self.lost = ""
        """Why not all is written; empty where it is."""
        self._log: Log | None = log
        self._left = log
        """Where writing had to stop."""
        self._waiting: deque[tuple[int, str, Fields]] = deque()
        self._on: frozenset[str] | None = None
        self._kept = kept
        """What the last line before those that wait shows, and what stands then."""
        self._dropped = self._releases = 0
        """Events that were dropped, and those among them that are releases by hand, which are counted."""
        self._gap = self._whole = False
        """Whether that something is missing, and all that is so, are still to be written."""
        self._last = ""
        """The kind of the last line."""

    def put(self, t_ms: int, kind: str, fields: Fields) -> None:
        """A line is to be written."""
        self._look()
        if self._log is not None and not self.lost:
            try:
                self._write(self._log, t_ms, kind, fields)
            except OSError as error:
                self._broken(error)
            else:
                return
        if len(self._waiting) >= WAITING:
            _, dropped, of_it = self._waiting.popleft()
            self._follow(dropped, of_it)
            self._dropped += 1
            self._releases += dropped == "release"
        self._waiting.append((t_ms, kind, fields))

    def try_again(self, now_ms: int) -> None:
        """Once in a while: look after the file, and go on where nothing could be written."""
        if self._log is not None:
            self._look()
        else:
            try:
                self._log = Log.again(self._path, self._left) if self._path.exists() else Log.create(self._path)
                self._go_on(self._log, self._waiting[0][0] if self._waiting else now_ms)
            except (OSError, ValueError) as error:
                self._broken(error)

    def some(self, most: int = IN_A_CYCLE) -> None:
        """Write some of the lines that wait, where that is possible."""
        if self._log is None or not self.lost:
            return
        try:
            for _ in range(min(most, len(self._waiting))):
                self._write(self._log, *self._waiting[0])
                self._waiting.popleft()
        except (OSError, ValueError) as error:
            self._broken(error)
            return
        if not self._waiting:
            self.lost = ""

    def close(self, now_ms: int) -> None:
        """The last line: try once more, and say on the standard error output what could not be written."""
        if self._log is None:
            self.try_again(now_ms)
        self.some(len(self._waiting))
        self.put(now_ms, END, {})
        if missing := len(self._waiting) + self._dropped:
            with suppress(OSError, ValueError):
                print(f"error: the last {missing} events are not in {self._path}: {self.lost}", file=sys.stderr)
        if self._log is not None:
            self._log.close()
            self._log = None

    def _look(self) -> None:
        """A file that is gone, or not as it was left, takes nothing any more."""
        if self._log is not None and (why := self._log.differs(self._path)):
            self._broken(OSError(0, why))

    def _broken(self, error: OSError | ValueError) -> None:
        why = (error.strerror if isinstance(error, OSError) else None) or str(error)
        self.lost, self._gap = f"the record cannot be written: {why}", True
        if self._log is not None:
            self._log.close()
            self._left, self._log = self._log, None

    def _go_on(self, log: Log, since: int) -> None:
        """What comes before the lines that wait."""
        if not log.chain.number:
            self._whole = True
            self._write(log, since, BEGIN, self._heading)
            if self._waiting and self._waiting[0][1] == BEGIN:
                self._waiting.popleft()
            self._all(log, since)
        if self._gap and (self._dropped or self._last != GAP):
            by_hand = {"releases": self._releases} if self._releases else {}
            self._write(log, since, GAP, {"text": self.lost, "dropped": self._dropped, **by_hand})
            self._whole = self._whole or bool(self._dropped)
            self._dropped = self._releases = 0
        self._gap = False
        if self._whole:
            self._all(log, since)

    def _all(self, log: Log, since: int) -> None:
        """All that is shown, and all that stands."""
        if self._on is not None:
            self._write(log, since, PICTURE, {"on": sorted(self._on), "off": [], "whole": True})
        if self._kept is not None:
            self._write(log, since, KEPT, self._kept)
        self._whole = False

    def _write(self, log: Log, t_ms: int, kind: str, fields: Fields) -> None:
        log.add(t_ms, kind, **fields)
        self._last = kind
        self._follow(kind, fields)

    def _follow(self, kind: str, fields: Fields) -> None:
        """What is shown, and what stands, after a line that is written, or dropped."""
        if kind == PICTURE:
            before = frozenset() if fields["whole"] or self._on is None else self._on
            self._on = (before | {*fields["on"]}) - {*fields["off"]}
        elif kind == KEPT:
            self._kept = fields
