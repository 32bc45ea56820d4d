"""Overlaps (R4): the track beyond a signal into which a train may run that fails to stop at it.

Lengths are metres.  An overlap ends at the first joint at or beyond its length, at a boundary, or at the end of the
track; one of infinite length, a successive route, also at the next main signal.  Alternatives over different points may
have lengths of their own, and speeds for which they are made; those over what the author bars are none.  A short one
that lies inside a longer one is told apart from it by its speed: see `told_apart`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import ceil, isinf

from interlock.model.elements import NodeId, OverlapWay, PointId, Position, SectionId, SignalId
from interlock.model.layout import Layout, of_layout
from interlock.model.times import stated
from interlock.model.too_many import overlaps
from interlock.model.traversal import Traversal, path_speed, topology


def overlap_length(speed_kmh: float, falling_permille: float) -> float:
    """The length needed for a speed and a gradient (falling is positive), read off published German examples:
    50 m to 40 km/h, 100 m to 60 km/h, 200 m above; 10 % more for each permille falling, 5 % less for each rising."""
    base = 50.0 if speed_kmh <= 40 else 100.0 if speed_kmh <= 60 else 200.0
    share = 0.10 * falling_permille if falling_permille > 0 else 0.05 * falling_permille
    return base * max(0.0, 1.0 + share)


def stand_s(length_m: Fraction, kmh: float, halt_ms: int) -> float:
    """When an overlap may be released, by length and speed (whole seconds): a train that is wholly in a section of so
    many metres before the signal runs on through it at half the speed at least, and brakes (our choice)."""
    return float(ceil(through(length_m, kmh) + Fraction(halt_ms, 1000)))


def through(metres: Fraction, kmh: float) -> Fraction:
    """The seconds for so many metres at half of a speed."""
    return metres * Fraction(36, 5) / stated(kmh)


@of_layout
def overlap_paths(layout: Layout, signal: SignalId) -> tuple[tuple[Traversal, ...], ...]:
    """Every alternative of a signal's overlap, as ways through sections in order; empty without overlap.

    Where two alternatives of different length come together, the one that is long enough goes on as far as the other:
    nobody knows over which of them a train came that has overrun the signal.  One that is told apart does not go on.
    """
    if layout.overlaps.length.get(signal, 0.0) <= 0:
        return ()
    plain = _found(layout, signal)
    steps = frozenset((a.section, a.exit, b.section) for ways in plain for a, b in pairwise(ways))
    found = _found(layout, signal, steps, frozenset(told_apart(layout, signal)))
    return tuple(sorted(found, key=lambda ws: (_reversed(ws), [t.key for t in ws])))


Ways = tuple[Traversal, ...]


def ends_at(paths: Iterable[Ways], section: SectionId, end: NodeId) -> bool:
    """No alternative of an overlap leads on from a section over one of its ends: what has overrun the signal and stands
    wholly in that section, heading there, runs no further."""
    return all((t.section, t.exit) != (section, end) for ways in paths for t in ways[:-1])


def inside_others(layout: Layout, signal: SignalId) -> list[tuple[Ways, Ways]]:
    """Alternatives, as long as they are stated, that lie wholly within a longer one of the same signal; and that one.

    But for those that are told apart, they are held with the longer one.
    """
    plain = _found(layout, signal) if layout.overlaps.length.get(signal, 0.0) > 0 else []
    return [(a, b) for a in plain for b in plain if b[: len(a)] == a and len(b) > len(a)]


def covered(layout: Layout, signal: SignalId) -> list[tuple[Ways, Ways]]:
    """Alternatives as long as the signal's own length that are held no farther than another entry says, where that one
    fits every way; and what is held instead."""
    paths = overlap_paths(layout, signal)
    counts = [own_way(layout, signal, p) for p in paths]
    if not counts or counts[0] is None or any(w is not counts[0] for w in counts):
        return []
    own = _search(layout, signal, layout.overlaps.length[signal], frozenset(), ())
    return [(a, b) for a in own if _agrees(layout, a) for b in paths if len(b) < len(a) and a[: len(b)] == b]


@of_layout
def told_apart(layout: Layout, signal: SignalId) -> dict[Ways, int]:
    """Alternatives of a signal's overlap that lie inside longer ones and are held alone for trains that were called at
    no more than a speed (km/h): by how a train was called it is known how far it may run on.

    Each longer one is for a higher speed; no other alternative comes to the sections of the short one on another way,
    nor does a second way lead through one of them to its end: over such a way fewer metres might lead there.
    """
    plain = _found(layout, signal) if layout.overlaps.length.get(signal, 0.0) > 0 else []
    found = {}
    inside = inside_others(layout, signal)
    for a, longer in ((a, [b for x, b in inside if x == a]) for a in plain):
        kmh, others = entry_speed(layout, signal, a), [entry_speed(layout, signal, b) for b in longer]
        slowest = kmh is not None and longer and all(v is None or v > kmh for v in others)
        if kmh is not None and slowest and all(_apart_or_along(a, b) for b in plain) and not two_ways(layout, a):
            found[a] = kmh
    return found


def two_ways(layout: Layout, ways: Ways) -> tuple[SectionId, ...]:
    """The sections of an overlap through which a second way leads, from the same end to the same end."""
    topo = topology(layout)
    return tuple(t.section for t in ways if sum(u.exit == t.exit for u in topo.through(t.section, t.entry)) > 1)


def _apart_or_along(a: Ways, b: Ways) -> bool:
    """Alternative b comes to no section of a but along a, from the signal on."""
    own = {t.section for t in a}
    return all(t.section not in own or b[:i] == a[:i] for i, t in enumerate(b))


def own_way(layout: Layout, signal: SignalId, ways: Iterable[Traversal]) -> OverlapWay | None:
    """What the layout states of an alternative, if it states anything of it."""
    over = {t.section for t in ways}
    return next((w for w in layout.overlaps.ways if w.signal == signal and over.issuperset(w.over)), None)


def entry_speed(layout: Layout, signal: SignalId, ways: Iterable[Traversal]) -> int | None:
    """The highest speed (km/h) shown to a train for which an alternative of a signal's overlap is held; None: any."""
    own = own_way(layout, signal, ways)
    return dict(layout.overlaps.entry_speeds).get(signal) if own is None else own.entry


