"""Voyages (航程) carried out: their routes opened one after the other, each for the train that stands before it.

The executor sees what a panel sees: sections as reported, locks and lamps as indicated.  It asks for a route as an
operator would, waits for the acknowledgement, and asks again later where the interlocking refused.  A voyage that is
set from its far end (combined shunt routes, 长调车进路) has all its routes asked for while the train stands before
the first.  Of two voyages over one single line in opposite directions the first to be given a route over it has it,
until it is out.  Nothing is claimed of deadlocks.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, field

from interlock.logic.controller import Symbols
from interlock.model.elements import RouteId, SectionId, SignalId
from interlock.table.rows import InterlockingTable

AGAIN_MS = 5_000
"""A route that was asked for and is not open is asked for again after this time (our choice)."""

Indications = Mapping[str, int]
"""Inputs as sampled and outputs as shown, by name."""


@dataclass(frozen=True)
class Stage:
    """A route of a voyage: its number, the section in rear of its signal, the indications that tell what it does."""

    route: RouteId
    number: int
    entry: SignalId
    rear: str | None
    clear: Mapping[SectionId, str]
    locked: Mapping[SectionId, str]
    lamps: tuple[str, ...]
    sections: tuple[SectionId, ...]

    def stands(self, seen: Indications) -> bool:
        """A train is before the signal; where nothing detects it, the command says so."""
        return self.rear is None or not seen.get(self.rear, 1)

    def open(self, seen: Indications) -> bool:
        """All sections are locked and the signal shows proceed."""
        return all(seen.get(n, 0) for n in self.locked.values()) and any(seen.get(n, 0) for n in self.lamps)

    def held(self, seen: Indications) -> bool:
        """Some of its sections are locked, or its signal is open."""
        return any(seen.get(n, 0) for n in (*self.locked.values(), *self.lamps))

    def entered(self, seen: Indications) -> bool:
        """The train has passed the signal."""
        name = self.clear.get(self.sections[0])
        return name is not None and not seen.get(name, 1)

    def left(self, seen: Indications) -> bool:
        """Nothing is locked or occupied."""
        return not self.held(seen) and all(seen.get(n, 0) for n in self.clear.values())


@dataclass(frozen=True)
class Voyage:
    """The stages of a voyage in the order of travel; `lines`: the single lines it shares with an opposing voyage."""

    name: str
    stages: tuple[Stage, ...]
    far_first: bool
    priority: int
    lines: tuple[tuple[str, frozenset[SectionId]], ...]


def voyages(table: InterlockingTable, symbols: Symbols) -> dict[str, Voyage]:
    """The voyages of a table, by name, as a panel of this controller sees them."""
    lamps = (symbols.clear_aspect, symbols.caution_aspect, symbols.call_aspect, symbols.shunt_aspect)
    found: dict[str, Voyage] = {}
    for row in table.voyages:
        stages = []
        for r in (table.route[i] for i in row.routes):
            before = symbols.approach_of.get(r.entry)
            stages.append(
                Stage(
                    route=r.id,
                    number=r.number,
                    entry=r.entry,
                    rear=None if before is None else symbols.clear.get(before),
                    clear={s: symbols.clear[s] for s in r.section_ids if s in symbols.clear},
                    locked={s: symbols.indication[f"locked {s}"] for s, _ in r.locked},
                    lamps=tuple(x[r.entry] for x in lamps if r.entry in x),
                    sections=r.section_ids,
                )
            )
        lines = tuple((m.voyage, frozenset(m.sections)) for m in row.meetings)
        found[row.name] = Voyage(row.name, tuple(stages), row.far_first, row.priority, lines)
    return found


@dataclass
class Journey:
    """A voyage that was commanded: which stage its train passes next, which are open, since when one is waited for."""

    voyage: Voyage
    at: int = 0
    opened: set[int] = field(default_factory=set)
    asked: int | None = None
    waited_ms: int = 0
    since_ms: int = 0
    holds: set[frozenset[SectionId]] = field(default_factory=set)

    def wanted(self) -> int | None:
        """The stage that is to be opened next, if any."""
        left = [k for k in range(self.at, len(self.voyage.stages)) if k not in self.opened]
        if self.voyage.far_first:
            return left[-1] if left else None
        return self.at if self.at in left else None


class Executor:
    """Carries out voyages, and hands on what an operator asks for by hand, which comes first.

    priorities: the class of a voyage decides who is served first, else the order of the commands; `wait_ms`: one that
    has waited so long comes first all the same (0: never).
    """

    def __init__(
        self, known: Mapping[str, Voyage], symbols: Symbols, priorities: bool = False, wait_ms: int = 0
    ) -> None:
        self.known, self.request, self.seen = known, symbols.request, symbols.seen[symbols.request]
        self.valid = symbols.valid
        self.priorities, self.wait_ms = priorities, wait_ms
        self.journeys: list[Journey] = []
        self.by_hand: deque[int] = deque()
        self.said: list[str] = []
        self._writes = 0
        self._passing: dict[SignalId, Stage] = {}

    def begin(self, name: str) -> None:
        """Command a voyage.  Raises `KeyError` where there is none of that name."""
        self.journeys.append(Journey(self.known[name]))

    def end(self, name: str) -> bool:
        """Give up a voyage: nothing more is asked for; what is set stays until it is cancelled or used."""
        before = len(self.journeys)
        self.journeys = [j for j in self.journeys if j.voyage.name != name]
        return len(self.journeys) < before

    def ask(self, number: int) -> None:
        """A route asked for by hand."""
        self.by_hand.append(number)

    def step(self, seen: Indications, dt_ms: int) -> dict[str, int]:
        """What to write after a scan, from what was seen in it; `dt_ms` milliseconds after the step before."""
        for j in tuple(self.journeys):
            self._follow(j, seen, dt_ms)
        self._passing = {g: s for g, s in self._passing.items() if s.stands(seen)}
        if self._writes and seen.get(self.seen, 0):
            self._writes = 0  # it was read
        elif not self._writes and not seen.get(self.seen, 1) and seen.get(self.valid, 0):
            self._writes = self.by_hand.popleft() if self.by_hand else self._next(seen)
        return {self.request: self._writes}

    def _follow(self, j: Journey, seen: Indications, dt_ms: int) -> None:
        """Where the train of a journey has come to, and whether what was asked for is open."""
        stages, name = j.voyage.stages, j.voyage.name
        j.waited_ms += dt_ms
        j.since_ms += dt_ms
        if j.asked is not None and stages[j.asked].open(seen):
            self.said.append(f"voyage {name}: {stages[j.asked].route} is open")
            j.opened.add(j.asked)
            j.asked, j.waited_ms = None, 0
        elif j.asked is not None and j.since_ms >= AGAIN_MS:
            j.asked = None
        if j.at in j.opened and stages[j.at].entered(seen):
            if stages[j.at].rear is not None:  # the train that passes is not yet the next one
                self._passing[stages[j.at].entry] = stages[j.at]
            j.at += 1
        elif j.at in j.opened and not stages[j.at].held(seen):
            self.said.append(f"voyage {name} is given up: {stages[j.at].route} was taken back before its train came")
            self.journeys.remove(j)
            return
        ahead = {s for stage in stages[j.at :] for s in stage.sections}
        behind = [x for k, x in enumerate(stages) if k < j.at]
        for line in tuple(j.holds):
            if line.isdisjoint(ahead) and all(x.left(seen) for x in behind if not line.isdisjoint(x.sections)):
                j.holds.discard(line)
        if j.at == len(stages) and not j.holds:
            self.said.append(f"voyage {name} is done")
            self.journeys.remove(j)

    def _next(self, seen: Indications) -> int:
        """The number of the route that is asked for now; 0 for none."""
        for j in sorted(self.journeys, key=self._rank):
            k = j.wanted()
            if k is None or j.asked is not None:
                continue
            first = j.voyage.stages[j.at]
            if not first.stands(seen) or first.entry in self._passing or not self._may(j, j.voyage.stages[k]):
                continue
            stage = j.voyage.stages[k]
            j.holds |= {line for _, line in j.voyage.lines if not line.isdisjoint(stage.sections)}
            j.asked, j.since_ms = k, 0
            return stage.number
        return 0

    def _rank(self, j: Journey) -> tuple[bool, int]:
        aged = bool(self.wait_ms) and j.waited_ms >= self.wait_ms
        return not aged, j.voyage.priority if self.priorities else 0

    def _may(self, j: Journey, stage: Stage) -> bool:
        """No opposing voyage has a single line that the stage is part of; no other train is served at its signal."""
        for other in self.journeys:
            if other is j:
                continue
            shared = [x for name, x in j.voyage.lines if name == other.voyage.name and not x.isdisjoint(stage.sections)]
            if any(not x.isdisjoint(held) for x in shared for held in other.holds):
                return False
            if other.asked is not None and other.voyage.stages[other.asked].entry == stage.entry:
                return False
            if any(other.voyage.stages[k].entry == stage.entry for k in other.opened if k >= other.at):
                return False
        return True
