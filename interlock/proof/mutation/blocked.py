"""Weakenings of what is blocked: points that move for a route although somebody works there (R10)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic import names
from interlock.logic.expr import FALSE, Substitution
from interlock.logic.lower import lower
from interlock.logic.naming import Family
from interlock.model.layout import Layout
from interlock.proof.mutation.points import with_values
from interlock.proof.mutation.ways import Mutant
from interlock.table.rows import InterlockingTable


def point_moves(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A machine may be demanded, driven along or swung over, although a section of it is blocked."""
    yield from _unseen(layout, table, names.POINT_AVAILABLE, names.DEMANDED, names.SWINGS_TO)


def drive_runs(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """The drive of a point runs on when a section of it is blocked."""
    yield from _unseen(layout, table, names.KEPT_OFF)


def _unseen(layout: Layout, table: InterlockingTable, *families: Family) -> Iterator[Mutant]:
    """Each equation of some families as if no section were blocked."""
    c = lower(layout, table)
    put = Substitution(dict.fromkeys(c.symbols.sections.blocked.values(), FALSE))
    for later, e in ((later, e) for later, those in ((False, c.equations), (True, c.next)) for e in those):
        if e.name.family in families:
            free = put(e.expr)
            if free is not e.expr:
                yield e.name, with_values(c, later, {e.name: free})
