"""Completion plans: verdicts against a search without any cleverness, reasons, zones, budgets."""

from __future__ import annotations

from itertools import pairwise, product
from random import Random

import pytest

from interlock.dispatch.plan.explore import explore
from interlock.dispatch.plan.problem import Built, Draft, Followed, GoesRound, Problem, build
from interlock.dispatch.plan.search import ORDERS, Planner, Verdict


def line(name: str, *sections: str, out: bool = True) -> Draft:
    """A train that stands in the first section and runs over the others, out at the end if wanted."""
    d = Draft(name, sections[0])
    for a, b in pairwise(sections):
        d.moves[a] = [(f"to {b}", b, frozenset({b}), {})]
    for s in sections:
        d.holds[s] = frozenset({s})
    if out:
        d.moves[sections[-1]] = [("out", "gone", frozenset(), {})]
        d.gone.add("gone")
    else:
        d.home.add(sections[-1])
    return d


def brute(p: Problem, state: int) -> bool:
    """Whether all can finish, by visiting every state."""
    seen, todo = {state}, [state]
    while todo:
        at = todo.pop()
        if p.done(at):
            return True
        for bits in p.nodes:
            here = next(b for b in bits if b & at)
            for m in p.moves[here]:
                after = at & ~m.source | m.target
                if p.possible(at, m) and after not in seen:
                    seen.add(after)
                    todo.append(after)
    return False


def replay(p: Problem, state: int, plan: tuple[object, ...]) -> int:
    for m in plan:
        assert m.source & state and p.possible(state, m)  # type: ignore[attr-defined]
        state = state & ~m.source | m.target  # type: ignore[attr-defined]
    return state


def scattered(seed: int, keeps: bool = False) -> Built:
    """A few trains with random ways over few sections, some with a zone; keeps: some keep more while followed."""
    rng = Random(seed)
    sections = [f"s{k}" for k in range(rng.randrange(4, 9))]
    drafts = []
    zone = frozenset(rng.sample(sections, 3)) if rng.random() < 0.5 else frozenset()
    for t, start in zip(range(rng.randrange(2, 5)), rng.sample(sections, 4), strict=False):
        d = Draft(f"t{t}", (0, start))
        layers: list[list[tuple[int, str]]] = [[(0, start)]]
        for depth in range(1, rng.randrange(2, 5)):
            layers.append([(depth, s) for s in rng.sample(sections, rng.randrange(1, 3))])
        for here, there in pairwise(layers):
            for a, b in product(here, there):
                into = {"Z": rng.choice((1, 1, 2))} if b[1] in zone and (a[1] not in zone or rng.random() < 0.2) else {}
                d.moves.setdefault(a, []).append((b[1], b, frozenset({b[1], rng.choice(sections)} - {a[1]}), into))
        for node in (n for x in layers for n in x):
            d.holds[node] = frozenset({node[1]})
            d.inside[node] = {"Z": rng.choice((1, 1, 2))} if node[1] in zone else {}
            if keeps and rng.random() < 0.4:
                d.followed[node] = Followed(frozenset(rng.sample(sections, 2)), frozenset(rng.sample(sections, 2)))
        for node in layers[-1]:
            if rng.random() < 0.6:
                d.moves[node] = [("out", "gone", frozenset(), {})]
                d.gone.add("gone")
            else:
                d.home.add(node)
        drafts.append(d)
    return build(drafts, [("Z", rng.randrange(1, 5))])


