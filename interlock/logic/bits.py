"""Expressions over bit vectors: one bit for each of many runs, so that all runs take a step at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from operator import itemgetter

from interlock.logic.expr import VAR, Expr, Op
from interlock.logic.names import Name

_READ, _TRUE, _FALSE, _NOT, _AND, _OR = range(6)
_KIND = {Op.VAR: _READ, Op.EQ: _READ, Op.TRUE: _TRUE, Op.FALSE: _FALSE, Op.NOT: _NOT, Op.AND: _AND, Op.OR: _OR}


class Bits:
    """Computes vectors of named expressions from vectors of the variables that they read.

    A step changes little of a railway, also for a thousand runs: of the nodes of a yard's expressions an eighth has
    something new to read.  The first call computes all of them, a later one those that read something that has
    changed.  Most of a railway is the same in all runs: a vector that is the very mask is not combined bit by bit.

    What is computed may come in stages: what a later stage reads may depend on what an earlier one has computed.
    """

    def __init__(self, *stages: Mapping[Name, Expr], meaning: Mapping[Name, Expr] | None = None) -> None:
        """`stages`: the roots of each; one name means one expression.  `meaning`: names that stand for expressions; no
        name reads itself."""
        wires = meaning or {}
        number: dict[Expr, int] = {}
        self._kinds = kinds = bytearray()
        self._args: list[tuple[int, ...]] = []
        readers: list[list[int]] = []
        reads: dict[str, int] = {}

        def enter(node: Expr, args: tuple[int, ...]) -> int:
            at = number[node] = len(kinds)
            kind = _KIND[node.op]
            if kind == _READ:
                reads[node.name if node.op is VAR else f"{node.name}={node.value}"] = at
            for a in args:
                readers[a].append(at)
            readers.append([])
            kinds.append(kind)
            self._args.append(args)
            return at

        self._ends: list[int] = []
        """The number of nodes of each stage and those before it."""
        self._read: list[Callable[[Mapping[str, int]], tuple[int, ...]]] = []
        """What is read by each stage and those before it; a comparison `n = k` is a variable of the name `n=k`."""
        for roots in stages:
            for root in roots.values():
                _each_after_what_it_reads(_meant(root, wires), wires, number, enter)
            self._ends.append(len(kinds))
            self._read.append(_getter([*reads]))
        self._names: dict[int, dict[str, None]] = {}
        """The roots' names, by node."""
        for roots in stages:
            for name, x in roots.items():
                self._names.setdefault(number[_meant(x, wires)], {})[name] = None
        self._readers: list[tuple[int, ...]] = [tuple(some) for some in readers]
        self._reads = [*reads.values()]
        """The nodes of variables."""
        self._found: dict[str, int] = {}
        self.changed: dict[str, int] = {}
        """Those of the roots' vectors that have changed since the first stage began: all of them when it was the first
        call."""
        self._given: list[int] = []
        self._vectors: list[int] = []
        self._due = bytearray()
        self._mask = -1

    def forget(self) -> None:
        """The next call is a first one."""
        self._mask = -1

    def __call__(self, values: Mapping[str, int], mask: int, stage: int = 0) -> Mapping[str, int]:
        """The roots' vectors, until the next call; `mask`: the vector of all runs.

        Each step calls all stages in their order.
        """
        given = self._read[stage](values)
        if mask != self._mask:
            self._mask, self._vectors = mask, [-1] * len(self._kinds)
            self._given = [-1] * len(self._reads)
            self._due = bytearray(b"\1") * len(self._kinds)
            for at in self._reads:
                self._due[at] = 0
        if not stage:
            self.changed = {}
        due, end = self._due, self._ends[stage]
        new = {at: x for at, x, y in zip(self._reads, given, self._given, strict=False) if x is not y}
        self._given[: len(given)] = given
        for at in new:
            due[at] = 1
        v, kinds, args_of, readers, names = self._vectors, self._kinds, self._args, self._readers, self._names
        changed = self.changed
        at = due.find(1, 0, end)
        while at >= 0:
            due[at] = 0
            kind = kinds[at]
            if kind == _AND:
                x = mask
                for a in args_of[at]:
                    y = v[a]
                    if y is not mask:
                        x = y if x is mask else x & y
                        if not x:
                            break
            elif kind == _OR:
                x = 0
                for a in args_of[at]:
                    y = v[a]
                    if y:
                        x = x | y if x else y
                        if x is mask:
                            break
            elif kind == _NOT:
                y = v[args_of[at][0]]
                x = 0 if y is mask else mask ^ y if y else mask
            elif kind == _READ:
                x = new[at]
            else:
                x = mask if kind == _TRUE else 0
            if x != v[at]:
                v[at] = x = x if x != mask else mask
                for r in readers[at]:
                    due[r] = 1
                if at in names:
                    changed.update(dict.fromkeys(names[at], x))
            at = due.find(1, at + 1, end)
        self._found.update(changed)
        return self._found


def _each_after_what_it_reads(
    root: Expr, meaning: Mapping[Name, Expr], number: Mapping[Expr, int], enter: Callable[[Expr, tuple[int, ...]], int]
) -> None:
    """Enter the nodes below a root that have no number yet."""
    stack = [root]
    while stack:
        node = stack[-1]
        if node in number:
            stack.pop()
            continue
        args: list[int] = []
        for a in node.args:
            x = _meant(a, meaning) if a.op is VAR else a
            at = number.get(x)
            if at is not None:
                args.append(at)
            elif x.args:
                stack.append(x)
            else:
                args.append(enter(x, ()))
        if len(args) == len(node.args):
            stack.pop()
            enter(node, tuple(args))


def _getter(names: Sequence[str]) -> Callable[[Mapping[str, int]], tuple[int, ...]]:
    """What a mapping has for names."""
    if len(names) > 1:
        return itemgetter(*names)
    return lambda values: tuple([values[n] for n in names])


def _meant(x: Expr, meaning: Mapping[Name, Expr]) -> Expr:
    """What a name stands for in the end."""
    while x.op is VAR and x.name in meaning:
        x = meaning[x.name]
    return x
