"""When operations can happen at all, in a plan that costs no more than a known one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from interlock.dataclass import dataclass
from interlock.planning.problem import Plan, Problem
from interlock.planning.rules import soonest


@dataclass(frozen=True)
class Windows:
    """By train: the operations that are possible, in order, and the earliest and the latest start of each."""

    live: tuple[tuple[int, ...], ...]
    earliest: tuple[tuple[int, ...], ...]
    latest: tuple[tuple[int, ...], ...]

    def must(self, train: int) -> frozenset[int]:
        """Operations that are on every path of a train: where only one way is open, counted in units of flow."""
        return self._must[train]

    _must: tuple[frozenset[int], ...] = ()


def horizon(problem: Problem, plan: Plan) -> int:
    """A time by which some cheapest plan is over: everything after each other, from the last earliest time on."""
    last = max((o.earliest for t in problem.trains for o in t), default=0)
    work = sum(o.duration + max((u.release for u in o.uses), default=0) for t in problem.trains for o in t)
    return max(last + work, max((e.time for e in plan.events), default=0))


def windows(problem: Problem, plan: Plan, paths: Mapping[int, Sequence[int]]) -> Windows:
    """For plans that cost at most what `plan` does; a train in `paths` takes the operations that stand there."""
    earliest = [soonest(problem, i) for i in range(len(problem.trains))]
    allowed = [frozenset(paths.get(i, range(len(t)))) for i, t in enumerate(problem.trains)]
    after_all = horizon(problem, plan)
    must = [_on_every_path(problem, i, allowed[i], earliest[i]) for i in range(len(problem.trains))]
    least = sum(d.of(earliest[d.train][d.operation]) for d in problem.delays if d.operation in must[d.train])
    spare = plan.cost - least
    bound: dict[tuple[int, int], int] = {}
    for d in problem.delays:
        if d.rate:
            own = d.of(earliest[d.train][d.operation]) if d.operation in must[d.train] else 0
            last = max(d.due, 0) + (own + spare) // d.rate
            key = (d.train, d.operation)
            bound[key] = min(bound.get(key, after_all), last)
    latest = [_latest(problem, i, allowed[i], earliest[i], bound, after_all) for i in range(len(problem.trains))]
    live, musts = [], []
    for i in range(len(problem.trains)):
        open_ = {k for k in allowed[i] if 0 <= earliest[i][k] <= latest[i][k]}
        live.append(tuple(sorted(open_)))
        musts.append(_on_every_path(problem, i, frozenset(open_), earliest[i]))
    return Windows(tuple(live), tuple(map(tuple, earliest)), tuple(map(tuple, latest)), tuple(musts))


def _latest(
    problem: Problem,
    i: int,
    allowed: frozenset[int],
    earliest: Sequence[int],
    bound: Mapping[tuple[int, int], int],
    after_all: int,
) -> list[int]:
    operations = problem.trains[i]
    latest = [-1] * len(operations)
    for k in range(len(operations) - 1, -1, -1):
        o = operations[k]
        if k not in allowed or earliest[k] < 0:
            continue
        end = max((latest[p] for p in o.following if latest[p] >= earliest[p] >= 0), default=-1)
        if o.following and end < 0:
            continue
        last = end - o.duration if o.following else after_all
        latest[k] = min(last, bound.get((i, k), after_all), after_all if o.latest is None else o.latest)
    return latest


def _on_every_path(problem: Problem, i: int, allowed: frozenset[int], earliest: Sequence[int]) -> frozenset[int]:
    """In topological order an operation is on every path if no arc leads past it."""
    operations, found, reach = problem.trains[i], set[int](), 0
    for k, o in enumerate(operations):
        if k not in allowed or earliest[k] < 0:
            continue
        if k >= reach:
            found.add(k)
        reach = max([reach, *(p for p in o.following if p in allowed and earliest[p] >= 0)])
    return frozenset(found)
