"""What the author adds to routes (R5, R6): hostile routes, and points that they demand.

Claims find the routes on the layout, by the author's choices; invariants tie the bit that remembers them to routes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, iff, implies, neg, var
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import Choice, SignalId, of_points, of_sections
from interlock.model.traversal import Traversal
from interlock.proof.claims.kinds import Facts
from interlock.proof.claims.paths import SignalPath, lie, signal_paths


def chosen(f: Facts, choice: Choice, g: SignalId, shunt: bool) -> list[tuple[int, SignalPath]]:
    """The paths of a signal among the author's choice, with their numbers."""
    return [(k, p) for k, p in enumerate(signal_paths(f, g, shunt), 1) if fits(f, choice, g, shunt, p.ways, not shunt)]


def fits(f: Facts, choice: Choice, g: SignalId, shunt: bool, ways: Sequence[Traversal], called_on: bool) -> bool:
    """Whether a route over these ways is among the author's choice; `called_on`: trains may be called on over it."""
    last = ways[-1]
    ahead = f.topo.beyond(last.section, last.exit)
    signal = None if ahead is None else f.topo.signal_into.get((last.exit, ahead))
    ends = {str(last.section), str(last.exit), *([str(signal)] if signal is not None else [])}
    return choice.fits(g, ends, {t.section for t in ways}, shunt, called_on)


def _aspect(f: Facts, choice: Choice, g: SignalId, shunt: bool) -> Expr:
    """The signal shows proceed for the author's choice: for call-on routes alone its call-on aspect."""
    if not choice.called_on:
        return f.sym.aspects.signal(g, shunt)
    return var(f.sym.aspects.call_on[g]) if g in f.sym.aspects.call_on and not shunt else FALSE


