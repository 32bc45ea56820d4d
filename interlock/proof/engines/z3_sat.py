"""Z3 as a propositional solver, fed with DIMACS (Python terms in the inner loop cost several times more)."""

from __future__ import annotations

from collections.abc import Iterable

import z3

from interlock.proof.engines.answer import Answer
from interlock.proof.engines.tseitin import Cnf


class Z3Sat:
    """One solver over the clauses of a `Cnf`; queries are assumed literals."""

    def __init__(self, cnf: Cnf, timeout_ms: int) -> None:
        self._cnf = cnf
        self._context = z3.Context()
        self._solver = z3.SolverFor("QF_FD", ctx=self._context)
        self._solver.set("timeout", timeout_ms)
        self._solver.from_string(cnf.dimacs())
        self._bools: dict[int, z3.BoolRef] = {}
        self._assumed: dict[int, tuple[z3.BoolRef, int]] = {}

    def _bool(self, n: int) -> z3.BoolRef:
        found = self._bools.get(n)
        if found is None:
            c = self._context
            symbol = z3.Z3_mk_int_symbol(c.ref(), n)
            found = z3.BoolRef(z3.Z3_mk_const(c.ref(), symbol, z3.BoolSort(c).ast), c)
            self._bools[n] = found
        return found

    def ask(self, *literals: int) -> Answer:
        """Whether the clauses can hold together with the literals."""
        assumed = [self._bool(x) if x > 0 else z3.Not(self._bool(-x)) for x in literals]
        self._assumed = {x.get_id(): (x, n) for x, n in zip(assumed, literals, strict=True)}
        found = self._solver.check(*assumed)
        if found == z3.unsat:
            return Answer.UNSAT
        return Answer.SAT if found == z3.sat else Answer.UNKNOWN

    def core(self) -> Iterable[int]:
        """Of the literals of a question that was answered UNSAT, some together with which the clauses cannot hold."""
        return [self._assumed[x.get_id()][1] for x in self._solver.unsat_core()]

    def values(self) -> dict[int, bool]:
        """Truth of the variable numbers after a SAT answer."""
        model = self._solver.model()
        found: dict[int, bool] = {}
        for decl in model.decls():
            name = decl.name()
            number = int(name[2:]) if isinstance(name, str) and name.startswith("k!") else int(name)
            found[number] = z3.is_true(model[decl])
        return found

    def model(self) -> dict[str, int]:
        """Values of all named variables after a SAT answer."""
        return self._cnf.read(self.values())
