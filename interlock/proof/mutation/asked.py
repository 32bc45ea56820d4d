"""Weakenings of what a request comes to whose signal has closed (R14)."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic import names
from interlock.logic.expr import conj, disj, var
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.mutation.points import with_values
from interlock.proof.mutation.ways import Mutant
from interlock.table.rows import InterlockingTable


def call_on_again(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A signal that has called a train on opens when it is asked for again."""
    c = lower(layout, table)
    for r in c.symbols.routes:
        if r.call_on:
            old = next(e for e in c.next if e.name == r.want)
            asked = conj((c.symbols.requests.asked(r.number), var(r.locked)))
            wanted = disj((old.terms[0].expr, asked))
            yield r.id, with_values(c, True, {old.name: conj((wanted, *(t.expr for t in old.terms[1:])))})


def request_kept(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """What is asked for while a condition is lost opens the signal when it returns."""
    c = lower(layout, table)
    for r in (r for r in c.symbols.routes if not r.call_on):
        old = next(e for e in c.equations if e.name == names.CONDITION_LOST(r.number))
        yield r.id, with_values(c, False, {old.name: conj((var(r.proceed), *(t.expr for t in old.terms[1:])))})
