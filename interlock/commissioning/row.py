"""What a row of the interlocking table says that a tester can see or bring about.

A route that leads past a signal is tested with what is set with it (`parts`).
"""

from __future__ import annotations

from functools import cached_property

from interlock.commissioning.bench import Bench
from interlock.diag.called import called
from interlock.logic.names import Name
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import MachineId, NodeId, SectionId
from interlock.model.machines import other_doors
from interlock.table.cells import PointDemand, RouteKind, Shows
from interlock.table.rows import InterlockingTable, RouteRow


class Row:
    """A route's row, in the variables of the controller."""

    def __init__(self, bench: Bench, table: InterlockingTable, row: RouteRow) -> None:
        self.bench, self.row = bench, row
        self.parts = table.parts(row)
        self.symbols: RouteSymbols = bench.symbols.routes.number[row.number]
        self.calls_on = row.kind is RouteKind.CALL_ON
        self.name, self.signal = called("route", row.id), called("signal", row.entry)

    @cached_property
    def demands(self) -> dict[MachineId, PointDemand]:
        """The machines that have to lie."""
        return {p.machine: p for part in self.parts for p in part.locking.points}

    @cached_property
    def path(self) -> tuple[SectionId, ...]:
        """The sections in which its train is, one after the other; a berth among them."""
        return tuple(dict.fromkeys(s for part in self.parts for s in part.path.section_ids))

    @cached_property
    def overlap(self) -> tuple[SectionId, ...]:
        """The sections of its overlap."""
        return tuple(s for part in self.parts if part.locking.overlap is not None for s, _ in part.locking.overlap.ways)

    @cached_property
    def rear(self) -> tuple[SectionId, ...]:
        """The section before the signal, where there is one."""
        section = self.row.locking.approach.section
        return () if section is None else (section,)

    @property
    def always_locked(self) -> bool:
        """Whether a train may be on its way to the signal that nobody sees."""
        sections = self.row.locking.approach.sections
        return not sections or bool({*sections} & {*self.bench.layout.track.undetected})

    @property
    def tokens(self) -> tuple[NodeId, ...]:
        """The boundaries beyond which the direction of the line has to be ours."""
        return tuple(p.conditions.token.boundary for p in self.parts if p.conditions.token is not None)

    def turnable(self, m: MachineId) -> bool:
        """Whether a machine can lie the other way when the route is asked for: no door of an air lock, since the others
        would have to be shut first; none before a train that is called on, which may stand too near to it."""
        machines = self.bench.layout.machines
        return not self.calls_on and m not in machines.by_hand and not other_doors(machines, m)

    def aspect(self) -> tuple[tuple[Name, ...], str]:
        """The lamps that the signal lights while every other signal is at stop, and the aspect in words."""
        a, g, shows = self.bench.symbols.aspects, self.row.entry, self.row.signal.aspect.shows
        if shows is Shows.SHUNT:
            return (a.shunt[g],), "shunt"
        if shows is Shows.CALL_ON:
            return (a.call_on[g], a.stop[g]), "call-on beside stop"
        clear, kmh = g not in a.caution or shows is Shows.CLEAR, self.row.signal.speed.kmh
        lamps: tuple[Name, ...] = ((a.clear if clear else a.caution)[g],)
        word = "clear" if clear else "caution"
        if shows is Shows.TWO_YELLOWS:
            lamps, word = (*lamps, a.second[g]), str(shows)
        if self.row.signal.aspect.indicator:
            lamps, word = (*lamps, a.indicator[g]), f"{word} with the route indicator"
        return (lamps, word) if kmh is None else ((*lamps, a.speed[g, kmh]), f"{word} and {kmh} km/h")
