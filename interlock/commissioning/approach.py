"""Places in the approach of a signal, beyond the section before it, as a tester brings a train there (R8).

A train in such a place counts only while the way from there is locked for it: the routes that lock it are set first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from interlock.dataclass import dataclass
from interlock.model.elements import SectionId
from interlock.model.places import Approach
from interlock.table.cells import RouteKind, TraversalKey
from interlock.table.rows import InterlockingTable, RouteRow

FEW_WAYS = 4
"""Choices of routes that lock the way from one place, after which no further one is tried (our choice)."""


@dataclass(frozen=True)
class Place:
    """Where a train may be that comes to a signal; None: where nobody would see it.  `ways`: what has to be locked for
    it, from the signal on back."""

    section: SectionId | None
    ways: tuple[TraversalKey, ...]


def further(coming: Approach, blind: frozenset[SectionId]) -> list[Place]:
    """The places beyond the section before the signal, each once, over every way by which it is reached.  `blind`:
    sections without detection."""
    if coming.section is None or coming.unseen or coming.section in blind:
        return []
    return list(dict.fromkeys(_places(coming, (), blind)))


def _places(x: Approach, ways: tuple[TraversalKey, ...], blind: frozenset[SectionId]) -> Iterator[Place]:
    for n, y in x.further:
        assert x.section is not None
        over = (*ways, (x.section, n))
        if y.section is None or y.unseen or y.section in blind:
            yield Place(None, over)
        if y.section is not None and y.section not in blind:
            yield Place(y.section, over)
            yield from _places(y, over, blind)


def settings(table: InterlockingTable, row: RouteRow, ways: Sequence[TraversalKey]) -> Iterator[tuple[RouteRow, ...]]:
    """Routes that together lock some ways on towards the signal of a route and are not hostile to it, the last one
    first; several choices, few of them."""
    return islice(_settings(table, row, tuple(ways)), FEW_WAYS)


def _settings(
    table: InterlockingTable, row: RouteRow, ways: tuple[TraversalKey, ...]
) -> Iterator[tuple[RouteRow, ...]]:
    if not ways:
        yield ()
        return
    for r in table.routes:
        if r.kind in (RouteKind.CALL_ON, RouteKind.IDENTIFIER) or r.path.onward is not None:
            continue
        locked = r.path.locked[::-1]
        common = min(len(locked), len(ways))
        if common and locked[:common] == ways[:common] and r.id not in row.locking.hostile.routes and r.id != row.id:
            yield from ((r, *others) for others in _settings(table, row, ways[common:]))
