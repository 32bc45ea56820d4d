"""Goals asked of a solver one after the other."""

from __future__ import annotations

from interlock.logic.expr import conj, disj, neg, var
from interlock.proof.engines.batch import decided, decisions
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.minisat import MiniSat
from interlock.proof.engines.plaisted_greenbaum import OneSided


def test_what_does_not_follow_wears_patience_out() -> None:
    cnf = OneSided({})
    denials = [[cnf.denial(disj((neg(var("a")), var(f"b{k}"))))] for k in range(9)]
    cnf.require(disj((neg(var("a")), var("b8"))))
    found = decisions(MiniSat(cnf), denials, patience=8)
    assert [d.follows for d in found] == [False] * 9  # the last is never asked
    found = decisions(MiniSat(cnf), denials, patience=9)
    assert [d.follows for d in found] == [False] * 8 + [True]


def test_what_is_known_is_not_asked() -> None:
    cnf = OneSided({})
    denials = [[cnf.denial(var("a"))], [cnf.denial(var("b"))]]
    assert [d.follows for d in decisions(MiniSat(cnf), denials, [True, False])] == [True, False]


def test_what_says_several_things_follows_if_each_of_them_does() -> None:
    a, b, c = (var(name) for name in "abc")
    goals = [conj((a, b)), conj((a, c)), neg(disj((neg(a), neg(b)))), neg(disj((c, neg(b))))]
    found = decided(goals, [a, b], {}, Limits(), lambda: "")
    assert [d.follows for d in found] == [True, False, True, False]
