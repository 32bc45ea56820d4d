"""Goals asked of a solver one after the other."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from interlock.logic.expr import Expr, conj, disj, neg, var
from interlock.proof.engines import ENGINES, Answer, solver
from interlock.proof.engines.batch import Decision, decided, decisions, denials_of, follows
from interlock.proof.engines.by_kind import FIRST, decided_by_kind
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.minisat import MiniSat
from interlock.proof.engines.plaisted_greenbaum import OneSided
from interlock.proof.induction.inductive import holding_at_restart
from interlock.proof.system.transition import System
from tests.layouts import built


def test_what_does_not_follow_wears_patience_out() -> None:
    cnf = OneSided({})
    denials = [denials_of(cnf, disj((neg(var("a")), var(f"b{k}")))) for k in range(9)]
    cnf.require(disj((neg(var("a")), var("b8"))))
    found = asked(cnf, denials, [False] * 9, patience=8)
    assert [d.follows for d in found] == [False] * 9  # the last is never asked
    found = asked(cnf, denials, [False] * 9, patience=9)
    assert [d.follows for d in found] == [False] * 8 + [True]


def asked(
    cnf: OneSided, denials: Sequence[Sequence[Sequence[int]]], known: Sequence[bool], patience: int = 0
) -> list[Decision]:
    sat = MiniSat(cnf)
    return decisions(lambda n: follows(sat, denials[n]), known, patience)


def test_what_is_known_is_not_asked() -> None:
    cnf = OneSided({})
    denials = [denials_of(cnf, var("a")), denials_of(cnf, var("b"))]
    assert [d.follows for d in asked(cnf, denials, [True, False])] == [True, False]


def test_what_says_several_things_follows_if_each_of_them_does() -> None:
    a, b, c = (var(name) for name in "abc")
    goals = [conj((a, b)), conj((a, c)), neg(disj((neg(a), neg(b)))), neg(disj((c, neg(b))))]
    found = decided(goals, [a, b], {}, Limits(), lambda: "")
    assert [d.follows for d in found] == [True, False, True, False]


@pytest.mark.parametrize("engine", ENGINES)
def test_a_core_is_enough_for_the_refutation(engine: str) -> None:
    cnf = OneSided({})
    literals = [cnf.denial(neg(var(f"a{k}")))[0] for k in range(6)]
    cnf.require(neg(conj((var("a1"), var("a4")))))
    sat = solver(engine, cnf, 10_000)
    assert sat.ask(*literals) is Answer.UNSAT
    assert set(sat.core()) == {literals[1], literals[4]}
    assert sat.ask(*literals[:4], -literals[4]) is Answer.SAT


def chain(k: int) -> list[tuple[str, Expr]]:
    """That `a` implies `b`, and `b` implies `c`, at a place: facts of two kinds; and one of a third that none needs."""
    a, b, c = (var(f"{name}{k}") for name in "abc")
    return [("ab", disj((neg(a), b))), ("bc", disj((neg(b), c))), ("x", disj((neg(c), var(f"x{k}"))))]


@pytest.mark.parametrize("engine", ENGINES)
def test_goals_of_a_kind_are_asked_with_what_the_first_of_them_needed(engine: str) -> None:
    facts = [fact for k in range(9) for fact in chain(k) if (k, fact[0]) != (7, "bc")]
    goals = [("goal", disj((neg(var(f"a{k}")), var(f"c{k}")))) for k in range(9)]
    found = decided_by_kind(goals, facts, {}, Limits(engine=engine), [False] * 9)
    assert [d.follows for d in found] == [k != 7 for k in range(9)]


def test_a_goal_that_needs_more_than_those_before_it_is_asked_with_all_facts(monkeypatch: pytest.MonkeyPatch) -> None:
    count = FIRST + 4
    facts = [("ac", disj((neg(var(f"a{k}")), var(f"c{k}")))) for k in range(count - 2)]
    facts += [fact for k in range(count - 2, count) for fact in chain(k)]
    goals = [("goal", disj((neg(var(f"a{k}")), var(f"c{k}")))) for k in range(count)]
    assumed: list[int] = []
    ask = MiniSat.ask

    def noted(sat: MiniSat, *literals: int) -> Answer:
        assumed.append(len(literals) - 2)  # but for the two of the denial
        return ask(sat, *literals)

    monkeypatch.setattr(MiniSat, "ask", noted)
    found = decided_by_kind(goals, facts, {}, Limits(), [False] * count)
    assert all(d.follows for d in found)
    assert assumed == [4] * FIRST + [1] * 2 + [1, 4] + [3]


@pytest.mark.parametrize(
    ("answer", "said"),
    [(Answer.UNSAT, "the restart states contradict each other"), (Answer.UNKNOWN, "could not be decided")],
)
def test_restart_states_contradict_each_other_only_where_an_engine_has_said_so(
    monkeypatch: pytest.MonkeyPatch, answer: Answer, said: str
) -> None:
    """An engine that gave up within its limit has said nothing, and nothing is concluded from it."""
    layout, _, controller = built("mine11")
    monkeypatch.setattr(MiniSat, "ask", lambda sat, *literals: answer)
    with pytest.raises(RuntimeError, match=said):
        holding_at_restart(System(layout, controller), [], Limits())
