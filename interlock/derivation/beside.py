"""Points beside the path of a route, in its sections: no point moves while its section is locked.

Where another route, that can be set together with this one, holds such a point, it must find it lying so: the route
drives it along there, if the principles have it drive points along (带动道岔, R10); else the author is told that the
two can be set in one order only, unless the point happens to lie so (warning IL7011).  A point that decides whether a
joint is foul of the other route (R7) is wanted where it leads away from the joint: a train of this route would close
the other one's signal.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from interlock.derivation.added import Demands
from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.model.bits import bits_of
from interlock.model.elements import MachineId, Point, PointId, Position, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.table.cells import Because, FoulCell, PointDemand, Role

Hostile = Callable[[RouteId], int]
"""For a route the hostile ones, as bits by number less one."""


class Beside:
    """The points in the sections of routes that the routes do not hold, who holds them, and of whom a train there is
    foul while they lie otherwise."""

    def __init__(
        self,
        layout: Layout,
        paths: Sequence[Path],
        demands: Demands,
        fouls: Mapping[RouteId, Iterable[FoulCell]],
        hostile: Hostile,
    ) -> None:
        """`demands`, `fouls`: by route, how it needs machines to lie, and the joints that are foul of it."""
        self._layout, self._paths, self._demands, self._hostile = layout, paths, demands, hostile
        self._holders: dict[tuple[MachineId, Position], int] = {}
        self._fouled: dict[tuple[SectionId, MachineId, Position], int] = {}
        """By a section, a machine in it and a position the routes of which a train in the section is not foul so."""
        for i, p in enumerate(paths):
            for d in demands[p.id]:
                self._holders[d.machine, d.position] = self._holders.get((d.machine, d.position), 0) | 1 << i
            for c in fouls[p.id]:
                if c.when is not None:
                    away = c.section, c.when[0], c.when[1].other
                    self._fouled[away] = self._fouled.get(away, 0) | 1 << i
        self.driven = {p.id: self._driven(p) for p in paths}

    def _together(self, path: Path, some: int) -> list[Path]:
        """Those of some routes, as bits, that can be set together with a route."""
        apart = self._hostile(path.id) | 1 << path.number - 1
        for p in self._paths:
            if path in p.parts or p in path.parts:
                apart |= 1 << p.number - 1
        return [self._paths[i] for i in bits_of(some & ~apart)]

    def _held(self, path: Path, m: MachineId, x: Position) -> list[Path]:
        """The routes that hold a machine in a position and can be set together with a route."""
        return self._together(path, self._holders.get((m, x), 0))

    def _kept_open(self, path: Path, s: SectionId, m: MachineId, x: Position) -> list[Path]:
        """The routes that can be set together with a route, and whose signals its train in a section leaves open while
        a machine there that they do not hold lies so (R7)."""
        own = self._holders.get((m, x), 0) | self._holders.get((m, x.other), 0)
        return self._together(path, self._fouled.get((s, m, x), 0) & ~own)

    def _driven(self, path: Path) -> tuple[PointDemand, ...]:
        """The machines that a route drives along, where the principle says so: to where routes beside it want them,
        to normal where none does, and not at all where they want them both ways (R10).  Those want a point of which
        they hold it, and those of which a train in its section is foul while it lies otherwise (R7)."""
        out: list[PointDemand] = []
        if self._layout.principles.drive_points:
            at: dict[MachineId, list[tuple[SectionId, Point]]] = {}
            for s, p in self._of(path, [t.section for t in path.ways]):
                at.setdefault(p.machine, []).append((s, p))
            for m, places in at.items():
                wanted = {x for x in Position if self._held(path, m, x)}
                wanted |= {x for x in Position for s, _ in places if self._kept_open(path, s, m, x)}
                if len(wanted) < 2:
                    section, point = places[0]
                    why = Because("R10", f"{point.id} lies in {section} beside the path; driven, never a condition")
                    out.append(PointDemand(m, next(iter(wanted), Position.NORMAL), Role.DRIVEN, section, why))
        return tuple(out)

    def report(self, sink: Sink) -> None:
        """IL7011."""
        late: _Places = {}
        closed: _Places = {}
        for q in self._paths:
            lies = {d.machine: d.position for d in self.driven[q.id]}
            for s, p in self._of(q, [t.section for t in (*q.ways, *q.overlap)]):
                for x in (x for x in Position if lies.get(p.machine) is not x):
                    _note(late, p.id, s, q, x, self._held(q, p.machine, x))
                    if any(t.section == s for t in q.ways):  # no train is in an overlap
                        _note(closed, p.id, s, q, x, self._kept_open(q, s, p.machine, x))
        own = "give {} a section of its own"
        for (point, s), (before, after) in late.items():
            text = f"{point} lies in {s}, and cannot move once {_listed(before)} has locked it: then {_listed(after)} "
            text += f"can be set only if {point} lies so"
            fix = f"{own.format(point)}, or set first the routes that need it"
            sink.add("IL7011", text, None, fix, about=Element("points", point))
        for (point, s), (before, after) in closed.items():
            text = (
                f"{point} lies in {s}, and cannot move once {_listed(before)} has locked it: a train there closes the "
            )
            text += f"signal of {_listed(after)}, of which it may be foul unless {point} lies so"
            fix = f"{own.format(point)}, or have {_listed(before)} lock it so: `demand`"
            sink.add("IL7011", text, None, fix, about=Element("points", point))

    def _of(self, path: Path, sections: Sequence[SectionId]) -> Iterator[tuple[SectionId, Point]]:
        """The points of sections that a route does not hold."""
        held = {d.machine for d in self._demands[path.id]}
        for s in dict.fromkeys(sections):
            yield from ((s, p) for p in self._layout.machines.points_in.get(s, ()) if p.machine not in held)


_Places = dict[tuple[PointId, SectionId], tuple[dict[RouteId, None], dict[str, None]]]
"""By a point and its section: the routes that lock the section, and those that want the point to lie so."""


def _note(at: _Places, p: PointId, s: SectionId, q: Path, x: Position, others: Iterable[Path]) -> None:
    """Other routes want a point in a position that a route does not bring about."""
    for other in others:
        before, after = at.setdefault((p, s), ({}, {}))
        before[q.id], after[f"{other.id} ({x})"] = None, None


def _listed(routes: Iterable[str]) -> str:
    """The first of some routes, and how many there are beside them."""
    own = list(routes)
    return " or ".join(own[:3]) + (f" ({len(own) - 3} more)" if len(own) > 3 else "")
