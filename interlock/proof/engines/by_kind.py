"""Goals asked with the kinds of facts that goals of their kind needed before.

Each kind of facts holds under a condition of its own, a literal that is assumed or not.  The first goals of a kind are
asked with all facts, the others with the kinds of facts on which the refutations so far rest: of a large yard, what one
locked section excludes is most of what a solver would follow up, and few claims need it.  What does not follow from
these is asked with all facts.

**Theorem.**  What follows from some facts follows from all of them, so that a choice of facts can leave a goal open but
not prove a wrong one; a choice is as good as the final clause over the assumed conditions that a refutation ends with.
(Proof-based abstraction: McMillan and Amla, *Automatic Abstraction without Counterexamples*, 2003; conditions as
assumptions: Een and Sorensson, *Temporal Induction by Incremental SAT Solving*, 2003.)
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping, Sequence

from interlock.logic.expr import Expr
from interlock.logic.names import Name
from interlock.proof.engines import Answer, Sat, solver
from interlock.proof.engines.batch import Decision, decisions, denials_of, follows
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.plaisted_greenbaum import OneSided

FIRST = 3  # goals of a kind that are asked with all facts


class ByKind:
    """One solver, the conditions of its kinds of facts, and those that goals of each kind needed."""

    def __init__(self, sat: Sat, conditions: Sequence[int]) -> None:
        self._sat = sat
        self._all = conditions
        self._needed: dict[Hashable, dict[int, None]] = {}
        self._asked: dict[Hashable, int] = {}

    def follows(self, kind: Hashable, denials: Sequence[Sequence[int]]) -> bool:
        """Whether a goal of a kind follows, of which no part can be false."""
        needed = self._needed.setdefault(kind, {})
        asked = self._asked[kind] = self._asked.get(kind, 0) + 1
        if asked > FIRST and follows(self._sat, denials, tuple(needed)):
            return True
        for denial in denials:
            if self._sat.ask(*self._all, *denial) is not Answer.UNSAT:
                return False
            core = frozenset(self._sat.core())
            needed |= dict.fromkeys(c for c in self._all if c in core)
        return True


def decided_by_kind(
    goals: Iterable[tuple[Hashable, Expr]],
    facts: Iterable[tuple[Hashable, Expr]],
    meaning: Mapping[Name, Expr],
    limits: Limits,
    known: Sequence[bool],
    patience: int = 0,
) -> list[Decision]:
    """Which goals follow from facts over names that have a meaning, both by kind; see `decisions`."""
    cnf = OneSided(meaning)
    conditions: dict[Hashable, int] = {}
    for kind, x in facts:
        condition = conditions.get(kind)
        if condition is None:
            condition = conditions[kind] = cnf.fresh()
        cnf.require(x, (-condition,))
    denials = [(kind, denials_of(cnf, x)) for kind, x in goals]
    asking = ByKind(solver(limits.engine, cnf, limits.query_ms), [*conditions.values()])
    return decisions(lambda n: asking.follows(*denials[n]), known, patience)
