"""MiniSat (through PySAT): quick on many small questions about the same clauses."""

from __future__ import annotations

from pysat.solvers import Minisat22

from interlock.proof.engines.answer import Answer
from interlock.proof.engines.tseitin import Cnf

CONFLICTS = 2_000_000


class MiniSat:
    """One solver over the clauses of a `Cnf`; queries are assumed literals."""

    def __init__(self, cnf: Cnf) -> None:
        self._solver = Minisat22(bootstrap_with=cnf.clauses)

    def ask(self, *literals: int) -> Answer:
        """Whether the clauses can hold together with the literals; UNKNOWN after too many conflicts."""
        self._solver.conf_budget(CONFLICTS)
        found = self._solver.solve_limited(assumptions=list(literals))
        return Answer.UNKNOWN if found is None else Answer.SAT if found else Answer.UNSAT
