"""Facts and questions as clauses that say of each part of an expression only what somebody asks of it.

A node that is only ever used as true needs no clause that makes it true, and the other way round (Plaisted and
Greenbaum, 1986): fewer clauses, and shorter chains for the solver.  What can hold together is the same as with
definitions in both directions; the value of a node in a model means nothing, so that searches for a run use `Cnf`.

**Theorem.**  A node that is used in one polarity only needs its definition in one direction: the clauses can be
satisfied exactly if the requirements can, and so UNSAT means the same as with definitions in both directions.
(Plaisted and Greenbaum, 1986.)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from interlock.logic.expr import AND, EQ, FALSE, NOT, OR, TRUE, VAR, Expr, neg
from interlock.logic.names import Name
from interlock.proof.engines.tseitin import Cnf

_FORTH, _BACK = 1, 2  # the literal implies the node; the node implies the literal


class OneSided(Cnf):
    """Clauses over names that have a meaning."""

    def __init__(self, meaning: Mapping[Name, Expr]) -> None:
        """`meaning`: what names stand for; no name reads itself."""
        super().__init__()
        self._meaning = meaning
        self._number: dict[Expr, int] = {}
        self._said: dict[Expr, int] = {}
        self._plain: dict[Expr, int] = {}  # literals of which there is nothing to say

    def require(self, x: Expr, given: tuple[int, ...] = ()) -> None:
        """Add the expression as a fact; `given`: literals of which one may hold instead."""
        if x.op is AND:
            for a in x.args:
                self.require(a, given)
            return
        parts: Sequence[Expr] = (x,)
        if x.op is OR:
            parts = x.args
        elif x.op is NOT and x.args[0].op is AND:
            parts = [neg(a) for a in x.args[0].args]
        plain = self._plain
        literals = [plain.get(a, 0) for a in parts]
        if 0 not in literals:
            self.clauses.append((*literals, *given))
            return
        split = [a for a in parts if _all_of(a)]
        if len(split) != 1:
            said = [n or self._said_of(a) for n, a in zip(literals, parts, strict=True)]
            self.clauses.append((*said, *given))
            return
        rest = [*(self._said_of(a) for a in parts if a is not split[0]), *given]
        whole = split[0]
        if whole.op is AND:
            self.clauses.extend([(self._said_of(a), *rest) for a in whole.args])
        else:
            self.clauses.extend([(-self._said_of(a, _BACK), *rest) for a in whole.args[0].args])

    def denial(self, x: Expr) -> list[int]:
        """Literals that together imply that the expression is false: it follows if they cannot all be true.

        What is false or true as a whole is so part by part, so that most expressions need no node of their own: a node
        would be told by all that is said of its parts, in each question about something else.
        """
        found: dict[int, None] = {}
        stack = [(x, False)]
        while stack:
            y, wanted = stack.pop()
            while True:
                if y.op is NOT:
                    y, wanted = y.args[0], not wanted
                elif y.op is VAR and y.name in self._meaning:
                    y = self._meaning[y.name]
                else:
                    break
            if y.op is (AND if wanted else OR):
                stack.extend([(a, wanted) for a in y.args])
            else:
                n = self._said_of(y, _FORTH if wanted else _BACK)
                found[n if wanted else -n] = None
        return list(found)

    def _literal_of(self, x: Expr) -> int:
        """The number of a node, nothing said of it."""
        known = self._number.get(x)
        if known is not None:
            return known
        op = x.op
        if op is VAR:
            meaning = self._meaning.get(x.name)
            n = self._literal_of(meaning) if meaning is not None else self.fresh()
            self.names[x.name] = n
        elif op is NOT:
            n = -self._literal_of(x.args[0])
        elif op is EQ:
            n = self._value(x.name, x.value)
        elif x is TRUE or x is FALSE:
            n = self._true if x is TRUE else -self._true
        else:
            self.count += 1
            n = self.count
        self._number[x] = n
        return n

    def _said_of(self, root: Expr, sides: int = _FORTH) -> int:
        """The literal of an expression, with the clauses that say what it means."""
        leaf = root.args[0] if root.op is NOT else root
        if leaf.op is VAR and leaf.name not in self._meaning:
            n = self._number.get(leaf) or self._literal_of(leaf)
            self._plain[root] = n = n if leaf is root else -n
            return n
        said, clauses, meaning, number, plain = self._said, self.clauses, self._meaning, self._number, self._plain
        stack = [(root, sides)]
        while stack:
            whole, side = stack.pop()
            x = whole
            while True:
                if x.op is NOT:
                    x = x.args[0]
                    side = _FORTH + _BACK - side
                elif x.op is VAR and x.name in meaning:
                    x = meaning[x.name]
                else:
                    break
            if not x.args:
                plain[whole] = number.get(whole) or self._literal_of(whole)
                continue
            before = said.get(x, 0)
            side &= ~before
            if not side:
                continue
            said[x] = before | side
            n = number.get(x) or self._literal_of(x)
            args = []
            for a in x.args:
                literal = plain.get(a)
                if literal is None:
                    literal = number.get(a) or self._literal_of(a)
                    stack.append((a, side))
                args.append(literal)
            if x.op is AND:
                if side & _FORTH:
                    clauses.extend([(-n, a) for a in args])
                if side & _BACK:
                    clauses.append((n, *[-a for a in args]))
            else:
                if side & _FORTH:
                    clauses.append((-n, *args))
                if side & _BACK:
                    clauses.extend([(n, -a) for a in args])
        return self._literal_of(root)


def _all_of(x: Expr) -> bool:
    """Whether it says several things at once."""
    return x.op is AND or (x.op is NOT and x.args[0].op is OR)
