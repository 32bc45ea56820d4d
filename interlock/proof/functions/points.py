"""Points and devices: commands, and what counts as trailed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from interlock.logic.controller import RouteSymbols
from interlock.logic.expr import Expr, conj, disj, iff, implies, neg, var
from interlock.model.elements import MachineId, Position, SignalId
from interlock.proof.functions.words import Way, Words


def points(w: Words) -> Iterator[tuple[str, str, Expr]]:
    """F-TRAILED, F-POINT and F-TURN."""
    for m, name in w.sym.trailed.items():
        there = disj(conj((w.commanded(m, x), w.detected(m, x))) for x in Position)
        lost = disj(conj((w.commanded(m, x), neg(w.detected(m, x)))) for x in Position)
        was, quiet, trailed = var(w.sym.seen_right[m]), neg(w.anew(m)), var(name)
        seen = conj((var(w.sym.looked_at[m]), w.valid, *(w.long(s) for s in w.layout.sections_of_machine[m])))
        new = conj((was, w.valid, lost, quiet))
        yield "F-TRAILED", f"{m} detected", iff(w.after(was), conj((there, quiet)))
        yield "F-TRAILED", m, iff(w.after(trailed), disj((new, conj((trailed, neg(seen))))))
    for m in w.layout.machines:
        yield from _commands(w, m)
    if w.sym.started is not None and w.sym.start_timer is not None:
        yield from _starts(w, var(w.sym.started), var(w.sym.start_timer))


def _starts(w: Words, last: Expr, gap: Expr) -> Iterator[tuple[str, str, Expr]]:
    """`last`: a machine started in the last scan; `gap`: the time that must lie between two starts is over."""
    before: list[Expr] = []
    starting = []
    for m, name in w.sym.turn.items():
        runs = var(name)
        missing = disj(conj((w.commanded(m, x), neg(w.detected(m, x)))) for x in Position)
        waits = conj((missing, neg(runs)))
        begins = conj((waits, gap, neg(disj(before))))
        yield "F-TURN", m, iff(w.after(runs), conj((disj((runs, begins)), missing, neg(w.anew(m)))))
        before.append(waits)
        starting.append(begins)
    yield "F-TURN", "last", iff(w.after(last), disj(starting))


def _commands(w: Words, m: MachineId) -> Iterator[tuple[str, str, Expr]]:
    nothing_set = conj(neg(w.set_now(r)) for r in _touching(w, m))
    no_overlap = conj(neg(w.rises(var(w.sym.overlap[o]))) for o in _overlaps_touching(w, m))
    both = conj((nothing_set, no_overlap, *(var(w.sym.by_hand[m, x]) for x in Position)))
    yield "F-POINT", f"{m} both by hand", implies(both, neg(w.anew(m)))
    for x in Position:
        command, other = w.commanded(m, x), w.commanded(m, x.other)
        key, opposite = var(w.sym.by_hand[m, x]), var(w.sym.by_hand[m, x.other])
        permitted = conj(()) if w.closing(m, x) else conj((w.movable(m), nothing_set))
        turned = conj((key, neg(opposite), permitted))
        yield "F-POINT", f"{m} {x} by hand", implies(turned, w.after(command))
        yield "F-POINT", f"{m} {x} stays", implies(w.ends(command), w.after(other))
        if m in w.layout.device and x is Position.NORMAL:
            back = conj((w.movable(m), nothing_set, neg(opposite)))
            yield "F-POINT", f"{m} returns", implies(back, w.after(command))
        demanded = [
            w.set_now(r)
            for r in w.sym.routes
            for way in (*r.ways, *(w.sym.overlap_ways[r.overlap] if r.overlap is not None else ()))
            if (m, x) in w.sym.demands[way]
        ]
        demanded += [w.set_now(r) for r in w.sym.routes if (m, x) in r.demands]
        yield "F-POINT", f"{m} {x} by a route", implies(disj(demanded), w.after(command))


def _touches(w: Words, m: MachineId, ways: Iterable[Way]) -> bool:
    return any(way[0] in w.layout.sections_of_machine[m] or way in w.flanks(m) for way in ways)


def _touching(w: Words, m: MachineId) -> list[RouteSymbols]:
    """The routes that lock a section of a machine, or demand it: while one is set, it is not moved otherwise (R10)."""

    def over(r: RouteSymbols) -> Iterator[Way]:
        yield from r.ways
        yield from () if r.berth is None else (r.berth,)
        yield from () if r.overlap is None else w.sym.overlap_ways[r.overlap]

    return [r for r in w.sym.routes if _touches(w, m, over(r)) or any(m == n for n, _ in r.demands)]


def _overlaps_touching(w: Words, m: MachineId) -> list[tuple[SignalId, int]]:
    """The overlaps that lie over a machine, or demand it."""
    return [o for o, ways in w.sym.overlap_ways.items() if _touches(w, m, ways)]
