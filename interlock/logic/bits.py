"""Expressions over bit vectors: one bit for each of many runs, so that all runs take a step at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from interlock.logic.expr import Expr, Op, walk

_READ, _TRUE, _FALSE, _NOT, _AND, _OR = range(6)
_KIND = {Op.VAR: _READ, Op.EQ: _READ, Op.TRUE: _TRUE, Op.FALSE: _FALSE, Op.NOT: _NOT, Op.AND: _AND, Op.OR: _OR}


def compile_bits(roots: Mapping[str, Expr]) -> Callable[[Mapping[str, int], int], dict[str, int]]:
    """A function from vectors of variables and the vector of all runs to vectors of the named roots.

    A comparison `n = k` is read as a variable of the name `n=k`.  The nodes are computed one after the other (as Python
    code they would take longer to compile than they take to run), and a node's place is given on after its last use, so
    that few vectors are kept at a time.
    """
    nodes = list(walk(roots.values()))
    last = {id(a): at for at, node in enumerate(nodes) for a in node.args}
    kept = {id(x) for x in roots.values()}
    place: dict[int, int] = {}
    free: list[int] = []
    size = 0
    code: list[tuple[int, int, tuple[int, ...]]] = []
    reads: list[str] = []
    for at, node in enumerate(nodes):
        kind = _KIND[node.op]
        args: tuple[int, ...] = tuple([place[id(a)] for a in node.args])
        if kind == _READ:
            args = (len(reads),)
            reads.append(node.name if node.op is Op.VAR else f"{node.name}={node.value}")
        for a in node.args:
            if last[id(a)] == at and id(a) not in kept:
                free.append(place[id(a)])
        if free:
            to = free.pop()
        else:
            to, size = size, size + 1
        place[id(node)] = to
        code.append((kind, to, args))
    wanted = [(name, place[id(x)]) for name, x in roots.items()]

    def run(values: Mapping[str, int], mask: int) -> dict[str, int]:
        v = [0] * size
        for kind, to, args in code:
            if kind == _AND:
                x = mask
                for a in args:
                    x &= v[a]
                    if not x:
                        break
            elif kind == _OR:
                x = 0
                for a in args:
                    x |= v[a]
            elif kind == _READ:
                x = values[reads[args[0]]]
            elif kind == _NOT:
                x = mask ^ v[args[0]]
            else:
                x = mask if kind == _TRUE else 0
            v[to] = x
        return {name: mask if v[at] == mask else v[at] for name, at in wanted}

    return run
