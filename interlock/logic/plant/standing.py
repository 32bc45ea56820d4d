"""What stands where, and what comes in where: words for movements, next states, images and hazards."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from interlock.logic import names
from interlock.logic.expr import FALSE, Expr, conj, disj, neg
from interlock.logic.plant.kinds import Events
from interlock.logic.plant.words import accepted, across, came, lies, overran, parted, rests, was_called
from interlock.model.elements import NodeId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import Topology, Traversal


def functions(layout: Layout, g: SignalId) -> list[bool]:
    """Whom a signal speaks to: False for trains, True for shunting movements."""
    signal = layout.signalling.signal[g]
    return [*([False] if signal.main else []), *([True] if signal.shunt else [])]


def across_end(layout: Layout, topo: Topology, s: SectionId, j: NodeId) -> str:
    """What lies across an end: a section, an approach section, or outside."""
    ahead = topo.beyond(s, j)
    if ahead is not None:
        return ahead
    boundary = layout.track.boundary_at.get(j)
    return (boundary.approach if boundary and boundary.approach else None) or names.outside(j)


class Standing:
    """What stands in each section: where it is heading, whether somebody has called it."""

    def __init__(self, layout: Layout, topo: Topology, overlapped: Mapping[SectionId, Sequence[SignalId]]) -> None:
        """`overlapped`: the signals of which the overlap lies over a section."""
        self._layout, self._topo, self._overlapped = layout, topo, overlapped

    def lie(self, t: Traversal) -> Expr:
        """Every point on the way really lies for it."""
        return conj(lies(self._layout.pointwork.point[p].machine, x) for p, x in t.points)

    def ways(self, s: SectionId, a: NodeId, b: NodeId | None = None) -> list[Traversal]:
        """Traversals from an end, to an end if given."""
        return [t for t in self._topo.through(s, a) if b is None or t.exit == b]

    def heading(self, s: SectionId, b: NodeId) -> Expr:
        """The train in s is heading to its end b, as the points lie."""
        return disj(conj((came(s, a), self.lie(t))) for a in self._topo.ends[s] for t in self.ways(s, a, b))

    def stood(self, s: SectionId, b: NodeId) -> Expr:
        """A train has stood in s since the restart, so that it could go to b, whatever lies under it."""
        return conj((rests(s), disj(came(s, a) for a in self._topo.ends[s] if self.ways(s, a, b))))

    def calls(self, s: SectionId) -> Iterator[tuple[NodeId, Expr]]:
        """For each signal that governs leaving s: its joint, and whether somebody has accepted it."""
        for g in self._topo.signals_out(s):
            yield self._layout.signalling.signal[g].node, disj(accepted(g, k) for k in functions(self._layout, g))

    def called(self, s: SectionId) -> Expr:
        """What stands in s has accepted a signal."""
        return disj(x for _, x in self.calls(s))

    def moves(self, s: SectionId) -> Expr:
        """What stands in s has been called by a signal, or is a part of a train that has."""
        return disj((self.called(s), FALSE if self.berth(s) else was_called(s)))

    def drawn(self, s: SectionId) -> Iterator[Expr]:
        """What stands in s stands across an end, too, and the part beyond it moves."""
        for j in self._topo.ends[s]:
            ahead = None if j in self._layout.track.buffer_at else self._topo.beyond(s, j)
            if ahead is not None:
                came_on = FALSE if self.berth(ahead) else neg(rests(ahead))  # in a berth others may have
                yield conj((across(j, s), disj((came_on, self.moves(ahead)))))

    def parted(self, s: SectionId) -> Expr:
        """What stands in s is the rear part of a train that was left there; in a berth any vehicles may be."""
        return FALSE if self.berth(s) else parted(s)

    def berth(self, s: str) -> bool:
        """Vehicles may stand there in any number."""
        return s in self._topo.berths

    def astray(self, s: SectionId) -> Expr:
        """What stands in s has overrun some signal."""
        return disj(overran(g, s) for g in self._overlapped.get(s, ()))

    def coming(self, s: SectionId, j: NodeId) -> Expr:
        """A train stands across j on its way into s."""
        boundary = self._layout.track.boundary_at.get(j)
        if j in self._layout.track.buffer_at or (boundary is not None and (j, s) not in self._topo.signal_into):
            return FALSE
        return across(j, across_end(self._layout, self._topo, s, j))


class Entries:
    """What comes into each section in this step, as the events say."""

    def __init__(
        self, layout: Layout, topo: Topology, overlapped: Mapping[SectionId, Sequence[SignalId]], events: Events
    ) -> None:
        self._layout, self._topo, self._overlapped, self._events = layout, topo, overlapped, events

    def comes_in(self, s: SectionId, j: NodeId) -> Expr:
        """A head comes into s at j in this step."""
        if j in self._layout.track.buffer_at:
            return FALSE
        return self._events.get(names.HEAD(j, across_end(self._layout, self._topo, s, j)), FALSE)

    def shunts_in(self, s: SectionId, j: NodeId) -> Expr:
        """A shunting movement comes into s at j in this step."""
        if j in self._layout.track.buffer_at:
            return FALSE
        return self._events.get(names.SHUNTS(j, across_end(self._layout, self._topo, s, j)), FALSE)

    def overruns_in(self, g: SignalId, s: SectionId) -> Expr:
        """A train that has overrun g comes into s in this step."""
        ends = [j for j in self._topo.ends[s] if j not in self._layout.track.buffer_at]
        return disj(
            self._events.get(names.OVERRUNS(g, j, across_end(self._layout, self._topo, s, j)), FALSE) for j in ends
        )

    def overrun_over(self, s: SectionId, j: NodeId) -> Expr:
        """What comes into s at j in this step has overrun a signal."""
        return disj(
            self._events.get(names.OVERRUNS(g, j, across_end(self._layout, self._topo, s, j)), FALSE)
            for g in self._overlapped.get(s, ())
            if j not in self._layout.track.buffer_at
        )

    def turns(self, s: SectionId) -> Expr:
        """The train in a section changes direction."""
        ends, events = self._topo.ends[s], self._events
        return disj(events[e] for a in ends for b in ends if (e := names.TURNS(s, a, b)) in events)