def may_be_short(layout: Layout, signal: SignalId, ways: Sequence[Traversal]) -> bool:
    """Whether an alternative may be told apart by its speed, whatever the lengths are: else none leads on where it
    ends."""
    if ways[-1].exit in layout.track.boundary_at or ways[-1].exit in layout.track.buffer_at:
        return False
    stated_apart = any(w.signal == signal for w in layout.overlaps.ways)
    return stated_apart and entry_speed(layout, signal, ways) is not None


def route_speed(layout: Layout, ways: Collection[Traversal], signal: str, overlap: Sequence[Traversal]) -> int | None:
    """The highest speed (km/h) for a route to a signal: the lowest stated along its path, or for its overlap (R11)."""
    found = [path_speed(layout, ways), entry_speed(layout, SignalId(signal), overlap) if overlap else None]
    return min((v for v in found if v is not None), default=None)


def wanted_m(layout: Layout, signal: SignalId, ways: Iterable[Traversal]) -> float:
    """The metres that are stated of an alternative; infinite for a successive route, which has no length."""
    own = own_way(layout, signal, ways)
    return layout.overlaps.length[signal] if own is None else own.length


def ends_short(layout: Layout, signal: SignalId, ways: Sequence[Traversal]) -> NodeId | None:
    """The boundary or buffer at which an alternative ends before it is as long as stated; None where it is long
    enough."""
    wanted = wanted_m(layout, signal, ways)
    return ways[-1].exit if sum(t.length for t in ways) < wanted and not isinf(wanted) else None


Steps = frozenset[tuple[SectionId, NodeId, SectionId]]


def _found(
    layout: Layout, signal: SignalId, steps: Steps = frozenset(), apart: frozenset[Ways] = frozenset()
) -> list[Ways]:
    """The alternatives, each as long as it must be; `apart`: those that do not go on with others."""
    lengths = [
        (None, layout.overlaps.length[signal]),
        *((w, w.length) for w in layout.overlaps.ways if w.signal == signal),
    ]
    return [
        ways
        for own, length in lengths
        for ways in _search(layout, signal, length, steps, {a for a in apart if own_way(layout, signal, a) is own})
        if _agrees(layout, ways) and own_way(layout, signal, ways) is own
    ]


def _search(layout: Layout, signal: SignalId, length: float, steps: Steps, apart: Collection[Ways]) -> list[Ways]:
    """Paths that are long enough and do not end where one of the steps goes on, but for those that are told apart."""
    g = layout.signalling.signal[signal]
    topo = topology(layout)
    barred: set[str] = {x for h, x in layout.overlaps.bars if h == signal}
    found: list[tuple[Traversal, ...]] = []
    counted = overlaps(signal)
    todo: list[tuple[tuple[Traversal, ...], float]] = [
        ((t,), t.length) for t in topo.through(layout.track.section_of(g.into), g.node)
    ]
    while todo:
        ways, gone = todo.pop()
        last = ways[-1]
        if not barred.isdisjoint((last.section, *last.edges)):
            counted.one()
            continue
        onward = topo.beyond(last.section, last.exit)
        enough = gone >= length or (isinf(length) and (last.exit, onward) in topo.main_into)
        if onward is None or (enough and ((last.section, last.exit, onward) not in steps or ways in apart)):
            counted.one()
            found.append(ways)
            continue
        further = topo.through(onward, last.exit) if all(w.section != onward for w in ways) else ()
        if not further:
            counted.one()
        todo.extend(((*ways, t), gone + t.length) for t in further)
    return found


def _agrees(layout: Layout, ways: tuple[Traversal, ...]) -> bool:
    wanted: dict[str, Position] = {}
    return all(wanted.setdefault(layout.pointwork.point[p].machine, x) is x for t in ways for p, x in t.points)


def _reversed(ways: tuple[Traversal, ...]) -> int:
    points: list[tuple[PointId, Position]] = [p for t in ways for p in t.points]
    return sum(x is Position.REVERSE for _, x in points)
