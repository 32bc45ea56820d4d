"""The invariants that make the claims inductive, one per element.

They tie the controller's locks to the trains: every moving train stands in sections that are firmly locked for
its way; ahead of its head nobody has been since the lock; behind a joint without a signal the lock goes on.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.controller import RouteSymbols
from interlock.logic.expr import Expr, at_most_one, conj, disj, implies, neg, var
from interlock.logic.plant import accepted, across, came, image, lamp, lies, o, old_command, rests
from interlock.model.elements import Position, SectionId, SignalId
from interlock.proof.invariants.kinds import Facts, Invariant


def strengthening(f: Facts) -> tuple[Invariant, ...]:
    """All of them, ordered by element."""
    out: list[Invariant] = []
    for s in f.topo.sections:
        out += [Invariant(i, s, x) for i, x in _section(f, s)]
    for j, s, t in f.plain_joints():
        out += [Invariant(i, f"{j}:{s}>{t}", x) for i, x in _joint(f, j, s, t)]
    for joint, here, there in _all_joints(f):
        out += [Invariant(i, f"{joint}:{here}>{there}", x) for i, x in _crossing_joint(f, joint, here, there)]
    for g in f.layout.signals:
        out += [Invariant(i, g.id, x) for i, x in _signal(f, g.id)]
    for r in f.sym.routes:
        out += [Invariant(i, r.id, x) for i, x in _route(f, r)]
    for m in sorted(f.layout.ends_of_machine):
        out.append(
            Invariant(
                "P-ONE",
                m,
                conj(
                    (
                        at_most_one(lies(m, x) for x in Position),
                        at_most_one(var(f.sym.command[m, x]) for x in Position),
                        at_most_one(old_command(m, x) for x in Position),
                    )
                ),
            )
        )
    return tuple(out)


def _all_joints(f: Facts) -> list[tuple[str, str, str]]:
    """Every (joint, from, to), with the outside of boundaries; `to` is empty outside."""
    out: list[tuple[str, str, str]] = []
    for s in f.topo.sections:
        for j in f.topo.ends[s]:
            if j in f.layout.buffer_at:
                continue
            out.append((j, s, f.topo.beyond(s, j) or ""))
            boundary = f.layout.boundary_at.get(j)
            if boundary is not None:
                outside = boundary.approach or f"outside.{j}"
                if f"o.{outside}" in f.system.plant.state:
                    out.append((j, outside, s))
    return out


def _section(f: Facts, s: SectionId) -> Iterator[tuple[str, Expr]]:
    locks = f.locks(s)
    yield "S-ONE", at_most_one([f.restart(s), *(x for _, x in locks)])
    yield "S-FIRM", implies(f.firm(s), f.any_lock(s))
    yield "S-USED", implies(f.used(s), disj((f.restart(s), f.firm(s))))
    yield "S-PASSED", implies(f.passed(s), f.used(s))
    yield "S-RESTART", implies(f.restart(s), f.used(s))
    yield "S-STALE", implies(f.stale(s), f.any_lock(s))
    yield "S-BEEN", implies(f.been(s), f.firm(s))
    yield (
        "S-CAME",
        conj(
            (
                at_most_one(came(s, j) for j in f.topo.ends[s]),
                implies(o(s), disj(came(s, j) for j in f.topo.ends[s])),
                *(implies(came(s, j), o(s)) for j in f.topo.ends[s]),
            )
        ),
    )
    yield "S-REST", conj((implies(rests(s), conj((o(s), f.restart(s)))), implies(conj((f.restart(s), o(s))), rests(s))))
    trains = []
    for n, x in locks:
        a, b = f.way(s, n)
        turned = came(s, b) if f.signal_out(s, a) is not None else conj((came(s, b), rests(s)))
        trains.append(conj((x, disj((came(s, a), turned)))))
    yield "S-TRAIN", implies(conj((o(s), neg(rests(s)))), conj((f.firm(s), f.been(s), disj(trains))))
    yield "S-SEEN", implies(conj((o(s), image(s), neg(rests(s)))), disj((f.used(s), f.stale(s))))
    for n, x in locks:
        for m, p in f.sym.demands[s, n]:
            yield f"S-COMMAND:{n}:{m}", implies(x, var(f.sym.command[m, p]))
            yield f"S-LIES:{n}:{m}", implies(conj((x, f.firm(s))), conj((lies(m, p), old_command(m, p))))
        for other, whole, numbers in f.sym.excluded[s, n]:
            against = f.held(other) if whole else disj([f.restart(other), *(f.lock(other, k) for k in numbers)])
            yield f"S-EXCLUDES:{n}:{other}", implies(x, neg(against))
        yield f"S-PASSED-BEEN:{n}", implies(conj((x, f.passed(s))), f.been(s))
    for m, ends in sorted(f.layout.ends_of_machine.items()):
        if any(f.layout.section_of(p.toe) == s for p in ends):
            rest = disj(
                conj((lies(m, p), neg(var(f.sym.command[m, p.other])), neg(old_command(m, p.other)))) for p in Position
            )
            yield f"S-AT-REST:{m}", implies(f.firm(s), rest)
            quiet = [implies(x, lies(m, p)) for p in Position for x in (var(f.sym.command[m, p]), old_command(m, p))]
            yield f"S-QUIET:{m}", implies(f.restart(s), conj(quiet))


def _joint(f: Facts, j: str, s: str, t: str) -> Iterator[tuple[str, Expr]]:
    """Along a joint without signal, from s to t."""
    yield "J-REST", implies(conj((across(j, s), rests(s))), rests(t))
    out, into = f.locked_out(s, j), f.locked_in(t, j)
    yield "J-ON", implies(out, into)
    yield "J-FIRM", implies(conj((out, f.firm(s))), f.firm(t))
    yield "J-NOT-FIRM", implies(conj((out, f.firm(t))), f.firm(s))
    yield "J-STALE", implies(conj((out, f.stale(s))), f.stale(t))
    yield "J-BEEN", implies(conj((out, f.been(t))), f.been(s))
    yield "J-USED", implies(conj((out, f.used(t))), f.used(s))
    for n, x in f.locks(s):
        a, b = f.way(s, n)
        if b == j:
            yield f"J-AHEAD:{n}", implies(conj((x, o(s), came(s, a), neg(rests(s)), neg(across(j, s)))), neg(f.been(t)))


def _crossing_joint(f: Facts, j: str, s: str, t: str) -> Iterator[tuple[str, Expr]]:
    """A train stands across a joint, from s to t (t may be outside, s may be an approach section)."""
    yield "X-BOTH", implies(across(j, s), conj((o(s), conj((o(t), came(t, j))) if t else o(s))))
    if SectionId(s) in f.topo.ends:
        heading = disj(
            conj((came(s, way.entry), conj(lies(f.layout.point[p].machine, x) for p, x in way.points)))
            for way in f.topo.traversals[SectionId(s)]
            if way.exit == j
        )
        yield "X-HEADING", implies(conj((across(j, s), rests(s))), heading)
        leads = []
        for n, x in f.locks(s):
            a, b = f.way(s, n)
            if b == j:
                leads.append(conj((x, came(s, a))))
            if a == j and f.signal_out(s, j) is not None:
                leads.append(conj((x, came(s, b))))
        yield "X-REAR", implies(across(j, s), disj((f.used(s), f.stale(s))))
        yield "X-FROM", implies(conj((across(j, s), neg(rests(s)))), disj(leads))
    if t:
        yield (
            "X-UNUSED",
            implies(conj((f.locked_in(t, j), f.been(t), neg(f.used(t)), neg(f.stale(t)))), conj((o(t), across(j, s)))),
        )


def _signal(f: Facts, g: SignalId) -> Iterator[tuple[str, Expr]]:
    signal = f.layout.signal[g]
    j, t = signal.node, f.layout.section_of(signal.into)
    boundary = f.layout.boundary_at.get(j)
    rear: str | None = f.topo.beyond(t, j)
    if boundary is not None:
        rear = boundary.approach or f"outside.{j}"
    if rear is None or f"go.{g}" not in f.system.plant.state:
        return
    shown = disj((f.sym.signal(g), lamp(g)))
    ready = conj((f.firm(t), f.locked_in(t, j), neg(f.passed(t))))
    yield "G-SHOWN", implies(shown, conj((ready, implies(f.been(t), conj((o(t), across(j, rear)))))))
    yield "G-ACCEPTED", implies(accepted(g), conj((ready, neg(f.been(t)), neg(o(t)))))
    standing = [o(rear), neg(across(j, rear))]
    if rear in f.sym.restart:
        standing.append(
            disj(
                conj((came(rear, way.entry), conj(lies(f.layout.point[p].machine, x) for p, x in way.points)))
                for way in f.topo.traversals[SectionId(rear)]
                if way.exit == j
            )
        )
    yield "G-TRAIN", implies(accepted(g), conj(standing))
    if f"img.{rear}" in f.system.plant.state:
        yield "G-REPORTED", implies(accepted(g), image(rear))
    routes = [r for r in f.sym.routes if r.entry == g]
    active = disj(var(r.active) for r in routes)
    seen = disj(var(r.shown) for r in routes)
    yield "G-MEMORY", implies(conj((active, disj((accepted(g), lamp(g))))), seen)
    if routes:
        yield "G-CANCEL", implies(var(f.sym.cancelling[g]), neg(f.sym.signal(g)))


def _route(f: Facts, r: RouteSymbols) -> Iterator[tuple[str, Expr]]:
    active, locked, shows = var(r.active), var(r.locked), var(r.proceed)
    first = r.ways[0][0]
    yield "R-LOCKS", implies(active, conj(f.lock(s, n) for s, n in r.ways))
    yield "R-UNUSED", implies(active, conj(neg(f.used(s)) for s, _ in r.ways))
    yield "R-FIRM", implies(locked, conj([active, *(f.firm(s) for s, _ in r.ways)]))
    yield "R-SETTING", implies(conj((active, neg(locked))), conj(neg(f.firm(s)) for s, _ in r.ways))
    yield "R-PROCEED", implies(shows, conj((locked, var(r.shown), neg(f.stale(first)))))
    yield "R-WANTED", implies(var(r.want), locked)
    yield "R-SHOWN", implies(var(r.shown), locked)
