"""Controllers that remember something rare, and then show the contrary at a terminal: noticed, family by family.

One bit more of state, which comes on with a rare sequence of inputs and stays: no scan of a test run would meet it, and
no point mutation makes it, since none adds a state.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from interlock.logic.controller import Controller, Equation, Join, Output, StateVar, Term
from interlock.logic.expr import conj, iff, neg, var
from interlock.logic.names import spelled
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.layouts import built

BIT = spelled("TROJAN")
OTHERS = ("spaces", "shunt_yard", "speeds", "identifier")
LAYOUTS = ("fig2_2", "heishan", "passing_loop", "pit_bottom", *(f"../tests/layouts_for_tests/{x}" for x in OTHERS))


def trojan(c: Controller, which: Output) -> Controller:
    """An output that is the other way for ever after six inputs were on in one scan."""
    rare = conj([var(x.name) for x in c.inputs if not x.size][:6])
    kept = Equation(BIT, Join.ANY, (Term(var(BIT), "kept"), Term(rare, "rare")), "restart")
    other = tuple(replace(o, expr=neg(iff(o.expr, var(BIT)))) if o is which else o for o in c.outputs)
    state = (*c.state, StateVar(BIT, False, "what nobody ordered"))
    return replace(c, state=state, next=(*c.next, kept), outputs=()).with_outputs(other)


@cache
def places() -> dict[str, tuple[str, str]]:
    """For each family of outputs the first one there is: its layout and its name."""
    found: dict[str, tuple[str, str]] = {}
    for name in LAYOUTS:
        for o in built(name)[2].outputs:
            found.setdefault(o.name.sort, (name, str(o.name)))
    return found


def test_every_family_of_outputs_is_here() -> None:
    assert len(places()) >= 22


@pytest.mark.parametrize("family", sorted(places()))
def test_a_trojan_at_a_terminal_is_noticed(family: str) -> None:
    name, which = places()[family]
    layout, _, c = built(name)
    wrong = trojan(c, next(o for o in c.outputs if o.name == which))
    result = prove(System(layout, wrong), Limits(search_depth=0, search_s=0))
    assert any(x.verdict is not Verdict.PROVED for x in result.claims)
