"""From where a train may come to a signal, found again edge by edge (R8)."""

from __future__ import annotations

from collections.abc import Mapping

from interlock.model.elements import BoundaryKind, EdgeId, NodeId, Position, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.principles import Caution

Been = frozenset[SectionId]
"""Sections through which the walk has come."""
Lie = Mapping[NodeId, Position]
"""How the points lie over which a train comes through a section."""


def approach_sections(layout: Layout, signal: SignalId) -> frozenset[SectionId] | None:
    """The sections of the approach; None where the signal is always approach locked."""
    g, rules = layout.signalling.signal[signal], layout.principles
    found: set[SectionId] = set()
    announces = g.main and rules.caution is not Caution.NEVER

    def speed(section: SectionId) -> float:
        """In metres a second, as fast as a train may run there."""
        row = layout.track.section.get(section)
        kmh = float(row.speed) if row is not None and row.speed is not None else rules.line_speed_kmh
        return (kmh if g.main else min(kmh, rules.shunt_speed_kmh)) / 3.6

    def unaware(section: SectionId) -> float:
        """Metres that a train runs there before its driver acts on what he is shown."""
        return speed(section) * (rules.output_delay_s + rules.reaction_s)

    def stops(section: SectionId) -> float:
        """Metres in which a train stands that runs as fast as it may here."""
        return unaware(section) + speed(section) ** 2 / (2 * rules.braking_ms2)

    def back(edge: EdgeId, node: NodeId, run: float, stop: float, told: bool, been: Been, lie: Lie) -> None:
        """Away from the signal over an edge that ends at `node`.  No train comes over it against its one way; its
        section, in which one may stand after a restart, counts all the same.  No point moves under the train."""
        e = layout.track.edge[edge]
        found.add(e.section)
        if e.one_way and e.b != node:
            return
        stop = max(stop, stops(e.section))
        at, run = layout.track.far(edge, node), run + e.length
        boundary = layout.track.boundary_at.get(at)
        onward = _onward(layout, edge, at)
        leaves = boundary is not None or any(layout.track.section_of(x) != e.section for x in onward)
        if leaves:
            if told and run >= stop:
                return
            here = not told and _tells(layout, at, edge)
            told = told or here
        if boundary is not None:
            if boundary.approach is not None and boundary.kind is not BoundaryKind.OUT:
                found.add(boundary.approach)
            return
        for x in onward:
            s = layout.track.section_of(x)
            under = _under(layout, edge, x, at, lie) if s == e.section else {}
            if under is not None and (s == e.section or s not in been):
                least = max(stop, run + unaware(s)) if leaves and here else stop
                back(x, at, run, least, told, been | {s}, under)

    boundary = layout.track.boundary_at.get(g.node)
    if boundary is not None:
        if boundary.approach is None or boundary.approach_m < stops(boundary.approach):
            return None
        return frozenset({boundary.approach})
    behind = [e.id for e in layout.track.edges_at[g.node] if e.id != g.into]
    if not behind:
        return None
    for edge in behind:
        been = frozenset({layout.track.section_of(g.into), layout.track.section_of(edge)})
        back(edge, g.node, 0.0, 0.0, not announces, been, {})
    return frozenset(found)


def _tells(layout: Layout, node: NodeId, edge: EdgeId) -> bool:
    """Whether a main signal there tells what the next one shows: not one that may be passed at identifier light."""
    g = layout.signalling.facing.get((node, edge))
    return g is not None and g.main and g.id not in layout.signalling.identifiers


def _under(layout: Layout, edge: EdgeId, other: EdgeId, node: NodeId, lie: Lie) -> Lie | None:
    """How points lie under a train that has come from one edge to another; None where it came over this one before, in
    its other position."""
    point = layout.pointwork.point_at.get(node)
    if point is None:
        return lie
    position = Position.NORMAL if point.normal in (edge, other) else Position.REVERSE
    return {**lie, node: position} if lie.get(node, position) is position else None


def _onward(layout: Layout, edge: EdgeId, node: NodeId) -> list[EdgeId]:
    """The edges over which a train can have come to `node` that goes on over `edge`."""
    point, crossing = layout.pointwork.point_at.get(node), layout.pointwork.crossing_at.get(node)
    if point is not None:
        return [point.toe] if edge in (point.normal, point.reverse) else [point.normal, point.reverse]
    if crossing is not None:
        return [b if edge == a else a for a, b in crossing.arms if edge in (a, b)]
    return [x.id for x in layout.track.edges_at[node] if x.id != edge]
