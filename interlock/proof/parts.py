"""A large induction in parts: goals that lie together, and the facts that speak of what they read.

A part has the definitions that its goals depend on within the step, and every invariant and assumption that shares a
variable with them.  Leaving facts out is sound: what follows from fewer facts follows from all.
"""

from __future__ import annotations

import time
from collections import Counter, deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Protocol

from interlock.logic.expr import Expr, variables
from interlock.logic.plant import Assumption
from interlock.proof.encode import Cnf
from interlock.proof.engines import Answer, Sat, solver
from interlock.proof.limits import Limits
from interlock.proof.onesided import OneSided
from interlock.proof.pool import run

SMALL = 1500  # so many goals are asked of one solver
GOALS = 4000  # in a part: fewer would encode the same definitions more often
HUB = 60  # a variable in more facts than this says nothing about what lies together


@dataclass(frozen=True)
class Decision:
    """Whether a goal follows, and the seconds that the question took."""

    follows: bool
    seconds: float


class Theory(Protocol):
    """What is known beside the hypotheses: a system, for questions about its steps."""

    @property
    def definitions(self) -> Mapping[str, Expr]:
        """Names of a step by what they mean, each after those that it reads."""
        ...

    @property
    def assumptions(self) -> Sequence[Assumption]:
        """Facts of every step."""
        ...

    @property
    def places(self) -> Mapping[str, tuple[int, ...]]:
        """Where variables belong: numbers, such that near ones lie together."""
        ...


@dataclass(frozen=True)
class Start:
    """Nothing: for questions about the restart."""

    definitions: Mapping[str, Expr] = field(default_factory=dict)
    assumptions: Sequence[Assumption] = ()
    places: Mapping[str, tuple[int, ...]] = field(default_factory=dict)


class Parts:
    """The facts of a system, by the variables that they read."""

    def __init__(self, system: Theory, hypotheses: Sequence[Expr]) -> None:
        self.system = system
        self.facts = [*hypotheses, *(a.expr for a in system.assumptions)]

    @cached_property
    def reads(self) -> list[tuple[str, ...]]:
        """What each fact reads."""
        return [tuple(variables((x,))) for x in self.facts]

    @cached_property
    def readers(self) -> dict[str, list[int]]:
        """The facts by what they read."""
        found: dict[str, list[int]] = {}
        for n, names in enumerate(self.reads):
            for v in names:
                found.setdefault(v, []).append(n)
        return found

    @cached_property
    def inputs_of(self) -> dict[str, tuple[str, ...]]:
        """What each definition reads."""
        return {name: tuple(variables((x,))) for name, x in self.system.definitions.items()}

    def prepare(self) -> None:
        """Read everything once, so that processes inherit it."""
        _ = self.readers, self.inputs_of

    def order(self, goals: Sequence[Expr]) -> list[int]:
        """The goals place by place, and in a place those that share variables near each other."""
        reads = [tuple(variables((g,))) for g in goals]
        chain = _sharing(reads)
        known = self.system.places
        at = [_places(names, known) for names in reads]
        crowd = Counter(p for those in at for p in those)
        place = 0
        key = [0] * len(goals)
        for n in chain:  # what belongs nowhere follows what it shares a variable with
            place = key[n] = min(at[n], key=lambda p: (crowd[p], p), default=place)
        return sorted(chain, key=key.__getitem__)

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
        for ring in range(rings):
            if ring:
                self.cone([v for n in facts for v in self.reads[n]], seen)
            for v in list(seen):
                near = self.readers.get(v, ())
                if len(near) <= 4 * HUB:
                    facts.update(dict.fromkeys(near))
        return self._clauses(sorted(facts), goals)

    def decide(self, goals: Sequence[Expr], limits: Limits, rings: int) -> list[Decision]:
        """Which of the goals follow from the facts so many steps around; 0 rings: from all facts."""
        cnf, literals = self.cnf(goals, rings) if rings else self.whole(goals)
        key = limits.cache.key(cnf, literals, limits.engine)
        known = limits.cache.known(key, len(literals))
        if all(known):
            return [Decision(True, 0.0)] * len(literals)
        sat = solver(limits.engine, cnf, limits.query_ms)
        for x, follows in zip(literals, known, strict=True):
            if follows:
                sat.learn(x)
        found = [Decision(True, 0.0) if yes else _asked(sat, x) for x, yes in zip(literals, known, strict=True)]
        limits.cache.keep(key, [d.follows for d in found])
        return found

    def whole(self, goals: Sequence[Expr]) -> tuple[Cnf, list[int]]:
        """All clauses, and the goals' literals."""
        return self._clauses(range(len(self.facts)), goals)

    def _clauses(self, facts: Iterable[int], goals: Sequence[Expr]) -> tuple[Cnf, list[int]]:
        cnf = OneSided(self.system.definitions)
        for n in facts:
            cnf.require(self.facts[n])
        return cnf, [cnf.question(g) for g in goals]


