"""CP-SAT asked for better plans, the whole problem or some of its trains, within a time."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from random import Random

from interlock.dataclass import dataclass
from interlock.planning.problem import Plan, Problem
from interlock.planning.rules import soonest


def installed() -> bool:
    """Whether OR-tools is there."""
    return find_spec("ortools") is not None


@dataclass(frozen=True)
class Answer:
    """The best plan found, a cost below which there is none, whether all was searched, and whether there is no plan."""

    plan: Plan | None
    bound: int
    done: bool = False
    none: bool = False


class Solver:
    """Questions about one problem."""

    def __init__(self, problem: Problem, workers: int, random: Random) -> None:
        self.problem, self.workers, self.random = problem, workers, random

    def whole(self, known: Plan | None, until: float) -> Answer:
        """All trains, all paths."""
        return self._asked(known, {}, until)

    def part(self, known: Plan, free: Sequence[int], until: float) -> Answer:
        """Only a better plan is asked for.  Some trains are free; the others keep their paths, and their order among
        themselves."""
        paths: dict[int, list[int]] = {}
        for e in known.events:
            if e.train not in free:
                paths.setdefault(e.train, []).append(e.operation)
        return self._asked(Plan(known.events, known.cost - 1), paths, until)

    def _asked(self, known: Plan | None, paths: Mapping[int, Sequence[int]], until: float) -> Answer:
        from ortools.sat.python import cp_model

        from interlock.planning.model import Model, OutOfTime

        start = known if known is not None else Plan((), dearest(self.problem))
        bound = least(self.problem)
        try:
            model = Model(self.problem, start, paths, until=until)
        except OutOfTime:
            return Answer(None, bound)
        while (left := until - clock.monotonic()) > 0:
            solver = cp_model.CpSolver()
            solver.parameters.num_workers = self.workers
            solver.parameters.max_time_in_seconds = left
            solver.parameters.symmetry_level = 0
            solver.parameters.random_seed = self.random.randrange(1 << 30)
            status = solver.solve(model.cp)
            if status == cp_model.INFEASIBLE:
                return Answer(None, start.cost + 1, done=True, none=True)
            if status not in (cp_model.OPTIMAL, cp_model.FEASIBLE):
                return Answer(None, bound)
            bound = max(bound, math.ceil(solver.best_objective_bound - 1e-6))
            plan, cycle = model.plan(solver)
            if plan is not None:
                return Answer(plan, bound, done=status == cp_model.OPTIMAL)
            model.cp.add_bool_or([x.negated() for x in cycle])
        return Answer(None, bound)


def least(problem: Problem) -> int:
    """A cost below which there is no plan: no train is ever in another one's way."""
    total = 0
    for i, t in enumerate(problem.trains):
        times = soonest(problem, i)
        reach = 0
        for k, o in enumerate(t):
            if k >= reach and times[k] >= 0:
                total += sum(d.of(times[k]) for d in problem.delays if (d.train, d.operation) == (i, k))
            reach = max([reach, *o.following])
    return total


def dearest(problem: Problem) -> int:
    """A cost above that of every cheapest plan."""
    from interlock.planning.windows import horizon

    end = horizon(problem, Plan((), 0))
    return sum(d.of(end) for d in problem.delays)
