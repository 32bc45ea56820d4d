"""The invariants that make the claims inductive, one per element.

They tie the controller's locks to the trains: every moving train stands in sections that are firmly locked for
its way; ahead of its head nobody has been since the lock; behind a joint without a signal the lock goes on.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, at_most_one, conj, disj, iff, implies, neg, var
from interlock.logic.plant import (
    accepted,
    across,
    came,
    image,
    lamp,
    lies,
    o,
    old_command,
    overran,
    parted,
    rests,
    shunting,
    was_called,
)
from interlock.logic.symbols import RouteSymbols, Way
from interlock.model.elements import MachineId, Position, SectionId, SignalId, of_points
from interlock.proof.claims.added import added_invariants, called_on_lit
from interlock.proof.claims.block import token_invariants
from interlock.proof.claims.kinds import Facts, Invariant
from interlock.proof.claims.overlaps import against_of, overlap_invariants, overrun, running_into
from interlock.proof.claims.points import machine_invariants
from interlock.proof.claims.reasons import first_behind, met
from interlock.proof.claims.slow import slow_invariants


def strengthening(f: Facts) -> tuple[Invariant, ...]:
    """All of them, ordered by element."""
    out: list[Invariant] = []
    for s in f.topo.sections:
        out += [Invariant(i, s, x) for i, x in _section(f, s)]
        if f.track.shunts:
            out += [Invariant(i, s, x) for i, x in _movement(f, s)]
    for j, s, t, past in f.track.passed_joints():
        out += [Invariant(i, f"{j}:{s}>{t}", x) for i, x in _joint(f, j, s, t, past)]
    for joint, here, there in _all_joints(f):
        out += [Invariant(i, f"{joint}:{here}>{there}", x) for i, x in _crossing_joint(f, joint, here, there)]
    for g in f.layout.signalling.signals:
        for k in f.track.functions(g.id):
            lit = iff(f.sym.aspects.signal(g.id, k), f.sym.routes.opened(g.id, k))
            out.append(Invariant("G-SHUNT-LIT" if k else "G-LIT", g.id, lit))
            out += [Invariant(i, g.id, x) for i, x in _signal(f, g.id, k)]
        if g.id in f.sym.aspects.stop:
            lamps = [*f.sym.aspects.main_lamps(g.id), *f.sym.aspects.proceed_lamps(g.id, shunt=True)]
            lamps += [f.sym.aspects.identifier[g.id]] if g.id in f.sym.aspects.identifier else []
            out.append(Invariant("G-STOP", g.id, iff(var(f.sym.aspects.stop[g.id]), neg(disj(map(var, lamps))))))
        routes = f.sym.routes.of_signal.get(g.id, ())
        several = g.call_on or any(r.path.identifier or r.path.onward is not None for r in routes)
        if several or any(r.path.overlap is not None and r.path.overlap[0] in f.sym.overlaps.swings for r in routes):
            one = at_most_one(var(r.active) for r in routes)  # they lock the same ways
            out.append(Invariant("G-ONE", g.id, one))
    out += [Invariant("G-CALL-ON-LIT", g, lit) for g, lit in called_on_lit(f)]
    out += [Invariant("C-COVERED", t.timer.name, var(t.covered)) for t in f.ties]
    out += overlap_invariants(f)
    out += slow_invariants(f)
    out += token_invariants(f)
    for s in sorted({s for z in f.layout.declared.zones for s in z.sections}):
        inside = conj((o(s), neg(rests(s)), neg(disj(_coming(f, s)))))
        if names.IMAGE(s) in f.plant.state:
            out.append(Invariant("Z-SEEN", s, implies(inside, image(s))))
    for r in f.sym.routes:
        out += [Invariant(i, r.id, x) for i, x in _route(f, r)]
    out += machine_invariants(f)
    return tuple(out)


def _all_joints(f: Facts) -> list[tuple[str, str, str]]:
    """Every (joint, from, to), with the outside of boundaries; `to` is empty outside."""
    out: list[tuple[str, str, str]] = []
    for s in f.topo.sections:
        for j in f.topo.ends[s]:
            if j in f.layout.track.buffer_at:
                continue
            out.append((j, s, f.topo.beyond(s, j) or ""))
            boundary = f.layout.track.boundary_at.get(j)
            if boundary is not None:
                outside = boundary.approach or names.outside(j)
                if names.STANDS(outside) in f.plant.state:
                    out.append((j, outside, s))
    return out


def _section(f: Facts, s: SectionId) -> Iterator[tuple[str, Expr]]:
    locks = f.locking.of(s)
    if s in f.layout.track.undetected:
        yield "S-BLIND", f.locking.restart(s)  # never reported clear, so never released after the restart
    yield "S-ONE", at_most_one([f.locking.restart(s), *(x for _, x in locks)])
    yield "S-FIRM", implies(f.locking.firm(s), f.locking.any_lock(s))
    yield "S-USED", implies(f.seen.used(s), disj((f.locking.restart(s), f.locking.firm(s))))
    yield "S-PASSED", implies(f.seen.passed(s), f.seen.used(s))
    if s in f.sym.cancellation.rear_cleared:
        yield "S-REAR-CLEARED", implies(var(f.sym.cancellation.rear_cleared[s]), f.seen.used(s))
    yield "S-RESTART", implies(f.locking.restart(s), f.seen.used(s))
    yield "S-STALE", implies(f.seen.stale(s), f.locking.any_lock(s))
    yield "S-BEEN", implies(f.seen.been(s), f.locking.firm(s))
    one = at_most_one(came(s, j) for j in f.topo.ends[s])
    yield (
        "S-CAME",
        conj(
            (
                disj((rests(s), one)) if f.track.berth(s) else one,
                implies(o(s), disj(came(s, j) for j in f.topo.ends[s])),
                *(implies(came(s, j), o(s)) for j in f.topo.ends[s]),
            )
        ),
    )
    unmoved = o(s) if f.track.berth(s) else conj((o(s), disj((f.locking.restart(s), overrun(f, s)))))
    yield "S-REST", conj((implies(rests(s), unmoved), implies(conj((f.locking.restart(s), o(s))), rests(s))))
    trains = []
    for n, x in locks:
        a, b = f.track.way(s, n)
        turned = (
            came(s, b)
            if f.track.signal_out(s, a) is not None and not f.track.berth(s)
            else conj((came(s, b), rests(s)))
        )
        trains.append(conj((x, disj((came(s, a), turned)))))
    yield "S-TRAIN", implies(conj((o(s), neg(rests(s)))), conj((f.locking.firm(s), f.seen.been(s), disj(trains))))
    moved = (
        f.locking.any_lock(s) if f.track.berth(s) else disj((neg(rests(s)), conj((overrun(f, s), f.locking.firm(s)))))
    )
    if f.track.berth(s):
        moved = conj((moved, disj((f.locking.firm(s), neg(overrun(f, s))))))
    yield "S-SEEN", implies(conj((o(s), image(s), moved)), disj((f.seen.used(s), f.seen.stale(s))))
    for n, x in locks:
        if (s, n) not in f.sym.routes.over:
            yield f"S-UNUSED:{n}", neg(x)  # the way serves overlaps only
        for m, p in f.sym.ways.demands[s, n]:
            yield f"S-COMMAND:{n}:{m}", implies(x, var(f.sym.machines.command[m, p]))
            yield f"S-LIES:{n}:{m}", implies(conj((x, f.locking.firm(s))), f.seen.settled(m, p))
        for other, whole, numbers in f.sym.ways.excluded[s, n]:
            against = against_of(f, other, whole, tuple(k for k in numbers if not _one_route(f, (s, n), (other, k))))
            yield f"S-EXCLUDES:{n}:{other}", implies(x, neg(against))
        train = f.locking.train(s) if f.track.berth(s) else TRUE
        yield f"S-PASSED-BEEN:{n}", implies(conj((x, train, f.seen.passed(s))), f.seen.been(s))
    yield from _standing_section(f, s)


def _one_route(f: Facts, a: Way, b: Way) -> bool:
    """Whether a route leads over both ways: where it comes foul of itself, it alone locks what excludes each other."""
    over = f.sym.routes.over
    return not {r.id for r in over.get(a, ())}.isdisjoint(r.id for r in over.get(b, ()))


def _standing_section(f: Facts, s: SectionId) -> Iterator[tuple[str, Expr]]:
    """What stands in a section since the restart, and what does not move under it."""
    if not f.track.berth(s):
        closed = [f.seen.settled(MachineId(d.id), Position.REVERSE) for d in f.layout.signalling.devices if s in d.over]
        alone = [neg(across(k, t)) for k in f.topo.ends[s] if (t := f.topo.beyond(s, k)) is not None]
        plain = neg(disj(TRUE for t in f.topo.traversals[s] if t.points or t.crossings))
        heading = disj(
            conj((came(s, t.entry), conj(lies(f.layout.pointwork.point[p].machine, x) for p, x in t.points)))
            for t in f.topo.traversals[s]
        )
        stood = conj((f.locking.restart(s), plain, heading, *closed, *alone, *(neg(x) for x in _foul(f, s))))
        yield "S-CALLED", implies(was_called(s), conj((o(s), implies(rests(s), stood))))
        yield "S-PARTED", implies(parted(s), o(s))
    for m in f.layout.machines:
        if s in f.layout.machines.sections[m]:
            told = [(p, x) for p in Position for x in (var(f.sym.machines.command[m, p]), old_command(m, p))]
            quiet = [implies(x, lies(m, p)) for p, x in told]
            held_open = any(
                (d.machine, d.position) == (m, Position.NORMAL) for d in of_points(f.layout.declared.demanded)
            )
            if m in f.layout.machines.device and not held_open:  # it may be closed, and nothing opens it
                quiet = [neg(x) for p, x in told if p is Position.NORMAL]
            yield f"S-QUIET:{m}", implies(f.locking.restart(s), conj(quiet))


def _movement(f: Facts, s: SectionId) -> Iterator[tuple[str, Expr]]:
    """Train and shunting movements apart."""
    moving = conj((o(s), neg(rests(s))))
    yield "M-LOCK", implies(f.locking.train(s), f.locking.any_lock(s))
    ends_here = s in f.track.ends_of_shunts
    for n, x in f.locking.of(s):
        kinds = {r.shunt for r in f.sym.routes.over.get((s, n), ())}
        if kinds == {False} and not ends_here:
            yield f"M-TRAIN:{n}", implies(x, f.locking.train(s))
        if kinds == {True}:
            yield f"M-SHUNT:{n}", implies(x, neg(f.locking.train(s)))
    if f.track.berth(s):
        yield "M-BERTH-HELD", implies(o(s), disj((f.locking.locked(s), overrun(f, s))))
        yield "M-BERTH-MODE", implies(moving, neg(shunting(s)))
        yield "M-BERTH-EMPTY", implies(conj((o(s), f.locking.any_lock(s))), disj((f.seen.been(s), overrun(f, s))))
        leads = [f.locking.locked_out(a, j) for j, a, past in f.track.passed_into(s) if not past]
        yield "M-BERTH-ONE", at_most_one(leads)
        fresh = conj((f.locking.any_lock(s), f.seen.been(s), neg(f.seen.used(s)), neg(f.seen.stale(s))))
        yield "M-BERTH-UNUSED", implies(fresh, conj((o(s), disj(_coming(f, s)))))
        yield (
            "M-BERTH-FRESH",
            implies(
                conj((f.locking.train(s), neg(f.seen.used(s)), neg(f.seen.stale(s)))),
                disj((neg(rests(s)), overrun(f, s))),
            ),
        )
        yield "M-BERTH-ARRIVED", implies(conj((moving, neg(f.locking.train(s)))), f.seen.used(s))
        for n, x in f.locking.of(s):
            a, b = f.track.way(s, n)
            out = f.track.signal_out(s, b)
            if out is not None and not f.layout.signalling.signal[SignalId(out)].main:
                yield f"M-BERTH-END:{n}", implies(conj((x, moving, came(s, a))), f.locking.train(s))
        return
    along = disj(conj((x, came(s, f.track.way(s, n)[0]))) for n, x in f.locking.of(s))
    yield "M-MODE", implies(conj((moving, neg(shunting(s)))), conj((f.locking.train(s), along)))
    for n, x in f.locking.of(s):
        a, b = f.track.way(s, n)
        if f.track.signal_out(s, b) is None:
            yield f"M-STRAIGHT:{n}", implies(conj((x, moving, came(s, a), f.locking.train(s))), neg(shunting(s)))


def _coming(f: Facts, s: SectionId) -> list[Expr]:
    """A train stands across an end of a section, going in: one expression for each end."""
    return [across(j, here) for j, here, there in _all_joints(f) if there == s]


def _joint(f: Facts, j: str, s: str, t: str, past: bool) -> Iterator[tuple[str, Expr]]:
    """Along a joint over which locks go on, from s to t; `past`: past a shunt signal, so that only trains go on."""
    if not past:
        yield "J-REST", implies(conj((across(j, s), rests(s))), rests(t))
    out, into = f.locking.locked_out(s, j), f.locking.locked_in(t, j)
    if past:
        out, into = conj((out, f.locking.train(s))), conj((into, f.locking.train(t)))
        yield "J-FROM", implies(into, neg(f.locking.restart(s)))
    elif f.track.berth(t):
        shunt = conj((out, neg(f.locking.train(s))))
        yield "J-SHUNT", implies(shunt, conj((f.locking.locked(t), neg(f.locking.train(t)))))
        yield "J-SHUNT-FIRM", implies(conj((shunt, f.locking.firm(s))), disj((f.locking.restart(t), f.locking.firm(t))))
        for k in f.topo.ends[SectionId(t)]:
            g = f.topo.signal_into.get((k, SectionId(t)))
            if g is not None:
                waiting = disj(
                    x
                    for shunts in f.track.functions(g)
                    if names.accepted(g, shunts) in f.plant.state
                    for x in (accepted(g, shunts), lamp(g, shunts), f.sym.routes.passing(g, shunts))
                )
                yield (
                    f"J-SHUNT-ALONE:{k}",
                    implies(conj((shunt, f.locking.locked_in(t, k))), conj((f.seen.used(t), neg(waiting)))),
                )
        yield "J-SHUNT-STALE", implies(conj((shunt, f.seen.stale(s))), disj((f.locking.restart(t), f.seen.stale(t))))
        out, into = conj((out, f.locking.train(s))), conj((into, f.locking.train(t)))
    elif f.track.shunts:
        yield (
            "J-KIND",
            implies(
                out,
                disj(
                    (
                        conj((f.locking.train(s), f.locking.train(t))),
                        neg(disj((f.locking.train(s), f.locking.train(t)))),
                    )
                ),
            ),
        )
    if not past and not f.track.berth(t):
        yield from _apart(f, j, s, t)
    yield "J-ON", implies(out, into)
    yield "J-FIRM", implies(conj((out, f.locking.firm(s))), f.locking.firm(t))
    yield "J-NOT-FIRM", implies(conj((out, f.locking.firm(t))), f.locking.firm(s))
    yield "J-STALE", implies(conj((out, f.seen.stale(s))), f.seen.stale(t))
    yield "J-BEEN", implies(conj((out, f.seen.been(t))), f.seen.been(s))
    yield "J-USED", implies(conj((out, f.seen.used(t))), f.seen.used(s))
    for n, x in f.locking.of(s):
        a, b = f.track.way(s, n)
        if b == j:
            goes = conj((x, f.locking.train(s))) if past or f.track.berth(t) else x
            if past:
                goes = conj((goes, neg(shunting(s))))
            yield (
                f"J-AHEAD:{n}",
                implies(conj((goes, o(s), came(s, a), neg(_stays(f, s)), neg(across(j, s)))), neg(f.seen.been(t))),
            )


def _apart(f: Facts, j: str, s: str, t: str) -> Iterator[tuple[str, Expr]]:
    """Ways that meet at a joint without a signal, but of which no route has both: the author excludes it."""
    before = [(n, _over(f, s, n)) for n, _ in f.locking.of(s) if f.track.way(s, n)[1] == j]
    after = [(m, _over(f, t, m)) for m, _ in f.locking.of(t) if f.track.way(t, m)[0] == j]
    for n, those in before:
        for m, others in after:
            if those.isdisjoint(others):
                yield f"J-APART:{n}:{m}", neg(conj((f.locking.lock(s, n), f.locking.lock(t, m))))


def _over(f: Facts, s: str, n: int) -> set[int]:
    """The numbers of the routes over a way."""
    return {r.number for r in f.sym.routes.over.get((SectionId(s), n), ())}


def _crossing_joint(f: Facts, j: str, s: str, t: str) -> Iterator[tuple[str, Expr]]:
    """A train stands across a joint, from s to t (t may be outside, s may be an approach section)."""
    if t and s in f.sym.sections.restart and not f.track.berth(s):
        unmoved = rests(t) if not f.track.berth(t) else f.locking.restart(t)
        yield "X-CALLED", implies(conj((across(j, s), rests(s), f.locking.restart(s))), disj((unmoved, was_called(s))))
    if t and s in f.sym.sections.restart and not f.track.berth(t):
        yield "X-ASTRIDE", implies(conj((across(j, s), f.locking.restart(t))), f.locking.restart(s))
    yield "X-BOTH", implies(across(j, s), conj((o(s), conj((o(t), came(t, j))) if t else o(s))))
    if SectionId(s) in f.topo.ends:
        heading = disj(
            conj((came(s, way.entry), conj(lies(f.layout.pointwork.point[p].machine, x) for p, x in way.points)))
            for way in f.topo.traversals[SectionId(s)]
            if way.exit == j
        )
        leads, turned = [], []
        for n, x in f.locking.of(s):
            a, b = f.track.way(s, n)
            if b == j:
                leads.append(conj((x, came(s, a))))
            if a == j and f.track.signal_out(s, j) is not None:
                turned.append(conj((x, came(s, b))))
        moves = conj((across(j, s), neg(rests(s))))
        if f.track.shunts and t and (j, t) in f.topo.signal_into and not f.track.berth(t):
            shunts = conj((across(j, s), neg(rests(t)), shunting(t)))
            yield "X-KIND", implies(shunts, neg(f.locking.train(t)))
        if f.track.shunts and t and (j, t) not in f.topo.main_into:
            as_train = conj((across(j, s), neg(rests(t)), neg(shunting(t))))
            yield "X-PASSING", implies(as_train, conj((f.locking.train(s), disj(leads))))
        yield (
            "X-REAR",
            implies(
                conj((across(j, s), neg(conj((overrun(f, s), neg(f.locking.firm(s))))))),
                disj((f.seen.used(s), f.seen.stale(s))),
            ),
        )
        if not f.track.berth(s):
            yield "X-HEADING", implies(conj((across(j, s), rests(s))), heading)
            yield "X-FROM", implies(moves, disj([*leads, *turned]))
        if t and f.track.berth(t):
            yield "X-INTO", implies(conj((across(j, s), neg(rests(t)))), f.locking.train(t))
    elif t and f.track.berth(t):
        yield "X-INTO", implies(conj((across(j, s), neg(rests(t)))), f.locking.train(t))
    if t and f.track.berth(t):
        stands = conj((across(j, s), f.locking.any_lock(t)))
        if (j, t) in f.topo.signal_into:
            yield "X-LOCKED", implies(stands, f.locking.locked_in(t, j))
        else:
            over = disj(
                overran(g, t)
                for (g, _), ways in f.sym.overlaps.ways.items()
                if names.OVERRAN(g, t) in f.plant.state and any(a == t and f.track.way(a, n)[0] == j for a, n in ways)
            )
            yield "X-LOCKED", implies(conj((stands, neg(over), neg(overrun(f, s)))), f.locking.locked_out(s, j))
    if t and not (f.track.berth(t) and (j, t) not in f.topo.signal_into):
        fresh = conj((f.locking.locked_in(t, j), f.seen.been(t), neg(f.seen.used(t)), neg(f.seen.stale(t))))
        yield "X-UNUSED", implies(fresh, conj((o(t), across(j, s))))


def _signal(f: Facts, g: SignalId, shunt: bool) -> Iterator[tuple[str, Expr]]:
    signal = f.layout.signalling.signal[g]
    j, t = signal.node, f.layout.track.section_of(signal.into)
    boundary = f.layout.track.boundary_at.get(j)
    rear: str | None = f.topo.beyond(t, j)
    if boundary is not None:
        rear = boundary.approach or names.outside(j)
    if rear is None or names.accepted(g, shunt) not in f.plant.state:
        return
    mark = "G-SHUNT" if shunt else "G"
    went = accepted(g, shunt)
    shown = disj((f.sym.aspects.signal(g, shunt), lamp(g, shunt)))
    routes = f.sym.routes.of_signal.get(SignalId(g), [])
    passing = f.sym.routes.passing(g, shunt)
    if passing is FALSE and all(r.shunt is not shunt for r in routes):  # a limit of shunt, say
        yield f"{mark}-NEVER", neg(disj((shown, went)))
        return
    kind = neg(f.locking.train(t)) if shunt else f.locking.train(t)
    locked = conj((f.locking.firm(t), f.locking.locked_in(t, j), kind))
    ready = conj((locked, neg(f.seen.passed(t))))
    fresh = conj((ready, implies(f.seen.been(t), conj((o(t), across(j, rear))))))
    if passing is FALSE:
        yield f"{mark}-SHOWN", implies(shown, fresh)
    else:
        left = parted(rear) if rear in f.sym.sections.restart and not f.track.berth(rear) else FALSE
        alone = disj((neg(o(rear)), across(j, rear), left, conj((kind, neg(f.seen.been(t)), neg(f.seen.passed(t))))))
        yield f"{mark}-SHOWN", implies(shown, conj((f.locking.firm(t), f.locking.locked_in(t, j), alone)))
        new = disj(var(r.proceed) for r in f.sym.routes.of_signal.get(SignalId(g), ()) if r.shunt is shunt)
        yield f"{mark}-SHOWN-NEW", implies(new, conj((fresh, neg(image(t)))))
    yield f"{mark}-ACCEPTED", implies(went, conj((ready, neg(f.seen.been(t)), neg(o(t)))))
    standing = [o(rear), neg(across(j, rear))]
    if rear in f.sym.sections.restart and not f.track.berth(rear):
        standing.append(
            disj(
                conj((came(rear, way.entry), conj(lies(f.layout.pointwork.point[p].machine, x) for p, x in way.points)))
                for way in f.topo.traversals[SectionId(rear)]
                if way.exit == j
            )
        )
    yield f"{mark}-TRAIN", implies(went, conj(standing))
    if names.IMAGE(rear) in f.plant.state:
        yield f"{mark}-REPORTED", implies(went, image(rear))
    if not shunt:
        for h, train in first_behind(f, t):
            if h == g and t in f.sym.cancellation.rear_cleared:
                come = conj((train, var(f.sym.cancellation.rear_cleared[t])))
                yield "G-NOBODY-MORE", implies(come, neg(disj((shown, went))))
                if met(f, t):  # what came in runs, or is a train that overran the signal, and stands
                    yield "G-WHOLLY-IN", implies(conj((come, neg(rests(t)))), neg(across(j, rear)))
    if rear in f.sym.sections.restart:
        yield f"{mark}-REAR", _from_rear(f, j, SectionId(rear), disj((shown, went)))
    active = disj(var(r.active) for r in routes)
    seen = disj(var(r.shown) for r in routes)
    yield f"{mark}-MEMORY", implies(conj((active, disj((went, lamp(g, shunt))))), seen)
    if routes:
        yield f"{mark}-CANCEL", implies(var(f.sym.cancellation.cancelling[g]), neg(f.sym.aspects.signal(g, shunt)))


def _from_rear(f: Facts, joint: str, rear: SectionId, called: Expr) -> Expr:
    """A train is called from a section that is still locked since the restart only if it has no points, and its
    crossings and bridges are closed, and stay so while the train leaves it, and nothing stands across its rear end."""
    out = []
    if any(t.points or t.crossings for t in f.topo.traversals[rear]):
        out.append(implies(called, neg(f.locking.restart(rear))))
    stood = conj((f.locking.restart(rear), called))
    for d in f.layout.signalling.devices:
        if rear in d.over:
            out.append(implies(stood, f.seen.settled(MachineId(d.id), Position.REVERSE)))
    behind = [
        conj((across(k, t), f.locking.restart(t))) if f.track.berth(rear) else across(k, t)
        for k in f.topo.ends[rear]
        if k != joint and (t := f.topo.beyond(rear, k)) is not None
    ]
    out.append(implies(stood, neg(disj((*behind, *_foul(f, rear))))))
    return conj(out)


def _foul(f: Facts, s: SectionId) -> list[Expr]:
    """Something has stood foul of a section since the restart."""
    return [conj((f.locking.restart(x.section), o(x.section))) for x in f.track.fouls if x.neighbour == s]


def _stays(f: Facts, s: str) -> Expr:
    """What stands in s does not move on: since the restart, or it was left there."""
    return rests(s) if f.track.berth(s) else disj((rests(s), parted(s)))


def _route(f: Facts, r: RouteSymbols) -> Iterator[tuple[str, Expr]]:
    active, locked, shows = var(r.active), var(r.locked), var(r.proceed)
    first = r.path.ways[0][0]
    yield "R-LOCKS", implies(active, conj(f.locking.lock(s, n) for s, n in r.path.ways))
    yield "R-UNUSED", implies(active, conj(neg(f.seen.used(s)) for s, _ in r.path.ways))
    yield "R-FIRM", implies(locked, conj([active, *(f.locking.firm(s) for s, _ in r.path.ways)]))
    yield "R-SETTING", implies(conj((active, neg(locked))), conj(neg(f.locking.firm(s)) for s, _ in r.path.ways))
    trusted = TRUE if r.call_on else neg(f.seen.stale(first))
    yield "R-PROCEED", implies(shows, conj((locked, var(r.shown), trusted)))
    if r.call_on:
        yield "R-CALL-ON", implies(active, conj(f.seen.stale(s) for s, _ in r.path.ways))
        yield "R-CALL-ON-FREE", implies(active, conj(neg(x) for s, _ in r.path.ways for x in f.locking.overlaps(s)))
        yield "R-CALL-ON-ONCE", implies(conj((var(r.want), var(r.shown))), shows)
        yield "R-CALL-ON-CLEAR", implies(shows, neg(image(first)))
        yield "R-CALL-ON-BEEN", implies(conj((active, f.seen.been(first))), var(r.shown))
    yield "R-WANTED", implies(var(r.want), active)
    yield "R-SHOWN", implies(var(r.shown), locked)
    yield "R-SHUT", implies(f.seen.shut(r.number), conj((active, neg(var(r.want)), neg(shows))))
    if f.track.shunts:
        kind = [neg(f.locking.train(s)) if r.shunt else f.locking.train(s) for s, _ in r.path.ways]
        yield "R-KIND", implies(active, conj(kind))
    if r.passing is not None:
        yield from _passing(f, r, r.passing)
    if r.path.identifier:
        yield from _identifier(f, r)
    if r.path.onward is not None:
        yield "R-PAST", implies(shows, var(f.sym.routes.number[r.path.onward].proceed))
    yield from added_invariants(f, r)
    if r.path.overlap is not None:
        yield "R-OVERLAP", implies(active, _overlap_of(f, r.path.overlap))
    if r.path.berth is not None:
        yield (
            "R-BERTH",
            implies(active, conj((f.locking.locked(r.path.berth[0]), neg(f.locking.train(r.path.berth[0]))))),
        )


def _identifier(f: Facts, r: RouteSymbols) -> Iterator[tuple[str, Expr]]:
    """While a signal shows its identifier light, the section before it is locked towards it for one route alone: the
    one that leads past it."""
    before, node = f.sym.cancellation.approach_of[r.entry], f.layout.signalling.signal[r.entry].node
    assert before is not None
    lit = var(r.proceed)
    yield (
        "R-IDENTIFIER",
        implies(lit, conj((f.locking.locked_out(before, node), f.locking.firm(before), f.locking.train(before)))),
    )
    for x in f.sym.routes:
        s, n = x.path.ways[-1]
        if s == before and f.track.way(s, n)[1] == node and x.number not in r.path.parts_of:
            own = [x.active] if x.passing is None else [x.active, x.passing]
            yield f"R-IDENTIFIER-ALONE:{x.number}", implies(lit, neg(disj(map(var, own))))


def _overlap_of(f: Facts, option: tuple[SignalId, int]) -> Expr:
    """The overlap is held, or any other of the signal's where it may swing."""
    if option[0] not in f.sym.overlaps.swings:
        return var(f.sym.overlaps.held[option])
    return disj(var(name) for o, name in f.sym.overlaps.held.items() if o[0] == option[0])


