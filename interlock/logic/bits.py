"""Expressions over bit vectors: one bit for each of many runs, so that all runs take a step at once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from interlock.logic.expr import VAR, Expr, Op

_READ, _TRUE, _FALSE, _NOT, _AND, _OR = range(6)
_KIND = {Op.VAR: _READ, Op.EQ: _READ, Op.TRUE: _TRUE, Op.FALSE: _FALSE, Op.NOT: _NOT, Op.AND: _AND, Op.OR: _OR}


def compile_bits(
    roots: Mapping[str, Expr], meaning: Mapping[str, Expr] | None = None
) -> Callable[[Mapping[str, int], int], dict[str, int]]:
    """A function from vectors of variables and the vector of all runs to vectors of the named roots.

    `meaning`: names that stand for expressions; no name reads itself.  A comparison `n = k` is read as a variable of
    the name `n=k`.  The nodes are computed one after the other (as Python code they would take longer to compile than
    they take to run), and a node's place is given on after its last use, so that few vectors are kept at a time.  Most
    of a railway is the same in all runs: a vector that is the very mask is not combined bit by bit.
    """
    wires = meaning or {}
    nodes, last = _in_order(roots.values(), wires)
    kept = {_meant(x, wires) for x in roots.values()}
    place: dict[Expr, int] = {}
    free: list[int] = []
    size = 0
    code: list[tuple[int, int, tuple[int, ...]]] = []
    reads: list[str] = []
    for at, (node, inner) in enumerate(nodes):
        kind = _KIND[node.op]
        args: tuple[int, ...] = tuple([place[a] for a in inner])
        if kind == _READ:
            args = (len(reads),)
            reads.append(node.name if node.op is VAR else f"{node.name}={node.value}")
        for a in inner:
            if last[a] == at and a not in kept:
                free.append(place[a])
                last[a] = -1
        if free:
            to = free.pop()
        else:
            to, size = size, size + 1
        place[node] = to
        code.append((kind, to, args))
    wanted = [(name, place[_meant(x, wires)]) for name, x in roots.items()]

    def run(values: Mapping[str, int], mask: int) -> dict[str, int]:
        v = [0] * size
        for kind, to, args in code:
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
            elif kind == _READ:
                x = values[reads[args[0]]]
            elif kind == _NOT:
                y = v[args[0]]
                x = 0 if y is mask else mask ^ y if y else mask
            else:
                x = mask if kind == _TRUE else 0
            v[to] = x
        return {name: mask if v[at] == mask else v[at] for name, at in wanted}

    return run


def _meant(x: Expr, meaning: Mapping[str, Expr]) -> Expr:
    """What a name stands for in the end."""
    while x.op is VAR and x.name in meaning:
        x = meaning[x.name]
    return x


def _in_order(
    roots: Iterable[Expr], meaning: Mapping[str, Expr]
) -> tuple[list[tuple[Expr, Sequence[Expr]]], dict[Expr, int]]:
    """Every node once with those that it reads, each after these, and by which node it is read last."""
    nodes: list[tuple[Expr, Sequence[Expr]]] = []
    last: dict[Expr, int] = {}
    seen: set[Expr] = set()
    for root in roots:
        stack: list[tuple[Expr, Sequence[Expr] | None]] = [(_meant(root, meaning), None)]
        while stack:
            node, inner = stack.pop()
            if inner is not None:
                last.update(dict.fromkeys(inner, len(nodes)))
                nodes.append((node, inner))
            elif node not in seen:
                seen.add(node)
                inner = [_meant(a, meaning) if a.op is VAR else a for a in node.args]
                stack.append((node, inner))
                stack.extend([(a, None) for a in reversed(inner) if a not in seen])
    return nodes, last
