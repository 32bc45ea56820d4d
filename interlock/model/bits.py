"""Sets of small numbers, as the bits of one number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import compress
from typing import TypeVar

T = TypeVar("T")
_DIGITS = bytes.maketrans(b"01", b"\0\1")


def bits(numbers: Iterable[int]) -> int:
    """The set of some numbers."""
    found = 0
    for n in numbers:
        found |= 1 << n
    return found


def bits_of(x: int) -> Iterator[int]:
    """The numbers of a set, the lowest first."""
    while x:
        low = x & -x
        yield low.bit_length() - 1
        x ^= low


def chosen(x: int, among: Sequence[T]) -> Iterator[T]:
    """Those of some things whose number is in a set; quicker than number by number where the set is not small."""
    return compress(among, bin(x)[:1:-1].encode().translate(_DIGITS))
