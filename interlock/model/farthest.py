"""How far something runs at most that passes one way after another, over any number of ways."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TypeVar

Key = TypeVar("Key")


def farthest(metres: Mapping[Key, Fraction], after: Mapping[Key, Sequence[Key]]) -> Fraction:
    """The longest sum of metres over ways of which each leads to the next.  Ways that lead round to one another count
    once each, all of them: no run over them that passes none twice is longer."""
    sums: dict[Key, Fraction] = {}
    for ring in _rings(after):
        on = (sums[x] for k in ring for x in after[k] if x not in ring)
        sums |= dict.fromkeys(ring, sum((metres[k] for k in ring), Fraction(0)) + max(on, default=Fraction(0)))
    return max(sums.values(), default=Fraction(0))


def _rings(after: Mapping[Key, Sequence[Key]]) -> Iterator[frozenset[Key]]:
    """All ways, those that lead round to one another together, each after what it leads to (R. Tarjan, 1972).

    With a list of what is begun, not with calls: a line is longer than calls may be deep.
    """
    number: dict[Key, int] = {}
    low: dict[Key, int] = {}
    open_: list[Key] = []
    done: set[Key] = set()
    for first in after:
        begun = [] if first in number else [(first, iter(after[first]))]
        while begun:
            k, rest = begun[-1]
            if k not in number:
                number[k] = low[k] = len(number)
                open_.append(k)
            new = None
            for x in rest:
                if x not in number:
                    new = x
                    break
                if x not in done:
                    low[k] = min(low[k], number[x])
            if new is not None:
                begun.append((new, iter(after[new])))
                continue
            begun.pop()
            if begun:
                back = begun[-1][0]
                low[back] = min(low[back], low[k])
            if low[k] == number[k]:
                at = open_.index(k)
                ring = frozenset(open_[at:])
                del open_[at:]
                done |= ring
                yield ring
