"""Signals that are passed at identifier light (S-IDENTIFIER)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.expr import Expr, conj, disj, implies, neg, var
from interlock.proof.claims.kinds import Facts


def identifiers(f: Facts) -> Iterator[tuple[str, str, Expr]]:
    """A signal shows its identifier light alone, and while the section before it is locked towards it; a route leads
    past it only while it does."""
    after = f.after
    for g, name in f.sym.aspects.identifier.items():
        before, node = f.sym.cancellation.approach_of[g], f.layout.signalling.signal[g].node
        assert before is not None
        others = [
            f.sym.aspects.stop[g],
            *f.sym.aspects.main_lamps(g),
            *f.sym.aspects.proceed_lamps(g, shunt=True),
        ]
        others += [f.sym.aspects.call_on[g]] if g in f.sym.aspects.call_on else []
        alone = neg(disj(after(var(x)) for x in others))
        led = after(conj((f.locking.locked_out(before, node), f.locking.firm(before), f.locking.train(before))))
        yield "S-IDENTIFIER", g, implies(after(var(name)), conj((alone, led)))
    for r in f.sym.routes:
        if r.path.onward is not None:
            lit = after(conj(f.sym.aspects.identifies(x.entry) for x in f.sym.routes.parts(r)[1:]))
            yield "S-IDENTIFIER", r.id, implies(after(var(r.proceed)), lit)
