"""Plans: by rules first, then better ones for as long as there is time.

The first plan comes from the rules (`rules.py`), within moments; so whoever runs out of time has theirs.  Then, until
the time is over or nothing can be better: local search (`recreate.py`), the whole problem put to CP-SAT, which may show
that nothing is better, and by turns CP-SAT on some trains with the paths of the others fixed (large neighbourhood
search), and local search again.  Without OR-tools there is local search alone.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from random import Random

from interlock.dataclass import dataclass
from interlock.planning.insertion import diary_of, without_waste
from interlock.planning.problem import Plan, Problem
from interlock.planning.recreate import Recreation, costs, some
from interlock.planning.rules import by_rules
from interlock.planning.solver import Solver, installed, least

FIRST, WHOLE, TURN = 0.35, 0.15, 0.04
"""Parts of the time: local search at first, CP-SAT on the whole problem, each turn after that."""


@dataclass(frozen=True)
class Planned:
    """What was found: the best plan (None: the rules found none, and the solver neither), a cost below which there is
    no plan, how the plan was made, and seconds."""

    plan: Plan | None
    bound: int
    by: str
    seconds: float
    none: bool = False
    """It is shown that there is no plan."""

    @property
    def best(self) -> bool:
        """Nothing costs less."""
        return self.plan is not None and self.plan.cost <= self.bound


Note = Callable[[Plan, str], None]


def schedule(
    problem: Problem,
    seconds: float,
    workers: int = 1,
    seed: int = 0,
    note: Note = lambda plan, by: None,
    known: Plan | None = None,
    by: str = "",
) -> Planned:
    """The best plan that is found in some seconds.  note: told of each better one, and of what found it.  known: a plan
    to begin with, and what it was made `by`."""
    planning = _Planning(problem, seconds, workers, seed, note)
    planning.found(known, by)
    return planning.run()


class _Planning:
    def __init__(self, problem: Problem, seconds: float, workers: int, seed: int, note: Note) -> None:
        self.problem, self.workers, self.note = problem, workers, note
        self.random = Random(seed)
        self.began = clock.monotonic()
        self.end = self.began + seconds
        self.plan: Plan | None = None
        self.by = ""
        self.bound = 0

    def run(self) -> Planned:
        seconds = self.end - self.began
        self.bound = least(self.problem)
        if self.plan is None:
            self.found(by_rules(self.problem, until=lambda: clock.monotonic() > self.began + 0.4 * seconds), "rules")
        solver = Solver(self.problem, self.workers, self.random) if installed() else None
        if self.open and self.plan is not None:
            self._recreated(self.began + FIRST * seconds)
        if self.open and solver is not None:
            share = WHOLE if self.plan is not None else 1.0
            answer = solver.whole(self.plan, min(self.end, clock.monotonic() + share * seconds))
            self.found(answer.plan, "CP-SAT")
            self.bound = max(self.bound, answer.bound)
            if answer.none and self.plan is None:
                return self._planned(none=True)
        if self.plan is not None and solver is None:
            self._recreated(self.end)
        elif solver is not None:
            self._by_turns(solver)
        return self._planned()

    @property
    def open(self) -> bool:
        """There may be a better plan, and there is time."""
        return clock.monotonic() < self.end and (self.plan is None or self.plan.cost > self.bound)

    def _recreated(self, until: float) -> None:
        assert self.plan is not None
        Recreation(self.problem, self.plan, self.random, lambda p: self.found(p, "recreation")).run(until)

    def _by_turns(self, solver: Solver) -> None:
        count, size = len(self.problem.trains), 3.0
        turn = max(1.0, TURN * (self.end - self.began))
        while self.plan is not None and self.open:
            wanted = min(count, round(size))
            free = some(
                self.problem, diary_of(self.problem, self.plan), costs(self.problem, self.plan), wanted, self.random
            )
            began, before = clock.monotonic(), self.plan.cost
            answer = solver.part(self.plan, free, min(self.end, began + turn))
            quick = answer.done and clock.monotonic() - began < 0.4 * turn
            self.found(answer.plan, "CP-SAT, some trains at a time")
            if wanted == count and answer.done:
                self.bound = max(self.bound, answer.bound)
                return
            if self.plan.cost == before:
                size = min(float(count), size * 1.15) if quick else max(2.0, size * 0.85)
            if not quick and self.open:
                self._recreated(min(self.end, clock.monotonic() + turn))

    def found(self, plan: Plan | None, by: str) -> None:
        """A plan, perhaps a better one."""
        if plan is None or (self.plan is not None and plan.cost >= self.plan.cost):
            return
        self.plan, self.by = without_waste(self.problem, plan), by
        self.note(self.plan, by)

    def _planned(self, none: bool = False) -> Planned:
        bound = self.bound if self.plan is None else min(self.bound, self.plan.cost)
        return Planned(self.plan, bound, self.by, clock.monotonic() - self.began, none)
