"""The digest of all that some values say: equal digests, equal values.

Values are plain data: texts, numbers, sequences, mappings in their order, sets, and data classes.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from operator import attrgetter


def digest(*values: object) -> str:
    """SHA-256 of the values; TypeError for what is no plain data."""
    told = _Told()
    told.tell(values)
    return hashlib.sha256("".join(told.parts).encode("utf-8", "surrogatepass")).hexdigest()


class _Told:
    """Values as one text that can be read in one way only."""

    def __init__(self) -> None:
        self.parts: list[str] = []
        self._fields: dict[type, Callable[[object], tuple[object, ...]]] = {}

    def tell(self, values: Iterable[object]) -> None:
        """Values one after the other, each with its kind and size."""
        parts = self.parts
        for x in values:
            if type(x) is str:
                parts.append(f"s{len(x)}:{x}")
            else:
                self._other(x)

    def _other(self, x: object) -> None:
        kind = type(x)
        values = self._fields.get(kind)
        if values is not None:
            self.parts.append(f"<{kind.__name__};")
            self.tell(values(x))
        elif isinstance(x, str):
            self.tell((str(x),))
        elif isinstance(x, Sequence):
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
        elif isinstance(x, (set, frozenset)):
            self.parts.append("/")
            self._other(sorted(x))
        elif is_dataclass(x):
            self._fields[kind] = _getter([f.name for f in fields(x)])
            self._other(x)
        else:
            raise TypeError(f"no plain data: {kind.__name__}")


def _getter(names: Sequence[str]) -> Callable[[object], tuple[object, ...]]:
    get = attrgetter(*names)
    return get if len(names) > 1 else lambda x: (get(x),)
