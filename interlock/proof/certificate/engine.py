"""Prove every goal from the facts, in order; a goal of the step that is proved is a fact from then on.

A goal is written as the numbers of the clauses that show it; before it, as clauses of their own, lemmas that these
rest on and that nobody needed before.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from interlock.proof.certificate.clauses import Clause, Numbering
from interlock.proof.certificate.facts import Fact, FactBase, Goal, GoalKind
from interlock.proof.certificate.refute import Clauses


@dataclass(frozen=True)
class Lemma:
    """A clause that follows, and the clauses that show it."""

    clause: Clause
    hints: tuple[int, ...]


@dataclass(frozen=True)
class Obligation:
    """A goal that is proved: lemmas, and the clauses that show it; the numbers of all facts on which it rests."""

    goal: Goal
    lemmas: tuple[Lemma, ...]
    hints: tuple[int, ...]
    facts: tuple[int, ...]


@dataclass
class LocalProof:
    """All obligations in order, and the goals for which none was found."""

    base: FactBase
    obligations: list[Obligation] = field(default_factory=list)
    open: list[Goal] = field(default_factory=list)


class Room:
    """Facts of one kind, and what is proved of them.

    A lemma is written when it is first needed, so that clauses have other numbers here than in what is written.
    """

    def __init__(self, facts: Sequence[Fact]) -> None:
        self._known = Clauses()
        self._numbering = Numbering(self._give)
        self._written: dict[int, int] = {}
        self._facts: dict[int, int] = {}
        """Clauses that are facts."""
        self._rests: dict[int, frozenset[int]] = {}
        """The facts on which a lemma rests."""
        for f in facts:
            self._fact(self._numbering.clause(f.clause))

    def _give(self, clause: Clause) -> int:
        number = self._known.add(clause)
        self._written[number] = len(self._written)
        return number

    def _fact(self, clause: Clause) -> None:
        self._facts[self._give(clause)] = len(self._facts)

    def prove(self, goal: Goal) -> Obligation | None:
        """How a goal is shown; None when it does not follow."""
        clause = self._numbering.clause(goal.clause)
        hints = self._known.show(clause)
        if hints is None:
            return None
        lemmas = [self._lemma(n, how) for n, how in self._unwritten(hints)]
        made = Obligation(goal, tuple(lemmas), self._numbers(hints), tuple(sorted(self._resting(hints))))
        if goal.of_step:
            self._fact(clause)
        return made

    def _unwritten(self, hints: Sequence[int]) -> list[tuple[int, Sequence[int]]]:
        """The lemmas that were not needed before, each after those that it rests on."""
        found: dict[int, Sequence[int]] = {}
        todo = [*hints]
        while todo:
            n = todo.pop()
            how = None if n in self._written or n in found else self._known.lemma(n)
            if how is not None:
                found[n] = how
                todo += how
        return sorted(found.items())

    def _lemma(self, number: int, hints: Sequence[int]) -> Lemma:
        made = Lemma(self._known.clauses[number], self._numbers(hints))
        self._rests[number] = self._resting(hints)
        self._written[number] = len(self._written)
        return made

    def _numbers(self, hints: Sequence[int]) -> tuple[int, ...]:
        return tuple([self._written[n] for n in hints])

    def _resting(self, hints: Sequence[int]) -> frozenset[int]:
        facts = [self._facts[n] for n in hints if n in self._facts]
        return frozenset(facts).union(*(self._rests[n] for n in hints if n in self._rests))


def prove_locally(base: FactBase, progress: Callable[[int, int], None] = lambda done, total: None) -> LocalProof:
    """Every goal of the base, in order."""
    out = LocalProof(base)
    rooms: dict[int, Room] = {}
    goals = list(base.goals())
    for n, goal in enumerate(goals):
        if n % 256 == 0:
            progress(n, len(goals))
        facts = base.facts(goal.kind)
        room = rooms.get(id(facts))
        if room is None:
            room = rooms[id(facts)] = Room(facts)
        made = room.prove(goal)
        if made is None:
            out.open.append(goal)
        else:
            out.obligations.append(made)
    return out


__all__ = ["Goal", "GoalKind", "LocalProof", "Obligation", "prove_locally"]
