"""Levels without false crossings: the order of all tracks from a planar embedding, their heights by an exact flow.

A plan that runs from left to right is an upward drawing of a planar graph with one source and one sink: both are added,
every boundary and end of track hangs on them or on what lies beyond it in the same face.  An embedding (networkx) tells
for every face which tracks are below and which above it; that is kept as a hard constraint, so that nothing can cross.
Among all such heights those with the least bends are taken, straight legs weighted most, and then the lowest plan.
A diamond is embedded as a hub in a ring of four, so that its arms alternate.  Everything is sorted: the same layout
gives the same plan.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import field
from itertools import pairwise

import networkx as nx

from interlock.dataclass import dataclass
from interlock.emit.drawing.narrowest import narrowest
from interlock.emit.drawing.strands import Plan, Strand
from interlock.model.elements import NodeId

Name = tuple[str, ...]
"""A node of the embedded graph: what it is, and its id."""

Joins = Mapping[Name, tuple[Name, Name]]
"""For every end of track and every turn an edge, from left to right, that makes of it neither source nor sink."""

SOURCE, SINK = ("source",), ("sink",)
ORDERS = ((60, 12), (120, 4), (2000, 1))  # up to so many strands so many embeddings are compared
STRAIGHT, TOE, TURNED, MIDDLE, END, ON, TALL = 18, 16, 4, 24, 160, 400, 12  # weights of bends and of height


class NotPlanar(Exception):
    """The tracks cannot be drawn without crossing each other where they do not cross on the ground."""


class Bridges(NotPlanar):
    """That holds however tracks turn: some of them pass over each other."""


@dataclass
class Levels:
    """The height of each knot and strand (up is more, a track's distance is 2); `direct` strands are all diagonal.

    `beyond`: for ends of track inside the plan, the knot or strand that must lie further to the right than they do.
    """

    cost: float
    node: dict[NodeId, int]
    strand: dict[int, int]
    direct: set[int]
    beyond: list[tuple[Name, Name]] = field(default_factory=list)
    beyond_ends: set[Name] = field(default_factory=set)


def knot(node: NodeId) -> Name:
    """The name of a knot."""
    return ("knot", node)


def middle(number: int) -> Name:
    """The name of a strand's middle."""
    return ("strand", f"{number:06d}")


class Embedding:
    """The strands of a plan as a graph with one source and one sink."""

    def __init__(self, plan: Plan, joins: Joins | None = None) -> None:
        self.plan = plan
        self.flow: nx.DiGraph[Name] = nx.DiGraph()
        self.flat: nx.Graph[Name] = nx.Graph()
        self.dummies: list[tuple[Name, Name]] = []
        self.inside: set[Name] = set()
        self.beyond: list[tuple[Name, Name]] = []
        crossings = plan.layout.pointwork.crossing_at
        for s in plan.strands:
            m = middle(s.number)
            for a, b in ((knot(s.left), m), (m, knot(s.right))):
                self.flow.add_edge(a, b)
            self.flat.add_edge(self._port(s, s.left), m)
            self.flat.add_edge(m, self._port(s, s.right))
        for n in sorted(crossings):
            c = crossings[n]
            ring = [("ring", n, str(e)) for e in (c.arms[0][0], c.arms[1][0], c.arms[0][1], c.arms[1][1])]
            for a, b in pairwise([*ring, ring[0]]):
                self.flat.add_edge(a, b)
                self.flat.add_edge(a, knot(n))
        if not nx.is_directed_acyclic_graph(self.flow):
            raise NotPlanar("runs back into itself")
        if joins is None:
            self._join()
        else:
            self._told(joins)

    def _told(self, joins: Joins) -> None:
        """Join every end as an embedding has told."""
        self.flow.add_edge(SOURCE, SINK)
        self.flat.add_edge(SOURCE, SINK)
        for end, (a, b) in sorted(joins.items()):
            self._add(a, b)
            if a != SOURCE and b != SINK:
                self.inside.add(end)
                self.beyond.append((self._knot(a, 0), self._knot(b, -1)))
        if not nx.is_directed_acyclic_graph(self.flow) or not nx.check_planarity(self.flat)[0]:
            raise NotPlanar("its ends cannot be joined")

    def _knot(self, n: Name, end: int) -> Name:
        """The knot at an end of a strand."""
        return next((knot(s.nodes[end]) for s in self.plan.strands if middle(s.number) == n), n)

    def _port(self, s: Strand, node: NodeId) -> Name:
        if node in self.plan.layout.pointwork.crossing_at:
            return ("ring", node, str(s.edges[0] if node == s.left else s.edges[-1]))
        return knot(node)

    # --- one source, one sink -------------------------------------------------------------------

    def _join(self) -> None:
        inner = sorted(self.flow)
        ends = [n for n in inner if not self.flow.in_degree(n) or not self.flow.out_degree(n)]
        outside = {knot(n) for n in self.plan.layout.track.boundary_at}
        self.flow.add_edge(SOURCE, SINK)
        self.flat.add_edge(SOURCE, SINK)
        ends.sort(key=lambda n: (n not in outside, n))
        for e in ends:
            self._add(*self._outward(e))
        if nx.check_planarity(self.flat)[0]:
            return
        for e in ends:
            self._remove(*self._outward(e))
        if not nx.check_planarity(self.flat)[0]:
            raise Bridges("cannot be drawn without crossings")
        left = []
        for e in ends:
            self._add(*self._outward(e))
            if not nx.check_planarity(self.flat)[0]:
                self._remove(*self._outward(e))
                left.append(e)
        for e in left:
            self._inward(e)

    def _outward(self, end: Name) -> tuple[Name, Name]:
        return (SOURCE, end) if self._starts(end) else (end, SINK)

    def _starts(self, end: Name) -> bool:
        """Whether an end is the left one of its strands."""
        return any(knot(s.left) == end for s in self.plan.strands)

    def _add(self, a: Name, b: Name) -> None:
        self.flow.add_edge(a, b)
        self.flat.add_edge(a, b)
        self.dummies.append((a, b))

    def _remove(self, a: Name, b: Name) -> None:
        self.flow.remove_edge(a, b)
        self.flat.remove_edge(a, b)
        self.dummies.remove((a, b))

    def _inward(self, end: Name) -> None:
        """Join an end of track to what lies beyond it in the same face."""
        found, embedding = nx.check_planarity(self.flat)
        assert found
        starts = self._starts(end)
        rank = {n: i for i, n in enumerate(nx.lexicographical_topological_sort(self.flow))}
        around = {n for m in embedding.neighbors_cw_order(end) for n in embedding.traverse_face(end, m)}
        barred = nx.descendants(self.flow, end) if starts else nx.ancestors(self.flow, end)
        barred |= {end, SOURCE, SINK, *(knot(n) for n in self.plan.layout.pointwork.crossing_at)}

        def key(n: Name) -> tuple[bool, bool, int, Name]:
            return (n not in around, (rank[n] > rank[end]) is starts, abs(rank[n] - rank[end]), n)

        for n in sorted((n for n in rank if n not in barred and not self.flat.has_edge(n, end)), key=key):
            new = (n, end) if starts else (end, n)
            self._add(*new)
            self.inside.add(end)
            if n in around or nx.check_planarity(self.flat)[0]:
                self.beyond.append(new)
                return
            self._remove(*new)
        raise NotPlanar(f"the end of track {end[1]} has no room")

    # --- what lies below what --------------------------------------------------------------------

    def embedded(self, order: int) -> nx.PlanarEmbedding[Name]:
        """An embedding; others for other orders of the same edges."""
        edges = sorted(map(sorted, self.flat.edges))
        nodes = sorted(self.flat)
        if order:
            shuffle = random.Random(order)
            shuffle.shuffle(nodes)
            shuffle.shuffle(edges)
        graph: nx.Graph[Name] = nx.Graph()
        graph.add_nodes_from(nodes)
        graph.add_edges_from(edges)
        found, embedding = nx.check_planarity(graph)
        assert found
        return embedding

    def rotation(self, embedding: nx.PlanarEmbedding[Name]) -> dict[Name, list[Name]]:
        """The neighbours of every node in order, each diamond as one node."""
        out: dict[Name, list[Name]] = {}
        crossings = self.plan.layout.pointwork.crossing_at
        for n in embedding:
            if n[0] == "ring":
                continue
            around = list(embedding.neighbors_cw_order(n))
            if n[0] == "knot" and n[1] in crossings:
                around = [self._beyond(embedding, r) for r in around]
            out[n] = [knot(NodeId(m[1])) if m[0] == "ring" else m for m in around]
        return out

    @staticmethod
    def _beyond(embedding: nx.PlanarEmbedding[Name], ring: Name) -> Name:
        return next(m for m in embedding.neighbors_cw_order(ring) if m[0] == "strand")


def faces(rotation: dict[Name, list[Name]]) -> list[list[Name]]:
    """The faces of a rotation system, each as the nodes around it."""
    follows = {(m, n): around[(i + 1) % len(around)] for n, around in rotation.items() for i, m in enumerate(around)}
    seen: set[tuple[Name, Name]] = set()
    out = []
    for first in sorted(follows):
        if first in seen:
            continue
        face, dart = [], first
        while dart not in seen:
            seen.add(dart)
            face.append(dart[0])
            dart = (dart[1], follows[dart])
        out.append(face)
    return out


class Heights:
    """The heights of an embedding, as a problem of least weighted differences."""

    def __init__(self, e: Embedding, embedding: nx.PlanarEmbedding[Name]) -> None:
        self.e, self.plan = e, e.plan
        self.graph: nx.DiGraph[Name] = nx.DiGraph()
        self.around = faces(e.rotation(embedding))
        self.strand = {middle(s.number): s for s in self.plan.strands}
        self.halves = {(knot(s.left), m) for m, s in self.strand.items()}
        self.halves |= {(m, knot(s.right)) for m, s in self.strand.items()}
        self.direct = self._direct()
        self._between()
        self._bends()

    def _lower(self, a: Name, b: Name, apart: int, weight: int = 0) -> None:
        if a == b:
            return
        old = self.graph.get_edge_data(a, b, {"length": 0, "weight": 0})
        self.graph.add_edge(a, b, length=max(apart, old["length"]), weight=weight + old["weight"])

    def _forks(self) -> Iterator[tuple[Name, Name, Name]]:
        """Wherever a face begins or ends at a knot: the knot, and what leaves it below and above the face."""
        for face in self.around:
            for i, n in enumerate(face):
                before, after = face[i - 1], face[(i + 1) % len(face)]
                inward, outward = self.e.flow.has_edge(before, n), self.e.flow.has_edge(n, after)
                if n[0] == "knot" and inward is not outward:
                    yield (n, after, before) if outward else (n, before, after)

    def _direct(self) -> set[Name]:
        """Strands that are all diagonal: they leave both ends the same way, up or down."""
        ways: dict[Name, set[int]] = {}
        for n, low, high in self._forks():
            for m, way in ((low, -1), (high, 1)):
                if m in self.strand:
                    ways.setdefault(m, set()).add(way if knot(self.strand[m].left) == n else -way)
        self.way = {m: next(iter(w)) for m, w in ways.items() if len(w) == 1}
        return {m for m in self.way if self._diagonal(self.strand[m])}

    def _diagonal(self, s: Strand) -> bool:
        return self.plan.diverges(s, s.left) and self.plan.diverges(s, s.right) and self.plan.crossover(s)

    def _between(self) -> None:
        """Each face has its lower tracks below it and its upper ones above, and knots lie between their legs."""
        diamonds = {knot(n) for n in self.plan.layout.pointwork.crossing_at}
        for k, face in enumerate(self.around):
            room = ("face", f"{k:06d}")
            for i, n in enumerate(face):
                inward = self._along(face[i - 1], n)
                outward = self._along(n, face[(i + 1) % len(face)])
                if inward is None or outward is None:  # an end of track hangs on it there
                    inward = outward = outward if inward is None else inward
                if inward is outward and inward is not None and n not in self.direct:
                    low, high = (n, room) if inward else (room, n)
                    self._lower(low, high, 0 if n in diamonds else 1)
        for n, low, high in self._forks():
            self._enclosed(n, low, -1)
            self._enclosed(n, high, 1)
        for m in self.direct:
            s = self.strand[m]
            a, b = knot(s.left), knot(s.right)
            diamond = {s.left, s.right} & set(self.plan.layout.pointwork.crossing_at)
            low, high = (a, b) if self.way[m] > 0 else (b, a)
            self._lower(low, high, 1 if diamond else 2, MIDDLE if diamond else TURNED)

    def _along(self, a: Name, b: Name) -> bool | None:
        """Whether one goes from left to right from one node to the next; nothing is said where a strand's middle is
        joined to an end of track that is not its own."""
        half = {(a, b), (b, a)} & self.halves
        return None if "strand" in (a[0], b[0]) and not half else self.e.flow.has_edge(a, b)

    def _enclosed(self, n: Name, leg: Name, way: int) -> None:
        if leg in self.strand and leg not in self.direct:
            low, high = (n, leg) if way > 0 else (leg, n)
            self._lower(low, high, 0)

    def _bends(self) -> None:
        layout = self.plan.layout
        for m, s in sorted(self.strand.items()):
            if m in self.direct:
                continue
            for n, edge in ((s.left, s.edges[0]), (s.right, s.edges[-1])):
                point = layout.pointwork.point_at.get(n)
                weight = TOE
                if n in layout.pointwork.crossing_at:
                    weight = ON if edge in layout.pointwork.crossing_at[n].arms[self._level_arm(n)] else TURNED
                elif self.plan.diverges(s, n):
                    weight = TURNED
                elif point is not None and edge != point.toe:
                    weight = STRAIGHT
                elif n in self.plan.turns:
                    weight = 0  # an arc leads there
                elif n in layout.track.boundary_at or n in layout.track.buffer_at:
                    weight = END
                self._apart(m, knot(n), weight)
        for n in sorted(n for n in self.graph if n[0] in ("knot", "strand")):
            self._lower(("bottom",), n, 0)
            self._lower(n, ("top",), 0)
        self._lower(("bottom",), ("top",), 0, TALL)

    def _level_arm(self, node: NodeId) -> int:
        """The arm of a diamond that goes straight on where not both are diagonals, so that the other one crosses it."""
        crossing = self.plan.layout.pointwork.crossing_at[node]
        return next((k for k in (0, 1) if k not in self.plan.diagonal_arms[crossing.id]), 0)

    def _apart(self, a: Name, b: Name, weight: int) -> None:
        """`weight` for every level by which two heights differ."""
        over, under = ("over", *a, *b), ("under", *a, *b)
        self._lower(a, over, 0, weight)
        self._lower(under, a, 0, weight)
        self._lower(b, over, 0)
        self._lower(under, b, 0)

    def solved(self) -> Levels:
        """The heights that cost least."""
        if not nx.is_directed_acyclic_graph(self.graph):
            raise NotPlanar("constraints contradict each other")
        y: dict[Name, float] = narrowest(self.graph)
        cost = sum(w["weight"] * (y[b] - y[a]) for a, b, w in self.graph.edges(data=True))
        return Levels(
            cost,
            {NodeId(n[1]): round(v) for n, v in y.items() if n[0] == "knot"},
            {self.strand[n].number: round(v) for n, v in y.items() if n[0] == "strand"},
            {self.strand[m].number for m in self.direct},
            self.e.beyond,
            self.e.inside,
        )


def exact_levels(plan: Plan, joins: Joins | None = None) -> Levels:
    """Heights without false crossings.  Raises NotPlanar, Bridges."""
    e = Embedding(plan, joins)
    best: Levels | None = None
    for order in range(next((k for most, k in ORDERS if len(plan.strands) <= most), 0)):
        found = Heights(e, e.embedded(order)).solved()
        if best is None or found.cost < best.cost:
            best = found
    if best is None:
        raise NotPlanar("is too large for exact levels")
    return best
