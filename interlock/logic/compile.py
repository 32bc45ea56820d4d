"""Expressions as Python code, for simulation at speed.

The names are ours alone (v0, v1, ...), so that nothing from a layout reaches the code as text.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from interlock.logic.expr import AND, EQ, NOT, OR, TRUE, VAR, Expr, walk
from interlock.logic.names import Name

Values = Mapping[str, int]


def compile_exprs(roots: Mapping[Name, Expr] | Mapping[str, Expr]) -> Callable[[Values], dict[str, bool]]:
    """A function from values of variables to values of the named roots."""
    lines: list[str] = []
    name_of: dict[int, str] = {}
    keys: list[str] = []
    index: dict[str, int] = {}

    def key(name: str) -> int:
        if name not in index:
            index[name] = len(keys)
            keys.append(name)
        return index[name]

    for i, node in enumerate(walk(roots.values())):
        v = name_of[id(node)] = f"v{i}"
        args = [name_of[id(a)] for a in node.args]
        if node.op is VAR:
            right = f"bool(x[k[{key(node.name)}]])"
        elif node.op is EQ:
            right = f"x[k[{key(node.name)}]] == {node.value}"
        elif node.op is NOT:
            right = f"not {args[0]}"
        elif node.op is AND:
            right = " and ".join(args)
        elif node.op is OR:
            right = " or ".join(args)
        else:
            right = str(node is TRUE)
        lines.append(f"    {v} = {right}")
    result = ", ".join(name_of[id(e)] for e in roots.values())
    source = "def run(x, k):\n" + "\n".join(lines) + f"\n    return ({result}{',' if roots else ''})\n"
    space: dict[str, Callable[[Values, list[str]], tuple[bool, ...]]] = {}
    exec(compile(source, "<expressions>", "exec"), space)
    run, names = space["run"], tuple(roots)
    return lambda values: dict(zip(names, run(values, keys), strict=True))
