"""Levels from a planar embedding as a drawing, with arcs where tracks turn back."""

from __future__ import annotations

import math

from interlock.emit.drawing.canvas import ARC, MARGIN, TOP, UNIT, Drawing, Spot
from interlock.emit.drawing.embedding import Bridges, Levels, Name, NotPlanar, exact_levels
from interlock.emit.drawing.strands import Plan
from interlock.emit.drawing.stretch import Behind, along, finish, length_of, named_edges, outer, put_strand
from interlock.emit.drawing.turns import Unrolled
from interlock.emit.drawing.upward import Turned, joins
from interlock.model.elements import NodeId
from interlock.model.layout import Layout

PARTS = 5  # parts that are turned round on trial


def exact_drawing(layout: Layout, cut: Unrolled, turned: Turned | None = None) -> Drawing | None:
    """The plan with levels from a planar embedding; none where that cannot be had.  Raises Bridges."""
    best: tuple[float, Plan, Levels] | None = None
    parts = Plan(cut.layout, 0, cut.turns).parts
    for mirrored in range(0, 1 << min(parts, PARTS), 2):
        plan = Plan(cut.layout, mirrored, cut.turns)
        try:
            levels = exact_levels(plan, None if turned is None else joins(plan, turned))
        except Bridges:
            raise
        except NotPlanar:
            continue
        if best is None or levels.cost < best[0]:
            best = (levels.cost, plan, levels)
    return None if best is None else _levels_drawn(layout, cut, best[1], best[2])


def _levels_drawn(layout: Layout, cut: Unrolled, plan: Plan, levels: Levels) -> Drawing:
    d = Drawing(cut.layout, plan)
    named = named_edges(plan)
    top = max([*levels.node.values(), *levels.strand.values()], default=0)
    y = {n: (top - v) * UNIT + TOP for n, v in levels.node.items()}
    own = {
        s.number: None if s.number in levels.direct else (top - levels.strand[s.number]) * UNIT + TOP
        for s in plan.strands
    }
    lengths = {}
    for s in plan.strands:
        level = own[s.number]
        if level is None:
            lengths[s.number] = length_of(plan, s, named, (abs(y[s.left] - y[s.right]), 0.0), True)
        else:
            rise = [0.0 if n in plan.turns else abs(y[n] - level) for n in (s.left, s.right)]
            lengths[s.number] = length_of(plan, s, named, (rise[0], rise[1]))
    beyond = tuple(_beyond(plan, levels, a, b) for a, b in levels.beyond)
    x = along(plan, lengths, beyond)
    for c in plan.layout.pointwork.crossings:  # a scissors' middle in the middle
        around = [s for s in plan.strands if c.node in (s.left, s.right)]
        if all(s.number in levels.direct for s in around):
            ends = [s.right if s.left == c.node else s.left for s in around]
            x[c.node] = sum(x[n] for n in ends) / len(ends)
    d.at = {n: (x[n] + MARGIN, y[n]) for n in x}
    for s in plan.strands:
        put_strand(d, s, own[s.number], named)
    finish(d, named)
    _joined(d, layout, cut)
    return d


def _beyond(plan: Plan, levels: Levels, a: Name, b: Name) -> Behind:
    """How far an end of track inside the plan stays away from what lies beyond it: no diagonal runs through it."""
    ends = [pair for pair in ((a, b), (b, a)) if pair[0] in levels.beyond_ends]
    apart = max(_room(plan, levels, end, other, other == a) for end, other in ends)
    return (_far(plan, a, True), _far(plan, b, False), apart)


def _far(plan: Plan, n: Name, left: bool) -> NodeId:
    """A knot, or that at an end of a strand."""
    if n[0] == "knot":
        return NodeId(n[1])
    s = next(s for s in plan.strands if s.number == int(n[1]))
    return s.left if left else s.right


def _room(plan: Plan, levels: Levels, end: Name, other: Name, left: bool) -> float:
    """Pixels between an end and what lies beyond it."""
    node, far = NodeId(end[1]), _far(plan, other, left)
    heights = [levels.strand[s.number] for s in plan.strands if node in (s.left, s.right)]
    if node in plan.turns:
        room = min(ARC, abs(heights[0] - heights[1]) * UNIT / 2) + 12
    else:
        room = outer(plan.layout, node)
    if other[0] == "strand":
        rise = abs(levels.node[far] - levels.strand.get(int(other[1]), levels.node[far]))
    else:
        rise = max(abs(levels.node[far] - h) for h in [*heights, levels.node[node]])
    return room + rise * UNIT + 20


def _joined(d: Drawing, layout: Layout, cut: Unrolled) -> None:
    """The pieces of tracks that turn back as one line each, from the edge's first end, with arcs between them."""
    for edge, pieces in cut.pieces.items():
        at = d.at[layout.track.edge[edge].a]
        line: list[Spot] = []
        for piece in pieces:
            more = d.edges.pop(piece)
            if (line[-1][0] if line else at[0]) != more[0][0] or (not line and more[0] != at):
                more = more[::-1]
            if line:
                outward = 1 if more[0][0] > more[1][0] else -1
                line += _arc(line[-1], more[0], outward)
            line += more
        d.edges[edge] = line
    d.at = {n: spot for n, spot in d.at.items() if n not in cut.turns}
    d.layout = layout


def _arc(a: Spot, b: Spot, outward: int) -> list[Spot]:
    """From one level to another by a half circle, or two quarters with a straight side between."""
    way = 1 if b[1] > a[1] else -1
    r = min(ARC, abs(b[1] - a[1]) / 2)
    quarter = [(r * math.sin(k * math.pi / 12), r * (1 - math.cos(k * math.pi / 12))) for k in range(1, 7)]
    first = [(a[0] + outward * dx, a[1] + way * dy) for dx, dy in quarter]
    second = [(b[0] + outward * dx, b[1] - way * dy) for dx, dy in reversed(quarter)]
    return [*first, *second[abs(first[-1][1] - second[0][1]) < 0.1 :]]
