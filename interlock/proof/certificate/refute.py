"""Refutations with hints (LRAT without deletions): for each clause that follows, the clauses that show it.

A clause is shown by *unit propagation*: with all of its literals false, clause after clause forces a literal, until
one has none left.  MiniSat says in which order literals are forced, and for each that is needed a clause is looked up
that forces it.  Where propagation alone shows nothing Glucose looks for a proof and writes the clauses that it learns:
each of them is shown by propagation, and with them the goal.

**Theorem.**  A clause that is shown so follows, and so does all that is shown with it.  (Reverse unit propagation:
Goldberg and Novikov, 2003; hints: Cruz-Filipe and others, *Efficient Certified RAT Verification*, 2017.)
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from itertools import chain

import pysolvers
from pysat.solvers import Glucose4, Minisat22

from interlock.proof.certificate.clauses import Clause

Trail = list[int]
"""Literals in the order in which they are forced; the last one of a contradiction is false in a clause without any."""


class Clauses:
    """Clauses by number, and what follows from them."""

    def __init__(self) -> None:
        self.clauses: list[Clause] = []
        self._with: dict[int, list[int]] = {}
        self._often: dict[int, int] = {}
        """The clause that forced a literal when it was last looked up."""
        self._forced: dict[int, int] = {}
        """Literals that are true whatever is assumed, and the clause of each alone."""
        self._contradiction: int | None = None
        self._lemmas: dict[int, tuple[Trail, Clause] | Sequence[int]] = {}
        """What was learnt, and how it is shown: hints, once somebody needed them."""
        self._propagates = Minisat22()
        self._searches = Glucose4(with_proof=True)
        self._read = 0

    def add(self, clause: Clause) -> int:
        """A clause that is given, or that was shown; its number."""
        self._searches.add_clause(clause)
        return self._add(clause)

    def _add(self, clause: Clause) -> int:
        number = self._note(clause)
        self._propagates.add_clause(clause)
        todo = deque([number])
        while todo:  # what is forced by itself now
            todo += self._forces(todo.popleft())
        return number

    def _note(self, clause: Clause) -> int:
        number = len(self.clauses)
        self.clauses.append(clause)
        for x in clause:
            self._with.setdefault(x, []).append(number)
        return number

    def _forces(self, number: int) -> Sequence[int]:
        """The clauses to look at next if it forces a literal whatever is assumed: a lemma says that literal alone."""
        forced, clause = self._forced, self.clauses[number]
        free = [x for x in clause if -x not in forced]
        if len(free) > 1 or (free and free[0] in forced):
            return ()
        shown = number
        if len(clause) != len(free):
            shown = self._note(tuple(free))
            self._lemmas[shown] = [*(forced[-x] for x in clause if -x in forced), number]
        if not free:
            self._contradiction = shown if self._contradiction is None else self._contradiction
            return ()
        forced[free[0]] = shown
        return self._with.get(-free[0], ())

    def show(self, clause: Clause) -> list[int] | None:
        """The numbers of clauses that show the clause, in their order; None when it does not follow."""
        found = self._propagate(clause)
        if found is None:
            if self._searches.solve(assumptions=[-x for x in clause]) is not False:
                return None
            for learnt in self._learnt():
                trail = self._propagate(learnt)
                if trail is not None:
                    self._lemmas[self._add(learnt)] = trail, learnt
            found = self._propagate(clause)
        return None if found is None else self._hints(found, clause, len(self.clauses))

    def lemma(self, number: int) -> Sequence[int] | None:
        """The numbers of clauses, all of them smaller, that show a lemma; None when the clause was given or a goal."""
        how = self._lemmas.get(number)
        if isinstance(how, tuple):
            trail, clause = how
            how = self._lemmas[number] = self._hints(trail, clause, number)
        return how

    def _propagate(self, clause: Clause) -> Trail | None:
        """What is forced when the clause is false, if that ends in a contradiction."""
        holds, trail = self._propagates.propagate([-x for x in reversed(clause)])
        return None if holds else trail

    def _learnt(self) -> Iterator[Clause]:
        """The clauses that the search has learnt since they were last read."""
        proof = self._searches.prfile
        pysolvers.flushpr(self._searches.prfp)
        proof.seek(self._read)
        lines = proof.read()
        self._read += len(lines)
        for line in lines.decode("ascii").splitlines():
            if not line.startswith("d"):
                yield tuple(map(int, line.split()[:-1]))

    def _hints(self, trail: Trail, clause: Clause, below: int) -> list[int]:
        """The clauses with smaller numbers that force what is needed, in their order."""
        if self._contradiction is not None and self._contradiction < below:
            return [self._contradiction]
        forced, clauses = self._forced, self.clauses
        at = dict(zip(trail, range(len(trail)), strict=True))
        wanted = next(([x] for x in clause if x in at or forced.get(x, below) < below), [])
        last: list[int] = []
        if not wanted:
            last = [self._forcing(trail[-1], at, len(trail), below)]
            wanted = [-x for x in clauses[last[0]]]
        known = {-x for x in clause}
        found: list[tuple[int, int]] = []
        while wanted:
            x = wanted.pop()
            if x in known:
                continue
            known.add(x)
            number = forced.get(x, below)
            place = -1
            if number >= below:
                place = at[x]
                number = self._forcing(x, at, place, below)
                wanted += [-y for y in clauses[number] if y != x and -y not in known]
            found.append((place, number))
        found.sort()
        return [*(number for _, number in found), *last]

    def _forcing(self, x: int, at: dict[int, int], place: int, below: int) -> int:
        """A clause with a smaller number in which all but a literal are false before a place in the trail."""
        forced, clauses = self._forced.get, self.clauses
        often = self._often.get(x, below)
        for number in chain((often,), self._with[x]):
            if number < below:
                for y in clauses[number]:
                    if at.get(-y, place) >= place and y != x and forced(-y, below) >= below:
                        break
                else:
                    self._often[x] = number
                    return number
        raise AssertionError("a literal was forced by no clause")
