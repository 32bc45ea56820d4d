"""Invariants about overlaps (R4): while a train may still overrun a signal, an overlap is held, lies, and is empty."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, at_most_one, conj, disj, implies, neg, var
from interlock.logic.plant import accepted, across, came, image, lamp, o, overran, rests, running, shunting
from interlock.model.elements import MachineId, NodeId, Position, SectionId, SignalId
from interlock.model.overlap import ends_at
from interlock.model.shared_overlap import may_meet
from interlock.proof.claims.kinds import Facts, Invariant


def against_of(
    f: Facts, other: SectionId, whole: bool, numbers: tuple[int, ...], but: tuple[SignalId, int] | None = None
) -> Expr:
    """What an exclusion forbids; `but`: the overlap of which it is, which may come round and lie foul of itself."""
    overlaps = f.locking.overlaps(other, None if whole else numbers, but)
    if whole:
        return disj((f.locking.locked(other), *overlaps))
    return disj([f.locking.restart(other), *(f.locking.lock(other, k) for k in numbers), *overlaps])


def overrun(f: Facts, s: str) -> Expr:
    """What stands in s has overrun a signal; FALSE where no overlap lies."""
    return disj(overran(g, s) for g in f.seen.overrun(s))


def overlap_invariants(f: Facts) -> list[Invariant]:
    """All of them, ordered by signal and section."""
    out: list[Invariant] = []
    for option, name in f.sym.overlaps.held.items():
        out += _option(f, option, var(name))
    for s in f.topo.sections:
        if names.RUNNING(s) in f.plant.state:
            along = disj(conj((x, came(s, f.track.way(s, n)[0]))) for n, x in f.locking.of(s))
            out.append(Invariant("O-ALONG", s, implies(conj((o(s), running(s), neg(rests(s)))), along)))
        if len(f.locking.overlaps(s)) > 1:
            apart = _apart(f, s)
            out.append(Invariant("O-ONE", s, at_most_one(f.locking.overlaps(s)) if apart is None else apart))
            out.append(Invariant("O-OVER-ONE", s, at_most_one(overran(g, s) for g in f.seen.overrun(s))))
        for g in f.seen.overrun(s):
            out.append(Invariant(f"O-BEEN:{g}", s, implies(conj((overran(g, s), f.locking.firm(s))), f.seen.been(s))))
            calls = [
                accepted(h, k)
                for h in f.topo.signals_out(s)
                for k in f.track.functions(h)
                if names.accepted(h, k) in f.plant.state
            ]
            out.append(Invariant(f"O-STAYS:{g}", s, implies(overran(g, s), neg(disj(calls)))))
            firmly = [
                conj((var(name), firm_for(f, opt), *_only_in(f, s, n)))
                for opt, name in f.sym.overlaps.held.items()
                for sec, n in f.sym.overlaps.ways[opt]
                if sec == s and opt[0] == g
            ]
            there = conj((o(s), rests(s), disj((*firmly, *_given_up(f, g, s)))))
            out.append(Invariant(f"O-OVER:{g}", s, implies(overran(g, s), there)))
    for g in f.layout.overlaps.length:
        out += _signal(f, g)
    for j, s, t, past in f.track.passed_joints():
        if f.track.berth(t) and not past and f.locking.overlaps(t):
            leads = conj((f.locking.locked_out(s, j), neg(f.locking.train(s))))
            out.append(Invariant("O-LEAD", f"{j}:{s}>{t}", implies(leads, neg(disj(f.locking.overlaps(t))))))
    for s in f.topo.sections:
        for g in f.seen.overrun(s):
            out += [Invariant(f"O-ON:{g}", f"{j}:{s}", x) for j, x in _inside(f, g, s)]
    return out


def _apart(f: Facts, s: SectionId) -> Expr | None:
    """No two overlaps lie over a section, but such as lie there the same way, one of them past the other's signal; None
    where there are no such."""
    over = f.locking.options(s)
    of = {o: (o[0], f.sym.overlaps.ways[o]) for o in over}
    if not any(may_meet(f.layout, of[a], of[b]) for a, b in combinations(over, 2)):
        return None
    apart = (x for x in combinations(over, 2) if not may_meet(f.layout, of[x[0]], of[x[1]]))
    return conj(neg(conj((var(over[a]), var(over[b])))) for a, b in apart)


def _given_up(f: Facts, g: SignalId, s: SectionId) -> Iterator[Expr]:
    """What has overrun a signal stands in the last section of an overlap, which is given up: a route keeps it there."""
    last = dict.fromkeys(ways[-1] for (h, _), ways in f.sym.overlaps.ways.items() if h == g)
    for a, n in last:
        if a == s and (a, n) in f.sym.routes.over and ends_at(f.track.overlap_paths(g), a, f.track.way(a, n)[1]):
            yield conj((f.locking.lock(a, n), f.locking.firm(a), f.seen.been(a), f.seen.used(a), *_only_in(f, a, n)))


def _inside(f: Facts, g: SignalId, s: SectionId) -> Iterator[tuple[str, Expr]]:
    """What has overrun a signal lies across a joint only into the next section of the overlap."""
    for j in f.topo.ends[s]:
        if names.ACROSS(j, s) in f.plant.state:
            t = f.topo.beyond(s, j)
            on = overran(g, t) if t is not None and names.OVERRAN(g, t) in f.plant.state else FALSE
            yield j, implies(conj((across(j, s), overran(g, s))), on)


def _only_in(f: Facts, s: SectionId, n: int) -> list[Expr]:
    """What is in s came in at the entry of the way, and does not stand across it outward."""
    entry = f.track.way(s, n)[0]
    out = names.ACROSS(entry, s) in f.plant.state
    others = [neg(came(s, j)) for j in f.topo.ends[s] if j != entry]
    return [came(s, entry), *others, *([neg(across(entry, s))] if out else [])]


def _option(f: Facts, option: tuple[SignalId, int], held: Expr) -> list[Invariant]:
    g, k = option
    place = f"{g}:{k}"
    out = []
    firm = var(f.sym.overlaps.firm[g])
    ways = f.sym.overlaps.ways[option]
    for s, n in ways:
        others = [x for m, x in f.locking.of(s) if m != n]
        out.append(Invariant("O-FREE", f"{place}:{s}", implies(held, neg(disj((f.locking.restart(s), *others))))))
        if f.track.berth(s):
            shunt = conj((f.locking.any_lock(s), neg(f.locking.train(s)), neg(f.seen.used(s))))
            out.append(Invariant("O-TRAIN", f"{place}:{s}", implies(held, neg(shunt))))
        for m, p in f.sym.ways.demands[s, n]:
            out.append(Invariant(f"O-COMMAND:{m}", f"{place}:{s}", implies(held, var(f.sym.machines.command[m, p]))))
            sure = implies(conj((held, firm)), f.seen.settled(m, p))
            out.append(Invariant(f"O-LIES:{m}", f"{place}:{s}", sure))
        for other, whole, numbers in f.sym.ways.excluded[s, n]:
            bad = against_of(f, other, whole, numbers, but=option)
            out.append(Invariant(f"O-EXCLUDES:{other}", f"{place}:{s}", implies(held, neg(bad))))
    for s, n in ways:
        entry = f.track.way(s, n)[0]
        for j in f.topo.ends[s]:
            rear = f.topo.beyond(s, j)
            if j != entry and rear is not None:
                alone = implies(held, neg(across(j, rear)))  # nobody comes in against it
                out.append(Invariant(f"O-ACROSS:{j}", f"{place}:{s}", alone))
    for i, (s, n) in enumerate(ways[:-1]):
        j = f.track.way(s, n)[1]
        slides = conj((held, overran(g, s), neg(across(j, s))))
        empty = conj(neg(o(t)) for t, _ in ways[i + 1 :])
        out.append(Invariant("O-SLIDE", f"{place}:{s}", implies(slides, conj((firm_for(f, option), empty)))))
    return out


def firm_for(f: Facts, option: tuple[SignalId, int]) -> Expr:
    """An overlap is held firmly: locked and detected, or swung and really come to lie."""
    g = option[0]
    firm = var(f.sym.overlaps.firm[g])
    if g not in f.sym.overlaps.swings:
        return firm
    lies = (f.seen.settled(m, p) for m, p in _under(f, option))
    return disj((firm, conj((var(f.sym.overlaps.swings[g]), *lies))))


def _under(f: Facts, option: tuple[SignalId, int]) -> list[tuple[MachineId, Position]]:
    """What an alternative demands of machines that lie under the overlap: of those a train waits for each (A-SWING).
    One that protects its flank may still turn."""
    wanted = [d for way in f.sym.overlaps.ways[option] for d in f.sym.ways.demands[way]]
    known = [(m, p) for m, p in wanted if names.TURNS_SINCE(option[0], m) in f.plant.state]
    return known or wanted


def _driven(f: Facts, option: tuple[SignalId, int]) -> Iterator[tuple[MachineId, Expr]]:
    """Of every point of an alternative to which an overlap swings: it lies, or its drive is not kept off."""
    for m, p in _under(f, option):
        if m in f.sym.machines.kept_off:
            yield m, disj((f.seen.settled(m, p), neg(var(f.sym.machines.kept_off[m]))))


def turned(f: Facts, option: tuple[SignalId, int]) -> Expr:
    """Every machine of an alternative to which an overlap swings lies, or still turns to it since before a train was
    reported before the signal."""
    turns = [(m, p, names.TURNS_SINCE(option[0], m)) for m, p in _under(f, option)]
    known = f.plant.state
    return conj(disj((f.seen.settled(m, p), var(t))) if t in known else f.seen.settled(m, p) for m, p, t in turns)


def running_into(f: Facts, g: SignalId, s: SectionId) -> Expr:
    """A train runs or comes to a signal, firmly, or runs on beyond it, so that it may overrun into a section."""
    node = f.layout.signalling.signal[g].node
    b = f.topo.beyond(f.layout.track.section_of(f.layout.signalling.signal[g].into), node)
    assert b is not None
    out = []
    for opt, name in f.sym.overlaps.held.items():
        ways = f.sym.overlaps.ways[opt] if opt[0] == g else ()
        if any(a == s for a, _ in ways):
            out += [
                conj((var(name), f.locking.firm(b), x)) for n, _ in f.locking.of(b) for x in _towards(f, b, n, node)
            ]
        for i, (a, n) in enumerate(ways):
            if any(c == s for c, _ in ways[i + 1 :]):
                out.append(conj((var(name), overran(g, a), neg(across(f.track.way(a, n)[1], a)))))
    return disj(out)


def _towards(f: Facts, b: SectionId, n: int, node: NodeId) -> tuple[Expr, ...]:
    """On a way through the section before a signal: a train runs there, or may still come."""
    entry, exit_ = f.track.way(b, n)
    if exit_ != node:
        return ()
    as_train = neg(shunting(b)) if f.track.shunts else TRUE
    runs = conj((f.locking.lock(b, n), o(b), running(b), came(b, entry), neg(rests(b)), neg(across(node, b)), as_train))
    coming = conj((f.locking.lock(b, n), f.locking.train(b), neg(f.seen.been(b)), _coming(f, b, entry)))
    return runs, coming


def _signal(f: Facts, g: SignalId) -> list[Invariant]:
    """A train that runs towards the signal, or may still come, finds an overlap."""
    node = f.layout.signalling.signal[g].node
    t = f.layout.track.section_of(f.layout.signalling.signal[g].into)
    b = f.topo.beyond(t, node)
    assert b is not None
    firm = var(f.sym.overlaps.firm[g]) if g in f.sym.overlaps.firm else neg(TRUE)  # no train route leads to it
    swings = var(f.sym.overlaps.swings[g]) if g in f.sym.overlaps.swings else FALSE
    apart = [] if swings is FALSE else [Invariant("O-SWINGS", g, implies(swings, neg(firm)))]
    firm = disj((firm, swings))
    options = [
        (var(name), conj(neg(o(s)) for s, _ in f.sym.overlaps.ways[opt]))
        for opt, name in f.sym.overlaps.held.items()
        if opt[0] == g
    ]
    ready = disj(conj((held, empty)) for held, empty in options)
    out = apart
    for option, name in f.sym.overlaps.held.items() if swings is not FALSE else ():
        if option[0] == g:
            close = conj((swings, var(name), o(b), neg(rests(b)), image(b), running(b)))
            out.append(Invariant(f"O-TURNS:{option[1]}", g, implies(close, turned(f, option))))
            out += [
                Invariant(f"O-DRIVEN:{m}", f"{g}:{option[1]}", implies(conj((swings, var(name))), x))
                for m, x in _driven(f, option)
            ]
    for n, _ in f.locking.of(b):
        if f.track.way(b, n)[1] != node:
            continue
        runs, coming = _towards(f, b, n, node)
        out.append(Invariant(f"O-RUNS:{n}", g, implies(runs, conj((firm, ready)))))
        kept = disj(conj((held, implies(f.locking.firm(b), conj((firm, empty))))) for held, empty in options)
        out.append(Invariant(f"O-COMES:{n}", g, implies(coming, kept)))
    return out


def _coming(f: Facts, b: SectionId, entry: str) -> Expr:
    """A train may still come into b at an end: a lock leads there, or its signal is or may be passed."""
    rear = f.topo.beyond(b, entry)  # type: ignore[arg-type]
    g = f.topo.main_into.get((entry, b))  # type: ignore[arg-type]
    if g is not None:
        active = [var(r.active) for r in f.sym.routes.of_signal.get(g, ()) if not r.shunt]
        went = [accepted(g)] if names.ACCEPTED(g) in f.plant.state else []
        shown = disj((f.sym.aspects.signal(g), lamp(g)))
        if f.sym.routes.passing(g) is not FALSE:  # nobody comes after the one that passes
            shown = disj(
                (
                    f.sym.routes.opens(g),
                    f.sym.routes.called(g),
                    conj((shown, o(f.sym.cancellation.approach_of[g] or ""))),
                )
            )
        return disj([*active, shown, *went])
    if rear is None:
        return disj(())
    on = [f.locking.train(rear)] if (entry, b) in f.topo.signal_into else []
    return conj([f.locking.locked_out(rear, entry), *on])
