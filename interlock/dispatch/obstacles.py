"""What is in the way of plans: sections occupied by nobody with a command, blocked ones and the points in them, and
machines that have failed."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from itertools import dropwhile, takewhile

from interlock.dispatch.panel import Indications
from interlock.dispatch.plan.held import Held
from interlock.logic.symbols import Symbols
from interlock.model.elements import MachineId, Position, SectionId

STRANGER_MS = 3_000
"""A section that is occupied for so long by no train with a command is in the way of plans (our choice)."""


class Obstacles:
    """What is in the way, as a panel shows it."""

    def __init__(self, symbols: Symbols, held: Held) -> None:
        self.symbols, self._held = symbols, held
        self.leaving: set[SectionId] = set()
        """Approach sections over which trains run that have left."""
        self.things: frozenset[object] = frozenset()
        self._strange: dict[SectionId, int] = {}
        self._failed: set[MachineId] = set()
        late = {m for m, _ in symbols.machines.detected}
        self._late = {m: n for m in sorted(late) if (n := symbols.indication.get(f"late {m}")) is not None}

    def look(
        self, seen: Indications, dt_ms: int, near: set[SectionId], ran: Iterable[Sequence[SectionId]] = ()
    ) -> bool:
        """What is there now; whether that has changed.  `near`: sections in which trains with commands may be; `ran`:
        those over which trains of no known length have run, in order."""
        clear = self.symbols.sections.clear
        self.leaving = {s for s in self.leaving if s in clear and not seen.get(clear[s], 1)}
        occupied = [s for s, name in clear.items() if not seen.get(name, 0)]
        blocked = [s for s, name in self.symbols.sections.blocked.items() if seen.get(name, 0)]
        things: set[object] = set()
        if occupied or blocked:
            known = near.union(self.leaving, *(_tail(way, frozenset(occupied)) for way in ran))
            self._strange = {s: self._strange.get(s, 0) + dt_ms for s in occupied if s not in known}
            things |= {("section", s) for s, ms in self._strange.items() if ms > STRANGER_MS}
            things |= {("blocked", s) for s in blocked if s not in known}
            lies = {m: x for (m, x), name in self.symbols.machines.detected.items() if seen.get(name, 0)}
            things |= self._held.stay(blocked, lies) if blocked else set()
        for m, name in self._late.items():
            if not seen.get(name, 0) and m not in self._failed:
                continue
            there = {x for x in Position if seen.get(self.symbols.machines.detected[m, x], 0)}
            if seen.get(name, 0) or not there:  # until it is detected again somewhere
                self._failed.add(m)
                things |= {("lies", m, x.other) for x in Position if x not in there}
            else:
                self._failed.discard(m)
        changed = things != self.things
        self.things = frozenset(things)
        return changed


def _tail(way: Sequence[SectionId], occupied: Collection[SectionId]) -> set[SectionId]:
    """The sections of a way that are occupied without a gap from the foremost one back: a train and its tail."""
    head = dropwhile(lambda s: s not in occupied, reversed(way))
    return set(takewhile(lambda s: s in occupied, head))
