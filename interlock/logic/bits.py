"""Expressions over bit vectors: one bit for each of many runs, so that all runs take a step at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from interlock.logic.expr import Expr, Op, walk


def compile_bits(roots: Mapping[str, Expr]) -> Callable[[Mapping[str, int], int], dict[str, int]]:
    """A function from vectors of variables and the vector of all runs to vectors of the named roots.

    A comparison `n = k` is read as a variable of the name `n=k`.
    """
    lines: list[str] = []
    name_of: dict[int, str] = {}
    keys: dict[str, int] = {}
    for i, node in enumerate(walk(roots.values())):
        v = name_of[id(node)] = f"v{i}"
        args = [name_of[id(a)] for a in node.args]
        if node.op in (Op.VAR, Op.EQ):
            name = node.name if node.op is Op.VAR else f"{node.name}={node.value}"
            right = f"x[k[{keys.setdefault(name, len(keys))}]]"
        elif node.op is Op.NOT:
            right = f"m ^ {args[0]}"
        elif node.op is Op.AND:
            right = " & ".join(args)
        elif node.op is Op.OR:
            right = " | ".join(args)
        else:
            right = "m" if node.op is Op.TRUE else "0"
        lines.append(f"    {v} = {right}")
    result = ", ".join(name_of[id(e)] for e in roots.values())
    source = "def run(x, k, m):\n" + "\n".join(lines) + f"\n    return ({result}{',' if roots else ''})\n"
    space: dict[str, Callable[[Mapping[str, int], list[str], int], tuple[int, ...]]] = {}
    exec(compile(source, "<expressions>", "exec"), space)
    run, names, reads = space["run"], tuple(roots), list(keys)
    return lambda values, mask: dict(zip(names, run(values, reads, mask), strict=True))
