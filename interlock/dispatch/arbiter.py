"""Whose request comes first: by hand, on the spot, from the control centre, or planned; none is lost.

Order (document A 3, lexicographic): whoever has waited too long; by hand; inclined lane before level; on the spot
before from afar; main direction before against it; then the time of the request, then its number.  Numbers differ, so
no two requests compare equal.

The bound on waiting.  One request is made at a time, and takes `SCANS` scans at most: asked, read, gone back to 0.  A
request whose turn has not come for `wait_ms` comes before all whose turn has; among those the one that has waited
longer is first; a refused one has had its turn.  So from then on at most those that are before it now are made before
it, each once: a request that could be granted all the time is made within `wait_ms` and `bound_scans` scans, whatever
else comes.
"""

from __future__ import annotations

from dataclasses import field
from enum import IntEnum

from interlock.dataclass import dataclass
from interlock.dispatch.panel import Indications, Stage

SCANS = 4
"""Scans that a request takes at most: written, read and acknowledged, set back, acknowledged (or answered) again."""

MOST = 200
"""Requests that are kept (our choice); one more is refused at once, and said so."""


class Source(IntEnum):
    """Who asks, in the order in which they are heard where all else is equal."""

    HAND = 0
    LOCAL = 1
    REMOTE = 2
    PLANNED = 3


class Full(Exception):
    """No further request can be kept."""


Key = tuple[bool, int, bool, bool, int, bool, int, int]


def key(source: Source, number: int, inclined: bool, forward: bool, waited_ms: int, wait_ms: int) -> Key:
    """The order of requests: what is smaller comes first."""
    aged = bool(wait_ms) and waited_ms >= wait_ms
    first = -waited_ms if aged else 0
    return (not aged, first, source is not Source.HAND, not inclined, source, not forward, -waited_ms, number)


@dataclass(eq=False)
class Request:
    """A route that somebody wants.  `reason`: what keeps it back, from the last time it was looked at."""

    stage: Stage
    source: Source
    number: int
    inclined: bool = False
    forward: bool = True
    waited_ms: int = 0
    turn_ms: int = 0
    """Since it came, or was refused last."""
    rest_ms: int = 0
    reason: str = ""
    tries: int = 0

    def key(self, wait_ms: int) -> Key:
        """Its place in the order."""
        return key(self.source, self.number, self.inclined, self.forward, self.turn_ms, wait_ms)

    def hindered(self, seen: Indications) -> str:
        """What is seen that keeps it back; what is asked for by hand is tried once in any case."""
        return "" if self.source is Source.HAND and not self.tries else self.stage.hindered(seen)


@dataclass
class Arbiter:
    """Requests that wait; `wait_ms`: after this time one comes first (0: never)."""

    wait_ms: int = 0
    again_ms: int = 5_000
    waiting: list[Request] = field(default_factory=list)
    said: list[str] = field(default_factory=list)
    asked: Request | None = None
    longest_ms: int = 0
    """The longest wait of a request that nothing kept back, until it was made."""
    numbers: int = 0
    _free_ms: dict[Request, int] = field(default_factory=dict)

    def add(self, stage: Stage, source: Source, inclined: bool = False, forward: bool = True) -> Request:
        """Keep a request until it is granted or withdrawn; the same again is the same.  Raises `Full`."""
        for r in self.waiting:
            if r.stage.route == stage.route and r.source is source:
                return r
        if len(self.waiting) >= MOST:
            raise Full(f"{stage.route}: {MOST} requests wait already")
        self.numbers += 1
        r = Request(stage, source, self.numbers, inclined, forward)
        self.waiting.append(r)
        return r

    def withdraw(self, r: Request) -> None:
        """Nobody wants it any more."""
        if r in self.waiting:
            self.waiting.remove(r)
        self._free_ms.pop(r, None)

    def bound_scans(self, r: Request) -> int:
        """Scans within which a request is made once it has waited too long and could be granted all the time."""
        older = sum(x.turn_ms >= r.turn_ms for x in self.waiting if x is not r)
        return SCANS * (older + 1)

    def tick(self, seen: Indications, dt_ms: int) -> None:
        """A scan has passed."""
        for r in self.waiting:
            r.waited_ms += dt_ms
            r.turn_ms += dt_ms
            r.rest_ms = max(0, r.rest_ms - dt_ms)
            free = not r.rest_ms and not r.hindered(seen)
            self._free_ms[r] = self._free_ms.get(r, 0) + dt_ms if free else 0

    def may(self, r: Request, seen: Indications) -> bool:
        """Nothing seen keeps a request back; what does is kept with it."""
        if r.rest_ms:
            return False
        r.reason = r.hindered(seen)
        return not r.reason

    def make(self, r: Request) -> Request:
        """A request is made now."""
        self.asked = r
        r.tries += 1
        self.longest_ms = max(self.longest_ms, self._free_ms.get(r, 0))
        return r

    def answered(self, seen: Indications) -> bool:
        """What was asked for was read: whether it was granted; if not, it is kept, and why is kept with it."""
        r, self.asked = self.asked, None
        if r is None:
            return False
        granted = r.stage.shown.is_set(seen)
        if granted:
            self.withdraw(r)
        else:
            r.rest_ms, r.turn_ms = self.again_ms, 0
            r.reason = r.stage.hindered(seen) or "refused: a machine, an exclusion, a zone or an overlap is not free"
            self.said.append(f"{r.stage.route}, {r.source.name.lower()}: {r.reason}")
        return granted
