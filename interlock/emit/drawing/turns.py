"""Tracks that run back into the plan: balloon loops, the third side of a triangle, a railway in a circle.

Every point has its toe on one side and its legs on the other.  Where that cannot be had of all points with every track
running from left to right, the longest of the tracks that close a loop is cut where it turns back, and drawn with an
arc there.  Short tracks are looked at first, so that it is never a crossover that turns.  Where that does not lie flat,
an embedding tells what turns (`upward`).
"""

from __future__ import annotations

from dataclasses import replace

import networkx as nx

from interlock.dataclass import dataclass
from interlock.emit.drawing.strands import Plan, Strand
from interlock.model.elements import EdgeId, NodeId
from interlock.model.layout import Layout


@dataclass(frozen=True)
class Unrolled:
    """A layout in which tracks are cut where they turn back, and what each cut edge consists of, from its end `a`."""

    layout: Layout
    turns: frozenset[NodeId]
    pieces: dict[EdgeId, tuple[EdgeId, ...]]


def unrolled(layout: Layout) -> Unrolled:
    """The layout, cut so that every track can run from left to right."""
    plan = Plan(layout)
    out = Unrolled(layout, frozenset(), {})
    for s in _turning(plan):
        out = cut_at_turns(out, longest(layout, s), 1)
    for _ in range(len(layout.track.edges)):
        plan = Plan(out.layout, 0, out.turns)
        cycle = _cycle(plan)
        whole = [s for s in cycle if not set(s.nodes) & out.turns]
        if not whole:
            break
        turning = max(whole, key=lambda s: (metres(layout, s), -s.number))
        out = cut_at_turns(out, longest(layout, turning), 2)
    return out


def _turning(plan: Plan) -> list[Strand]:
    """Strands whose ends lie on the same side of their points, once the shorter ones are laid from left to right."""
    parent: dict[object, tuple[object, bool]] = {}

    def root(k: object) -> tuple[object, bool]:
        odd = False
        while k in parent:
            k, flips = parent[k]
            odd ^= flips
        return k, odd

    out = []
    ordered = sorted(plan.strands, key=lambda s: (metres(plan.layout, s), s.number))
    for s in ordered:
        a, b = _port(plan, s.left, s.edges[0]), _port(plan, s.right, s.edges[-1])
        if a is None or b is None:
            continue
        (x, p), (y, q) = root(a[0]), root(b[0])
        differ = p ^ q ^ a[1] ^ b[1]
        if x != y:
            parent[x] = (y, not differ)
        elif not differ:
            out.append(s)
    return out


def _port(plan: Plan, node: NodeId, edge: EdgeId) -> tuple[object, bool] | None:
    """What decides on which side of a knot an edge lies, and whether it lies on the other one."""
    point = plan.layout.pointwork.point_at.get(node)
    if point is not None:
        return (node, edge != point.toe)
    crossing = plan.layout.pointwork.crossing_at.get(node)
    if crossing is not None and node in plan.slips:
        return (node, edge in (crossing.arms[0][1], crossing.arms[1][1]))
    if crossing is not None:
        return next(((node, k), edge == arm[1]) for k, arm in enumerate(crossing.arms) if edge in arm)
    return None


def _cycle(plan: Plan) -> list[Strand]:
    """Strands that run in a circle, or none."""
    graph: nx.MultiDiGraph[NodeId] = nx.MultiDiGraph()
    of = {s.number: s for s in plan.strands}
    graph.add_edges_from((s.left, s.right, s.number) for s in plan.strands)
    try:
        return [of[e[2]] for e in nx.find_cycle(graph)]
    except nx.NetworkXNoCycle:
        return []


def metres(layout: Layout, s: Strand) -> float:
    """The length of a track."""
    return sum(layout.track.edge[e].length for e in s.edges if e in layout.track.edge)


def longest(layout: Layout, s: Strand) -> EdgeId:
    """The edge of a track at which it turns."""
    return max(s.edges, key=lambda e: (layout.track.edge[e].length, e))


def cut_at_turns(before: Unrolled, edge: EdgeId, times: int) -> Unrolled:
    """An edge in equal pieces, joined by nodes at which the track turns."""
    layout = before.layout
    e = layout.track.edge[edge]
    names = tuple(EdgeId(f"{edge}~{k}") for k in range(times + 1))
    turns = [NodeId(f"{edge}~turn{k}") for k in range(times)]
    nodes = [e.a, *turns, e.b]
    new = [
        replace(e, id=name, a=nodes[k], b=nodes[k + 1], length=e.length / (times + 1)) for k, name in enumerate(names)
    ]

    def at(node: NodeId, old: EdgeId) -> EdgeId:
        return old if old != edge else names[0] if node == e.a else names[-1]

    points = [
        replace(p, toe=at(p.node, p.toe), normal=at(p.node, p.normal), reverse=at(p.node, p.reverse))
        for p in layout.pointwork.points
    ]
    crossings = [
        replace(
            c,
            arms=(
                (at(c.node, c.arms[0][0]), at(c.node, c.arms[0][1])),
                (at(c.node, c.arms[1][0]), at(c.node, c.arms[1][1])),
            ),
        )
        for c in layout.pointwork.crossings
    ]
    cut = replace(
        layout,
        track=replace(
            layout.track,
            edges=tuple(sorted((*(x for x in layout.track.edges if x.id != edge), *new), key=lambda x: x.id)),
        ),
        pointwork=replace(layout.pointwork, points=tuple(points), crossings=tuple(crossings)),
        signalling=replace(
            layout.signalling, signals=tuple(replace(g, into=at(g.node, g.into)) for g in layout.signalling.signals)
        ),
    )
    return Unrolled(cut, before.turns | frozenset(turns), {**before.pieces, edge: names})