def declared(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """S-DECLARED, for each two signals with such routes."""
    callings = [(g.id, k) for g in f.layout.signalling.signals for k in f.track.functions(g.id)]

    def shown(g: SignalId, shunt: bool, choice: Choice) -> Expr:
        over = disj(lie(f, p.ways) for _, p in chosen(f, choice, g, shunt))
        return conj((_aspect(f, choice, g, shunt), over))

    for i, b in enumerate(f.layout.declared.barred, 1):
        ones = [(who, x) for who in callings if (x := shown(*who, b.one)) is not FALSE]
        others = [(who, x) for who in callings if (x := shown(*who, b.other)) is not FALSE]
        for (g, k), x in ones:
            for (h, m), y in others:
                if g != h:
                    who, whom = _who(g, k, b.one.called_on), _who(h, m, b.other.called_on)
                    yield "S-DECLARED", f"{i}: {who} and {whom}", neg(conj((x, y)))


def held(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """What was added is held from proceed on until the train is wholly in the last section: hostile routes by no two at
    once, points commanded."""
    after = f.after
    for r in f.sym.routes:
        if r.added is None:
            continue
        id_, holds = "S-DECLARED" if _among_hostile(f, r) else "S-DEMANDED", var(r.added)
        yield id_, f"{r.id} held", implies(after(var(r.proceed)), after(holds))
        ends = conj((holds, neg(after(holds))))
        last = conj((_last_lock(f, r), neg(_hold_begun(f, r))))
        yield id_, f"{r.id} given up", implies(ends, neg(disj((var(r.active), after(var(r.active)), last))))
        yield from _held_longer(f, r)
        for d in of_points(f.layout.declared.demanded):
            if (d.machine, d.position) in r.path.demands and route_fits(f, d.routes, r):
                commanded = after(var(f.sym.machines.command[d.machine, d.position]))
                yield "S-DEMANDED", f"{r.id} {d.machine} held", implies(after(holds), commanded)
    for i, b in enumerate(f.layout.declared.barred, 1):
        ones, others = ([r for r in f.sym.routes if route_fits(f, x, r)] for x in (b.one, b.other))
        for r, x in ((r, x) for r in ones for x in others if r is not x):
            both = conj(after(var(name)) for name in (r.added, x.added) if name is not None)
            yield "S-DECLARED", f"{i}: {r.id} and {x.id}", neg(both)


def _held_longer(f: Facts, r: RouteSymbols) -> Iterator[tuple[str, str, Expr]]:
    """What was added is given up when the route's hold is over, and no sooner; the hold does not begin before the route
    would give it up without, and ends when it is set again."""
    if not hold_s(f, r):
        return
    timer = r.path.hold_timer
    holds, input_, over = var(r.added) if r.added is not None else FALSE, TRUE, FALSE
    if timer is not None:
        input_, over = var(f.timers[timer].input), var(timer)
    yield "S-DEMANDED", f"{r.id} held longer", implies(conj((holds, neg(f.after(holds)))), over)
    begun, going = _hold_begun(f, r), disj((neg(holds), var(r.active), _last_lock(f, r)))
    runs = conj((holds, neg(var(r.active)), disj((begun, neg(_last_lock(f, r))))))
    yield "S-DEMANDED", f"{r.id} held longer since", implies(input_, runs)
    yield "S-DEMANDED", f"{r.id} begun", implies(conj((f.after(begun), neg(begun))), neg(going))
    yield "S-DEMANDED", f"{r.id} begun, not set", implies(f.after(begun), f.after(conj((holds, neg(var(r.active))))))


def _hold_begun(f: Facts, r: RouteSymbols) -> Expr:
    """The hold of a route, which the author asks for, runs since a scan before, whatever others lock."""
    return var(r.path.hold_begun) if r.path.hold_begun is not None and hold_s(f, r) else FALSE


def hold_s(f: Facts, r: RouteSymbols) -> float:
    """Seconds for which a route holds what was added to it after it would give it up: the longest of the author's."""
    return max((d.hold for d in of_points(f.layout.declared.demanded) if route_fits(f, d.routes, r)), default=0.0)


def route_fits(f: Facts, choice: Choice, r: RouteSymbols) -> bool:
    """Whether a route of the controller is among the author's choice."""
    return fits(f, choice, r.entry, r.shunt, _run(f, r), r.call_on)


def _among_hostile(f: Facts, r: RouteSymbols) -> bool:
    return any(route_fits(f, x, r) for b in f.layout.declared.barred for x in (b.one, b.other))


def _run(f: Facts, r: RouteSymbols) -> list[Traversal]:
    """The ways over which a route of the controller leads, the berth at its end among them."""
    keys = [*r.path.ways, *([r.path.berth] if r.path.berth is not None else [])]
    return [f.topo.traversals[s][n - 1] for s, n in keys]


def _last_lock(f: Facts, r: RouteSymbols) -> Expr:
    """The lock that a train leaves behind when it is wholly in the last section; of a route that leads out over a
    boundary, as no shunting movement does, or that has one section, the last one."""
    leaves = not r.shunt and _run(f, r)[-1].exit in f.layout.track.boundary_at
    through = r.path.ways if r.path.berth is not None or leaves else r.path.ways[:-1]
    return f.locking.lock(*(through or r.path.ways)[-1])


def demanded(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """S-DEMANDED, path by path."""
    after = f.after
    for d in of_points(f.layout.declared.demanded):
        m, x = d.machine, d.position
        there = [var(f.sym.machines.detected[m, x]), neg(var(f.sym.machines.detected[m, x.other]))]
        if m in f.sym.machines.trailed:
            there.append(neg(var(f.sym.machines.trailed[m])))
        for g, shunt in ((h.id, k) for h in f.layout.signalling.signals for k in f.track.functions(h.id)):
            for n, path in chosen(f, d.routes, g, shunt):
                here = conj((after(_aspect(f, d.routes, g, shunt)), after(lie(f, path.ways))))
                yield "S-DEMANDED", f"{_who(g, shunt, d.routes.called_on)}:{n} {m} {x}", implies(here, conj(there))
    for a in of_sections(f.layout.declared.demanded):
        for g, shunt in ((h.id, k) for h in f.layout.signalling.signals for k in f.track.functions(h.id)):
            for n, path in chosen(f, a.routes, g, shunt):
                here = conj((after(_aspect(f, a.routes, g, shunt)), after(lie(f, path.ways))))
                who = _who(g, shunt, a.routes.called_on)
                yield "S-DEMANDED", f"{who}:{n} {a.section} clear", implies(here, f.seen.steadily_clear(a.section))


def _who(g: SignalId, shunt: bool, called_on: bool) -> str:
    return f"{g} shunt" if shunt else f"{g} call-on" if called_on else g


def called_on_lit(f: Facts) -> Iterator[tuple[SignalId, Expr]]:
    """The call-on aspect is lit for call-on routes and no others, where the author adds something to these alone, or
    excludes some of them alone."""
    told: list[Choice] = [x for b in f.layout.declared.barred for x in (b.one, b.other)]
    told += [*(d.routes for d in f.layout.declared.demanded), *f.layout.declared.excluded]
    for g, lamp in f.sym.aspects.call_on.items():
        if any(x.called_on and x.entry in (None, g) for x in told):
            yield g, iff(var(lamp), f.sym.routes.called(g))


def added_invariants(f: Facts, r: RouteSymbols) -> Iterator[tuple[str, Expr]]:
    """What was added is held while a route is set and while its signal is open, also where it closes behind the whole
    movement; no two that exclude each other hold it; the points are commanded."""
    if r.added is None:
        return
    holds = var(r.added)
    yield "R-ADDED", implies(disj((var(r.active), *(var(n) for n in r.open_while))), holds)
    if r.path.hold_begun is not None:
        closed = (neg(var(n)) for n in (r.active, *r.open_while))
        yield "R-HOLD-BEGUN", implies(var(r.path.hold_begun), conj((holds, *closed)))
    of = {x.number: x.added for x in f.sym.routes}
    for n in r.path.barred:
        other = of[n]
        if n > r.number and other is not None:
            yield f"R-DECLARED:{n}", neg(conj((holds, var(other))))
    for m, x in r.path.demands:
        yield f"R-DEMANDED:{m}", implies(holds, var(f.sym.machines.command[m, x]))
