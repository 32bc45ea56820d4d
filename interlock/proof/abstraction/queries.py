"""Goals of a large system asked of local abstractions: first with a truncated cone of influence, then with the whole.

**Theorem.**  What follows from some lines of a system follows from the system, as fewer premises prove fewer goals; a
goal that neither abstraction shows is left open, for others to ask.  (Localization reduction: Kurshan, *Computer-Aided
Verification of Coordinating Processes*, 1994.)
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from interlock.dataclass import dataclass
from interlock.logic.expr import Expr
from interlock.logic.names import Kind
from interlock.proof.abstraction.canonical import CanonicalForms
from interlock.proof.abstraction.focus import foci
from interlock.proof.abstraction.local import Focus, LocalAbstractions
from interlock.proof.abstraction.quotient import abstraction
from interlock.proof.engines.batch import decided
from interlock.proof.engines.limits import Limits
from interlock.proof.system.neighbourhood import Neighbourhood
from interlock.proof.system.relation import TransitionRelation

CHUNK = 60  # foci that one process takes one after the other


@dataclass(frozen=True)
class Batch:
    """Foci, the goals that are in them, and the numbers of the goals."""

    foci: Sequence[Focus]
    goals: Sequence[int]

    def __len__(self) -> int:
        return len(self.goals)


class LocalQueries:
    """Goals asked of local abstractions, and what follows."""

    def __init__(
        self, relation: TransitionRelation, where: Neighbourhood, hypotheses: Sequence[Expr], limits: Limits
    ) -> None:
        """`hypotheses`: the invariants."""
        self.local = LocalAbstractions(relation, where, hypotheses)
        self.limits = limits
        self._forms = CanonicalForms({})
        self._answered: dict[str, list[bool]] = {}
        """By the form of an abstraction, which of what is asked follows: most places of a yard are like another."""

    def batches(self, goals: Iterable[tuple[int, Expr]]) -> list[Batch]:
        """Numbered goals in so many batches; some are in none."""
        found = foci(self.local, goals)
        return [
            Batch(some, tuple(dict.fromkeys(n for s in some for n in s.goals)))
            for some in (found[k : k + CHUNK] for k in range(0, len(found), CHUNK))
        ]

    def left(self, batch: Batch) -> list[int]:
        """The goals that a batch leaves open."""
        return [*dict.fromkeys(n for focus in batch.foci for n in self._left(focus))]

    def _left(self, focus: Focus) -> dict[int, None]:
        """The goals of a focus that follow neither from the truncated cone nor from the whole.

        An overlap lies elsewhere than the signal that holds it: the truncated cone is not asked.
        """
        if not any(h.kind is Kind.OVERLAP for h in focus.homes):
            open_ = self._open(focus, truncated=True)
            if not open_:
                return open_
            focus = focus.only(open_)
        return self._open(focus, truncated=False)

    def _open(self, focus: Focus, truncated: bool) -> dict[int, None]:
        """The goals of a focus that do not follow in its abstraction."""
        made = abstraction(self.local, focus, truncated)
        asked = [x for x, _ in made.asked]
        form = self._forms.of(made.definitions, asked, made.facts)
        follows = self._answered.get(form)
        if follows is None:
            found = decided(asked, made.facts, made.definitions, self.limits, lambda: form)
            follows = self._answered[form] = [d.follows for d in found]
        return {n: None for (_, goals), shown in zip(made.asked, follows, strict=True) if not shown for n in goals}
