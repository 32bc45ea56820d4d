"""Claims about what stands at the terminals: lamps that agree, drives, indications, words to a neighbour, and about
how long delays last (R8, R10, R11, R12).

Each output that the cabinet wires is read by the plant or by one of these.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.controller import LONGEST_MS
from interlock.logic.expr import FALSE, TRUE, Expr, at_most_one, conj, disj, iff, implies, neg, var
from interlock.logic.names import Name
from interlock.model.elements import Position, SignalId
from interlock.model.times import overlap_release_s, supervision_s, whole_ms
from interlock.proof.claims.added import hold_s
from interlock.proof.claims.kinds import Facts


def terminals(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """Claim, place and expression, signal by signal, machine by machine, then indications."""
    yield from _lamps(f)
    yield from _drives(f)
    yield from _indications(f)
    yield from _delays(f)


def _lamps(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    after = f.after
    for g, stop in f.sym.aspects.stop.items():
        mains = [var(name) for name in f.sym.aspects.main_lamps(g)]
        others = [*mains, *(var(name) for name in f.sym.aspects.proceed_lamps(g, shunt=True))]
        others += [var(f.sym.aspects.identifier[g])] if g in f.sym.aspects.identifier else []
        speeds = [var(name) for (h, _), name in f.sym.aspects.speed.items() if h == g]
        one = conj((at_most_one(others), implies(disj(speeds), disj(mains))))
        if g in f.sym.aspects.indicator:
            one = conj((one, implies(var(f.sym.aspects.indicator[g]), disj(mains))))
        if g in f.sym.aspects.second:
            first = var(f.sym.aspects.caution[g]) if g in f.sym.aspects.caution else FALSE
            one = conj((one, implies(var(f.sym.aspects.second[g]), first)))
        yield "S-STOP", g, after(conj((iff(var(stop), neg(disj(others))), one)))
        for name in _not_for(f, g):
            yield "S-STOP", f"{g} never {name}", neg(after(var(name)))
        if g in f.sym.aspects.call_on and not f.layout.signalling.signal[g].call_on:
            yield "S-CALL-ON", f"{g} never", neg(after(var(f.sym.aspects.call_on[g])))
    for d in f.layout.signalling.distants:
        clear, caution = var(f.sym.aspects.distant_clear[d.id]), var(f.sym.aspects.distant_caution[d.id])
        yield "S-STOP", d.id, after(iff(caution, neg(clear)))


def _not_for(f: Facts, g: SignalId) -> list[Name]:
    """Lamps of a signal that speak to trains, or to shunting movements, of which the layout does not let it speak."""
    signal = f.layout.signalling.signal[g]
    second = [of[g] for of in (f.sym.aspects.second, f.sym.aspects.indicator) if g in of]
    trains = [*f.sym.aspects.main_lamps(g), *second, *(name for (h, _), name in f.sym.aspects.speed.items() if h == g)]
    return [*([] if signal.main else trains), *([] if signal.shunt else f.sym.aspects.proceed_lamps(g, shunt=True))]


def _drives(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    for m in f.layout.machines:
        both = []
        for x in Position:
            turn = f.sym.machines.turn.get(m)
            commanded = var(f.sym.machines.command[m, x])
            off = f.sym.machines.kept_off.get(m)
            due = conj([commanded, *([] if turn is None else [var(turn)]), *([] if off is None else [neg(var(off))])])
            both.append(iff(var(f.sym.machines.drive[m, x]), due))
        never = neg(conj(var(f.sym.machines.command[m, x]) for x in Position))
        yield "P-DRIVEN", m, f.after(conj((*both, never)))


def _indications(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """What an operator is told, in terms of the state after the scan, or of what the scan has read."""
    after, told = f.after, f.sym.indication
    for s in f.topo.sections:
        yield "I-TOLD", f"locked {s}", iff(after(var(told[f"locked {s}"])), after(f.locking.held(s)))
    for s, healthy in f.sym.sections.healthy.items():
        yield "I-TOLD", f"faulty {s}", iff(after(var(told[f"faulty {s}"])), neg(var(healthy)))
    for m in f.layout.machines:
        timer = f.sym.machines.late_timer[m]
        astray = disj(conj((var(f.sym.machines.command[m, x]), neg(f.seen.reported(m, x)))) for x in Position)
        yield "I-TOLD", f"late {m}", iff(after(var(told[f"late {m}"])), var(timer))
        yield "I-TOLD", f"late {m} timed", iff(var(f.timers[timer].input), astray)
    for m, trailed in f.sym.machines.trailed.items():
        yield "I-TOLD", f"trailed {m}", iff(after(var(told[f"trailed {m}"])), after(var(trailed)))
    for z, full in f.sym.zone_full.items():
        yield "I-TOLD", f"full {z}", iff(after(var(told[f"full {z}"])), after(var(full)))
    for b, x in f.sym.token.items():
        words = {"gives": var(x.give), "has": var(x.have)}
        for word, is_so in words.items():
            yield "I-TOLD", f"{word} {b}", iff(after(var(x.tells[word])), after(is_so))
        towards = disj(f.locking.locked_out(s, b) for s in f.topo.sections if b in f.topo.ends[s])
        yield "I-TOLD", f"asks {b}", iff(after(var(x.tells["asks"])), after(conj((towards, neg(var(x.have))))))
        yield "I-TOLD", f"keeps {b}", implies(after(var(x.tells["keeps"])), neg(after(var(x.give))))


def _delays(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """Each preset against what the principles order and what the world needs: settled by comparing numbers."""
    rules, needs = f.layout.principles, f.measured.needs
    ordered: dict[Name, list[float]] = {}
    released = dict(f.layout.signalling.releases)
    for g, name in f.sym.cancellation.approach_timer.items():
        kinds = {r.shunt for r in f.sym.routes.of_signal.get(g, ())}
        trains = [released.get(g, rules.approach_release_s), needs.stop[g] / 1000] if False in kinds else []
        shunts = [released.get(g, rules.shunt_release_s), needs.shunt / 1000] if True in kinds else []
        ordered[name] = [*trains, *shunts]
    for g, name in f.sym.overlaps.timer.items():
        own = [] if g in f.sym.overlaps.firm else [needs.arrive[g] / 1000]
        ordered[name] = [overlap_release_s(f.layout, g), needs.stand[g] / 1000, *own]
    ordered |= {x.timer: [rules.token_delay_s, needs.agreed / 1000] for x in f.sym.token.values()}
    ordered |= {name: [supervision_s(f.layout, m), needs.run / 1000] for m, name in f.sym.machines.late_timer.items()}
    ordered |= {name: [rules.release_delay_s] for name in f.sym.sections.release_timer.values()}
    ordered |= {name: [rules.detection_delay_s] for name in f.sym.cancellation.alone.values()}
    ordered[f.sym.start.restart_timer] = [rules.restart_delay_s, needs.restart / 1000]
    ordered |= {r.path.hold_timer: [hold_s(f, r)] for r in f.sym.routes if r.path.hold_timer is not None}
    if f.sym.machines.start_timer is not None:
        ordered[f.sym.machines.start_timer] = [rules.point_start_gap_s]
    for name, seconds in ordered.items():
        counts = whole_ms(max(seconds)) <= f.timers[name].preset_ms <= LONGEST_MS
        yield "D-PRESET", name, TRUE if counts else FALSE
    for name in sorted(f.timers.keys() - ordered.keys()):
        yield "D-PRESET", name, FALSE  # nothing says how long this timer must be


__all__ = ["terminals"]
