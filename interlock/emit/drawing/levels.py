"""Levels: how high each straight run of track lies.

A run is everything that goes straight on: strands with the knots that they pass without bending.  Its level is a whole
number, two to a track's distance; only a crossing between two diagonals may lie on an odd one.  Wanted, in this order:
no two runs on one another, no diagonal through a run, short diagonals, few levels.  First each run is put where it fits
best next to those that are there, longest first; then single runs and neighbouring pairs are moved as long as that
helps.  The same layout gives the same levels.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterable

from interlock.dataclass import dataclass
from interlock.emit.drawing.strands import Plan
from interlock.model.elements import NodeId

ON_ANOTHER, THROUGH, BENT_WRONG = 10_000, 400, 5_000
PASSES, FEW, MANY = 12, 60, 160
NEAR = 6  # levels around a neighbour that are tried first
EASE = 12.0  # a run that costs less lies well


@dataclass(frozen=True)
class Link:
    """A diagonal from a knot of one run to another run, at a place; `right`: it lies to the right of the knot.

    `pair`: the two diagonals of one arm of a crossing, which must leave on opposite sides.
    """

    knot: int
    run: int
    x: float
    right: bool
    pair: int


class Runs:
    """The runs of a plan, with the stretch that each covers from left to right."""

    def __init__(self, plan: Plan, x: dict[NodeId, float]) -> None:
        self.plan = plan
        parent: dict[object, object] = {}

        def root(k: object) -> object:
            while parent.setdefault(k, k) != k:
                k = parent[k]
            return k

        for s in plan.strands:
            for end in (s.left, s.right):
                if not plan.diverges(s, end):
                    parent[root(("strand", s.number))] = root(("node", end))
        roots: dict[object, int] = {}
        self.of_node: dict[NodeId, int] = {}
        self.of_strand: dict[int, int] = {}
        for s in plan.strands:
            for n in (s.left, s.right):
                self.of_node[n] = roots.setdefault(root(("node", n)), len(roots))
        self.straight: set[int] = set()
        for s in plan.strands:
            both = plan.diverges(s, s.left) and plan.diverges(s, s.right)
            if both and self.of_node[s.left] != self.of_node[s.right] and plan.crossover(s):
                self.straight.add(s.number)  # nothing but a diagonal: no level of its own
            else:
                self.of_strand[s.number] = roots.setdefault(root(("strand", s.number)), len(roots))
        self.count = len(roots)
        self.spans = [[float("inf"), float("-inf")] for _ in range(self.count)]
        for n, k in self.of_node.items():
            self._cover(k, x[n])
        for s in plan.strands:
            if s.number in self.of_strand:
                k = self.of_strand[s.number]
                bend = 40.0
                self._cover(k, x[s.left] + (bend if plan.diverges(s, s.left) else 0))
                self._cover(k, x[s.right] - (bend if plan.diverges(s, s.right) else 0))
        hints = dict(plan.layout.printed.drawing)
        self.fixed: dict[int, int] = {}
        for s in plan.strands:
            if s.number in self.of_strand:
                for e in s.edges:
                    if plan.layout.track.edge[e].section in hints:
                        self.fixed[self.of_strand[s.number]] = 2 * hints[plan.layout.track.edge[e].section]
        self.half = {
            self.of_node[c.node] for c in plan.layout.pointwork.crossings if len(plan.diagonal_arms[c.id]) == 2
        }
        self.links = self._links(x)
        self.links_of: list[list[int]] = [[] for _ in range(self.count)]
        for i, link in enumerate(self.links):
            self.links_of[link.knot].append(i)
            if link.run != link.knot:
                self.links_of[link.run].append(i)
        self.pairs: dict[int, list[int]] = {}
        for i, link in enumerate(self.links):
            if link.pair >= 0:
                self.pairs.setdefault(link.pair, []).append(i)

    def _cover(self, run: int, x: float) -> None:
        span = self.spans[run]
        span[0], span[1] = min(span[0], x), max(span[1], x)

    def _links(self, x: dict[NodeId, float]) -> list[Link]:
        out = []
        arms = {
            (c.node, e): 2 * i + k
            for i, c in enumerate(self.plan.layout.pointwork.crossings)
            for k in self.plan.diagonal_arms[c.id]
            for e in c.arms[k]
        }
        for s in self.plan.strands:
            for here, there, right, edge in (
                (s.left, s.right, True, s.edges[0]),
                (s.right, s.left, False, s.edges[-1]),
            ):
                if not self.plan.diverges(s, here):
                    continue
                pair = arms.get((here, edge), -1)
                if s.number in self.straight:
                    if right or pair >= 0:
                        out.append(Link(self.of_node[here], self.of_node[there], (x[here] + x[there]) / 2, right, pair))
                else:
                    out.append(Link(self.of_node[here], self.of_strand[s.number], x[here], right, pair))
        return out


def passes(count: int) -> int:
    """How often all runs are looked at again: a large layout gets a good plan in time, not the best."""
    return PASSES if count <= FEW else 3 if count <= MANY else 0


def place_levels(runs: Runs) -> list[int]:
    """The level of each run; 0 is that of the longest, unless a hint of the layout says otherwise."""
    order = _order(runs)
    level: list[int | None] = [None] * runs.count
    for k in order:
        level[k] = _best(runs, level, k)[0]
    found = [v if v is not None else 0 for v in level]
    for _ in range(passes(runs.count)):
        if not _improve(runs, found, order):
            break
    return found


def cost(runs: Runs, levels: list[int]) -> float:
    """What levels cost in all."""
    known: list[int | None] = list(levels)
    return sum(_cost_of(runs, known, k, v) for k, v in enumerate(levels))


def _allowed(runs: Runs, k: int, wanted: Iterable[int]) -> list[int]:
    return [v for v in wanted if k in runs.half or v % 2 == 0]


def _order(runs: Runs) -> list[int]:
    """The longest run first, then always the one that hangs on most: sidings with one end come last."""
    length = [b - a for a, b in runs.spans]
    near: list[set[int]] = [set() for _ in range(runs.count)]
    for link in runs.links:
        near[link.knot].add(link.run)
        near[link.run].add(link.knot)
    rank = {k: (-len(near[k]), -length[k], k) for k in range(runs.count)}
    left = sorted(range(runs.count), key=lambda k: (-length[k], k))
    out: list[int] = []
    seen: set[int] = set()
    for first in left:
        waiting = [] if first in seen else [(rank[first], first)]
        while waiting:
            _, k = heapq.heappop(waiting)
            if k in seen:
                continue
            seen.add(k)
            out.append(k)
            for j in near[k] - seen:
                heapq.heappush(waiting, (rank[j], j))
    return out


def _cost_of(runs: Runs, level: list[int | None], k: int, v: int) -> float:
    """What a run costs at a level, next to those that have one."""
    before, level[k] = level[k], v
    total = 0.0
    a, b = runs.spans[k]
    for j, (c, d) in enumerate(runs.spans):
        if j != k and level[j] == v and a - 30 < d and c < b + 30:
            total += ON_ANOTHER
    own = set(runs.links_of[k])
    for i in own:
        total += _link_cost(runs, level, i)
    for i, link in enumerate(runs.links):  # diagonals of others through this run
        if i not in own and a < link.x < b:
            p, q = level[link.knot], level[link.run]
            if p is not None and q is not None and min(p, q) < v < max(p, q):
                total += THROUGH
    level[k] = before
    return total + 0.5 * abs(v)


def _link_cost(runs: Runs, level: list[int | None], i: int) -> float:
    link = runs.links[i]
    p, q = level[link.knot], level[link.run]
    if p is None or q is None:
        return 0.0
    total = 3.0 * math.pow(abs(p - q), 1.5)
    if p == q:
        total += BENT_WRONG
    low, high = min(p, q), max(p, q)
    for j in runs.half if high - low <= 2 else range(runs.count):  # between neighbours there are but half levels
        v = level[j]
        if v is not None and low < v < high and j not in (link.knot, link.run):
            a, b = runs.spans[j]
            total += THROUGH if a < link.x < b else 0.0
    return total + _pair_cost(runs, level, i)


def _pair_cost(runs: Runs, level: list[int | None], i: int) -> float:
    """The two diagonals of one arm of a crossing must leave on opposite sides."""
    link, total = runs.links[i], 0.0
    p, q = level[link.knot], level[link.run]
    if link.pair >= 0:
        for other in runs.pairs[link.pair]:
            o = level[runs.links[other].run]
            if other != i and o is not None and p is not None and q is not None and (o - p) * (q - p) > 0:
                total += BENT_WRONG
    return total


def _best(runs: Runs, level: list[int | None], k: int) -> tuple[int, float]:
    """The best level for a run next to those that have one, and its cost: near what it hangs on, or else anywhere."""
    if k in runs.fixed:
        return runs.fixed[k], _cost_of(runs, level, k, runs.fixed[k])
    there = [v for v in level if v is not None]
    if not there:
        return 0, 0.0
    near = {level[j] for i in runs.links_of[k] for j in (runs.links[i].knot, runs.links[i].run) if j != k}
    close = {v + step for v in near if v is not None for step in range(-NEAR, NEAR + 1)}
    best: tuple[int, float] | None = None
    for candidates in (sorted(close), range(min(there) - 2, max(there) + 3)):
        for v in _allowed(runs, k, candidates):
            found = _cost_of(runs, level, k, v)
            if best is None or (found, abs(v), v) < (best[1], abs(best[0]), best[0]):
                best = (v, found)
        if best is not None and best[1] < THROUGH:
            break
    assert best is not None
    return best


def _improve(runs: Runs, found: list[int], order: list[int]) -> bool:
    level: list[int | None] = list(found)
    better = False
    for k in order[1:]:
        now = _cost_of(runs, level, k, found[k])
        if now < EASE:
            continue
        best, price = _best(runs, level, k)
        if price < now - 1e-9:
            level[k] = found[k] = best
            better = True
    for link in runs.links if runs.count <= FEW else ():  # two runs at once: what hangs together moves together
        for step in (-4, -2, 2, 4):
            pair = sorted({link.knot, link.run} - {order[0], *runs.fixed})
            if len(pair) != 2:
                continue
            before = [found[j] for j in pair]
            now = _both(runs, level, pair)
            for j in pair:
                level[j] = found[j] + step
            if _both(runs, level, pair) < now - 1e-9:
                for j in pair:
                    found[j] += step
                better = True
            else:
                for j, v in zip(pair, before, strict=True):
                    level[j] = v
    return better


def _both(runs: Runs, level: list[int | None], pair: list[int]) -> float:
    total = 0.0
    for k in pair:
        v = level[k]
        assert v is not None
        total += _cost_of(runs, level, k, v)
    return total
