"""How far something runs at most that passes one way after another, over any number of ways."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction
from graphlib import CycleError, TopologicalSorter
from typing import TypeVar

Key = TypeVar("Key")


def farthest(metres: Mapping[Key, Fraction], after: Mapping[Key, Sequence[Key]]) -> Fraction:
    """The longest sum of metres over ways of which each leads to the next.  Ways that lead round to one another count
    once each, all of them: no run over them that passes none twice is longer."""
    sums: dict[Key, Fraction] = {}
    for ring in _last_first(after):
        on = (sums[x] for k in ring for x in after[k] if x not in ring)
        sums |= dict.fromkeys(ring, sum((metres[k] for k in ring), Fraction(0)) + max(on, default=Fraction(0)))
    return max(sums.values(), default=Fraction(0))


def _last_first(after: Mapping[Key, Sequence[Key]]) -> Iterable[Collection[Key]]:
    """All ways, those that lead round to one another together, each after what it leads to."""
    try:
        return [(k,) for k in TopologicalSorter(after).static_order()]
    except CycleError:
        import networkx as nx  # few layouts have rings without a main signal

        rings = nx.condensation(nx.DiGraph(after))
        return [rings.nodes[n]["members"] for n in reversed(list(nx.topological_sort(rings)))]
