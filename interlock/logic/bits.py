"""Expressions over bit vectors: one bit for each of many runs, so that all runs take a step at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from operator import itemgetter

from interlock.logic.expr import VAR, Expr, Op

_READ, _TRUE, _FALSE, _NOT, _AND, _OR = range(6)
_KIND = {Op.VAR: _READ, Op.EQ: _READ, Op.TRUE: _TRUE, Op.FALSE: _FALSE, Op.NOT: _NOT, Op.AND: _AND, Op.OR: _OR}


class Bits:
    """Computes vectors of named expressions from vectors of the variables that they read.

    A step changes little of a railway, also for a thousand runs: of the nodes of a yard's expressions an eighth has
    something new to read.  The first call computes all of them, a later one those that read something that has
    changed.  Most of a railway is the same in all runs: a vector that is the very mask is not combined bit by bit.
    """

    def __init__(self, roots: Mapping[str, Expr], meaning: Mapping[str, Expr] | None = None) -> None:
        """`meaning`: names that stand for expressions; no name reads itself."""
        wires = meaning or {}
        number: dict[Expr, int] = {}
        self._code: list[tuple[int, Sequence[int]]] = []
        self._readers: list[list[int]] = []
        reads: dict[str, int] = {}

        def enter(node: Expr, args: Sequence[int]) -> int:
            at = number[node] = len(self._code)
            kind = _KIND[node.op]
            if kind == _READ:
                reads[node.name if node.op is VAR else f"{node.name}={node.value}"] = at
            for a in args:
                self._readers[a].append(at)
            self._readers.append([])
            self._code.append((kind, args))
            return at

        for root in roots.values():
            stack = [_meant(root, wires)]
            while stack:  # each node after those that it reads
                node = stack[-1]
                if node in number:
                    stack.pop()
                    continue
                args: list[int] = []
                for a in node.args:
                    x = _meant(a, wires) if a.op is VAR else a
                    at = number.get(x)
                    if at is not None:
                        args.append(at)
                    elif x.args:
                        stack.append(x)
                    else:
                        args.append(enter(x, ()))
                if len(args) == len(node.args):
                    stack.pop()
                    enter(node, args)
        self._names: dict[int, list[str]] = {}
        """The roots' names, by node."""
        for name, x in roots.items():
            self._names.setdefault(number[_meant(x, wires)], []).append(name)
        self._found: dict[str, int] = {}
        self.changed: dict[str, int] = {}
        """Those of the roots' vectors that the last call changed: all of them when it was the first."""
        self._reads = [*reads.values()]
        """The nodes of variables; a comparison `n = k` is read as a variable of the name `n=k`."""
        self._read: Callable[[Mapping[str, int]], tuple[int, ...]] = _getter([*reads])
        self._given: tuple[int, ...] = ()
        self._vectors: list[int] = []
        self._mask = -1

    def forget(self) -> None:
        """The next call is a first one."""
        self._mask = -1

    def __call__(self, values: Mapping[str, int], mask: int) -> Mapping[str, int]:
        """The roots' vectors, until the next call; `mask`: the vector of all runs."""
        due = bytearray(len(self._code))
        before, self._given = self._given, self._read(values)
        if mask != self._mask:
            self._mask, self._vectors = mask, [-1] * len(self._code)
            due = bytearray(b"\1") * len(self._code)
            before = (-1,) * len(self._reads)
            for at in self._reads:
                due[at] = 0
        v, code, readers, names = self._vectors, self._code, self._readers, self._names
        self.changed = changed = {}
        for at, x in [(at, x) for at, x, y in zip(self._reads, self._given, before, strict=True) if x is not y]:
            if x != v[at]:
                v[at] = x = x if x != mask else mask
                for r in readers[at]:
                    due[r] = 1
                if at in names:
                    changed.update(dict.fromkeys(names[at], x))
        at = due.find(1)
        while at >= 0:
            kind, args = code[at]
            if kind == _AND:
                x = mask
                for a in args:
                    y = v[a]
                    if y is not mask:
                        x = y if x is mask else x & y
                        if not x:
                            break
            elif kind == _OR:
                x = 0
                for a in args:
                    y = v[a]
                    if y:
                        x = x | y if x else y
                        if x is mask:
                            break
            elif kind == _NOT:
                y = v[args[0]]
                x = 0 if y is mask else mask ^ y if y else mask
            else:
                x = mask if kind == _TRUE else 0
            if x != v[at]:
                v[at] = x = x if x != mask else mask
                for r in readers[at]:
                    due[r] = 1
                if at in names:
                    changed.update(dict.fromkeys(names[at], x))
            at = due.find(1, at + 1)
        self._found.update(changed)
        return self._found


def _getter(names: Sequence[str]) -> Callable[[Mapping[str, int]], tuple[int, ...]]:
    """What a mapping has for names."""
    if len(names) > 1:
        return itemgetter(*names)
    return lambda values: tuple([values[n] for n in names])


def _meant(x: Expr, meaning: Mapping[str, Expr]) -> Expr:
    """What a name stands for in the end."""
    while x.op is VAR and x.name in meaning:
        x = meaning[x.name]
    return x
