"""Derailers and trap points that no route lays where they protect: they stand the wrong way round, or behind a
signal (R5).

Warning IL7016.  Only those are told of to which a flank leads: what none leads to may be worked for itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from interlock.dataclass import dataclass
from interlock.derivation.added import Demands
from interlock.derivation.flank import Requester, end_of_leg, requesters
from interlock.derivation.locks import Locks
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import BufferKind, EdgeId, MachineId, NodeId, Point, Position, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import onward_edges, runaways, topology
from interlock.table.cells import Provider, ProviderKind


@dataclass(frozen=True)
class _Met:
    """A point to which one comes from a place that asks for protection; from its toe, or over the leg from which it
    turns vehicles away.  between: the signal past which one came."""

    flank: str
    toe: bool
    between: SignalId | None


def check_protecting(layout: Layout, demands: Demands, locks: Locks, sink: Sink) -> None:
    """Report derailers and trap points that no route demands, where no error hides routes."""
    laid = {(d.machine, d.position) for those in demands.values() for d in those}
    idle = {p.node: (p, x) for p, x in _protecting(layout) if (p.machine, x) not in laid}
    if sink.has_errors or not idle:
        return
    met: dict[NodeId, dict[_Met, None]] = {}
    known: set[tuple[NodeId, EdgeId, float]] = set()
    for row in locks.values():
        cells = {c.requester: c.providers for c in row.flank}
        for r in requesters(layout, topology(layout).traversals[row.section][row.number - 1]):
            if r.name in cells and r.waiver is None and (r.node, r.edge, r.clear_of) not in known:
                known.add((r.node, r.edge, r.clear_of))
                for node, found in _outward(layout, r, cells[r.name], idle):
                    met.setdefault(node, {})[found] = None
    for node, those in met.items():
        _report(layout, *idle[node], list(those), sink)


def _protecting(layout: Layout) -> Iterator[tuple[Point, Position]]:
    """Derailers, and points one of whose legs leads over plain track to a trap, with the position that protects."""
    for p in layout.pointwork.points:
        for x in Position:
            end = layout.track.buffer_at.get(end_of_leg(layout, p, x))
            if end is not None and end.kind in (BufferKind.TRAP, BufferKind.DERAIL):
                yield p, x


def _outward(
    layout: Layout, r: Requester, providers: Sequence[Provider], idle: Mapping[NodeId, tuple[Point, Position]]
) -> Iterator[tuple[NodeId, _Met]]:
    """The idle points to which one comes from a requester, no further than to what protects it; past a signal over
    plain track alone."""
    turned = {(MachineId(p.name), p.position) for p in providers if p.kind is ProviderKind.POINT}
    todo: list[tuple[EdgeId, NodeId, float, SignalId | None]] = [(r.edge, r.node, 0.0, None)]
    seen = set[tuple[EdgeId, NodeId]]()
    while todo:
        edge, node, gone, past = todo.pop()
        e = layout.track.edge[edge]
        if (edge, node) in seen or (e.nothing_comes_to(node) and (edge, node) not in runaways(layout)):
            continue
        seen.add((edge, node))
        far, gone = layout.track.far(edge, node), gone + e.length
        point = layout.pointwork.point_at.get(far)
        position = None if point is None else point.position_of(edge)
        if far in idle:
            if position is not idle[far][1]:
                yield far, _Met(r.name, position is None, past)
            continue
        signal = layout.signalling.facing.get((far, edge))
        if far == r.node or (past is not None and (signal is not None or point is not None)):
            continue
        if point is not None and position is not None and (point.machine, position.other) in turned:
            continue
        if signal is not None and gone >= r.clear_of:
            past = signal.id
        todo += [(x, far, gone, past) for x in onward_edges(layout, far, edge)]


_WORD = {Position.NORMAL: "normal", Position.REVERSE: "reverse"}


def _report(layout: Layout, p: Point, x: Position, met: Sequence[_Met], sink: Sink) -> None:
    """Say which of the slips it is; nothing where it is none of them."""
    before, turned = [m for m in met if not m.toe and m.between is not None], [m for m in met if m.toe]
    if before:
        signal = str(before[0].between)
        why = f"{called('signal', signal)} stands between it and {before[0].flank}, and is trusted instead"
        fix = f"set {signal} further out than {p.id}, or have the routes that need it lay {p.id}: `demand`"
    elif turned and all(m.toe for m in met) and (p.derailer or not _to_boundary(layout, p, x.other)):
        goes, comes = ("throws off", "derail") if p.derailer else ("leads into the trap", "catch")
        why = f"seen from {turned[0].flank} it is the wrong way round, and {goes} what runs out from there, "
        why += "not what comes in"
        ends = "`inner` and `outer`" if p.derailer else f"`toe` and `{_WORD[x.other]}`"
        fix = f"to {comes} what comes in, exchange {ends} of {p.id}"
    else:
        return
    what = f"derailer {p.id} is laid on" if p.derailer else f"{called('point', p.id)} is laid towards its trap"
    said = f"{what} by no route, so that it protects nothing: {why}"
    sink.add("IL7016", said, None, fix, about=Element("points", p.id))


def _to_boundary(layout: Layout, p: Point, x: Position) -> bool:
    """Whether trains run on over a leg to a boundary: then the trap is for those that come to its toe."""
    todo, seen = [(p.leg(x), p.node)], set[tuple[EdgeId, NodeId]]()
    while todo:
        edge, node = todo.pop()
        if (edge, node) not in seen:
            seen.add((edge, node))
            far = layout.track.far(edge, node)
            if far in layout.track.boundary_at:
                return True
            todo += [(e, far) for e in onward_edges(layout, far, edge)]
    return False
