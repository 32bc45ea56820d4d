"""How long a train holds a resource without a break, whatever path it takes; and which spans touch each other.

A span is a set of operations that follow each other and hold the same resource.  Between two trains one span comes
wholly before the other one: nobody gets in between.  Where a train goes from one span to the next at once, or holds
both together, and so does another train with the same two resources, the order is the same on both: otherwise they
would have to change places.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from interlock.dataclass import dataclass
from interlock.planning.problem import Operation


@dataclass(frozen=True)
class Span:
    """Operations of a train, by index in order, that hold a resource; `release`: of each of them, units."""

    train: int
    operations: tuple[int, ...]
    releases: tuple[int, ...]
    resource: str


def spans(train: int, operations: Sequence[Operation], live: Sequence[int]) -> list[Span]:
    """All of a train, over the operations that are possible."""
    open_ = set(live)
    by: dict[str, dict[int, int]] = {}
    for k in live:
        for u in operations[k].uses:
            mine = by.setdefault(u.resource, {})
            mine[k] = max(mine.get(k, 0), u.release)
    return [
        Span(train, part, tuple(releases[k] for k in part), name)
        for name, releases in by.items()
        for part in _parts(operations, open_, releases)
    ]


def _parts(operations: Sequence[Operation], live: set[int], releases: Mapping[int, int]) -> list[tuple[int, ...]]:
    """Connected sets of operations; each operation for itself where a path leaves such a set and comes back."""
    mark: dict[int, int] = {k: k for k in releases}

    def root(k: int) -> int:
        while mark[k] != k:
            k = mark[k]
        return k

    for k in releases:
        for p in operations[k].following:
            if p in mark:
                mark[max(root(k), root(p))] = min(root(k), root(p))
    sets: dict[int, list[int]] = {}
    for k in sorted(releases):
        sets.setdefault(root(k), []).append(k)
    found: list[tuple[int, ...]] = []
    for part in sets.values():
        if len(part) > 1 and apart(operations, live, frozenset(part), frozenset(part)):
            found += [(k,) for k in part]
        else:
            found.append(tuple(part))
    return found


def apart(operations: Sequence[Operation], live: set[int], a: frozenset[int], b: frozenset[int]) -> bool:
    """Whether some path goes from `a` to `b` over operations that are in neither."""
    last, both = max(b), a | b
    todo = [p for k in a for p in operations[k].following if p in live and p not in both and p < last]
    seen = set(todo)
    while todo:
        for p in operations[todo.pop()].following:
            if p in b:
                return True
            if p in live and p < last and p not in both and p not in seen:
                seen.add(p)
                todo.append(p)
    return False


def touching(
    operations: Sequence[Operation], live: set[int], found: Sequence[Span], check: Callable[[], None] = lambda: None
) -> list[list[int]]:
    """By span: those that the train holds at the same time or right after it, on every path over both.

    check: called again and again; what it raises ends the work."""
    at: dict[int, list[int]] = {}
    for n, s in enumerate(found):
        for k in s.operations:
            at.setdefault(k, []).append(n)
    near: list[list[int]] = [[] for _ in found]
    for n, s in enumerate(found):
        check()
        others: set[int] = set()
        for k in s.operations:
            for q in (k, *(p for p in operations[k].following if p in live)):
                others.update(at.get(q, ()))
        a = frozenset(s.operations)
        for m in sorted(others - {n} - set(near[n])):
            b = frozenset(found[m].operations)
            if not apart(operations, live, a, b) and not apart(operations, live, b, a):
                near[n].append(m)
                near[m].append(n)
    return near
