"""Clauses in one solver, with a literal that switches each line on.

**Theorem.**  A switch that nobody assumes can be false, and then its clause holds: the line takes part in no answer.
What was learnt from it contains its switch, or that of its group, and is left off with it.  (Activation literals: Een
and Sorensson, 2003.)
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from pysat.solvers import Minisat22

from interlock.logic.expr import Expr, var
from interlock.logic.names import Name
from interlock.proof.engines.tseitin import Cnf

GROUP = 50


class Switched:
    """Lines that can be left off: clauses that were learnt stay."""

    def __init__(self) -> None:
        self.cnf = Cnf()
        self.solver = Minisat22()
        self._given = 0
        self._lines: dict[tuple[str, Expr], int] = {}
        self._asked: dict[tuple[Expr, ...], int] = {}
        self._again: set[int] = set()
        self._groups: dict[int, list[int]] = {}

    def define(self, name: Name, x: Expr) -> int:
        """The switch of: the name stands for the expression."""
        key = (name, x)
        found = self._lines.get(key)
        if found is None:
            a, b = self.cnf.literal(var(name)), self.cnf.literal(x)
            found = self._lines[key] = self.cnf.fresh()
            self.cnf.clauses += [(-found, -a, b), (-found, a, -b)]
        return found

    def fact(self, x: Expr) -> int:
        """The switch of: the expression is true."""
        found = self._lines.get(("", x))
        if found is None:
            lit = self.cnf.literal(x)
            found = self._lines["", x] = self.cnf.fresh()
            self.cnf.clauses.append((-found, lit))
        return found

    def any_false(self, xs: Iterable[Expr], again: bool = False) -> int:
        """The switch of: one of the expressions is false; `again`: it will be asked of many mutants."""
        key = tuple(xs)
        known = self._asked.get(key)
        if known is not None:
            return known
        lits = [-self.cnf.literal(x) for x in key]
        switch = self.cnf.fresh()
        self.cnf.clauses.append((-switch, *lits))
        if again:
            self._asked[key] = switch
            self._again.add(switch)
        return switch

    def group(self, switches: Sequence[int]) -> None:
        """Lines that are mostly on together get switches in common: the solver has fewer to decide."""
        for k in range(0, len(switches), GROUP):
            those = list(dict.fromkeys(switches[k : k + GROUP]))
            common = self.cnf.fresh()
            self.cnf.clauses += [(-common, x) for x in those]
            self._groups[common] = those

    def _grouped(self, switches: Iterable[int]) -> list[int]:
        """The same lines by as few switches as possible."""
        left = dict.fromkeys(switches)
        found = [common for common, those in self._groups.items() if all(x in left for x in those)]
        for common in found:
            for x in self._groups[common]:
                left.pop(x, None)
        return [*found, *left]

    def model(self, *switches: int) -> set[int] | None:
        """The literals of a model with the lines of these switches; None where there is none."""
        for c in self.cnf.clauses[self._given :]:
            self.solver.add_clause(list(c))
        self._given = len(self.cnf.clauses)
        if not self.solver.solve(assumptions=self._grouped(switches)):
            return None
        return set(self.solver.get_model() or ())

    def off(self, switch: int) -> None:
        """A question that is asked no more, unless it was one to be asked again."""
        if switch not in self._again:
            self.cnf.clauses.append((-switch,))
