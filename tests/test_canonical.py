"""Parts of one form: a renaming finds them, any other difference parts them, and what is answered once is right."""

from __future__ import annotations

import pytest

from interlock.app.init import line
from interlock.logic.expr import TRUE, Expr, disj, eq, implies, neg, var
from interlock.logic.lower import lower
from interlock.proof.abstraction.canonical import CanonicalForms
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.engines.limits import Limits
from interlock.proof.induction import parts
from interlock.proof.induction.parts import Goal, Inquiry
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.system.transition import System
from tests.layouts import built, grown

A, B, C, X, Y, Z = (var(n) for n in "abcxyz")


def form(*facts: Expr, head: str = "", **meaning: Expr) -> str:
    return CanonicalForms(meaning).digest(head, [(facts, {})])


def test_names_do_not_matter() -> None:
    assert form(A & B, implies(A, C)) == form(X & Y, implies(X, Z))
    assert form(A & B, b=implies(C, A)) == form(X & Y, y=implies(Z, X))
    assert form(disj((eq("q", 1), A))) == form(disj((eq("r", 7), X)))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (form(A & B), form(A | B)),
        (form(A & B), form(A & neg(B))),
        (form(A, B), form(A & B)),
        (form(A & B, A), form(A & B, B)),
        (form(A & B, C), form(A & B, A)),
        (form(A & B), form(A & B, b=C)),
        (form(A & B, a=C), form(A & B, b=C)),
        (form(A & B, b=C), form(A & B, b=A)),
        (form(A & B, b=C, c=A), form(A & B, b=C)),
        (form(eq("q", 1) | eq("q", 2)), form(eq("q", 1) | eq("r", 2))),
        (form(eq("q", 1) | A), form(B | A)),
        (form(A), form(A, head="another engine")),
    ],
)
def test_everything_else_does(one: str, other: str) -> None:
    assert one != other


def test_which_list_an_expression_stands_in_matters() -> None:
    forms = CanonicalForms({})
    assert forms.digest("", [([A], {}), ([B, C], {})]) != forms.digest("", [([A, B], {}), ([C], {})])


def test_a_name_may_stand_for_another_in_one_list() -> None:
    forms = CanonicalForms({"a'": B})
    later = [([A | C], {"a": "a'"}), ([A], {})]
    assert forms.digest("", later) == forms.digest("", [([var("a'") | C], {}), ([A], {})])
    assert forms.digest("", later) != forms.digest("", [([A | C], {}), ([A], {})])


def inquiry_of(system: System, monkeypatch: pytest.MonkeyPatch, near: int) -> Inquiry:
    """All goals of a system in parts, as those of a long line are."""
    monkeypatch.setattr(parts, "SMALL", 0)
    monkeypatch.setattr(parts, "NEAR", near)
    monkeypatch.setattr(parts, "FEW", 1)
    monkeypatch.setattr(parts, "LARGE", 10**9)  # parts only: no goal is looked at
    monkeypatch.setattr(parts, "HUB", 9)  # what a long line has by itself: nothing is read by a few facts of all places
    kept = list(strengthening(Facts(system)))
    goals = [Goal(i.expr, later=True) for i in kept] + [Goal(c.expr) for c in claims(Facts(system))]
    return Inquiry(system.relation, system.where, [i.expr for i in kept], goals, Limits())


def asked(system: System, monkeypatch: pytest.MonkeyPatch, near: int) -> tuple[list[bool], int]:
    """Which goals follow in the end, and how many goals were put to a solver first."""
    inquiry = inquiry_of(system, monkeypatch, near)
    goals = inquiry.goals
    first = inquiry.first()
    some = [n for n, g in enumerate(goals) if g.expr is not TRUE]
    assert sorted(n for q in first for those in (q.goals, *q.equal) for n in those) == some
    inquiry.settle(first, lambda done, total: None)
    return [d.follows for d in inquiry.finish(lambda done, total: None)], sum(len(q.goals) for q in first)


def test_a_weak_station_is_not_taken_for_its_sound_neighbours(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a line of stations of one kind most parts are asked once; where one station's controller is weakened, the same
    goals fail as when nothing is taken for anything else."""
    made = grown(line(16))
    assert made is not None
    layout, table, _ = made
    follows, few = asked(System(layout, lower(layout, table)), monkeypatch, 3000)
    assert all(follows) and few < 0.8 * len(follows)
    for kind in ("section-not-checked",):
        mutants = list(next(k for k in KINDS if k.name == kind).make(layout, table))
        weak = System(layout, mutants[len(mutants) // 2][1])
        alike, few = asked(weak, monkeypatch, 3000)
        alone, every = asked(weak, monkeypatch, 0)
        assert alike == alone and not all(alike), kind
        assert few < 0.8 * every < every <= len(alone)


def test_parts_do_not_grow_with_a_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the goals of a part depend on lies around one place; of one goal elsewhere a part is the whole line."""
    largest: list[int] = []
    for stations in (8, 16):
        made = grown(line(stations))
        assert made is not None
        inquiry = inquiry_of(System(made[0], lower(made[0], made[1])), monkeypatch, 3000)
        largest.append(max(len(seen) for _, seen in inquiry._parts(inquiry.places, 1, parts.GOALS)))
    assert largest[1] < 1.2 * largest[0]


@pytest.mark.parametrize("jobs", [1, 3])
def test_goals_of_a_small_system_are_asked_beside_each_other(monkeypatch: pytest.MonkeyPatch, jobs: int) -> None:
    """No process waits for one that asks them all, and no solver is told what all of them say."""
    layout, _, controller = built("fig2_1")
    system = System(layout, controller)
    kept = [i.expr for i in strengthening(Facts(system))]
    goals = [Goal(x, later=True) for x in kept] + [Goal(c.expr) for c in claims(Facts(system))] + [Goal(neg(TRUE))]
    monkeypatch.setattr(parts, "TOGETHER", len(goals) // 2 + 1)
    inquiry = Inquiry(system.relation, system.where, kept, goals, Limits(jobs=jobs))
    first = inquiry.first()
    assert sorted(n for q in first for n in q.goals) == [n for n, g in enumerate(goals) if g.expr is not TRUE]
    assert len(first) == max(2, jobs)
    for q in first:
        inquiry.note(q, inquiry.ask(q))
    assert [n for n, d in enumerate(inquiry.found) if not d.follows] == [len(goals) - 1]
