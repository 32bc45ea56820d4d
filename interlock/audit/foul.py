"""What stands foul of a path beyond a joint, by distances from the track alone (R7)."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from interlock.audit.flank import pairs
from interlock.audit.walk import Move, Trip, distances
from interlock.model.elements import EdgeId, MachineId, NodeId, Point, Position, SectionId
from interlock.model.layout import Layout, of_layout

Foul = tuple[SectionId, tuple[MachineId, Position] | None, NodeId, SectionId]


def foul_neighbours(layout: Layout, trip: Trip) -> set[Foul]:
    """Sections that begin too near to a point of the path, on its unused leg, or to a diamond on its other arm; the
    point that leads there, where, and the section of the path."""
    return set[Foul]().union(*(_foul_between(layout, a, b) for a, b in pairs(trip)))


def _facing(layout: Layout, trip: Trip) -> set[Foul]:
    """What stands foul of a path that comes too near to a point on one leg, or to a diamond on one arm."""
    found = set[Foul]()
    for edge in {m.edge for m in (*trip.moves, *trip.over)}:
        own = layout.track.section_of(edge)
        for node, side in _reached_at(layout).get(edge, ()):
            for other, (_, fouls) in _sides(layout)[node].items():
                if other != side:
                    found |= {(s, w, near, own) for s, w, near in fouls if s != own}
    return found


_Side = tuple[set[EdgeId], set[tuple[SectionId, tuple[MachineId, Position] | None, NodeId]]]
"""The edges too near to a point or diamond, on one leg or arm, and the sections that begin there."""


@of_layout
def _reached_at(layout: Layout) -> dict[EdgeId, list[tuple[NodeId, int]]]:
    found: dict[EdgeId, list[tuple[NodeId, int]]] = {}
    for node, sides in _sides(layout).items():
        for side, (edges, _) in sides.items():
            for e in edges:
                found.setdefault(e, []).append((node, side))
    return found


@of_layout
def _sides(layout: Layout) -> dict[NodeId, dict[int, _Side]]:
    margin, section_of = layout.principles.clearance_m, layout.track.section_of
    legs = [
        (p.node, i, leg, {section_of(p.toe)}, p.fouling + margin)
        for p in layout.pointwork.points
        for i, leg in enumerate((p.normal, p.reverse))
    ]
    legs += [
        (c.node, i, e, {section_of(c.arms[0][0]), section_of(c.arms[1][0])}, c.fouling + margin)
        for c in layout.pointwork.crossings
        for i, arm in enumerate(c.arms)
        for e in arm
    ]
    found: dict[NodeId, dict[int, _Side]] = {}
    for node, side, leg, own, needed in legs:
        edges, fouls = found.setdefault(node, {}).setdefault(side, (set(), set()))
        for (edge, near), gone in distances(layout, node, leg, needed).items():
            section, far = section_of(edge), layout.track.far(edge, near)
            if gone < needed and section not in own:
                edges.add(edge)
                if all(e.section != section for e in layout.track.edges_at[near] if e.id != edge):
                    fouls.add((section, _decides(layout, edge, near, gone, needed), near))
            run = gone + layout.track.edge[edge].length
            if run < needed and far != node and far in layout.pointwork.crossing_at:
                arm = next(arm for arm in layout.pointwork.crossing_at[far].arms if edge not in arm)
                if section_of(arm[0]) not in own:
                    edges.update(arm)
                there = _on_diamond(layout, far, edge, {*own, section}, section, (run, needed))
                fouls |= {(s, w, n) for s, w, n, _ in there}
    return found


@of_layout
def _foul_between(layout: Layout, a: Move, b: Move) -> frozenset[Foul]:
    """What stands foul of a path where one move passes to the next."""
    return frozenset(
        (section, _decides(layout, edge, near, gone, needed), near, layout.track.section_of(a.edge))
        for unused, own, needed in _beside(layout, a, b)
        for (edge, near), gone in distances(layout, a.node, unused, needed).items()
        for section in [layout.track.section_of(edge)]
        if gone < needed
        and section not in own
        and all(e.section != section for e in layout.track.edges_at[near] if e.id != edge)
    )


def across(layout: Layout, trip: Trip) -> set[Foul]:
    """The sections in which a vehicle may stand on a diamond of the path, or on one too near to a point or diamond of
    the path, with each point that must lie so for one to come to that diamond; the diamond, and the path's section.
    And what stands foul of a path that comes too near to a point or diamond without passing it."""
    found = _facing(layout, trip)
    for a, b in pairs(trip):
        own = layout.track.section_of(a.edge)
        if a.node in layout.pointwork.crossing_at:
            margin = layout.pointwork.crossing_at[a.node].fouling + layout.principles.clearance_m
            found |= _on_diamond(layout, a.node, a.edge, {own}, own, (0.0, margin))
        for unused, here, needed in _beside(layout, a, b):
            for (edge, near), gone in distances(layout, a.node, unused, needed).items():
                far, run = layout.track.far(edge, near), gone + layout.track.edge[edge].length
                if run < needed and far != a.node and far in layout.pointwork.crossing_at:
                    seen = {*here, layout.track.section_of(unused), layout.track.section_of(edge), own}
                    found |= _on_diamond(layout, far, edge, seen, own, (run, needed))
    return found


def _on_diamond(
    layout: Layout, node: NodeId, along: EdgeId, seen: Collection[SectionId], own: SectionId, way: tuple[float, float]
) -> set[Foul]:
    """Who may stand on a diamond across an edge that leads to it, in none of the sections in which it is seen anyway;
    `way`: metres to the diamond, and how far away a point must be that tells of somebody that it is not there."""
    arm = next(arm for arm in layout.pointwork.crossing_at[node].arms if along not in arm)
    section = layout.track.section_of(arm[0])
    if section in seen:
        return set()
    leading = [_decides(layout, e, node, *way) for e in arm if _way_out(layout, e, node) is not None]
    return {(section, w if all(leading) else None, node, own) for w in leading or [None]}


def crossed(
    layout: Layout, trip: Trip, held: Collection[tuple[MachineId, Position]]
) -> set[tuple[SectionId, tuple[MachineId, Position] | None]]:
    """What must be clear across the diamonds of the path, and where it comes too near to others; but for sections that
    the path takes itself, and such a point that it holds otherwise."""
    taken = {layout.track.section_of(m.edge) for m in (*trip.moves, *trip.over)}
    found = {(s, w) for s, w, *_ in across(layout, trip) if s not in taken}
    return {(s, w) for s, w in found if w is None or (w[0], w[1].other) not in held}


def _beside(layout: Layout, a: Move, b: Move) -> Iterator[tuple[EdgeId, set[SectionId], float]]:
    """The edges on which a vehicle near the node would stand in the way, the sections in which it would be seen
    anyway, and how far it must stay away."""
    point, margin = layout.pointwork.point_at.get(a.node), layout.principles.clearance_m
    if point is not None:
        unused = next(e for e in (point.normal, point.reverse) if e not in (a.edge, b.edge))
        yield unused, {layout.track.section_of(point.toe)}, point.fouling + margin
    crossing = layout.pointwork.crossing_at.get(a.node)
    if crossing is not None:
        here = {layout.track.section_of(a.edge)}
        for e in next(arm for arm in crossing.arms if a.edge not in arm):
            yield e, here | {layout.track.section_of(e)}, crossing.fouling + margin


def _decides(
    layout: Layout, edge: EdgeId, near: NodeId, gone: float, needed: float
) -> tuple[MachineId, Position] | None:
    """How a point must lie for a vehicle to come to `near`, if it tells that whoever passes it otherwise is clear: it
    lies so far away that neither its own legs nor those where the walk began are too near to each other."""
    out = _way_out(layout, edge, near)
    if out is None or gone + out[2] < max(needed, out[0].fouling + layout.principles.clearance_m):
        return None
    return out[0].machine, out[1]


def _way_out(layout: Layout, edge: EdgeId, near: NodeId) -> tuple[Point, Position, float] | None:
    """The first point beyond, within the section, that must lie so for a vehicle to come to `near`; how far away."""
    section = layout.track.section_of(edge)
    gone = 0.0
    for _ in layout.track.edges:
        near = layout.track.far(edge, near)
        gone += layout.track.edge[edge].length
        p = layout.pointwork.point_at.get(near)
        if p is not None:
            return None if edge == p.toe else (p, Position.NORMAL if edge == p.normal else Position.REVERSE, gone)
        further = [e.id for e in layout.track.edges_at[near] if e.id != edge and e.section == section]
        if near in layout.pointwork.crossing_at or len(further) != 1:
            return None
        edge = further[0]
    return None
