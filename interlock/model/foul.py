"""Foul joints (侵限绝缘), computed from distances (R7).

A joint on a leg of a point, or on an arm of a diamond, is foul when it lies nearer to the point or diamond than the
fouling point plus the clearance: a vehicle that stands beyond the joint can still foul the other leg or arm.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.dataclass import dataclass
from interlock.model.elements import Crossing, CrossingId, EdgeId, MachineId, NodeId, PointId, Position, SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import Traversal


@dataclass(frozen=True)
class FoulJoint:
    """The neighbour section fouls ways over the *other* leg of a point, or the other arm of a diamond.

    side: the leg or arm beyond whose joint the neighbour lies.  section: where the ways run that it fouls.  `when` is
    the point of the neighbour that leads vehicles to the joint in that position; detected in the other one, no vehicle
    in the neighbour stands at the joint.  None: the neighbour fouls whatever points do.  near: a point that decides
    nothing, since it lies nearer to the element than the fouling point of either and the clearance, at so many metres
    of so many needed: whatever passes it comes too near, however it lies.
    """

    element: PointId | CrossingId
    side: Position | int
    section: SectionId
    neighbour: SectionId
    node: NodeId
    distance: float
    needed: float
    when: tuple[MachineId, Position] | None
    near: tuple[MachineId, float, float] | None = None

    @property
    def name(self) -> str:
        """The point or diamond, in words."""
        return _called(self.element, self.side)

    def fouls(self, t: Traversal) -> bool:
        """A vehicle at the joint stands in the way."""
        return _in_the_way(self.element, self.side, t)

    def touches(self, t: Traversal) -> bool:
        """A movement on the way comes to the joint; any way of the neighbour, where its points tell nothing."""
        return t.section == self.neighbour and (self.when is None or self.node in (t.entry, t.exit))


@dataclass(frozen=True)
class FoulBoundary:
    """A boundary on a leg of a point, or on an arm of a diamond, nearer to it than `needed` metres: a train that has
    left the layout may stand foul of it."""

    element: PointId | CrossingId
    node: NodeId
    distance: float
    needed: float


@dataclass(frozen=True)
class CrossedSection:
    """The section of a diamond's other arm: a vehicle there may stand on the diamond, in the way of whoever passes the
    diamond itself, or passes a point, or another diamond, that lies too near to it.

    element, side: of the ways in `section` that it fouls, as of a foul joint; of the diamond itself the other arm.
    `when` is the point of the other section that leads vehicles to the diamond in that position; where points on both
    sides of the diamond do, there is one of these for each.  near: as of a foul joint, a point on either side that is
    too near.  distance: from the element to the diamond; 0 of the diamond itself.
    """

    crossing: CrossingId
    element: PointId | CrossingId
    side: Position | int
    section: SectionId
    neighbour: SectionId
    when: tuple[MachineId, Position] | None
    near: tuple[MachineId, float, float] | None = None
    distance: float = 0.0
    needed: float = 0.0

    def fouls(self, t: Traversal) -> bool:
        """A vehicle on the diamond stands in the way."""
        return _in_the_way(self.element, self.side, t)


@dataclass(frozen=True)
class FoulBeside:
    """A section that begins on one leg of a point, or arm of a diamond, nearer than a vehicle there stands clear of one
    that is as near on the other: who stands at the one joint is in the way of who stands at the other, or runs past it.

    section: in which the ways over one of `edges` lie that are fouled.  side: the leg or arm of the neighbour.  there:
    its edges on which a vehicle is so near.  `when`: as of a foul joint.
    """

    element: PointId | CrossingId
    side: Position | int
    section: SectionId
    neighbour: SectionId
    when: tuple[MachineId, Position] | None
    edges: frozenset[EdgeId]
    there: frozenset[EdgeId]

    @property
    def name(self) -> str:
        """The point or diamond, in words."""
        return _called(self.element, self.side)

    def fouls(self, t: Traversal) -> bool:
        """A vehicle there stands in the way."""
        return t.section == self.section and not self.edges.isdisjoint(t.edges)

    def touches(self, t: Traversal) -> bool:
        """A movement on the way comes there; any way of the neighbour, where its points tell nothing."""
        return t.section == self.neighbour and (self.when is None or not self.there.isdisjoint(t.edges))


@dataclass(frozen=True)
class _Reached:
    """An edge of another section that begins nearer than needed on a leg or arm, or lies across it there."""

    element: PointId | CrossingId
    side: Position | int
    section: SectionId
    edge: EdgeId


def _called(element: PointId | CrossingId, side: Position | int) -> str:
    return f"{'point' if isinstance(side, Position) else 'diamond'} {element}"


Foul = FoulJoint | CrossedSection | FoulBeside
"""What a vehicle may stand at, in the way of another one."""


def _in_the_way(element: PointId | CrossingId, side: Position | int, t: Traversal) -> bool:
    """Whether a way leads over the other leg of a point, or the other arm of a diamond."""
    if isinstance(side, Position):
        return any(p == element and x is not side for p, x in t.points)
    return any(c == element and arm != side for c, arm in t.crossings)


def crossed_sections(layout: Layout) -> tuple[CrossedSection, ...]:
    """The sections across, of diamonds whose arms lie in two sections, ordered by diamond and arm (R6); then those of
    diamonds that lie too near to a point or another diamond, in the order of these (R7)."""
    found: list[CrossedSection] = []
    for c in layout.pointwork.crossings:
        needed = c.fouling + layout.principles.clearance_m
        sections = [layout.track.section_of(edges[0]) for edges in c.arms]
        for arm in (0, 1) if sections[0] != sections[1] else ():
            whens, near = _leading(layout, c, 1 - arm, 0.0, needed)
            across = sections[1 - arm]
            found += [CrossedSection(c.id, c.id, 1 - arm, sections[arm], across, when, near) for when in whens]
    return (*found, *dict.fromkeys(f for f in _met(layout) if isinstance(f, CrossedSection)))


def foul_joints(layout: Layout) -> tuple[FoulJoint, ...]:
    """Every foul joint, ordered by point and leg, then by diamond and arm."""
    return tuple(f for f in _met(layout) if isinstance(f, FoulJoint))


def foul_beside(layout: Layout) -> tuple[FoulBeside, ...]:
    """Every pair of sections that are foul of each other beside a point or diamond, in the same order."""
    met = tuple(_met(layout))
    reached: dict[PointId | CrossingId, dict[tuple[Position | int, SectionId], set[EdgeId]]] = {}
    for x in met:
        if isinstance(x, _Reached):
            reached.setdefault(x.element, {}).setdefault((x.side, x.section), set()).add(x.edge)
    found = dict[FoulBeside, None]()
    for f in (f for f in met if isinstance(f, FoulJoint | CrossedSection)):
        if isinstance(f, FoulJoint):
            there = {e.id for e in layout.track.edges_at[f.node]}
        else:
            there = {e for arm in layout.pointwork.crossing[f.crossing].arms for e in arm}
        near = frozenset(e for e in there if layout.track.section_of(e) == f.neighbour)
        for (side, section), edges in reached.get(f.element, {}).items():
            if side != f.side and section != f.neighbour:
                of = (f.element, f.side, section, f.neighbour, f.when)
                found[FoulBeside(*of, frozenset(edges), near)] = None
    return tuple(found)


def foul_boundaries(layout: Layout) -> tuple[FoulBoundary, ...]:
    """Every foul boundary, in the same order."""
    return tuple(dict.fromkeys(f for f in _met(layout) if isinstance(f, FoulBoundary)))


def _met(layout: Layout) -> Iterator[FoulJoint | FoulBoundary | CrossedSection | _Reached]:
    """What is met on the walks out from each leg and arm."""
    margin = layout.principles.clearance_m
    for p in layout.pointwork.points:
        home = layout.track.section_of(p.toe)
        for leg in Position:
            walk = _Walk(layout, p.id, leg, home, p.node, p.fouling + margin)
            yield from walk.along(p.leg(leg), p.node, 0.0, home)
    for c in layout.pointwork.crossings:
        for arm, edges in enumerate(c.arms):
            across = layout.track.section_of(c.arms[1 - arm][0])
            walk = _Walk(layout, c.id, arm, across, c.node, c.fouling + margin)
            for e in edges:
                yield from walk.along(e, c.node, 0.0, layout.track.section_of(e))


@dataclass(frozen=True)
class _Walk:
    """A walk out from a point or diamond until the distance needed is covered; what it meets that is nearer is foul."""

    layout: Layout
    element: PointId | CrossingId
    side: Position | int
    section: SectionId
    start: NodeId
    needed: float

    def along(
        self, edge: EdgeId, node: NodeId, gone: float, home: SectionId
    ) -> list[FoulJoint | FoulBoundary | CrossedSection | _Reached]:
        """`home`: the section in which the point or arm lies; within it and the fouled one there is no joint."""
        layout = self.layout
        far = layout.track.far(edge, node)
        gone += layout.track.edge[edge].length
        if gone >= self.needed or far == self.start:
            return []
        out: list[FoulJoint | FoulBoundary | CrossedSection | _Reached] = []
        crossing = layout.pointwork.crossing_at.get(far)
        if crossing is not None:
            arm = next(i for i, edges in enumerate(crossing.arms) if edge not in edges)
            across = layout.track.section_of(crossing.arms[arm][0])
            if across not in (home, self.section):
                out += [_Reached(self.element, self.side, across, e) for e in crossing.arms[arm]]
            if across not in (home, self.section, layout.track.section_of(edge)):
                whens, near = _leading(layout, crossing, arm, gone, self.needed)
                of = (crossing.id, self.element, self.side, self.section, across)
                out += [CrossedSection(*of, when, near, gone, self.needed) for when in whens]
        if far in layout.track.boundary_at:
            out.append(FoulBoundary(self.element, far, gone, self.needed))
        for e in layout.onward(edge, far):
            if e.section not in (home, self.section):
                out.append(_Reached(self.element, self.side, e.section, e.id))
            if e.section not in (home, self.section, layout.track.section_of(edge)):
                when, near = _decider(layout, e.id, far, gone, self.needed)
                out.append(
                    FoulJoint(self.element, self.side, self.section, e.section, far, gone, self.needed, when, near)
                )
            out.extend(self.along(e.id, far, gone, home))
        return out


def _leading(
    layout: Layout, crossing: Crossing, arm: int, gone: float, needed: float
) -> tuple[list[tuple[MachineId, Position] | None], tuple[MachineId, float, float] | None]:
    """The points on either side that lead vehicles to a diamond along an arm, or None where none decides; and one that
    lies too near, with which none does."""
    found = [_decider(layout, e, crossing.node, gone, needed) for e in crossing.arms[arm]]
    near = next((x for _, x in found if x is not None), None)
    whens = dict.fromkeys(when for when, _ in found if when is not None and near is None)
    return [*whens] or [None], near


def _decider(
    layout: Layout, edge: EdgeId, node: NodeId, gone: float, needed: float
) -> tuple[tuple[MachineId, Position] | None, tuple[MachineId, float, float] | None]:
    """The first point in the neighbour, if its leg leads to the node, and it lies `needed` metres away, of which `gone`
    lead to the node, and as its own fouling point asks; if it is nearer, it decides nothing: that point, how far away
    it lies, and how far it should."""
    section = layout.track.section_of(edge)
    seen = {node}
    while True:
        node = layout.track.far(edge, node)
        gone += layout.track.edge[edge].length
        if node in seen or node in layout.pointwork.crossing_at:
            return None, None
        seen.add(node)
        point = layout.pointwork.point_at.get(node)
        if point is not None:
            position = point.position_of(edge)
            needed = max(needed, point.fouling + layout.principles.clearance_m)
            if position is not None and gone < needed:
                return None, (point.machine, gone, needed)
            return (None if position is None else (point.machine, position)), None
        onward = [e.id for e in layout.track.edges_at[node] if e.id != edge and e.section == section]
        if len(onward) != 1:
            return None, None
        edge = onward[0]
