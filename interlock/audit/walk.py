"""Vehicles on edges: the audit's own picture of the layout.

A vehicle is on an edge and moves towards one of its nodes.  From there it goes on over every edge that the track
allows, whatever position points have, unless the caller freezes them.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

from interlock.dataclass import dataclass
from interlock.model.elements import BoundaryKind, Edge, EdgeId, MachineId, NodeId, Position, SectionId, Signal
from interlock.model.layout import Layout, of_layout

Frozen = Mapping[MachineId, Position]
Lying = tuple[tuple[MachineId, Position], ...]
"""How points must lie for a way, in the order in which they are met or of their machines."""


class Move(NamedTuple):
    """On `edge`, moving towards `node`."""

    edge: EdgeId
    node: NodeId


@dataclass(frozen=True)
class Trip:
    """A signal's path as the audit finds it."""

    entry: str
    exit: str
    shunt: bool
    berth: SectionId | None
    moves: tuple[Move, ...]
    sections: tuple[SectionId, ...]
    positions: Lying
    over: tuple[Move, ...] = ()
    over_positions: Lying = ()
    call_on: bool = False
    identifier: bool = False
    """What a train that passes its signal at identifier light runs over."""
    onward: Trip | None = None
    """Past the signal at its exit it leads on over this one."""

    @property
    def parts(self) -> tuple[Trip, ...]:
        """Itself, and what lies past one signal after the other."""
        return (self,) if self.onward is None else (self, *self.onward.parts)

    @property
    def run(self) -> Trip:
        """The whole way of its train."""
        if self.onward is None:
            return self
        b = self.onward.run
        positions = tuple(sorted({**dict(self.positions), **dict(b.positions)}.items()))
        moves, sections = (*self.moves, *b.moves), (*self.sections, *b.sections)
        return replace(self, exit=b.exit, moves=moves, sections=sections, positions=positions, onward=None)


def in_rear(layout: Layout, trip: Trip) -> frozenset[SectionId]:
    """The section before a trip's signal, in which its train stands; none at a boundary."""
    start = trip.moves[0]
    near = layout.track.edges_at[layout.track.far(start.edge, start.node)]
    return frozenset(e.section for e in near if e.id != start.edge)


def past_signals(layout: Layout, ahead: list[Trip], beyond: list[Trip]) -> list[Trip]:
    """Trips past a signal that shows its identifier light: one to it and one on from it, which one train can run over;
    what is on from it may itself lead past the next one.

    The overlap of the signal, where it has one, is the longest that lies on the way beyond.
    """
    found: dict[tuple[str, bool, tuple[Move, ...], Trip], Trip] = {}
    for part in beyond:
        b = part.run
        for t in ahead:
            clash = any(dict(t.positions).get(m, x) is not x for m, x in b.positions)
            over = {n for m in (*t.moves[:-1], *b.moves[:-1]) for n in [m.node] if n in layout.pointwork.crossing_at}
            twice = len(over) < sum(m.node in layout.pointwork.crossing_at for m in (*t.moves[:-1], *b.moves[:-1]))
            if t.exit != b.entry or clash or twice or (in_rear(layout, t) | set(t.sections)) & set(b.sections):
                continue
            if layout.overlaps.length.get(b.entry, 0.0) > 0 and not (t.over and set(t.over) <= set(b.moves)):  # type: ignore[call-overload]
                continue
            key = (t.entry, t.identifier, t.moves, part)
            if key not in found or len(t.over) > len(found[key].over):
                found[key] = replace(t, onward=part)
    return list(found.values())


class Step(NamedTuple):
    """A way on from a move: `needs` is the position that a point takes or needs for it, and `facing` whether the
    vehicle meets that point at its toe; `against`: no train runs in that direction."""

    ahead: Move
    needs: tuple[MachineId, Position] | None
    facing: bool
    against: bool


@of_layout
def _every_step(layout: Layout, at: Move) -> tuple[Step, ...]:
    """Where the track leads on from a move, whatever position points have."""
    found = []
    crossing = layout.pointwork.crossing_at.get(at.node)
    point = layout.pointwork.point_at.get(at.node)
    for e in layout.track.edges_at[at.node]:
        if e.id == at.edge:
            continue
        ahead = Move(e.id, e.b if e.a == at.node else e.a)
        if crossing is not None and not any(at.edge in arm and e.id in arm for arm in crossing.arms):
            continue
        needs: tuple[MachineId, Position] | None = None
        if point is not None:
            if point.toe not in (at.edge, e.id):
                continue
            leg = e.id if at.edge == point.toe else at.edge
            needs = (point.machine, Position.NORMAL if leg == point.normal else Position.REVERSE)
        facing = point is not None and at.edge == point.toe
        found.append(Step(ahead, needs, facing, e.one_way and ahead.node != e.b))
    return tuple(found)


