"""Facts and goals as clauses over numbers, as `interlock verify` numbers them again from the written system.

Leaves are numbered in the order in which they first appear.  A part of a clause that is no literal gets a number of its
own, parts of it first, and clauses that say what it means, before the first clause in which it stands.  A clause has a
number, too: the next one.

**Theorem.**  The clauses of a number of its own make it equivalent to the part for which it stands, and say nothing of
anything else: so a clause over numbers follows from such clauses exactly if its expression follows from theirs.
(Definitional clauses: Tseitin, 1968.)
"""

from __future__ import annotations

from collections.abc import Callable

from interlock.logic.expr import AND, EQ, FALSE, NOT, OR, TRUE, Expr

Clause = tuple[int, ...]


class Numbering:
    """Numbers of leaves, and of the conjunctions and disjunctions over them."""

    def __init__(self, define: Callable[[Clause], object]) -> None:
        """`define`: takes each clause that says what a new number means."""
        self.define = define
        self._leaves: dict[str, int] = {}
        self._nodes: dict[tuple[int, Clause], int] = {}
        self.count = 0

    def clause(self, x: Expr) -> Clause:
        """The literals one of which must be true."""
        if x is FALSE:
            return ()
        parts = x.args if x.op is OR else (x,)
        for p in parts:
            self._meet(p)
        return tuple(dict.fromkeys([self._literal(p) for p in parts]))

    def _fresh(self) -> int:
        self.count += 1
        return self.count

    def _meet(self, x: Expr) -> None:
        """Number the leaves in their order."""
        for a in x.args:
            self._meet(a)
        if x.name and _leaf(x) not in self._leaves:
            self._leaves[_leaf(x)] = self._fresh()

    def _literal(self, x: Expr) -> int:
        if x.op is NOT:
            return -self._literal(x.args[0])
        if x.name:
            return self._leaves[_leaf(x)]
        sign = -1 if x.op is AND or x is TRUE else 1  # TRUE is a conjunction of nothing
        args = tuple([sign * self._literal(a) for a in x.args])
        known = self._nodes.get((sign, args))
        if known is None:
            known = self._nodes[sign, args] = self._fresh()
            self.define((-sign * known, *args))
            for a in args:
                self.define((sign * known, -a))
        return known


def _leaf(x: Expr) -> str:
    return f"{x.name}={x.value}" if x.op is EQ else x.name