def _passing(f: Facts, r: RouteSymbols, name: names.Name) -> Iterator[tuple[str, Expr]]:
    """The signal is open for the movement that passes it: everything is still locked, and nobody comes after it."""
    first, rear = r.path.ways[0][0], f.sym.cancellation.approach_of[r.entry]
    assert rear is not None
    passing = var(name)
    kind = (
        [neg(f.locking.train(s)) if r.shunt else f.locking.train(s) for s, _ in r.path.ways] if f.track.shunts else []
    )
    held = [x for s, n in r.path.ways for x in (f.locking.lock(s, n), f.locking.firm(s))]
    yield "R-PASSING", implies(passing, conj([*held, *kind, f.seen.used(first), image(first), image(rear)]))
    if rear in f.sym.sections.restart:
        overran = conj((neg(f.locking.firm(rear)), disj(f.locking.overlaps(rear))))
        yield "R-PASSING-LAST", implies(passing, disj((f.locking.restart(rear), f.seen.been(rear), overran)))
    for h in f.seen.overrun(rear):
        yield f"R-PASSING-ALONE:{h}", implies(passing, neg(running_into(f, h, rear)))
    if r.path.overlap is not None:
        yield "R-PASSING-OVERLAP", implies(passing, _overlap_of(f, r.path.overlap))
    if r.path.berth is not None:
        yield (
            "R-PASSING-BERTH",
            implies(passing, conj((f.locking.locked(r.path.berth[0]), neg(f.locking.train(r.path.berth[0]))))),
        )
