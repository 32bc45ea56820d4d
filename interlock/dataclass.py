"""Dataclasses as the standard library's, of which most is made when it is first used.

The standard library compiles up to six functions for each class: in Python 3.11 nearly a millisecond, and for the
classes of one command a quarter of the time that it takes on a small layout.  Here `__init__` alone is compiled at
once.  What compares, hashes, orders and prints is the standard library's too, compiled when an instance is first asked
for it.  What is made is a dataclass: `fields`, `replace`, `asdict`, pickling and matching work as ever, and type
checkers see the original.
"""

from __future__ import annotations

import dataclasses
from sys import _getframe
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
else:

    def dataclass(cls=None, /, *, eq=True, order=False, unsafe_hash=False, frozen=False, repr=True, **options):
        """As `dataclasses.dataclass`; only the `__init__` of a frozen one sets its fields."""

        def make(cls):
            own = vars(cls)
            hashes = own.get("__hash__") is not None or ("__hash__" in own and "__eq__" not in own)
            made = dataclasses.dataclass(repr=False, eq=False, **options)(cls)
            later = [*["__repr__"] * repr, *["__eq__"] * eq, *["__lt__", "__le__", "__gt__", "__ge__"] * order]
            methods = {name: _when_first_used(made, name) for name in later}
            if frozen:
                methods |= {"__setattr__": _frozen(made), "__delattr__": _never_deleted}
            for name, method in methods.items():
                if name not in own:
                    setattr(made, name, method)
            if not hashes and (unsafe_hash or (eq and frozen)):
                made.__hash__ = _when_first_used(made, "__hash__")
            elif not hashes and eq:
                made.__hash__ = None
            return made

        return make if cls is None else make(cls)


def _when_first_used(made: Any, name: str) -> Any:
    """A method that puts the standard library's in its own place, which reads the same fields."""

    def method(self: Any, *arguments: Any) -> Any:
        shows, orders = name == "__repr__", name[2:4] in ("lt", "le", "gt", "ge")
        alike = {
            f.name: dataclasses.field(compare=f.compare, hash=f.hash, repr=f.repr) for f in dataclasses.fields(made)
        }
        theirs = type(made.__name__, (), {"__doc__": name, "__annotations__": dict.fromkeys(alike, Any), **alike})
        dataclasses.dataclass(
            init=False, repr=shows, eq=not shows, order=orders, unsafe_hash=name == "__hash__", match_args=False
        )(theirs)
        setattr(made, name, vars(theirs)[name])
        return getattr(made, name)(self, *arguments)

    return method


def _frozen(made: Any) -> Any:
    """What lets `__init__` alone set a field; of a class with slots, whoever sets it first, as unpickling does."""
    init, has_slots = made.__init__.__code__, not made.__dictoffset__

    def __setattr__(self: Any, name: str, value: Any) -> None:
        if hasattr(self, name) if has_slots else _getframe(1).f_code is not init:
            raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")
        object.__setattr__(self, name, value)

    return __setattr__


def _never_deleted(self: Any, name: str) -> None:
    raise dataclasses.FrozenInstanceError(f"cannot delete field {name!r}")
