"""Plain track between points: what usual practice speaks of when it speaks of tracks, starting signals and sidings."""

from __future__ import annotations

from functools import lru_cache

from interlock.dataclass import dataclass
from interlock.model.elements import BoundaryKind, BufferKind, Edge, EdgeId, NodeId, SectionId, Signal
from interlock.model.layout import Layout
from interlock.model.traversal import onward_edges


@dataclass(frozen=True)
class Plain:
    """Plain track from one point, diamond, boundary or buffer (the first node) to the next (the last node).

    `sections`: those that lie in it whole.  `metres`: their length together.
    """

    nodes: tuple[NodeId, ...]
    edges: tuple[Edge, ...]
    sections: tuple[SectionId, ...]
    metres: float

    @property
    def name(self) -> SectionId | None:
        """The section by which it is called: the longest of its own."""
        own = {s: sum(e.length for e in self.edges if e.section == s) for s in self.sections}
        return max(own, key=lambda s: own[s], default=None)

    def end(self, forward: bool) -> NodeId:
        """Where one comes to: over the edges as they are in order, or backward.  (Both are one node in a loop.)"""
        return self.nodes[-1] if forward else self.nodes[0]

    def runs(self, forward: bool) -> bool:
        """Whether trains may run over all of it that way."""
        nodes = self.nodes[:-1] if forward else self.nodes[1:]
        return all(not e.one_way or e.a == n for n, e in zip(nodes, self.edges, strict=True))


class Plains:
    """Every stretch of plain track of a layout, with the signals on it."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        pointed = {e.section for e in layout.track.edges for n in (e.a, e.b) if self.special(n) and not self.ended(n)}
        self.all: list[Plain] = []
        self.of: dict[EdgeId, Plain] = {}
        """The stretch of each edge."""
        self.by_id: dict[int, Plain] = {}
        for first in sorted(layout.track.edges_at):
            if self.special(first):
                for e in layout.track.edges_at[first]:
                    if e.id not in self.of:
                        self._add(first, e, pointed)
        for e in layout.track.edges:  # closed rings
            if e.id not in self.of:
                self._add(e.a, e, pointed)
        self.signals: dict[int, list[tuple[Signal, bool]]] = {}
        """The signals on each stretch, and whether they look forward."""
        for g in layout.signalling.signals:
            p = self.of[g.into]
            self.signals.setdefault(id(p), []).append((g, self._forward(p, g)))

    def special(self, node: NodeId) -> bool:
        """Whether plain track ends at a node."""
        return self.ended(node) or node in self.layout.pointwork.point_at or node in self.layout.pointwork.crossing_at

    def ended(self, node: NodeId) -> bool:
        """Whether the track ends there, or the layout."""
        return node in self.layout.track.boundary_at or node in self.layout.track.buffer_at

    def pointed(self, node: NodeId) -> bool:
        """Whether points or a diamond lie at a node."""
        return node in self.layout.pointwork.point_at or node in self.layout.pointwork.crossing_at

    def _add(self, first: NodeId, e: Edge, pointed: set[SectionId]) -> None:
        nodes, edges = [first], [e]
        while True:
            nodes.append(self.layout.track.far(edges[-1].id, nodes[-1]))
            onward = [x for x in self.layout.track.edges_at[nodes[-1]] if x.id != edges[-1].id]
            if self.special(nodes[-1]) or len(onward) != 1 or onward[0] in edges:
                break
            edges.append(onward[0])
        own = tuple(dict.fromkeys(x.section for x in edges if x.section not in pointed))
        found = Plain(tuple(nodes), tuple(edges), own, sum(x.length for x in edges if x.section in own))
        self.all.append(found)
        self.by_id[id(found)] = found
        for x in edges:
            self.of[x.id] = found

    def _forward(self, p: Plain, g: Signal) -> bool:
        return p.nodes[next(k for k, e in enumerate(p.edges) if e.id == g.into)] == g.node

    def looking(self, p: Plain, forward: bool) -> list[Signal]:
        """The signals on a stretch that look one way."""
        return [g for g, way in self.signals.get(id(p), ()) if way == forward]

    def behind_points(self, g: Signal) -> tuple[NodeId, float] | None:
        """The points or diamond that lie in the section before a signal, the last that a train passes; how many metres
        lie between."""
        p = self.of[g.into]
        forward = self._forward(p, g)
        rear, into = p.end(not forward), next(k for k, e in enumerate(p.edges) if e.id == g.into)
        before = p.edges[:into] if forward else p.edges[into + 1 :]
        inside = bool(before) and not any(e.section in p.sections for e in before)
        return (rear, sum(e.length for e in before)) if inside and self.pointed(rear) else None

    def turned(self, g: Signal) -> bool:
        """Whether a main signal looks the wrong way: from points into a track from which trains come without a signal.

        It stands where a signal out of that track belongs, there is none in that place, and trains come from there.
        They do not where the way out leads only to boundaries at which trains come in: all run the other way.
        """
        p = self.of[g.into]
        forward = self._forward(p, g)
        far = p.end(forward)
        if not g.main or not p.sections or self.behind_points(g) is None:
            return False
        at = {x.id for x in self.layout.signalling.signals if x.node == g.node}
        if at != {g.id}:
            return False
        boundary, buffer = self.layout.track.boundary_at.get(far), self.layout.track.buffer_at.get(far)
        nothing = boundary is not None and boundary.kind is BoundaryKind.OUT
        nothing = nothing or (buffer is not None and buffer.kind is not BufferKind.STOP)
        return p.runs(not forward) and not nothing and self._leads_out(g)

    def _leads_out(self, g: Signal) -> bool:
        """Whether a train that came towards the back of a signal could run on to where it may leave, or stand."""
        todo, seen = [(g.node, g.into)], set[tuple[NodeId, EdgeId]]()
        while todo:
            node, arriving = todo.pop()
            boundary, buffer = self.layout.track.boundary_at.get(node), self.layout.track.buffer_at.get(node)
            if boundary is not None or buffer is not None:
                if boundary is not None and boundary.kind is not BoundaryKind.IN:
                    return True
                if buffer is not None and buffer.kind is BufferKind.STOP:
                    return True
                continue
            for e in onward_edges(self.layout, node, arriving):
                ahead = self.layout.track.far(e, node), e
                if ahead not in seen:
                    seen.add(ahead)
                    todo.append(ahead)
        return False


@lru_cache(maxsize=8)
def plains(layout: Layout) -> Plains:
    """The plain track of a layout, found once."""
    return Plains(layout)
