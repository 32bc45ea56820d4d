"""All that a proof reads of a railway's lengths: overlaps, foul joints, approaches, and what protects a flank.

Everything else is made from the layout without lengths: two layouts that differ in lengths alone, and of which the same
is told here, have the same plant, and the same is claimed of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from interlock.dataclass import dataclass
from interlock.model.approach import approach
from interlock.model.elements import BoundaryKind, BufferKind, EdgeId, MachineId, NodeId, Position, SectionId, SignalId
from interlock.model.foul import CrossedSection, FoulBeside, FoulJoint, crossed_sections, foul_beside, foul_joints
from interlock.model.layout import Layout
from interlock.model.needs import Needs, needs
from interlock.model.overlap import overlap_paths, told_apart
from interlock.model.places import Approach
from interlock.model.traversal import runaways


@dataclass(frozen=True, slots=True)
class Beyond:
    """The track over one edge away from a point or a crossing, and what lies beyond it, up to what stops a vehicle.

    one_way: no vehicle comes over the edge towards the place.  closed: a buffer, or where the search has been before.
    signal: the next signal that a vehicle towards the place meets, far enough away to stand behind it.  boundary: the
    kind of the boundary at the far end.  trailed: a machine, and where it must lie for a vehicle to come from `onward`.
    spur: the end of a track, a ring, or a boundary, behind a derailer or an inclined lane: it stands for the vehicles
    that are left there, by whatever way, and for those that run back over the lane.  lane: an inclined one on which
    vehicles may stand: not in the section of the way that is protected, nor across a diamond, nor before a trap.
    """

    section: SectionId
    one_way: bool = False
    closed: bool = False
    signal: SignalId | None = None
    boundary: BoundaryKind | None = None
    trailed: tuple[MachineId, Position] | None = None
    onward: tuple[Beyond, ...] = ()
    spur: bool = False
    lane: bool = False


@dataclass(frozen=True, slots=True)
class Measured:
    """overlaps: for each signal that has one the alternatives, as ways through sections by number.  apart: by number
    from 1, those that lie inside longer ones and are told apart from them by a speed (km/h).  fouls: the foul joints,
    without distances.  crossed: the sections across diamonds.  beside: those that are foul of each other beside a point
    or diamond.  needs: the times that the world needs.  beyond: what lies over an edge away from a node, for legs of
    points and arms of crossings.  approaches: from where a train may come to each signal."""

    overlaps: Mapping[SignalId, tuple[tuple[tuple[SectionId, int], ...], ...]]
    apart: Mapping[SignalId, Mapping[int, int]]
    fouls: tuple[FoulJoint, ...]
    crossed: tuple[CrossedSection, ...]
    beside: tuple[FoulBeside, ...]
    needs: Needs
    beyond: Mapping[tuple[NodeId, EdgeId], Beyond]
    approaches: Mapping[SignalId, Approach]


def measured(layout: Layout) -> Measured:
    """What a proof reads of a layout's lengths."""
    margin = layout.principles.clearance_m
    track = layout.track
    starts = [
        (p.node, e, _From(p.fouling + margin, frozenset({track.section_of(p.toe)})))
        for p in layout.pointwork.points
        for e in (p.normal, p.reverse)
    ]
    starts += [
        (c.node, e, _From(c.fouling + margin, frozenset(track.section_of(a[0]) for a in c.arms)))
        for c in layout.pointwork.crossings
        for arm in c.arms
        for e in arm
    ]
    beyond = {(node, edge): _beyond(layout, start, edge, node, 0.0, frozenset({node})) for node, edge, start in starts}
    overlaps = {
        g.id: tuple(tuple(t.key for t in ways) for ways in paths)
        for g in layout.signalling.signals
        if (paths := overlap_paths(layout, g.id))
    }
    apart = {
        g: {k: kmh for k, ways in enumerate(overlap_paths(layout, g), 1) if (kmh := known.get(ways)) is not None}
        for g in overlaps
        if (known := told_apart(layout, g))
    }
    fouls = tuple(replace(f, distance=0.0, needed=0.0, near=None) for f in foul_joints(layout))
    approaches = {g.id: approach(layout, g.id) for g in layout.signalling.signals}
    return Measured(
        overlaps,
        apart,
        fouls,
        tuple(dict.fromkeys(replace(x, distance=0.0, needed=0.0, near=None) for x in crossed_sections(layout))),
        foul_beside(layout),
        needs(layout),
        beyond,
        approaches,
    )


@dataclass(frozen=True, slots=True)
class _From:
    """A place that is protected.  needed: how far away a vehicle must stand; sections: of the ways that pass there."""

    needed: float
    sections: frozenset[SectionId]


def _beyond(
    layout: Layout,
    start: _From,
    edge: EdgeId,
    node: NodeId,
    gone: float,
    seen: frozenset[NodeId],
    spur: bool = False,
    against: bool = False,
) -> Beyond:
    """`gone`: metres from the place to `node`; `spur`: past a derailer, or over an inclined lane; `against`: past a
    section over which nothing comes this way but what runs away from there."""
    e = layout.track.edge[edge]
    against = against or e.nothing_comes_to(node)
    if against and not spur and (edge, node) not in runaways(layout):
        return Beyond(e.section, one_way=True)
    far = layout.track.far(edge, node)
    gone += e.length
    spur, lane = spur or e.inclined, e.inclined and e.section not in start.sections
    if far in seen or far in layout.track.buffer_at:
        stand = far in seen or layout.track.buffer_at[far].kind is BufferKind.STOP
        return Beyond(e.section, closed=True, spur=spur and stand, lane=lane and stand)
    facing = layout.signalling.facing.get((far, edge))
    signal = facing.id if facing is not None and gone >= start.needed else None
    boundary = layout.track.boundary_at.get(far)
    if signal is not None or boundary is not None:
        kind = boundary.kind if boundary is not None else None
        return Beyond(e.section, signal=signal, boundary=kind, spur=spur, lane=lane)
    point, crossing, trailed = layout.pointwork.point_at.get(far), layout.pointwork.crossing_at.get(far), None
    if point is not None:
        position = point.position_of(edge)
        ways = [point.normal, point.reverse] if position is None else [point.toe]
        trailed = None if position is None else (point.machine, position)
        spur = spur or (trailed is not None and point.derailer)
    elif crossing is not None:
        ways = [b if edge == a else a for a, b in crossing.arms if edge in (a, b)]
    else:
        ways = [x.id for x in layout.track.edges_at[far] if x.id != edge]
    onward = tuple(_beyond(layout, start, x, far, gone, seen | {far}, spur, against) for x in ways)
    return Beyond(e.section, trailed=trailed, onward=onward, lane=lane)
