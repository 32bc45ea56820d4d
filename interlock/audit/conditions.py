"""What routes ask for from outside, from the audit's own paths: conditions, directions of lines, zones (R12, R17)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from interlock.audit.walk import Trip, in_rear
from interlock.model.elements import SectionId, SignalId
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable, RouteRow

_Swung = Mapping[tuple[SignalId, int], set[SectionId]]
"""The sections of each alternative of an overlap: of a signal, by its number."""


def conditions(layout: Layout, table: InterlockingTable, matched: Mapping[str, Trip]) -> Iterator[tuple[str, str, str]]:
    """Route, column and text where a route asks for something else than its path and its overlaps do."""
    rows = [r for r in table.routes if r.id in matched]
    swung = {
        (r.locking.overlap.signal, r.locking.overlap.option): _beyond(layout, matched[r.id])
        for r in rows
        if r.locking.overlap is not None
    }
    for r in rows:
        yield from ((r.id, *x) for x in _row(layout, r, matched[r.id], swung))


def _beyond(layout: Layout, trip: Trip) -> set[SectionId]:
    return {layout.track.section_of(m.edge) for m in trip.over}


def _row(layout: Layout, r: RouteRow, trip: Trip, swung: _Swung) -> Iterator[tuple[str, str]]:
    out = {
        b.node
        for b in layout.track.boundaries
        if b.block == "token" and b.node == trip.moves[-1].node and not trip.shunt
    }
    if ({r.conditions.token.boundary} if r.conditions.token else set()) != out:
        yield "token", f"the direction is needed at {', '.join(out) or 'no boundary'}"
    over = [next(iter(in_rear(layout, trip)), None), *trip.run.sections]
    into = {
        z.id: sum(a not in z.sections and b in z.sections for a, b in pairwise(over)) for z in layout.declared.zones
    }
    if {c.zone: c.entries for c in r.conditions.zones} != {z: n for z, n in into.items() if n}:
        yield "zones", f"leads into {', '.join(z for z, n in into.items() if n) or 'none'}"
    leaves = None if trip.shunt else trip.moves[-1].node
    reached = {*trip.sections, *_beyond(layout, trip)}  # by a train that may overrun as far as its overlap, or one to
    if r.locking.overlap is not None:  # which that swings
        options = (swung.get((r.locking.overlap.signal, k), set()) for k in r.locking.overlap.swings)
        reached.update(s for those in options for s in those)
    needed = {
        c.id for c in layout.signalling.conditions if r.entry in c.signals or set(c.over) & reached or leaves in c.exits
    }
    if {c.condition for c in r.conditions.external} != needed:
        yield "conditions", f"required are {', '.join(sorted(needed)) or 'none'}"
