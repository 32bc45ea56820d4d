"""Alarms: each stands until its cause is gone and somebody has acknowledged it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from interlock.dataclass import dataclass

MOST = 1000
"""Alarms of what has happened that are told each by itself; all others are one (our choice)."""

ONCE = "once"
MORE = "more has happened than is told here: the record has all of it"


@dataclass(frozen=True)
class Alarm:
    """What is wrong, the element it is about, since when, whether it still is, and who has acknowledged it.  `count`:
    how often it has come since somebody acknowledged it last, `first`: when first."""

    key: str
    text: str
    at: tuple[str, ...]
    since: str
    active: bool = True
    by: str = ""
    count: int = 1
    first: str = ""

    @property
    def said(self) -> str:
        """What is wrong, and how often."""
        return self.text if self.count == 1 else f"{self.text} ({self.count} times since {_shown(self.first)})"

    def told(self) -> list[Any]:
        """As it is sent."""
        return [self.key, self.said, list(self.at), self.since, int(self.active), self.by]


def _shown(stamp: str) -> str:
    """A time as people write it."""
    return stamp[:19].replace("T", " ")


class Alarms:
    """All alarms of a panel, in the order in which they came."""

    def __init__(self) -> None:
        self.all: dict[str, Alarm] = {}
        self.count = 0
        self.version = 0

    def stand(self, causes: Mapping[str, tuple[str, tuple[str, ...]]], now: str) -> tuple[list[Alarm], list[Alarm]]:
        """The causes that there are now; the alarms that are new, and those that are over."""
        found = [Alarm(key, text, at, now) for key, (text, at) in causes.items() if not self._active(key)]
        over = [a for a in self.all.values() if a.active and a.key not in causes]
        for a in over:
            self._put(replace(a, active=False))
        new = [self._again(a) for a in found]
        self.count += len(new)
        return new, over

    def once(self, text: str, at: tuple[str, ...], now: str) -> Alarm:
        """Something that happened, and is not the case any more: one alarm for one text and place, however often."""
        self.count += 1
        key = next((k for k in self._once if (self.all[k].text, self.all[k].at) == (text, at)), "")
        if not key and len(self._once) >= MOST:
            key, text, at = f"{ONCE}s", MORE, ()
        return self._again(Alarm(key or f"{ONCE} {self.count}", text, at, now, active=False))

    @property
    def _once(self) -> list[str]:
        return [k for k in self.all if k.startswith(f"{ONCE} ")]

    def _again(self, a: Alarm) -> Alarm:
        """An alarm that has come: the last in the order, and counted where it was not acknowledged the time before."""
        before = self.all.pop(a.key, None)
        if before is not None and not before.by:
            a = replace(a, count=before.count + 1, first=before.first or before.since)
        self._put(a)
        return a

    def acknowledge(self, those: Iterable[tuple[str, str]] | None, who: str) -> list[Alarm]:
        """Somebody has seen alarms, each by its key and since when it stands, as one that has come again was not
        seen (None: all of them); those that were not seen before."""
        known = None if those is None else set(those)
        found = [a for a in self.all.values() if not a.by and (known is None or (a.key, a.since) in known)]
        for a in found:
            self._put(replace(a, by=who))
        return found

    def _active(self, key: str) -> bool:
        return key in self.all and self.all[key].active

    def _put(self, a: Alarm) -> None:
        self.version += 1
        if not a.active and a.by:
            self.all.pop(a.key, None)
        else:
            self.all[a.key] = a
