"""What the national forms read from layout and table in common."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property

from interlock.model.elements import MachineId, NodeId, Position, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import Topology, Traversal, topology
from interlock.table.printed import Printed, PrintedRoute, grouped
from interlock.table.rows import InterlockingTable, PointDemand, Role, RouteRow

ON_PATH = (Role.PATH, Role.OVERLAP)


@dataclass(frozen=True)
class Reading:
    """A layout with its table."""

    layout: Layout
    table: InterlockingTable

    @cached_property
    def printed(self) -> Printed:
        """The table as it is printed, a row for each way."""
        return Printed(self.table)

    def named(
        self,
        routes: Iterable[RouteId],
        name: Callable[[PrintedRoute], str] = lambda w: w.id,
        by: RouteRow | None = None,
    ) -> tuple[str, ...]:
        """Routes as they are printed, a way once where all of its overlaps are meant.

        by: the route that says it; that its own way cannot be set twice is not said.
        """
        said = grouped(((r, None) for r in routes), self.printed.ways, by)
        own = None if by is None else self.printed.ways[by.id]
        return tuple(x.name(name) for x in said if x.way is not own)

    @cached_property
    def topo(self) -> Topology:
        """Ways and joints."""
        return topology(self.layout)

    def way(self, key: tuple[SectionId, int]) -> Traversal:
        """The way of a lock."""
        return self.topo.traversals[key[0]][key[1] - 1]

    def is_machine(self, p: PointDemand) -> bool:
        """Whether a demand is of points, not of a derailer or another device."""
        return p.machine not in self.layout.device and not self.is_derailer(p.machine)

    def is_derailer(self, m: MachineId) -> bool:
        """Whether a machine is a derailer."""
        return any(p.derailer for p in self.layout.ends_of_machine.get(m, ()))

    def derailers(self, r: RouteRow) -> str:
        """The derailers of a route, on or off."""
        found = (p for p in r.points if self.is_derailer(p.machine))
        return ", ".join(f"{p.machine} {self.layout.word(p.machine, p.position)}" for p in found)

    def points(self, r: RouteRow, position: Position, *roles: Role) -> str:
        """Points of a route in a position."""
        return ", ".join(
            p.machine
            for p in r.points
            if p.position is position and p.role in (roles or tuple(Role)) and self.is_machine(p)
        )

    def sections(self, r: RouteRow) -> list[str]:
        """Sections to be clear: path, foul sections with their condition, overlap, flank space."""
        foul = [f.section if f.when is None else f"[{f.section} or {f.when[0]} {f.when[1].other}]" for f in r.foul]
        over = [s for s, _ in r.overlap.ways] if r.overlap else []
        space = [c.name for c in r.space if not c.lamp]
        return list(dict.fromkeys([*(c.section for c in r.sections), *foul, *over, *space]))

    def facing(self, r: RouteRow) -> list[tuple[str, Position]]:
        """The points that the route passes facing, in order: they decide where it goes."""
        out = []
        for key in r.traversals:
            t = self.way(key)
            node: NodeId = t.entry
            for here, onward in zip(t.edges, t.edges[1:], strict=False):
                node = self.layout.far(here, node)
                p = self.layout.point_at.get(node)
                if p is not None and here == p.toe:
                    out.append((str(p.machine), Position.NORMAL if onward == p.normal else Position.REVERSE))
        return out
