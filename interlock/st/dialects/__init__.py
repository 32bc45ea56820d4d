"""The dialects, in the order in which they are listed; the module of each is loaded when it is first asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from interlock.st.dialects.dialect import Dialect

_NAMES = ("iec", "codesys", "twincat", "scl1500", "scl300", "awl", "plcopen", "ladder")


class _Dialects(Mapping[str, "Dialect"]):
    """Dialects by name."""

    def __getitem__(self, name: str) -> Dialect:
        if name not in _NAMES:
            raise KeyError(name)
        found: Dialect = import_module(f"interlock.st.dialects.{name}").DIALECT
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(_NAMES)

    def __len__(self) -> int:
        return len(_NAMES)


BY_NAME = _Dialects()
