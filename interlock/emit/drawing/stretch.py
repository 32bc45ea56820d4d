"""Along the track: how long every stretch is, where its bends lie, and how it is cut into edges.

Every stretch is as long as its names and signals need, and its diagonals as wide as they are high; the whole is as
narrow as that allows, diagonals first (the dual of a flow gives the optimum).
"""

from __future__ import annotations

from itertools import pairwise

import networkx as nx

from interlock.emit.drawing.anchors import moved
from interlock.emit.drawing.canvas import (
    ARC,
    BLADES,
    DEVICE,
    DISTANT,
    LEAST,
    MARGIN,
    TOP,
    UNIT,
    Drawing,
    Spot,
    announced,
    boundary_name,
    cut_at,
    point_name,
    reach,
    width,
)
from interlock.emit.drawing.lamps import long_symbol, symbol_width
from interlock.emit.drawing.names import put_names
from interlock.emit.drawing.narrowest import narrowest
from interlock.emit.drawing.slips import double_slips
from interlock.emit.drawing.strands import Plan, Strand
from interlock.model.elements import EdgeId, NodeId, SectionId
from interlock.model.layout import Layout


def named_edges(plan: Plan) -> dict[EdgeId, SectionId]:
    """The edge on which each section's name stands: the longest one that is not all diagonal."""
    layout = plan.layout
    slanting = (s for s in plan.strands if plan.diverges(s, s.left) and plan.diverges(s, s.right))
    diagonal = plan.rails | {e for s in slanting for e in s.edges}
    best: dict[SectionId, EdgeId] = {}
    for e in layout.track.edges:
        old = best.get(e.section)
        key = (e.id not in diagonal, e.length)
        if old is None or key > (old not in diagonal, layout.track.edge[old].length):
            best[e.section] = e.id
    return {e: s for s, e in best.items()}


CORNER = 8
"""Pixels between a symbol with more than two units and the arm that crosses its track beyond it."""


def _content(plan: Plan, s: Strand, k: int, named: dict[EdgeId, SectionId]) -> float:
    """Pixels that an edge of a strand needs for names and signals."""
    layout, edge = plan.layout, s.edges[k]
    need = 0.0
    for node in (s.nodes[k], s.nodes[k + 1]):
        signal = layout.signalling.facing.get((node, edge))
        if signal is not None:
            need += max(symbol_width(layout, signal), width(signal.id)) + 8
            need += (
                CORNER
                if long_symbol(layout, signal) and layout.pointwork.crossing_at.keys() & s.nodes[k : k + 2]
                else 0
            )
        elif node in layout.pointwork.point_at:
            turned = edge == plan.turned_leg(layout.pointwork.point_at[node])
            toe = edge == layout.pointwork.point_at[node].toe
            need += 10 if turned else width(point_name(layout.pointwork.point_at[node])) + 4 if toe else 40
        else:
            need += _slip_room(plan, node)
        if announced(layout, node, edge):
            need += DISTANT
    if edge in named:
        metres = sum(e.length for e in layout.track.edges_in[named[edge]])
        letters = max(width(named[edge]), 0.82 * width(f"{metres:g}"))
        need += letters + 14
        if any(named[edge] in x.over for x in layout.signalling.devices):
            need += DEVICE + letters  # the device may lie in the middle, with the name on either side
    return max(LEAST, need)


def _slip_room(plan: Plan, node: NodeId) -> float:
    """Pixels that an arm needs at a diamond: of a double slip with two machines, for its blades and their name."""
    if node not in plan.slips:
        return 6
    double = any(node == s.nodes[0] for s in double_slips(plan.layout))
    return BLADES + width(node) + 20 if double else 6


def length_of(
    plan: Plan,
    s: Strand,
    named: dict[EdgeId, SectionId],
    heights: tuple[float, float] | None,
    straight: bool = False,
) -> float:
    """Least pixels of a strand: its edges, and its diagonals at either end."""
    content = sum(_content(plan, s, k, named) for k in range(len(s.edges)))
    if heights is None:
        bends = sum(2 * UNIT for end in (s.left, s.right) if plan.diverges(s, end))
        return content if bends == 4 * UNIT else content + bends
    return max(heights[0], content * 0.6) if straight else content + sum(heights)


Behind = tuple[NodeId, NodeId, float]
"""Two knots, and how far the second must lie to the right of the first at least."""


def outer(layout: Layout, node: NodeId) -> float:
    """Room that the end of a track needs beyond itself."""
    boundary = layout.track.boundary_at.get(node)
    if boundary is not None:
        return reach(layout, node) + width(boundary_name(layout, node)) + 10
    return width(node) + 12 if node in layout.track.buffer_at else 0.0


def along(plan: Plan, lengths: dict[int, float], behind: tuple[Behind, ...]) -> dict[NodeId, float]:
    """The left-to-right place of every knot: every strand as long as it must be, the whole as narrow as it can be."""
    graph: nx.DiGraph[NodeId] = nx.DiGraph()
    wanted: dict[tuple[NodeId, NodeId], tuple[float, int]] = {}
    for s in plan.strands:
        graph.add_nodes_from((s.left, s.right))
        if s.left == s.right:
            continue
        turned = plan.diverges(s, s.left) or plan.diverges(s, s.right)
        old = wanted.get((s.left, s.right), (0.0, 0))
        wanted[s.left, s.right] = (max(old[0], lengths[s.number]), old[1] + (8 if turned else 1))
    for a, b, apart in behind:
        if a != b:
            old = wanted.get((a, b), (apart, 0))
            wanted[a, b] = (max(old[0], apart), old[1])
    for (a, b), (length, weight) in sorted(wanted.items()):
        if graph.has_edge(b, a) or (graph.has_node(b) and graph.has_node(a) and nx.has_path(graph, b, a)):
            continue  # it would run back: drawn as it comes
        graph.add_edge(a, b, length=length, weight=weight)
    return narrowest(graph)


