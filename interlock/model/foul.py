"""Foul joints (侵限绝缘), computed from distances (R7).

A joint on a leg of a point is foul when it lies nearer to the point than its fouling point plus the
clearance: a vehicle that stands beyond the joint can still foul the other leg.
"""

from __future__ import annotations

from dataclasses import dataclass

from interlock.model.elements import EdgeId, MachineId, NodeId, PointId, Position, SectionId
from interlock.model.layout import Layout


@dataclass(frozen=True)
class FoulJoint:
    """The neighbour section fouls routes over the *other* leg of the point.

    `when` is the point of the neighbour that leads vehicles to the joint in that position; detected in the other one,
    no vehicle in the neighbour stands at the joint.  None: the neighbour fouls whatever points do.
    """

    point: PointId
    leg: Position
    section: SectionId
    neighbour: SectionId
    node: NodeId
    distance: float
    needed: float
    when: tuple[MachineId, Position] | None


def foul_joints(layout: Layout) -> tuple[FoulJoint, ...]:
    """Every foul joint, ordered by point and leg."""
    found = []
    for p in layout.points:
        needed = p.fouling + layout.principles.clearance_m
        for leg in Position:
            found.extend(_along(layout, p.id, leg, p.leg(leg), p.node, 0.0, needed))
    return tuple(found)


def _along(
    layout: Layout, point: PointId, leg: Position, edge: EdgeId, node: NodeId, gone: float, needed: float
) -> list[FoulJoint]:
    """Walk out from the point until the distance needed is covered; collect joints nearer than it."""
    home = layout.section_of(layout.point[point].toe)
    far = layout.far(edge, node)
    gone += layout.edge[edge].length
    if gone >= needed or far == layout.point[point].node:
        return []
    out = []
    for e in layout.onward(edge, far):
        if e.section not in (home, layout.section_of(edge)):
            when = _decider(layout, e.id, far)
            out.append(FoulJoint(point, leg, home, e.section, far, gone, needed, when))
        out.extend(_along(layout, point, leg, e.id, far, gone, needed))
    return out


def _decider(layout: Layout, edge: EdgeId, node: NodeId) -> tuple[MachineId, Position] | None:
    """The first point in the neighbour, if its leg leads to the joint."""
    section = layout.section_of(edge)
    seen = {node}
    while True:
        node = layout.far(edge, node)
        if node in seen or node in layout.crossing_at:
            return None
        seen.add(node)
        point = layout.point_at.get(node)
        if point is not None:
            position = point.position_of(edge)
            return None if position is None else (point.machine, position)
        onward = [e.id for e in layout.edges_at[node] if e.id != edge and e.section == section]
        if len(onward) != 1:
            return None
        edge = onward[0]
