"""cvc5 as a propositional solver: an engine of other makers, for a second opinion (extra `recheck`)."""

from __future__ import annotations

from collections.abc import Iterable

import cvc5

from interlock.proof.engines.answer import Answer
from interlock.proof.engines.tseitin import Cnf


class Cvc5Sat:
    """One solver over the clauses of a `Cnf`; queries are assumed literals."""

    def __init__(self, cnf: Cnf, timeout_ms: int) -> None:
        self._terms = cvc5.TermManager()
        self._solver = cvc5.Solver(self._terms)
        self._solver.setOption("incremental", "true")
        self._solver.setOption("produce-unsat-assumptions", "true")
        self._solver.setOption("tlimit-per", str(timeout_ms))
        self._solver.setLogic("QF_UF")
        boolean = self._terms.getBooleanSort()
        self._positive = [self._terms.mkConst(boolean, str(n)) for n in range(cnf.count + 1)]
        self._negative = [self._terms.mkTerm(cvc5.Kind.NOT, x) for x in self._positive]
        self._assumed: dict[cvc5.Term, int] = {}
        for clause in cnf.clauses:
            literals = [self._literal(x) for x in dict.fromkeys(clause)]
            whole = literals[0] if len(literals) == 1 else self._terms.mkTerm(cvc5.Kind.OR, *literals)
            self._solver.assertFormula(whole)

    def _literal(self, x: int) -> cvc5.Term:
        return self._positive[x] if x > 0 else self._negative[-x]

    def ask(self, *literals: int) -> Answer:
        """Whether the clauses can hold together with the literals."""
        self._assumed = {self._literal(x): x for x in literals}
        found = self._solver.checkSatAssuming(*self._assumed)
        if found.isUnsat():
            return Answer.UNSAT
        return Answer.SAT if found.isSat() else Answer.UNKNOWN

    def core(self) -> Iterable[int]:
        """Of the literals of a question that was answered UNSAT, some together with which the clauses cannot hold."""
        return [self._assumed[x] for x in self._solver.getUnsatAssumptions()]