# --- lines ---------------------------------------------------------------------------------------


def put_strand(d: Drawing, s: Strand, own: float | None, named: dict[EdgeId, SectionId]) -> None:
    """The line of a strand, cut into its edges."""
    (x0, y0), (x1, y1) = d.at[s.left], d.at[s.right]
    line = [(x0, y0)]
    if own is not None:
        y0, y1 = (own if n in d.plan.turns else y for n, y in ((s.left, y0), (s.right, y1)))
        line = [(x0, y0)]
        if own != y0:
            line.append((x0 + abs(own - y0), own))
        if own != y1:
            line.append((x1 - abs(own - y1), own))
    line.append((x1, y1))
    flat0 = line[1][0] if own is not None and own != y0 else x0
    flat1 = line[-2][0] if own is not None and own != y1 else x1
    if len(line) > 2 and flat1 < flat0:
        d.notes.append(f"strand of {s.edges[0]} is too short for its diagonals")
    contents = [_content(d.plan, s, k, named) for k in range(len(s.edges))]
    cuts = [x0]
    if own is None:
        total, run = sum(contents), 0.0
        for c in contents:
            run += c
            cuts.append(x0 + (x1 - x0) * run / total)
    else:
        spare = (flat1 - flat0) - sum(contents)
        run = flat0
        for k, c in enumerate(contents):
            share = spare * d.layout.track.edge[s.edges[k]].length / sum(d.layout.track.edge[e].length for e in s.edges)
            run += c + share
            cuts.append(run)
    cuts[-1] = x1
    for k, edge in enumerate(s.edges):
        a, b = cuts[k], cuts[k + 1]
        inner = [p for p in line[1:-1] if a < p[0] < b]
        d.edges[edge] = [_spot(line, a), *inner, _spot(line, b)]
        if k:
            d.at[s.nodes[k]] = _spot(line, a)


def _spot(line: list[Spot], x: float) -> Spot:
    for (x0, y0), (x1, y1) in pairwise(line):
        if x <= x1 or (x1, y1) == line[-1]:
            if x1 == x0:
                return (x, y1)
            return (x, y0 + (y1 - y0) * (x - x0) / (x1 - x0))
    return line[-1]


def _slips(d: Drawing) -> None:
    """Points of slips close to their diamond, on its arms, and slip rails as chords between them."""
    for p in d.plan.slip_points:
        toe, straight = d.edges[p.toe], d.edges[p.normal]
        middle = next(n for n in (d.layout.track.edge[p.normal].a, d.layout.track.edge[p.normal].b) if n != p.node)
        onward = straight[0] == d.at[middle]  # the arm leads to the right
        line = [*straight, *toe[1:]] if onward else [*toe, *straight[1:]]
        inner, outer = cut_at(line if onward else line[::-1], BLADES)
        d.at[p.node] = inner[-1]
        d.edges[p.normal], d.edges[p.toe] = (inner, outer) if onward else (inner[::-1], outer[::-1])
    for rail in d.plan.rails:
        e = d.layout.track.edge[rail]
        d.edges[rail] = sorted((d.at[e.a], d.at[e.b]))


def finish(d: Drawing, named: dict[EdgeId, SectionId]) -> None:
    """Coordinates, slips, strokes that lead off the rails, signals and names, and the size of the whole."""
    moved(d)
    _slips(d)
    for s in d.plan.stubs:
        knot, end = (s.left, s.right) if s.left in d.at else (s.right, s.left)
        (kx, ky), way = d.at[knot], 1 if knot == s.left else -1
        d.at[end] = (kx + way * 18, ky - 14)
        line = [d.at[knot], d.at[end]]
        for edge in s.edges:
            d.edges[edge] = line if way > 0 else line[::-1]
    put_names(d, named)
    bulges, spots = [d.at[n][0] - ARC for n in d.plan.turns], [p for line in d.edges.values() for p in line]
    left = min([t.box[0] for t in d.labels] + [p[0] for _, p, _ in d.outside] + bulges + [x + MARGIN for x, _ in spots])
    top = min((y for _, y in spots), default=TOP)  # of what cannot lie in a plane a line may lead out of it
    if left < MARGIN or top < 0:
        _shift(d, max(0.0, MARGIN - left), TOP - top if top < 0 else 0.0)
    bulges, spots = [d.at[n][0] + ARC for n in d.plan.turns], [p for line in d.edges.values() for p in line]
    d.width = MARGIN + max(
        [t.box[2] for t in d.labels] + [p[0] for p in d.at.values()] + bulges + [x for x, _ in spots]
    )
    d.height = MARGIN + max([t.box[3] for t in d.labels] + [p[1] for p in d.at.values()] + [y for _, y in spots])


def _shift(d: Drawing, by: float, down: float) -> None:
    d.at = {n: (x + by, y + down) for n, (x, y) in d.at.items()}
    d.edges = {e: [(x + by, y + down) for x, y in line] for e, line in d.edges.items()}
    d.labels = [t.moved(by, down) for t in d.labels]
    d.signals = {g: (x + by, y + down, r) for g, (x, y, r) in d.signals.items()}
    d.distants = {g: (x + by, y + down, r) for g, (x, y, r) in d.distants.items()}
    d.joints = [(n, x + by, y + down, a) for n, x, y, a in d.joints]
    d.outside = [(n, (x + by, y + down), r) for n, (x, y), r in d.outside]
