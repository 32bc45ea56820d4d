"""Overlaps as the audit finds them: edge by edge beyond the signal at which a trip ends (R4)."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from dataclasses import replace

from interlock.audit.walk import Lying, Move, Trip, in_rear, onward, signal_facing, steps
from interlock.model.elements import NodeId, OverlapWay, SectionId, Signal, SignalId
from interlock.model.layout import Layout, of_layout


def overruns(layout: Layout, trip: Trip) -> list[Trip]:
    """A train's trip with each overlap beyond its exit signal, as far as the trip itself permits."""
    g = layout.signalling.signal.get(trip.exit)  # type: ignore[call-overload]
    length = layout.overlaps.length.get(g.id, 0.0) if g is not None else 0.0
    if g is None or trip.shunt or length <= 0:
        return [trip]
    plain = _alone(layout, g)
    joined = frozenset(
        (a.node, layout.track.section_of(b.edge))
        for path in plain
        for a, b in itertools.pairwise(path.over)
        if layout.track.section_of(a.edge) != layout.track.section_of(b.edge)
    )
    inside = frozenset(short(layout, g.id))
    return [
        path
        for way, metres in _stated(layout, g)
        for path in _overruns(layout, g, trip, metres, joined, inside, checked=True)
        if overlap_way(layout, path) is way
    ]


def onward_over(layout: Layout, trip: Trip) -> dict[str, frozenset[Move]]:
    """The moves of a trip's overlap that trains may run over while it is held, by the signal from which they come: from
    the trip's own end all of them, from a main signal that it meets further on those that follow.  What stands before
    such a signal is within the overlap, and has come over it.  An overlap that swings may leave it."""
    if not trip.over:
        return {}
    found = {trip.exit: frozenset(trip.over)}
    for i, m in enumerate(trip.over[1:], 1):
        g = signal_facing(layout, trip.over[i - 1].node, m.edge)
        if g is not None and g.main and not swings(layout, trip.exit):
            found[g.id] = frozenset(trip.over[i:])
    return found


def swings(layout: Layout, signal: str) -> bool:
    """Whether another alternative may take the place of a signal's overlap."""
    return any(o.signal == signal and o.swing for o in layout.overlaps.all)


def without_speed(layout: Layout, found: Iterable[Trip]) -> list[Trip]:
    """The trips for which a train may be called that is told no speed: none that has a short overlap."""
    return [t for t in found if not t.over or t.over not in short(layout, SignalId(t.exit))]


@of_layout
def short(layout: Layout, signal: SignalId) -> dict[tuple[Move, ...], int]:
    """Overlaps that lie inside longer ones of the same signal and count for trains that were shown no more than a
    speed (km/h), which is lower than that of any longer one.  A train that has run to where one ends has run over all
    of it: from nowhere else does an overlap of the signal lead onto its sections."""
    plain = _alone(layout, layout.signalling.signal[signal])
    found = {}
    for a in plain:
        longer = [b for b in plain if len(b.over) > len(a.over) and b.over[: len(a.over)] == a.over]
        kmh, others = overlap_speed(layout, a), [overlap_speed(layout, b) for b in longer]
        if kmh is None or not longer or any(v is not None and v <= kmh for v in others):
            continue
        first = _first_moves(layout, a)
        along = all(_along(a, b, first, _first_moves(layout, b)) for b in plain)
        if along and all(_passages(layout, a.over, s) == 1 for s in first):
            found[a.over] = kmh
    return found


def _passages(layout: Layout, over: tuple[Move, ...], section: SectionId) -> int:
    """In how many ways a vehicle can run through a section, from where moves come into it to where they leave it."""
    inside = [m for m in over if layout.track.section_of(m.edge) == section]
    todo: list[tuple[Move, ...]] = [(inside[0],)]
    found = 0
    while todo:
        moves = todo.pop()
        found += moves[-1].node == inside[-1].node
        within = (m for m, _ in steps(layout, moves[-1]) if layout.track.section_of(m.edge) == section)
        todo += [(*moves, m) for m in within if all(m.edge != x.edge for x in moves)]
    return found


def _along(a: Trip, b: Trip, in_a: Mapping[SectionId, int], in_b: Mapping[SectionId, int]) -> bool:
    """Overlap b comes into the sections of a on the way on which a does."""
    return all(b.over[:i] == a.over[: in_a[s]] for s, i in in_b.items() if s in in_a)


def _first_moves(layout: Layout, trip: Trip) -> dict[SectionId, int]:
    """Where an overlap comes into each of its sections."""
    found: dict[SectionId, int] = {}
    for i, m in enumerate(trip.over):
        found.setdefault(layout.track.section_of(m.edge), i)
    return found


def _stated(layout: Layout, g: Signal) -> list[tuple[OverlapWay | None, float]]:
    """How long the overlap of a signal is, and that of alternatives with a length of their own."""
    own = [(w, w.length) for w in layout.overlaps.ways if w.signal == g.id]
    return [(None, layout.overlaps.length[g.id]), *own]


