"""MiniSat (through PySAT): quick on many small questions about the same clauses, and on a run that grows."""

from __future__ import annotations

import time
from collections.abc import Iterable

from pysat.solvers import Minisat22

from interlock.proof.engines.answer import Answer
from interlock.proof.engines.tseitin import Cnf

CONFLICTS = 2_000_000
SLICE = 5_000
"""Conflicts after which the clock is looked at, where there is a time limit."""


class MiniSat:
    """One solver over the clauses of a `Cnf`, and those that are added; queries are assumed literals.

    until: by the monotonic clock in seconds; what is not answered then is UNKNOWN.  Without it the limit is a number of
    conflicts, so that answers do not depend on the machine.
    """

    def __init__(self, cnf: Cnf | None = None, until: float | None = None) -> None:
        self._solver = Minisat22(bootstrap_with=cnf.clauses if cnf is not None else None)
        self._cnf = cnf
        self._until = until

    def add(self, clauses: Iterable[Iterable[int]]) -> None:
        """More clauses; what was learnt before remains."""
        self._solver.append_formula([list(c) for c in clauses], no_return=True)

    def ask(self, *literals: int) -> Answer:
        """Whether the clauses can hold together with the literals; UNKNOWN after too many conflicts, or too late."""
        budget = CONFLICTS if self._until is None else SLICE
        while True:
            self._solver.conf_budget(budget)
            found = self._solver.solve_limited(assumptions=list(literals))
            if found is not None:
                return Answer.SAT if found else Answer.UNSAT
            if self._until is None or time.monotonic() >= self._until:
                return Answer.UNKNOWN

    def core(self) -> Iterable[int]:
        """Of the literals of a question that was answered UNSAT, some together with which the clauses cannot hold."""
        return self._solver.get_core() or ()

    def values(self) -> dict[int, bool]:
        """Truth of the variable numbers after a SAT answer."""
        return {abs(x): x > 0 for x in self._solver.get_model() or ()}

    def model(self) -> dict[str, int]:
        """Values of all named variables of the `Cnf` after a SAT answer."""
        return self._cnf.read(self.values()) if self._cnf is not None else {}
