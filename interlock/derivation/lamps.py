"""What a signal has beside its main lamp that tells of a turnout: a second yellow lamp, a route indicator (R11)."""

from __future__ import annotations

from enum import StrEnum

from interlock.derivation.locking import derive_aspect
from interlock.derivation.routes import find_routes
from interlock.diag import Sink
from interlock.model.elements import SignalId
from interlock.model.layout import Layout, of_layout
from interlock.model.principles import Caution
from interlock.table.cells import Shows


class Beside(StrEnum):
    """A unit of a signal beside its main lamp."""

    SECOND = "second"
    INDICATOR = "indicator"


@of_layout
def beside_main(layout: Layout) -> dict[SignalId, tuple[Beside, ...]]:
    """By signal the units that a train route from it lights: second yellow lamp (UU), route indicator (B)."""
    indicated = any(b.indicator for b in layout.track.boundaries)
    if layout.principles.caution is not Caution.TURNOUT and not indicated:
        return {}
    found: dict[SignalId, set[Beside]] = {}
    for path in find_routes(layout, Sink()):
        aspect = derive_aspect(layout, path)
        if aspect.shows is Shows.TWO_YELLOWS:
            found.setdefault(path.entry, set()).add(Beside.SECOND)
        if aspect.indicator:
            found.setdefault(path.entry, set()).add(Beside.INDICATOR)
    return {g: tuple(u for u in Beside if u in units) for g, units in found.items()}
