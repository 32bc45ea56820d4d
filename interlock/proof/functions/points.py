"""Points and devices: commands, and what counts as trailed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from interlock.logic.expr import TRUE, Expr, conj, disj, iff, implies, neg, var
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import MachineId, Position, SignalId
from interlock.model.machines import other_doors
from interlock.proof.functions.words import Way, Words


def points(w: Words) -> Iterator[tuple[str, str, Expr]]:
    """F-TRAILED, F-POINT, F-OFF and F-TURN."""
    for m, name in w.sym.machines.trailed.items():
        quiet, trailed, over = neg(w.points.anew(m)), var(name), var(w.sym.start.restart_timer)
        seen = conj(
            (var(w.sym.machines.looked_at[m]), w.valid, *(w.sections.long(s) for s in w.layout.machines.sections[m]))
        )
        lost = []
        for x in Position:
            was, detected = var(w.sym.machines.was_detected[m, x]), w.points.detected(m, x)
            there = disj((conj((detected, neg(w.points.commanded(m, x.other)))), conj((was, neg(w.valid)))))
            yield "F-TRAILED", f"{m} detected {x}", iff(w.after(was), conj((there, quiet, over)))
            lost.append(conj((was, neg(detected))))
        new = conj((disj(lost), w.valid, quiet))
        yield "F-TRAILED", m, iff(w.after(trailed), disj((new, conj((trailed, neg(seen))))))
    for m in w.layout.machines:
        yield from _commands(w, m)
    for m, name in w.sym.machines.kept_off.items():
        free, off = w.points.unblocked(m), var(name)
        blocked = conj((neg(free), neg(w.points.swings(m))))
        ready, hand, kept = conj((free, _clear(w, m))), _by_hand(w, m), w.after(off)
        stays = conj((off, disj((neg(ready), _untouched(w, m)))))
        commanded = conj((ready, disj(x for at in Position for x in _demanding(w, m, at))))
        yield "F-OFF", m, implies(conj((disj((blocked, stays)), neg(hand))), kept)
        yield "F-OFF", f"{m} at last", implies(kept, conj((disj((blocked, off)), neg(hand), neg(commanded))))
    if w.sym.machines.started is not None and w.sym.machines.start_timer is not None:
        yield from _starts(w, var(w.sym.machines.started), var(w.sym.machines.start_timer))


def _starts(w: Words, last: Expr, gap: Expr) -> Iterator[tuple[str, str, Expr]]:
    """`last`: a machine started in the last scan; `gap`: the time that must lie between two starts is over."""
    before: list[Expr] = []
    starting = []
    for m, name in w.sym.machines.turn.items():
        runs = var(name)
        missing = disj(conj((w.points.commanded(m, x), neg(w.points.detected(m, x)))) for x in Position)
        trailed, free = var(w.sym.machines.trailed[m]), disj((w.points.unblocked(m), _by_hand(w, m)))
        off = var(w.sym.machines.kept_off[m])
        waits = conj((missing, neg(runs), _clear(w, m), free, neg(trailed), neg(off)))
        begins = conj((waits, gap, neg(disj(before))))
        yield "F-TURN", m, iff(w.after(runs), conj((disj((runs, begins)), missing, neg(off), neg(w.points.anew(m)))))
        before.append(waits)
        starting.append(begins)
    yield "F-TURN", "last", iff(w.after(last), disj(starting))


def _clear(w: Words, m: MachineId) -> Expr:
    """Inputs are valid, and the sections of a machine are steadily clear."""
    return conj((w.valid, *(w.sections.long(s) for s in w.layout.machines.sections[m])))


def _by_hand(w: Words, m: MachineId) -> Expr:
    """An operator moves a machine in this scan, one way alone, and it is free to move."""
    n, r = (var(w.sym.machines.by_hand[m, x]) for x in Position)
    return conj((disj((n, r)), neg(conj((n, r))), w.points.movable(m), _untouched(w, m)))


def _untouched(w: Words, m: MachineId) -> Expr:
    """No route and no overlap over a machine, or one that demands it, is set or held in this scan."""
    held = (w.rises(var(w.sym.overlaps.held[o])) for o in _overlaps_touching(w, m))
    return conj((*(neg(w.signals.set_now(r)) for r in _touching(w, m)), *map(neg, held)))


def _commands(w: Words, m: MachineId) -> Iterator[tuple[str, str, Expr]]:
    untouched = _untouched(w, m)
    both = conj((untouched, *(var(w.sym.machines.by_hand[m, x]) for x in Position)))
    yield "F-POINT", f"{m} both by hand", implies(both, neg(w.points.anew(m)))
    for x in Position:
        command, other = w.points.commanded(m, x), w.points.commanded(m, x.other)
        key, opposite = var(w.sym.machines.by_hand[m, x]), var(w.sym.machines.by_hand[m, x.other])
        permitted = conj(()) if w.points.closing(m, x) else conj((w.points.movable(m), untouched, *_alone(w, m, x)))
        turned = conj((key, neg(opposite), permitted))
        yield "F-POINT", f"{m} {x} by hand", implies(turned, w.after(command))
        yield "F-POINT", f"{m} {x} stays", implies(w.ends(command), w.after(other))
        if m in w.layout.machines.device and x is Position.NORMAL:
            back = conj((w.points.movable(m), untouched, neg(opposite)))
            yield "F-POINT", f"{m} returns", implies(back, w.after(command))
        yield "F-POINT", f"{m} {x} by a route", implies(disj(_demanding(w, m, x)), w.after(command))


def _alone(w: Words, m: MachineId, x: Position) -> Iterator[Expr]:
    """To open a door of an air lock by hand: the others are shut, and no route, overlap or hand opens one of them."""
    for other in other_doors(w.layout.machines, m) if x is Position.REVERSE else ():
        yield w.points.detected(other, Position.NORMAL)
        yield neg(w.points.commanded(other, x))
        yield _untouched(w, other)
        yield TRUE if m < other else neg(var(w.sym.machines.by_hand[other, x]))


def _demanding(w: Words, m: MachineId, x: Position) -> list[Expr]:
    """The routes that demand a machine in a position: each is set in this scan."""
    found = [
        w.signals.set_now(r)
        for r in w.sym.routes
        for way in (*r.path.ways, *(w.sym.overlaps.ways[r.path.overlap] if r.path.overlap is not None else ()))
        if (m, x) in w.sym.ways.demands[way]
    ]
    return found + [w.signals.set_now(r) for r in w.sym.routes if (m, x) in r.path.demands]


def _touches(w: Words, m: MachineId, ways: Iterable[Way]) -> bool:
    return any(way[0] in w.layout.machines.sections[m] or way in w.points.flanks(m) for way in ways)


def _touching(w: Words, m: MachineId) -> list[RouteSymbols]:
    """The routes that lock a section of a machine, or demand it: while one is set, it is not moved otherwise (R10)."""

    def over(r: RouteSymbols) -> Iterator[Way]:
        yield from r.path.ways
        yield from () if r.path.berth is None else (r.path.berth,)
        yield from () if r.path.overlap is None else w.sym.overlaps.ways[r.path.overlap]

    return [r for r in w.sym.routes if _touches(w, m, over(r)) or any(m == n for n, _ in r.path.demands)]


def _overlaps_touching(w: Words, m: MachineId) -> list[tuple[SignalId, int]]:
    """The overlaps that lie over a machine, or demand it."""
    return [o for o, ways in w.sym.overlaps.ways.items() if _touches(w, m, ways)]
