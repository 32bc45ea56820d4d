"""Prove every goal from the facts, in order; a goal of the step that is proved is a fact from then on.

A goal is written as the numbers of the clauses that show it; before it, as clauses of their own, lemmas that these
rest on and that nobody needed before.

**Theorem.**  Clauses that follow one after the other, each from those before it, follow from the facts alone; and none
is needed but those on which the last one rests.  (Backward checking: Goldberg and Novikov, 2003.)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.proof.certificate.clauses import Clause, Numbering
from interlock.proof.certificate.facts import Fact, FactBase, Goal, GoalKind
from interlock.proof.certificate.refute import NOTHING, Literals, Search

AT_ONCE, PARTS = 500, 20
"""Goals are asked in so many parts, but so many at once at the least: a solver goes through all clauses whenever it
is asked, and through all goals whenever it has a new clause."""


@dataclass(frozen=True)
class Lemma:
    """A clause that follows, and the clauses that show it."""

    clause: Clause
    hints: tuple[int, ...]


@dataclass(frozen=True)
class Obligation:
    """A goal that is proved: lemmas, and the clauses that show it; the number that its own clause has, or would have.

    The lemmas' clauses have the numbers before that.
    """

    goal: Goal
    lemmas: tuple[Lemma, ...]
    hints: tuple[int, ...]
    number: int


@dataclass
class LocalProof:
    """All obligations in order, and the goals for which none was found; the numbers of the clauses of `base.steps`."""

    base: FactBase
    facts: tuple[int, ...] = ()
    obligations: list[Obligation] = field(default_factory=list)
    open: list[Goal] = field(default_factory=list)


class Context:
    """Facts of one kind, and the goals that are proved of them.

    A clause has a number here as it has in what is written: when its turn comes, lemmas when they are first needed.
    Keys of clauses are the solver's numbers, or the complement of the number of one that is written (so less than 0).
    """

    def __init__(self, facts: Sequence[Fact], goals: Sequence[Goal]) -> None:
        self._goals = goals
        self.facts: list[int] = []
        """The number of the clause of each fact."""
        self._written: list[Clause] = []
        numbering = Numbering(self._written.append)
        for f in facts:
            clause = numbering.clause(f.clause)
            self.facts.append(len(self._written))
            self._written.append(clause)
        at_first = numbering.count
        self._clauses: list[tuple[Sequence[Clause], Clause]] = [((), ())]
        """What says of its parts what they mean, and the clause, of each goal from 1."""
        for g in goals:
            meaning: list[Clause] = []
            numbering.define = meaning.append
            clause = numbering.clause(g.clause)
            self._clauses.append((meaning, clause))
        self._literals = Literals(len(goals), at_first, numbering.count)
        self._search = Search(len(goals), numbering.count - at_first, numbering.count)
        self._lemmas: dict[int, int] = {}
        """The numbers under which lemmas are written, by their keys."""
        self._done: dict[int, int] = {}
        """The same of goals, by their place."""
        for n, clause in enumerate(self._written):
            self._search.add(self._literals.of(clause), n)

    def prove(self) -> Iterator[Obligation | None]:
        """How each goal is shown, in their order; None for one that does not follow."""
        total = len(self._goals)
        many = max(AT_ONCE, total // PARTS)
        for first in range(1, total + 1, many):
            last = min(first + many - 1, total)
            meanings = [self._load(n) for n in range(first, last + 1)]
            self._search.settle(first, last)
            for n, places in enumerate(meanings, first):
                yield self._shown(n, places)

    def _load(self, n: int) -> range:
        """Tell the solver what it means that a goal is false; where the clauses stand that say what its parts mean."""
        meaning, clause = self._clauses[n]
        literals = self._literals.of(clause)
        before = len(self._search.use)
        for m in meaning:
            self._search.add(self._literals.of(m), NOTHING)
        places = range(before, len(self._search.use))
        for x in literals:
            self._search.add((-n, -x), NOTHING)
        if self._goals[n - 1].of_step:
            self._search.add((n, *literals), NOTHING - n)
        return places

    def _shown(self, n: int, places: range) -> Obligation | None:
        goal, (meaning, clause) = self._goals[n - 1], self._clauses[n]
        for place, m in zip(places, meaning, strict=True):
            self._search.use[place] = len(self._written)
            self._written.append(m)
        settled, contradiction = self._search.settled.get(n), self._search.contradiction
        if settled is None and contradiction is None:
            return None
        keys = self._contradiction(contradiction) if settled is None else self._keys(settled)
        same = self._same(keys, clause) if goal.of_step else None
        if same is not None:
            keys = self._keys(same)
        lemmas = [self._lemma(*x) for x in self._unwritten(keys)]
        number = len(self._written)
        if goal.of_step:
            self._done[n] = number
            self._written.append(clause)
        if same is not None:
            self._lemmas[same] = number
        return Obligation(goal, tuple(lemmas), self._numbers(keys), number)

    def _same(self, keys: Sequence[int], clause: Clause) -> int | None:
        """The lemma that shows a clause alone, and says the same: it need not be written before it."""
        key = keys[0] if len(keys) == 1 else -1
        if key < 0 or key in self._lemmas or set(self._clause(key)) != set(clause):
            return None
        return key

    def _contradiction(self, number: int | None) -> list[int]:
        """The key of the clause without literals, by the solver's number."""
        assert number is not None
        given = self._search.given.get(number)
        return [number] if given is None else [~self._search.use[given]]

    def _keys(self, number: int) -> list[int]:
        """The keys of the clauses that show one that was learnt, without those that say when a goal is false."""
        found: list[int] = []
        given, use = self._search.given.get, self._search.use
        for h in self._search.learnt[number][1]:
            at = given(h)
            key = self._key(h) if at is None else ~use[at] if use[at] >= 0 else self._goal_key(use[at])
            if key is not None:
                found.append(key)
        return found

    def _goal_key(self, use: int) -> int | None:
        """The key of a goal's clause, if that is what was given."""
        goal = NOTHING - use
        return ~self._done[goal] if goal in self._done else self._search.settled.get(goal)

    def _key(self, number: int) -> int | None:
        """The key of a clause that was learnt; None when it says that a goal is not false."""
        literals, hints = self._search.learnt[number]
        if len(literals) == 1 and -literals[0] in self._search.settled:
            return None
        if len(hints) == 2:  # a goal's clause without its variable is no lemma
            keys = self._keys(number)
            if len(keys) == 1 and set(self._clause(keys[0])) == set(self._clause(number)):
                return keys[0]
        return number

    def _clause(self, key: int) -> Clause:
        """A clause by its key: where the solver has that some goal is not false, the literals of that goal.

        Where it has that a goal is false that goal has been proved: the clause was this goal's, and is used afterwards.
        """
        if key < 0:
            return self._written[~key]
        literals, back = self._search.learnt[key][0], self._literals.back
        found: dict[int, None] = {}
        for x in literals:
            own = back(x)
            if own:
                found[own] = None
            elif x < 0:
                found.update(dict.fromkeys(self._clauses[-x][1]))
        return tuple(found)

    def _unwritten(self, keys: Sequence[int]) -> list[tuple[int, list[int]]]:
        """The lemmas that were not needed before, each after those that it rests on."""
        found: dict[int, list[int]] = {}
        todo = [*keys]
        while todo:
            k = todo.pop()
            if k >= 0 and k not in self._lemmas and k not in found:
                found[k] = self._keys(k)
                todo += found[k]
        return sorted(found.items())

    def _lemma(self, key: int, keys: Sequence[int]) -> Lemma:
        made = Lemma(self._clause(key), self._numbers(keys))
        self._lemmas[key] = len(self._written)
        self._written.append(made.clause)
        return made

    def _numbers(self, keys: Sequence[int]) -> tuple[int, ...]:
        lemmas = self._lemmas
        return tuple([~k if k < 0 else lemmas[k] for k in keys])


def prove_locally(base: FactBase, progress: Callable[[int, int], None] = lambda done, total: None) -> LocalProof:
    """Every goal of the base, in order."""
    goals = list(base.goals())
    contexts: dict[int, list[int]] = {}
    for n, goal in enumerate(goals):
        contexts.setdefault(id(base.facts(goal.kind)), []).append(n)
    found: list[Obligation | None] = [None] * len(goals)
    numbers: dict[int, tuple[int, ...]] = {}
    done = 0
    for which, those in contexts.items():
        context = Context(base.facts(goals[those[0]].kind), [goals[n] for n in those])
        numbers[which] = tuple(context.facts)
        for n, made in zip(those, context.prove(), strict=True):
            if done % 256 == 0:
                progress(done, len(goals))
            found[n] = made
            done += 1
    shown = [made for made in found if made is not None]
    left = [g for g, made in zip(goals, found, strict=True) if made is None]
    return LocalProof(base, numbers.get(id(base.steps), ()), shown, left)


__all__ = ["Goal", "GoalKind", "LocalProof", "Obligation", "prove_locally"]
