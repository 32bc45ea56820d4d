"""Weakenings of overlaps that swing from one alternative to another (R4)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic import names
from interlock.logic.expr import TRUE, Substitution, conj
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.mutation.points import with_values
from interlock.proof.mutation.ways import Mutant
from interlock.table.rows import InterlockingTable


def swung_at_once(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A swung overlap counts as held before it lies."""
    c = lower(layout, table)
    for g in c.symbols.overlaps.swings:
        old = next(e for e in c.next if e.name == c.symbols.overlaps.firm[g])
        first = Substitution({names.OVERLAP_LIES(g): TRUE})(old.terms[0].expr)
        yield g, with_values(c, True, {old.name: conj((first, *(t.expr for t in old.terms[1:])))})


def swings_at_another_number(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """The number that is taken for a signal's overlap is the one after its own."""
    c = lower(layout, table)
    asked = c.symbols.requests.asked
    for g, number in c.symbols.overlaps.swing_request.items():
        for e in (e for e in c.equations if e.name.family is names.SWINGS_TO):
            terms = [asked(number + 1) if t.expr is asked(number) else t.expr for t in e.terms]
            if terms != [t.expr for t in e.terms]:
                yield f"{g}: {e.name}", with_values(c, False, {e.name: conj(terms)})
