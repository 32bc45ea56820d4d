"""Refutations with hints (LRAT without deletions): for each clause that follows, the clauses that show it.

CaDiCaL looks for them and writes down, for every clause that it learns, the clauses from which it has it.  All goals
that have the same facts are asked in one search: for goal i there is a variable that says that it is false, the search
decides these variables one after the other, and each is learnt to be false before the next one is decided.  A goal that
may be used for those after it holds where its variable is false.

**Theorem.**  A clause follows if, with all of its literals false, clause after clause forces a literal, until one has
none left; and so does all that is shown with it.  (Reverse unit propagation: Goldberg and Novikov, 2003; hints:
Cruz-Filipe and others, *Efficient Certified RAT Verification*, 2017.)  What the solver learns under a goal's variable
follows when the goal's own literals stand in its place, and what says what that variable means is then no longer needed
(definitions are conservative: Tseitin, 1968).
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence

import pysolvers
from pysat.solvers import Cadical195

from interlock.proof.certificate.clauses import Clause

PLAIN = {
    "lrat": 1,  # hints beside what is learnt
    "binary": 0,
    "inprocessing": 0,  # what it finds are clauses that no goal needs
    "lucky": 0,
    "walk": 0,
    "shrink": 0,  # more hints for shorter clauses
    "eagersubsume": 0,
    "reduce": 0,  # what is learnt is little, and may show a later goal
    "compact": 0,
    "rephase": 0,
    "restart": 0,  # a goal takes a conflict or two
    "stabilize": 0,  # else what is met first comes first in every other phase
    "chrono": 0,  # a goal that is decided is the first decision, and is undone with all others
    "reimply": 0,
    "ilb": 0,
    "ilbassumptions": 0,
}
"""How CaDiCaL searches: for many small goals, not for a hard one."""
NOTHING = -1
"""What a clause is used for that says nothing of the facts."""


class Turn:
    """Decides that a goal is false when the one before it is settled (what IPASIR-UP calls a propagator)."""

    is_lazy = False
    propagate = add_clause = provide_reason = list  # nothing to say: an empty list
    on_new_level = [].clear  # nothing to do

    def __init__(self) -> None:
        self.next = self.last = 0
        self._decided = False
        self._fixed: dict[int, int] = {}
        """Literals that were forced; 1 when they hold whatever is assumed."""
        self.on_assignment = self._fixed.__setitem__  # called very often, so that it is a function of C

    def of(self, first: int, last: int) -> None:
        """Whose turn it is now."""
        self.next, self.last, self._decided = first, last, False

    def decide(self) -> int:
        """The next goal, once nothing else is decided; 0 when the solver may decide as it likes."""
        if self._decided:
            return 0
        fixed = self._fixed.get
        while self.next <= self.last and fixed(-self.next):
            self.next += 1
        if self.next >= self.last or fixed(self.next):  # the last one is false by itself when no other one is
            return 0
        self._decided = True
        return self.next

    def check_model(self, model: list[int]) -> bool:
        """A state in which the goal is false, or none is left: the search ends."""
        return True

    def on_backtrack(self, to: int) -> None:
        """Nothing is decided any more but that some goal is false."""
        if to <= 1:
            self._decided = False


class Search:
    """Clauses and goals in their order, and what is learnt of them.

    Variable i of the solver says that goal i is false.  It is decided when it is the goal's turn, and not otherwise:
    the lowest variables come last, when all that could force them is decided.
    """

    def __init__(self, goals: int, low: int, count: int) -> None:
        """`low`: how many more variables are decided last; `count`: how many there are besides those of goals."""
        self.given: dict[int, int] = {}
        """By the solver's number of a clause: its place in `use`."""
        self.use: list[int] = []
        """What was given is used for."""
        self.learnt: dict[int, tuple[Sequence[int], Sequence[int]]] = {}
        """By the solver's number: the literals of a clause, and the numbers of those that show it."""
        self.settled: dict[int, int] = {}
        """For each goal that follows: the number of the clause that says so."""
        self.contradiction: int | None = None
        """The number of the clause without literals, if what is given contradicts itself."""
        self._void: int | None = None
        self._goals = goals
        self._top = goals + count
        self._read = self._met = 0
        self._turn = Turn()
        self._solver = Cadical195()
        self._solver.configure(PLAIN)
        self._proof = self._solver.prfile = tempfile.TemporaryFile()  # noqa: SIM115 (the solver closes it)
        self._solver.prfp = pysolvers.cadical195_tracepr(self._solver.cadical, self._proof)
        self._solver.connect_propagator(self._turn)
        for n in range(1, goals + 1):
            self._solver.observe(n)
        self.add([*range(1, goals + low + 1), -1], NOTHING)  # says nothing; but what is met first is decided last

    def add(self, clause: Sequence[int], use: int) -> None:
        """A clause that is given, and what it is used for."""
        self._solver.add_clause(clause)
        if not clause and self._void is None:
            self._void = len(self.use)
        self.use.append(use)

    def settle(self, first: int, last: int) -> None:
        """Ask goals in their order; afterwards those that follow are `settled`."""
        while first <= last and self.contradiction is None:
            self._turn.of(first, last)
            self._top += 1
            self.add((-self._top, *range(first, last + 1)), NOTHING)
            if self._solver.solve(assumptions=[self._top]):  # some goal can be false
                self._note()
                self.add((-self._top,), NOTHING)
                first = self._turn.next + 1
            else:
                self._note()
                self.use.append(NOTHING)  # the solver gives a number to what it found of the assumption
                return

    def _note(self) -> None:
        """Read what was learnt.  The solver numbers clauses as they come, given and learnt alike."""
        pysolvers.flushpr(self._solver.prfp)
        self._proof.seek(self._read)
        text = self._proof.read()
        self._read += len(text)
        for line in text.splitlines():
            if b"d" in line:  # what is dropped
                continue
            numbers = [*map(int, line.split())]
            number, end = numbers[0], numbers.index(0)
            if self._met < number - 1:
                self._number_given(number - 1)
            self._met = number
            literals = numbers[1:end]
            self.learnt[number] = literals, numbers[end + 1 : -1]
            if end == 2 and -self._goals <= literals[0] < 0:
                self.settled[-literals[0]] = number
            elif end == 1:
                self.contradiction = number
        self._number_given(self._met + len(self.use) - len(self.given))

    def _number_given(self, last: int) -> None:
        """What was given after what is known, up to a number."""
        for n in range(self._met + 1, last + 1):
            if len(self.given) == self._void:
                self.contradiction = n
            self.given[n] = len(self.given)
        self._met = max(self._met, last)
        if len(self.given) > len(self.use):
            raise ValueError("the solver does not number clauses as they come")


class Literals:
    """Numbers of literals in the solver, where the lowest are those of goals.

    What appears in goals alone is low, too: it is not to be decided before its goal's turn.
    """

    def __init__(self, goals: int, facts: int, count: int) -> None:
        """`facts`: how many numbers appear in facts; `count`: how many there are."""
        low, high = goals - facts, goals + count - facts
        numbers = [0, *(high + n for n in range(1, facts + 1)), *(low + n for n in range(facts + 1, count + 1))]
        self._to = [*numbers, *(-n for n in reversed(numbers[1:]))]
        self._back = [0] * (2 * (goals + count) + 1)
        for n, v in enumerate(numbers):
            self._back[v], self._back[-v] = n, -n

    def of(self, clause: Clause) -> list[int]:
        """The solver's literals."""
        to = self._to
        return [to[x] for x in clause]

    def back(self, literal: int) -> int:
        """Our literal, 0 when it is that of a goal."""
        return self._back[literal]
