"""Claims about why locks end and routes are given up, and about when a point is taken as trailed (R8, R9, R10, R16)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, implies, neg, var
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import NodeId, Position, SectionId, SignalId
from interlock.model.overlap import ends_at
from interlock.model.places import Approach
from interlock.proof.claims.kinds import Facts


def reasons(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """Claim, place and expression: sections, then signals and routes, then machines."""
    yield from _ends(f)
    yield from _given_up(f)
    yield from _trailed(f)


def _ends(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """R8, R9, R16: why the locks of a section end.  `used`, `passed` and `cancelling` are the controller's own bits, so
    that when they may be set is claimed, too."""
    after = f.after
    for s in f.topo.sections:
        by_hand = var(f.sym.sections.release[s])
        freed = conj((f.locking.restart(s), neg(after(f.locking.restart(s)))))
        yield (
            "L-REASON",
            f"{s} after a restart",
            implies(freed, disj((by_hand, var(f.sym.sections.release_all), f.seen.passed(s)))),
        )
        reasons = [f.seen.used(s), by_hand, conj((var(f.sym.sections.release_all), f.seen.stale(s)))]
        for j in f.topo.ends[s]:
            g = f.topo.signal_into.get((j, s))
            rear = f.topo.beyond(s, j)
            if g is not None and g in f.sym.cancellation.cancelling:
                reasons.append(var(f.sym.cancellation.cancelling[g]))
            if rear is not None and (j, s) not in f.topo.main_into:
                leads = f.locking.locked_out(rear, j)  # past a shunt signal only for a train
                reasons.append(
                    conj(
                        (
                            f.locking.locked_in(s, j),
                            neg(conj((leads, f.locking.train(rear))) if g is not None else leads),
                        )
                    )
                )
        ended = conj((f.locking.any_lock(s), neg(after(f.locking.any_lock(s)))))
        yield "L-REASON", s, implies(ended, disj(reasons))
        yield from _kept(f, s, ended)
        yield from _stood(f, s)
        if s in f.sym.cancellation.rear_cleared:
            yield from _cleared(f, s)
        yield "L-REASON", f"{s} used", implies(conj((after(f.seen.used(s)), neg(f.seen.used(s)))), _came_in(f, s))
        gone = disj(neg(f.seen.clear(a)) for j in f.topo.ends[s] if (a := f.topo.beyond(s, j)) is not None)
        onward = conj((f.seen.used(s), neg(f.seen.clear(s)), gone))
        yield "L-REASON", f"{s} passed", implies(conj((after(f.seen.passed(s)), neg(f.seen.passed(s)))), onward)
        yield "L-CLEAR", s, implies(disj((freed, ended)), var(f.sym.sections.release_timer[s]))
    for s, timer in f.sym.sections.release_timer.items():
        yield "L-CLEAR", f"{s} timed", implies(var(f.timers[timer].input), conj((var(f.sym.valid), f.seen.clear(s))))
    for (g, k), held in f.sym.overlaps.held.items():
        swings = [after(var(f.sym.overlaps.swings[g]))] if g in f.sym.overlaps.swings else []
        ways, paths = f.sym.overlaps.ways[g, k], f.track.overlap_paths(g)
        over = [var(f.sym.sections.release_timer[s]) for s, _ in ways]
        if ends_at(paths, ways[-1][0], f.track.way(*ways[-1])[1]):
            over[-1] = disj((over[-1], _stays_locked(f, ways[-1])))
        given_up = conj((var(held), neg(after(var(held)))))
        yield "L-CLEAR", f"overlap {k} of {g}", implies(given_up, disj((conj(over), *swings)))
        yield from _let_go(f, f"overlap {k} of {g}", g, conj((given_up, *map(neg, swings))))


def _let_go(f: Facts, place: str, g: SignalId, given_up: Expr) -> Iterator[tuple[str, str, Expr]]:
    """R4, R9: nor is an overlap given up behind a train that is to come to a stand before its signal, while another may
    be on its way there."""
    signal = f.layout.signalling.signal[g]
    node, before = signal.node, f.topo.beyond(f.layout.track.section_of(signal.into), signal.node)
    if before is None or before not in f.sym.cancellation.rear_cleared:
        return
    cleared, towards = var(f.sym.cancellation.rear_cleared[before]), f.locking.locked_out(before, node)
    for h, locked in first_behind(f, before):
        yield "L-APPROACH", f"{place} past {h}", implies(conj((given_up, towards, locked)), cleared)


def _stays_locked(f: Facts, way: tuple[SectionId, int]) -> Expr:
    """A section is not released: it stays firmly locked the same way for a train that has come into it."""
    s, n = way
    lock = f.locking.lock(s, n)
    return conj((lock, f.seen.used(s), f.after(lock), f.after(f.locking.firm(s)), f.after(f.seen.used(s))))


def _kept(f: Facts, s: SectionId, ended: Expr) -> Iterator[tuple[str, str, Expr]]:
    """What a section remembers of its train ends with its lock, and a lock once firm stays so; and no lock ends before
    the one in rear that leads into it, whatever the reason, unless its own signal is cancelled."""
    after, any_lock = f.after, f.locking.any_lock(s)
    held = disj((f.locking.restart(s), any_lock))
    yield "L-REASON", f"{s} remembered", implies(disj((f.seen.used(s), f.seen.passed(s))), held)
    firm = f.locking.firm(s)
    yield "L-REASON", f"{s} firm", implies(conj((firm, neg(after(firm)))), neg(after(any_lock)))
    lost = conj((neg(var(f.sym.valid)), any_lock))
    called = (conj((after(var(r.active)), neg(var(r.active)))) for r in f.sym.routes if r.call_on)
    missed = conj((after(f.seen.stale(s)), neg(f.seen.stale(s))))
    yield "L-REASON", f"{s} missed", implies(missed, disj((lost, *called)))
    signals = [g for j in f.topo.ends[s] if (g := f.topo.signal_into.get((j, s))) is not None]
    cancelled = (var(c) for g in signals if (c := f.sym.cancellation.cancelling.get(g)) is not None)
    yield "L-REASON", f"{s} in order", implies(conj((ended, neg(disj(cancelled)))), neg(_led_into(f, s)))


def _led_into(f: Facts, s: SectionId) -> Expr:
    """A section is locked from an end at which another leads into it."""
    leading = []
    for j, rear, past in f.track.passed_into(s):
        leads = f.locking.locked_out(rear, j)
        leading.append(conj((f.locking.locked_in(s, j), leads, *([f.locking.train(rear)] if past else []))))
    return disj(leading)


def met(f: Facts, s: SectionId) -> list[tuple[SignalId, Expr]]:
    """The main signals at the ends of a berth before which train routes end, and over whose joint shunt routes end in
    it, towards such a train; each with that the berth is locked towards it."""
    if s not in f.track.ends_of_shunts:
        return []
    routes = f.sym.routes
    ends = {f.track.way(*r.path.ways[-1])[1] for r in routes if not r.shunt and r.path.ways[-1][0] == s}
    begins = {f.track.way(*r.path.berth)[0] for r in routes if r.path.berth is not None and r.path.berth[0] == s}
    found = []
    for j in f.topo.ends[s]:
        ahead = f.topo.beyond(s, j)
        g = None if ahead is None else f.topo.main_into.get((j, ahead))
        if g is not None and j in ends & begins:
            found.append((g, f.locking.locked_out(s, j)))
    return found


def _stood(f: Facts, s: SectionId) -> Iterator[tuple[str, str, Expr]]:
    """R2: where shunting movements come in towards a train, it counts as arrived only when it stands by time; and that
    counts from when it is wholly in."""
    train, any_lock, cleared = f.locking.train(s), f.locking.any_lock(s), f.sym.cancellation.rear_cleared.get(s)
    gone = conj((any_lock, train, f.after(any_lock), neg(f.after(train))))
    whole = [] if cleared is None else [implies(locked, var(cleared)) for _, locked in first_behind(f, s)]
    for g, towards in met(f, s):
        timer = f.sym.overlaps.timer.get(g)
        yield "L-REASON", f"{s} before {g}", implies(conj((gone, towards)), FALSE if timer is None else var(timer))
        if timer is not None:
            there = conj(
                (var(f.sym.valid), f.seen.used(s), neg(f.seen.clear(s)), towards, neg(_led_into(f, s)), *whole)
            )
            yield "L-REASON", f"{s} before {g} timed", implies(var(f.timers[timer].input), there)


def _rear(f: Facts, s: SectionId, j: NodeId) -> SectionId | None:
    """The section or approach from which a train comes in at an end."""
    boundary = f.layout.track.boundary_at.get(j)
    return boundary.approach if boundary is not None else f.topo.beyond(s, j)


def first_behind(f: Facts, s: SectionId) -> list[tuple[SignalId, Expr]]:
    """The main signals with routes behind which a section is the first, where the section in rear of them is detected,
    each with that the section is locked from there for a train."""
    found = []
    for j in f.topo.ends[s]:
        g, rear, locked = f.topo.main_into.get((j, s)), _rear(f, s, j), f.locking.locked_in(s, j)
        if g is None or rear is None or rear not in f.sym.sections.clear or locked is FALSE:
            continue
        if g in f.sym.cancellation.cancelling:
            found.append((g, conj((locked, f.locking.train(s)))))
    return found


def in_order(f: Facts, s: SectionId) -> list[tuple[SignalId, Expr]]:
    """The signals with routes behind which a section is the first, with that it is locked from there for a shunting
    movement, or for a train where the section in rear of them is not detected."""
    found = []
    for j in f.topo.ends[s]:
        g, locked = f.topo.signal_into.get((j, s)), f.locking.locked_in(s, j)
        if g is None or locked is FALSE:
            continue
        kinds = {r.shunt for r in f.sym.routes.of_signal.get(g, ())}
        if True in kinds:
            found.append((g, conj((locked, neg(f.locking.train(s))))))
        if False in kinds and f.topo.main_into.get((j, s)) == g and _rear(f, s, j) not in f.sym.sections.clear:
            found.append((g, conj((locked, f.locking.train(s)))))
    return found


def whole(f: Facts, s: SectionId) -> Expr:
    """What is said to have come into a first section is a movement: nobody else is reported on the way to its signal,
    or it was in the section alone for as long as two detectors may differ."""
    seen = [conj((locked, _nobody(f, g, FALSE))) for g, locked in first_behind(f, s)]
    for g, locked in in_order(f, s):
        told = _rear(f, s, f.layout.signalling.signal[g].node) in f.sym.sections.clear
        alone = var(f.sym.cancellation.alone[s])
        seen.append(conj((locked, disj((alone, _nobody(f, g, FALSE) if told else FALSE)))))
    return disj(seen)


def _alone(f: Facts, s: SectionId) -> Iterator[tuple[str, str, Expr]]:
    """A movement is in a section, and neither is nor was in one ahead of it that it is locked towards; what was read
    in both at once is remembered with the lock."""
    ahead = []
    for n, lock in f.locking.of(s):
        b = f.topo.beyond(s, f.track.way(s, n)[1])
        if b is not None:
            ahead.append(implies(lock, conj((var(f.sym.valid), f.seen.clear(b)))))
    runs = var(f.timers[f.sym.cancellation.alone[s]].input)
    occupied = neg(conj((var(f.sym.valid), f.seen.clear(s))))
    at_once = var(f.sym.cancellation.at_once[s])
    came = conj((f.seen.used(s), neg(f.seen.passed(s)), neg(at_once)))
    yield "L-REASON", f"{s} alone", implies(runs, conj((came, occupied, *ahead)))
    comes = conj((neg(f.seen.used(s)), f.after(f.seen.used(s)), neg(conj(ahead))))
    yield "L-REASON", f"{s} at once", implies(comes, f.after(at_once))
    stays = conj((f.after(f.locking.any_lock(s)), at_once))
    yield "L-REASON", f"{s} at once remembered", implies(stays, f.after(at_once))


def _cleared(f: Facts, s: SectionId) -> Iterator[tuple[str, str, Expr]]:
    """R9: the first section behind a signal is released behind a movement only when it is seen to have come in, or
    nobody can be about to pass; that is remembered with the lock alone."""
    cleared, after = var(f.sym.cancellation.rear_cleared[s]), f.after
    behind = first_behind(f, s)
    come = conj((f.seen.used(s), whole(f, s)))
    yield "L-REASON", f"{s} rear", implies(conj((after(cleared), neg(cleared))), come)
    if s in f.sym.cancellation.alone:
        yield from _alone(f, s)
    held = disj((f.locking.restart(s), f.locking.any_lock(s)))
    yield "L-REASON", f"{s} rear remembered", implies(cleared, held)
    for what, those in (("a train", behind), ("what came", in_order(f, s))):
        for g, locked in those:
            long = names.STOP_LONG(g)
            stands = after(var(long)) if long in f.plant.clocks else FALSE
            ended = conj((locked, neg(after(f.locking.any_lock(s))), f.seen.used(s)))
            yield "L-APPROACH", f"{g} behind {what}", implies(ended, disj((cleared, _nobody(f, g), stands)))
    if f.track.shunts:
        for g, locked in behind:
            arrived = conj((locked, after(f.locking.any_lock(s)), neg(after(f.locking.train(s)))))
            yield "L-APPROACH", f"{g} arrived", implies(arrived, cleared)


def _nobody(f: Facts, g: SignalId, unseen: Expr = TRUE) -> Expr:
    """No train can be on its way to a signal: all of its approach is steadily clear, and what has no detection none."""
    return neg(_coming(f, f.measured.approaches[g], unseen)) if g in f.measured.approaches else FALSE


def _came_in(f: Facts, s: SectionId) -> Expr:
    """A locked section and one in rear of it, from which it can be locked, are reported occupied (R9)."""
    rear = [_rear(f, s, j) for j in f.topo.ends[s] if f.locking.locked_in(s, j) is not FALSE]
    occupied = disj(TRUE if r is None else neg(f.seen.clear(r)) for r in rear)
    return conj((var(f.sym.valid), f.locking.any_lock(s), neg(f.seen.clear(s)), occupied))


def _coming(f: Facts, x: Approach, unseen: Expr) -> Expr:
    """A train may be on its way from there; `unseen` is said of what has no detection."""
    if x.section is None or x.section not in f.sym.sections.clear:
        return unseen
    ways = ((f.sym.sections.lock.get((x.section, n)), y) for n, y in x.further)
    called = (conj((var(name), _coming(f, y, unseen))) for name, y in ways if name is not None)
    return disj((neg(f.seen.steadily_clear(x.section)), *called, *([unseen] if x.unseen else [])))


def _given_up(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """R8: comprehensive approach locking, over what is `measured`."""
    after = f.after
    for g, routes in f.sym.routes.of_signal.items():
        signal = f.layout.signalling.signal[g]
        first = f.layout.track.section_of(signal.into)
        from_g = f.locking.locked_in(first, signal.node)
        shown = disj(var(r.shown) for r in routes)
        given_up = conj((from_g, neg(after(from_g)), neg(f.seen.used(first)), shown))
        long = names.STOP_LONG(g)
        stands = after(var(long)) if long in f.plant.clocks else FALSE
        nobody = _nobody(f, g)
        asked = conj((after(var(f.sym.cancellation.cancelling[g])), neg(var(f.sym.cancellation.cancelling[g]))))
        withdrawn = (conj((var(r.active), _withdrawn(f, r))) for r in f.sym.routes.of_signal.get(g, ()))
        yield "L-REASON", f"{g} cancelled", implies(asked, disj((var(f.sym.cancellation.cancel[g]), *withdrawn)))
        yield "L-APPROACH", g, implies(given_up, disj((nobody, stands)))
        for r in routes:
            set_, seen = after(var(r.active)), after(var(r.shown))
            stays = disj((after(var(r.proceed)), conj((var(r.shown), set_))))
            yield "L-APPROACH", f"{r.id} shown", implies(stays, seen)
            gone = disj((after(f.seen.used(first)), neg(after(from_g))))
            yield "L-APPROACH", f"{r.id} kept", implies(conj((var(r.shown), neg(seen))), gone)


def _withdrawn(f: Facts, r: RouteSymbols) -> Expr:
    """A route that is set with one past its signal, or with one of these in turn, is being cancelled."""
    cancel, cancelling = f.sym.cancellation.cancel, f.sym.cancellation.cancelling
    with_ = f.sym.routes.set_with(r)
    return disj(conj((var(x.active), disj((var(cancel[x.entry]), var(cancelling[x.entry]))))) for x in with_)


def _trailed(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """R10: detection lost without a command.  That it was there before is the controller's own bit, which stays while
    inputs are lost, and is kept from when the restart delay is over."""
    after, commands, valid = f.after, f.sym.machines.command, var(f.sym.valid)
    for m, trailed in f.sym.machines.trailed.items():
        quiet = neg(disj(conj((after(var(commands[m, x])), neg(var(commands[m, x])))) for x in Position))
        for x in Position:
            was, reported = var(f.sym.machines.was_detected[m, x]), f.seen.reported(m, x)
            there = conj((reported, neg(var(commands[m, x.other])), quiet, var(f.sym.start.restart_timer)))
            yield "S-TRAILED", f"{m} detected {x}", implies(there, after(was))
            unseen = conj((was, neg(valid), quiet, var(f.sym.start.restart_timer)))
            yield "S-TRAILED", f"{m} unseen {x}", implies(unseen, after(was))
            yield "S-TRAILED", f"{m} {x}", implies(conj((was, valid, quiet, neg(reported))), after(var(trailed)))
        sections = f.layout.machines.sections[m]
        seen = conj((var(f.sym.machines.looked_at[m]), valid, *(f.seen.steadily_clear(s) for s in sections)))
        yield "S-TRAILED", f"{m} kept", implies(conj((var(trailed), neg(seen))), after(var(trailed)))


__all__ = ["reasons"]
