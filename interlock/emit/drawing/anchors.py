"""Coordinates that the layout gives keep their places on the plan, and everything else moves with them.

The plan is first placed from topology alone.  Each element with coordinates is then moved to these; a knot without any
is moved as its neighbours are on the average, and the lines between as much as lies between their ends, so that what
was drawn as a diagonal stays one where both its ends move alike.
"""

from __future__ import annotations

from itertools import pairwise
from math import dist

from interlock.emit.drawing.canvas import MARGIN, TOP, Drawing, Spot
from interlock.emit.drawing.strands import Strand
from interlock.model.elements import NodeId

ROUNDS = 200  # of averaging: enough for stations of some hundred knots
Move = tuple[float, float]


def moved(d: Drawing) -> None:
    """Move what is placed to the coordinates of the layout."""
    given = _given(d)
    if not given:
        return
    moves = _spread(d, given)
    for s in d.plan.strands:
        _bend(d, s, moves, given)
    for n, (dx, dy) in moves.items():
        x, y = d.at[n]
        d.at[n] = (x + dx, y + dy)
    _into_view(d)


def _given(d: Drawing) -> dict[NodeId, Move]:
    """How far the nodes with coordinates move; of a slip all of it."""
    out = {}
    for a in d.layout.printed.anchors:
        there = [d.at[n] for n in a.nodes]
        dx = a.x - sum(x for x, _ in there) / len(there)
        dy = a.y - sum(y for _, y in there) / len(there)
        out.update(dict.fromkeys(a.nodes, (dx, dy)))
    return out


def _spread(d: Drawing, given: dict[NodeId, Move]) -> dict[NodeId, Move]:
    """How far every knot moves: as its neighbours do on the average."""
    near: dict[NodeId, list[NodeId]] = {}
    for s in d.plan.strands:
        stops = [s.left, *(n for n in s.nodes[1:-1] if n in given), s.right]
        for a, b in pairwise(stops):
            near.setdefault(a, []).append(b)
            near.setdefault(b, []).append(a)
    mean = (sum(x for x, _ in given.values()) / len(given), sum(y for _, y in given.values()) / len(given))
    moves = {n: given.get(n, mean) for n in sorted(near)}
    free = [n for n in moves if n not in given]
    for _ in range(ROUNDS):
        for n in free:
            those = [moves[m] for m in near[n]]
            moves[n] = (sum(x for x, _ in those) / len(those), sum(y for _, y in those) / len(those))
    return moves


def _bend(d: Drawing, s: Strand, moves: dict[NodeId, Move], given: dict[NodeId, Move]) -> None:
    """Move the spots of a strand by what lies between the moves of its ends, and of what has coordinates within it."""
    lines = [d.edges[e] if _starts(d, s, k) else d.edges[e][::-1] for k, e in enumerate(s.edges)]
    lengths = [sum(dist(a, b) for a, b in pairwise(line)) for line in lines]
    stops = [(0.0, moves[s.left])]
    run = 0.0
    for k, n in enumerate(s.nodes[1:-1]):
        run += lengths[k]
        if n in given:
            stops.append((run, given[n]))
    stops.append((sum(lengths), moves[s.right]))
    run = 0.0
    for k, (edge, line) in enumerate(zip(s.edges, lines, strict=True)):
        out, here = [], run
        for i, spot in enumerate(line):
            here += dist(line[i - 1], spot) if i else 0.0
            dx, dy = _between(stops, here)
            out.append((spot[0] + dx, spot[1] + dy))
        run += lengths[k]
        if k + 1 < len(s.edges):
            moves[s.nodes[k + 1]] = _between(stops, run)
        d.edges[edge] = out if out[0] <= out[-1] else out[::-1]


def _starts(d: Drawing, s: Strand, k: int) -> bool:
    """Whether an edge of a strand is written from the strand's left end."""
    return dist(d.edges[s.edges[k]][0], d.at[s.nodes[k]]) < dist(d.edges[s.edges[k]][-1], d.at[s.nodes[k]])


def _between(stops: list[tuple[float, Move]], at: float) -> Move:
    for (a, one), (b, two) in pairwise(stops):
        if at <= b or b == stops[-1][0]:
            part = min(1.0, (at - a) / (b - a)) if b > a else 1.0
            return (one[0] + (two[0] - one[0]) * part, one[1] + (two[1] - one[1]) * part)
    return stops[-1][1]


def _into_view(d: Drawing) -> None:
    """Below the title, and within the left margin; distances stay."""
    dx = MARGIN - min(x for x, _ in d.at.values())
    dy = TOP - min(min(y for _, y in line) for line in d.edges.values())

    def put(spot: Spot) -> Spot:
        return (spot[0] + dx, spot[1] + dy)

    d.at = {n: put(spot) for n, spot in d.at.items()}
    d.edges = {e: [put(spot) for spot in line] for e, line in d.edges.items()}
