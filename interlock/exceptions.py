"""Exceptions that say more than a message, whole in another process."""

from __future__ import annotations

from typing import Any


class Ended(RuntimeError):
    """A process has ended before its work was done: what it was to find is not known."""


class Whole(Exception):
    """An exception that is made of other values than its message: what pickles it, as every pool of processes does,
    makes it again from message and fields, without its `__init__`."""

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (type(self), self.args), self.__dict__


def _again(kind: type[Whole], args: tuple[object, ...]) -> Whole:
    return kind.__new__(kind, *args)
