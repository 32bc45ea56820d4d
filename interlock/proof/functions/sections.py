"""Sections: what is remembered of trains, and when each is released."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, iff, implies, neg, var
from interlock.model.elements import SectionId
from interlock.proof.claims.reasons import first_behind, in_order
from interlock.proof.functions.words import Words


def sections(w: Words) -> Iterator[tuple[str, str, Expr]]:
    """F-USED to F-MODE and F-RELEASE."""
    for s in w.topo.sections:
        yield from _memory(w, s)
        released = conj((w.f.locking.locked(s), disj(_releasing(w, s))))
        yield "F-RELEASE", s, iff(w.ends(w.f.locking.locked(s)), released)


def _memory(w: Words, s: SectionId) -> Iterator[tuple[str, str, Expr]]:
    f, after = w.f, w.after
    yield "F-USED", s, iff(w.rises(f.seen.used(s)), disj(w.sections.coming_in(s, j) for j in w.topo.ends[s]))
    ahead = []
    for j in w.topo.ends[s]:
        t = w.topo.beyond(s, j)
        if t is not None:
            ahead.append(w.sections.coming_in(t, j))
    gone = conj((neg(f.seen.passed(s)), f.seen.used(s), w.sections.occupied(s), disj(ahead)))
    yield "F-PASSED", s, iff(w.rises(f.seen.passed(s)), gone)
    over = [r for r in w.sym.routes if any(x == s for x, _ in r.path.ways)]
    called = disj(w.signals.set_now(r) for r in over if r.call_on)
    lost = conj((neg(f.seen.stale(s)), disj((conj((neg(w.valid), f.locking.any_lock(s))), called))))
    yield "F-STALE", s, iff(w.rises(f.seen.stale(s)), lost)
    firm = [w.rises(var(r.locked)) for r in over]
    firm += [
        conj((w.rises(var(r.locked)), f.locking.any_lock(s)))
        for r in w.sym.routes
        if r.path.berth is not None and r.path.berth[0] == s
    ]
    yield "F-FIRM", s, iff(w.rises(f.locking.firm(s)), conj((neg(f.locking.firm(s)), disj(firm))))
    kept = [f.seen.used(s), f.seen.passed(s), f.seen.stale(s), f.locking.firm(s)]
    if s in w.sym.cancellation.at_once:
        at_once = var(w.sym.cancellation.at_once[s])
        new = conj((neg(at_once), w.rises(f.seen.used(s)), read_ahead(w, s)))
        yield "F-PASSED", f"{s} at once", iff(w.rises(at_once), new)
        kept.append(at_once)
    if s in w.sym.cancellation.rear_cleared:
        cleared = var(w.sym.cancellation.rear_cleared[s])
        seen, alone = conj((f.seen.used(s), _whole(w, s))), conj(w.sections.none_set_into(s))
        held = conj((disj((cleared, seen)), alone, after(f.locking.locked(s))))
        yield "F-PASSED", f"{s} come in", iff(after(cleared), held)
    if f.track.shunts:
        mode = f.locking.train(s)
        trains = disj(w.signals.set_now(r) for r in over if not r.shunt)
        yield "F-MODE", s, iff(w.rises(mode), conj((neg(mode), trains)))
        if w.sections.ends_shunts(s):
            here = conj((w.sections.arrived(s), *_ends_here(w, s)))
            yield "F-MODE", f"{s} arrived", implies(here, neg(after(mode)))
            yield "F-MODE", f"{s} stays", implies(conj((w.ends(mode), after(f.locking.locked(s)))), here)
        else:
            kept.append(mode)
    for x in kept:
        yield "F-RELEASE", f"{s} {x}", implies(conj((x, after(f.locking.locked(s)))), after(x))
        yield "F-RELEASE", f"{s} {x} forgotten", implies(w.ends(f.locking.locked(s)), neg(after(x)))


def read_ahead(w: Words, s: SectionId) -> Expr:
    """What is next on the way for which a section is locked reads occupied."""
    found = []
    for n, lock in w.f.locking.of(s):
        b = w.topo.beyond(s, w.f.track.way(s, n)[1])
        found += [] if b is None else [conj((lock, w.sections.occupied(b)))]
    return disj(found)


def _ends_here(w: Words, s: SectionId) -> Iterator[Expr]:
    """The train does not go on into the next section."""
    for j in w.topo.ends[s]:
        t = w.topo.beyond(s, j)
        if t is not None and not w.sections.main_at(t, j):
            yield neg(conj((w.f.locking.locked_out(s, j), w.f.locking.locked_in(t, j), w.sections.on(t, j, s))))
    for r in w.sym.routes:
        if r.path.identifier and w.sym.cancellation.approach_of[r.entry] == s:
            yield neg(var(r.proceed))


def _releasing(w: Words, s: SectionId) -> Iterator[Expr]:
    """Why a section is released."""
    f, sym = w.f, w.sym
    long, rear, closed = w.sections.long(s), w.sections.rear_released(s), w.sections.closed(s)
    yield conj((w.valid, f.seen.used(s), long, closed, rear, disj((_passed_on(w, s), *_left(w, s)))))  # R9
    inside = []
    hand = disj((var(sym.sections.release[s]), conj((var(sym.sections.release_all), f.seen.stale(s)))))
    by_hand = [w.valid, long, closed, rear, hand, f.locking.any_lock(s)]
    for j in w.topo.ends[s]:
        locked, g = f.locking.locked_in(s, j), w.sections.signal_at(s, j)
        if not w.sections.main_at(s, j) and w.topo.beyond(s, j) is not None:
            inside.append(conj((locked, TRUE if g is None else f.locking.train(s))))
        if g is not None and locked is not FALSE:
            yield w.signals.given_up(g)
            by_hand.append(disj((neg(locked), conj((neg(w.signals.active(g)), w.signals.safe(g))))))
    yield conj((w.valid, long, neg(f.seen.used(s)), disj(inside), rear))  # withdrawn, R8
    yield conj(by_hand)
    operator = disj((var(sym.sections.release[s]), var(sym.sections.release_all)))
    vehicles = rear if w.sections.ends_shunts(s) else TRUE
    yield conj((w.valid, long, f.locking.restart(s), var(sym.start.restart_timer), operator, vehicles))  # R16


def _whole(w: Words, s: SectionId) -> Expr:
    """A movement was seen to have come in: nobody else is reported on the way to the signal, which has closed, or it
    was there alone (R9)."""
    seen = [conj((locked, w.signals.nobody(g, FALSE), neg(w.signals.passing(g)))) for g, locked in first_behind(w.f, s)]
    for g, locked in in_order(w.f, s):
        rear = w.sections.rear(s, w.layout.signalling.signal[g].node)
        told = rear is not None and rear not in w.layout.track.undetected
        alone = var(w.sym.cancellation.alone[s])
        seen.append(conj((locked, disj((alone, w.signals.nobody(g, FALSE) if told else FALSE)))))
    return disj(seen)


def _passed_on(w: Words, s: SectionId) -> Expr:
    """A train has gone on, and its approach was seen clear since, or nobody can be about to pass its signal."""
    if s not in w.sym.cancellation.rear_cleared:
        return w.f.seen.passed(s)
    begun = (*first_behind(w.f, s), *in_order(w.f, s))
    safe = (disj((neg(locked), w.signals.safe(g))) for g, locked in begun)
    return conj((w.f.seen.passed(s), disj((var(w.sym.cancellation.rear_cleared[s]), conj(safe)))))


def _left(w: Words, s: SectionId) -> Iterator[Expr]:
    """A train has left over a boundary, or gone among standing vehicles, and none is about to follow it (R9)."""
    for n, lock in w.f.locking.of(s):
        entry, exit_ = w.f.track.way(s, n)
        g = w.sections.signal_at(s, entry)
        alone = TRUE if g is None else w.signals.safe(g)
        if exit_ in w.layout.track.boundary_at:
            yield conj((lock, alone))
        yield conj((w.sections.into_berth(s, n), w.sections.occupied(w.topo.beyond(s, exit_)), alone))
