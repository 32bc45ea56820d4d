"""Bounded search: the shortest run from a restart to a violated claim.

**Theorem.**  A model of the initial condition and k copies of the step, with the claim denied in the last of them, is
a run of k steps that violates it; where there is none for a smaller k, the run is a shortest one.  (Bounded model
checking: Biere, Cimatti, Clarke and Zhu, 1999.)  The step is encoded once and copied for each depth, into one solver:
what it has learnt of the shorter runs serves for the longer (Een and Sorensson, 2003).  A found run is then thinned:
every event and input that can be left out is left out, and what remains is a run that the solver found.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator

from interlock.dataclass import dataclass
from interlock.logic.expr import Expr, disj, eq, evaluate, neg, var, variables
from interlock.logic.names import STANDS, Form
from interlock.proof.claims import Claim
from interlock.proof.engines import Answer
from interlock.proof.engines.minisat import MiniSat
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.system.relation import TransitionRelation
from interlock.proof.system.restart import InitialCondition
from interlock.proof.system.transition import System


@dataclass(frozen=True)
class Frame:
    """One step of a run: the state before it and the inputs taken."""

    state: dict[str, int]
    inputs: dict[str, int]


@dataclass(frozen=True)
class Run:
    """A run from a restart; the claim is violated in the last frame."""

    claim: Claim
    frames: tuple[Frame, ...]


class _Unrolled:
    """Copies of one step, chained."""

    def __init__(self, relation: TransitionRelation, initial: InitialCondition, goals: list[Expr]) -> None:
        self.template = Cnf()
        for name, x in relation.definitions.items():
            self.template.define(name, x)
        for a in relation.assumptions:
            self.template.require(a.expr)
        for name in variables(goals):
            self.template.literal(var(name))
        for name, size in relation.sizes.items():  # one of its values
            self.template.require(disj(eq(name, k) for k in range(size)))
        self.now = {n: self.template.literal(var(n)) for n in relation.state}
        self.then = {n: self.template.literal(var(n.next)) for n in relation.state}
        self.inputs = {n: self.template.literal(var(n)) for n in relation.inputs if n not in relation.sizes}
        self.goals = [self.template.literal(neg(g)) for g in goals]
        self.initial = self.template.literal(initial.whole)
        self.bad = self.template.fresh()
        self.template.clauses.append((-self.bad, *self.goals))
        self.size = self.template.count

    def step(self, k: int) -> Iterator[tuple[int, ...]]:
        """The clauses of step k, chained to the step before; variable n of step k is n + k * size."""
        shift = k * self.size
        for c in self.template.clauses:
            yield tuple(x + shift if x > 0 else x - shift for x in c)
        if not k:
            yield (self.initial,)
            return
        for n, lit in self.now.items():
            a, b = lit + shift, self.then[n]
            b = b + shift - self.size if b > 0 else b - shift + self.size
            yield (-a, b)
            yield (a, -b)


def search(
    system: System,
    claims: list[Claim],
    max_depth: int,
    seconds: float,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Run | None:
    """The shortest run that violates one of the claims, or None when none was found in depth and time."""
    if not claims:
        return None
    steps = _Unrolled(system.relation, system.initial, [c.expr for c in claims])
    end = time.monotonic() + seconds
    solver = MiniSat(until=end)
    for k in range(max_depth):
        progress(k, max_depth)
        if time.monotonic() >= end:
            return None
        solver.add(steps.step(k))
        bad = steps.bad + k * steps.size
        answer = solver.ask(bad)
        if answer is Answer.UNKNOWN:
            return None
        if answer is Answer.SAT:
            return _thin(system, steps, claims, solver, k + 1)
        solver.add([(-bad,)])
    return None


class _Thinned:
    """Literals that a run is to have, more and more, and the last run that was found with all of them."""

    def __init__(self, solver: MiniSat, must: int) -> None:
        self._solver = solver
        self.values = solver.values()
        solver.add([(must,)])

    def keep(self, *literals: int) -> None:
        """If there is a run with these as well, they stay."""
        if not all(self.has(x) for x in literals):
            if self._solver.ask(*literals) is not Answer.SAT:
                return
            self.values = self._solver.values()
        self._solver.add((x,) for x in literals)

    def has(self, literal: int) -> bool:
        """Whether it holds in the run that was found last."""
        return self.values.get(abs(literal), False) == (literal > 0)


def _thin(system: System, steps: _Unrolled, claims: list[Claim], solver: MiniSat, depth: int) -> Run:
    """Leave out every input that can be left out, one by one."""
    relation, symbols = system.relation, system.loop.controller.symbols
    valid = symbols.valid
    healthy = {
        valid,
        *symbols.sections.clear.values(),
        *symbols.sections.healthy.values(),
        *symbols.machines.detected.values(),
    }  # else a fault is told
    run = _Thinned(solver, steps.bad + (depth - 1) * steps.size)
    for k in range(depth):
        run.keep(steps.inputs[valid] + k * steps.size)
    names = sorted((n for n in steps.inputs if n != valid), key=lambda n: n.form is not Form.CHOICE)
    wishes = [-steps.now[n] for n in steps.now if n.family is STANDS]
    for name in names:
        for k in range(depth):
            lit = steps.inputs[name] + k * steps.size
            wishes.append(lit if name in healthy else -lit)
    wishes += [-(n + k * steps.size) for k in range(depth) for n in steps.template.value_literals()]
    # first keep what already is as wished, then try to add the others one at a time
    for lit in sorted(wishes, key=lambda lit: not run.has(lit)):
        run.keep(lit)
    frames = []
    for k in range(depth):
        shifted = {n: run.values.get(n + k * steps.size, False) for n in range(1, steps.size + 1)}
        named = steps.template.read(shifted)
        frames.append(
            Frame({n: named.get(n, 0) for n in relation.state}, {n: named.get(n, 0) for n in relation.inputs})
        )
    last = named
    memo: dict[int, bool] = {}
    violated = next(c for c in claims if not evaluate(c.expr, lambda n: last.get(n, 0), memo))
    return Run(violated, tuple(frames))
