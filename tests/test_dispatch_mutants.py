"""Weakened dispatchers: each is noticed by a check that the dispatcher as it is passes."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from interlock.dispatch import arbiter, describer
from interlock.dispatch.arbiter import Source
from interlock.dispatch.commands import errand
from interlock.dispatch.dispatcher import Dispatcher
from interlock.dispatch.holding import Holding
from interlock.dispatch.panel import Indications
from interlock.dispatch.plan.explore import explore
from interlock.dispatch.plan.problem import Problem, build
from interlock.dispatch.plan.search import Answer, Planner, Verdict
from interlock.dispatch.run import Run
from interlock.model.elements import RouteId
from tests.campaigns.dispatch import ADIT, HEISHAN, MINE, Case, timings
from tests.layouts import built
from tests.test_describer import IN, OUT, Yard, adit
from tests.test_dispatch import Panel


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
    made = build([j.nodes(names[:k]) for k, j in enumerate(journeys)], railway.held.zones)
    (zone,) = made.problem.limits
    counts: set[int] = set()
    original = Problem.done

    def count(p: Problem, state: int) -> bool:
        counts.add((state & zone.nodes[0]).bit_count())
        return original(p, state)

    Problem.done = count  # type: ignore[method-assign]
    try:
        explore(made.problem, made.start)
    finally:
        Problem.done = original  # type: ignore[method-assign]
    return max(counts) == 4


def numbers_are_where_trains_are() -> bool:
    """Two trains on two tracks of mine11."""
    y = Yard()
    y.drive("7", *IN)
    y.drive("9", *OUT)
    return (y.d.where("7"), y.d.where("9"), y.d.alarms) == ("q6", "q5", {})


def bound_for_e() -> Panel:
    """Mine11 with a train that stands before X7, bound for E over any way."""
    p = Panel(*built("mine11"))
    p.dispatcher.carry_out(errand(p.dispatcher.railway, "1:W>E", 60.0)[0])
    p.stand("ap_W")
    return p


def asked_once() -> bool:
    """A route that is set is not asked for again while its train is on its way."""
    p, wanted = bound_for_e(), [0]
    step = p.dispatcher.step

    def noted(seen: Indications, dt_ms: int) -> dict[str, int]:
        found = step(seen, dt_ms)
        wanted.append(found["REQ"])
        return found

    p.dispatcher.step = noted  # type: ignore[method-assign]
    p.run(60)
    return [b for a, b in pairwise(wanted) if b and not a] == [p.number("X7-X1")]


def plans_are_of_what_is_seen() -> bool:
    """Since the first plan q7 is reported occupied: the train is led over q4."""
    p = bound_for_e()
    p.run(40)
    for at in (("ap_W", "q7"), ("ap_W", "q1", "q7"), ("q1", "q7")):
        p.stand(*at)
        p.run(40)
    return ("1", "X1-X5") in p.dispatcher.journal.asked


def plans_end_where_trains_may_stay() -> bool:
    """Two trains bound for each other's boundary: each move is possible, and after the last one both are away."""
    railway = case(MINE).ground.railway
    made = build([railway.draft(errand(railway, c, 60.0)[0]).nodes() for c in ("1:W>E", "2:E>W")])
    answer, state = Planner(made.problem).solve(made.start), made.start
    for m in answer.plan:
        if not made.problem.possible(state, m):
            return False
        state = state & ~m.source | m.target
    return answer.verdict is Verdict.PLAN and not state & ~made.problem.gone


def the_oldest_comes_first() -> bool:
    """Of two requests that have waited too long, the one that has waited longer."""
    stages, waiting = Panel(*built("mine11")).dispatcher.stages, arbiter.Arbiter(wait_ms=30_000)
    for route, waited in (("X7-X1", 40_000), ("X4-X6", 90_000)):
        waiting.add(stages[RouteId(route)], Source.PLANNED).turn_ms = waited
    return min(waiting.waiting, key=lambda r: r.key(waiting.wait_ms)).stage.route == "X4-X6"


def nothing_for_a_number_in_doubt() -> bool:
    """The train's number is in doubt."""
    p = bound_for_e()
    p.dispatcher.held["1"] = "in q1 the number 9 was read"
    p.run(60)
    return p.asked == []


def sent_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each request is made again once it was answered."""
    answered, following = Dispatcher._answered, Dispatcher._next
    again: list[int] = []

    def keeps(self: Dispatcher, seen: Indications) -> None:
        again.append(self._writes)
        answered(self, seen)

    def repeats(self: Dispatcher, seen: Indications) -> None:
        if again:
            self._writes = again.pop()
        else:
            following(self, seen)

    monkeypatch.setattr(Dispatcher, "_answered", keeps)
    monkeypatch.setattr(Dispatcher, "_next", repeats)


def older_state(monkeypatch: pytest.MonkeyPatch) -> None:
    """The problem is made anew for other trains, and not for what else has changed."""
    forget = Holding.forget

    def keeps(self: Holding) -> None:
        if self.built is None or len(self.built.problem.trains) != len(self.runs):
            forget(self)

    monkeypatch.setattr(Holding, "forget", keeps)


def ends_anywhere(monkeypatch: pytest.MonkeyPatch) -> None:
    """A plan may leave trains where they cannot stay."""
    monkeypatch.setattr(Problem, "done", lambda self, state: True)


def age_inverted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of those that have waited too long the youngest comes first."""
    key = arbiter.key

    def inverted(*given: Any) -> arbiter.Key:
        aged, first, *rest = key(*given)
        return (aged, -first, *rest)  # type: ignore[return-value]

    monkeypatch.setattr(arbiter, "key", inverted)


def doubt_ignored(monkeypatch: pytest.MonkeyPatch) -> None:
    """Routes are asked for whatever is held."""
    asks = Dispatcher._asks

    def all_the_same(self: Dispatcher, run: Run, seen: Indications) -> bool:
        self.held.clear()
        return asks(self, run, seen)

    monkeypatch.setattr(Dispatcher, "_asks", all_the_same)


def expected_first(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever is nearest has come in, wherever a route leads it."""
    monkeypatch.setattr(
        describer.Describer,
        "_heads",
        lambda self, s: [t for t in self.trains if t.under and t.under[-1] in self._next_to.get(s, ())],
    )


def who_comes_in_beside_one_that_runs_out() -> bool:
    """Heishan: 2 runs out over the points while 5 comes into the approach section beside them."""
    y = adit("5", "6")
    y.drive("5", "s1_wait")
    return (y.d.where("5"), y.d.where("2"), y.d.alarms) == ("s1_wait", "s2", {})


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
    (expected_first, who_comes_in_beside_one_that_runs_out),
    (sent_twice, asked_once),
    (older_state, plans_are_of_what_is_seen),
    (ends_anywhere, plans_end_where_trains_may_stay),
    (age_inverted, the_oldest_comes_first),
    (doubt_ignored, nothing_for_a_number_in_doubt),
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
