"""The rails in metres: directed stretches, what follows each of them, signals, points, and where vehicles are foul.

A stretch is an edge of the layout in one direction: number 2*e from its end a to its end b, 2*e+1 back.  Beyond
each boundary lies a line of our own: in through `line` and the approach section, out over a stretch apart, since what
happens beyond a boundary is the neighbour's (he never sends trains against each other on one track).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.model.elements import BlockKind, BoundaryKind, BufferKind, Position
from interlock.model.layout import Layout
from interlock.model.traversal import topology

LINE_M = 400.0
"""Metres of line beyond an approach section on which trains appear."""

LEAVES_M = 300.0
"""Metres beyond the approach section, or the boundary, after which a train that leaves is gone."""

NONE = -1


@dataclass
class Beyond:
    """The line beyond a boundary: stretches by which trains come and go; metres of approach section."""

    name: str
    block: BlockKind
    comes: int = NONE
    comes_by: tuple[int, ...] = ()
    goes: int = NONE
    approach_m: float = 0.0


@dataclass
class Stretch:
    """A directed stretch; `on`: what follows at its end; at a facing point `on` by position of its machine."""

    edge: int
    metres: float
    section: int
    on: int = NONE
    machine: int = NONE
    facing: tuple[int, int] | None = None
    needs: int = NONE
    signal: int = NONE
    derails: bool = False
    outside: bool = False


@dataclass
class Track:
    """All stretches of a layout, with names of sections, machines and signals by number."""

    layout: Layout
    stretches: list[Stretch] = field(default_factory=list)
    sections: list[str] = field(default_factory=list)
    machines: list[str] = field(default_factory=list)
    signals: list[str] = field(default_factory=list)
    begins: list[int] = field(default_factory=list)
    """By signal: the stretch that begins at it, read by trains that go onto it."""
    beyond: list[Beyond] = field(default_factory=list)
    zones: dict[int, list[tuple[int, int, float, float]]] = field(default_factory=dict)
    """By edge: foul ground as (number of a point or diamond, side 0 or 1, from, to), metres from the edge's end a."""
    names_of_zones: list[str] = field(default_factory=list)
    neighbours: list[tuple[int, ...]] = field(default_factory=list)
    berths: frozenset[int] = frozenset()

    @staticmethod
    def of(layout: Layout) -> Track:
        """The rails of a layout; an approach section whose length is not stated has 400 m."""
        t = Track(layout)
        t.sections = [str(s.id) for s in layout.track.sections]
        t.machines = [str(m) for m in layout.machines]
        t.signals = [str(g.id) for g in layout.signalling.signals]
        section = {s: i for i, s in enumerate(t.sections)}
        for e in layout.track.edges:
            for _ in (0, 1):
                t.stretches.append(Stretch(len(t.stretches) // 2, max(e.length, 0.1), section[str(e.section)]))
        number = {str(e.id): i for i, e in enumerate(layout.track.edges)}
        starts = {e.id: (e.a, e.b) for e in layout.track.edges}

        def out_of(edge: str, node: str) -> int:
            """The stretch over an edge that begins at a node."""
            return 2 * number[edge] + (0 if starts[edge][0] == node else 1)  # type: ignore[index]

        for e in layout.track.edges:
            for back, node in ((0, e.b), (1, e.a)):
                s = t.stretches[2 * number[e.id] + back]
                point = layout.pointwork.point_at.get(node)
                buffer = layout.track.buffer_at.get(node)
                onward = layout.onward(e.id, node)
                if point is not None:
                    s.machine = t.machines.index(str(point.machine))
                    position = point.position_of(e.id)
                    if position is None:
                        s.facing = (out_of(point.normal, node), out_of(point.reverse, node))
                    else:
                        s.needs = 0 if position is Position.NORMAL else 1
                        s.on = out_of(point.toe, node)
                elif buffer is not None:
                    s.derails = buffer.kind is BufferKind.DERAIL
                elif node not in layout.track.boundary_at and onward:
                    s.on = out_of(onward[0].id, node)
        t.begins = [out_of(g.into, g.node) for g in layout.signalling.signals]
        for i, d in enumerate(t.begins):
            t.stretches[d].signal = i
        t._lines(section, out_of)
        t._foul(number)
        t._near()
        t.berths = frozenset(section[str(s)] for s in topology(layout).berths)
        return t

    def _lines(self, section: Mapping[str, int], out_of: Callable[[str, str], int]) -> None:
        for b in self.layout.track.boundaries:
            inside = self.layout.track.edges_at[b.node][0]
            begins = out_of(inside.id, b.node)
            ends = begins ^ 1
            here = section[str(b.approach)] if b.approach is not None and str(b.approach) in section else NONE
            metres = b.approach_m or 400.0
            line = Beyond(str(b.node), b.block, approach_m=metres if here != NONE else 0.0)
            if b.kind is not BoundaryKind.OUT:
                rear = self._outside(LINE_M, NONE)
                line.comes, line.comes_by = rear, (rear,)
                if here != NONE:
                    near = self._outside(metres, here)
                    self.stretches[rear].on = near
                    line.comes_by = (rear, near)
                self.stretches[line.comes_by[-1]].on = begins
            if b.kind is not BoundaryKind.IN:
                line.goes = self._outside(line.approach_m + LEAVES_M, here)
                self.stretches[ends].on = line.goes
            self.beyond.append(line)

    def _outside(self, metres: float, section: int) -> int:
        edge = len(self.stretches) // 2
        self.stretches.append(Stretch(edge, metres, section, outside=True))
        self.stretches.append(Stretch(edge, metres, section, outside=True))
        return 2 * edge

    def _foul(self, number: Mapping[str, int]) -> None:
        """Foul ground: so far from a point along either leg, as stated; likewise from a diamond along its arms."""
        layout = self.layout
        for p in layout.pointwork.points:
            zone = len(self.names_of_zones)
            self.names_of_zones.append(f"point {p.id}")
            if not p.derailer:
                for side, leg in enumerate((p.normal, p.reverse)):
                    self._walk(number, leg, p.node, p.fouling, zone, side, False, {leg})
        for c in layout.pointwork.crossings:
            zone = len(self.names_of_zones)
            self.names_of_zones.append(f"diamond {c.id}")
            for side, arm in enumerate(c.arms):
                for edge in arm:
                    self._walk(number, edge, c.node, c.fouling, zone, side, True, {edge})

    def _walk(
        self,
        number: Mapping[str, int],
        edge: str,
        node: str,
        left: float,
        zone: int,
        side: int,
        diamond: bool,
        seen: set[str],
    ) -> None:
        e = self.layout.track.edge[edge]  # type: ignore[index]
        reach = min(left, e.length)
        lo, hi = (0.0, reach) if e.a == node else (e.length - reach, e.length)
        self.zones.setdefault(number[edge], []).append((zone, side, lo, hi))
        far = self.layout.track.far(e.id, node)  # type: ignore[arg-type]
        if left <= e.length or far in self.layout.track.boundary_at:
            return
        point = self.layout.pointwork.point_at.get(far)
        if diamond and point is not None and point.toe != e.id:
            return  # the tracks have met: beyond its toe nothing is foul of the diamond
        for o in self.layout.onward(e.id, far):
            if o.id not in seen:
                seen.add(o.id)
                self._walk(number, o.id, far, left - e.length, zone, side, diamond, seen)

    def _near(self) -> None:
        """Neighbouring sections: those that a vehicle can stand in at once across one joint."""
        found: list[set[int]] = [set() for _ in self.sections]
        for s in self.stretches:
            for o in (s.on, *(s.facing or ())):
                if o != NONE:
                    a, b = s.section, self.stretches[o].section
                    if a != b and NONE not in (a, b):
                        found[a].add(b)
                        found[b].add(a)
        self.neighbours = [tuple(sorted(x)) for x in found]