def _alone(layout: Layout, g: Signal) -> list[Trip]:
    """Every overlap of a signal as long as it is stated, whatever train comes."""
    free = Trip("", g.id, False, None, (), (), ())
    return [
        path
        for way, metres in _stated(layout, g)
        for path in _overruns(layout, g, free, metres, frozenset(), frozenset(), checked=False)
        if overlap_way(layout, path) is way
    ]


def overlap_speed(layout: Layout, trip: Trip) -> int | None:
    """The speed (km/h) for which the overlap of a trip is made, if for one."""
    own = overlap_way(layout, trip)
    return own.entry if own is not None else next((v for g, v in layout.overlaps.entry_speeds if g == trip.exit), None)


def overlap_way(layout: Layout, trip: Trip) -> OverlapWay | None:
    """What the layout states of the overlap of a trip alone, if anything: the first entry whose sections it passes."""
    passed = {layout.track.section_of(m.edge) for m in trip.over}
    return next((w for w in layout.overlaps.ways if w.signal == trip.exit and passed >= set(w.over)), None)


def _overruns(
    layout: Layout,
    g: Signal,
    trip: Trip,
    length: float,
    joined: frozenset[tuple[NodeId, SectionId]],
    inside: frozenset[tuple[Move, ...]],
    checked: bool,
) -> list[Trip]:
    """Long enough paths beyond the signal that do not end where another one goes on from section to section, but for
    those inside longer ones that count by themselves."""
    e = layout.track.edge[g.into]
    found: list[Trip] = []
    start = Move(g.into, e.b if e.a == g.node else e.a)
    todo: list[tuple[tuple[Move, ...], Lying, float]] = [((start,), (), e.length)]
    while todo:
        moves, positions, gone = todo.pop()
        here = moves[-1]
        section = layout.track.section_of(here.edge)
        if (g.id, section) in layout.overlaps.bars or (g.id, here.edge) in layout.overlaps.bars:
            continue
        if here.node in layout.track.buffer_at and layout.track.buffer_at[here.node].kind == "derail":
            continue
        others = {layout.track.section_of(m.edge) for m, _ in steps(layout, here)} - {section}
        goes_on = any((here.node, s) in joined for s in others)
        goes_on &= not (moves in inside and gone >= _length_of(layout, trip, moves))
        ends = here.node in layout.track.boundary_at or here.node in layout.track.buffer_at
        if ends or (_suffices(layout, here, gone, length) and not goes_on):
            if _fits(layout, trip, moves, positions, checked):
                found.append(replace(trip, over=moves, over_positions=tuple(sorted(dict(positions).items()))))
            continue
        todo += (
            (on, (*positions, x) if x else positions, gone + layout.track.edge[on[-1].edge].length)
            for on, x in onward(layout, moves)
        )
    return found


def _suffices(layout: Layout, here: Move, gone: float, length: float) -> bool:
    """Whether an overlap that has come so far may end: at a joint, were it one over which no train goes on, after the
    metres that are asked for, or, of a successive route (infinite), before a signal for trains."""
    section = layout.track.section_of(here.edge)
    beside = () if here.node in layout.pointwork.crossing_at else layout.track.edges_at[here.node]
    if all(layout.track.section_of(e.id) == section for e in beside):
        return False
    ahead = (signal_facing(layout, here.node, m.edge) for m, _ in steps(layout, here))
    return gone >= length or (length == float("inf") and any(g is not None and g.kind != "shunt" for g in ahead))


def _fits(layout: Layout, trip: Trip, moves: tuple[Move, ...], positions: Lying, checked: bool) -> bool:
    """Whether a train on the trip may overrun over these moves: no machine lies in two positions, no diamond is met
    twice, and no section of the trip, or in rear of it, again; of what is `checked`, nothing by hand in reverse and
    nothing without detection."""
    lying = dict(trip.positions)
    clash = any(lying.setdefault(m, x) is not x for m, x in positions)
    over = {layout.track.section_of(m.edge) for m in moves}
    if checked:
        clash = clash or any(lying.get(m) == "R" for m in layout.machines.by_hand)
        clash = clash or bool(over & layout.track.undetected)
    diamonds = [m.node for m in (*trip.moves, *moves) if m.node in layout.pointwork.crossing_at]
    barred = {*trip.sections, *(in_rear(layout, trip) if trip.moves else ())}
    return not clash and not over & barred and len(diamonds) == len(set(diamonds))


def _length_of(layout: Layout, trip: Trip, moves: tuple[Move, ...]) -> float:
    """The metres asked of the overlap over some moves."""
    own = overlap_way(layout, replace(trip, over=moves))
    return layout.overlaps.length[SignalId(trip.exit)] if own is None else own.length
