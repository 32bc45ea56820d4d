"""What a signal has beside its main lamp (R11): a second yellow lamp, a route indicator, a speed indicator."""

from __future__ import annotations

from enum import StrEnum

from interlock.derivation.locking import derive_aspect, derive_speed
from interlock.derivation.routes import find_routes
from interlock.diag import Sink
from interlock.model.elements import SignalId
from interlock.model.layout import Layout, of_layout
from interlock.model.principles import Caution
from interlock.table.cells import RouteKind, Shows


class Beside(StrEnum):
    """A unit of a signal beside its main lamp."""

    SECOND = "second"
    INDICATOR = "indicator"
    SPEED = "speed"


@of_layout
def beside_main(layout: Layout) -> dict[SignalId, tuple[Beside, ...]]:
    """By signal the units that a train route from it lights: second yellow lamp (UU), route indicator (B), speed
    indicator, which shows each speed that a route of the signal has."""
    indicated = any(b.indicator for b in layout.track.boundaries)
    if layout.principles.caution is not Caution.TURNOUT and not indicated and not _stated(layout):
        return {}
    found: dict[SignalId, set[Beside]] = {}
    for path in find_routes(layout, Sink()):
        aspect = derive_aspect(layout, path)
        if aspect.shows is Shows.TWO_YELLOWS:
            found.setdefault(path.entry, set()).add(Beside.SECOND)
        if aspect.indicator:
            found.setdefault(path.entry, set()).add(Beside.INDICATOR)
        if path.kind is RouteKind.MAIN and derive_speed(layout, path).kmh is not None:
            found.setdefault(path.entry, set()).add(Beside.SPEED)
    return {g: tuple(u for u in Beside if u in units) for g, units in found.items()}


def _stated(layout: Layout) -> bool:
    """Whether the layout states any speed: of a section, over a reverse leg, or for an overlap."""
    track = (*(s.speed for s in layout.track.sections), *(p.speed for p in layout.pointwork.points))
    overlaps = (*(kmh for _, kmh in layout.overlaps.entry_speeds), *(w.entry for w in layout.overlaps.ways))
    return any(v is not None for v in (*track, *overlaps))
