"""Sets of small numbers, as the bits of one number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator


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
