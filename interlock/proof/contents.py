"""The digest of all that some values say: equal digests, equal values.

Values are plain data: texts, numbers, sequences, mappings in their order, sets, data classes, and expressions, which
may share parts.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, is_dataclass

from interlock.logic.expr import Expr

_OPS = "FTv=!&|"  # one letter for each operator, by number


def digest(*values: object) -> str:
    """SHA-256 of the values; TypeError for what is no plain data."""
    told = _Told()
    told.tell(values)
    return hashlib.sha256("".join(told.parts).encode("utf-8", "surrogatepass")).hexdigest()


class _Told:
    """Values as one text that can be read in one way only."""

    def __init__(self) -> None:
        self.parts: list[str] = []
        self._nodes: dict[Expr, str] = {}
        self._fields: dict[type, Callable[[object], tuple[object, ...]]] = {}

    def tell(self, values: Iterable[object]) -> None:
        """Values one after the other, each with its kind and size."""
        parts, nodes = self.parts, self._nodes
        for x in values:
            kind = type(x)
            if kind is str:
                parts.append(f"s{len(x)}:{x}")  # type: ignore[arg-type]
            elif kind is Expr:
                parts.append(nodes.get(x) or self._node(x))  # type: ignore[arg-type, call-overload]
            else:
                self._other(x)

    def _other(self, x: object) -> None:
        kind = type(x)
        values = self._fields.get(kind)
        if values is not None:
            self.parts.append(f"<{kind.__name__};")
            self.tell(values(x))
        elif isinstance(x, (tuple, list)):
            self.parts.append(f"({len(x)};")
            self.tell(x)
        elif x is None or kind is bool or kind is float:
            self.parts.append(f"{x!r};")
        elif isinstance(x, int):
            self.parts.append(f"{int(x)};")
        elif isinstance(x, Mapping):
            self.parts.append(f"{{{len(x)};")
            self.tell(x)
            self.tell(x.values())
        elif isinstance(x, str):
            self.tell((str(x),))
        elif isinstance(x, (set, frozenset)):
            self.parts.append("/")
            self._other(sorted(x))
        elif is_dataclass(x):
            names = [f.name for f in fields(x)]
            self._fields[kind] = lambda x: tuple([getattr(x, name) for name in names])
            self._other(x)
        else:
            raise TypeError(f"no plain data: {kind.__name__}")

    def _node(self, x: Expr) -> str:
        """An expression by its number, after a line for each part that is new."""
        nodes = self._nodes
        args = "".join([nodes.get(a) or self._node(a) for a in x.args])
        if x.name:
            self.parts.append(f"{_OPS[x.op]}{x.value},{len(x.name)}:{x.name};")
        else:
            self.parts.append(f"{_OPS[x.op]}{args};")
        told = nodes[x] = f"e{len(nodes)};"
        return told
