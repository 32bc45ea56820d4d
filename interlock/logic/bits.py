"""Expressions over bit vectors: one bit for each of many runs, so that all runs take a step at once."""

from __future__ import annotations

from collections.abc import Mapping

from interlock.logic.expr import AND, EQ, NOT, OR, VAR, Expr, Op
from interlock.logic.names import Name

_TRUE, _AND, _OR = int(Op.TRUE), int(AND), int(OR)


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
        self._kinds = bytearray()
        self._args: list[tuple[int, ...]] = []
        """What each node reads: nodes by number, and denied ones by the complement of theirs."""
        self._denied = bytearray()
        """Whether anybody reads a node denied."""
        self._readers: list[list[int]] = []
        self._reads: dict[str, int] = {}
        """The nodes of variables; a comparison `n = k` is a variable of the name `n=k`."""
        self._ends: list[int] = []
        """The number of nodes of each stage and those before it."""
        self._names: dict[int, list[str]] = {}
        """The roots' names, by number."""
        number: dict[Expr, int] = {}
        for roots in stages:
            for name, x in roots.items():
                self._number(x, meaning or {}, number)
                self._names.setdefault(number[x], []).append(name)
            self._ends.append(len(self._kinds))
        self.found: dict[str, int] = {}
        self.changed: dict[str, int] = {}
        """Those of the roots' vectors that have changed since the first stage began: all of them when it was the first
        call."""
        self._given: dict[int, int] = {}
        self._vectors: list[int] = []
        self._due = bytearray()
        self._mask = -1

    def _number(self, root: Expr, meaning: Mapping[Name, Expr], number: dict[Expr, int]) -> None:
        """Number what is below a root and has no number yet, each node after what it reads; a name has the number of
        its meaning, and what is denied the complement."""
        kinds, args_of, readers = self._kinds, self._args, self._readers
        stack = [root]
        while stack:
            x = stack[-1]
            if x in number:
                stack.pop()
                continue
            op, reads = x.op, x.args
            if op is VAR and x.name in meaning:
                reads = (meaning[x.name],)
            args: list[int] = []
            for a in reads:
                at = number.get(a)
                if at is None:
                    stack.append(a)
                else:
                    args.append(at)
            if len(args) < len(reads):
                continue
            stack.pop()
            if op is NOT:
                at = number[x] = ~args[0]
                self._denied[max(at, ~at)] = 1
                continue
            if op is VAR and reads:
                number[x] = args[0]
                continue
            at = number[x] = len(kinds)
            if op is VAR or op is EQ:
                self._reads[x.name if op is VAR else f"{x.name}={x.value}"] = at
            for n in args:
                readers[n if n >= 0 else ~n].append(at)
            readers.append([])
            kinds.append(op)
            args_of.append(tuple(args))
            self._denied.append(0)

    def forget(self) -> None:
        """The next call is a first one."""
        self._mask = -1

    def __call__(self, values: Mapping[str, int], mask: int, stage: int = 0) -> Mapping[str, int]:
        """The roots' vectors, until the next call; `mask`: the vector of all runs; `values`: those that are read, of
        which any that is as in the call before may be left out.

        Each step calls all stages in their order.
        """
        if mask != self._mask:
            self._mask, self._given = mask, {}
            self._vectors, self._due = [-1] * 2 * len(self._kinds), bytearray(b"\1") * len(self._kinds)
        if not stage:
            self.changed = {}
        due, end, given, reads = self._due, self._ends[stage], self._given, self._reads
        for name, x in values.items():
            at = reads.get(name, -1)
            if at >= 0 and given.get(at) is not x:
                given[at] = x
                due[at] = 1
        v, kinds, args_of, readers, names = self._vectors, self._kinds, self._args, self._readers, self._names
        changed, denied = self.changed, self._denied
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
            elif kind > _TRUE:
                x = given[at]
            else:
                x = mask if kind else 0
            if x != v[at]:
                v[at] = x = x if x != mask else mask
                for r in readers[at]:
                    due[r] = 1
                if at in names:
                    for name in names[at]:
                        changed[name] = x
                if denied[at]:
                    v[~at] = x = mask if not x else mask ^ x if x is not mask else 0
                    for name in names.get(~at, ()):
                        changed[name] = x
            at = due.find(1, at + 1, end)
        self.found.update(changed)
        return self.found
