"""Boolean expressions, hash-consed: equal expressions are the same object.

Atoms are Boolean variables and comparisons of a small-range variable with a constant.  There are no
floats, no loops and no side effects; `And` and `Or` take any number of operands.

What is equal is found in a unique table.  `interning` gives a piece of work (a layout that is lowered and proved) a
table of its own, which ends with it, so that a process that proves one layout after the other does not grow.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from enum import IntEnum
from threading import RLock

from interlock.logic import names
from interlock.logic.names import NONE, Made, Name, spelled


class Op(IntEnum):
    """Kind of an expression node."""

    FALSE = 0
    TRUE = 1
    VAR = 2
    EQ = 3
    NOT = 4
    AND = 5
    OR = 6


AND, EQ, NOT, OR, VAR = Op.AND, Op.EQ, Op.NOT, Op.OR, Op.VAR  # an attribute of an enumeration is slow to find


class Expr:
    """One node.  Build with the functions of this module, never directly."""

    __slots__ = ("args", "name", "op", "value")

    def __init__(self, op: Op, args: tuple[Expr, ...] = (), name: Name = NONE, value: int = 0) -> None:
        self.op = op
        self.args = args
        self.name = name
        self.value = value

    def __repr__(self) -> str:
        return text(self)

    def __invert__(self) -> Expr:
        return neg(self)

    def __and__(self, other: Expr) -> Expr:
        return conj((self, other))

    def __or__(self, other: Expr) -> Expr:
        return disj((self, other))


FALSE = Expr(Op.FALSE)
TRUE = Expr(Op.TRUE)


class UniqueTable:
    """The nodes of one piece of work; equal expressions are one object, so that the operands themselves are the key."""

    __slots__ = ("ands", "below", "names", "negations", "ors", "values", "vars")

    def __init__(self) -> None:
        self.names: Made = {}
        self.vars: dict[Name, Expr] = {}
        self.values: dict[tuple[Name, int], Expr] = {}
        self.negations: dict[Expr, Expr] = {}
        self.ands: dict[tuple[Expr, ...], Expr] = {}
        self.ors: dict[tuple[Expr, ...], Expr] = {}
        self.below: dict[Expr, dict[Name, None]] = {}
        """The variables below nodes with many operands, which many expressions share."""

    def __len__(self) -> int:
        """The number of nodes."""
        return len(self.vars) + len(self.values) + len(self.negations) + len(self.ands) + len(self.ors)


# the table in use, and its parts: names of this module, since they are looked up for each node
_table: UniqueTable
_vars: dict[Name, Expr]
_values: dict[tuple[Name, int], Expr]
_negations: dict[Expr, Expr]
_ands: dict[tuple[Expr, ...], Expr]
_ors: dict[tuple[Expr, ...], Expr]
_below: dict[Expr, dict[Name, None]]


def _use(table: UniqueTable) -> None:
    global _table, _vars, _values, _negations, _ands, _ors, _below
    _table, _vars, _values, _negations = table, table.vars, table.values, table.negations
    _ands, _ors, _below = table.ands, table.ors, table.below
    names.use(table.names)


_use(UniqueTable())
_turn = RLock()


def current_table() -> UniqueTable:
    """The table with which nodes are made now."""
    return _table


@contextmanager
def interning(table: UniqueTable | None = None) -> Iterator[UniqueTable]:
    """Make nodes with a table, a new one if none is given, to the end of a `with` block.

    Threads take turns: another one that comes here waits for the end of the block.
    """
    with _turn:
        before = _table
        _use(UniqueTable() if table is None else table)
        try:
            yield _table
        finally:
            _use(before)


def var(name: Name) -> Expr:
    """A Boolean variable."""
    found = _vars.get(name)
    if found is None:
        name = spelled(name)
        found = _vars[name] = Expr(VAR, (), name)
    return found


def eq(name: Name, value: int) -> Expr:
    """Whether the small-range variable has the value."""
    found = _values.get((name, value))
    if found is None:
        name = spelled(name)
        found = _values[name, value] = Expr(EQ, (), name, value)
    return found


def neg(x: Expr) -> Expr:
    """NOT."""
    if x is TRUE:
        return FALSE
    if x is FALSE:
        return TRUE
    if x.op is NOT:
        return x.args[0]
    found = _negations.get(x)
    if found is None:
        found = _negations[x] = Expr(NOT, (x,))
    return found


def _nary(op: Op, known: dict[tuple[Expr, ...], Expr], unit: Expr, zero: Expr, args: tuple[Expr, ...]) -> Expr:
    found = known.get(args)  # the operands of a node as they are: most nodes are built many times
    if found is not None:
        return found
    flat: dict[Expr, None] = {}
    inverse = False
    for x in args:
        kind = x.op
        if kind is op:
            flat.update(dict.fromkeys(x.args))
            inverse = True
        elif kind > 1:  # no constant
            flat[x] = None
            if kind is NOT:
                inverse = True
        elif x is zero:
            return zero
    if inverse:
        for y in flat:
            if y.op is NOT and y.args[0] in flat:
                return zero
    if not flat:
        return unit
    if len(flat) == 1:
        return next(iter(flat))
    args = tuple(flat)
    found = known.get(args)
    if found is None:
        found = known[args] = Expr(op, args)
    return found


def conj(xs: Iterable[Expr]) -> Expr:
    """AND of any number of operands; TRUE when there is none."""
    return _nary(AND, _ands, TRUE, FALSE, tuple(xs))


def disj(xs: Iterable[Expr]) -> Expr:
    """OR of any number of operands; FALSE when there is none."""
    return _nary(OR, _ors, FALSE, TRUE, tuple(xs))


def implies(a: Expr, b: Expr) -> Expr:
    """NOT a OR b."""
    return disj((neg(a), b))


def iff(a: Expr, b: Expr) -> Expr:
    """Both or neither."""
    return conj((implies(a, b), implies(b, a)))


def at_most_one(xs: Iterable[Expr]) -> Expr:
    """No two of them: pair by pair for a few, by halves for many, so that the size stays n log n."""
    seen = list(xs)
    if len(seen) <= 6:
        return conj(neg(a & b) for i, a in enumerate(seen) for b in seen[i + 1 :])
    left, right = seen[: len(seen) // 2], seen[len(seen) // 2 :]
    return conj((at_most_one(left), at_most_one(right), neg(disj(left) & disj(right))))


def walk(roots: Iterable[Expr]) -> Iterator[Expr]:
    """Every node below the roots, operands first, each once; without recursion."""
    done: set[int] = set()
    for root in roots:
        stack: list[tuple[Expr, bool]] = [(root, False)]
        while stack:
            node, ready = stack.pop()
            if id(node) in done:
                continue
            if ready or not node.args:
                done.add(id(node))
                yield node
                continue
            stack.append((node, True))
            stack.extend((a, False) for a in node.args if id(a) not in done)


def rebuild(node: Expr, args: tuple[Expr, ...]) -> Expr:
    """A node of the same kind over other operands."""
    if node.op is NOT:
        return neg(args[0])
    if node.op is AND:
        return conj(args)
    if node.op is OR:
        return disj(args)
    return node


class Substitution:
    """Replaces variables by expressions; remembers what it did, so that many roots share the work."""

    def __init__(self, mapping: Mapping[Name, Expr]) -> None:
        self._mapping = mapping
        self._done: dict[Expr, Expr] = {}

    def __call__(self, root: Expr) -> Expr:
        done, mapping = self._done, self._mapping
        if root in done:
            return done[root]
        if not root.args:
            return mapping.get(root.name, root) if root.op is VAR else root
        new: list[Expr] = []
        stack = [(root, iter(root.args), new)]
        while stack:
            node, left, new = stack[-1]
            for a in left:
                x = done.get(a)
                if x is None:
                    if a.args:
                        stack.append((a, iter(a.args), []))
                        break
                    x = done[a] = mapping.get(a.name, a) if a.op is VAR else a
                new.append(x)
            else:
                stack.pop()
                done[node] = x = rebuild(node, tuple(new))
                if stack:
                    stack[-1][2].append(x)
        return done[root]


def parts_of(x: Expr) -> Sequence[Expr]:
    """The parts of an expression that says several things at once; none of any other."""
    if x.op is AND:
        return x.args
    if x.op is NOT and x.args[0].op is OR:
        return [neg(a) for a in x.args[0].args]
    return ()


WIDE = 12  # operands: from here on the variables below a node are remembered


def variables(roots: Iterable[Expr]) -> dict[Name, None]:
    """Names of all variables below the roots, in order of appearance."""
    found: dict[Name, None] = {}
    done: set[Expr] = set()
    for root in roots:
        _gather([root], found, done)
    return found


def _gather(stack: list[Expr], found: dict[Name, None], done: set[Expr]) -> None:
    while stack:
        node = stack.pop()
        args = node.args
        if args:
            if node not in done:
                done.add(node)
                if len(args) <= WIDE:
                    stack += args
                    continue
                known = _below.get(node)
                if known is None:
                    known = _below[node] = {}
                    _gather([*args], known, set())
                found.update(known)
        elif name := node.name:
            found[name] = None


def evaluate(root: Expr, value: Callable[[Name], int], memo: dict[int, bool]) -> bool:
    """The truth of an expression; `memo` may be shared between roots of one valuation."""
    if id(root) in memo:
        return memo[id(root)]
    for node in walk((root,)):
        if id(node) in memo:
            continue
        if node.op is VAR:
            memo[id(node)] = bool(value(node.name))
        elif node.op is EQ:
            memo[id(node)] = value(node.name) == node.value
        elif node.op is NOT:
            memo[id(node)] = not memo[id(node.args[0])]
        elif node.op is AND:
            memo[id(node)] = all(memo[id(a)] for a in node.args)
        elif node.op is OR:
            memo[id(node)] = any(memo[id(a)] for a in node.args)
        else:
            memo[id(node)] = node is TRUE
    return memo[id(root)]


def settled(x: Expr, known: Mapping[Name, bool]) -> bool | None:
    """The value that an expression has under values of some variables, whatever the others are: of Kleene's three the
    third is None."""
    op = x.op
    if op is VAR:
        return known.get(x.name)
    if op is NOT:
        value = settled(x.args[0], known)
        return None if value is None else not value
    if op is AND or op is OR:
        decides = op is OR
        found: bool | None = not decides
        for a in x.args:
            value = settled(a, known)
            if value is decides:
                return value
            if value is None:
                found = None
        return found
    return None if op is EQ else x is TRUE


Truth = Callable[[Mapping[str, int]], bool]
"""The truth of one expression under values of its variables."""


def truths(roots: Iterable[Expr]) -> list[Truth]:
    """As `evaluate`, made once for many valuations: each root as a function, what they share once.  An operand that
    decides is the last one looked at."""
    made: dict[Expr, Truth] = {}
    roots = list(roots)
    for node in walk(roots):
        made[node] = _truth(node, [made[a] for a in node.args])
    return [made[root] for root in roots]


def _truth(node: Expr, parts: list[Truth]) -> Truth:
    name, number = node.name, node.value
    if node.op is VAR:
        return lambda values: values[name] != 0
    if node.op is EQ:
        return lambda values: values[name] == number
    if node.op is NOT:
        (part,) = parts
        return lambda values: not part(values)
    if node.op in (AND, OR):
        decides = node.op is OR

        def joined(values: Mapping[str, int]) -> bool:
            for part in parts:
                if part(values) is decides:
                    return decides
            return not decides

        return joined
    return lambda values: node is TRUE


def leaf_text(x: Expr) -> str:
    """A variable or comparison as text."""
    return x.name if x.op is VAR else f"{x.name} = {x.value}"


def text(x: Expr, leaf: Callable[[Expr], str] = leaf_text) -> str:
    """A readable form, for messages and golden tests; `leaf` writes variables and comparisons."""
    if x is TRUE:
        return "TRUE"
    if x is FALSE:
        return "FALSE"
    if not x.args:
        return leaf(x)
    if x.op is NOT:
        return f"NOT {_inner(x.args[0], leaf)}"
    return (" AND " if x.op is AND else " OR ").join(_inner(a, leaf) for a in x.args)


def _inner(x: Expr, leaf: Callable[[Expr], str]) -> str:
    return f"({text(x, leaf)})" if x.op in (AND, OR, EQ) else text(x, leaf)
