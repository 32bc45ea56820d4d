"""Trains that shall run through: signals past which the overlap of the one before reaches, and voyages whose routes
cannot be set together.

Warnings IL7014, IL7015.  Nothing is wrong about safety: a train stops where its driver would expect to run on.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations
from math import inf

from interlock.dataclass import dataclass
from interlock.derivation.conflicts import Conflicts
from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import NodeId, OverlapWay, SectionId, Signal, SignalId
from interlock.model.layout import Layout
from interlock.model.overlap import entry_speed, overlap_length, own_way, route_speed, two_ways, wanted_m
from interlock.table.cells import RouteKind
from interlock.table.rows import VoyageRow


def check_through(
    layout: Layout, paths: Sequence[Path], hostile: Conflicts, voyages: Sequence[VoyageRow], sink: Sink
) -> None:
    """Report where no train can run through, where no error hides routes."""
    if not sink.has_errors:
        _check_overlaps(layout, paths, hostile, sink)
        _check_voyages(paths, hostile, voyages, sink)


def _check_overlaps(layout: Layout, paths: Sequence[Path], hostile: Conflicts, sink: Sink) -> None:
    """Signals whose overlap holds what lies past the next main signal, too, where routes to or from that one need it as
    overlap or as path (R4, R6): to which no route can be set together with one that leads on; or from which a train
    runs on to the next signal and stands there in that overlap, which is held until it is wholly in the last section
    of it, or has left it."""
    to: dict[SignalId, list[Path]] = {}
    on: dict[SignalId, list[Path]] = {}
    for p in paths:
        if p.kind is RouteKind.MAIN and p.onward is None:
            to.setdefault(SignalId(p.exit), []).append(p)
            on.setdefault(p.entry, []).append(p)
    main = {(g.node, layout.track.section_of(g.into)): g for g in layout.signalling.signals if g.main}
    for g, those in to.items():
        past = [(p, x) for p in those if (x := _passed(main, p)) is not None]
        if g not in on or len(past) < len(those):
            continue
        barred = [hostile.bits(p.id) for p in those]
        both = [(b, q) for b in barred for q in on[g] if not b >> q.number - 1 & 1]
        ahead = [(b, on.get(SignalId(q.exit), [])) for b, q in both]
        if any(not rs or any(not b >> r.number - 1 & 1 for r in rs) for b, rs in ahead):
            continue
        beyond = min((x for _, x in past), key=lambda x: x.metres).signal
        why = f"no route onward from {g} can be set together with {' or '.join(p.id for p in those)}"
        if both:
            ends = " or ".join(dict.fromkeys(q.exit for _, q in both))
            why = f"a train that runs on to {ends} stands in it there, where it is held, and no route onward can be set"
        sink.add(
            "IL7014",
            f"no train runs through at {g}: its overlap leads past {called('signal', beyond.id)}, so that {why}; "
            f"trains {'must ' if both else ''}stop at {g} until it is released",
            None,
            f"where it may end before {beyond.id}: {_shorter(layout, g, past)}",
            about=Element("signals", g),
        )


@dataclass(frozen=True)
class _Past:
    """The first main signal past which an overlap leads: how many metres on, and the section into which it leads."""

    signal: Signal
    metres: float
    into: SectionId


def _shorter(layout: Layout, g: SignalId, past: Sequence[tuple[Path, _Past]]) -> str:
    """What to write for an overlap that ends before the next signal: for all trains, or for those that are shown no
    more than such an overlap is long enough for, beside the long one."""
    least: dict[OverlapWay | None, float] = {}
    for p, x in past:
        own = own_way(layout, g, p.overlap)
        least[own] = min(x.metres, least.get(own, inf))
    said = [f"`overlaps: {{{g}: {{length: {_down(least[None])}}}}}`"] if None in least else []
    said += [f"`length: {_down(m)}` in `ways` over {', '.join(w.over)}" for w, m in least.items() if w is not None]
    written = " and ".join(said) + (", without its `not_over`" if g in (x for x, _ in layout.overlaps.bars) else "")
    (p, x), *others = past
    kmh = max((v for v in (40, 60) if overlap_length(v, 0) <= x.metres), default=None)
    if others or None not in least or kmh is None or entry_speed(layout, g, p.overlap) is not None:
        return written
    usual = route_speed(layout, p.ways, g, p.overlap) or layout.principles.line_speed_kmh
    if usual <= kmh or two_ways(layout, p.overlap):
        return written
    inside = f"length: {_down(x.metres)}, entry_speed: {kmh}"
    longer = f"ways: [{{over: [{x.into}], length: {wanted_m(layout, g, p.overlap):g}}}]"
    return f"{written}; where it may for slow trains alone: `overlaps: {{{g}: {{{inside}, {longer}}}}}`"


def _down(metres: float) -> str:
    """Metres that are no more when they are read again: a millimetre more would lead past the next signal."""
    written = round(metres, 3) if round(metres, 3) <= metres else round(metres, 3) - 0.001
    return f"{written:.3f}".rstrip("0").rstrip(".")


def _passed(main: Mapping[tuple[NodeId, SectionId], Signal], p: Path) -> _Past | None:
    """The first main signal past which the overlap of a path leads, in its direction."""
    metres = 0.0
    for t in p.overlap:
        if metres and (t.entry, t.section) in main:
            return _Past(main[t.entry, t.section], metres, t.section)
        metres += t.length
    return None


def _check_voyages(paths: Sequence[Path], hostile: Conflicts, voyages: Sequence[VoyageRow], sink: Sink) -> None:
    """Voyages whose routes are all set before their train goes, and two of which cannot be (R18)."""
    bit = {p.id: 1 << p.number - 1 for p in paths}
    for v in voyages:
        for a, b in combinations(v.routes, 2) if v.far_first else ():
            if hostile.bits(a) & bit[b]:
                sink.add(
                    "IL7015",
                    f"voyage {v.name} is never set: with `order: far` all of its routes are set before its train goes, "
                    f"and {a} is hostile to {b} ({hostile.tell(a, b).witness})",
                    None,
                    "say `order: near`, or change what makes the two hostile",
                    about=Element("voyages", v.name),
                )
                break
