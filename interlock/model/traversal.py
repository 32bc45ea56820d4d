"""Ways through a section: from one of its ends to another, with the point positions needed.

A section's ends are its joints with neighbours, boundaries and buffers.  The plant, the derivation
and the strengthening invariants all speak of traversals; the audit walks the edges itself instead.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable

from interlock.dataclass import dataclass
from interlock.model.elements import (
    BufferKind,
    CrossingId,
    EdgeId,
    NodeId,
    PointId,
    Position,
    SectionId,
    SignalId,
    Zone,
)
from interlock.model.layout import Layout, of_layout
from interlock.model.too_many import through


@dataclass(frozen=True)
class Traversal:
    """One way through a section.

    `points` gives the position of every point on the way, `crossings` the arm (0 or 1) of every diamond.
    `number` counts the traversals of the section from 1.
    """

    section: SectionId
    number: int
    entry: NodeId
    exit: NodeId
    points: tuple[tuple[PointId, Position], ...]
    crossings: tuple[tuple[CrossingId, int], ...]
    edges: tuple[EdgeId, ...]
    length: float

    @property
    def key(self) -> tuple[SectionId, int]:
        """Section and number."""
        return (self.section, self.number)


class Topology:
    """Sections, their ends, neighbours, traversals and the signals at the ends."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self.ends: dict[SectionId, tuple[NodeId, ...]] = {}
        self._edges_of: dict[SectionId, list[EdgeId]] = {}
        for e in layout.track.edges:
            self._edges_of.setdefault(e.section, []).append(e.id)
        self.sections: tuple[SectionId, ...] = tuple(s for s in sorted(self._edges_of))
        self._touch: dict[NodeId, list[SectionId]] = {}
        for s in self.sections:
            nodes = dict.fromkeys(
                n for eid in self._edges_of[s] for n in (layout.track.edge[eid].a, layout.track.edge[eid].b)
            )
            self.ends[s] = tuple(sorted(n for n in nodes if self._is_end(n)))
            for n in self.ends[s]:
                self._touch.setdefault(n, []).append(s)
        self.traversals: dict[SectionId, tuple[Traversal, ...]] = {
            s: tuple(self._walk_section(s)) for s in self.sections
        }
        self.signal_into: dict[tuple[NodeId, SectionId], SignalId] = {
            (g.node, layout.track.section_of(g.into)): g.id for g in layout.signalling.signals
        }
        self.main_into = {k: g for k, g in self.signal_into.items() if layout.signalling.signal[g].main}
        self.shunt_into = {k: g for k, g in self.signal_into.items() if layout.signalling.signal[g].shunt}
        self.standing: frozenset[SectionId] = frozenset(s for s in self.sections if self._is_standing(s))
        """Where vehicles may be left standing, so that a signal at the end is closed by the first axle (R2, R3)."""
        under = {s for d in layout.signalling.devices for s in d.over}
        self.berths: frozenset[SectionId] = self.standing - under - set(layout.declared.no_berths)
        """Where shunting movements end and may find vehicles: not under a door, on a bridge, or over a crossing, nor
        where the layout says no."""
        self.turning: frozenset[SectionId] = self.standing - under - self.berths
        """Roads that the layout denies to be berths: before a boundary shunting movements end in them, too."""

    def _is_end(self, node: NodeId) -> bool:
        """Whether sections end at this node."""
        if node in self.layout.track.boundary_at or node in self.layout.track.buffer_at:
            return True
        if node in self.layout.pointwork.point_at or node in self.layout.pointwork.crossing_at:
            return False
        return len({e.section for e in self.layout.track.edges_at[node]}) > 1

    def signals_out(self, section: SectionId) -> tuple[SignalId, ...]:
        """The signals that govern leaving a section over its joints."""
        found = ((n, self.beyond(section, n)) for n in self.ends[section])
        return tuple(self.signal_into[n, o] for n, o in found if o is not None and (n, o) in self.signal_into)

    def _is_standing(self, section: SectionId) -> bool:
        """A plain section that is left over its joints only on a signal, one of them at least a shunt signal."""
        if any(t.points or t.crossings for t in self.traversals[section]):
            return False
        joints = [n for n in self.ends[section] if self.beyond(section, n) is not None]
        out = self.signals_out(section)
        return len(out) == len(joints) and any(self.layout.signalling.signal[g].shunt for g in out)

    def beyond(self, section: SectionId, node: NodeId) -> SectionId | None:
        """The neighbour across an end, or None at a boundary or buffer."""
        for other in self._touch.get(node, ()):
            if other != section:
                return other
        return None

    def joints(self) -> tuple[tuple[NodeId, SectionId, SectionId], ...]:
        """Every joint between two sections, once."""
        return tuple((n, ss[0], ss[1]) for n, ss in sorted(self._touch.items()) if len(ss) == 2)

    def through(self, section: SectionId, entry: NodeId) -> tuple[Traversal, ...]:
        """The traversals of a section that start at an end."""
        return tuple(t for t in self.traversals[section] if t.entry == entry)

    def paths(self, keys: Iterable[Iterable[tuple[SectionId, int]]]) -> tuple[tuple[Traversal, ...], ...]:
        """Paths by the keys of their traversals."""
        return tuple(tuple(self.traversals[s][n - 1] for s, n in ways) for ways in keys)

    def _reversed(self, t: Traversal) -> Traversal | None:
        """The same way in the other direction, if trains may run it."""
        for other in self.traversals[t.section]:
            if other.entry == t.exit and other.exit == t.entry and other.points == tuple(reversed(t.points)):
                return other
        return None

    def _walk_section(self, section: SectionId) -> list[Traversal]:
        layout = self.layout
        mine = set(self._edges_of[section])
        found: list[tuple[NodeId, NodeId, tuple[EdgeId, ...]]] = []

        counted = {start: through(section) for start in self.ends[section]}
        todo = [
            (start, [e.id], start, frozenset({start}))
            for start in self.ends[section]
            for e in layout.track.edges_at[start]
            if e.id in mine
        ]
        while todo:  # with a list, not with calls: there may be more points in a row than calls may be deep
            node, path, start, seen = todo.pop()
            edge = path[-1]
            e = layout.track.edge[edge]
            if e.one_way and e.a != node:
                counted[start].one()
                continue
            nxt = layout.track.far(edge, node)
            if nxt in layout.track.buffer_at and layout.track.buffer_at[nxt].kind is BufferKind.DERAIL:
                counted[start].one()
                continue  # off the rails: no way at all
            onward = [x for x in onward_edges(layout, nxt, edge) if x in mine]
            if self._is_end(nxt):
                counted[start].one()
                found.append((start, nxt, tuple(path)))
            elif nxt in seen or not onward:
                counted[start].one()
            else:
                todo += [(nxt, [*path, x], start, seen | {nxt}) for x in onward]
        return [self._traversal(section, i, a, b, path) for i, (a, b, path) in enumerate(sorted(found), start=1)]

    def _traversal(self, section: SectionId, number: int, a: NodeId, b: NodeId, path: tuple[EdgeId, ...]) -> Traversal:
        layout = self.layout
        points: list[tuple[PointId, Position]] = []
        crossings: list[tuple[CrossingId, int]] = []
        node = a
        for here, onward in itertools.pairwise(path):
            node = layout.track.far(here, node)
            point = layout.pointwork.point_at.get(node)
            if point is not None:
                leg = here if onward == point.toe else onward
                position = point.position_of(leg)
                assert position is not None
                points.append((point.id, position))
            crossing = layout.pointwork.crossing_at.get(node)
            if crossing is not None:
                crossings.append((crossing.id, 0 if here in crossing.arms[0] else 1))
        length = sum(layout.track.edge[e].length for e in path)
        return Traversal(section, number, a, b, tuple(points), tuple(crossings), path, length)


