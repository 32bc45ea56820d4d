"""Claims that follow from what the invariants say of one state.

Most claims need no look into a step.  What is claimed of the state before a step, that opposing signals do not show
proceed together, say, follows from the invariants before it.  What is claimed of the signals that a step shows follows
from the invariants after it, from what these signals are defined to show, and from what is assumed of the inputs.  No
definition of a place is needed, and so no goal pulls in half a railway: all of them can be asked of one solver that
knows every invariant, however large the layout.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from interlock.logic.expr import Expr, variables
from interlock.proof.alike import Forms
from interlock.proof.asking import Decision, decisions
from interlock.proof.engines import solver
from interlock.proof.limits import Limits
from interlock.proof.onesided import OneSided
from interlock.proof.views import Placed

MOST = 25_000  # goals asked of one solver: each has to read every invariant
PATIENCE = 50  # what does not follow takes long to find out, with so many names: after so many, others look


@dataclass(frozen=True, slots=True)
class OfState:
    """Goals by number, about the state before a step, or about what is shown after it."""

    goals: Sequence[int]
    after: bool

    def __len__(self) -> int:
        return len(self.goals)


class States:
    """What invariants say of one state."""

    def __init__(self, system: Placed, hypotheses: Sequence[Expr], limits: Limits) -> None:
        """`hypotheses`: the invariants; they hold before the step, and after it if it keeps them all."""
        self.system = system
        self.hypotheses = hypotheses
        self.limits = limits

    @cached_property
    def _next(self) -> frozenset[str]:
        return frozenset(self.system.later.values())

    @cached_property
    def _kept(self) -> frozenset[str]:
        """The next values of which invariants speak."""
        later = self.system.later
        return frozenset(later[v] for v in variables(self.hypotheses) if v in later)

    def questions(self, goals: Iterable[tuple[int, Expr]]) -> tuple[list[OfState], list[int]]:
        """Numbered goals that are no part of the induction: those about one state, and the others.

        What is said of routes tells which: of their next values, or of all else before the step.
        """
        before: list[int] = []
        after: list[int] = []
        others: list[int] = []
        later, members = self.system.later, self.system.members
        for n, x in goals:
            names = tuple(variables((x,)))
            if all(v in later for v in names):
                before.append(n)
            elif any(v in members and v in self._next for v in names) and not any(
                v in members and v in later for v in names
            ):
                after.append(n)
            else:
                others.append(n)
        return [
            OfState(some[k : k + MOST], some is after) for some in (after, before) for k in range(0, len(some), MOST)
        ], others

    def decide(self, goals: Sequence[Expr], after: bool) -> list[Decision]:
        """Which goals follow from the invariants before a step, or after it."""
        definitions, facts = self.told(goals, after)
        key = self.limits.cache.key(lambda: Forms(definitions).of(definitions, goals, facts), self.limits.engine)
        known = self.limits.cache.known(key, len(goals))
        if all(known):
            return [Decision(True, 0.0)] * len(goals)
        cnf = OneSided(definitions)
        for x in facts:
            cnf.require(x)
        denials = [cnf.denial(x) for x in goals]
        sat = solver(self.limits.engine, cnf, self.limits.query_ms)
        found = decisions(sat, denials, known, PATIENCE)
        self.limits.cache.keep(key, [d.follows for d in found])
        return found

    def told(self, goals: Sequence[Expr], after: bool) -> tuple[Mapping[str, Expr], Sequence[Expr]]:
        """What is defined and known of one state.

        After a step: not why a next value is what it is, unless a goal names it, and nothing of places that depends
        on routes.
        """
        if not after:
            return {}, self.hypotheses
        system = self.system
        asked = dict.fromkeys(variables(goals))
        definitions: dict[str, Expr] = {}
        seen: set[str] = set()
        todo = list(asked)
        while todo:
            v = todo.pop()
            if v in seen:
                continue
            seen.add(v)
            x = system.definitions.get(v)
            if x is None or (v not in asked and v in self._kept):
                continue
            reads = tuple(variables((x,)))
            if v not in asked and v not in system.members and any(u in system.members for u in reads):
                continue
            definitions[v] = x
            todo += reads
        inputs = [a.expr for a in system.assumptions if all(v in seen for v in variables((a.expr,)))]
        return definitions, [*map(system.after, self.hypotheses), *inputs]
