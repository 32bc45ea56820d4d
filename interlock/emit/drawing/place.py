"""Where everything of a plan lies: knots, bends, joints, signals and names, in pixels.

Along the track: every stretch is as long as its names and signals need, and its diagonals as wide as they are high; the
whole is as narrow as that allows, diagonals first (a shortest flow of networkx gives the optimum).  Across: the levels.
"""

from __future__ import annotations

from itertools import pairwise

import networkx as nx

from interlock.emit.drawing.canvas import LEAST, MARGIN, SIGNAL, TOP, UNIT, Drawing, Spot, width
from interlock.emit.drawing.levels import FEW, Runs, cost, place_levels
from interlock.emit.drawing.names import put_names
from interlock.emit.drawing.strands import Plan, Strand
from interlock.model.elements import EdgeId, NodeId, SectionId, Signal
from interlock.model.layout import Layout

TURNS = 5  # parts that are turned round on trial
CROSSED = 2000.0


Levelled = tuple[float, Plan, dict[NodeId, float], Runs, list[int]]


def _levelled(layout: Layout, mirrored: int) -> Levelled:
    """A plan with its levels, and what they cost."""
    plan = Plan(layout, mirrored)
    named = _named_edges(plan)
    x = _along(plan, {s.number: _length(plan, s, named, None) for s in plan.strands}, ())
    runs = Runs(plan, x)
    levels = place_levels(runs)
    return cost(runs, levels), plan, x, runs, levels


def place(layout: Layout) -> Drawing:
    """The plan of a layout."""
    first = _levelled(layout, 0)
    drawn = [_drawn(layout, first)]
    for mirrored in range(2, 1 << min(first[1].parts, TURNS), 2):  # the first part stays as it is declared
        drawn.append(_drawn(layout, _levelled(layout, mirrored)))
    return min(drawn, key=lambda t: t[0])[1]


def _drawn(layout: Layout, tried: Levelled) -> tuple[float, Drawing]:
    """The drawing, and what it costs with the lines that cross without a crossing."""
    total, plan, first, runs, levels = tried
    d = Drawing(layout, plan)
    named = _named_edges(plan)
    lengths = {
        s.number: _length(plan, s, named, _height(runs, levels, s), s.number in runs.straight) for s in plan.strands
    }
    x = _along(plan, lengths, _behind(plan, runs, levels, first))
    for c in layout.crossings:  # a scissors' middle in the middle
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
        _strand(d, s, own, named)
    for s in plan.stubs:
        knot, end = (s.left, s.right) if s.left in d.at else (s.right, s.left)
        (kx, ky), way = d.at[knot], 1 if knot == s.left else -1
        d.at[end] = (kx + way * 18, ky - 14)
        line = [d.at[knot], d.at[end]]
        for edge in s.edges:
            d.edges[edge] = line if way > 0 else line[::-1]
    if layout.crossings:
        total += CROSSED * _crossed(d)
    put_names(d, named)
    shift = MARGIN - min([t.box[0] for t in d.labels] + [p[0] for _, p, _ in d.outside] + [MARGIN])
    if shift > 0:
        _shift(d, shift)
    d.width = MARGIN + max([t.box[2] for t in d.labels] + [p[0] for p in d.at.values()])
    d.height = MARGIN + max([t.box[3] for t in d.labels] + [p[1] for p in d.at.values()])
    return total, d


def _crossed(d: Drawing) -> int:
    """Lines that cross where there is no crossing."""
    parts = [(e, a, b) for e, line in d.edges.items() for a, b in pairwise(line)]
    count = 0
    for i, (e, a, b) in enumerate(parts):
        for f, p, q in parts[i + 1 :]:
            if e != f and (a[1] != b[1] or p[1] != q[1]) and _cross(a, b, p, q):
                count += 1
    return count


def _cross(a: Spot, b: Spot, p: Spot, q: Spot) -> bool:
    """Two strokes cross between their ends."""

    def side(u: Spot, v: Spot, w: Spot) -> float:
        return (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0])

    return side(a, b, p) * side(a, b, q) < -1 and side(p, q, a) * side(p, q, b) < -1


def _shift(d: Drawing, by: float) -> None:
    d.at = {n: (x + by, y) for n, (x, y) in d.at.items()}
    d.edges = {e: [(x + by, y) for x, y in line] for e, line in d.edges.items()}
    d.labels = [t.moved(by, 0) for t in d.labels]
    d.signals = {g: (x + by, y, r) for g, (x, y, r) in d.signals.items()}
    d.distants = {g: (x + by, y, r) for g, (x, y, r) in d.distants.items()}
    d.joints = [(n, x + by, y, a) for n, x, y, a in d.joints]
    d.outside = [(n, (x + by, y), r) for n, (x, y), r in d.outside]


# --- along the track -----------------------------------------------------------------------------


