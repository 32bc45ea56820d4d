"""Denials that are asked together, against each asked by itself; and clauses that are implied."""

from __future__ import annotations

import random

import pytest

from interlock.logic.expr import Expr, conj, disj, neg, var
from interlock.proof.engines.batch import decisions, together
from interlock.proof.engines.minisat import MiniSat
from interlock.proof.engines.plaisted_greenbaum import OneSided
from interlock.proof.induction.one_state import implied


def _literal(rng: random.Random) -> Expr:
    x = var(f"v{rng.randrange(14)}")
    return x if rng.random() < 0.5 else neg(x)


def _facts(rng: random.Random) -> list[Expr]:
    return [disj(_literal(rng) for _ in range(rng.choice((2, 2, 3)))) for _ in range(rng.randrange(8, 30))]


@pytest.mark.parametrize("seed", range(120))
def test_what_is_asked_together_follows_as_when_it_is_asked_alone(seed: int) -> None:
    """Many goals have their premises in common, as those of one signal have."""
    rng = random.Random(seed)
    facts, premises = _facts(rng), [conj(_literal(rng) for _ in range(rng.randrange(1, 4))) for _ in range(4)]
    goals = [disj((neg(rng.choice(premises)), _literal(rng))) for _ in range(30)]
    known = [rng.random() < 0.1 for _ in goals]

    def decided(in_groups: bool) -> list[bool]:
        cnf = OneSided({})
        for x in facts:
            cnf.require(x)
        denials = [cnf.denial(g) for g in goals]
        asked = together(cnf, denials) if in_groups else ()
        assert not in_groups or sorted(n for q in asked for n in q.denials) == list(range(len(goals)))
        assert not in_groups or len(asked) < len(goals)
        return [d.follows for d in decisions(MiniSat(cnf), denials, known, asked=asked)]

    assert decided(True) == decided(False)


def test_what_does_not_follow_wears_patience_out_in_a_group_too() -> None:
    cnf = OneSided({})
    denials = [cnf.denial(disj((neg(var("a")), var(f"b{k}")))) for k in range(9)]
    asked = together(cnf, denials)
    assert [len(q.denials) for q in asked] == [9]
    cnf.require(disj((neg(var("a")), var("b8"))))
    found = decisions(MiniSat(cnf), denials, patience=8, asked=asked)
    assert [d.follows for d in found] == [False] * 9  # the last is never asked
    found = decisions(MiniSat(cnf), denials, patience=9, asked=asked)
    assert [d.follows for d in found] == [False] * 8 + [True]


@pytest.mark.parametrize("seed", range(60))
def test_implied_clauses_follow_and_are_found_where_steps_lead_there(seed: int) -> None:
    rng = random.Random(seed)
    cnf = OneSided({})
    for x in _facts(rng):
        cnf.require(x)
    every = list(range(2, cnf.count + 1))
    sat = MiniSat(cnf)
    found = implied(cnf.clauses, every, set(every))
    assert all(sat.ask(-a, -b).value == "unsat" for a, b in found)
    direct = {(a, b) for c in cnf.clauses if len(c) == 2 for a, b in (c, c[::-1]) if a < 0 < b and -a != b}
    chained = {(a, c) for a, b in direct for d, c in direct if b == -d and c != -a}
    assert direct | chained <= set(found)
    pairs = {-a: {b for x, b in direct if x == a} | {-a} for a, _ in direct}
    for c in cnf.clauses:
        if len(c) == 3 and sum(x > 0 for x in c) == 1:
            *needs, then = sorted(c)
            assert all((-a, then) in found for a, true in pairs.items() if {-n for n in needs} <= true and a != then)
