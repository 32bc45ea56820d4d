"""Patterns: steps in which a mutant was once seen to fail, tried on every mutant before a solver is asked.

As test patterns are found by fault simulation: a pattern is a state and the inputs of a step that the invariants and
assumptions allow.  A mutant that breaks a claim in one of them has failed, whatever invariants it keeps: those were
facts of that state.  All patterns are computed at once, one bit for each, and of a mutant only what it changes.

**Theorem.**  A state and inputs that satisfy the facts and break a claim in that step are a model of its denial: the
claim does not follow from these facts.  That no pattern breaks it shows nothing.  (Fault simulation with random and
deterministic patterns: Abramovici, Breuer and Friedman, *Digital Systems Testing and Testable Design*, 1990.)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from heapq import heappop, heappush

from interlock.logic.expr import AND, FALSE, NOT, OR, TRUE, VAR, Expr
from interlock.logic.names import Name

SOME = 8  # so many new patterns are gathered before all are computed again


class Patterns:
    """The steps, and the value of every expression of a system in each of them."""

    def __init__(
        self, definitions: Mapping[Name, Expr], facts: Iterable[Expr], wanted: Iterable[tuple[str, Expr]]
    ) -> None:
        """`facts`: invariants and assumptions.  `wanted`: claims by name, the more telling first."""
        self._number: dict[Expr, int] = {}
        self._nodes: list[Expr] = []
        self._args: list[tuple[int, ...]] = []
        self._readers: list[list[int]] = []
        self._definitions = definitions
        self._name: dict[str, int] = {}
        """The nodes of names that are defined, each after what defines it."""
        for name, x in definitions.items():
            at = self._enter(x)
            self._name[name] = self._add(Expr(VAR, (), name), (at,))
        self._facts = {self._enter(x) for x in facts}
        self._wanted: dict[int, tuple[int, str]] = {}
        for n, (what, x) in enumerate(wanted):
            self._wanted.setdefault(self._enter(x), (n, what))
        self._given: list[Mapping[str, bool]] = []
        self._waiting = 0
        self._vectors: list[int] = []
        self._full = self._allowed = 0

    def _add(self, x: Expr, args: tuple[int, ...]) -> int:
        at = len(self._nodes)
        self._nodes.append(x)
        self._args.append(args)
        self._readers.append([])
        for a in args:
            self._readers[a].append(at)
        return at

    def _enter(self, x: Expr) -> int:
        """The node of an expression, after all that it reads."""
        stack = [x]
        while stack:
            node = stack[-1]
            if self._at(node) is not None:
                stack.pop()
                continue
            waiting = [a for a in node.args if self._at(a) is None]
            if waiting:
                stack += reversed(waiting)
                continue
            stack.pop()
            args = tuple(at for a in node.args if (at := self._at(a)) is not None)
            self._number[node] = self._add(node, args)
        found = self._at(x)
        assert found is not None
        return found

    def _at(self, x: Expr) -> int | None:
        if x.op is VAR and x.name in self._definitions:
            return self._name[x.name]
        return self._number.get(x)

    @property
    def leaves(self) -> list[Expr]:
        """What a pattern gives the values of: state and inputs."""
        return [x for x in self._number if not x.args and x is not TRUE and x is not FALSE]

    def add(self, values: Mapping[str, bool]) -> None:
        """A step: the values of the leaves, by their text."""
        self._given.append(values)
        self._waiting += 1
        if self._waiting >= min(SOME, len(self._given)):
            self._compute()

    def _compute(self) -> None:
        self._waiting = 0
        self._full = (1 << len(self._given)) - 1
        v: list[int] = []
        for x, args in zip(self._nodes, self._args, strict=True):
            v.append(self._value(x, args, v) if args else self._leaf(x))
        self._vectors, self._allowed = v, self._full
        for at in self._facts:
            self._allowed &= v[at]

    def _leaf(self, x: Expr) -> int:
        if x is TRUE or x is FALSE:
            return self._full if x is TRUE else 0
        name = str(x)
        return sum(1 << n for n, given in enumerate(self._given) if given.get(name))

    def _value(self, x: Expr, args: tuple[int, ...], v: list[int]) -> int:
        if x.op is AND:
            out = self._full
            for a in args:
                out &= v[a]
            return out
        if x.op is OR:
            out = 0
            for a in args:
                out |= v[a]
            return out
        return self._full ^ v[args[0]] if x.op is NOT else v[args[0]]

    def broken(self, changed: Mapping[Name, Expr]) -> str | None:
        """What fails in one of the steps when some names stand for other expressions."""
        v = list(self._vectors)
        if not v:
            return None
        new = {self._name[n]: x for n, x in changed.items()}
        heap = sorted(new)
        seen, differ = set(heap), set()
        memo: dict[Expr, int] = {}
        while heap:
            at = heappop(heap)
            x = new.get(at)
            value = self._value(self._nodes[at], self._args[at], v) if x is None else self._fresh(x, v, memo)
            if value != v[at]:
                v[at] = value
                differ.add(at)
                for r in self._readers[at]:
                    if r not in seen:
                        seen.add(r)
                        heappush(heap, r)
        allowed = self._allowed
        for at in self._facts & differ:
            allowed &= v[at]
        failed = [self._wanted[at] for at in differ & self._wanted.keys() if allowed & ~v[at]]
        return min(failed)[1] if failed else None

    def _fresh(self, x: Expr, v: list[int], memo: dict[Expr, int]) -> int:
        """An expression that is in no system, over names that come before it."""
        found = memo.get(x)
        if found is None:
            at = None if x.args else self._at(x)
            if x.args:
                parts = [self._fresh(a, v, memo) for a in x.args]
                found = self._value(x, tuple(range(len(parts))), parts)
            else:
                found = self._leaf(x) if at is None else v[at]
            memo[x] = found
        return found