def _places(names: Sequence[str], known: Mapping[str, tuple[int, ...]]) -> set[int]:
    """Where an expression over some variables may belong: to sections, or else where its routes run."""
    where = [known[v] for v in names if v in known]
    return {p[0] for p in where if len(p) == 1} or {q for p in where for q in p}


def _sharing(reads: Sequence[tuple[str, ...]]) -> list[int]:
    """Numbers of expressions, those that share variables near each other."""
    having: dict[str, list[int]] = {}
    for n, names in enumerate(reads):
        for v in names:
            having.setdefault(v, []).append(n)
    done = [False] * len(reads)
    seen: set[str] = set()
    out: list[int] = []
    for start in range(len(reads)):
        if done[start]:
            continue
        done[start] = True
        todo = deque([start])
        while todo:
            n = todo.popleft()
            out.append(n)
            for v in reads[n]:
                near = having[v]
                if v not in seen and len(near) <= HUB:
                    seen.add(v)
                    for m in near:
                        if not done[m]:
                            done[m] = True
                            todo.append(m)
    return out


def _asked(sat: Sat, literal: int) -> Decision:
    """What follows is a fact for the questions after it."""
    began = time.perf_counter()
    follows = sat.ask(-literal) is Answer.UNSAT
    if follows:
        sat.learn(literal)
    return Decision(follows, time.perf_counter() - began)


Chunk = tuple[list[int], int]
"""Numbers of goals that are asked of one solver, and the rings of facts around them."""


class Inquiry:
    """Which goals follow from the hypotheses, the assumptions and the definitions of the step.

    Part by part; what a part leaves open is asked again with more facts around it, and at last with all of them.
    """

    def __init__(self, system: Theory, hypotheses: Sequence[Expr], goals: Sequence[Expr], limits: Limits) -> None:
        self.parts = Parts(system, hypotheses)
        self.goals = goals
        self.limits = limits
        self.found = [Decision(False, 0.0)] * len(goals)

    def chunks(self, rings: int) -> list[Chunk]:
        """What is still open, in chunks."""
        left = [n for n, d in enumerate(self.found) if not d.follows]
        if not rings:
            return [(left, 0)] if left else []
        self.parts.prepare()
        order = [left[k] for k in self.parts.order([self.goals[n] for n in left])]
        size = max(1, min(GOALS, -(-len(order) // self.limits.jobs)))
        return [(order[at : at + size], rings) for at in range(0, len(order), size)]

    def first(self) -> list[Chunk]:
        """The chunks to begin with: one of all goals where they are few."""
        return self.chunks(0 if len(self.goals) <= SMALL else 1)

    def ask(self, chunk: Chunk) -> list[Decision]:
        """Decide the goals of a chunk."""
        return self.parts.decide([self.goals[n] for n in chunk[0]], self.limits, chunk[1])

    def note(self, chunk: Chunk, answers: Sequence[Decision]) -> None:
        """Keep the answers to a chunk."""
        for n, answer in zip(chunk[0], answers, strict=True):
            self.found[n] = answer

    def finish(self, progress: Callable[[int, int], None]) -> list[Decision]:
        """All answers: what the first chunks left open is asked again."""
        for rings in (2, 0) if len(self.goals) > SMALL else ():
            self.settle(self.chunks(rings), progress)
        return self.found

    def settle(self, chunks: Sequence[Chunk], progress: Callable[[int, int], None]) -> None:
        """Decide chunks, beside each other."""
        done = sum(d.follows for d in self.found)

        def report(n: int) -> None:
            nonlocal done
            done += len(chunks[n][0])
            progress(done, len(self.goals))

        answers = run([partial(self.ask, c) for c in chunks], self.limits.jobs, report)
        for chunk, found in zip(chunks, answers, strict=True):
            self.note(chunk, found)


def decide(
    system: Theory,
    hypotheses: Sequence[Expr],
    goals: Sequence[Expr],
    limits: Limits,
    progress: Callable[[int, int], None],
) -> list[Decision]:
    """Which goals follow; see `Inquiry`."""
    inquiry = Inquiry(system, hypotheses, goals, limits)
    inquiry.settle(inquiry.first(), progress)
    return inquiry.finish(progress)
