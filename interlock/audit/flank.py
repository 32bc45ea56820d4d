"""Flank by Hansen's area condition: freeze the points of a route and see what may roll to an unused leg."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from itertools import pairwise
from typing import NamedTuple

from interlock.audit.walk import (
    Frozen,
    Move,
    Trip,
    nothing_comes,
    rolled_from,
    signal_distance,
    signal_facing,
)
from interlock.model.elements import BoundaryKind, BufferKind, EdgeId, MachineId, NodeId, Position, SectionId
from interlock.model.layout import Layout, of_layout
from interlock.table.rows import RouteRow


class Place(NamedTuple):
    """An unused leg of a point, or end of a crossed arm: entered over `edge` towards `node`.  own: the sections of the
    trip there, and across a diamond."""

    name: str
    node: NodeId
    edge: EdgeId
    clear_of: float
    point: str
    leg: Position | None
    own: frozenset[SectionId]


def pairs(trip: Trip) -> Iterator[tuple[Move, Move]]:
    """Each move with the one after it, on the path and on the overlap."""
    yield from pairwise(trip.moves)
    yield from pairwise(trip.over)


def unused_places(layout: Layout, trip: Trip) -> list[Place]:
    """Every place beside the path at which a vehicle could come in; none does from where a derailer throws it off."""
    out: list[Place] = []
    margin = layout.principles.clearance_m
    for a, b in pairs(trip):
        point = layout.pointwork.point_at.get(a.node)
        if point is not None:
            unused = next(e for e in (point.normal, point.reverse) if e not in (a.edge, b.edge))
            leg = Position.NORMAL if unused == point.normal else Position.REVERSE
            own = frozenset({layout.track.section_of(point.toe)})
            if point.derailer and leg is Position.NORMAL:
                continue
            out.append(Place(f"{point.id}.{leg}", a.node, unused, point.fouling + margin, point.id, leg, own))
        crossing = layout.pointwork.crossing_at.get(a.node)
        if crossing is not None:
            own = frozenset(layout.track.section_of(arm[0]) for arm in crossing.arms)
            for arm in crossing.arms:
                if a.edge not in arm:
                    clear_of = crossing.fouling + margin
                    out += [Place(f"{crossing.id}/{e}", a.node, e, clear_of, "", None, own) for e in arm]
    return out


def requester(place: Place) -> str:
    """A place as the table names it: the leg of a point, or the end of a crossing or slip."""
    if place.leg is not None:
        return f"{place.point}.{'normal' if place.leg is Position.NORMAL else 'reverse'}"
    return place.edge.removesuffix("x")


def comes_in(layout: Layout, place: Place, frozen: Frozen, told: frozenset[str] | None = None) -> bool:
    """Whether a vehicle can come to a place from outside, as frozen points lie, past no signal, or none of some.

    Over the path itself none comes: that is a hostile movement, not a flank.
    """
    met = _walk(layout, place, (), told).met
    return _walk(layout, place, tuple((m, frozen[m]) for m in met if m in frozen), told).outside


class Walk(NamedTuple):
    """What a walk back from a place finds: whether it comes outside, and the machines that a vehicle on its way to the
    place can meet at the toe of their points, which alone lead it elsewhere when they are frozen."""

    outside: bool
    met: tuple[MachineId, ...]


@of_layout
def _walk(
    layout: Layout, place: Place, lying: tuple[tuple[MachineId, Position], ...], told: frozenset[str] | None
) -> Walk:
    """The walk back from a place with points lying so, up to signals, or to some signals only.  Outside is the end of a
    track, a ring, or a boundary where no train comes in, if a vehicle comes from there over a derailer or an inclined
    lane (`spur`); and such a lane itself, however points lie in it, unless it ends in a trap.  Of what lies beyond a
    section against whose one way it would have to run (`against`) only those count.
    """
    frozen = dict(lying)
    todo = [(Move(place.edge, place.node), False, False, frozenset({place.node}))]
    seen, met, outside = set[tuple[Move, bool, frozenset[NodeId] | None]](), dict[MachineId, None](), False
    while todo:
        here, spur, against, path = todo.pop()
        e = layout.track.edge[here.edge]
        against = against or nothing_comes(e, here.node)
        if (here, against, path if spur else None) in seen:
            continue
        seen.add((here, against, path if spur else None))
        rear, lane = layout.track.far(here.edge, here.node), e.inclined and e.section not in place.own
        g = signal_facing(layout, rear, here.edge)
        if g is not None and (told is None or g.id in told) and not lane and _stops(layout, rear, here.edge, place):
            continue
        boundary = layout.track.boundary_at.get(rear)
        spur = spur or e.inclined
        ring = spur and rear in path
        outside = outside or ring
        comes = boundary is not None and boundary.kind is not BoundaryKind.OUT and not against
        outside = outside or comes or (boundary is not None and spur)
        end = layout.track.buffer_at.get(rear)
        outside = outside or (spur and end is not None and end.kind is BufferKind.STOP)
        if boundary is None and end is None and rear != place.node and not ring:
            for before, faced in rolled_from(layout, here):
                if faced is not None:
                    met[faced[0]] = None
                if faced is None or lane or frozen.get(*faced) is faced[1]:
                    outside = outside or (lane and layout.track.section_of(before.edge) != e.section)
                    kept = faced is not None and layout.pointwork.point_at[rear].derailer
                    todo.append((before, spur or kept, against, path | {rear}))
    return Walk(outside, tuple(met))


def open_flanks(layout: Layout, trip: Trip, frozen: Frozen) -> list[Place]:
    """Places that the area of some vehicle from outside touches."""
    return [p for p in unused_places(layout, trip) if comes_in(layout, p, frozen)]


def crossovers_to_lie_normal(layout: Layout, trip: Trip) -> set[MachineId]:
    """The machines of crossovers over which a trip runs on a diamond: points on both sides whose reverse legs lead
    nowhere but to the arm that the trip does not use."""
    found: set[MachineId] = set()
    for a, b in pairs(trip):
        crossing = layout.pointwork.crossing_at.get(a.node)
        for arm in crossing.arms if crossing is not None else ():
            ends = [_reverse_of(layout, Move(e, layout.track.far(e, a.node))) for e in arm if e not in (a.edge, b.edge)]
            found.update(m for m in ends if m is not None and None not in ends)
    return found


def _reverse_of(layout: Layout, move: Move) -> MachineId | None:
    """The machine that a vehicle on plain track comes to next, if it comes over the reverse leg."""
    for _ in range(len(layout.track.edges)):
        point = layout.pointwork.point_at.get(move.node)
        if point is not None:
            return point.machine if move.edge == point.reverse else None
        further = [e for e in layout.track.edges_at[move.node] if e.id != move.edge]
        if len(further) != 1:
            return None
        move = Move(further[0].id, layout.track.far(further[0].id, move.node))
    return None


Space = set[tuple[str, bool]]
"""Sections, and signals (True)."""

Movements = Mapping[SectionId, Collection[frozenset[SectionId]]]
"""For each section the sections of every trip that passes it; an empty set where one begins behind it, or vehicles
stand at its end."""


def flank_space(
    layout: Layout,
    trip: Trip,
    frozen: Frozen,
    waived: Collection[tuple[str, Position | None]],
    movements: Movements,
) -> tuple[Space, Space]:
    """What lies between the places and what stops vehicles: with the points as the route locks them, and at most.

    Not needed is a section in which another movement may be that does not pass the place.
    """
    needed: Space = set()
    possible: Space = set()
    path = {m.edge for m in (*trip.moves, *trip.over)}
    for place in unused_places(layout, trip):
        own = {layout.track.section_of(e.id) for e in layout.track.edges_at[place.node] if e.id in path}
        if (place.point, place.leg) not in waived:
            needed |= {
                (what, signal)
                for what, signal in _outside(_between(layout, place, frozen), own)
                if signal or all(own & over for over in movements.get(SectionId(what), ()))
            }
        possible |= _outside(_at_most(layout, place), own)
    return needed, possible


def _outside(space: Space, own: Collection[SectionId]) -> Space:
    return {(what, signal) for what, signal in space if signal or what not in own}


@of_layout
def _at_most(layout: Layout, place: Place) -> Space:
    """What lies behind a place, whichever way the points lie."""
    return _between(layout, place, {})


def _between(layout: Layout, place: Place, frozen: Frozen) -> Space:
    """Backwards from a place over everything from which a vehicle could roll to it.

    A section counts if one could come into it from elsewhere, or from its end; not if it can come no further back than
    to a point of this very section that is turned away.
    """
    rules = layout.principles
    if not rules.flank_space and not (rules.flank_lamp and rules.lamp_proof):
        return set()
    found: Space = set()
    todo = [(Move(place.edge, place.node), False, False)]
    seen: set[tuple[Move, bool, bool]] = set()
    while todo:
        here, spur, against = todo.pop()
        e = layout.track.edge[here.edge]
        if (here, spur, against) in seen or not _rolls(layout, here, spur, against):
            continue
        seen.add((here, spur, against))
        rear = layout.track.far(here.edge, here.node)
        ended = rear in (place.node, *layout.track.buffer_at, *layout.track.boundary_at) or _stops(
            layout, rear, here.edge, place
        )
        ways = () if ended else rolled_from(layout, here)
        against, spur = against or nothing_comes(e, here.node), spur or e.inclined
        before = [
            (m, spur or (faced is not None and layout.pointwork.point_at[rear].derailer))
            for m, faced in ways
            if faced is None or frozen.get(*faced) is faced[1]
        ]
        point = layout.pointwork.point_at.get(rear)
        turned = not ended and not before and point is not None and layout.track.section_of(point.toe) == e.section
        inside = bool(before) and all(layout.track.section_of(m.edge) == e.section for m, _ in before)
        if rules.flank_space and e.section not in layout.track.undetected and not turned and not inside:
            found.add((e.section, False))
        if _stops(layout, rear, here.edge, place):
            g = signal_facing(layout, rear, here.edge)
            if g is not None and rules.flank_lamp and rules.lamp_proof:
                found.add((g.id, True))
        todo += [(m, away, against) for m, away in before]
    return found


def _rolls(layout: Layout, here: Move, spur: bool, against: bool) -> bool:
    """Whether anything comes over an edge: against its one way, or beyond a section that runs so, only what runs away
    from an inclined lane, or from behind a derailer."""
    return spur or not (against or nothing_comes(layout.track.edge[here.edge], here.node)) or _runs_away(layout, here)


@of_layout
def _runs_away(layout: Layout, here: Move) -> bool:
    """Whether what stands on an inclined lane, or behind a derailer, can come over an edge, as points may lie."""
    todo, seen = [here], set[Move]()
    while todo:
        at = todo.pop()
        if at in seen:
            continue
        seen.add(at)
        rear = layout.track.far(at.edge, at.node)
        before = rolled_from(layout, at)
        derailer = rear in layout.pointwork.point_at and layout.pointwork.point_at[rear].derailer
        if layout.track.edge[at.edge].inclined or (derailer and any(faced is not None for _, faced in before)):
            return True
        todo += [m for m, _ in before]
    return False


def _stops(layout: Layout, node: NodeId, onto: EdgeId, place: Place) -> bool:
    """Whether a signal at stop keeps a vehicle there, clear of the fouling point of the place."""
    g = signal_facing(layout, node, onto)
    if g is None:
        return False
    return signal_distance(layout, place.node, place.edge, g, place.clear_of) is None


def flank(layout: Layout, r: RouteRow, trip: Trip, movements: Movements) -> Iterator[tuple[str, str]]:
    """What the audit sees otherwise in the flank protection of a route: the column, and what is wrong."""
    frozen = {p.machine: p.position for p in r.locking.points}
    waived = {(w.point, w.leg) for w in layout.declared.waivers}
    for place in open_flanks(layout, trip, frozen):
        if (place.point, place.leg) not in waived:
            yield ("flank", f"a vehicle can reach {place.name}")
    for m in sorted(crossovers_to_lie_normal(layout, trip)):
        if frozen.get(m) is not Position.NORMAL:
            yield ("flank", f"the crossover {m} of a scissors does not lie normal")
    yield from _cells(layout, r, trip, frozen)
    needed_clear, possible = flank_space(layout, trip, frozen, waived, movements)
    asked = {(c.name, c.lamp) for c in r.clear.space}
    if not needed_clear <= asked <= possible:
        odd = sorted(name for name, _ in (needed_clear - asked) | (asked - possible))
        yield ("space", f"differs in {', '.join(odd)}")


def _cells(layout: Layout, r: RouteRow, trip: Trip, frozen: Frozen) -> Iterator[tuple[str, str]]:
    """What is said of each place: a cell for each; its points are locked so, and its signals suffice."""
    places = {requester(p): p for p in unused_places(layout, trip)}
    cells = {c.requester: c.providers for c in r.locking.flank}
    waived = {(w.point, w.leg) for w in layout.declared.waivers}
    if places.keys() != cells.keys() or len(cells) < len(r.locking.flank):
        yield ("flank", f"places to protect are {', '.join(sorted(places)) or 'none'}")
    for name in sorted(places.keys() & cells.keys()):
        place = places[name]
        given_up = any(p.kind == "waived" for p in cells[name])
        if any(p.kind == "point" and frozen.get(MachineId(p.name)) != p.position for p in cells[name]):
            yield ("flank", f"a point that is told to protect {name} is not locked so")
        if given_up and (place.point, place.leg) not in waived:
            yield ("flank", f"nobody gives up the protection of {name}")
        if not given_up and comes_in(
            layout, place, frozen, frozenset(p.name for p in cells[name] if p.kind == "signal")
        ):
            yield ("flank", f"what is told to protect {name} does not suffice")
