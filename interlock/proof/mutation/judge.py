"""What becomes of point mutations: one solver that knows the controller, and of each mutant only what it changes.

Every definition, assumption, invariant and condition of the restart has a literal that switches it on.  For a mutant
the changed ones are added and the old ones are left off: clauses that were learnt stay.  A mutant is proved as the
controller is: invariants that are lost, at the restart or in a step, are dropped until none is lost any more, and the
claims are asked with those that are left.  What no claim refuses is driven by trains; what trains do not notice is
compared with the controller, state by state.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from pysat.solvers import Minisat22

from interlock.logic.controller import Controller, MalformedController
from interlock.logic.expr import TRUE, Expr, Substitution, var, variables
from interlock.model.layout import Layout
from interlock.proof.encode import Cnf
from interlock.proof.invariants import Facts, claims, strengthening
from interlock.proof.mutation.points import Mutation
from interlock.proof.operations import operations
from interlock.proof.runner import start_claim
from interlock.proof.system import System
from interlock.proof.witness import witnesses

RENEWED = 400  # after so many mutants a solver carries more lines that are off than lines that are on
COPY = "~"  # the mutant's values of a step, beside those of the controller


class Fate(StrEnum):
    """What became of a mutant."""

    REFUSED = "refused"
    """It reads a value before it is computed, or the system has a variable that nobody defines: no controller."""
    CLAIM = "a claim fails"
    TRAIN = "a train notices"
    """A route that a train could use can no longer be set, driven and released."""
    OPERATOR = "an operator notices"
    """What an operator could do with a route does not work any more, or works where it must not."""
    EQUIVALENT = "equivalent"
    """In every state that the invariants allow, the next state and all outputs are the same."""
    SURVIVES = "survives"


@dataclass(frozen=True, slots=True)
class Verdict:
    """A mutant's fate, and the claim that fails or the route that cannot be used any more."""

    fate: Fate
    why: str = ""


@dataclass(frozen=True, slots=True)
class Lines:
    """What is said of a system."""

    definitions: Mapping[str, Expr]
    assumptions: tuple[Expr, ...]
    invariants: tuple[tuple[str, Expr], ...]
    claims: tuple[tuple[str, Expr], ...]
    start: tuple[Expr, ...]
    at_start: Expr

    @staticmethod
    def of(system: System) -> Lines:
        """The lines of a system."""
        facts = Facts(system)
        return Lines(
            system.definitions,
            tuple(dict.fromkeys(a.expr for a in system.assumptions)),
            tuple((f"{i.id} at {i.place}", i.expr) for i in strengthening(facts)),
            tuple((f"{c.id} at {c.place}", c.expr) for c in claims(facts)),
            tuple(dict.fromkeys(system.initial_parts)),
            start_claim(system),
        )


class Switched:
    """Clauses in one solver, with a literal that switches each line on."""

    def __init__(self) -> None:
        self.cnf = Cnf()
        self.solver = Minisat22()
        self._given = 0
        self._lines: dict[tuple[str, Expr], int] = {}

    def define(self, name: str, x: Expr) -> int:
        """The switch of: the name stands for the expression."""
        key = (name, x)
        found = self._lines.get(key)
        if found is None:
            a, b = self.cnf.literal(var(name)), self.cnf.literal(x)
            found = self._lines[key] = self.cnf.fresh()
            self.cnf.clauses += [(-found, -a, b), (-found, a, -b)]
        return found

    def fact(self, x: Expr) -> int:
        """The switch of: the expression is true."""
        found = self._lines.get(("", x))
        if found is None:
            lit = self.cnf.literal(x)
            found = self._lines["", x] = self.cnf.fresh()
            self.cnf.clauses.append((-found, lit))
        return found

    def any_false(self, xs: Iterable[Expr]) -> int:
        """The switch of: one of the expressions is false."""
        lits = [-self.cnf.literal(x) for x in xs]
        switch = self.cnf.fresh()
        self.cnf.clauses.append((-switch, *lits))
        return switch

    def model(self, *switches: int) -> set[int] | None:
        """The literals of a model with the lines of these switches; None where there is none."""
        for c in self.cnf.clauses[self._given :]:
            self.solver.add_clause(list(c))
        self._given = len(self.cnf.clauses)
        if not self.solver.solve(assumptions=list(switches)):
            return None
        return set(self.solver.get_model() or ())

    def off(self, switch: int) -> None:
        """A question that is asked no more."""
        self.cnf.clauses.append((-switch,))


