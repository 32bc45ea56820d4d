"""The signalling: what stands beside the track and speaks to drivers, what it asks from outside, and overlaps."""

from __future__ import annotations

from functools import cached_property

from interlock.dataclass import dataclass
from interlock.model.elements import (
    Condition,
    Device,
    Distant,
    EdgeId,
    NodeId,
    Overlap,
    OverlapWay,
    SectionId,
    Signal,
    SignalId,
)
from interlock.model.facts import Facts


@dataclass(frozen=True, eq=False)
class Signalling(Facts):
    """Signals and boards, and what else is interlocked with them: devices, and conditions from outside."""

    signals: tuple[Signal, ...]
    distants: tuple[Distant, ...] = ()
    boards: tuple[SignalId, ...] = ()
    """Boards without lamps, of the kind of signal whose routes end there; no route begins at one."""
    stops: tuple[SignalId, ...] = ()
    """Where train routes end and none begins: stop boards, and shunt signals that the author says so of."""
    identifiers: tuple[SignalId, ...] = ()
    """Main signals that a longer route can pass: they show an identifier light meanwhile."""
    conditions: tuple[Condition, ...] = ()
    devices: tuple[Device, ...] = ()
    releases: tuple[tuple[SignalId, float], ...] = ()
    """Seconds for which the routes of a signal are held after a cancellation, where it has a time of its own."""

    @cached_property
    def signal(self) -> dict[SignalId, Signal]:
        """Signals by id."""
        return {s.id: s for s in self.signals}

    @cached_property
    def facing(self) -> dict[tuple[NodeId, EdgeId], Signal]:
        """The signal that a vehicle meets at a node before it goes onto an edge."""
        return {(g.node, g.into): g for g in self.signals}

    def opens(self, signal: SignalId, shunt: bool) -> bool:
        """Whether routes for trains, or for shunting movements, may begin at a signal."""
        return signal not in self.boards and (shunt or signal not in self.stops)


@dataclass(frozen=True, eq=False)
class Overlaps(Facts):
    """The overlaps beyond main signals (R4): stated, or as the principle says."""

    all: tuple[Overlap, ...] = ()
    ways: tuple[OverlapWay, ...] = ()
    """Alternatives with values of their own; of several that fit, the first counts."""
    bars: tuple[tuple[SignalId, SectionId | EdgeId], ...] = ()
    """Sections and edges over which no alternative of a signal's overlap leads, as the author chose."""
    entry_speeds: tuple[tuple[SignalId, int], ...] = ()
    """Signals with an overlap that is made for a speed (km/h): no train to it is shown more, but where its alternative
    has a speed of its own."""
    releases: tuple[tuple[SignalId, float], ...] = ()
    """Seconds after which the overlap of a signal is released, where it has a time of its own."""

    @cached_property
    def length(self) -> dict[SignalId, float]:
        """Metres of overlap beyond each main signal that has one."""
        return {o.signal: o.length for o in self.all}
