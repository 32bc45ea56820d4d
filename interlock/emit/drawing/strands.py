"""The layout as a graph of strands: stretches of track between points, crossings, boundaries and ends of track.

Every strand gets a left and a right end.  A point has its toe on one side and its legs on the other, a joint goes
straight on, an arm of a crossing too; so one choice orients everything that hangs together, but for the two arms of a
crossing: they may be told apart, and then every way of turning them is tried (`place`).  A track that runs back into
the plan (a balloon loop, a triangle) is first cut where it turns (`turns`).
"""

from __future__ import annotations

from collections import deque
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.model.elements import BufferKind, EdgeId, NodeId, Point
from interlock.model.layout import Layout

CROSSOVER = 250.0  # metres: what is longer between two turned legs is a track


@dataclass(frozen=True)
class Strand:
    """Edges from the left end to the right one, and the nodes between and around them."""

    number: int
    edges: tuple[EdgeId, ...]
    nodes: tuple[NodeId, ...]

    @property
    def left(self) -> NodeId:
        """The left end."""
        return self.nodes[0]

    @property
    def right(self) -> NodeId:
        """The right end."""
        return self.nodes[-1]


class Plan:
    """The strands of a layout, oriented; `mirrored` turns parts round, counted in the order in which they are found.

    `turns`: nodes at which a track turns back, so that both its parts lie on one side of them.
    """

    def __init__(self, layout: Layout, mirrored: int = 0, turns: frozenset[NodeId] = frozenset()) -> None:
        self.layout = layout
        self.turns = turns
        self.parts = 0
        self._mirrored = mirrored
        self.slip_points = [layout.pointwork.point[b.point] for b in layout.pointwork.blades if len(b.at) == 1]
        """Points of slips with a diamond: on the arms, close to it, and no knots."""
        self.rails = {p.reverse for p in self.slip_points}
        """Slip rails: chords of their diamond, without a place of their own."""
        on_arms = {p.node for p in self.slip_points}
        self.knots = {
            n
            for n, edges in layout.track.edges_at.items()
            if len(edges) != 2
            or n in layout.pointwork.point_at
            or n in layout.pointwork.crossing_at
            or n in layout.track.boundary_at
        } - on_arms
        self.knots |= set(layout.track.buffer_at) | turns
        oriented = self._oriented(self._contracted())
        off = {b.node for b in layout.track.buffers if b.kind is BufferKind.DERAIL}
        self.stubs = [s for s in oriented if s.left in off or s.right in off]
        """Legs that lead off the rails: a short stroke, without a place of their own."""
        self.strands = [s for s in oriented if s not in self.stubs]

    def _contracted(self) -> list[Strand]:
        out: list[Strand] = []
        done: set[EdgeId] = set()
        for e in self.layout.track.edges:
            if e.id in done or e.id in self.rails:
                continue
            back, behind = self._walk(e.id, e.a)  # back to the beginning, then forward
            edges, nodes = self._walk(back[-1], self.layout.track.far(back[-1], behind[-1]))
            done |= set(edges)
            out.append(Strand(len(out), tuple(edges), tuple(nodes)))
        return out

    def _walk(self, edge: EdgeId, towards: NodeId) -> tuple[list[EdgeId], list[NodeId]]:
        """From an edge on to the next knot; the nodes begin with the one behind."""
        edges, nodes = [edge], [self.layout.track.far(edge, towards), towards]
        while nodes[-1] not in self.knots:
            onward = next(
                (x.id for x in self.layout.track.edges_at[nodes[-1]] if x.id != edges[-1] and x.id not in self.rails),
                None,
            )
            if onward is None or onward == edges[0]:
                break
            edges.append(onward)
            nodes.append(self.layout.track.far(onward, nodes[-1]))
        return edges, nodes

    def _oriented(self, raw: list[Strand]) -> list[Strand]:
        at: dict[NodeId, list[int]] = {}
        for s in raw:
            for n in {s.nodes[0], s.nodes[-1]}:
                at.setdefault(n, []).append(s.number)
        forward: dict[int, bool] = {}
        for first in raw:
            if first.number in forward:
                continue
            forward[first.number] = True
            found = [first.number]
            todo = deque([first.number])
            while todo:
                k = todo.popleft()
                for end in (raw[k].nodes[0], raw[k].nodes[-1]):
                    mine = raw[k].edges[0] if end == raw[k].nodes[0] else raw[k].edges[-1]
                    arrives = forward[k] is (end == raw[k].nodes[-1])
                    for other in at[end]:
                        theirs = raw[other].edges[0] if end == raw[other].nodes[0] else raw[other].edges[-1]
                        same = self._same_side(end, mine, theirs)
                        if other == k or same is None or other in forward:
                            continue
                        lands = arrives if same else not arrives
                        forward[other] = lands is (end == raw[other].nodes[-1])
                        found.append(other)
                        todo.append(other)
            along = sum(1 if self._declared(raw[k]) is forward[k] else -1 for k in found)
            if (along < 0) is not bool(self._mirrored >> self.parts & 1):
                for k in found:
                    forward[k] = not forward[k]
            self.parts += 1
        out = []
        for s in raw:
            keeps = forward[s.number]
            out.append(s if keeps else Strand(s.number, s.edges[::-1], s.nodes[::-1]))
        return out

    @cached_property
    def slips(self) -> frozenset[NodeId]:
        """Diamonds with slip rails."""
        far = {self.layout.track.far(p.normal, p.node) for p in self.slip_points}
        far |= {NodeId(b.point) for b in self.layout.pointwork.blades if len(b.at) == 2}  # of `with_diamonds`
        return frozenset(far & set(self.layout.pointwork.crossing_at))

    def _declared(self, s: Strand) -> bool:
        """Whether most edges of a strand run as they are declared."""
        ahead = sum(self.layout.track.edge[e].a == n for e, n in zip(s.edges, s.nodes, strict=False))
        return 2 * ahead >= len(s.edges)

    def _same_side(self, node: NodeId, a: EdgeId, b: EdgeId) -> bool | None:
        """Whether two edges leave a knot on the same side; None when it says nothing."""
        if node in self.turns:
            return True
        point = self.layout.pointwork.point_at.get(node)
        if point is not None:
            return (a == point.toe) is (b == point.toe)
        crossing = self.layout.pointwork.crossing_at.get(node)
        if crossing is not None:
            for arm in crossing.arms:
                if a in arm and b in arm:
                    return a == b
            if node in self.slips:  # slip rails lead across: ends of one letter lie on one side
                return any(a in side and b in side for side in zip(*crossing.arms, strict=True))
        return None  # the other arm may lie either way

    # --- which ends bend --------------------------------------------------------------------------

    def diverges(self, s: Strand, node: NodeId) -> bool:
        """Whether a strand leaves a knot on a diagonal: the leg of a point that is not straight, a diagonal arm."""
        edge = s.edges[0] if node == s.left else s.edges[-1]
        point = self.layout.pointwork.point_at.get(node)
        if point is not None:
            return edge == self.turned_leg(point)
        crossing = self.layout.pointwork.crossing_at.get(node)
        if crossing is not None:
            return any(edge in crossing.arms[k] for k in self.diagonal_arms[crossing.id])
        return False

    def crossover(self, s: Strand) -> bool:
        """Whether a strand between two turned legs is short and bears no signal, so that it is all diagonal."""
        layout = self.layout
        signals = any((n, e) in layout.signalling.facing for n in s.nodes for e in s.edges)
        return not signals and sum(layout.track.edge[e].length for e in s.edges) <= CROSSOVER

    def turned_leg(self, point: Point) -> EdgeId:
        """The leg that is drawn as a diagonal."""
        return point.normal if point.derailer else point.reverse

    @cached_property
    def diagonal_arms(self) -> dict[str, tuple[int, ...]]:
        """The arms of each crossing that are drawn as diagonals: those between turned legs, at least one."""
        out: dict[str, tuple[int, ...]] = {}
        of_edge = {e: s for s in self.strands for e in s.edges}
        for c in self.layout.pointwork.crossings:
            turned = []
            for k, arm in enumerate(c.arms):
                for edge in arm:
                    s = of_edge[edge]
                    far = s.right if s.left == c.node else s.left
                    point = self.layout.pointwork.point_at.get(far)
                    end = s.edges[-1] if s.left == c.node else s.edges[0]
                    if point is not None and end == self.turned_leg(point):
                        turned.append(k)
                        break
            out[c.id] = tuple(dict.fromkeys(turned)) or (1,)
        return out
