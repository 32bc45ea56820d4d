"""Claims that speak of the controller's own bits say what these are: another bit in the place of one is found out.

The controller is as it is lowered, with one bit more that nothing reads; the claims alone take that for the bit that
they mean.  A claim that takes such a bit for an excuse, or asks something only while it is set, would say nothing then.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from interlock.logic import names
from interlock.logic.controller import Controller, Equation, Join, StateVar, Term
from interlock.logic.expr import Expr, conj, neg, var
from interlock.logic.naming import Name, spelled
from interlock.model.elements import SectionId
from interlock.proof.claims import Facts, Invariant, claims
from interlock.proof.claims.kinds import LockFacts
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.inductive import inductive, open_claims
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from tests.layouts import built


def for_ever(c: Controller, s: SectionId, bit: Name) -> Expr:
    return var(bit)


def until_passed(c: Controller, s: SectionId, bit: Name) -> Expr:
    firm = next(e for e in c.next if e.name == c.symbols.sections.firm[s])
    return conj((firm.expr, neg(var(c.symbols.sections.passed[s]))))


def with_request(c: Controller, s: SectionId, bit: Name) -> Expr:
    return var(c.symbols.sections.release_all)


BITS: dict[str, tuple[str, bool, Callable[[Controller, SectionId, Name], Expr], str]] = {
    "used for ever": ("used", True, for_ever, "remembered"),
    "passed on for ever": ("passed", True, for_ever, "remembered"),
    "firm until the head has gone on": ("firm", False, until_passed, "firm"),
    "missed whenever all is to be released": ("stale", False, with_request, "missed"),
}
"""By what is said falsely: the bit, its initial and its next value, and what of L-REASON finds it out."""


@pytest.mark.parametrize("said", BITS)
@pytest.mark.parametrize("layout", ["fig2_2", "passing_loop"])
def test_another_bit_in_the_place_of_one_is_found_out(layout: str, said: str) -> None:
    drawn, _, c = built(layout)
    field, initial, following, claim = BITS[said]
    bits: dict[SectionId, Name] = getattr(c.symbols.sections, field)
    s = next(x for x, _ in c.symbols.sections.lock)
    other = spelled(f"X{bits[s]}")
    more = Equation(other, Join.ALL, (Term(following(c, s, other), "another"),), "another")
    c = replace(c, state=(*c.state, StateVar(other, initial, "another")), next=(*c.next, more))
    system = System(drawn, c)
    kept, _, _ = inductive(system, Limits())
    if following is for_ever:
        kept = [*kept, Invariant("S-ANOTHER", s, var(other))]
    facts = Facts(system)
    assert open_claims(system, kept, claims(facts), Limits()) == {}, "as it is, all is proved"
    facts.sym = replace(c.symbols, sections=replace(c.symbols.sections, **{field: {**bits, s: other}}))
    facts.locking, facts.seen._sym = LockFacts(facts.sym, facts.track), facts.sym
    found = open_claims(system, kept, claims(facts), Limits())["L-REASON"]
    assert f"{s} {claim}" in [c.place for c in found]


@pytest.mark.parametrize("layout", ["fig2_2", "passing_loop"])
def test_a_signal_that_is_said_never_to_have_been_open_is_found_out(layout: str) -> None:
    """The bit of a route falls when it is cancelled, while what lies behind the signal is still locked."""
    drawn, _, c = built(layout)
    r = c.symbols.routes[0]
    other = spelled(f"X{r.shown}")
    shown = next(e for e in c.next if e.name == r.shown)
    cancelled = var(c.symbols.cancellation.cancel[r.entry])
    more = Equation(other, Join.ALL, (Term(conj((shown.expr, neg(cancelled))), "another"),), "another")
    c = replace(c, state=(*c.state, StateVar(other, False, "another")), next=(*c.next, more))
    system = System(drawn, c)
    kept, _, _ = inductive(system, Limits())
    facts = Facts(system)
    routes = type(c.symbols.routes)(replace(x, shown=other) if x is r else x for x in c.symbols.routes)
    facts.sym = replace(c.symbols, routes=routes)
    found = open_claims(system, kept, claims(facts), Limits())["L-APPROACH"]
    assert f"{r.id} kept" in [x.place for x in found]


def test_a_lock_that_ends_before_the_one_that_leads_into_it_is_found_out() -> None:
    """Released by hand in the middle of a route that is set: nothing but the order of locks speaks of that."""
    drawn, _, c = built("passing_loop")
    steps = tuple(
        replace(e, terms=tuple(t for t in e.terms if t.kind != "rear released"))
        if isinstance(e, Equation) and e.name.family is names.RELEASED_BY_HAND
        else e
        for e in c.steps
    )
    system = System(drawn, replace(c, steps=steps))
    kept, _, _ = inductive(system, Limits())
    found = open_claims(system, kept, claims(Facts(system)), Limits())["L-REASON"]
    assert any(x.place.endswith(" in order") for x in found)


def test_nobody_has_passed_or_is_missed_at_the_restart() -> None:
    drawn, _, c = built("fig2_2")
    wanted = start_claim(System(drawn, c).loop).args
    for name in (*c.symbols.sections.passed.values(), *c.symbols.sections.stale.values()):
        assert neg(var(name)) in wanted
