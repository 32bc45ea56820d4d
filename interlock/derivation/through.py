"""Trains that shall run through: signals past which the overlap of the one before reaches, and voyages whose routes
cannot be set together.

Warnings IL7014, IL7015.  Nothing is wrong about safety: a train stops where its driver would expect to run on.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from interlock.derivation.conflicts import Conflicts
from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import NodeId, SectionId, Signal, SignalId
from interlock.model.layout import Layout
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
    """Signals to which no route can be set together with one that leads on: the overlap holds what lies past the next
    main signal, too, so that routes to that one need it as overlap or as path (R4, R6)."""
    to: dict[SignalId, list[Path]] = {}
    on: dict[SignalId, int] = {}
    for p in paths:
        if p.kind is RouteKind.MAIN and p.onward is None:
            to.setdefault(SignalId(p.exit), []).append(p)
            on[p.entry] = on.get(p.entry, 0) | 1 << p.number - 1
    main = {(g.node, layout.track.section_of(g.into)): g for g in layout.signalling.signals if g.main}
    for g, those in to.items():
        past = [_passed(main, p) for p in those]
        if g not in on or None in past or any(on[g] & ~hostile.bits(p.id) for p in those):
            continue
        beyond, metres = min((x for x in past if x is not None), key=lambda x: x[1])
        sink.add(
            "IL7014",
            f"no train runs through at {g}: its overlap leads past {called('signal', beyond.id)}, so that no route "
            f"onward from {g} can be set together with {' or '.join(p.id for p in those)}; trains stop at {g} until "
            "it is released",
            None,
            f"where it may end before {beyond.id}: `overlaps: {{{g}: {{length: {metres:g}}}}}`",
            about=Element("signals", g),
        )


def _passed(main: Mapping[tuple[NodeId, SectionId], Signal], p: Path) -> tuple[Signal, float] | None:
    """The first main signal past which the overlap of a path leads, in its direction, and how many metres on."""
    metres = 0.0
    for t in p.overlap:
        if metres and (t.entry, t.section) in main:
            return main[t.entry, t.section], metres
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
