"""Alarms: each stands until its cause is gone and somebody has acknowledged it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from interlock.dataclass import dataclass


@dataclass(frozen=True)
class Alarm:
    """What is wrong, the element it is about, since when, whether it still is, and who has acknowledged it."""

    key: str
    text: str
    at: tuple[str, ...]
    since: str
    active: bool = True
    by: str = ""

    def told(self) -> list[Any]:
        """As it is sent."""
        return [self.key, self.text, list(self.at), self.since, int(self.active), self.by]


class Alarms:
    """All alarms of a panel, in the order in which they came."""

    def __init__(self) -> None:
        self.all: dict[str, Alarm] = {}
        self.count = 0
        self.version = 0

    def stand(self, causes: Mapping[str, tuple[str, tuple[str, ...]]], now: str) -> list[Alarm]:
        """The causes that there are now; the alarms that are new."""
        new = [Alarm(key, text, at, now) for key, (text, at) in causes.items() if not self._active(key)]
        for a in [a for a in self.all.values() if a.active and a.key not in causes and not a.key.startswith("once ")]:
            self._put(replace(a, active=False))
        for a in new:
            self._put(a)
        self.count += len(new)
        return new

    def once(self, text: str, at: tuple[str, ...], now: str) -> Alarm:
        """Something that happened, and is not the case any more."""
        self.count += 1
        a = Alarm(f"once {self.count}", text, at, now, active=False)
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