def steps(
    layout: Layout, at: Move, frozen: Frozen | None = None, against: bool = False
) -> Iterator[tuple[Move, tuple[MachineId, Position] | None]]:
    """Where a vehicle can go next, and the position that a point takes or needs for it.

    A frozen point leads a facing vehicle one way only; a trailing vehicle runs through any point.  `against`: also
    where no train runs in that direction.
    """
    for step in _every_step(layout, at):
        if step.against and not against:
            continue
        if frozen and step.facing and step.needs and frozen.get(step.needs[0], step.needs[1]) is not step.needs[1]:
            continue
        yield step.ahead, step.needs


def nothing_comes(e: Edge, node: NodeId) -> bool:
    """Against its one way no train runs; vehicles run away over an inclined lane all the same."""
    return e.one_way and not e.inclined and node != e.b


@of_layout
def rolled_from(layout: Layout, here: Move) -> tuple[tuple[Move, tuple[MachineId, Position] | None], ...]:
    """Where a vehicle can have come from, against the one way of a section, too, as vehicles do that run away; and the
    position of a point that it met at its toe on the way here."""
    rear = layout.track.far(here.edge, here.node)
    before = [Move(e.id, rear) for e in layout.track.edges_at[rear] if e.id != here.edge]
    return tuple(
        (m, step.needs if step.facing else None)
        for m in before
        for step in _every_step(layout, m)
        if step.ahead == here
    )


def signal_facing(layout: Layout, node: NodeId, onto: EdgeId) -> Signal | None:
    """The signal that a vehicle meets at a node before it goes onto an edge."""
    return layout.signalling.facing.get((node, onto))


def turning_place(layout: Layout, section: SectionId) -> bool:
    """Whether shunting movements end in a section before a boundary, although the layout says that it is no berth."""
    under = any(section in d.over for d in layout.signalling.devices)
    return left_standing(layout, section) and section in layout.declared.no_berths and not under


@of_layout
def standing_place(layout: Layout, section: SectionId) -> bool:
    """Whether shunting movements end in a section and may find vehicles there: none that a device lies over, none that
    the layout says is no berth."""
    barred = section in layout.declared.no_berths or any(section in d.over for d in layout.signalling.devices)
    return left_standing(layout, section) and not barred


def left_standing(layout: Layout, section: SectionId) -> bool:
    """Whether vehicles may be left in a section: plain track, and every way out over a joint has a signal, one of them
    for shunting."""
    kinds = []
    for e in layout.track.edges_in.get(section, ()):
        for node in (e.a, e.b):
            if node in layout.pointwork.point_at or node in layout.pointwork.crossing_at:
                return False
            for onward in layout.track.edges_at[node]:
                if onward.section != section:
                    g = signal_facing(layout, node, onward.id)
                    if g is None:
                        return False
                    kinds.append(g.kind)
    return any(k != "main" for k in kinds)


def trips(layout: Layout, g: Signal, shunt: bool) -> list[Trip]:
    """Every path of a signal for trains or for shunting movements, by exhaustive walk over edges."""
    e = layout.track.edge[g.into]
    first = Move(g.into, e.b if e.a == g.node else e.a)
    if e.one_way and first.node != e.b:
        return []
    found: list[Trip] = []
    todo: list[tuple[tuple[Move, ...], Lying]] = [((first,), ())]
    while todo:
        moves, positions = todo.pop()
        here = moves[-1]
        place = shunt and _stops_here(layout, here)
        if _shut(layout, here, shunt, place):
            continue
        exit_ = _exit(layout, here, shunt, place)
        if exit_ is None:
            todo += ((on, (*positions, x) if x else positions) for on, x in onward(layout, moves))
        else:
            found += _trip(layout, Trip(g.id, exit_, shunt, None, moves, (), positions))
    return found


def _stops_here(layout: Layout, here: Move) -> bool:
    """Whether a shunting movement that has come to the end of a section ends in it."""
    section, end = layout.track.section_of(here.edge), here.node in layout.track.boundary_at
    leaves = end or any(e.section != section for e in layout.track.edges_at[here.node])
    return (leaves and standing_place(layout, section)) or (end and turning_place(layout, section))


