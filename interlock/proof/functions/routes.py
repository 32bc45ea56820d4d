"""Routes and signals: what is refused, and what stays at stop, has a reason."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, iff, implies, neg, var
from interlock.logic.names import Name
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import Position, SectionId, SignalId, of_sections
from interlock.model.overlap import route_speed
from interlock.model.principles import Caution, Closes
from interlock.proof.claims.added import route_fits
from interlock.proof.claims.aspects import allows_clear, turned_inside
from interlock.proof.claims.paths import SignalPath
from interlock.proof.functions.shared import Option, held_beside, over_held
from interlock.proof.functions.words import Way, Words


def routes(w: Words) -> Iterator[tuple[str, str, Expr]]:
    """F-GRANT to F-SHOWN route by route, F-CANCEL signal by signal."""
    for r in w.sym.routes:
        yield from _route(w, r)
    for g, name in w.sym.cancellation.cancelling.items():
        x, active, done = var(name), w.signals.active(g), w.signals.given_up(g)
        withdrawn = (conj((var(r.active), _withdrawn(w, r))) for r in w.sym.routes.of_signal.get(g, ()))
        going = conj((disj((x, var(w.sym.cancellation.cancel[g]), *withdrawn)), active, neg(done)))
        yield "F-CANCEL", g, conj((iff(w.after(x), going), implies(done, neg(w.after(active)))))


def _grants(w: Words, r: RouteSymbols) -> Iterator[tuple[str, str, Expr]]:
    """When a route is set, and what of it is locked then."""
    after, sym, active = w.after, w.sym, var(r.active)
    if r.path.identifier:  # it is set with a route that leads past its signal
        yield (
            "F-GRANT",
            r.id,
            iff(w.signals.set_now(r), disj(w.signals.set_now(sym.routes.number[n]) for n in r.path.parts_of)),
        )
    else:
        refused = conj((sym.requests.asked(r.number), neg(active), neg(after(active))))
        parts = sym.routes.parts(r)
        narrow, all_ = (disj(x for p in parts for x in _refusing(w, p, wide)) for wide in (False, True))
        yield "F-GRANT", r.id, implies(refused, all_)
        yield "F-GRANT", f"{r.id} set", implies(w.signals.set_now(r), neg(narrow))
    if r.path.berth is not None:
        unlocked = conj((w.signals.set_now(r), neg(w.f.locking.held(r.path.berth[0]))))
        yield "F-GRANT", f"{r.id} into its berth", implies(unlocked, after(w.f.locking.lock(*r.path.berth)))


def _route(w: Words, r: RouteSymbols) -> Iterator[tuple[str, str, Expr]]:
    after, sym = w.after, w.sym
    active, locked, want, shows, shown = (var(n) for n in (r.active, r.locked, r.want, r.proceed, r.shown))
    cancelling, cancelled = var(sym.cancellation.cancelling[r.entry]), var(sym.cancellation.cancel[r.entry])
    free = conj((neg(cancelling), neg(cancelled), neg(_withdrawn(w, r))))
    yield from _grants(w, r)
    stays = after(active)
    setting = [active, neg(locked), w.valid, free, stays]
    ready, needed = (
        conj((*setting, *_lie(w, r, wide), *_added_lie(w, r), w.ways.overlap_lies(r, wide))) for wide in (True, False)
    )
    yield "F-LOCK", r.id, conj((implies(ready, after(locked)), implies(w.rises(locked), needed)))
    yield "F-LOCK", f"{r.id} stays", implies(conj((locked, stays)), after(locked))
    order, some = conj(_in_order(w, r, True)), conj(_in_order(w, r, False))
    lamp = disj((shows, var(sym.lamp_proof.stop[r.entry]))) if r.entry in sym.lamp_proof.stop else conj(())
    past = _past(w, r)
    opens = conj((active, locked, want, order, free, stays, lamp, past))
    yield "F-OPEN", r.id, implies(opens, after(shows))
    yield "F-OPEN", f"{r.id} locked", implies(after(shows), locked)
    asked = sym.requests.asked(r.number)
    if r.path.identifier:
        asked = _asked_with(w, r)
    again = disj((want, FALSE if r.call_on else asked))
    reopens = disj((past, asked)) if w.sym.routes.parts(r)[1:2] else past  # what it leads past is asked for as well
    free_ = conj((free, *map(neg, _hindering(w, r))))
    wanted, unwanted = (
        neg(conj((again, free_, disj((neg(shown), conj((x, lamp, p))))))) for x, p in ((order, past), (some, reopens))
    )
    kept = conj((disj((wanted, after(want))), implies(unwanted, neg(after(want)))))
    yield "F-WANT", r.id, implies(conj((active, stays)), kept)
    yield "F-WANT", f"{r.id} at first", implies(conj((w.signals.set_now(r), free)), after(want))
    yield "F-WANT", f"{r.id} at last", implies(after(want), after(active))
    if not (r.shunt or r.call_on or r.path.identifier):
        yield from _aspects(w, r, after(shows))
    if r.added is not None:
        yield "F-ADDED", r.id, _holds_added(w, r, r.added)
    if r.path.hold_begun is not None and r.path.hold_timer is not None:
        begun = conj((kept_longer(w, r), neg(var(r.path.hold_timer))))
        yield "F-ADDED", f"{r.id} longer", iff(after(var(r.path.hold_begun)), begun)
    if r.passing is not None:
        yield "F-PASSING", r.id, _passing(w, r, r.passing)
        closes = w.layout.principles.shunt_closes if r.shunt else w.layout.principles.main_closes
        yield "F-PASSING", f"{r.id} as the layout has it", FALSE if r.call_on or closes is Closes.FIRST_AXLE else TRUE
    yield "F-SHOWN", r.id, iff(after(shown), conj((stays, disj((shown, after(shows))))))
    first, number = r.path.ways[0]
    node = w.f.track.way(first, number)[0]
    ended = disj((w.signals.given_up(r.entry), w.sections.coming_in(first, node)))
    yield "F-CANCEL", f"{r.id} ends", iff(w.ends(active), conj((active, ended)))


def _hindering(w: Words, r: RouteSymbols) -> Iterator[Expr]:
    """A section in the way of a route is blocked, or a point that it needs was trailed; or inputs are lost while it is
    to call a train on (R16)."""
    yield neg(w.valid) if r.call_on else FALSE
    beyond = _overlaps(w, r)
    for s, n in (*r.path.ways, *([r.path.berth] if r.path.berth is not None else [])):
        yield from (w.ways.blocked(s), w.ways.trailed(s, n))
    for o in beyond:
        held = var(w.sym.overlaps.held[o]) if len(beyond) > 1 else TRUE
        yield from (conj((held, disj((w.ways.blocked(s), w.ways.trailed(s, n))))) for s, n in w.sym.overlaps.ways[o])
    yield from (var(w.sym.machines.trailed[m]) for m, _ in r.path.demands if w.points.powered(m))


def _asked_with(w: Words, r: RouteSymbols) -> Expr:
    """A route is asked for that leads past the signal and is set with this one, as is all between them."""
    if not r.path.identifier:
        return w.sym.requests.asked(r.number)
    with_ = (w.sym.routes.number[n] for n in r.path.parts_of)
    return disj(conj((var(x.active), _asked_with(w, x))) for x in with_)


def _withdrawn(w: Words, r: RouteSymbols) -> Expr:
    """A route that leads past the signal, and is set with this one, is being cancelled, or a part of it."""
    with_ = w.sym.routes.set_with(r)
    cancel, cancelling = w.sym.cancellation.cancel, w.sym.cancellation.cancelling
    return disj(conj((var(x.active), disj((var(cancel[x.entry]), var(cancelling[x.entry]))))) for x in with_)


def _past(w: Words, r: RouteSymbols) -> Expr:
    """A signal opens for a route that leads past the next one while that shows its identifier light; this shows first
    while such a route is set, and then while the section before it stays firmly locked towards it."""
    shown = conj(w.after(w.sym.aspects.identifies(x.entry)) for x in w.sym.routes.parts(r)[1:2])
    if not r.path.identifier:
        return shown
    before, node = w.sym.cancellation.approach_of[r.entry], w.layout.signalling.signal[r.entry].node
    if before is None:
        return FALSE
    led = conj((w.f.locking.locked_out(before, node), w.f.locking.firm(before), w.f.locking.train(before)))
    with_ = (var(w.sym.routes.number[n].active) for n in r.path.parts_of)
    return conj((led, w.after(w.f.locking.locked_out(before, node)), disj((var(r.proceed), *with_)), shown))


def _passing(w: Words, r: RouteSymbols, name: Name) -> Expr:
    """The signal stays open for the movement that has begun to pass it."""
    first, n = r.path.ways[0]
    node = w.f.track.way(first, n)[0]
    begun = disj((var(name), conj((var(r.proceed), w.sections.coming_in(first, node)))))
    there = [
        w.sections.occupied(first),
        w.sections.occupied(w.sym.cancellation.approach_of[r.entry]),
        neg(var(w.sym.cancellation.cancel[r.entry])),
    ]
    return implies(conj((begun, *there, *_in_order(w, r, True, clear=False))), w.after(var(name)))


def _aspects(w: Words, r: RouteSymbols, shows: Expr) -> Iterator[tuple[str, str, Expr]]:
    """What a main signal shows beside stop while it is open for a train route.  `shows`: it will be."""
    aspects, is_open = w.sym.aspects, w.after(disj(map(var, r.open_while)))
    if r.entry in aspects.caution:
        clear = w.after(var(aspects.clear[r.entry]))
        yield "F-CLEAR", r.id, implies(conj((shows, _may_show_clear(w, r))), clear)
    if r.entry in aspects.second:
        two = var(aspects.second[r.entry])
        told = two if _two_yellows(w, r) else neg(two)
        yield "F-CLEAR", f"{r.id} two yellows", implies(is_open, w.after(told))
    speed = _speed(w, r)
    if speed is not None and (r.entry, speed) in aspects.speed:
        yield "F-SPEED", r.id, implies(is_open, w.after(var(aspects.speed[r.entry, speed])))


def _may_show_clear(w: Words, r: RouteSymbols) -> Expr:
    """The path allows clear, and its lamp is intact (R11)."""
    path = SignalPath(r.entry, False, tuple(w.ways.way(s, n) for s, n in r.path.ways), None)
    lamp = [var(w.sym.lamp_proof.clear[r.entry])] if r.entry in w.sym.lamp_proof.clear else []
    speed = _speed(w, r)
    if speed is not None and speed < w.layout.principles.slow_below_kmh:
        return FALSE
    return conj((allows_clear(w.f, path), *lamp))


def _speed(w: Words, r: RouteSymbols) -> int | None:
    """The highest speed for a route: of its path, and for its overlap (R11, R4)."""
    over = [] if r.path.overlap is None else [w.ways.way(s, n) for s, n in w.sym.overlaps.ways[r.path.overlap]]
    own = route_speed(
        w.layout, [w.ways.way(s, n) for s, n in r.path.ways], "" if r.path.overlap is None else r.path.overlap[0], over
    )
    beyond = None if r.path.onward is None else _speed(w, w.sym.routes.number[r.path.onward])
    return min((v for v in (own, beyond) if v is not None), default=None)


def _two_yellows(w: Words, r: RouteSymbols) -> bool:
    """Whether a train route leads over a reversed point, and not out onto a checked line, or does so past a signal."""
    if w.layout.principles.caution is not Caution.TURNOUT:
        return False
    own = turned_inside(w.f, SignalPath(r.entry, False, tuple(w.ways.way(s, n) for s, n in r.path.ways), None))
    return own or (r.path.onward is not None and _two_yellows(w, w.sym.routes.number[r.path.onward]))


def _lamps(w: Words, r: RouteSymbols) -> Iterator[Name]:
    """The inputs that must say that the lamps are intact by which a train is told of a route (R11)."""
    proof, g = w.sym.lamp_proof, r.entry
    if r.path.identifier:
        yield from (proof.identifier[g],) if g in proof.identifier else ()
        return
    yield from (x for x in (proof.caution.get(g, proof.clear.get(g)),) if x is not None)
    if g in proof.second and _two_yellows(w, r):
        yield proof.second[g]
    if g in proof.speed and _speed(w, r) is not None:
        yield proof.speed[g]


def _kept_clear(w: Words, r: RouteSymbols) -> list[SectionId]:
    """The sections that must be clear: all, but those of a call-on only at first and where vehicles may stand."""
    sections = [s for s, _ in r.path.ways]
    return [s for i, s in enumerate(sections) if not r.call_on or i == 0 or w.f.track.berth(s)]


def _refusing(w: Words, r: RouteSymbols, wide: bool) -> Iterator[Expr]:
    """Why a route is refused (R6); `wide`: with what might count for the flank space or for the limit of a zone."""
    f, clear = w.f, _kept_clear(w, r)
    yield neg(w.valid)
    for s, n in r.path.ways:
        own = [o for o in f.locking.options(s) if (s, n) in over_held(w, o).get(r.entry, ())]
        if r.shunt or r.call_on or r.path.identifier:
            own = []
        yield f.locking.locked(s)
        yield disj(var(name) for o, name in f.locking.options(s).items() if o not in own)
        if s in clear:
            yield neg(w.sections.long(s))
        yield w.ways.blocked(s)
        yield _not_to_be_had(w, (s, n), wide)
    yield from _rear(w, r)
    if r.path.overlap is not None:
        for s, n in w.sym.overlaps.ways[r.path.overlap]:
            yield _not_as_overlap(w, r.path.overlap, (s, n), wide)
    if r.path.berth is not None:
        yield from _berth(w, r.path.berth, wide)
    of = {x.number: x.added for x in w.sym.routes}
    yield disj(var(name) for n in r.path.barred if (name := of[n]) is not None)
    for m, x in r.path.demands:
        yield neg(w.points.obtainable(m, x))
        yield var(w.sym.machines.trailed[m]) if w.points.powered(m) else FALSE
    for z in w.layout.declared.zones if wide else ():  # how many trains there may be is T-ZONE's business
        if any(s in z.sections for s, _ in r.path.ways):
            yield _zone_may_be_full(w, z.sections)


def _zone_may_be_full(w: Words, those: tuple[SectionId, ...]) -> Expr:
    """Something is locked or held in a zone."""
    return disj(w.f.locking.held(s) for s in those)


def _not_to_be_had(w: Words, way: Way, wide: bool) -> Expr:
    """A way cannot be locked, whatever stands in its section (R6, R10)."""
    f, out = w.f, [w.ways.trouble(*way, wide)]
    for other, whole, numbers in w.sym.ways.excluded[way]:
        if other not in w.sym.sections.restart:
            continue
        if whole:
            out.append(f.locking.held(other))
        else:
            out += [
                f.locking.restart(other),
                *f.locking.overlaps(other, numbers),
                *(f.locking.lock(other, n) for n in numbers),
            ]
    out += [neg(w.points.obtainable(m, x)) for m, x in w.sym.ways.demands[way]]
    return disj(out)


def _not_as_overlap(w: Words, o: Option, way: Way, wide: bool) -> Expr:
    """A way cannot be held as an overlap: it may lie over the route that is set onward, and beside another that leads
    over the same track (R4)."""
    f, (s, n) = w.f, way
    over = over_held(w, o)
    onward = disj(
        var(x.active)
        for x in w.sym.routes.over.get(way, ())
        if way in over.get(x.entry, ())
        and not x.shunt
        and not x.call_on
        and not x.path.identifier
        and way in x.path.ways
    )
    locks = [conj((lock, neg(onward))) if k == n else lock for k, lock in f.locking.of(s)]
    others = [var(name) for x, name in f.locking.options(s).items() if not held_beside(w, o, x)]
    held = [f.locking.restart(s), *others, *locks]
    return disj((*held, neg(w.sections.long(s)), w.ways.blocked(s), _not_to_be_had(w, way, wide)))


def _rear(w: Words, r: RouteSymbols) -> Iterator[Expr]:
    """A train that may stand before the signal since the restart on points, on what is open, or not alone (R16)."""
    f, (first, n) = w.f, r.path.ways[0]
    node = f.track.way(first, n)[0]
    rear = w.topo.beyond(first, node)
    if rear is None:
        return
    lies_anyhow = any(t.points or t.crossings for t in w.topo.traversals[rear])
    if lies_anyhow:
        yield f.locking.restart(rear)
    for d in w.layout.signalling.devices:
        if rear in d.over:
            yield conj((f.locking.restart(rear), neg(w.points.detected(d.id, Position.REVERSE))))
    beside = {w.topo.beyond(rear, j) for j in w.topo.ends[rear] if j != node}
    beside |= {fj.section for fj in f.track.fouls if fj.neighbour == rear}
    for other in sorted(s for s in beside if s is not None):
        yield conj((f.locking.restart(rear), f.locking.restart(other), neg(w.sections.long(other))))


def _berth(w: Words, way: Way, wide: bool) -> Iterator[Expr]:
    """A shunting movement does not come among vehicles where a train, or another movement, comes in (R2, R6)."""
    f, s = w.f, way[0]
    yield disj((w.ways.blocked(s), _not_to_be_had(w, way, wide), f.locking.train(s), *f.locking.overlaps(s)))
    for j in w.topo.ends[s]:
        rear = w.topo.beyond(s, j)
        if j == f.track.way(*way)[0]:
            continue
        g = w.sections.signal_at(s, j)
        if g is not None:
            waits = disj((neg(f.seen.used(s)), neg(w.sections.long(w.sections.rear(s, j))), w.signals.passing(g)))
            yield conj((f.locking.locked_in(s, j), waits))
        elif rear is not None:
            yield f.locking.locked_out(rear, j)


def _lie(w: Words, r: RouteSymbols, wide: bool, kept_clear: bool = True) -> Iterator[Expr]:
    """The ways lie, and those that are kept clear are."""
    clear = _kept_clear(w, r) if kept_clear else []
    for s, n in (*r.path.ways, *([r.path.berth] if r.path.berth is not None else [])):
        yield w.ways.lies(s, n, wide)
        if s in clear:
            yield w.sections.long(s)


def _added_lie(w: Words, r: RouteSymbols) -> Iterator[Expr]:
    """The points that the author has the route lock lie so (R5)."""
    for m, x in r.path.demands:
        yield w.points.detected(m, x)
        yield neg(var(w.sym.machines.trailed[m])) if w.points.powered(m) else conj(())


def _holds_added(w: Words, r: RouteSymbols, name: Name) -> Expr:
    """What was added is held from the grant until the train is wholly in the last section (R6), and longer where the
    author asks for it: until that is over, and no longer."""
    stays = _under_way(w, r) if r.path.hold_timer is None else neg(var(r.path.hold_timer))
    return iff(w.after(var(name)), conj((disj((var(name), w.signals.set_now(r))), stays)))


def kept_longer(w: Words, r: RouteSymbols) -> Expr:
    """A route holds what was added to it, and would have given it up, now or before; it was not set anew since."""
    if r.added is None or r.path.hold_begun is None:
        return FALSE
    since = disj((var(r.path.hold_begun), neg(_under_way(w, r))))
    return conj((var(r.added), neg(w.signals.set_now(r)), since))


def _under_way(w: Words, r: RouteSymbols) -> Expr:
    """A route is set, its train is not yet wholly in the last section, or its overlap is held."""
    last = w.topo.traversals[r.path.ways[-1][0]][r.path.ways[-1][1] - 1]
    leaves = last.exit in w.layout.track.boundary_at or r.path.berth is not None
    through = r.path.ways if leaves or len(r.path.ways) == 1 else r.path.ways[:-1]
    overlaps = [x for o, x in w.sym.overlaps.held.items() if r.path.overlap is not None and o[0] == r.path.overlap[0]]
    mine = [w.sym.overlaps.held[r.path.overlap]] if r.path.overlap is not None else []
    those = overlaps if r.path.overlap is not None and r.path.overlap[0] in w.sym.overlaps.swings else mine
    return disj((w.signals.set_now(r), var(r.active), w.f.locking.lock(*through[-1]), *map(var, those)))


def _overlaps(w: Words, r: RouteSymbols) -> list[tuple[SignalId, int]]:
    """The overlap of a route, and those to which it may swing: that every path to its signal has (R4)."""
    own = r.path.overlap
    if own is None or own[0] not in w.sym.overlaps.swings:
        return [] if own is None else [own]
    found: dict[object, set[tuple[SignalId, int]]] = {}
    for x in w.sym.routes:
        if x.path.overlap is not None and x.path.overlap[0] == own[0]:
            found.setdefault((x.entry, x.call_on, x.path.ways), set()).add(x.path.overlap)
    return sorted({own, *set[tuple[SignalId, int]].intersection(*found.values())})


def _in_order(w: Words, r: RouteSymbols, wide: bool, clear: bool = True) -> Iterator[Expr]:
    """The conditions of proceed, in every scan (R3); `wide`: with all that might count for the flank space.  Behind the
    first axle the path need not be `clear`."""
    f, sym = w.f, w.sym
    yield w.valid
    yield from _lie(w, r, wide, clear)
    yield w.ways.overlap_lies(r, wide)
    if r.path.overlap is not None and r.path.overlap[0] in sym.overlaps.swings:
        yield neg(w.after(var(sym.overlaps.swings[r.path.overlap[0]])))
    yield from _added_lie(w, r)
    for s, _ in (*r.path.ways, *([r.path.berth] if r.path.berth is not None else [])):
        yield neg(w.ways.blocked(s))
    beyond = _overlaps(w, r)
    for o in beyond:
        held = [neg(var(sym.overlaps.held[o]))] if len(beyond) > 1 else []
        yield disj((*held, conj(neg(w.ways.blocked(s)) for s, _ in sym.overlaps.ways[o])))
    yield from map(neg, _rear(w, r))
    ways = [w.ways.way(s, n) for s, n in r.path.ways]
    reached = {t.section for t in ways} | {s for o in beyond for s, _ in sym.overlaps.ways[o]}
    for c in w.layout.signalling.conditions:
        exits = not r.shunt and ways[-1].exit in c.exits
        if r.entry in c.signals or not reached.isdisjoint(c.over) or exits:
            yield var(sym.condition[c.id])
    for d in of_sections(w.layout.declared.demanded):
        if route_fits(f, d.routes, r):
            yield w.sections.long(d.section)
    boundary = w.layout.track.boundary_at.get(ways[-1].exit)
    if boundary is not None and not r.shunt:
        if boundary.node in sym.token:
            yield var(sym.token[boundary.node].have)
        if boundary.approach is not None:
            yield w.sections.long(boundary.approach)
    if not r.call_on:
        yield neg(f.seen.stale(r.path.ways[0][0]))
        yield from () if r.shunt else map(var, _lamps(w, r))
    if r.path.overlap is not None:
        yield disj(var(name) for o, name in sym.overlaps.held.items() if o[0] == r.path.overlap[0])
