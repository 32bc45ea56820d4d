"""The facts of a system as small clauses, and the goals that a proof owes.

A *clause* here is a disjunction whose parts are literals or small expressions.  Facts are

    def   one half of a definition: a wire, an event or a next value implies, or is implied by, a part of its meaning
    asm   a part of an assumption about the world, for one step
    inv   a part of an invariant, in the old state: every part is itself a goal of the induction
    done  a goal of the step that was proved before
    ini   a part of the initial condition (for the base case alone)
    val   a small-range input has no two values at once

Every fact is numbered in the order in which `interlock verify` builds it again from the written system; goals of the
step that are proved are numbered on from there, in their order, and are facts for what comes after them.

**Theorem.**  Together the clauses of an expression are equivalent to it.  If each goal of the base case follows from
the initial condition, and each other goal from the facts of a step and the goals of the step before it, then the
invariants hold in all reachable states, and so do the claims.  (Induction: Floyd, 1967; each goal rests on earlier ones
alone, so that none shows itself.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import StrEnum

from interlock.dataclass import dataclass
from interlock.logic.expr import OR, TRUE, Expr, disj, eq, implies, neg, parts_of, var
from interlock.logic.names import Name
from interlock.proof.claims import Claim, Invariant
from interlock.proof.system.relation import TransitionRelation
from interlock.proof.system.restart import InitialCondition


def split(x: Expr) -> list[Expr]:
    """An expression as clauses that together say the same.

    A conjunction falls into its parts; a disjunction with one conjunction in it is distributed over that one.
    """
    together = parts_of(x)
    if together:
        return [y for a in together for y in split(a)]
    if x.op is OR:
        inner = [(i, c) for i, a in enumerate(x.args) if (c := parts_of(a))]
        if len(inner) == 1:
            i, those = inner[0]
            rest = x.args[:i] + x.args[i + 1 :]
            return [y for b in those for y in split(disj((*rest, b)))]
    return [] if x is TRUE else [x]


def halves(name: Name, x: Expr) -> list[Expr]:
    """A definition as clauses."""
    return split(implies(var(name), x)) + split(implies(x, var(name)))


class Kind(StrEnum):
    """Where a fact or a goal comes from."""

    DEFINITION = "def"
    ASSUMPTION = "asm"
    INVARIANT = "inv"
    INITIAL = "ini"
    VALUES = "val"
    DONE = "done"


@dataclass(frozen=True)
class Fact:
    """A clause that may be used: its kind, the name of its source, and the clause."""

    kind: Kind
    source: str
    clause: Expr


class GoalKind(StrEnum):
    """What a goal is part of: the base case, the step, a claim, or the claim about the restart."""

    BASE = "base"
    STEP = "step"
    CLAIM = "claim"
    START = "start"


@dataclass(frozen=True)
class Goal:
    """A clause to be proved; `index` is the number of its invariant or claim."""

    kind: GoalKind
    index: int
    clause: Expr
    source: str = ""

    @property
    def of_step(self) -> bool:
        """It is proved of every step, so that it is a fact for the goals after it."""
        return self.kind not in (GoalKind.BASE, GoalKind.START)

    @property
    def fact(self) -> Fact:
        """What it is for the goals after it."""
        return Fact(Kind.DONE, self.source, self.clause)


class FactBase:
    """All facts and goals of a system, its invariants and claims."""

    def __init__(
        self,
        relation: TransitionRelation,
        initial: InitialCondition,
        invariants: Sequence[Invariant],
        claims: Sequence[Claim],
        start: Expr | None = None,
    ) -> None:
        self.relation = relation
        self.initial = initial
        self.invariants = tuple(invariants)
        self.claims = tuple(claims)
        self.start = start
        self.steps: list[Fact] = []
        for name, x in relation.definitions.items():
            self.steps += [Fact(Kind.DEFINITION, name, c) for c in halves(name, x)]
        for asm in relation.assumptions:
            self.steps += [Fact(Kind.ASSUMPTION, asm.id, c) for c in split(asm.expr)]
        self._parts = [split(i.expr) for i in self.invariants]
        for i, those in zip(self.invariants, self._parts, strict=True):
            self.steps += [Fact(Kind.INVARIANT, f"{i.id} {i.place}", c) for c in those]
        for name, size in relation.sizes.items():
            for a in range(size):
                self.steps += [
                    Fact(Kind.VALUES, name, disj((neg(eq(name, a)), neg(eq(name, b))))) for b in range(a + 1, size)
                ]
        self.restart = [Fact(Kind.INITIAL, "", c) for x in initial.parts for c in split(x)]
        self._next = [[relation.after(c) for c in those] for those in self._parts]

    def goals(self) -> Iterator[Goal]:
        """Every goal: the base of each invariant, the step of each invariant, and each claim, in the order in which
        they may rest on each other; the restart."""
        for n, those in enumerate(self._parts):
            for c in those:
                yield Goal(GoalKind.BASE, n, c, self.invariants[n].id)
        for n, those in enumerate(self._next):
            for c in those:
                yield Goal(GoalKind.STEP, n, c, self.invariants[n].id)
        for n, claim in enumerate(self.claims):
            for c in split(claim.expr):
                yield Goal(GoalKind.CLAIM, n, c, claim.id)
        if self.start is not None:
            for c in split(self.start):
                yield Goal(GoalKind.START, 0, c)

    def facts(self, kind: GoalKind) -> list[Fact]:
        """The facts that goals of a kind may use from the first on."""
        return self.restart if kind in (GoalKind.BASE, GoalKind.START) else self.steps
