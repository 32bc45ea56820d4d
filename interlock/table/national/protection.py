"""What lies between a place that asks for flank protection and what protects it, for forms that print it.

Read from the track and from the table's cells: nothing is derived anew.  `transfer`: the point that is met at its toe,
so that both of its legs must be protected; `first`: the point that is met first, over plain track and at one of its
legs, and how it would lie to turn vehicles away, whether it is the protection or not.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.model.elements import EdgeId, MachineId, NodeId, PointId, Position, SectionId
from interlock.model.layout import Layout
from interlock.table.cells import FlankCell, ProviderKind
from interlock.table.rows import InterlockingTable

Need = tuple[MachineId, Position]


@dataclass(frozen=True)
class Reach:
    """The track between a requester and its protection; `space`: its sections without the requester's own."""

    transfer: PointId | None
    first: Need | None
    space: tuple[SectionId, ...]


@dataclass(frozen=True)
class Protection:
    """The flank cells of a table over the track."""

    layout: Layout
    table: InterlockingTable

    @cached_property
    def cells(self) -> tuple[FlankCell, ...]:
        """Every requester with each set of its providers, once."""
        return tuple(dict.fromkeys(c for t in self.table.locks for c in t.flank))

    @cached_property
    def _asked(self) -> dict[FlankCell, frozenset[str]]:
        found: dict[FlankCell, set[str]] = {}
        for t in self.table.locks:
            for c in t.flank:
                found.setdefault(c, set()).update(s.name for s in t.space if not s.lamp)
        return {c: frozenset(names) for c, names in found.items()}

    def space(self, c: FlankCell) -> tuple[list[str], list[str]]:
        """The sections between a requester and its protection: reported clear, and not."""
        asked = self._asked.get(c, frozenset())
        sections = self.reach(c).space
        return [s for s in sections if s in asked], [s for s in sections if s not in asked]

    @cached_property
    def _known(self) -> dict[FlankCell, Reach]:
        return {}

    def reach(self, c: FlankCell) -> Reach:
        """What lies between a requester and its protection."""
        if c not in self._known:
            self._known[c] = self._reach(c)
        return self._known[c]

    def place(self, c: FlankCell) -> tuple[NodeId, EdgeId] | None:
        """Where the requester looks outward: the node of its point or diamond, and the edge of its leg or arm."""
        name, _, leg = c.requester.rpartition(".")
        point = self.layout.pointwork.point.get(PointId(name))
        if point is not None and leg in ("normal", "reverse"):
            return point.node, point.normal if leg == "normal" else point.reverse
        for x in self.layout.pointwork.crossings:
            if x.id == name:
                return x.node, x.arms[int(leg[0]) - 1]["ab".index(leg[1])]
        return None

    def _reach(self, c: FlankCell) -> Reach:
        at = self.place(c)
        signals = {p.name for p in c.providers if p.kind is ProviderKind.SIGNAL}
        if at is None or any(p.kind is ProviderKind.WAIVED for p in c.providers):
            return Reach(None, None if at is None else self._first(at, signals), ())
        turned = {(p.name, p.position) for p in c.providers}
        space: dict[SectionId, None] = {}
        transfer: PointId | None = None
        todo, seen = [(at[1], at[0])], set[tuple[EdgeId, NodeId]]()
        while todo:
            edge, node = todo.pop()
            e = self.layout.track.edge[edge]
            if (edge, node) in seen or (e.one_way and e.a == node):
                continue
            seen.add((edge, node))
            far = self.layout.track.far(edge, node)
            point = self.layout.pointwork.point_at.get(far)
            lies = point.position_of(edge) if point is not None else None
            if point is not None and lies is not None and (point.machine, lies.other) in turned:
                if self.layout.track.section_of(point.toe) != e.section:
                    space[e.section] = None
                continue
            space[e.section] = None
            signal = self.layout.signalling.facing.get((far, edge))
            if signal is not None and signal.id in signals:
                continue
            if point is not None and lies is None and transfer is None:
                transfer = point.id
            todo += [(x, far) for x in self._onward(edge, far, at[0])]
        space.pop(c.section, None)
        return Reach(transfer, self._first(at, signals), tuple(sorted(space)))

    def _onward(self, edge: EdgeId, node: NodeId, start: NodeId) -> Sequence[EdgeId]:
        stops = node == start or node in self.layout.track.boundary_at or node in self.layout.track.buffer_at
        return () if stops else [x.id for x in self.layout.onward(edge, node)]

    def _first(self, at: tuple[NodeId, EdgeId], signals: set[str]) -> Need | None:
        """The point met first over plain track, at one of its legs, before any signal that protects."""
        node, edge = at
        for _ in self.layout.track.edges:
            node = self.layout.track.far(edge, node)
            point = self.layout.pointwork.point_at.get(node)
            if point is not None:
                lies = point.position_of(edge)
                return None if lies is None else (point.machine, lies.other)
            signal = self.layout.signalling.facing.get((node, edge))
            onward = self._onward(edge, node, at[0])
            if (signal is not None and signal.id in signals) or len(onward) != 1:
                return None
            edge = onward[0]
        return None
