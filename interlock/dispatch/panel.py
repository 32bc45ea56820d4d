"""What a panel shows of a route, and what an operator asks for there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.logic.symbols import Symbols
from interlock.model.elements import MachineId, RouteId, SectionId, SignalId
from interlock.table.cells import RouteKind, TraversalKey
from interlock.table.rows import InterlockingTable

Indications = Mapping[str, int]
"""Inputs as sampled and outputs as shown, by name."""


@dataclass(frozen=True)
class RouteIndications:
    """What a panel shows of a route, by the names of inputs and outputs, and what these tell in a scan.

    rear: the section before its signal reported clear; clear, locked: by section of the route; late: by machine;
    beyond: sections over its boundary reported clear.
    """

    rear: str | None
    clear: Mapping[SectionId, str]
    locked: Mapping[SectionId, str]
    lamps: tuple[str, ...] = ()
    late: Mapping[MachineId, str] = field(default_factory=dict)
    beyond: tuple[str, ...] = ()
    direction: str = ""
    """What tells that the direction of the line beyond is here, where a token tells it."""

    def stands(self, seen: Indications) -> bool:
        """A train is before the signal; where nothing detects it, the command says so."""
        return self.rear is None or not seen.get(self.rear, 1)

    def open(self, seen: Indications) -> bool:
        """All sections are locked and the signal shows proceed."""
        return self.is_set(seen) and any(seen.get(n, 0) for n in self.lamps)

    def is_set(self, seen: Indications) -> bool:
        """All sections are locked."""
        return all(seen.get(n, 0) for n in self.locked.values())

    def held(self, seen: Indications) -> bool:
        """Some of its sections are locked, or its signal is open."""
        return any(seen.get(n, 0) for n in (*self.locked.values(), *self.lamps))

    def closed(self, seen: Indications) -> bool:
        """It is set and shows stop, though its sections are clear and the direction is here: it closed while something
        was wrong."""
        clear = all(seen.get(n, 0) for n in self.clear.values())
        return self.is_set(seen) and not self.open(seen) and clear and not self.waits(seen)

    def waits(self, seen: Indications) -> bool:
        """It leads over a line whose direction is not here."""
        return bool(self.direction) and not seen.get(self.direction, 0)

    def fails(self, seen: Indications) -> MachineId | None:
        """A machine of the route that was not detected in time."""
        return next((m for m, n in self.late.items() if seen.get(n, 0)), None)


@dataclass(frozen=True)
class Stage:
    """A route as a train is sent over it: its number, its sections, and what the panel shows of it."""

    route: RouteId
    number: int
    entry: SignalId
    sections: tuple[SectionId, ...]
    berth: SectionId | None
    shown: RouteIndications
    out: tuple[SectionId, ...] = ()
    """The sections beyond the boundary over which it leads out."""
    on_sight: bool = False
    """A call-on: its sections may be reported occupied."""
    own: frozenset[SectionId] = frozenset()
    """Sections that may be locked as the overlap of its own signal: the route may be set over it all the same."""

    def taken(self, seen: Indications) -> bool:
        """It is set, as far as anybody can tell: where all of it may be locked as an overlap, only its lamp tells."""
        told = self.shown
        return told.open(seen) or (told.is_set(seen) and not self.own.issuperset(told.locked))

    def entered(self, seen: Indications) -> bool:
        """The train has passed the signal."""
        name = self.shown.clear.get(self.sections[0])
        return name is not None and not seen.get(name, 1)

    def hindered(self, seen: Indications) -> str:
        """What is seen that keeps the route from being set; empty where nothing is."""
        for s, n in self.shown.clear.items():
            if s != self.berth and not self.on_sight and not seen.get(n, 0):
                return f"{s} is not clear"
        for s, n in self.shown.locked.items():
            if seen.get(n, 1) and s not in self.own:
                return f"{s} is locked"
        if any(not seen.get(n, 0) for n in self.shown.beyond):
            return "the line beyond is not clear"
        return ""


def stages(table: InterlockingTable, symbols: Symbols) -> dict[RouteId, Stage]:
    """Every route as a panel of this controller sees it."""
    trains = (
        symbols.aspects.clear,
        symbols.aspects.caution,
        symbols.aspects.call_on,
        symbols.aspects.identifier,
    )
    lamps = (*trains, symbols.aspects.shunt)
    found: dict[RouteId, Stage] = {}
    overlaps: dict[SignalId, set[TraversalKey]] = {}
    for r in table.routes:
        if r.locking.overlap is not None:
            overlaps.setdefault(r.locking.overlap.signal, set()).update(r.locking.overlap.ways)
    for r in table.routes:
        before = symbols.cancellation.approach_of.get(r.entry)
        late = {d.machine: f"late {d.machine}" for d in r.locking.points}
        found[r.id] = Stage(
            route=r.id,
            number=r.number,
            entry=r.entry,
            sections=r.path.section_ids,
            berth=r.path.berth,
            shown=RouteIndications(
                rear=None if before is None else symbols.sections.clear.get(before),
                clear={s: symbols.sections.clear[s] for s in r.path.section_ids if s in symbols.sections.clear},
                locked={s: symbols.indication[f"locked {s}"] for s, _ in r.path.locked},
                lamps=tuple(x[r.entry] for x in lamps if r.entry in x),
                late={m: symbols.indication[n] for m, n in late.items() if n in symbols.indication},
                beyond=tuple(
                    symbols.sections.clear[c.section] for c in r.conditions.block if c.section in symbols.sections.clear
                ),
                direction="" if r.conditions.token is None else symbols.token[r.conditions.token.boundary].tells["has"],
            ),
            out=tuple(c.section for c in r.conditions.block),
            on_sight=r.kind is RouteKind.CALL_ON,
            own=frozenset(s for s, k in r.path.traversals if (SectionId(s), k) in overlaps.get(r.entry, ())),
        )
    return found
