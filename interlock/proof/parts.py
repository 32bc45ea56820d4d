"""A large induction in parts: goals that lie together, and the facts that speak of what they read.

A part has the definitions that its goals depend on within the step, and every invariant and assumption that shares a
variable with them.  Leaving facts out is sound: what follows from fewer facts follows from all.
"""

from __future__ import annotations

import multiprocessing
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from interlock.logic.expr import Expr, variables
from interlock.proof.encode import Cnf
from interlock.proof.engines import Answer, Sat, solver
from interlock.proof.system import System

SMALL = 1500  # so many goals are asked of one solver
GOALS = 4000  # in a part: fewer would encode the same definitions more often
HUB = 60  # a variable in more facts than this says nothing about what lies together


@dataclass(frozen=True)
class Decision:
    """Whether a goal follows, and the seconds that the question took."""

    follows: bool
    seconds: float


class Parts:
    """The facts of a system, by the variables that they read."""

    def __init__(self, system: System, hypotheses: Sequence[Expr]) -> None:
        self.system = system
        self.facts = [*hypotheses, *(a.expr for a in system.assumptions)]
        self.reads = [tuple(variables((x,))) for x in self.facts]
        self.readers: dict[str, list[int]] = {}
        for n, names in enumerate(self.reads):
            for v in names:
                self.readers.setdefault(v, []).append(n)
        self.position = {name: n for n, name in enumerate(system.definitions)}
        self.inputs_of = {name: tuple(variables((x,))) for name, x in system.definitions.items()}

    def order(self, goals: Sequence[Expr]) -> list[int]:
        """The goals, those that share variables near each other."""
        reads = [tuple(variables((g,))) for g in goals]
        having: dict[str, list[int]] = {}
        for n, names in enumerate(reads):
            for v in names:
                having.setdefault(v, []).append(n)
        done = [False] * len(goals)
        out: list[int] = []
        for start in range(len(goals)):
            if done[start]:
                continue
            done[start] = True
            todo = deque([start])
            while todo:
                n = todo.popleft()
                out.append(n)
                for v in reads[n]:
                    near = having[v]
                    if len(near) <= HUB:
                        for m in near:
                            if not done[m]:
                                done[m] = True
                                todo.append(m)
        return out

    def cone(self, names: Sequence[str], seen: dict[str, None]) -> None:
        """Everything that the names depend on within the step."""
        todo = list(names)
        while todo:
            v = todo.pop()
            if v not in seen:
                seen[v] = None
                todo.extend(self.inputs_of.get(v, ()))

    def cnf(self, goals: Sequence[Expr], rings: int) -> tuple[Cnf, list[int]]:
        """Clauses of a part with facts so many steps around, and the goals' literals."""
        seen: dict[str, None] = {}
        self.cone(list(variables(goals)), seen)
        facts: dict[int, None] = {}
        for _ in range(rings):
            for v in list(seen):
                near = self.readers.get(v, ())
                if len(near) <= 4 * HUB:
                    facts.update(dict.fromkeys(near))
            self.cone([v for n in facts for v in self.reads[n]], seen)
        cnf = Cnf()
        definitions = self.system.definitions
        for name in sorted((v for v in seen if v in self.position), key=self.position.__getitem__):
            cnf.define(name, definitions[name])
        for n in sorted(facts):
            cnf.require(self.facts[n])
        return cnf, [cnf.literal(g) for g in goals]

    def decide(self, goals: Sequence[Expr], engine: str, query_ms: int, rings: int) -> list[Decision]:
        """Which of the goals follow from the facts so many steps around."""
        cnf, literals = self.cnf(goals, rings)
        sat = solver(engine, cnf, query_ms)
        return [_asked(sat, x) for x in literals]


def _asked(sat: Sat, literal: int) -> Decision:
    began = time.perf_counter()
    return Decision(sat.ask(-literal) is Answer.UNSAT, time.perf_counter() - began)


def decide(
    system: System,
    hypotheses: Sequence[Expr],
    goals: Sequence[Expr],
    engine: str,
    query_ms: int,
    jobs: int,
    progress: Callable[[int, int], None],
) -> list[Decision]:
    """Which goals follow from the hypotheses, the assumptions and the definitions of the step.

    Part by part; what a part leaves open is asked again with more facts around it, and at last with all of them.
    """
    proved = [Decision(False, 0.0)] * len(goals)
    parts = Parts(system, hypotheses) if len(goals) > SMALL else None
    for rings in (1, 2) if parts is not None else ():
        left = [n for n, ok in enumerate(proved) if not ok.follows]
        order = [left[k] for k in parts.order([goals[n] for n in left])]  # type: ignore[union-attr]
        size = max(1, min(GOALS, -(-len(order) // jobs)))
        chunks = [order[at : at + size] for at in range(0, len(order), size)]
        calls = [(parts, [goals[n] for n in chunk], engine, query_ms, rings) for chunk in chunks]
        done = len(goals) - len(left)
        for chunk, found in zip(chunks, _run(calls, jobs), strict=True):
            for n, ok in zip(chunk, found, strict=True):
                proved[n] = ok
            done += len(chunk)
            progress(done, len(goals))
    left = [n for n, ok in enumerate(proved) if not ok.follows]
    if left:
        cnf = step_cnf(system)
        for x in hypotheses:
            cnf.require(x)
        for a in system.assumptions:
            cnf.require(a.expr)
        literals = [cnf.literal(goals[n]) for n in left]
        sat = solver(engine, cnf, query_ms)
        for k, (n, lit) in enumerate(zip(left, literals, strict=True)):
            if k % 64 == 0:
                progress(len(goals) - len(left) + k, len(goals))
            proved[n] = _asked(sat, lit)
    return proved


def step_cnf(system: System) -> Cnf:
    """Clauses in which every name of a step has its meaning."""
    cnf = Cnf()
    for name, x in system.definitions.items():
        cnf.define(name, x)
    return cnf


Call = tuple[Any, ...]
_calls: list[Call] = []


def _work(k: int) -> list[Decision]:
    parts, goals, engine, query_ms, rings = _calls[k]
    found: list[Decision] = parts.decide(goals, engine, query_ms, rings)
    return found


def _run(calls: list[Call], jobs: int) -> Iterator[list[Decision]]:
    """The calls in order, on several processes where that is asked for; the children inherit them."""
    global _calls
    _calls = calls
    if jobs < 2 or len(calls) < 2 or "fork" not in multiprocessing.get_all_start_methods():
        yield from map(_work, range(len(calls)))
        return
    with multiprocessing.get_context("fork").Pool(min(jobs, len(calls))) as pool:
        yield from pool.imap(_work, range(len(calls)))