def _shut(layout: Layout, here: Move, shunt: bool, place: bool) -> bool:
    """Whether no path leads so far: into a trap or off the rails, or out over a boundary where trains only come in, or,
    shunting, over any."""
    boundary, buffer = layout.track.boundary_at.get(here.node), layout.track.buffer_at.get(here.node)
    out = boundary is not None and not place and (shunt or boundary.kind is BoundaryKind.IN)
    return out or (buffer is not None and buffer.kind != "stop")


def _exit(layout: Layout, here: Move, shunt: bool, place: bool) -> str | None:
    """Where a path ends that has come so far: at a signal that the movement obeys, at a buffer, in a section where it
    stops (`place`), at a boundary; None where it leads on."""
    ahead = next((signal_facing(layout, here.node, m.edge) for m, _ in steps(layout, here)), None)
    if ahead is not None and (shunt or ahead.main):
        return str(ahead.id)
    if place and here.node not in layout.track.buffer_at:
        return layout.track.section_of(here.edge)
    return str(here.node) if here.node in layout.track.boundary_at or here.node in layout.track.buffer_at else None


def onward(
    layout: Layout, moves: tuple[Move, ...]
) -> Iterator[tuple[tuple[Move, ...], tuple[MachineId, Position] | None]]:
    """How a path goes on, each with what a point must lie for it: over no edge twice, and back into no section that it
    has left."""
    section = layout.track.section_of(moves[-1].edge)
    for m, needs in steps(layout, moves[-1]):
        beyond = layout.track.section_of(m.edge)
        again = beyond != section and any(layout.track.section_of(x.edge) == beyond for x in moves)
        if not again and all(m.edge != x.edge for x in moves):
            yield (*moves, m), needs


def _trip(layout: Layout, walked: Trip) -> Iterator[Trip]:
    """What was walked as a trip with its sections and berth, if a movement can take it: each section in one piece, no
    machine in two positions or by hand in reverse, no diamond twice, and nothing without detection but a berth."""
    runs = [layout.track.section_of(m.edge) for m in walked.moves]
    sections = tuple(dict.fromkeys(runs))
    in_one_piece = sum(1 for a, b in itertools.pairwise(runs) if a != b) + 1 == len(sections)
    lying: dict[MachineId, Position] = {}
    clash = any(lying.setdefault(m, x) is not x for m, x in walked.positions)
    clash = clash or any(lying.get(m) == "R" for m in layout.machines.by_hand)
    diamonds = [m.node for m in walked.moves[:-1] if m.node in layout.pointwork.crossing_at]
    stands = walked.shunt and len(sections) > 1 and standing_place(layout, sections[-1])
    berth = sections[-1] if stands else None
    blind = [s for s in sections if s in layout.track.undetected]
    if in_one_piece and not clash and len(diamonds) == len(set(diamonds)) and blind in ([], [berth]):
        yield replace(walked, berth=berth, sections=sections, positions=tuple(sorted(lying.items())))


def distances(layout: Layout, node: NodeId, leg: EdgeId, limit: float) -> dict[tuple[EdgeId, NodeId], float]:
    """Metres from a point's node, out over one leg, to the near node of every edge nearer than a limit: vehicles may
    stand there in whatever direction trains run."""
    out: dict[tuple[EdgeId, NodeId], float] = {}
    todo: list[tuple[EdgeId, NodeId, float]] = [(leg, node, 0.0)]
    while todo:
        edge, near, gone = todo.pop()
        if (edge, near) in out:
            continue
        out[edge, near] = gone
        far = layout.track.far(edge, near)
        if far != node:
            reached = gone + layout.track.edge[edge].length
            todo.extend(
                (m.edge, far, reached) for m, _ in steps(layout, Move(edge, far), against=True) if reached < limit
            )
    return out


def signal_distance(layout: Layout, node: NodeId, leg: EdgeId, g: Signal, limit: float) -> float | None:
    """Shortest metres from a node, out over an edge, through anything, to a signal; None from the limit on."""
    best: dict[NodeId, float] = {}
    todo: list[tuple[EdgeId, NodeId, float]] = [(leg, node, 0.0)]
    while todo:
        edge, near, gone = todo.pop()
        far = layout.track.far(edge, near)
        total = gone + layout.track.edge[edge].length
        if total >= limit or best.get(far, limit) <= total:
            continue
        best[far] = total
        todo.extend((e.id, far, total) for e in layout.track.edges_at[far] if e.id != edge)
    return best.get(g.node)
