"""What an abstraction says holds in the large system, and with abstractions no other claim is proved than without."""

from __future__ import annotations

import random
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cache
from types import SimpleNamespace

import pytest

from interlock.app.init import yard
from interlock.logic import names
from interlock.logic.controller import Controller
from interlock.logic.expr import Expr, Substitution, conj, disj, iff, implies, neg, var, variables
from interlock.logic.lower import lower
from interlock.logic.names import Form, Kind, Name, each, each_value
from interlock.model.layout import Layout
from interlock.proof.abstraction.focus import foci
from interlock.proof.abstraction.indexed import IndexedFamilies
from interlock.proof.abstraction.local import Focus, LocalAbstraction, LocalAbstractions
from interlock.proof.abstraction.queries import LocalQueries
from interlock.proof.abstraction.quotient import abstraction
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.engines import Answer, solver
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.induction import parts
from interlock.proof.induction.inductive import inductive, open_claims
from interlock.proof.induction.one_state import States
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.system.neighbourhood import RouteVariables
from interlock.proof.system.relation import TransitionRelation
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable
from tests.layouts import built, grown

SOME = ("point-missing", "section-not-checked", "two-grants")


def small_yard(tracks: int, call_on: bool = False) -> tuple[Layout, InterlockingTable, Controller]:
    """A yard; `call_on`: into it trains can be called on, so that routes of one signal exclude each other."""
    made = grown(yard(tracks).replace("into: Ws2}", "into: Ws2, call_on: yes}" if call_on else "into: Ws2}"))
    assert made is not None
    layout, table, _ = made
    return layout, table, lower(layout, table)


def goals_of(system: System) -> tuple[list[tuple[int, Expr]], list[tuple[int, Expr]], list[Expr]]:
    """The goals of the induction and the claims of a system, numbered, and its invariants."""
    kept = [i.expr for i in strengthening(Facts(system))]
    steps = [(n, system.relation.after(x)) for n, x in enumerate(kept)]
    return steps, [(len(kept) + n, c.expr) for n, c in enumerate(claims(Facts(system)))], kept


class Large:
    """The large system, asked whether it says what an abstraction says."""

    def __init__(self, system: System, kept: list[Expr], after: bool) -> None:
        self.of: dict[Name, list[tuple[int, Expr]]] = {}
        named = IndexedFamilies(system.relation, system.where.routes, [])
        for name, (family, number) in system.where.routes.indexed.items():
            self.of.setdefault(family, []).append((number, named.named(var(name))))
        symbols, relation = system.loop.controller.symbols, system.relation
        for r in symbols.routes:
            self.of.setdefault(each_value(names.REQUEST), []).append((r.number, symbols.requests.asked(r.number)))
        cnf = Cnf()
        for name, x in relation.definitions.items():
            cnf.define(name, x)
        for x in [*kept, *(a.expr for a in relation.assumptions), *(map(relation.after, kept) if after else ())]:
            cnf.require(x)
        self.cnf = cnf

    def wrong(self, abstractions: Iterable[LocalAbstraction]) -> list[Expr]:
        """What abstractions say and the large system does not."""
        asked: dict[Expr, None] = {}
        for seen in abstractions:
            said = [*seen.facts, *(iff(var(name), x) for name, x in seen.definitions.items())]
            blocks = {
                name: disj(x for number, x in self.of[name.base] if seen.blocks[int(name.at[0])] >> number & 1)
                for name in variables(said)
                if name.form is Form.BLOCK
            }
            asked |= dict.fromkeys(map(Substitution(blocks), said))
        return self.not_said([*asked])

    def not_said(self, asked: Sequence[Expr]) -> list[Expr]:
        """The expressions that do not follow."""
        literals = [self.cnf.literal(x) for x in asked]
        sat = solver("minisat", self.cnf, 60_000)
        return [x for x, literal in zip(asked, literals, strict=True) if sat.ask(-literal) is not Answer.UNSAT]


@cache
def whole_yard(tracks: int, call_on: bool) -> tuple[LocalAbstractions, list[Focus], Large]:
    """What abstractions of a yard are made from, all of them, and the large system that they speak of."""
    layout, _, controller = small_yard(tracks, call_on)
    system = System(layout, controller)
    steps, claimed, kept = goals_of(system)
    local = LocalAbstractions(system.relation, system.where, kept)
    return local, foci(local, [*steps, *claimed]), Large(system, kept, False)


