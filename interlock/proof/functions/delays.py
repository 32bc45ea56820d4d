"""Delays run exactly while their reason holds; after a restart nothing is remembered."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, iff, neg, var
from interlock.logic.names import Name
from interlock.model.elements import Position, SectionId, SignalId
from interlock.model.times import whole_ms
from interlock.proof.claims.reasons import first_behind, in_order
from interlock.proof.functions.routes import kept_longer
from interlock.proof.functions.sections import read_ahead
from interlock.proof.functions.words import Words


def delays(w: Words) -> Iterator[tuple[str, str, Expr]]:
    """F-DELAY."""
    f, sym = w.f, w.sym
    reasons: dict[Name, Expr] = {name: neg(w.sections.occupied(s)) for s, name in sym.sections.release_timer.items()}
    reasons[sym.start.restart_timer] = var(sym.start.running)
    reasons |= {
        name: disj((var(sym.cancellation.cancelling[g]), _waiting(w, g)))
        for g, name in sym.cancellation.approach_timer.items()
    }
    reasons |= {name: _in_it_alone(w, s) for s, name in sym.cancellation.alone.items()}
    for m, name in sym.machines.late_timer.items():
        reasons[name] = disj(conj((w.points.commanded(m, x), neg(w.points.detected(m, x)))) for x in Position)
    for g, name in sym.overlaps.timer.items():
        node = w.layout.signalling.signal[g].node
        before = w.topo.beyond(w.signals.first(g), node)
        assert before is not None
        reasons[name] = conj(
            (w.sections.wholly_in(before), f.locking.locked_out(before, node), w.sections.occupied(before))
        )
    reasons |= {r.path.hold_timer: kept_longer(w, r) for r in sym.routes if r.path.hold_timer is not None}
    if sym.machines.start_timer is not None and sym.machines.started is not None:
        reasons[sym.machines.start_timer] = neg(var(sym.machines.started))
    for x in sym.token.values():
        absent = [neg(var(name)) for name in (x.have, x.give, x.gives, x.has)]
        reasons[x.timer] = conj((w.valid, var(x.manual), var(sym.start.restart_timer), *absent))
    for name, reason in reasons.items():
        yield "F-DELAY", name, iff(var(f.timers[name].input), reason)
    rules = w.layout.principles
    for g, name in sym.cancellation.approach_timer.items():  # whatever routes it has today
        signal = w.layout.signalling.signal[g]
        trains = rules.approach_release_s if signal.main else 0.0
        kind = max(trains, rules.shunt_release_s if signal.shunt else 0.0)
        ordered = dict(w.layout.signalling.releases).get(g, kind)
        yield (
            "F-DELAY",
            f"{name} as its signal's kind",
            TRUE if f.timers[name].preset_ms >= whole_ms(ordered) else FALSE,
        )
    yield "F-DELAY", f"{sym.start.restart_timer} goes on", w.after(var(sym.start.running))


def _in_it_alone(w: Words, s: SectionId) -> Expr:
    """What came in is in a section, and not yet in the next one that it is locked towards."""
    at_once = var(w.sym.cancellation.at_once[s])
    return neg(
        disj((neg(w.sections.occupied(s)), neg(w.f.seen.used(s)), w.f.seen.passed(s), at_once, read_ahead(w, s)))
    )


def _waiting(w: Words, g: SignalId) -> Expr:
    """Stop stands, and what is locked from the signal waits for a train that may still come: somebody wants it
    released, or what came in goes on a way on which nobody releases it behind that alone."""
    first = w.signals.first(g)
    node = w.layout.signalling.signal[g].node
    left = conj((w.f.seen.used(first), disj((w.sections.outward(first, node), *_not_told(w, g, first)))))
    quiet = [neg(w.signals.active(g)), neg(w.signals.passing(g)), w.f.locking.locked_in(first, node)]
    return conj((*quiet, disj((var(w.sym.sections.release[first]), left))))


def _not_told(w: Words, g: SignalId, first: SectionId) -> Iterator[Expr]:
    """What came into the first section was not seen to be all that may come."""
    cleared = w.sym.cancellation.rear_cleared
    for h, locked in (*first_behind(w.f, first), *in_order(w.f, first)) if first in cleared else ():
        if h == g:
            yield conj((locked, neg(var(cleared[first]))))


def start(w: Words) -> Expr:
    """F-START."""
    f, sym = w.f, w.sym
    off: list[Expr] = []
    for r in sym.routes:
        off += [var(name) for name in (r.active, r.locked, r.want, r.proceed, r.shown, *r.open_while)]
        off += [var(name) for name in (r.added, r.path.hold_begun) if name is not None]
    off += map(var, sym.cancellation.cancelling.values())
    for s in w.topo.sections:
        off += [f.locking.any_lock(s), f.locking.firm(s), f.seen.passed(s), f.seen.stale(s)]
    off += map(
        var,
        (
            *sym.sections.train.values(),
            *sym.overlaps.held.values(),
            *sym.overlaps.firm.values(),
            *sym.overlaps.swings.values(),
        ),
    )
    off += map(
        var, (*sym.machines.turn.values(), *([sym.machines.started] if sym.machines.started is not None else []))
    )
    off += map(var, (*sym.machines.trailed.values(), *sym.machines.was_detected.values()))
    off += map(var, sym.cancellation.rear_cleared.values())
    off += [var(name) for x in sym.token.values() for name in (x.have, x.give, x.seen)]
    on = [*(f.seen.used(s) for s in w.topo.sections), *map(var, sym.zone_full.values())]
    return conj((*map(neg, off), *on))
