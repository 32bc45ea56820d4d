"""Overlaps (R4): the track beyond a signal into which a train may run that fails to stop at it.

Lengths are metres.  An overlap ends at the first joint at or beyond its length, at a boundary, or at the end of the
track; one of infinite length, a successive route, also at the next main signal.
"""

from __future__ import annotations

from itertools import pairwise
from math import isinf

from interlock.model.elements import NodeId, PointId, Position, SectionId, SignalId
from interlock.model.layout import Layout, of_layout
from interlock.model.traversal import Traversal, topology


def overlap_length(speed_kmh: float, falling_permille: float) -> float:
    """The length needed for a speed and a gradient (falling is positive), read off published German examples:
    50 m to 40 km/h, 100 m to 60 km/h, 200 m above; 10 % more for each permille falling, 5 % less for each rising."""
    base = 50.0 if speed_kmh <= 40 else 100.0 if speed_kmh <= 60 else 200.0
    share = 0.10 * falling_permille if falling_permille > 0 else 0.05 * falling_permille
    return base * max(0.0, 1.0 + share)


@of_layout
def overlap_paths(layout: Layout, signal: SignalId) -> tuple[tuple[Traversal, ...], ...]:
    """Every alternative of a signal's overlap, as ways through sections in order; empty without overlap.

    Where two alternatives of different length come together, the one that is long enough goes on as far as the other:
    nobody knows over which of them a train came that has overrun the signal.
    """
    if layout.overlap_of.get(signal, 0.0) <= 0:
        return ()
    plain = [ways for ways in _search(layout, signal, frozenset()) if _agrees(layout, ways)]
    steps = frozenset((a.section, a.exit, b.section) for ways in plain for a, b in pairwise(ways))
    found = [ways for ways in _search(layout, signal, steps) if _agrees(layout, ways)]
    return tuple(sorted(found, key=lambda ws: (_reversed(ws), [t.key for t in ws])))


def _search(
    layout: Layout, signal: SignalId, steps: frozenset[tuple[SectionId, NodeId, SectionId]]
) -> list[tuple[Traversal, ...]]:
    """Paths that are long enough and do not end where one of the steps goes on."""
    length = layout.overlap_of[signal]
    g = layout.signal[signal]
    topo = topology(layout)
    found: list[tuple[Traversal, ...]] = []
    todo: list[tuple[tuple[Traversal, ...], float]] = [
        ((t,), t.length) for t in topo.through(layout.section_of(g.into), g.node)
    ]
    while todo:
        ways, gone = todo.pop()
        last = ways[-1]
        onward = topo.beyond(last.section, last.exit)
        enough = gone >= length or (isinf(length) and (last.exit, onward) in topo.main_into)
        if onward is None or (enough and (last.section, last.exit, onward) not in steps):
            found.append(ways)
            continue
        if all(w.section != onward for w in ways):
            todo.extend(((*ways, t), gone + t.length) for t in topo.through(onward, last.exit))
    return found


def _agrees(layout: Layout, ways: tuple[Traversal, ...]) -> bool:
    wanted: dict[str, Position] = {}
    return all(wanted.setdefault(layout.point[p].machine, x) is x for t in ways for p, x in t.points)


def _reversed(ways: tuple[Traversal, ...]) -> int:
    points: list[tuple[PointId, Position]] = [p for t in ways for p in t.points]
    return sum(x is Position.REVERSE for _, x in points)
