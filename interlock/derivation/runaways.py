"""Inclined lanes and tracks behind derailers from which nothing, or nothing but a signal, keeps wagons off (R5).

Warning IL7019: beyond the end of a route, where no rule asks for protection, what runs away meets a train head-on.
What keeps wagons off there is a signal that faces them, or a derailer or point that the route has turned away; an
overlap moves the end on, since it is clear.  A derailer that no route lays does not: it is off after the last movement
over it, and it was put there because vehicles roll from behind it.

Warning IL7020: beside a way the protection is a signal alone.  The proof trusts it (A-STANDS), wagons do not read it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from interlock.dataclass import dataclass
from interlock.derivation.added import Demands
from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import BufferKind, EdgeId, MachineId, NodeId, Point, Position, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import Traversal, onward_edges
from interlock.table.cells import ProviderKind
from interlock.table.rows import RouteRow

SHOWN = 3
"""So many routes are named."""


@dataclass(frozen=True)
class _Lane:
    """An inclined lane that is met beyond the end of a route, or a track behind a derailer: over which sections, and
    over which point from a leg, which would keep wagons off in the other position, and may be demanded there."""

    section: SectionId
    over: tuple[SectionId, ...] = ()
    point: tuple[Point, Position] | None = None
    derailer: Point | None = None


def check_runaways(layout: Layout, paths: Sequence[Path], demands: Demands, sink: Sink) -> None:
    """Report routes to whose ends wagons may run from an inclined lane or from behind a derailer, where no error hides
    routes."""
    rolls = any(e.inclined for e in layout.track.edges) or any(p.derailer for p in layout.pointwork.points)
    if sink.has_errors or not rolls:
        return
    met: dict[tuple[SectionId, str], tuple[_Lane, list[Path]]] = {}
    for p in paths:
        last = p.parts[-1]
        ways = (*p.run, *last.overlap)
        laid = {(d.machine, d.position) for q in p.parts for d in demands[q.id]}
        for lane in _lanes(layout, _from_end(layout, ways[-1]), {t.section for t in ways}, laid):
            met.setdefault((lane.section, last.exit), (lane, []))[1].append(p)
    for (_, end), (lane, those) in met.items():
        _report(lane, end, those, sink)


def check_signals_alone(layout: Layout, rows: Sequence[RouteRow], sink: Sink) -> None:
    """Report places beside routes without a condition that a signal alone guards from an inclined lane."""
    if sink.has_errors or not any(e.inclined for e in layout.track.edges):
        return
    met: dict[tuple[SectionId, str, str], list[RouteRow]] = {}
    for r in rows:
        laid = {(d.machine, d.position) for d in r.locking.points}
        own = {x.section for x in r.clear.sections}
        held = [(c, p.name) for c in r.locking.flank for p in c.providers if p.kind is ProviderKind.SIGNAL]
        for cell, signal in () if r.conditions.external else held:
            s = layout.signalling.signal[SignalId(signal)]
            for lane in _lanes(layout, _onward(layout, s.into, s.node), own, laid):
                if lane.derailer is None:
                    met.setdefault((lane.section, signal, cell.requester), []).append(r)
    for (section, signal, place), those in met.items():
        _report_alone(section, signal, place, those, sink)


_Start = tuple[EdgeId, NodeId, _Lane]


def _onward(layout: Layout, edge: EdgeId, node: NodeId) -> list[_Start]:
    """The edges that lead on from where an edge ends at a node."""
    start = _Lane(layout.track.section_of(edge))
    return [(x, node, start) for x in onward_edges(layout, node, edge)]


def _from_end(layout: Layout, end: Traversal) -> list[_Start]:
    """The edges beyond the end of a way, where no signal faces what comes from there."""
    if (end.exit, end.edges[-1]) in layout.signalling.facing:
        return []
    return _onward(layout, end.edges[-1], end.exit)


def _lanes(
    layout: Layout, starts: Sequence[_Start], own: Collection[SectionId], laid: Collection[tuple[MachineId, Position]]
) -> Iterator[_Lane]:
    """The first inclined lanes from which wagons come, with no signal in between, and the tracks behind derailers that
    are not laid on.  `own`: what is clear for the route; `laid`: how it has machines lie."""
    faced, todo = layout.signalling.facing, list(starts)
    seen, found, rolled = set[tuple[EdgeId, NodeId]](), set[SectionId](), set[SectionId]()
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
        if point is not None and turned is not None and point.derailer:
            for section, over in _behind(layout, far, edge, own, laid):
                if section not in rolled:
                    rolled.add(section)
                    yield _Lane(section, tuple(dict.fromkeys((*onward.over, *over))), onward.point, point)


def _behind(
    layout: Layout, node: NodeId, edge: EdgeId, own: Collection[SectionId], laid: Collection[tuple[MachineId, Position]]
) -> Iterator[tuple[SectionId, tuple[SectionId, ...]]]:
    """Where vehicles are left behind a derailer, to which one comes over an edge, with no signal in between: the ends
    of tracks, rings and boundaries (an inclined lane is told for itself), and the sections before."""
    first = frozenset({node})
    todo: list[tuple[EdgeId, NodeId, frozenset[NodeId], tuple[SectionId, ...]]]
    todo = [(x, node, first, ()) for x in onward_edges(layout, node, edge)]
    seen = set[tuple[EdgeId, NodeId, frozenset[NodeId]]]()
    while todo:
        here, near, path, over = todo.pop()
        e, far = layout.track.edge[here], layout.track.far(here, near)
        if (here, near, path) in seen or e.section in own or e.inclined or (far, here) in layout.signalling.facing:
            continue
        seen.add((here, near, path))
        buffer, point = layout.track.buffer_at.get(far), layout.pointwork.point_at.get(far)
        stand = buffer is not None and buffer.kind is BufferKind.STOP
        if stand or far in path or far in layout.track.boundary_at:
            yield e.section, tuple(s for s in over if s != e.section)
            continue
        position = None if point is None else point.position_of(here)
        if point is None or position is None or (point.machine, position.other) not in laid:
            todo += [(x, far, path | {far}, (*over, e.section)) for x in onward_edges(layout, far, here)]


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


def _some(those: Sequence[Path] | Sequence[RouteRow]) -> str:
    names = [p.id for p in those[:SHOWN]]
    return " and ".join(names) if len(those) <= SHOWN else f"{', '.join(names)} and {len(those) - SHOWN} more"


def _report_alone(section: SectionId, signal: str, place: str, those: Sequence[RouteRow], sink: Sink) -> None:
    text = (
        f"nothing but signal {signal} at stop keeps wagons that run away from {called('section', section)}, an "
        f"inclined lane, off {place}, beside {_some(those)}: wagons pass a signal"
    )
    entries = ", ".join(dict.fromkeys(r.entry for r in those))
    fix = (
        f"between {section} and {place} put a derailer, or a point before a trap; or state what keeps wagons on the "
        f"lane as a condition of these routes: `conditions: {{HOIST: {{text: hoist stopped, signals: [{entries}]}}}}`"
    )
    sink.add("IL7020", text, None, fix, about=Element("sections", section))


def _report(lane: _Lane, end: str, those: Sequence[Path], sink: Sink) -> None:
    routes = _some(those)
    over = f"over {', '.join(lane.over)}" if lane.over else "at once"
    section = called("section", lane.section)
    if lane.derailer is None:
        comes = f"wagons that run away from {section}, an inclined lane, come"
        fix = (
            f"between {lane.section} and {end} put a signal that faces them, or a derailer or a point before a trap, "
            "which the routes have turned away by a `demand`"
        )
    else:
        comes = f"vehicles that roll from {section}, behind derailer {lane.derailer.id} while it is off, come"
        fix = f"between {lane.section} and {end} put a signal that faces them"
    if lane.point is not None:
        p, x = lane.point
        fix += f"; or have {p.id} turned away: `demand: [{{point: {p.id}, lies: {_WORD[x]}, "
        fix += f"routes: {{to: {end}}}, reason: runaways from {lane.section}}}]`"
    sink.add(
        "IL7019",
        f"{comes} {over} to {end} and meet a train head-on that comes there by {routes}: no signal, derailer or point "
        "turned away keeps them off",
        None,
        fix,
        about=Element("sections", lane.section),
    )


_WORD = {Position.NORMAL: "normal", Position.REVERSE: "reverse"}
