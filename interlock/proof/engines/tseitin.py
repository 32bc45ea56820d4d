"""Expressions as clauses (Tseitin), with compact variable numbers.

Comparisons of a small-range variable become one variable each; two different values of the same variable
exclude each other.

**Theorem.**  A valuation of the variables extends to a model of the clauses exactly if it satisfies what is required,
and in every model the literal of a node has the value of its expression; so a model tells the value of every expression
that was entered, and that there is none tells that the requirements contradict each other.  (Tseitin, 1968.)
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.logic.expr import AND, EQ, FALSE, NOT, OR, TRUE, VAR, Expr


class Cnf:
    """Clauses over positive variable numbers; `literal` adds an expression and returns its literal."""

    def __init__(self, values: bool = True) -> None:
        """`values`: say that a small-range variable has no two values at once."""
        self._exclusive = values
        self.clauses: list[tuple[int, ...]] = []
        self.count = 0
        self.names: dict[str, int] = {}
        self._of: dict[int, tuple[Expr, int]] = {}
        self._values: dict[str, dict[int, int]] = {}
        self._some: dict[str, int] = {}
        self._true = self.fresh()
        self.clauses.append((self._true,))

    def fresh(self) -> int:
        """A new variable number."""
        self.count += 1
        return self.count

    def literal(self, root: Expr) -> int:
        """The literal that is equivalent to the expression."""
        of = self._of
        known = of.get(id(root))
        if known is not None:
            return known[1]
        clauses = self.clauses
        stack = [root]
        while stack:
            node = stack[-1]
            if id(node) in of:
                stack.pop()
                continue
            op = node.op
            if op is VAR:
                lit = self.names.get(node.name, 0) or self._named(node.name)
            elif op is EQ:
                lit = self._value(node.name, node.value)
            elif node is TRUE:
                lit = self._true
            elif node is FALSE:
                lit = -self._true
            else:
                waiting = [a for a in node.args if id(a) not in of]
                if waiting:
                    stack.extend(reversed(waiting))
                    continue
                if op is NOT:
                    lit = -of[id(node.args[0])][1]
                else:
                    sign = 1 if op is AND else -1
                    self.count += 1
                    lit = self.count
                    args = [sign * of[id(a)][1] for a in node.args]
                    clauses.extend([(-lit, a) for a in args])
                    clauses.append((lit, *[-a for a in args]))
                    lit *= sign
            of[id(node)] = (node, lit)
            stack.pop()
        return of[id(root)][1]

    def known(self, x: Expr) -> bool:
        """Whether some clause may speak of the expression."""
        return id(x) in self._of

    def define(self, name: str, x: Expr) -> None:
        """From now on the name stands for the expression; before it is used anywhere."""
        self.names[name] = self.literal(x)

    def _named(self, name: str) -> int:
        n = self.names[name] = self.fresh()
        return n

    def _value(self, name: str, value: int) -> int:
        values = self._values.setdefault(name, {})
        if value not in values:
            new = self.fresh()
            if self._exclusive:
                self._exclude(name, new)
            values[value] = new
        return values[value]

    def _exclude(self, name: str, new: int) -> None:
        """The new value excludes all before it: by a chain of "one of these", so that the clauses stay few."""
        before = self._some.get(name)
        if before is not None:
            self.clauses.append((-new, -before))
        some = self.fresh()
        self.clauses.extend([(-new, some), *([(-before, some)] if before is not None else [])])
        self._some[name] = some

    def value_literals(self) -> list[int]:
        """The literals of all comparisons of small-range variables with values other than 0."""
        return [n for values in self._values.values() for v, n in values.items() if v]

    def require(self, x: Expr) -> None:
        """Add the expression as a fact."""
        if x.op is AND:
            for a in x.args:
                self.require(a)
        elif x.op is OR:
            self.clauses.append(tuple(self.literal(a) for a in x.args))
        else:
            self.clauses.append((self.literal(x),))

    def dimacs(self) -> str:
        """The clauses as DIMACS text."""
        body = "\n".join(" ".join(map(str, c)) + " 0" for c in self.clauses)
        return f"p cnf {self.count} {len(self.clauses)}\n{body}\n"

    def read(self, model: Mapping[int, bool]) -> dict[str, int]:
        """Values of the named variables under a model of variable numbers."""
        out = {name: int(model.get(abs(n), False) == (n > 0)) for name, n in self.names.items()}
        for name, values in self._values.items():
            out[name] = next((v for v, n in values.items() if model.get(n, False)), 0)
        return out
