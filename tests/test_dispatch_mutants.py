"""Weakened dispatchers: each is noticed by a check that the dispatcher as it is passes."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

import pytest

from interlock.dispatch import describer
from interlock.dispatch.commands import errand
from interlock.dispatch.dispatcher import Dispatcher
from interlock.dispatch.plan.explore import explore
from interlock.dispatch.plan.problem import Problem, build
from interlock.dispatch.plan.search import Answer, Planner, Verdict
from tests.campaigns.dispatch import ADIT, HEISHAN, MINE, Case, timings
from tests.test_describer import IN, OUT, Yard


@lru_cache
def case(path: str) -> Case:
    return Case(Path(path).read_text("utf-8"))


def nobody_stands_for_ever() -> bool:
    """Two trains on mine11 over any way, in some timings, on the controller."""
    return case(MINE).run(timings("1:W>E", "2:E>W")[::12]).stuck == 0


def one_route_ahead() -> bool:
    """A single train on mine11, on the controller."""
    return case(MINE).run([[("1:W>E", 0, 0, 60.0)]]).ahead == 1


def four_inside() -> bool:
    """Of five trains that are to load at heishan never more than four are in the zone, and sometimes four."""
    railway = case(HEISHAN).ground.railway
    journeys = [railway.draft(errand(railway, c, 60.0)[0]) for c in ADIT[:5]]
    names = [j.errand.train for j in journeys]
    built = build([j.nodes(names[:k]) for k, j in enumerate(journeys)], railway.zones)
    (zone,) = built.problem.limits
    counts: set[int] = set()
    original = Problem.done

    def count(p: Problem, state: int) -> bool:
        counts.add((state & zone.nodes).bit_count())
        return original(p, state)

    Problem.done = count  # type: ignore[method-assign]
    try:
        explore(built.problem, built.start)
    finally:
        Problem.done = original  # type: ignore[method-assign]
    return max(counts) == 4


def numbers_are_where_trains_are() -> bool:
    """Two trains on two tracks of mine11."""
    y = Yard()
    y.drive("7", *IN)
    y.drive("9", *OUT)
    return (y.d.where("7"), y.d.where("9"), y.d.alarms) == ("q6", "q5", {})


def not_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Planner, "solve", lambda self, state: Answer(Verdict.PLAN))


def no_zone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Problem, "possible", lambda self, state, move: not state & move.blocked)


def off_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    heads = describer.Describer._heads
    monkeypatch.setattr(
        describer.Describer,
        "_heads",
        lambda self, s: [t for t in self.trains if t not in heads(self, s)] or heads(self, s),
    )


Mutant = Callable[[pytest.MonkeyPatch], None]
MUTANTS: list[tuple[Mutant, Callable[[], bool]]] = [
    (not_checked, nobody_stands_for_ever),
    (no_zone, four_inside),
    (off_by_one, numbers_are_where_trains_are),
]


@pytest.mark.parametrize(("mutant", "check"), MUTANTS)
def test_a_weakened_dispatcher_is_noticed(
    mutant: Mutant, check: Callable[[], bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert check()
    mutant(monkeypatch)
    assert not check()


def test_a_dispatcher_that_looks_further_ahead_is_noticed() -> None:
    assert one_route_ahead()
    assert case(MINE).run([[("1:W>E", 0, 0, 60.0)]], look_ahead=50).ahead > 1
    assert Dispatcher.__init__.__kwdefaults__["look_ahead"] == 1
