"""Inclined lanes beyond the ends of routes: what runs away from there meets a train head-on (R5).

Warning IL7019.  Protection is asked for beside a way, not beyond its end.  What keeps wagons off there is a signal that
faces them, or a derailer or point that the route has turned away; an overlap moves the end on, since it is clear.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from interlock.dataclass import dataclass
from interlock.derivation.added import Demands
from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import BufferKind, EdgeId, MachineId, NodeId, Point, Position, SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import Traversal, onward_edges

SHOWN = 3
"""So many routes are named."""


@dataclass(frozen=True)
class _Lane:
    """An inclined lane that is met beyond the end of a route: over which sections, and over which point from a leg,
    which would keep wagons off in the other position, and may be demanded there."""

    section: SectionId
    over: tuple[SectionId, ...] = ()
    point: tuple[Point, Position] | None = None


def check_runaways(layout: Layout, paths: Sequence[Path], demands: Demands, sink: Sink) -> None:
    """Report routes to whose ends wagons may run from an inclined lane, where no error hides routes."""
    if sink.has_errors or not any(e.inclined for e in layout.track.edges):
        return
    met: dict[tuple[SectionId, str], tuple[_Lane, list[Path]]] = {}
    for p in paths:
        last = p.parts[-1]
        ways = (*p.run, *last.overlap)
        laid = {(d.machine, d.position) for q in p.parts for d in demands[q.id]}
        for lane in _lanes(layout, ways[-1], {t.section for t in ways}, laid):
            met.setdefault((lane.section, last.exit), (lane, []))[1].append(p)
    for (_, end), (lane, those) in met.items():
        _report(lane, end, those, sink)


def _lanes(
    layout: Layout, end: Traversal, own: Collection[SectionId], laid: Collection[tuple[MachineId, Position]]
) -> Iterator[_Lane]:
    """The first inclined lanes from which wagons come to the end of a way.  `own`: what is clear for the route; `laid`:
    how it has machines lie."""
    faced = layout.signalling.facing
    todo: list[tuple[EdgeId, NodeId, _Lane]] = []
    if (end.exit, end.edges[-1]) not in faced:
        start = _Lane(end.section)
        todo = [(x, end.exit, start) for x in onward_edges(layout, end.exit, end.edges[-1])]
    seen, found = set[tuple[EdgeId, NodeId]](), set[SectionId]()
    while todo:
        edge, node, met = todo.pop()
        e = layout.track.edge[edge]
        if (edge, node) in seen or e.section in own:
            continue
        seen.add((edge, node))
        if e.inclined:
            if e.section not in found and not _caught(layout, edge, node):
                found.add(e.section)
                yield _Lane(e.section, met.over, met.point)
            continue
        far = layout.track.far(edge, node)
        point = layout.pointwork.point_at.get(far)
        position = None if point is None else point.position_of(edge)
        turned = None if point is None or position is None else (point, position.other)
        if (far, edge) in faced or (turned is not None and (turned[0].machine, turned[1]) in laid):
            continue
        demanded = turned if turned is not None and _may_lie(layout, *turned) else None
        onward = _Lane(met.section, tuple(dict.fromkeys((*met.over, e.section))), met.point or demanded)
        todo += [(x, far, onward) for x in onward_edges(layout, far, edge)]


def _may_lie(layout: Layout, point: Point, position: Position) -> bool:
    """Whether a route may demand a point in a position: one that is worked by hand is locked in normal only (R10)."""
    return position is Position.NORMAL or point.machine not in layout.machines.by_hand


def _caught(layout: Layout, edge: EdgeId, node: NodeId) -> bool:
    """Whether a lane leads to nothing but traps, so that nothing is brought there."""
    section, todo, seen = layout.track.edge[edge].section, [(edge, node)], set[tuple[EdgeId, NodeId]]()
    while todo:
        here = todo.pop()
        if here in seen:
            continue
        seen.add(here)
        far = layout.track.far(*here)
        buffer, onward = layout.track.buffer_at.get(far), onward_edges(layout, far, here[0])
        if (buffer is None and not onward) or (buffer is not None and buffer.kind is not BufferKind.TRAP):
            return False
        if any(layout.track.section_of(x) != section for x in onward):
            return False
        todo += [(x, far) for x in onward]
    return True


def _report(lane: _Lane, end: str, those: Sequence[Path], sink: Sink) -> None:
    names = [p.id for p in those[:SHOWN]]
    routes = " and ".join(names) if len(those) <= SHOWN else f"{', '.join(names)} and {len(those) - SHOWN} more"
    over = f"over {', '.join(lane.over)}" if lane.over else "at once"
    fix = (
        f"between {lane.section} and {end} put a signal that faces them, or a derailer or a point before a trap, which "
    )
    fix += "the routes have turned away by a `demand`"
    if lane.point is not None:
        p, x = lane.point
        fix += f"; or have {p.id} turned away: `demand: [{{point: {p.id}, lies: {_WORD[x]}, "
        fix += f"routes: {{to: {end}}}, reason: runaways from {lane.section}}}]`"
    sink.add(
        "IL7019",
        f"wagons that run away from {called('section', lane.section)}, an inclined lane, come {over} to {end} and meet "
        f"a train head-on that comes there by {routes}: no signal, derailer or point turned away keeps them off",
        None,
        fix,
        about=Element("sections", lane.section),
    )


_WORD = {Position.NORMAL: "normal", Position.REVERSE: "reverse"}
