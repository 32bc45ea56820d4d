"""Which tracks turn back, read from a planar embedding, so that the whole can be drawn from left to right.

In an upward plane drawing every angle between two tracks that leave a knot on the same side is small or large, every
other one flat.  A point has a small angle between its legs, a diamond one on either side, an end of track a large one,
a turn a large one outside and a small one inside; and a face has two small angles more than large ones, the outer face
two large ones more than small ones (Bertolazzi, Di Battista, Liotta, Mannino, Algorithmica 12, 1994).  So a turn hands
one unit from the face on one side of its track to that on the other, and the fewest turns are a flow of least cost.
From the same angles come the edges that leave no source and no sink within a face.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from itertools import pairwise, product

import networkx as nx

from interlock.dataclass import dataclass
from interlock.emit.drawing.embedding import SINK, SOURCE, Bridges, Joins, Name, NotPlanar, knot, middle
from interlock.emit.drawing.strands import Plan, Strand
from interlock.emit.drawing.turns import Unrolled, cut_at_turns, longest, metres
from interlock.model.elements import EdgeId, NodeId
from interlock.model.layout import Layout

OUTER = 6  # faces that are tried as the outer one of a part, those with most boundaries first, then the longest
DIAMONDS = 4  # of which every way to lie is tried
TURN = 100  # what a turn costs; that of the shortest track costs twice as much
OUTSIDE = ("outside",)
INSIDE = 150  # what a boundary costs that does not lie in the outer face
ARM = 300  # more for an arm of a diamond, which shall go straight on

Port = tuple[NodeId, EdgeId]
"""A knot, and an edge that ends there."""
Corner = tuple[Port, Port]
"""The angle at a knot from one of its edges on to the next."""


@dataclass
class Turned:
    """A layout whose tracks are cut where they turn, and the order of the edges around every knot."""

    cut: Unrolled
    order: dict[NodeId, list[EdgeId]]
    large: set[Corner] = field(default_factory=set)
    outer: set[Corner] = field(default_factory=set)
    """A corner of the outer face of each part."""


def turned(layout: Layout) -> Turned:
    """The layout with as few turns as its planar embedding allows.  Raises Bridges, NotPlanar."""
    plan = Plan(layout)
    if any(s.left == s.right and len(s.edges) == 1 for s in plan.strands):
        raise NotPlanar("an edge ends where it begins")
    order = _order(plan)
    bends, outer = _bends(plan, order)
    out = Turned(Unrolled(layout, frozenset(), {}), order, set(), outer)
    for s in plan.strands:
        if bends.get(s.number):
            _turn(out, s, longest(layout, s), bends[s.number])
    return out


def _order(plan: Plan) -> dict[NodeId, list[EdgeId]]:
    """The edges around every knot in an embedding of the tracks, with all boundaries in one face where that can be."""
    graph: nx.Graph[Name] = nx.Graph()
    crossings, ports = plan.layout.pointwork.crossing_at, {}
    for s in plan.strands:
        halves = []
        for n, e, k in ((s.left, s.edges[0], "0"), (s.right, s.edges[-1], "1")):
            half = ("half", f"{s.number:06d}", k)
            ports[half] = e
            graph.add_edge(("ring", n, str(e)) if n in crossings else knot(n), half)
            halves.append(half)
        graph.add_edge(*halves)
    for n in sorted(crossings):
        c = crossings[n]
        ring = [("ring", n, str(e)) for e in (c.arms[0][0], c.arms[1][0], c.arms[0][1], c.arms[1][1])]
        for a, b in pairwise([*ring, ring[0]]):
            graph.add_edges_from(((a, b), (a, knot(n))))
    tidy: nx.Graph[Name] = nx.Graph()
    tidy.add_nodes_from(sorted(graph))
    tidy.add_edges_from(sorted(map(sorted, graph.edges)))
    around = [(OUTSIDE, knot(n)) for n in sorted(plan.layout.track.boundary_at) if knot(n) in tidy]
    tidy.add_edges_from(around)
    found, embedding = nx.check_planarity(tidy)
    if not found:
        tidy.remove_edges_from(around)
        found, embedding = nx.check_planarity(tidy)
    if not found:
        raise Bridges("cannot be drawn without crossings")
    out = {}
    for n in sorted(n for n in tidy if n[0] == "knot"):
        ring = [m for m in embedding.neighbors_cw_order(n) if m != OUTSIDE]
        out[NodeId(n[1])] = [EdgeId(m[2]) if m[0] == "ring" else ports[m] for m in ring]
    return out


def _faces(plan: Plan, order: dict[NodeId, list[EdgeId]]) -> list[list[Corner]]:
    """The faces, each as the corners along it: where one arrives, and where one goes on."""
    far: dict[Port, Port] = {}
    for s in plan.strands:
        a, b = (s.left, s.edges[0]), (s.right, s.edges[-1])
        far[a], far[b] = b, a
    seen: set[Port] = set()
    out = []
    for first in sorted(far):
        at, face = first, []
        while at not in seen:
            seen.add(at)
            around = order[at[0]]
            leaves = (at[0], around[(around.index(at[1]) + 1) % len(around)])
            face.append((at, leaves))
            at = far[leaves]
        if face:
            out.append(face)
    return out


def _bends(plan: Plan, order: dict[NodeId, list[EdgeId]]) -> tuple[dict[int, int], set[Corner]]:
    """How often each track turns, with the sign of the side, and a corner of the outer face of each part."""
    faces = _faces(plan, order)
    of = {corner[0]: k for k, face in enumerate(faces) for corner in face}
    parts = nx.Graph(s.nodes[:: len(s.nodes) - 1] for s in plan.strands)
    bends: dict[int, int] = {}
    outer: set[Corner] = set()
    for part in sorted(map(sorted, nx.connected_components(parts))):
        mine = [k for k, face in enumerate(faces) if face[0][0][0] in set(part)]
        best = min(_tried(plan, faces, of, mine, set(part)), key=lambda t: t[0], default=None)
        if best is None:
            raise NotPlanar("no turns make it run from left to right")
        bends |= best[1]
        outer.add(faces[best[2]][0])
    return bends, outer


def _tried(
    plan: Plan, faces: list[list[Corner]], of: dict[Port, int], mine: list[int], part: set[NodeId]
) -> Iterator[tuple[int, dict[int, int], int]]:
    """What the turns cost, how often each track turns, and the outer face, for every way that is tried."""
    strands = [s for s in plan.strands if s.left in part]
    by_length = sorted(strands, key=lambda s: (-metres(plan.layout, s), s.number))
    graph: nx.MultiDiGraph[int] = nx.MultiDiGraph()
    for rank, s in enumerate(by_length):
        ahead, back = of[s.right, s.edges[-1]], of[s.left, s.edges[0]]
        weight = TURN + TURN * rank // len(strands)
        if {s.left, s.right} & set(plan.layout.pointwork.crossing_at):
            weight += ARM
        if ahead != back:
            graph.add_edge(back, ahead, (s.number, 1), weight=weight)
            graph.add_edge(ahead, back, (s.number, -1), weight=weight)
    graph.add_nodes_from(mine)
    leads = {k: sum(a[0] in plan.layout.track.boundary_at for a, _ in faces[k]) for k in mine}
    free = [n for n in sorted(plan.layout.pointwork.crossing_at) if n in part and n not in plan.slips][:DIAMONDS]
    for ways in product((False, True), repeat=len(free)):
        across = dict(zip(free, ways, strict=True))
        has = {k: sum(_angle(plan, across, *corner) for corner in faces[k]) for k in mine}
        for outer in sorted(mine, key=lambda k: (-leads[k], -len(faces[k]), k))[:OUTER]:
            for k in mine:
                graph.nodes[k]["demand"] = (2 if k == outer else -2) - has[k]
            try:
                cost, flow = nx.network_simplex(graph)
            except nx.NetworkXUnfeasible:
                continue
            bends: dict[int, int] = {}
            for a in flow:
                for b in flow[a]:
                    for (number, way), units in flow[a][b].items():
                        bends[number] = bends.get(number, 0) + way * units
            yield cost - INSIDE * leads[outer], bends, outer


def _angle(plan: Plan, across: dict[NodeId, bool], a: Port, b: Port) -> int:
    """1 for a large angle, -1 for a small one, 0 for a flat one."""
    node = a[0]
    if a == b:
        return 1
    crossing = plan.layout.pointwork.crossing_at.get(node)
    if crossing is not None:
        left = {crossing.arms[0][0], crossing.arms[1][1 if across.get(node) else 0]}
        return -1 if (a[1] in left) is (b[1] in left) else 0
    point = plan.layout.pointwork.point_at.get(node)
    return -1 if point is not None and (a[1] == point.toe) is (b[1] == point.toe) else 0


def _turn(t: Turned, s: Strand, edge: EdgeId, times: int) -> None:
    """Cut a track where it turns, `times` < 0 the other way round."""
    e = t.cut.layout.track.edge[edge]
    t.cut = cut_at_turns(t.cut, edge, abs(times))
    names = t.cut.pieces[edge]

    def new(p: Port) -> Port:
        return p if p[1] != edge else (p[0], names[0] if p[0] == e.a else names[-1])

    for n in {s.left, s.right}:
        t.order[n] = [new((n, x))[1] for x in t.order[n]]
    t.outer = {(new(a), new(b)) for a, b in t.outer}
    along = s.nodes[s.edges.index(edge)] == e.a
    for before, after in pairwise(names):
        turn = NodeId(f"{edge}~turn{names.index(before)}")
        t.order[turn] = [before, after]
        first, second = (before, after) if along is (times > 0) else (after, before)
        t.large.add(((turn, first), (turn, second)))


# --- one source, one sink --------------------------------------------------------------------------


@dataclass(frozen=True)
class Switch:
    """A corner whose two tracks lie on the same side of its knot."""

    node: NodeId
    ends: bool
    """They lie to its left: nothing leads on to the right in this face."""
    large: bool
    before: Name
    """The strand along which one arrives."""
    after: Name
    """The strand along which one goes on."""


def joins(plan: Plan, t: Turned) -> Joins:
    """Edges, from left to right, with which nothing but SOURCE and SINK is a source or a sink.  Raises NotPlanar."""
    out: dict[Name, tuple[Name, Name]] = {}
    of = {p: s for s in plan.strands for p in ((s.left, s.edges[0]), (s.right, s.edges[-1]))}
    for face in _faces(plan, t.order):
        ring = []
        for a, b in face:
            ends = of[a].right == a[0], of[b].right == b[0]
            if ends[0] is ends[1]:
                ring.append(
                    Switch(a[0], ends[0], a == b or (a, b) in t.large, middle(of[a].number), middle(of[b].number))
                )
        outer = bool(set(face) & t.outer)
        if sum(1 if k.large else -1 for k in ring) != (2 if outer else -2):
            raise NotPlanar("its angles do not close")
        out |= _joined(plan, ring)
    return out


def _joined(plan: Plan, ring: list[Switch]) -> Iterator[tuple[Name, tuple[Name, Name]]]:
    """A large angle before or after two small ones is joined to the further of them; what is left lies outside."""
    ring = list(ring)
    while True:
        found = next(
            (
                (i, way)
                for i, k in enumerate(ring)
                for way in (1, -1)
                if k.large and not any(ring[(i + way * j) % len(ring)].large for j in (1, 2))
            ),
            None,
        )
        if found is None or len(ring) < 3:
            break
        i, way = found
        one, between, other = (ring[(i + way * j) % len(ring)] for j in range(3))
        to = other.before if way > 0 else other.after
        yield knot(one.node), (knot(one.node), to) if one.ends else (to, knot(one.node))
        ring = [k for k in ring if k is not one and k is not between]
    for k in ring:
        if k.large:
            yield knot(k.node), (knot(k.node), SINK) if k.ends else (SOURCE, knot(k.node))
