"""Better plans without a solver: some trains are taken out and put in again in another order (ruin and recreate).

Late trains are taken out more often than others, and with them those that hold the same resources at about the same
time.  A plan that is a little worse is gone on from, the less so the nearer the end is (simulated annealing).
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Mapping, Sequence
from math import log
from random import Random

from interlock.planning.insertion import TICK, Diary, Path, diary_of, inserted, without_waste
from interlock.planning.problem import Plan, Problem

WARMTH = 0.005
"""The part of the cost that a plan may typically be worse by, at the beginning."""

PATIENCE = 250
"""Rounds for each train without a better plan, after which a search ends."""

MOST = 7
"""Trains that are taken out at a time."""


class Recreation:
    """A search from a plan.  `note` is told of every better plan."""

    def __init__(self, problem: Problem, plan: Plan, random: Random, note: Callable[[Plan], None]) -> None:
        self.problem, self.random, self.note = problem, random, note
        self.best = plan
        self.rounds = self._better = 0
        self._from(plan, None)

    def _from(self, plan: Plan, before: Diary | None) -> None:
        self.diary = diary_of(self.problem, plan, before)
        self.costs = [self._cost(i, path) for i, path in sorted(self.diary.paths.items())]

    def _cost(self, train: int, path: Path) -> int:
        delays = self.diary.ways(train).delays
        return sum(d.of(tick // TICK) for o, tick in path for d in delays[o])

    def run(self, until: float) -> Plan:
        """The best plan at a moment of the monotonic clock, or when nothing better was found for a long while."""
        began, count = clock.monotonic(), len(self.problem.trains)
        self._better, patience = self.rounds, PATIENCE * count
        while count > 1 and self.best.cost > 0 and (now := clock.monotonic()) < until:
            if self.rounds - self._better > patience:
                break
            warm = WARMTH * self.best.cost * (until - now) / (until - began)
            self._round(min(count, self.random.randint(2, MOST)), -warm * log(1 - self.random.random()))
            self.rounds += 1
        if sum(self.costs) > self.best.cost:
            self._from(self.best, self.diary)
        return self.best

    def _round(self, size: int, worse: float) -> None:
        chosen = some(self.problem, self.diary, self.costs, size, self.random)
        saved = {i: self.diary.paths[i] for i in chosen}
        begun = self._begun(chosen, saved)
        limit, spent = sum(self.costs[i] for i in chosen) + worse, 0
        for i in chosen:
            self.diary.take(i)
            self.diary.put(i, begun[i])
        self.random.shuffle(chosen)
        for i in chosen:
            path = inserted(self.diary, i, begun[i])
            spent += 0 if path is None else self._cost(i, path)
            if path is None or spent > limit:
                for j, old in saved.items():
                    self.diary.take(j)
                    self.diary.put(j, old)
                return
            self.diary.take(i)
            self.diary.put(i, path)
        for i in chosen:
            self.costs[i] = self._cost(i, self.diary.paths[i])
        if sum(self.costs) < self.best.cost:
            self.best = without_waste(self.problem, self.diary.plan())
            self._from(self.best, self.diary)
            self._better = self.rounds
            self.note(self.best)
        elif self.random.random() < 0.05:
            self._from(without_waste(self.problem, self.diary.plan()), self.diary)

    def _begun(self, chosen: Sequence[int], paths: Mapping[int, Path]) -> dict[int, Path]:
        """Every other time all that happens before some moment is kept: so one train may go first here, and the other
        one there."""
        if self.random.random() < 0.5:
            return dict.fromkeys(chosen, ())
        moment = self.random.choice(paths[chosen[0]])[1]
        return {i: tuple(x for x in paths[i] if x[1] < moment) for i in chosen}


def costs(problem: Problem, plan: Plan) -> list[int]:
    """What each train costs in a plan."""
    starts = {(e.train, e.operation): e.time for e in plan.events}
    found = [0] * len(problem.trains)
    for d in problem.delays:
        if (d.train, d.operation) in starts:
            found[d.train] += d.of(starts[d.train, d.operation])
    return found


def neighbours(problem: Problem, diary: Diary, train: int) -> dict[int, int]:
    """How near to each other trains hold the same resource, by the other train: the least ticks between."""
    found: dict[int, int] = {}
    for name in {u.resource for o, _ in diary.paths[train] for u in problem.trains[train][o].uses}:
        rows = diary.held.get(name, [])
        mine = [(a, b) for a, b, t in rows if t == train]
        for a, b, t in rows:
            if t != train:
                for c, d in mine:
                    gap = max(a - d, c - b, 0)
                    if gap < found.get(t, gap + 1):
                        found[t] = gap
    return found


def some(problem: Problem, diary: Diary, late: Sequence[int], size: int, random: Random) -> list[int]:
    """Trains that are in each other's way, one of which is late."""
    seed = random.choices(range(len(late)), [1 + x for x in late])[0]
    chosen, near = [seed], neighbours(problem, diary, seed)
    while len(chosen) < min(size, len(late)):
        rest = [i for i in range(len(late)) if i not in chosen]
        close = sorted((i for i in rest if i in near), key=lambda i: (near[i], random.random()))[: 2 * size]
        chosen.append(random.choice(close or rest))
        if random.random() < 0.5:
            for i, gap in neighbours(problem, diary, chosen[-1]).items():
                near[i] = min(near.get(i, gap), gap)
    return chosen
