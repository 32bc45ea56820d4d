"""Words: a route that is called free would be granted, an open one shows proceed, a refused one is not granted, and the
condition that is named does not hold."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic import words as said
from interlock.logic.controller import Controller
from interlock.logic.expr import FALSE, TRUE, Expr, Substitution, conj, disj, iff, implies, neg, var
from interlock.logic.names import computed
from interlock.logic.symbols import RouteSymbols
from interlock.proof.functions.words import Words


def words(w: Words, controller: Controller) -> Iterator[tuple[str, str, Expr]]:
    """F-WORD, route by route."""
    put = Substitution({computed(s.name): w.after(var(s.name)) for s in controller.state})
    when = controller.words.when()
    reasons = controller.words.reasons
    for r in w.sym.routes:
        if r.number in controller.words.routes:
            told = {code: put(x) for code, x in when[controller.words.routes[r.number]].items()}
            needed = {k: reasons[k].condition for k in told if k in reasons}
            named = [implies(told[k], neg(c)) for k, c in needed.items() if c is not None]
            yield "F-WORD", r.id, conj((*_does(w, r, told), *named))


def _does(w: Words, r: RouteSymbols, told: dict[int, Expr]) -> Iterator[Expr]:
    """What a word says of the route itself: never nothing, and nothing better than what is so."""
    after, active = w.after, var(r.active)

    def says(code: int) -> Expr:
        return told.get(code, FALSE)

    yield neg(says(said.UNKNOWN))
    yield iff(says(said.OPEN), after(disj(map(var, r.open_while))))
    yield implies(says(said.OPEN), after(w.sym.aspects.signal(r.entry, r.shunt)))
    yield implies(says(said.CANCELLING), after(conj((active, var(w.sym.cancellation.cancelling[r.entry])))))
    waits = disj(x for k, x in told.items() if said.WAITING < k < said.REFUSED)
    yield implies(waits, conj((after(active), neg(after(var(r.locked))))))
    yield implies(says(said.SET), after(active))
    yield implies(disj((waits, says(said.SET))), neg(after(var(w.sym.cancellation.cancelling[r.entry]))))
    yield FALSE if r.path.identifier and said.FREE in told else TRUE  # nobody can ask for it alone
    yield implies(conj((says(said.FREE), w.sym.requests.asked(r.number))), after(active))
    refused = disj(x for k, x in told.items() if k > said.REFUSED)
    yield implies(disj((refused, says(said.FREE))), neg(after(active)))
