"""Lemmas: what is said follows, and a proof without them says the same in more facts."""

from __future__ import annotations

import random
from itertools import product

import pytest

from interlock.logic.expr import Expr, conj, disj, evaluate, neg, var
from interlock.logic.lower import lower
from interlock.proof.invariants import Facts, claims, strengthening
from interlock.proof.local.engine import prove_locally
from interlock.proof.local.facts import FactBase, GoalKind
from interlock.proof.local.lemmas import Chains
from interlock.proof.local.library import Library
from interlock.proof.local.needed import needs
from interlock.proof.runner import start_claim
from interlock.proof.system import System
from tests.layouts import built

NAMES = [f"v{n}" for n in range(7)]


def clause(rng: random.Random) -> Expr:
    """A clause as facts have them: of two or three literals, some of them in a denied conjunction, or longer."""
    lits = [var(v) if rng.random() < 0.5 else neg(var(v)) for v in rng.sample(NAMES, rng.choice((2, 2, 3, 3, 4)))]
    if rng.random() < 0.4:
        return disj((neg(conj(map(neg, lits[:2]))), *lits[2:]))
    return disj(lits)


@pytest.mark.parametrize("seed", range(40))
def test_what_chains_find_is_implied(seed: int) -> None:
    rng = random.Random(seed)
    clauses = [clause(rng) for _ in range(9)]
    models = []
    for values in product((0, 1), repeat=len(NAMES)):
        env = dict(zip(NAMES, values, strict=True))
        if all(evaluate(c, env.__getitem__, {}) for c in clauses):
            models.append(env)
    known = Chains()
    known.learn(clauses)
    literals = [y for v in NAMES for y in (var(v), neg(var(v)))]
    for start in literals:
        with_it = [m for m in models if evaluate(start, m.__getitem__, {})]
        found = known.implied(start, 9)
        for y in literals:
            if known.number(y) in found:
                assert all(evaluate(y, m.__getitem__, {}) for m in with_it), (start, y)
        near = known.implied(start, 2)
        assert near.items() <= found.items() and max(near.values()) <= 2


def test_chains_go_as_far_as_they_are_asked_to() -> None:
    known = Chains()
    a, b, c, d = map(var, "abcd")
    known.learn([disj((neg(a), b)), disj((neg(b), c)), disj((neg(conj((a, c))), d))])
    steps = known.implied(a, 9)
    assert [steps[known.number(x)] for x in (a, b, c, d)] == [0, 1, 2, 3]
    assert known.number(d) not in known.implied(a, 2)


@pytest.mark.parametrize("name", ["passing_loop", "terminus"])
def test_a_proof_without_lemmas_says_the_same_in_more_facts(name: str) -> None:
    layout, table, _ = built(name)
    system = System(layout, lower(layout, table))
    facts = Facts(system)
    told = []
    for lemmas in (True, False):
        base = FactBase(system, strengthening(facts), claims(facts), start_claim(system))
        if not lemmas:
            base.lemmas = [], []
        proof = prove_locally(base, Library.shipped())
        assert not proof.open
        rest = [o for o in proof.obligations if o.goal.kind is not GoalKind.LEMMA]
        told.append((len(rest), sum(len(o.facts) for o in rest), {n.equation for n in needs(proof, system.controller)}))
    (ours, few, equations), (theirs, many, again) = told
    assert ours == theirs and few < many and equations == again
