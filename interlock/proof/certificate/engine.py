"""Decide every goal: as an instance of a known shape, or by a SAT solver that names the facts it needed.

The facts stand in one solver, each behind a switch; a goal is asked with groups of facts, then with the facts of the
groups in the core, and the switches in the core name the facts.  What is the least far from the goal is asked first:
what was proved of the step, then definitions and assumptions, and all.  Facts that are not needed are taken out one by
one, and the shape gets its refutation.  A goal of the step that is proved is a fact from then on.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from pysat.solvers import Minisat22

from interlock.logic.expr import OR, Expr
from interlock.proof.certificate.facts import Fact, FactBase, Goal, GoalKind, Kind
from interlock.proof.certificate.library import Library
from interlock.proof.certificate.refute import refutation
from interlock.proof.certificate.shapes import Index, Pattern, Patterns, Shape, shape_of
from interlock.proof.engines.tseitin import Cnf


@dataclass(frozen=True)
class Obligation:
    """A goal that is proved: the shape, the numbers of the facts in the shape's order, and how to find them again."""

    goal: Goal
    shape: Shape
    facts: tuple[int, ...]
    hint: str


@dataclass
class LocalProof:
    """All obligations in order, and the goals for which none was found."""

    base: FactBase
    obligations: list[Obligation] = field(default_factory=list)
    open: list[Goal] = field(default_factory=list)
    solved: int = 0

    @property
    def shapes(self) -> list[Shape]:
        """The shapes used, by number."""
        return sorted({o.shape.number: o.shape for o in self.obligations}.values(), key=lambda s: s.number)


TIERS = (
    frozenset({Kind.DONE}),
    frozenset({Kind.DEFINITION, Kind.ASSUMPTION, Kind.VALUES}),
    frozenset({Kind.INVARIANT, Kind.INITIAL}),
)
"""Facts by how far they are from a goal; a goal is asked of the first, of the first two, and so on."""


PATIENCE = 1.4
"""Propagations for each fact that is switched on, beyond which more facts are switched on."""

GROUP = 48
"""Facts behind one switch: a solver that has to set a switch for each fact is slow."""


class Room:
    """Facts of one kind, and a solver in which each stands behind a switch, and neighbours behind one in common; it is
    filled when it is first asked."""

    def __init__(self, facts: Sequence[Fact], patterns: Patterns) -> None:
        self.facts = list(facts)
        self.index = Index(facts, patterns)
        self.cnf = Cnf(values=False)
        self.fed = 0
        self.number: dict[int, int] = {}
        self.tiers: list[dict[int, list[int]]] = [{} for _ in TIERS]
        """The switches of each tier's groups, with those of their facts."""

    @cached_property
    def solver(self) -> Minisat22:
        """The solver."""
        return Minisat22()

    def add(self, goal: Goal, pattern: Pattern) -> None:
        """A goal that is proved is a fact from now on."""
        self.facts.append(goal.fact)
        self.index.add(pattern)

    def _feed(self) -> None:
        """Give the solver all facts that it has not."""
        for n in range(len(self.number), len(self.facts)):
            f = self.facts[n]
            groups = next(those for those, kinds in zip(self.tiers, TIERS, strict=True) if f.kind in kinds)
            group = next(reversed(groups), 0)
            if not group or len(groups[group]) >= GROUP:
                group = self.cnf.fresh()
                groups[group] = []
            switch = self.cnf.fresh()
            self.number[switch] = n
            groups[group].append(switch)
            self.cnf.clauses += [(-group, switch), (-switch, *[self.cnf.literal(p) for p in _parts(f.clause)])]
        for c in self.cnf.clauses[self.fed :]:
            self.solver.add_clause(c)
        self.fed = len(self.cnf.clauses)

    def core(self, goal: Expr) -> list[int] | None:
        """Facts that together refute the negated goal, or None when all facts do not."""
        assumed = [-self.cnf.literal(p) for p in _parts(goal)]
        self._feed()
        groups: dict[int, list[int]] = {}
        for tier in self.tiers:
            groups |= tier
            if tier and self._contradicts([*assumed, *groups], 0 if tier is self.tiers[-1] else len(groups)):
                on = [switch for x in self.solver.get_core() or () for switch in groups.get(x, ())]
                if self.solver.solve(assumptions=[*assumed, *on]) is False:
                    core = self.solver.get_core() or ()
                    return self._smaller(goal, [self.number[x] for x in core if x in self.number])
        return None

    def _contradicts(self, assumed: list[int], groups: int) -> bool:
        """Whether there is a contradiction; with so many groups alone it is looked for only a while, as to find out
        that there is none takes a value for every variable."""
        if not groups:
            return self.solver.solve(assumptions=assumed) is False
        self.solver.prop_budget(int(PATIENCE * GROUP * groups))
        return self.solver.solve_limited(assumptions=assumed) is False

    def _smaller(self, goal: Expr, core: list[int]) -> list[int]:
        """Leave out fact after fact while the rest still refutes, in a small solver of their own."""
        cnf = Cnf(values=False)
        switch = {n: cnf.fresh() for n in core}
        for n in core:
            lits = [cnf.literal(p) for p in _parts(self.facts[n].clause)]
            cnf.clauses.append((-switch[n], *lits))
        cnf.clauses.extend((-cnf.literal(p),) for p in _parts(goal))
        back = {x: n for n, x in switch.items()}
        kept = core
        tried: set[int] = set()
        with Minisat22(bootstrap_with=cnf.clauses) as solver:
            while True:
                following = next((n for n in kept if n not in tried), None)
                if following is None:
                    return sorted(kept)
                tried.add(following)
                if solver.solve(assumptions=[switch[n] for n in kept if n != following]) is False:
                    kept = [back[x] for x in solver.get_core() or ()]


def _parts(clause: Expr) -> tuple[Expr, ...]:
    return clause.args if clause.op is OR else (clause,)


def prove_locally(
    base: FactBase, library: Library | None = None, progress: Callable[[int, int], None] = lambda done, total: None
) -> LocalProof:
    """Every goal of the base, in order."""
    library = library if library is not None else Library()
    out = LocalProof(base)
    patterns = Patterns()
    rooms: dict[int, Room] = {}
    goals = list(base.goals())
    for n, goal in enumerate(goals):
        if n % 256 == 0:
            progress(n, len(goals))
        facts = base.facts(goal.kind)
        room = rooms.get(id(facts))
        if room is None:
            room = rooms[id(facts)] = Room(facts, patterns)
        pattern = patterns(goal.clause, goal.tag)
        found = library.find(pattern, room.index)
        if found is None:
            core = room.core(goal.clause)
            made = None if core is None else _new(pattern, core, room.index)
            if made is None:
                out.open.append(goal)
                continue
            out.solved += 1
            shape, hint = library.learn(made[0], pattern, made[1], room.index)
            found = shape, made[1], hint
        out.obligations.append(Obligation(goal, *found))
        if goal.of_step:
            room.add(goal, pattern)
    return out


def _new(goal: Pattern, core: Sequence[int], index: Index) -> tuple[Shape, tuple[int, ...]] | None:
    """A new shape with its refutation; None when a second engine or the refutation fails."""
    shape, order = shape_of(goal, core, index)
    steps = refutation(shape)
    if steps is None:
        return None
    shape.steps = " ".join(f"{','.join(map(str, lits))}:{','.join(map(str, hints))}" for lits, hints in steps)
    return shape, order


__all__ = ["Goal", "GoalKind", "LocalProof", "Obligation", "prove_locally"]
