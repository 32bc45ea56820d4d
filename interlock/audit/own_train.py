"""Whether a train that stands before a signal is in the way of its own route, from the track alone."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from interlock.audit.foul import crossed, foul_neighbours
from interlock.audit.walk import Move, Trip, in_rear, steps
from interlock.model.elements import BufferKind, MachineId, NodeId, Position, SectionId
from interlock.model.layout import Layout
from interlock.table.rows import RouteRow


def own_train_in_the_way(layout: Layout, r: RouteRow, trip: Trip) -> Iterator[str]:
    """What of a route can never be had while its train stands before its entry signal."""
    parts = trip.parts
    over = [next(iter(in_rear(layout, trip)), None), *trip.run.sections]
    for z in layout.declared.zones:
        entries = sum(a not in z.sections and b in z.sections for a, b in pairwise(over))
        if entries and entries + (over[0] in z.sections) > z.trains:
            yield f"no room in {z.id}"
    for rear in in_rear(layout, trip):
        taken = {s for p in parts for s in p.sections if s != p.berth}
        taken |= {layout.track.section_of(m.edge) for p in parts for m in p.over}
        if rear in taken:
            yield f"{rear} is taken by its own train"
        ways = _ways_to(layout, trip, rear)
        under = set.intersection(*(w[0] for w in ways)) if ways else set()
        frozen = {p.machine: p.position for p in r.locking.points}
        if any(frozen.get(m, x) is not x for m, x in under):
            yield "its own train stands on points that it needs otherwise"
        held = under | set(frozen.items())
        foul = {(s, w) for p in parts for s, w, *_ in foul_neighbours(layout, p)}
        foul |= {x for p in parts for x in crossed(layout, p, frozen.items())}
        if any(s == rear and (w is None or w in held) for s, w in foul):
            yield f"its own train stands foul of it in {rear}"
        across = set.intersection(*(w[1] for w in ways)) if ways else set()
        if any(m.node in across for p in parts for m in (*p.moves[:-1], *p.over[:-1])):
            yield "its own train stands across its way"


def _ways_to(layout: Layout, trip: Trip, rear: SectionId) -> list[tuple[set[tuple[MachineId, Position]], set[NodeId]]]:
    """For each way on which a train may have come to the signal within the section before it: the machines on which it
    may stand, as they lie then, and the diamonds."""
    start = trip.moves[0]
    node = layout.track.far(start.edge, start.node)
    found = []
    todo: list[tuple[tuple[Move, ...], set[tuple[MachineId, Position]]]] = [
        ((Move(e.id, node),), set()) for e in layout.track.edges_at[node] if e.section == rear
    ]
    while todo:
        moves, under = todo.pop()
        here = moves[-1]
        back = layout.track.far(here.edge, here.node)
        before = [e.id for e in layout.track.edges_at[back] if e.id != here.edge and e.section == rear]
        onward = [
            ((*moves, Move(e, back)), under | ({needs} if needs is not None else set()))
            for e in before
            for m, needs in steps(layout, Move(e, back), against=True)
            if m == here and all(x.edge != e for x in moves)
        ]
        todo += onward
        end = layout.track.buffer_at.get(back)
        if not onward and (
            end is None or end.kind is BufferKind.STOP
        ):  # none comes from off the rails, or out of a trap
            found.append((under, {m.node for m in moves[1:] if m.node in layout.pointwork.crossing_at}))
    return found
