"""What an open signal shows for a trip, found again (R11)."""

from __future__ import annotations

from itertools import pairwise

from interlock.audit.walk import Trip
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.model.principles import Caution
from interlock.table.cells import Shows


def aspect(layout: Layout, trip: Trip, slowest: int | None) -> tuple[Shows, SignalId | None]:
    """What the open signal shows: the last track of the trip and the signal at its end decide."""
    rule = layout.principles.caution
    if trip.call_on:
        return Shows.CALL_ON, None
    if trip.identifier:
        return Shows.IDENTIFIER, None
    if trip.shunt:
        return Shows.SHUNT, None
    if rule is Caution.TURNOUT and _two_yellows(layout, trip):
        return Shows.TWO_YELLOWS, None
    if rule is not Caution.NEVER and slowest is not None and slowest < layout.principles.slow_below_kmh:
        return Shows.CAUTION, None
    trip = trip.run
    last = trip.moves[-1]
    out = layout.track.boundary_at.get(last.node)
    if rule is Caution.NEVER or (out is not None and (out.approach is not None or out.block != "none")):
        return Shows.CLEAR, None
    onward = [e.id for e in layout.track.edges_at[last.node] if e.id != last.edge]
    facing = [layout.signalling.facing.get((last.node, e)) for e in onward]
    ahead = [g for g in facing if g is not None and g.kind != "shunt"]
    if not ahead or ahead[0].id in layout.signalling.stops:
        return Shows.CAUTION, None
    return Shows.NEXT, ahead[0].id


def route_indicator(layout: Layout, trip: Trip) -> bool:
    """Whether the signal lights its route indicator for the trip."""
    out = layout.track.boundary_at.get(trip.run.moves[-1].node)
    return out is not None and out.indicator and not (trip.call_on or trip.identifier or trip.shunt)


def _two_yellows(layout: Layout, trip: Trip) -> bool:
    """Whether the trip leads over a reversed point and not out onto a line that is checked, or does so before the last
    signal that it passes."""
    *before, last = trip.parts
    out = layout.track.boundary_at.get(last.moves[-1].node)
    departs = out is not None and (out.approach is not None or out.block != "none")
    return any(_reversed(layout, t) for t in before) or (_reversed(layout, last) and not departs)


def _reversed(layout: Layout, trip: Trip) -> bool:
    """Whether the trip passes some point over its reverse leg."""
    passed = [(layout.pointwork.point_at.get(a.node), a.edge, b.edge) for a, b in pairwise(trip.moves)]
    return any(p is not None and p.reverse in edges for p, *edges in passed)
