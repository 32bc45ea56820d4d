"""Routes that their own train keeps from being set.

A train that is to run a route stands in the section before its entry signal.  What the route must find free there, it
never finds: round a ring it would end in, or run over, that very section; a foul joint, the crossing of a diamond, or
points under the train may ask for it, too; and a zone may have no room left for a train that is in it already.  Such a
route is refused (IL4016): a table that listed it would promise what no controller can do.  (It is no flank space: R5.)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from interlock.derivation.locks import Locks
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import BufferKind, MachineId, Position, RouteId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import Traversal, topology
from interlock.table.cells import RouteKind
from interlock.table.rows import RouteRow


def check_own_train(layout: Layout, rows: Sequence[RouteRow], locks: Locks, sink: Sink) -> None:
    """IL4016: every route that is never free while its train stands before its signal; those of one signal that have
    the same cause together."""
    row = {r.id: r for r in rows}
    found: dict[tuple[SignalId, bool, str, str], list[RouteRow]] = {}
    for r in rows:
        if r.kind is RouteKind.IDENTIFIER:
            continue  # it is set with a route that leads to its signal, and asked about with that one
        parts = _parts(r, row)
        first = next(_in_its_way(layout, parts, locks), None)
        if first is not None:
            found.setdefault((r.entry, r.kind is RouteKind.SHUNT, *first), []).append(r)
    for (signal, shunt, why, fix), those in found.items():
        many = len(those) > 1
        which = f"route{'s' if many else ''} {', '.join(r.id for r in those)}"
        text = f"{which} can never be set: {why}"
        last = _parts(those[0], row)[-1]
        kind = "shunt" if shunt else "main"
        barred = f"{{from: {signal}, to: {last.exit}, via: [{last.path.section_ids[-1]}], kind: {kind}, reason: ...}}"
        sink.add(
            "IL4016",
            text,
            None,
            f"{fix}, or exclude {'them' if many else 'it'}: `exclude: [{barred}]`",
            about=Element("signals", signal),
        )


def _parts(r: RouteRow, row: Mapping[RouteId, RouteRow]) -> list[RouteRow]:
    """A route, and what is set with it past one signal after the other."""
    return [r] if r.path.onward is None else [r, *_parts(row[r.path.onward], row)]


def _in_its_way(layout: Layout, parts: Sequence[RouteRow], locks: Locks) -> Iterator[tuple[str, str]]:
    """Why a route is not free while its train stands before its signal, and what would help; nothing where it is."""
    r, topo = parts[0], topology(layout)
    rear = topo.beyond(r.path.section_ids[0], r.path.entry_node)
    for c in r.conditions.zones:  # of all that is set with it
        zone = next(z for z in layout.declared.zones if z.id == c.zone)
        if c.entries > zone.trains - (rear in zone.sections):
            train = f"its train stands in it before {r.entry}" if rear in zone.sections else "its train comes in twice"
            yield f"{called('zone', c.zone)} has room for {zone.trains}, and {train}", f"raise the maximum of {c.zone}"
    if rear is None:
        return
    stands = f"its train stands before {r.entry} in {rear}"
    for why, fix in _in_rear(layout, parts, rear, locks):
        yield f"{stands}, and {why}", fix


def _in_rear(layout: Layout, parts: Sequence[RouteRow], rear: SectionId, locks: Locks) -> Iterator[tuple[str, str]]:
    """What a route asks for that a train in the section before its signal is in the way of."""
    r = parts[0]
    apart = f"divide {rear} by a joint, so that the train stands clear"
    if any(rear in p.path.section_ids and rear != p.path.berth for p in parts):
        yield f"{rear} must be free for its way", f"let the way end before {rear}, at a signal or board further back"
    if any(rear == s for p in parts if p.locking.overlap for s, _ in p.locking.overlap.ways):
        yield f"{rear} must be free for its overlap", f"shorten the overlap of {parts[-1].exit}"
    under = _under(layout, rear, r)
    held = {**under, **{p.machine: p.position for x in parts for p in x.locking.points}}
    for m, x in held.items():
        if under.get(m, x) is not x:
            yield f"machine {m}, on which it stands, must lie {x}", apart
    for f in (f for p in parts for f in p.clear.foul):
        if f.section == rear and (f.when is None or held.get(f.when[0]) is f.when[1]):
            yield f"{rear} must be free: {f.because.text}", "move the joint out of the fouling point"
    came = [t for t in topology(layout).traversals[rear] if r.path.entry_node in (t.entry, t.exit)]
    stands = {t.number for t in came if t.key in locks}
    taken = [key for p in parts for key in (*p.path.traversals, *(p.locking.overlap.ways if p.locking.overlap else ()))]
    for ex in (ex for key in taken for ex in locks[key].exclusions):
        if ex.section == rear and (ex.whole or (stands and stands <= {*ex.numbers})):
            yield f"{rear} must be free: {ex.because.text}", apart


def _under(layout: Layout, rear: SectionId, r: RouteRow) -> Mapping[MachineId, Position]:
    """The machines on which the train stands whichever way it came to the signal, and how they lie then: from off the
    rails, and out of a trap, none comes."""
    nowhere = {n for n, b in layout.track.buffer_at.items() if b.kind is not BufferKind.STOP}
    ways = [t for t in topology(layout).traversals[rear] if not nowhere & {t.entry, t.exit}]
    came = [_machines(layout, t) for t in ways if r.path.entry_node in (t.entry, t.exit)]
    return dict(set.intersection(*came)) if came else {}


def _machines(layout: Layout, t: Traversal) -> set[tuple[MachineId, Position]]:
    return {(layout.pointwork.point[p].machine, x) for p, x in t.points}