@pytest.mark.parametrize("tracks", [4, 6])
@pytest.mark.parametrize("call_on", [False, True])
@pytest.mark.parametrize("truncated", [False, True])
def test_what_an_abstraction_says_holds_in_the_large_system(tracks: int, call_on: bool, truncated: bool) -> None:
    local, some, large = whole_yard(tracks, call_on)
    sample = random.Random(tracks).sample(some, min(24, len(some)))
    seen = [abstraction(local, focus, truncated) for focus in sample]
    assert all(x.asked and (x.facts or x.definitions) for x in seen)  # what waits for an approach section needs no fact
    assert large.wrong(seen) == []


def test_a_truncated_cone_says_less_and_asks_the_same() -> None:
    layout, _, controller = small_yard(6)
    system = System(layout, controller)
    steps, claimed, kept = goals_of(system)
    local = LocalAbstractions(system.relation, system.where, kept)
    some = [s for s in foci(local, [*steps, *claimed]) if s.homes and s.homes[0].kind is Kind.SECTION]
    sizes = []
    for focus in some:
        truncated, all_around = abstraction(local, focus, truncated=True), abstraction(local, focus)
        assert {n for _, goals in truncated.asked for n in goals} == {n for _, goals in all_around.asked for n in goals}
        of_places = {name for name in truncated.definitions if name.form is not Form.BLOCK}
        assert of_places <= all_around.definitions.keys() and len(truncated.blocks) <= len(all_around.blocks)
        sizes += [len(truncated.facts) / len(all_around.facts)] if all_around.facts else []
    assert sum(sizes) < 0.9 * len(sizes)


