"""What browsers ask for waits for its turn between two cycles: to stop first; whoever only looks last, and not long."""

from __future__ import annotations

import queue
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from interlock.app.run import since_boot
from interlock.dataclass import dataclass
from interlock.panel.entry import STOP, WHY, never_late, verb
from interlock.panel.operating import Person

Reply = Callable[[dict[str, Any]], None]

ORDERS_S = 0.2
"""Seconds of a cycle after which nothing more is begun that puts no signal to stop and blocks nothing (our choice): a
cycle of half a second would be too long for what the controller has to see (A-SCAN)."""

LOOKS = 0.1
"""The part of a cycle in which it is said why a signal is at stop, and as much again for those who only look (our
choice); one answer is given in each cycle at least."""

STOPPED = "all signals were put to stop after it: ask again"
TOO_MUCH = "too much is asked for at once: it is not done, ask again"


@dataclass(frozen=True)
class Turn:
    """Who asks for what, and since when (`since_boot`); `why_not`: why it is not done, empty where nothing is known."""

    who: Person
    command: Mapping[str, Any]
    reply: Reply
    since: float
    why_not: str = ""


class Turns:
    """The turns of one desk; `looks_s`: seconds of a cycle for each kind of those who want to know why.  Any thread may
    put one."""

    def __init__(self, looks_s: float, now: Callable[[], float] = since_boot) -> None:
        self._looks_s, self._now = looks_s, now
        self._orders: queue.SimpleQueue[Turn] = queue.SimpleQueue()
        self._whys: queue.SimpleQueue[Turn] = queue.SimpleQueue()
        self._looks: queue.SimpleQueue[Turn] = queue.SimpleQueue()

    def put(self, who: Person, command: Mapping[str, Any], reply: Reply, why_not: str = "") -> None:
        """A command for the next cycle, and why it is not done, if that is known."""
        own = self._whys if verb(command) == WHY else self._orders
        (own if who.operates else self._looks).put(Turn(who, command, reply, self._now(), why_not))

    def due(self) -> Iterator[Turn]:
        """What is done in this cycle, one after the other; what comes meanwhile waits.  All signals to stop come first,
        and what was asked for before that and could open something is not done after it."""
        orders = [self._orders.get_nowait() for _ in range(self._orders.qsize())]
        stops = [k for k, x in enumerate(orders) if verb(x.command) == STOP]
        yield from (orders[k] for k in stops)
        began = self._now()
        for k, x in enumerate(orders):
            if k in stops:
                continue
            harmless = never_late(verb(x.command), x.command)
            why_not = STOPPED if stops and k < stops[-1] else TOO_MUCH if self._now() - began > ORDERS_S else ""
            yield x if harmless or not why_not else replace(x, why_not=why_not)
        for looks in (self._whys, self._looks):
            began = self._now()
            for _ in range(looks.qsize()):
                yield looks.get_nowait()
                if self._now() - began > self._looks_s:
                    break
