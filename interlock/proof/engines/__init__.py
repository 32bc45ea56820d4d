"""SAT engines behind one question: can the clauses hold together with some literals?

MiniSat answers the many small questions of the induction, and searches; Z3 answers the former on request
(`--engine z3`), and cvc5 is a second opinion of other makers still (`--engine cvc5`, extra `recheck`).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from interlock.proof.engines.answer import Answer
from interlock.proof.engines.tseitin import Cnf

ENGINES = ("minisat", "z3", "cvc5")


class Sat(Protocol):
    """One solver over the clauses of a `Cnf`; queries are assumed literals."""

    def ask(self, *literals: int) -> Answer:
        """Whether the clauses can hold together with the literals."""
        ...

    def core(self) -> Iterable[int]:
        """Of the literals of a question that was answered UNSAT, some together with which the clauses cannot hold."""
        ...


def solver(engine: str, cnf: Cnf, timeout_ms: int) -> Sat:
    """A solver of the named engine; each is loaded only when it is used.  ValueError for another name."""
    if engine not in ENGINES:
        raise ValueError(f"there is no engine {engine}: {', '.join(ENGINES)}")
    if engine == "z3":
        from interlock.proof.engines.z3_sat import Z3Sat

        return Z3Sat(cnf, timeout_ms)
    if engine == "cvc5":
        from interlock.proof.engines.cvc5_sat import Cvc5Sat

        return Cvc5Sat(cnf, timeout_ms)
    from interlock.proof.engines.minisat import MiniSat

    return MiniSat(cnf)


__all__ = ["ENGINES", "Answer", "Sat", "solver"]
