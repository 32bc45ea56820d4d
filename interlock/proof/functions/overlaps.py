"""Overlaps, zones and direction tokens."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, iff, implies, neg, var
from interlock.model.elements import SectionId, SignalId
from interlock.proof.functions.shared import Option
from interlock.proof.functions.words import Words


def overlaps(w: Words) -> Iterator[tuple[str, str, Expr]]:
    """F-OVERLAP, F-SWING, F-ZONE and F-TOKEN."""
    f, sym = w.f, w.sym
    for o, name in sym.overlaps.held.items():
        g, node = o[0], w.layout.signalling.signal[o[0]].node
        before = w.topo.beyond(w.signals.first(g), node)
        assert before is not None
        needless = disj((neg(f.locking.locked_out(before, node)), var(sym.overlaps.timer[g])))
        over = conj((needless, *_left(w, o)))
        users = [w.signals.set_now(r) for r in sym.routes if r.path.overlap == o]
        held = var(name)
        if g not in sym.overlaps.swings:
            yield "F-OVERLAP", f"{g} {o[1]}", iff(w.after(held), disj((*users, conj((held, neg(over))))))
        else:
            yield "F-OVERLAP", f"{g} {o[1]}", implies(conj((held, over, neg(disj(users)))), neg(w.after(held)))
    yield from _swings(w)
    yield from _zones(w)
    yield from _tokens(w)


def _left(w: Words, o: Option) -> Iterator[Expr]:
    """Of each section of an overlap, that it keeps nothing: it is clear, or the last one, and firmly locked on along it
    for a train that has come in; unless it may be a short one, for slow trains, inside a longer one."""
    ways, route = w.sym.overlaps.ways[o], w.sym.routes.over
    for s, n in ways:
        end = (s, n) == ways[-1] and not _may_be_short(w, o) and any(not r.shunt for r in route.get((s, n), ()))
        kept = conj((w.f.locking.lock(s, n), w.f.locking.firm(s), w.f.seen.used(s))) if end else FALSE
        yield disj((w.sections.long(s), kept))


def _may_be_short(w: Words, o: Option) -> bool:
    """The track goes on where it ends, its signal has entries for some alternatives, and the one that holds of this one
    states a speed."""
    end = w.f.track.way(*w.sym.overlaps.ways[o][-1])[1]
    if end in w.layout.track.boundary_at or end in w.layout.track.buffer_at:
        return False
    over, entries = {s for s, _ in w.sym.overlaps.ways[o]}, [x for x in w.layout.overlaps.ways if x.signal == o[0]]
    of_all = dict(w.layout.overlaps.entry_speeds).get(o[0])
    return bool(entries) and next((x.entry for x in entries if over >= {*x.over}), of_all) is not None


def _swings(w: Words) -> Iterator[tuple[str, str, Expr]]:
    """The first alternative that can be had is taken."""
    f, sym = w.f, w.sym
    for g in sym.overlaps.swings:
        node = w.layout.signalling.signal[g].node
        before = w.topo.beyond(w.signals.first(g), node)
        assert before is not None
        options = [o for o in sym.overlaps.held if o[0] == g]
        asked = [
            w.valid,
            sym.requests.asked(sym.overlaps.swing_request[g]),
            var(sym.overlaps.firm[g]),
            f.locking.locked_out(before, node),
        ]
        asked += [neg(var(sym.overlaps.timer[g])), w.sections.long(before)]
        for s in dict.fromkeys(s for o in options for s, _ in sym.overlaps.ways[o]):
            asked += [w.sections.long(s), neg(f.locking.any_lock(s))]
        for i, o in enumerate(options):
            held = disj(var(sym.overlaps.held[x]) for x in options if x != o)
            ready = conj((*asked, held, *(x for s, n in sym.overlaps.ways[o] for x in _swings_to(w, g, s, n))))
            taken = disj(var(sym.overlaps.held[x]) for x in options[: i + 1])
            yield "F-SWING", f"{g} {o[1]}", implies(ready, w.after(taken))


def _swings_to(w: Words, g: SignalId, s: SectionId, n: int) -> Iterator[Expr]:
    """A way can be held as overlap instead of another alternative of the same signal (R4)."""
    yield from (_only_by(w, g, s), neg(w.ways.blocked(s)), neg(w.ways.trouble(s, n)))
    for other, _, _ in w.sym.ways.excluded[s, n]:
        if other in w.sym.sections.restart:
            yield conj((_only_by(w, g, other), neg(w.f.locking.any_lock(other))))
    for m, x in w.sym.ways.demands[s, n]:
        free = [
            y
            for t in w.layout.machines.sections[m]
            for y in (_only_by(w, g, t), neg(w.f.locking.any_lock(t)), w.sections.long(t))
        ]
        holding = (r.added for r in w.sym.routes if any(m == k for k, _ in r.path.demands))
        free += [w.points.unblocked(m), *(neg(var(name)) for name in holding if name is not None)]
        off = w.sym.machines.kept_off.get(m)
        runs = conj((w.points.unblocked(m), *([] if off is None else [neg(var(off))])))
        yield disj(
            (
                conj((w.points.commanded(m, x), disj((w.points.detected(m, x), runs)))),
                conj((*free, *(neg(w.points.holding(way)) for way in w.points.flanks(m)))),
            )
        )


def _only_by(w: Words, g: SignalId, s: SectionId) -> Expr:
    """A section is held neither by the restart nor as overlap of another signal."""
    others = (var(name) for o, name in w.f.locking.options(s).items() if o[0] != g)
    return neg(disj((w.f.locking.restart(s), *others)))


def _zones(w: Words) -> Iterator[tuple[str, str, Expr]]:
    for z in w.layout.declared.zones:
        full = _at_least([_counts(w, z.sections, s) for s in z.sections], z.trains)
        yield "F-ZONE", z.id, iff(w.after(var(w.sym.zone_full[z.id])), full)


def _counts(w: Words, zone: tuple[SectionId, ...], s: SectionId) -> Expr:
    """A train may be there: not where the lock is only the unused way ahead of one in rear."""
    f, out = w.f, [w.f.locking.restart(s), *w.f.locking.overlaps(s)]
    for n, lock in f.locking.of(s):
        entry = f.track.way(s, n)[0]
        rear = w.topo.beyond(s, entry)
        ahead = (
            conj((f.locking.locked_out(rear, entry), neg(f.seen.used(s)), neg(f.seen.stale(s))))
            if rear in zone
            else FALSE
        )
        out.append(conj((lock, neg(ahead))))
    return disj(out)


def _at_least(xs: list[Expr], number: int) -> Expr:
    """So many of them."""
    if number <= 0:
        return TRUE
    if number > len(xs):
        return FALSE
    return disj((conj((xs[0], _at_least(xs[1:], number - 1))), _at_least(xs[1:], number)))


def _tokens(w: Words) -> Iterator[tuple[str, str, Expr]]:
    f, sym = w.f, w.sym
    running = var(sym.start.restart_timer)
    for b, x in sym.token.items():
        have, give, seen = var(x.have), var(x.give), var(x.seen)
        out = disj(f.locking.locked_out(s, b) for s in w.topo.sections if b in w.topo.ends[s])
        taken = conj((w.valid, running, var(x.gives), neg(have), neg(give)))
        given = conj((w.valid, var(x.asks), have, seen, var(x.clear), neg(out), neg(var(x.manual))))
        arrived = conj((w.valid, var(x.has)))
        back = conj((w.valid, running, var(x.manual), give, neg(var(x.gives)), neg(var(x.has))))
        yield "F-TOKEN", f"{b} ours", iff(w.after(have), conj((disj((have, taken, var(x.timer))), neg(given))))
        yield "F-TOKEN", f"{b} given", iff(w.after(give), conj((disj((give, given)), neg(arrived), neg(back))))
        told = conj((w.valid, running, var(x.keeps)))
        yield "F-TOKEN", f"{b} told", iff(w.after(seen), conj((disj((seen, told)), neg(taken))))
        kept = disj((conj((neg(give), neg(given))), arrived))
        yield "F-TOKEN", f"{b} kept", iff(w.after(var(x.tells["keeps"])), kept) if kept is not FALSE else FALSE
