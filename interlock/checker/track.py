"""The track of a layout: its sections with their ends, and the ways through them, made from the drawing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise

from interlock.checker.drawing import Drawing, Edge
from interlock.verify import need


@dataclass(frozen=True)
class Demand:
    """A machine and the position in which a way needs it."""

    machine: str
    position: str

    @property
    def opposite(self) -> str:
        """The other position."""
        return "R" if self.position == "N" else "N"


@dataclass(frozen=True)
class Way:
    """A way through a section from one end to another, numbered from 1 by its ends and edges.

    points: each point on it, and how it must lie.  arms: each diamond on it, and over which arm (0 or 1).
    """

    section: str
    number: int
    entry: str
    exit: str
    points: tuple[tuple[str, Demand], ...]
    arms: tuple[tuple[str, int], ...]
    edges: tuple[str, ...]
    length: float


class Track:
    """Sections, their ends, and the ways through them.  told: what the layout says of a section beside its track."""

    def __init__(self, drawn: Drawing, told: Mapping[str, Mapping[str, str]]) -> None:
        self._drawn, self.told = drawn, told
        self.sections = sorted({e.section for e in drawn.edges.values()})
        self.undetected = self.denied("detected")
        touch: dict[str, set[str]] = {}
        for e in drawn.edges.values():
            for n in (e.a, e.b):
                touch.setdefault(n, set()).add(e.section)
        self._touch = touch
        self.ends = {s: sorted(n for n, those in touch.items() if s in those and self._end(n)) for s in self.sections}
        self.ways = {s: list(self._through(s)) for s in self.sections}

    def denied(self, key: str) -> list[str]:
        """The sections to which the layout says no under `detected`, or `berth`."""
        return [s for s in self.sections if (self.told.get(s) or {}).get(key) in ("no", "false")]

    def _end(self, node: str) -> bool:
        if node in self._drawn.boundaries or node in self._drawn.buffers:
            return True
        return node not in self._drawn.points and node not in self._drawn.diamonds and len(self._touch[node]) > 1

    def beyond(self, section: str, node: str) -> str | None:
        """The neighbour across an end."""
        return next((s for s in sorted(self._touch.get(node, ())) if s != section), None)

    def _through(self, section: str) -> Iterator[Way]:
        d = self._drawn
        found: list[tuple[str, str, tuple[str, ...]]] = []

        begun: list[tuple[str, tuple[Edge, ...], str, frozenset[str]]] = [
            (start, (e,), start, frozenset({start}))
            for start in self.ends[section]
            for e in d.at[start]
            if e.section == section
        ]
        while begun:
            node, path, start, seen = begun.pop()
            e = path[-1]
            there = e.far(node)
            if (e.one_way and e.a != node) or there in d.off_rails:
                continue
            if self._end(there):
                found.append((start, there, tuple(x.name for x in path)))
            elif there not in seen:
                more = (x for x in d.onward(there, e) if x.section == section)
                begun += [(there, (*path, x), start, seen | {there}) for x in more]
        for number, (a, b, names) in enumerate(sorted(found), 1):
            metres = sum(d.edges[n].length for n in names)
            yield Way(section, number, a, b, *self._passed(a, names), names, metres)

    def _passed(
        self, node: str, names: tuple[str, ...]
    ) -> tuple[tuple[tuple[str, Demand], ...], tuple[tuple[str, int], ...]]:
        """The points and diamonds over which edges lead."""
        d, points, arms = self._drawn, [], []
        for a, b in pairwise(names):
            node = d.edges[a].far(node)
            point, diamond = d.points.get(node), d.diamonds.get(node)
            if point is not None:
                x = point.position(b if a == point.toe else a)
                need(x is not None, f"a way leads over point {node} from leg to leg")
                points.append((node, Demand(point.machine, str(x))))
            if diamond is not None:
                arms.append((node, 0 if a in diamond.arms[0] else 1))
        return tuple(points), tuple(arms)

    def from_end(self, section: str, node: str) -> list[Way]:
        """The ways through a section from one of its ends."""
        return [w for w in self.ways[section] if w.entry == node]
