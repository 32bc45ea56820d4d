"""The first plan, by rules and without a solver: trains are planned one after the other, each for itself the best.

Who comes first goes first; a train that finds no way through is taken before those that were in its way.  While a train
is not planned yet it stands where it begins, so that nobody runs into a place that it cannot leave.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random

from interlock.planning.insertion import TICK, Diary, after, inserted, without_waste
from interlock.planning.problem import Plan, Problem


def soonest(problem: Problem, train: int) -> list[int]:
    """The time at which each operation of a train can begin if nobody is in its way; -1: never."""
    operations = problem.trains[train]
    found = [-1] * len(operations)
    found[0] = operations[0].earliest
    for k, o in enumerate(operations):
        if found[k] < 0:
            continue
        for p in o.following:
            t = max(found[k] + o.duration, operations[p].earliest)
            bound = operations[p].latest
            if (bound is None or t <= bound) and (found[p] < 0 or t < found[p]):
                found[p] = t
    return found


def by_rules(problem: Problem, tries: int = 200, until: Callable[[], bool] = lambda: False) -> Plan | None:
    """A plan; None: the rules find none, which does not mean that there is none.  until: whether to give up."""
    first = [min([t for t in soonest(problem, i)[1:] if t >= 0], default=0) for i in range(len(problem.trains))]
    order = sorted(range(len(problem.trains)), key=lambda i: (first[i], i))
    random, seen = Random(0), set[tuple[int, ...]]()
    for _ in range(tries):
        for waits in (True, False):
            diary, left = _planned(problem, order, waits)
            if not left:
                return without_waste(problem, diary.plan())
        if until():
            return None
        seen.add(tuple(order))
        order = [*left, *(i for i in order if i not in left)]
        if tuple(order) in seen:
            random.shuffle(order)
    return None


def _planned(problem: Problem, order: Sequence[int], waits: bool) -> tuple[Diary, list[int]]:
    """Trains in an order; waits: those that come later are taken to stand where they begin until they are planned."""
    diary, left = Diary(problem), list(order)
    for i in order:
        o = problem.trains[i][0]
        begun = o.earliest if o.latest is None else o.latest
        diary.stands(i) if waits else diary.stands(i, after(begun * TICK, o.duration) + 1)
    while left:
        before = len(left)
        for i in tuple(left):
            path = inserted(diary, i)
            if path is not None:
                diary.goes(i)
                diary.put(i, path)
                left.remove(i)
        if len(left) == before:
            break
    return diary, left