def _named_edges(plan: Plan) -> dict[EdgeId, SectionId]:
    """The edge on which each section's name stands: the longest one that is not all diagonal."""
    layout = plan.layout
    diagonal = {e for s in plan.strands if plan.diverges(s, s.left) and plan.diverges(s, s.right) for e in s.edges}
    best: dict[SectionId, EdgeId] = {}
    for e in layout.edges:
        old = best.get(e.section)
        key = (e.id not in diagonal, e.length)
        if old is None or key > (old not in diagonal, layout.edge[old].length):
            best[e.section] = e.id
    return {e: s for s, e in best.items()}


def _signals_at(layout: Layout, node: NodeId) -> list[Signal]:
    return [g for e in layout.edges_at[node] if (g := layout.signal_facing.get((node, e.id))) is not None]


def _content(plan: Plan, s: Strand, k: int, named: dict[EdgeId, SectionId]) -> float:
    """Pixels that an edge of a strand needs for names and signals."""
    layout, edge = plan.layout, s.edges[k]
    need = 0.0
    for node in (s.nodes[k], s.nodes[k + 1]):
        signal = layout.signal_facing.get((node, edge))
        if signal is not None:
            need += max(SIGNAL, width(signal.id)) + 8
        elif node in layout.point_at:
            turned = edge == plan.turned_leg(layout.point_at[node])
            toe = edge == layout.point_at[node].toe
            need += 10 if turned else width(str(layout.point_at[node].id)) + 4 if toe else 40
        else:
            need += 6
    if edge in named:
        metres = sum(e.length for e in layout.edges if e.section == named[edge])
        need += max(width(named[edge]), 0.82 * width(f"{metres:g}")) + 14
    return max(LEAST, need)


def _length(
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


def _height(runs: Runs, levels: list[int], s: Strand) -> tuple[float, float]:
    """Pixels up or down at the left and at the right end of a strand."""
    left, right = levels[runs.of_node[s.left]], levels[runs.of_node[s.right]]
    if s.number in runs.straight:
        return (abs(left - right) * UNIT, 0.0)
    own = levels[runs.of_strand[s.number]]
    return (abs(left - own) * UNIT, abs(right - own) * UNIT)


Behind = tuple[NodeId, NodeId, float]
"""Two knots, and how far the second must lie to the right of the first at least."""


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
                out.append((m, n, _outer(plan.layout, m) + _outer(plan.layout, n) + 30 + p - q))
    return tuple(out)


def _outer(layout: Layout, node: NodeId) -> float:
    """Room that the end of a track needs beyond itself."""
    boundary = layout.boundary_at.get(node)
    if boundary is not None:
        reach = max(46.0, width(str(boundary.approach or "")) + 16)
        return reach + width(layout.labels.get(node, "") or node) + 10
    return width(node) + 12 if node in layout.buffer_at else 0.0


def _along(plan: Plan, lengths: dict[int, float], behind: tuple[Behind, ...]) -> dict[NodeId, float]:
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
    return _narrowest(graph)


def _narrowest(graph: nx.DiGraph[NodeId]) -> dict[NodeId, float]:
    """Least sum of weight times length over all edges, each as long as it must be: by the dual flow."""
    flow: nx.DiGraph[NodeId] = nx.DiGraph()
    demand = dict.fromkeys(graph.nodes, 0)
    for a, b, data in graph.edges(data=True):
        flow.add_edge(a, b, weight=-round(data["length"]))
        demand[a] -= data["weight"]
        demand[b] += data["weight"]
    for n in graph.nodes:
        flow.add_node(n, demand=demand[n])
    place: dict[NodeId, float] = {}
    for part in map(sorted, nx.weakly_connected_components(graph)):
        sub = flow.subgraph(part)
        _, found = nx.network_simplex(sub)
        back: nx.DiGraph[NodeId] = nx.DiGraph()
        back.add_nodes_from(part)
        for a, b, data in graph.subgraph(part).edges(data=True):
            back.add_edge(a, b, weight=-round(data["length"]))  # x(b) >= x(a) + length
            if found[a].get(b, 0) > 0:  # tight where there is flow
                back.add_edge(b, a, weight=round(data["length"]))
        start = "*"
        back.add_edges_from(((start, n) for n in part), weight=0)
        far = nx.single_source_bellman_ford_path_length(back, start)
        least = min(-far[n] for n in part)
        place |= {n: float(-far[n] - least) for n in part}
    return place


# --- lines ---------------------------------------------------------------------------------------


def _strand(d: Drawing, s: Strand, own: float | None, named: dict[EdgeId, SectionId]) -> None:
    """The line of a strand, cut into its edges."""
    (x0, y0), (x1, y1) = d.at[s.left], d.at[s.right]
    line = [(x0, y0)]
    if own is not None:
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
            share = spare * d.layout.edge[s.edges[k]].length / sum(d.layout.edge[e].length for e in s.edges)
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