class Judge:
    """Tells the fate of the mutants of one controller."""

    def __init__(self, layout: Layout, controller: Controller) -> None:
        self.layout = layout
        self.controller = controller
        self.system = System(layout, controller)
        self.lines = Lines.of(self.system)
        self._renew()
        self.driven = {w.route for w in witnesses(self.system) if w.ok}
        self.works = _worked(self.system)
        if self._failing(self.lines, self.system) is not None:
            raise ValueError("the controller itself is not proved")

    def _renew(self) -> None:
        self.step = Switched()
        self.start = Switched()
        self.asked = 0

    def judge(self, mutation: Mutation) -> Verdict:
        """The fate of one mutant."""
        self.asked += 1
        if self.asked > RENEWED:
            self._renew()
        try:
            controller = mutation.make()
            system = System(self.layout, controller)
        except MalformedController as e:
            return Verdict(Fate.REFUSED, str(e))
        lines = Lines.of(system)
        failing = self._failing(lines, system)
        if failing is not None:
            return Verdict(Fate.CLAIM, failing)
        if self._same(lines, system):
            return Verdict(Fate.EQUIVALENT)
        for w in witnesses(system):
            if w.route in self.driven and not w.ok:
                return Verdict(Fate.TRAIN, f"{w.route}: {w.text}")
        worked = _worked(system)
        lost = next((x for x in self.works if x not in worked), None)
        if lost is not None:
            return Verdict(Fate.OPERATOR, f"{lost[0]}: {lost[1]}")
        return Verdict(Fate.SURVIVES)

    def _failing(self, lines: Lines, system: System) -> str | None:
        """A claim that does not follow, or None where all are proved."""
        kept = self._at_start(lines)
        if isinstance(kept, str):
            return kept
        s = self.step
        fixed = [s.define(n, x) for n, x in lines.definitions.items()] + [s.fact(x) for x in lines.assumptions]
        claimed = [x for _, x in lines.claims if x is not TRUE]
        wrong = s.any_false(claimed)
        while True:
            known = [*fixed, *(s.fact(x) for _, x in kept)]
            model = s.model(*known, wrong)
            if model is not None:
                s.off(wrong)
                return next(n for n, x in lines.claims if -s.cnf.literal(x) in model)
            after = [(i, system.after(i[1])) for i in kept]
            lost = s.any_false(x for _, x in after)
            model = s.model(*known, lost)
            s.off(lost)
            if model is None:
                s.off(wrong)
                return None
            kept = [i for i, x in after if -s.cnf.literal(x) not in model]

    def _at_start(self, lines: Lines) -> list[tuple[str, Expr]] | str:
        """The invariants that hold at the restart; P-START where that does not."""
        s = self.start
        known = [s.fact(x) for x in lines.start]
        if s.model(*known) is None:
            return "the restart states contradict each other"
        wrong = s.any_false((lines.at_start,))
        model = s.model(*known, wrong)
        s.off(wrong)
        if model is not None:
            return "P-START"
        kept = list(lines.invariants)
        while True:
            lost = s.any_false(x for _, x in kept)
            model = s.model(*known, lost)
            s.off(lost)
            if model is None:
                return kept
            kept = [i for i in kept if -s.cnf.literal(i[1]) not in model]

    def _same(self, lines: Lines, system: System) -> bool:
        """Whether the mutant does what the controller does, in all states that the invariants allow."""
        mine = self.lines
        if set(lines.start) != set(mine.start) or set(lines.assumptions) != set(mine.assumptions):
            return False
        changed = {n for n, x in lines.definitions.items() if mine.definitions.get(n) is not x}
        below = set(changed)
        for n, x in lines.definitions.items():  # in an order in which each reads only what is before it
            if not below.isdisjoint(variables((x,))):
                below.add(n)
        put = Substitution({n: var(n + COPY) for n in below})
        s = self.step
        known = [s.define(n, x) for n, x in mine.definitions.items()]
        known += [s.define(n + COPY, put(lines.definitions[n])) for n in below]
        known += [s.fact(x) for x in mine.assumptions] + [s.fact(x) for _, x in mine.invariants]
        seen = [n for n in system.later.values() if n in below]
        differ = []
        for n in seen:
            a, b = s.cnf.literal(var(n)), s.cnf.literal(var(n + COPY))
            d = s.cnf.fresh()
            s.cnf.clauses += [(-d, a, b), (-d, -a, -b)]
            differ.append(d)
        some = s.cnf.fresh()
        s.cnf.clauses.append((-some, *differ))
        model = s.model(*known, some)
        s.off(some)
        return model is None


def _worked(system: System) -> dict[tuple[str, str], None]:
    """The routes and operations that work."""
    return {(r, name): None for r, those in operations(system).items() for name, why in those.items() if why is None}


def judged(layout: Layout, controller: Controller, those: Sequence[Mutation]) -> list[Verdict]:
    """The fates of some mutants of a controller."""
    judge = Judge(layout, controller)
    return [judge.judge(m) for m in those]
