"""Points beside the path of a route, in its sections: no point moves while its section is locked.

Where another route, that can be set together with this one, holds such a point, it must find it lying so: the route
drives it along there, if the principles have it drive points along (带动道岔, R10); else the author is told that the
two can be set in one order only, unless the point happens to lie so (warning IL7011).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from interlock.derivation.added import Demands
from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.model.bits import bits_of
from interlock.model.elements import MachineId, Point, PointId, Position, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.table.cells import Because, PointDemand, Role

Hostile = Callable[[RouteId], int]
"""For a route the hostile ones, as bits by number less one."""


class Beside:
    """The points in the sections of routes that the routes do not hold, and who holds them."""

    def __init__(self, layout: Layout, paths: Sequence[Path], demands: Demands, hostile: Hostile) -> None:
        self._layout, self._paths, self._demands, self._hostile = layout, paths, demands, hostile
        self._holders: dict[tuple[MachineId, Position], int] = {}
        for i, p in enumerate(paths):
            for d in demands[p.id]:
                self._holders[d.machine, d.position] = self._holders.get((d.machine, d.position), 0) | 1 << i
        self.driven = {p.id: self._driven(p) for p in paths}

    def _wanted(self, path: Path, m: MachineId, x: Position) -> list[Path]:
        """The routes that hold a machine in a position and can be set together with a route."""
        apart = self._hostile(path.id) | 1 << path.number - 1
        for p in self._paths:
            if path in p.parts or p in path.parts:
                apart |= 1 << p.number - 1
        return [self._paths[i] for i in bits_of(self._holders.get((m, x), 0) & ~apart)]

    def _driven(self, path: Path) -> tuple[PointDemand, ...]:
        """The machines that a route drives along, where the principle says so: to where routes beside it want them,
        to normal where none does, and not at all where they want them both ways (R10)."""
        out: dict[MachineId, PointDemand] = {}
        if self._layout.principles.drive_points:
            for s, p in self._of(path, [t.section for t in path.ways]):
                wanted = [x for x in Position if self._wanted(path, p.machine, x)] or [Position.NORMAL]
                if len(wanted) == 1:
                    why = Because("R10", f"{p.id} lies in {s} beside the path; driven, never a condition")
                    out.setdefault(p.machine, PointDemand(p.machine, wanted[0], Role.DRIVEN, s, why))
        return tuple(out.values())

    def report(self, sink: Sink) -> None:
        """IL7011."""
        found: dict[tuple[PointId, SectionId], tuple[dict[RouteId, None], dict[str, None]]] = {}
        for q in self._paths:
            lies = {d.machine: d.position for d in self.driven[q.id]}
            for s, p in self._of(q, [t.section for t in (*q.ways, *q.overlap)]):
                for x in (x for x in Position if lies.get(p.machine) is not x):
                    for late in self._wanted(q, p.machine, x):
                        before, after = found.setdefault((p.id, s), ({}, {}))
                        before[q.id], after[f"{late.id} ({x})"] = None, None
        for (point, s), (before, after) in found.items():
            text = f"{point} lies in {s}, and cannot move once {_listed(before)} has locked it: then {_listed(after)} "
            text += f"can be set only if {point} lies so"
            fix = f"give {point} a section of its own, or set first the routes that need it"
            sink.add("IL7011", text, None, fix, about=Element("points", point))

    def _of(self, path: Path, sections: Sequence[SectionId]) -> Iterator[tuple[SectionId, Point]]:
        """The points of sections that a route does not hold."""
        held = {d.machine for d in self._demands[path.id]}
        for s in dict.fromkeys(sections):
            yield from ((s, p) for p in self._layout.machines.points_in.get(s, ()) if p.machine not in held)


def _listed(routes: Iterable[str]) -> str:
    """The first of some routes, and how many there are beside them."""
    own = list(routes)
    return " or ".join(own[:3]) + (f" ({len(own) - 3} more)" if len(own) > 3 else "")
