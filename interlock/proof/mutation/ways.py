"""Weakenings of the table: routes that lock other ways than theirs, or not all of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable, RouteKind, RouteRow

Mutant = tuple[str, Controller]


def other_direction(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route locks one of its sections for the opposite direction."""
    back = {(t.section, t.exit, t.entry): t.key for t in table.locks}
    for r in table.routes:
        for i, key in enumerate(r.traversals):
            t = table.lock[key]
            other = back.get((t.section, t.entry, t.exit))
            if other is None or (t.section, t.entry) == (t.section, t.exit):
                continue
            turned = replace(r, traversals=(*r.traversals[:i], other, *r.traversals[i + 1 :]))
            routes = tuple(turned if x is r else x for x in table.routes)
            yield f"{r.id} in {t.section}", lower(layout, replace(table, routes=routes))


def shorter(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    for r in table.routes:
        if len(r.traversals) > 1 and r.berth is None:
            less: RouteRow = replace(
                r,
                traversals=r.traversals[:-1],
                sections=r.sections[:-1],
                release=r.release[:-1],
                points=tuple(p for p in r.points if p.section != r.traversals[-1][0]),
            )
            yield (
                f"{r.id} without {r.traversals[-1][0]}",
                lower(layout, replace(table, routes=tuple(less if x is r else x for x in table.routes))),
            )


def past_the_board(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A shunt route locks a way beyond the limit-of-shunt board at which it ends, as far as trains have one there."""
    for r in table.routes:
        board = next((g for g in layout.boards if g == r.exit), None)
        if board is None or r.kind is not RouteKind.SHUNT:
            continue
        g = layout.signal[board]
        for t in table.locks:
            if t.section == layout.section_of(g.into) and t.entry == g.node:
                longer = replace(r, traversals=(*r.traversals, t.key))
                routes = tuple(longer if x is r else x for x in table.routes)
                yield f"{r.id} into {t.section}", lower(layout, replace(table, routes=routes))


def nothing_beyond(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route that leads past a signal ends at it for the controller, and is shown as if it led on."""
    for r in table.routes:
        if r.onward is not None:
            less = replace(r, onward=None)
            yield r.id, lower(layout, replace(table, routes=tuple(less if x is r else x for x in table.routes)))


def overlap_shorter(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """The last section of an overlap is left out."""
    for r in table.routes:
        if r.overlap is None:
            continue
        cell = replace(r.overlap, ways=r.overlap.ways[:-1])
        kept = {s for s, _ in (*r.traversals, *cell.ways)}
        points = tuple(p for p in r.points if p.section in kept)
        less = replace(r, overlap=cell if cell.ways else None, points=points)
        same = [x for x in table.routes if x.overlap is not None and x.overlap.ways == r.overlap.ways and x is not r]
        if not same:
            yield r.id, lower(layout, replace(table, routes=tuple(less if x is r else x for x in table.routes)))


def overlap_inside(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route holds the short overlap inside its own, at the speed for which its own is made."""
    for r in table.routes:
        for x in table.routes:
            own, other = r.overlap, x.overlap
            if own is None or other is None or (x.traversals, x.kind) != (r.traversals, r.kind):
                continue
            if len(other.ways) < len(own.ways) and own.ways[: len(other.ways)] == other.ways:
                less = replace(r, overlap=other, points=x.points)
                routes = tuple(less if y is r else y for y in table.routes)
                yield f"{r.id} with {other.option}", lower(layout, replace(table, routes=routes))
