"""Invariants about short overlaps inside longer ones of the same signal (R4): while a short one is held, whoever may
come to its signal was called at no more than the speed for which it is made.

The short and the long one exclude each other over their first section, and the section before the signal is locked for
one route at a time: so all that is said here is said of the route with which the overlap that is held was set.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, implies, neg, var
from interlock.logic.plant import accepted, came, fast, lamp, o, overran, rests, running, shunting, slow
from interlock.model.elements import NodeId, SectionId, SignalId
from interlock.proof.claims.kinds import Facts, Invariant


def slow_invariants(f: Facts) -> list[Invariant]:
    """All of them, ordered by signal; none where no short overlap lies inside a longer one."""
    out: list[Invariant] = []
    held: dict[tuple[SignalId, int], list[Expr]] = {}
    for option, name in f.sym.overlaps.held.items():
        kmh = f.track.apart(option[0]).get(option[1])
        if kmh is not None:
            held.setdefault((option[0], kmh), []).append(var(name))
            for s, _ in f.sym.overlaps.ways[option]:
                there = conj((var(name), overran(option[0], s)))
                out.append(Invariant(f"V-OVER:{kmh}", f"{option[0]}:{option[1]}:{s}", implies(there, slow(s, kmh))))
    if not held:
        return []
    for r in f.sym.routes:
        kmh = None if r.path.overlap is None else f.track.apart(r.path.overlap[0]).get(r.path.overlap[1])
        if kmh is not None:
            lamps = [(v, var(name)) for (g, v), name in f.sym.aspects.speed.items() if g == r.entry]
            within, above = (disj(x for v, x in lamps if (v <= kmh) is fits) for fits in (True, False))
            shown = implies(disj(map(var, r.open_while)), conj((within, neg(above))))
            out.append(Invariant(f"V-LIT:{kmh}", r.id, shown))
    for kmh in sorted({kmh for _, kmh in held}):
        for g in (x.id for x in f.layout.signalling.signals if names.FAST(x.id, kmh) in f.plant.state):
            out.append(Invariant(f"V-FAST:{kmh}", g, implies(fast(g, kmh), disj((lamp(g), accepted(g))))))
    for (g, kmh), xs in held.items():
        out += _on_the_way(f, g, kmh, disj(xs))
    return out


def _on_the_way(f: Facts, g: SignalId, kmh: int, held: Expr) -> Iterator[Invariant]:
    """Backwards from the section before a signal to the signals from which locks lead there."""
    node = f.layout.signalling.signal[g].node
    before = f.topo.beyond(f.layout.track.section_of(f.layout.signalling.signal[g].into), node)
    assert before is not None
    leads = _Leads(f, before, node)
    for s, n, on in leads.ways():
        entry = f.track.way(s, n)[0]
        as_train = conj((f.locking.train(s), neg(shunting(s)) if f.track.shunts else TRUE))
        moves = running(s) if s == before else as_train  # in a berth it has arrived and may not have come to a stand
        comes = conj((held, on, o(s), came(s, entry), neg(rests(s)), moves))
        yield Invariant(f"V-SLOW:{g}:{kmh}:{n}", s, implies(comes, slow(s, kmh)))
        signal = f.topo.main_into.get((entry, s))
        if signal is not None and names.FAST(signal, kmh) in f.plant.state:
            told = conj((held, on, f.locking.train(s)))
            yield Invariant(f"V-TOLD:{g}:{kmh}:{n}", signal, implies(told, neg(fast(signal, kmh))))


class _Leads:
    """From where locks lead on, for trains, without a main signal between, to a section and over its end."""

    def __init__(self, f: Facts, to: SectionId, over: NodeId) -> None:
        self._f, self._to, self._over = f, to, over
        self._known: dict[tuple[SectionId, int], Expr] = {}

    def ways(self) -> Iterator[tuple[SectionId, int, Expr]]:
        """Sections with a way and what tells that it is locked, and all beyond up to there."""
        f = self._f
        for s in f.topo.sections:
            for n, _ in f.locking.of(s):
                on = self._on(s, n, frozenset())
                if on is not FALSE:
                    yield s, n, on

    def _on(self, s: SectionId, n: int, seen: frozenset[SectionId]) -> Expr:
        f, exit_ = self._f, self._f.track.way(s, n)[1]
        if (s, exit_) == (self._to, self._over):
            return f.locking.lock(s, n)
        ahead = f.topo.beyond(s, exit_)
        if ahead is None or (exit_, ahead) in f.topo.main_into or ahead in seen:
            return FALSE
        onward = (
            conj((f.locking.train(ahead), self._on(ahead, m, seen | {s})))
            for m, _ in f.locking.of(ahead)
            if f.track.way(ahead, m)[0] == exit_
        )
        return conj((f.locking.lock(s, n), disj(onward)))
