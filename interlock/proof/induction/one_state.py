"""Claims that follow from what the invariants say of one state.

**Theorem.**  An inductive invariant holds before and after every step, so that a claim about the state before a step
follows if the invariants before it imply it, and one about the signals that a step shows if the invariants after it,
what these signals are defined to show, and what is assumed of the inputs imply it.  (Manna and Pnueli, 1995: rule of
consequence.)

No definition of a place is needed, and so no goal pulls in half a railway: all of them can be asked of one solver
that knows every invariant, however large the layout.  A claim about the state after a step that names nothing else,
and no lamp, is a claim about one state as well, and asked without priming.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from functools import cached_property, partial

from interlock.dataclass import dataclass
from interlock.logic.expr import Expr, Substitution, var, variables
from interlock.logic.names import Name
from interlock.proof.abstraction.canonical import CanonicalForms
from interlock.proof.engines.batch import Decision, kept
from interlock.proof.engines.by_kind import decided_by_kind
from interlock.proof.engines.limits import Limits
from interlock.proof.system.neighbourhood import Neighbourhood
from interlock.proof.system.relation import TransitionRelation

MOST = 40_000  # goals asked of one solver: each has to read every invariant
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

    def __init__(
        self, relation: TransitionRelation, where: Neighbourhood, hypotheses: Sequence[Expr], limits: Limits
    ) -> None:
        """`hypotheses`: the invariants; they hold before the step, and after it if it keeps them all."""
        self.relation = relation
        self.where = where
        self.hypotheses = hypotheses
        self.limits = limits

    @cached_property
    def _kept(self) -> frozenset[str]:
        """The next values of which invariants speak."""
        later = self.relation.later
        return frozenset(later[v] for names in self._names for v in names if v in later)

    def questions(self, goals: Iterable[tuple[int, Expr]]) -> tuple[list[OfState], list[int]]:
        """Numbered goals that are no part of the induction: those about one state, and the others.

        What is said of routes and lamps tells which: of their next values, or of all else before the step.
        """
        before: list[int] = []
        after: list[int] = []
        others: list[int] = []
        later = self.relation.later
        _ = self._names  # read once, so that processes inherit it
        state = frozenset(later)
        unlit = frozenset(later.values()) - self._shown
        of_routes = frozenset(self.where.routes.indexed)
        now = (of_routes & state) | self.where.lamps
        following = (of_routes & frozenset(later.values())) | self._shown
        for n, x in goals:
            names = variables((x,))
            if state.issuperset(names):
                before.append(n)
            elif now.isdisjoint(names) and not following.isdisjoint(names):
                (before if unlit.issuperset(names) else after).append(n)
            else:
                others.append(n)
        return [
            OfState(some[k : k + MOST], some is after) for some in (after, before) for k in range(0, len(some), MOST)
        ], others

    @cached_property
    def _shown(self) -> frozenset[str]:
        """The next values of lamps."""
        return frozenset(self.relation.later[x] for x in self.where.lamps)

    @cached_property
    def _names(self) -> list[tuple[Name, ...]]:
        """What each invariant reads."""
        return [tuple(variables((x,))) for x in self.hypotheses]

    def decide(self, goals: Sequence[Expr], after: bool) -> list[Decision]:
        """Which goals follow from the invariants before a step, or after it."""
        if not after:
            goals = [*map(self._unprimed, goals)]
        definitions, facts = self.told(goals, after)
        forms = CanonicalForms(definitions)
        names = [*self._names, *(variables((x,)) for x in facts[len(self._names) :])]
        asked = partial(
            decided_by_kind,
            [(_families(variables((x,))), x) for x in goals],
            [*zip(map(_families, names), facts, strict=True)],
            definitions,
            self.limits,
            patience=PATIENCE,
        )
        return kept(len(goals), self.limits, lambda: forms.of(definitions, goals, facts), asked)

    @cached_property
    def _unprimed(self) -> Callable[[Expr], Expr]:
        """Turns what is said of the state one step later into what is said of a state."""
        return Substitution({later: var(v) for v, later in self.relation.later.items()})

    def told(self, goals: Sequence[Expr], after: bool) -> tuple[Mapping[Name, Expr], Sequence[Expr]]:
        """What is defined and known of one state.

        After a step: why a next value is what it is if a goal names a lamp that shows it, or names the value, which no
        route decides; and nothing of places that depends on routes.
        """
        if not after:
            return {}, self.hypotheses
        relation, indexed, timers = self.relation, self.where.routes.indexed, self.relation.timers
        names = variables(goals)
        lit = {v: relation.definitions[v] for v in names if v in self._shown}
        shown = {**lit, **variables(lit.values())}
        kept = self._kept - shown.keys()
        asked = names.keys() - kept | shown.keys()
        definitions: dict[Name, Expr] = {}
        seen: set[str] = set()
        todo = [*names, *shown]
        while todo:
            v = todo.pop()
            if v in seen:
                continue
            seen.add(v)
            x = relation.definitions.get(v)
            if x is None or (v in kept and v not in names):
                if v in timers:  # its input is true while it is (A-TON)
                    todo.append(timers[v].input)
                continue
            reads = relation.reads[v]
            if v not in asked and (v in kept or v not in indexed) and any(u in indexed for u in reads):
                continue
            definitions[v] = x
            todo += reads
        inputs = [a.expr for a in relation.assumptions if all(v in seen for v in variables((a.expr,)))]
        return definitions, [*map(relation.after, self.hypotheses), *inputs]


def _families(names: Iterable[Name]) -> Hashable:
    """The kind of what reads some names: of what it speaks, wherever that is."""
    return frozenset([v.family for v in names])