def onward_edges(layout: Layout, node: NodeId, arriving: EdgeId) -> tuple[EdgeId, ...]:
    """The edges on which a vehicle can go on that comes to a node over an edge.

    Over a point: from the toe to either leg, from a leg to the toe.  Over a diamond: straight on.
    """
    point = layout.pointwork.point_at.get(node)
    if point is not None:
        return (point.normal, point.reverse) if arriving == point.toe else (point.toe,)
    crossing = layout.pointwork.crossing_at.get(node)
    if crossing is not None:
        for a, b in crossing.arms:
            if arriving == a:
                return (b,)
            if arriving == b:
                return (a,)
        return ()
    return tuple(e.id for e in layout.track.edges_at[node] if e.id != arriving)


def zone_joints(topo: Topology, z: Zone) -> list[tuple[SectionId, NodeId]]:
    """Where trains come into a zone: each section of it with an end beyond which the zone does not lie."""
    ends = [(s, j) for s in z.sections for j in topo.ends[s] if j not in topo.layout.track.buffer_at]
    return [(s, j) for s, j in ends if topo.beyond(s, j) not in z.sections]


@of_layout
def topology(layout: Layout) -> Topology:
    """The topology of a layout (kept, since several packages ask for it)."""
    return Topology(layout)


def path_speed(layout: Layout, ways: Collection[Traversal]) -> int | None:
    """The lowest speed in km/h that the layout states along a path; None where it states none (R11)."""
    found = [layout.track.section[t.section].speed for t in ways]
    found += [layout.pointwork.point[p].speed for t in ways for p, x in t.points if x is Position.REVERSE]
    return min((v for v in found if v is not None), default=None)


Run = tuple[EdgeId, NodeId]
"""An edge, run over from a node."""


@of_layout
def runaways(layout: Layout) -> frozenset[Run]:
    """From where one comes, going on whichever way points and one-way sections lie, to an inclined lane, or over a
    derailer to what lies behind it: vehicles run away from there, also against the one way of a section (R5)."""
    before: dict[Run, list[Run]] = {}
    found: list[Run] = []
    for e in layout.track.edges:
        for node in (e.a, e.b):
            far = layout.track.far(e.id, node)
            point = layout.pointwork.point_at.get(far)
            if e.inclined or (point is not None and point.derailer and e.id != point.toe):
                found.append((e.id, node))
            for onward in onward_edges(layout, far, e.id):
                before.setdefault((onward, far), []).append((e.id, node))
    reached = set(found)
    for run in found:
        new = [x for x in before.get(run, ()) if x not in reached]
        reached.update(new)
        found += new
    return frozenset(reached)
