"""Signals that are passed at identifier light (S-IDENTIFIER)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import Expr, conj, disj, implies, neg, var
from interlock.proof.claims.kinds import Facts


def identifiers(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """A signal shows its identifier light alone, and while the section before it is locked towards it; a route leads
    past it only while it does."""
    after = f.system.after
    for g, name in f.sym.identifier_aspect.items():
        before, node = f.sym.approach_of[g], f.layout.signal[g].node
        assert before is not None
        others = [f.sym.stop_aspect[g], *f.sym.main_lamps(g), *f.sym.proceed_lamps(g, shunt=True)]
        others += [f.sym.call_aspect[g]] if g in f.sym.call_aspect else []
        alone = neg(disj(after(var(x)) for x in others))
        led = after(conj((f.locked_out(before, node), f.firm(before), f.train(before))))
        yield "S-IDENTIFIER", g, implies(after(var(name)), conj((alone, led)))
    for r in f.sym.routes:
        if r.onward is not None:
            past = f.sym.number[r.onward].entry
            yield "S-IDENTIFIER", r.id, implies(after(var(r.proceed)), after(f.sym.identifies(past)))
