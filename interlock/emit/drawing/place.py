"""Where everything of a plan lies, in pixels.

Small layouts first with straight runs put on levels next to each other (`levels`); where lines would cross that way,
and in large ones, levels come from a planar embedding (`embedding`).  Along the track everything is as narrow as its
names allow (`stretch`).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from interlock.emit.drawing.canvas import MARGIN, TOP, UNIT, Drawing, Spot
from interlock.emit.drawing.embedding import Bridges, NotPlanar
from interlock.emit.drawing.exact import exact_drawing
from interlock.emit.drawing.levels import FEW, Runs, cost, place_levels
from interlock.emit.drawing.names import tell_covered
from interlock.emit.drawing.slips import restore, with_diamonds
from interlock.emit.drawing.strands import Plan, Strand
from interlock.emit.drawing.stretch import Behind, along, finish, length_of, named_edges, outer, put_strand
from interlock.emit.drawing.turns import Unrolled, unrolled
from interlock.emit.drawing.upward import turned
from interlock.model.elements import NodeId
from interlock.model.layout import Layout

TURNS = 5  # parts that are turned round on trial
CROSSED = 2000.0


Levelled = tuple[float, Plan, dict[NodeId, float], Runs, list[int]]


def _levelled(layout: Layout, mirrored: int) -> Levelled:
    """A plan with its levels, and what they cost."""
    plan = Plan(layout, mirrored)
    named = named_edges(plan)
    x = along(plan, {s.number: length_of(plan, s, named, None) for s in plan.strands}, ())
    runs = Runs(plan, x)
    levels = place_levels(runs)
    return cost(runs, levels), plan, x, runs, levels


def place(layout: Layout) -> Drawing:
    """The plan of a layout: its runs put next to each other, or, where lines would cross that way, exact levels."""
    drawn = _placed(with_diamonds(layout))
    restore(drawn, layout)
    tell_covered(drawn)
    return drawn


def _placed(layout: Layout) -> Drawing:
    cut = unrolled(layout)
    large = len(layout.pointwork.points) > FEW
    hints = bool(layout.printed.drawing)
    drawn = _settled(layout) if hints or not (cut.turns or large) else None
    if drawn is not None and drawn.plan.slips and not hints:  # a slip's arms decide on which side much else lies
        drawn = _smaller(drawn, cut)
    if drawn is None or (_crossed(drawn) and not hints):
        for exact in _exact(layout, cut):
            if drawn is None or _crossed(exact) < _crossed(drawn):
                drawn = exact
            if not _crossed(drawn):
                break
    if drawn is None:
        drawn = _settled(layout)
    crossed = _crossed(drawn)
    if crossed:
        drawn.notes.append(f"lines cross at {crossed} places where the tracks do not")
    return drawn


def _exact(layout: Layout, cut: Unrolled) -> Iterator[Drawing]:
    """Plans with exact levels: the longest tracks turn, or those that a planar embedding tells."""
    try:
        if (drawn := exact_drawing(layout, cut)) is not None:
            yield drawn
        told = turned(layout)
        if (drawn := exact_drawing(layout, told.cut, told)) is not None:
            yield drawn
    except NotPlanar:  # however its tracks turn
        return


def _smaller(drawn: Drawing, cut: Unrolled) -> Drawing:
    """The plan with exact levels instead, if it takes less room."""
    try:
        exact = exact_drawing(cut.layout, cut)
    except Bridges:
        return drawn
    if exact is None or _crossed(exact):
        return drawn
    return exact if exact.width * exact.height < drawn.width * drawn.height else drawn


def _settled(layout: Layout) -> Drawing:
    """The plan with runs put next to each other."""
    first = _levelled(layout, 0)
    drawn = [_drawn(layout, first)]
    for mirrored in range(2, 1 << min(first[1].parts, TURNS), 2):  # the first part stays as it is declared
        drawn.append(_drawn(layout, _levelled(layout, mirrored)))
    return min(drawn, key=lambda t: t[0])[1]


def _drawn(layout: Layout, tried: Levelled) -> tuple[float, Drawing]:
    """The drawing, and what it costs with the lines that cross without a crossing."""
    total, plan, first, runs, levels = tried
    d = Drawing(layout, plan)
    named = named_edges(plan)
    lengths = {
        s.number: length_of(plan, s, named, _height(runs, levels, s), s.number in runs.straight) for s in plan.strands
    }
    x = along(plan, lengths, _behind(plan, runs, levels, first))
    for c in layout.pointwork.crossings:  # a scissors' middle in the middle
        if len(plan.diagonal_arms[c.id]) == 2:
            ends = [s.right if s.left == c.node else s.left for s in plan.strands if c.node in (s.left, s.right)]
            x[c.node] = sum(x[n] for n in ends) / len(ends)
    if runs.count > FEW:
        d.notes.append(f"{runs.count} runs of track: a good plan in time, not the best one")
    for s in plan.strands:
        if x[s.right] < x[s.left] or s.left == s.right:
            d.notes.append(f"the track at {s.edges[0]} runs back into the plan: there left and right cannot be told")
    top = max(levels, default=0)
    y = {n: (top - levels[k]) * UNIT + TOP for n, k in runs.of_node.items()}
    d.at = {n: (x[n] + MARGIN, y[n]) for n in x}
    for s in plan.strands:
        own = (top - levels[runs.of_strand[s.number]]) * UNIT + TOP if s.number in runs.of_strand else None
        put_strand(d, s, own, named)
    if layout.pointwork.crossings:
        total += CROSSED * _crossed(d)
    finish(d, named)
    return total, d


def _crossed(d: Drawing) -> int:
    """Lines that cross or overprint each other where the tracks do not cross."""
    lines = [*d.edges.items(), *((f"outside {n}", [d.at[n], tip]) for n, tip, _ in d.outside)]
    parts = sorted((min(a[0], b[0]), max(a[0], b[0]), e, a, b) for e, line in lines for a, b in pairwise(line))
    count = 0
    for i, (_, right, e, a, b) in enumerate(parts):
        low, high = min(a[1], b[1]), max(a[1], b[1])
        for left, other, f, p, q in parts[i + 1 :]:
            if left > right:
                break
            if e == f or min(p[1], q[1]) > high or max(p[1], q[1]) < low:
                continue
            if low == high and p[1] == q[1]:
                count += min(right, other) - left > 2
            else:
                count += _cross(a, b, p, q)
    return count


def _cross(a: Spot, b: Spot, p: Spot, q: Spot) -> bool:
    """Two strokes cross between their ends."""

    def side(u: Spot, v: Spot, w: Spot) -> float:
        return (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0])

    return side(a, b, p) * side(a, b, q) < -1 and side(p, q, a) * side(p, q, b) < -1


def _height(runs: Runs, levels: list[int], s: Strand) -> tuple[float, float]:
    """Pixels up or down at the left and at the right end of a strand."""
    left, right = levels[runs.of_node[s.left]], levels[runs.of_node[s.right]]
    if s.number in runs.straight:
        return (abs(left - right) * UNIT, 0.0)
    own = levels[runs.of_strand[s.number]]
    return (abs(left - own) * UNIT, abs(right - own) * UNIT)


def _behind(plan: Plan, runs: Runs, levels: list[int], x: dict[NodeId, float]) -> tuple[Behind, ...]:
    """Runs on one level one behind the other, with room for the names at their ends."""
    ends: dict[int, list[tuple[NodeId, float]]] = {}
    for n, k in runs.of_node.items():
        ends.setdefault(k, []).append((n, 0.0))
    for s in plan.strands:
        if s.number in runs.of_strand:
            up, down = _height(runs, levels, s)
            ends[runs.of_strand[s.number]] = [
                *ends.get(runs.of_strand[s.number], []),
                (s.left, up),
                (s.right, -down),
            ]
    first = {k: min(v, key=lambda e: (x[e[0]] + e[1], e)) for k, v in ends.items()}
    last = {k: max(v, key=lambda e: (x[e[0]] + e[1], e)) for k, v in ends.items()}
    by_level: dict[int, list[int]] = {}
    for k in ends:
        by_level.setdefault(levels[k], []).append(k)
    out = []
    for group in by_level.values():
        ordered = sorted(group, key=lambda k: (runs.spans[k][0], k))
        for a, b in pairwise(ordered):
            if runs.spans[a][1] <= runs.spans[b][0] + 1:
                (m, p), (n, q) = last[a], first[b]
                out.append((m, n, outer(plan.layout, m) + outer(plan.layout, n) + 30 + p - q))
    return tuple(out)
