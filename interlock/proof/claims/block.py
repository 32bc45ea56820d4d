"""Invariants about direction tokens (R12): one token, and nobody on the line who may not be there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from interlock.logic import names
from interlock.logic.expr import Expr, conj, disj, iff, implies, neg, var
from interlock.logic.plant import accepted, came, has_token, lamp, line, o, rests, seen_by, telegram
from interlock.logic.symbols import RouteSymbols, Way
from interlock.model.elements import NodeId, SectionId
from interlock.proof.claims.kinds import Facts, Invariant
from interlock.proof.claims.overlaps import overrun


def token_invariants(f: Facts) -> list[Invariant]:
    """All of them, ordered by boundary."""
    return [Invariant(name, b, x) for b in f.sym.token for name, x in (*_one_token(f, b), *_departing(f, b))]


def _one_token(f: Facts, b: NodeId) -> list[tuple[str, Expr]]:
    x = f.sym.token[b]
    here, given, ready = var(x.have), var(x.give), var(x.seen)
    has, gives, fresh = (has_token(b, w) for w in ("has", "gives", "fresh"))
    told_has, told_gives = telegram(b, "has"), telegram(b, "gives")
    saw_has, saw_gives = seen_by(b, "has"), seen_by(b, "gives")
    boundary = f.layout.track.boundary_at[b]
    sent = disj((line(b, "in"), o(boundary.approach or names.outside(b))))
    leaving = line(b, "out")
    return [
        ("K-TELLS", conj((iff(var(x.tells["has"]), here), iff(var(x.tells["gives"]), given)))),
        ("K-HERE", implies(here, neg(disj((given, has, told_has, saw_gives, sent))))),
        ("K-GIVEN", implies(given, conj((ready, neg(disj((gives, told_gives, leaving))))))),
        ("K-READY", implies(conj((ready, told_gives)), neg(disj((here, has, told_has, saw_gives, sent, leaving))))),
        ("K-HAS", implies(has, neg(disj((gives, told_gives, leaving))))),
        ("K-GIVES", implies(gives, conj((fresh, neg(disj((saw_gives, sent))))))),
        ("K-TOLD", implies(told_gives, neg(disj((told_has, saw_gives, sent))))),
        ("K-LEFT", implies(leaving, neg(disj((told_has, saw_gives, sent))))),
        ("K-SAW", neg(conj((saw_has, saw_gives)))),
        ("K-TAKING", implies(conj((here, ready)), neg(gives))),
        ("K-TAKEN", implies(conj((here, gives)), told_gives)),
        ("K-ARRIVED", implies(conj((given, has)), conj((saw_gives, neg(fresh), neg(saw_has))))),
        ("K-COMING", implies(conj((given, disj((fresh, neg(saw_gives), saw_has)))), neg(disj((sent, has, told_has))))),
        ("K-FIRST", implies(conj((gives, disj((saw_has, leaving)))), told_gives)),
        ("K-NEW", implies(conj((ready, gives)), neg(disj((saw_has, leaving))))),
        ("K-OLD", implies(conj((fresh, saw_gives)), neg(disj((has, told_has, sent))))),
    ]


def _departing(f: Facts, b: NodeId) -> list[tuple[str, Expr]]:
    """Whoever was called towards the boundary finds the direction ours until he has left."""
    here = var(f.sym.token[b].have)
    out = []
    for r in f.sym.routes:
        s, n = r.path.ways[-1]
        if r.shunt or f.track.way(s, n)[1] != b:
            continue
        shows = disj(var(v) for v in (*r.open_while, r.shown))
        out.append((f"K-SHOWN:{r.id}", implies(shows, here)))
        first = r.path.ways[0][0]
        held = [x for t, k in r.path.ways for x in (f.locking.lock(t, k), f.locking.train(t))]
        went = [accepted(r.entry)] if names.ACCEPTED(r.entry) in f.plant.state else []
        called = disj((f.sym.aspects.signal(r.entry), lamp(r.entry), *went))
        out.append((f"K-CALLED:{r.id}", implies(conj((*held, f.locking.firm(first), called)), here)))
        for i, (t, _) in enumerate(r.path.ways):
            ahead = [
                x for a, k in r.path.ways[i:] for x in (f.locking.lock(a, k), f.locking.train(a), neg(overrun(f, a)))
            ]
            out.append((f"K-GOES:{r.id}:{t}", implies(conj((*ahead, f.seen.been(t))), here)))
        if f.track.berth(s):  # a train counts as arrived there, and goes on all the same
            out.append((f"K-GOES:{r.id}", implies(_goes_on(f, s, n), here)))
        out += _apart(f, r)
    return list(dict(out).items()) or _staying(f, b)


def _apart(f: Facts, r: RouteSymbols) -> Iterator[tuple[str, Expr]]:
    """Of sections locked for trains one behind the other towards the boundary, one route has locked the first and
    another the last.  Where no route goes the whole way, because the author excludes it, they are never locked so."""
    for i, (t, k) in enumerate(r.path.ways[1:], 1):
        entry = f.track.way(t, k)[0]
        rear = f.topo.beyond(t, entry)
        if rear is None:
            continue
        for n, _ in f.locking.of(rear):
            if f.track.way(rear, n)[1] == entry:
                chain = _of_no_route(f, (rear, n), r.path.ways[i:])
                if len(chain) > (1 if f.track.shunts else 2):  # two over which no shunt route leads either: J-APART
                    locked = (x for s, m in chain for x in (f.locking.lock(s, m), f.locking.train(s)))
                    yield "K-APART:" + ">".join(f"{s}:{m}" for s, m in chain), neg(conj(locked))


def _of_no_route(f: Facts, rear: Way, onward: Sequence[Way]) -> list[Way]:
    """A way and the first ones onward that no train has locked together; none where one may: by a route over all of
    them, or by one to a signal on the way and another from there."""
    chain = [rear]
    over = [q for q in f.sym.routes.over.get(rear, ()) if not q.shunt]
    for way in onward:
        if any(q.path.ways[-1] == chain[-1] for q in over):
            return []
        chain.append(way)
        over = [q for q in over if way in q.path.ways]
        if not over:
            return chain
    return []


def _staying(f: Facts, b: NodeId) -> list[tuple[str, Expr]]:
    """Where no train is ever called towards the boundary: a shunting movement that ends before it goes no further."""
    ends = {r.path.berth or r.path.ways[-1] for r in f.sym.routes}
    before = [(s, n) for s, n in sorted(ends) if f.track.way(s, n)[1] == b and f.track.berth(s)]
    return [(f"K-STAYS:{s}", neg(_goes_on(f, s, n))) for s, n in before]


def _goes_on(f: Facts, s: SectionId, n: int) -> Expr:
    """A movement that has come into a section over a way that is locked to its end is not at rest."""
    return conj((f.locking.lock(s, n), o(s), came(s, f.track.way(s, n)[0]), neg(rests(s))))