def test_what_a_truncated_cone_leaves_open_is_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Here truncated local say nothing: all the same follows, from the local of all around."""
    layout, _, controller = small_yard(4)
    system = System(layout, controller)
    steps, _, kept = goals_of(system)
    again: set[int] = set()

    def seen_of(local: LocalAbstractions, focus: Focus, truncated: bool) -> LocalAbstraction:
        seen = abstraction(local, focus, truncated)
        if truncated:
            return replace(seen, facts=(), definitions={})
        again.update(focus.goals)
        return seen

    queries = LocalQueries(system.relation, system.where, kept, Limits())
    asked = queries.batches(steps)
    assert not any(queries.left(batch) for batch in asked)
    monkeypatch.setattr("interlock.proof.abstraction.queries.abstraction", seen_of)
    queries = LocalQueries(system.relation, system.where, kept, Limits())
    assert not any(queries.left(batch) for batch in asked)
    goals = {n for batch in asked for n in batch.goals}
    assert again <= goals and len(again) > 0.9 * len(goals)


def test_what_does_not_follow_is_open_after_both_cones() -> None:
    layout, _, controller = small_yard(4)
    system = System(layout, controller)
    steps, _, _ = goals_of(system)
    queries = LocalQueries(system.relation, system.where, [], Limits())
    asked = queries.batches(steps)
    left = {n for batch in asked for n in queries.left(batch)}
    alone = {n for batch in asked for focus in batch.foci for n in queries._open(focus, truncated=False)}
    assert left == alone and len(left) > 100


@pytest.mark.parametrize("after", [False, True])
def test_what_is_said_of_one_state_holds_in_the_large_system(after: bool) -> None:
    layout, _, controller = small_yard(4)
    system = System(layout, controller)
    _, claimed, kept = goals_of(system)
    states = States(system.relation, system.where, kept, Limits())
    questions, others = states.questions(claimed)
    expr = dict(claimed)
    (asked,) = (q for q in questions if q.after is after)
    definitions, facts = states.told([expr[n] for n in asked.goals], after)
    assert bool(definitions) is after and len(facts) >= len(kept)
    assert Large(system, kept, after).not_said([*facts, *(iff(var(v), x) for v, x in definitions.items())]) == []
    assert all(d.follows for d in states.decide([expr[n] for n in asked.goals], after))
    assert others and not any(
        d.follows for d in states.decide([conj((expr[n], var("no such name"))) for n in others], after)
    )


def open_goals(
    system: System, monkeypatch: pytest.MonkeyPatch, large: int
) -> tuple[list[str], dict[str, list[str]], int]:
    """The invariants that are dropped, the claims that stay open, and how many goals a first batch has shown."""
    monkeypatch.setattr(parts, "SMALL", 0 if large == 0 else 10**9)
    monkeypatch.setattr(parts, "LARGE", large)
    shown = 0
    conclude = parts.Inquiry._conclude

    def counted(inquiry: parts.Inquiry) -> None:
        nonlocal shown
        shown += len(inquiry.asked_locally.keys() - inquiry.unseen)
        conclude(inquiry)

    monkeypatch.setattr(parts.Inquiry, "_conclude", counted)
    kept, dropped, _ = inductive(system, Limits())
    left = open_claims(system, kept, claims(Facts(system)), Limits())
    monkeypatch.setattr(parts.Inquiry, "_conclude", conclude)
    return sorted(dropped), {id_: [c.place for c in some] for id_, some in left.items()}, shown


def weakened(kind: str, layout: Layout, table: InterlockingTable) -> Controller | None:
    """The controller with one weakening of a kind, in the middle of the places where there is one."""
    mutants = list(next(k for k in KINDS if k.name == kind).make(layout, table))
    return mutants[len(mutants) // 2][1] if mutants else None


@pytest.mark.parametrize("kind", ["", *SOME])
def test_the_same_goals_fail_with_abstractions(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    layout, table, controller = small_yard(4)
    weak = weakened(kind, layout, table) if kind else controller
    assert weak is not None
    system = System(layout, weak)
    dropped, left, shown = open_goals(system, monkeypatch, 0)
    assert (dropped, left, 0) == open_goals(system, monkeypatch, 10**9)
    assert bool(kind) == bool(dropped or left)
    assert shown > 1000


def test_the_same_goals_fail_where_all_of_a_layout_is_abstracted(monkeypatch: pytest.MonkeyPatch) -> None:
    layout, table, _ = small_yard(4)
    weak = weakened("section-not-checked", layout, table)
    assert weak is not None
    system = System(layout, weak)
    in_parts = open_goals(system, monkeypatch, 10**9)
    monkeypatch.setattr(parts, "NEAR", 0)  # no goal lies in a part of its own
    dropped, left, shown = open_goals(system, monkeypatch, 0)
    assert (dropped, left, 0) == in_parts
    assert left and shown > 1000
    goals = [parts.Goal(c.expr) for c in claims(Facts(system))]
    wide = parts.Inquiry(system.relation, system.where, [], goals, Limits())
    assert not any(isinstance(q, parts.Question) for q in wide.first())


@pytest.mark.parametrize("name", ["depot", "mine11", "pit_bottom"])
def test_the_same_goals_follow_with_abstractions_when_shipped(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    layout, _, controller = built(name)
    dropped, left, shown = open_goals(System(layout, controller), monkeypatch, 0)
    assert not dropped and not left and shown > 100


def routes_of(*those: Name) -> RouteVariables:
    """Variables of routes, of two routes at most."""
    return RouteVariables({name: (each(name), name.number) for name in those})


X, Y = var(names.spelled("x")), var(names.spelled("y"))


def test_what_is_said_twice_of_a_route_is_said_of_no_other() -> None:
    fact = implies(var(names.ACTIVE(1)), X)
    routes = routes_of(names.ACTIVE(1), names.ACTIVE(2))
    (clause,) = IndexedFamilies(TransitionRelation(), routes, [fact, conj((fact, Y))]).guarded
    assert (clause.expr, clause.members) == (X, 1 << 1)


def test_a_fact_that_is_a_disjunction_in_one_tells_all_of_its_parts() -> None:
    active, locked = names.ACTIVE(1), names.LOCKED(1)
    fact = disj((neg(conj((var(active), neg(var(locked))))), neg(X)))
    (clause,) = IndexedFamilies(TransitionRelation(), routes_of(active, locked), [fact]).guarded
    assert (clause.family, clause.expr) == (each(active), disj((var(each(locked)), neg(X))))


@pytest.mark.parametrize("denied", [False, True])
def test_what_reads_a_route_as_false_is_said_of_no_two_of_them(denied: bool) -> None:
    """Of each route: while it is set it is locked (or, denied: not), or X.  Of both together that is so only undenied:
    the one may be set and the other locked.  No yard has such a fact."""
    routes = (1, 2)
    place = names.spelled("place")
    of_routes = routes_of(*(f(i) for f in (names.ACTIVE, names.LOCKED) for i in routes))
    where = SimpleNamespace(routes=of_routes, homes={}, beside={})
    relation = TransitionRelation(definitions={place: disj(var(names.ACTIVE(i)) for i in routes)})
    locked = {i: neg(var(names.LOCKED(i))) if denied else var(names.LOCKED(i)) for i in routes}
    kept = [implies(var(names.ACTIVE(i)), disj((locked[i], X))) for i in routes]
    seen = abstraction(LocalAbstractions(relation, where, kept), Focus((), ((0, implies(var(place), X)),)))
    assert seen.blocks == [0b110]
    assert any(each(names.LOCKED(1)) == v.base for v in variables(seen.facts) if v.form is Form.BLOCK) is not denied