@pytest.mark.parametrize("keeps", [False, True])
@pytest.mark.parametrize("order", ORDERS)
def test_every_verdict_is_that_of_a_search_of_all_states(
    order: str, keeps: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("interlock.dispatch.plan.search.ORDERS", (order,))
    verdicts = []
    for seed in range(400):
        built = scattered(seed, keeps)
        p = built.problem
        planner = Planner(p)
        answer = planner.solve(built.start)
        assert (answer.verdict is Verdict.PLAN) == brute(p, built.start), seed
        verdicts.append(answer.verdict)
        if answer.verdict is Verdict.PLAN:
            assert p.done(replay(p, built.start, answer.plan))
        else:
            caught = [t for t, bits in enumerate(p.nodes) if answer.caught & sum(bits)]
            alone = Problem([p.trains[t] for t in caught], [p.nodes[t] for t in caught], p.moves, p.label,
                            p.home, p.gone, p.limits)  # fmt: skip
            assert answer.caught & built.start == answer.caught
            assert not brute(alone, answer.caught), "the trains that are caught are caught without the others"
    assert 50 < verdicts.count(Verdict.NONE) < 350


@pytest.mark.parametrize("keeps", [False, True])
def test_what_was_learnt_holds_for_other_states(keeps: bool) -> None:
    for seed in range(150):
        built = scattered(seed, keeps)
        p = built.problem
        planner = Planner(p)
        for pick in range(12):
            rng = Random(f"{seed} {pick}")
            state = sum(rng.choice(bits) for bits in p.nodes)
            assert (planner.solve(state).verdict is Verdict.PLAN) == brute(p, state), (seed, pick)


def test_two_trains_head_on_are_caught_and_named() -> None:
    built = build([line("a", "x", "y"), line("b", "y", "x"), line("c", "z", "w")])
    answer = Planner(built.problem).solve(built.start)
    assert answer.verdict is Verdict.NONE
    assert [built.problem.label[b] for b in built.problem.at(built.start) if b & answer.caught] == ["x", "y"]


def test_a_loop_lets_them_pass() -> None:
    b = line("b", "y", "x")
    b.moves["y"].append(("aside", "loop", frozenset({"loop"}), {}))
    b.holds["loop"] = frozenset({"loop"})
    b.moves["loop"] = [("to x", "x", frozenset({"x"}), {})]
    built = build([line("a", "x", "y"), b])
    plan = Planner(built.problem).solve(built.start).plan
    assert built.problem.done(replay(built.problem, built.start, plan)) and plan[0].label == "aside"


@pytest.mark.parametrize("behind", ["third", "itself", "nobody"])
def test_what_is_kept_while_followed_is_free_when_nobody_is_behind(behind: str) -> None:
    """a stands in x and keeps y while another train is in w; b wants to go over y."""
    a, b, c = line("a", "x", out=False), line("b", "w" if behind == "itself" else "v", "y"), line("c", "u", out=False)
    a.followed["x"] = Followed(frozenset({"y"}), frozenset({"w"}))
    if behind == "third":
        c.holds["u"] = frozenset({"w"})
    built = build([a, b, c])
    answer = Planner(built.problem).solve(built.start)
    assert (answer.verdict is Verdict.PLAN) == (behind == "nobody")
    assert [built.problem.trains[t] for t, bits in enumerate(built.problem.nodes) if answer.caught & sum(bits)] == {
        "third": ["a", "b", "c"],
        "itself": ["a", "b"],
        "nobody": [],
    }[behind]


def test_a_full_zone_keeps_trains_out() -> None:
    first, second = line("a", "x", "in1", out=False), line("b", "y", "in2", out=False)
    for d, s in ((first, "in1"), (second, "in2")):
        d.inside[s] = {"Z": 1}
        for node, moves in d.moves.items():
            d.moves[node] = [(n, t, needs, {"Z": 1}) for n, t, needs, _ in moves]
    assert Planner((one := build([first, second], [("Z", 1)])).problem).solve(one.start).verdict is Verdict.NONE
    assert Planner((two := build([first, second], [("Z", 2)])).problem).solve(two.start).verdict is Verdict.PLAN


def test_out_of_budget_is_unknown_never_none() -> None:
    for seed in range(100):
        built = scattered(seed)
        answer = Planner(built.problem, budget=1).solve(built.start)
        if answer.verdict is not Verdict.UNKNOWN:
            assert (answer.verdict is Verdict.PLAN) == brute(built.problem, built.start)
    assert any(
        Planner((b := scattered(s)).problem, budget=1).solve(b.start).verdict is Verdict.UNKNOWN for s in range(100)
    )


def test_a_train_that_goes_round_is_refused() -> None:
    d = line("a", "x", "y")
    d.moves["y"].append(("back", "x", frozenset({"x"}), {}))
    with pytest.raises(GoesRound, match="a comes back to x"):
        build([d])


def test_trains_that_stand_head_on_from_the_start_are_in_a_deadlock() -> None:
    built = build([line("a", "x", "y"), line("b", "y", "x")])
    found = explore(built.problem, built.start)
    assert found.deadlocks == {built.start} == found.unsafe and found.states == 1
    assert found.shortest == () and found.last_safe == 0


def test_the_way_to_a_deadlock_is_safe_until_the_move_that_the_rule_refuses() -> None:
    """a may wait in p or in q; once it is in x it is head on with b."""
    built = build([line("a", "p", "q", "x", "y"), line("b", "y", "x")])
    found = explore(built.problem, built.start)
    assert found.shortest is not None and [m.label for m in found.shortest] == ["to q", "to x"]
    assert found.last_safe == 1 and found.refused_moves == 1 and len(found.deadlocks) == 1


def test_a_move_into_a_zone_that_is_too_small_for_one_train_is_none() -> None:
    """One train counts twice where it comes into a zone at two places."""
    for most, moves in ((1, 0), (2, 1)):
        d = line("a", "x", "in", out=False)
        d.moves["x"] = [(n, t, needs, {"Z": 2}) for n, t, needs, _ in d.moves["x"]]
        d.inside["in"] = {"Z": 2}
        built = build([d], [("Z", most)])
        assert len(built.problem.moves[built.start]) == moves
