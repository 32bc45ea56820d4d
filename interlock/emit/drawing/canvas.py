"""What a drawing consists of: spots, names, and what is taken already."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field, replace
from itertools import pairwise
from math import dist

from interlock.dataclass import dataclass
from interlock.emit.drawing.strands import Plan
from interlock.model.elements import EdgeId, NodeId, Point, SectionId
from interlock.model.layout import Layout

UNIT = 42  # pixels of a level: half a track's distance
LEAST = 26  # of an edge without any name
SIGNAL = 34  # of a signal's symbol
DEVICE = 24  # of a road or frame across a track
DISTANT = 30  # of a distant signal beside the name of its section
MARGIN, TOP = 40, 84
BLADES = 40.0  # from the middle of a slip's diamond to its blades
ARC = 1.5 * UNIT  # the largest radius of a track that turns back
WIDE = {"W": 11.0, "M": 9.8, "m": 9.8}  # of letters that are much wider than the others, bold ones too

Spot = tuple[float, float]
Box = tuple[float, float, float, float]


def width(text: str) -> float:
    """Pixels of a name at the size in which it is drawn."""
    return sum(11.5 if ord(c) > 0x2E80 else WIDE.get(c, 6.4) for c in text)


@dataclass(frozen=True)
class Label:
    """A name: what kind of thing bears it, its id, the text, the middle of its line, and whether it is a length."""

    kind: str
    id: str
    text: str
    x: float
    y: float
    small: bool = False
    anchor: str = "middle"

    @property
    def box(self) -> Box:
        """Left, top, right, bottom."""
        wide = width(self.text) * (0.82 if self.small else 1)
        left = self.x - {"start": 0.0, "middle": wide / 2, "end": wide}[self.anchor]
        return (left, self.y - 9, left + wide, self.y + 2.5)

    def moved(self, dx: float, dy: float) -> Label:
        """The same elsewhere."""
        return replace(self, x=self.x + dx, y=self.y + dy)


class Taken:
    """Where something is drawn already: boxes in a grid, names apart from lines and marks."""

    CELL = 48

    def __init__(self) -> None:
        self._cells: dict[tuple[int, int], list[tuple[Box, bool]]] = {}

    def add(self, box: Box, name: bool = False) -> None:
        """Something is here."""
        for cell in self._over(box):
            self._cells.setdefault(cell, []).append((box, name))

    def meets(self, box: Box, names_only: bool = False) -> bool:
        """Whether something is there."""
        return any(
            (name or not names_only) and _meet(box, other)
            for cell in self._over(box)
            for other, name in self._cells.get(cell, ())
        )

    def _over(self, box: Box) -> Iterator[tuple[int, int]]:
        for x in range(int(box[0] // self.CELL), int(box[2] // self.CELL) + 1):
            for y in range(int(box[1] // self.CELL), int(box[3] // self.CELL) + 1):
                yield (x, y)


@dataclass
class Drawing:
    """A plan with its places.  Edges are lines of spots from left to right; `turned`: the right end of a signal's
    track lies behind it."""

    layout: Layout
    plan: Plan
    at: dict[NodeId, Spot] = field(default_factory=dict)
    edges: dict[EdgeId, list[Spot]] = field(default_factory=dict)
    labels: list[Label] = field(default_factory=list)
    signals: dict[str, tuple[float, float, bool]] = field(default_factory=dict)
    distants: dict[str, tuple[float, float, bool]] = field(default_factory=dict)
    joints: list[tuple[NodeId, float, float, float]] = field(default_factory=list)
    taken: Taken = field(default_factory=lambda: Taken())
    outside: list[tuple[NodeId, Spot, bool]] = field(default_factory=list)
    width: float = 0.0
    height: float = 0.0
    notes: list[str] = field(default_factory=list)


def cut_at(line: list[Spot], far: float) -> tuple[list[Spot], list[Spot]]:
    """A line in two, so far from its beginning, but not beyond half of it."""
    far = min(far, sum(dist(a, b) for a, b in pairwise(line)) / 2)
    for k, (a, b) in enumerate(pairwise(line)):
        long = dist(a, b)
        if far <= long:
            spot = (a[0] + (b[0] - a[0]) * far / long, a[1] + (b[1] - a[1]) * far / long)
            return [*line[: k + 1], spot], [spot, *line[k + 1 :]]
        far -= long
    return line, line[-1:]


def flat(line: list[Spot]) -> tuple[Spot, Spot]:
    """The longest level part of an edge, or its longest part."""
    parts = list(pairwise(line))
    return max(parts, key=lambda p: (p[0][1] == p[1][1], abs(p[1][0] - p[0][0])))


# --- names and signals ---------------------------------------------------------------------------

APART = 36.0
"""Pixels along the track from the joint of a signal to the middle of a device that stands clear of it."""


def bend(d: Drawing, point: str) -> Spot:
    """The next spot on the turned leg of a point."""
    p = d.layout.pointwork.point[point]  # type: ignore[index]
    return next_spot(d.edges[d.plan.turned_leg(p)], d.at[p.node])


def next_spot(line: list[Spot], end: Spot) -> Spot:
    """Where a line goes from one of its ends."""
    return line[1] if line[0] == end else line[-2]


def fouling_mark(d: Drawing, point: str) -> Spot | None:
    """Where the fouling point of a point is marked: between its legs; nowhere at a derailer, and within a slip."""
    p = d.layout.pointwork.point[point]  # type: ignore[index]
    if p.derailer or p.reverse in d.plan.rails:
        return None
    (x, y), far = d.at[d.layout.pointwork.point[point].node], bend(d, point)  # type: ignore[index]
    return (x + (27 if far[0] > x else -27), y + (12 if far[1] > y else -12))


def device_spots(d: Drawing, over: tuple[SectionId, ...]) -> list[Spot]:
    """Where a device lies over its sections: once over those that follow each other, in the middle of them, at a joint
    without signals or within a section."""
    out = []
    for row in _rows(d, over):
        joints = [_joint(d, s, t) for s, t in pairwise(row)]
        half = len(row) // 2
        middle = joints[half - 1] if len(row) % 2 == 0 else None
        out.append(_within(d, row[half]) if middle is None else d.at[middle])
    return out


def _rows(d: Drawing, over: tuple[SectionId, ...]) -> list[list[SectionId]]:
    """Sections that follow each other on one level, from end to end."""
    near = {s: [t for t in over if t != s and _joint(d, s, t) is not None] for s in over}
    rows, seen = list[list[SectionId]](), set[SectionId]()
    for first in (*(s for s in over if len(near[s]) < 2), *over):  # beginning at an end, but of a ring
        row: list[SectionId] = []
        onward = [first]
        while onward and onward[0] not in seen:
            row.append(onward[0])
            seen.add(onward[0])
            onward = [t for t in near[row[-1]] if t not in seen]
        rows += [row] if row else []
    return rows


def _joint(d: Drawing, s: SectionId, t: SectionId) -> NodeId | None:
    """The joint between two sections where both are level, and no signal stands."""
    signals = {g.node for g in d.layout.signalling.signals}
    ends = [{n for e in d.layout.track.edges_in[x] for n in (e.a, e.b) if _is_level(d, e.id, n)} for x in (s, t)]
    return min(ends[0] & ends[1] - signals, default=None)


def _is_level(d: Drawing, edge: EdgeId, node: NodeId) -> bool:
    """Whether an edge is level where it meets a node."""
    line = d.edges[edge]
    a, b = line[:2] if line[0] == d.at[node] else line[-2:]
    return a[1] == b[1]


def _within(d: Drawing, s: SectionId) -> Spot:
    """Where a device lies over a section: clear of the signals that lead into it, and of fouling points, if there is
    room."""
    fouls = [mark for p in d.layout.pointwork.points if (mark := fouling_mark(d, p.id)) is not None]
    stretches = [flat(d.edges[e.id]) for e in d.layout.track.edges if e.section == s]
    (x0, y0), (x1, y1) = max(stretches, key=lambda p: abs(p[1][0] - p[0][0]))
    masts = [d.at[g.node][0] for g in d.layout.signalling.signals if d.layout.track.section_of(g.into) == s]
    off = [(x, APART) for x in masts] + [(x, 12.0) for x in (x0, x1)]
    near = [(x, 16.0) for x, y in fouls if abs(y - y0) < UNIT / 2]
    free = [k for k in (0.25, 0.5, 0.75) if all(abs(x0 + (x1 - x0) * k - x) >= m for x, m in off)]
    clear = [k for k in (*free, 0.5) if all(abs(x0 + (x1 - x0) * k - x) >= m for x, m in near)]
    k = next(iter([*clear, *free]), 0.5)
    return (x0 + (x1 - x0) * k, y0 + (y1 - y0) * k)


def arrow(d: Drawing, edge: EdgeId) -> tuple[Spot, bool]:
    """Where the arrow of a one-way edge lies, and whether it points to the right."""
    e, line = d.layout.track.edge[edge], d.edges[edge]
    (x0, y0), (x1, y1) = flat(line)
    return (x0 + (x1 - x0) * 0.8, y0 + (y1 - y0) * 0.8), (line[0] == d.at[e.a]) is (x1 > x0)


def reach(layout: Layout, node: NodeId) -> float:
    """How far a line is drawn beyond its boundary: for the name of its section, and a distant signal beside it."""
    approach = layout.track.boundary_at[node].approach
    return max(46.0, width(str(approach or "")) + 16) + (DISTANT if announced(layout, node) else 0.0)


def boundary_name(layout: Layout, node: NodeId) -> str:
    """A boundary by its label and by the id with which tables and routes name it."""
    label = layout.printed.labels.get(node, "")
    return f"{label} ({node})" if label and label != node else str(node)


def point_name(p: Point) -> str:
    """A point, with the machine that works it where its name does not show that: `1/3` works 1 and 3, `201` 201A."""
    own, machine = str(p.id), str(p.machine)
    rest = own.removeprefix(machine)
    told = own in machine.split("/") or (rest != own and not (machine[-1].isdigit() and rest[:1].isdigit()))
    return own if own == machine or told else f"{own} ({machine})"


def announced(layout: Layout, node: NodeId, edge: EdgeId | None = None) -> bool:
    """Whether a distant signal is drawn in rear of the signal at a node, on this edge or beyond the boundary."""
    mains = (layout.signalling.signal[k.of] for k in layout.signalling.distants)
    return any(g.node == node and g.into != edge for g in mains)


def entered(strokes: Iterable[tuple[Spot, Spot]], boxes: Sequence[Box]) -> set[int]:
    """The boxes, by number, that strokes run through.  They lie in rows, sorted from left to right, so that a stroke is
    compared with those alone that it may reach: comparing all pairs takes most of the time of a long line."""
    rows: dict[int, list[tuple[float, int]]] = {}
    for k, (left, top, _, bottom) in enumerate(boxes):
        for row in range(int(top // UNIT), int(bottom // UNIT) + 1):
            rows.setdefault(row, []).append((left, k))
    for there in rows.values():
        there.sort()
    widest = max((right - left for left, _, right, _ in boxes), default=0.0) + 1  # rounding
    found: set[int] = set()
    for a, b in strokes:
        least, most, top, bottom = min(a[0], b[0]), max(a[0], b[0]), min(a[1], b[1]), max(a[1], b[1])
        for row in range(int(top // UNIT), int(bottom // UNIT) + 1):
            there = rows.get(row, [])
            first, end = bisect_left(there, (least - widest, 0)), bisect_left(there, (most, 0))
            found.update(k for _, k in there[first:end] if k not in found and enters(a, b, boxes[k]))
    return found


def enters(a: Spot, b: Spot, box: Box) -> bool:
    """Whether a stroke runs through a box, not only along its edge."""
    low, high = 0.0, 1.0
    for start, end, least, most in ((a[0], b[0], box[0], box[2]), (a[1], b[1], box[1], box[3])):
        if start == end:
            if not least < start < most:
                return False
            continue
        one, two = sorted(((least - start) / (end - start), (most - start) / (end - start)))
        low, high = max(low, one), min(high, two)
    return low < high


def _meet(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
