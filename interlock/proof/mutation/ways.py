"""Weakenings of the table: routes that lock other ways than theirs, or not all of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.table.cells import RouteKind
from interlock.table.rows import InterlockingTable, RouteRow

Mutant = tuple[str, Controller]


def other_direction(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route locks one of its sections for the opposite direction."""
    back = {(t.section, t.exit, t.entry): t.key for t in table.locks}
    for r in table.routes:
        for i, key in enumerate(r.path.traversals):
            t = table.lock[key]
            other = back.get((t.section, t.entry, t.exit))
            if other is None or (t.section, t.entry) == (t.section, t.exit):
                continue
            turned = replace(
                r, path=replace(r.path, traversals=(*r.path.traversals[:i], other, *r.path.traversals[i + 1 :]))
            )
            routes = tuple(turned if x is r else x for x in table.routes)
            yield f"{r.id} in {t.section}", lower(layout, replace(table, routes=routes))


def shorter(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route without its last section, and without all that is locked and asked there."""
    for r in table.routes:
        if len(r.path.traversals) > 1 and r.path.berth is None:
            less: RouteRow = replace(
                r,
                path=replace(r.path, traversals=r.path.traversals[:-1]),
                locking=replace(
                    r.locking,
                    release=r.locking.release[:-1],
                    points=tuple(p for p in r.locking.points if p.section != r.path.traversals[-1][0]),
                ),
                clear=replace(r.clear, sections=r.clear.sections[:-1]),
            )
            yield (
                f"{r.id} without {r.path.traversals[-1][0]}",
                lower(layout, replace(table, routes=tuple(less if x is r else x for x in table.routes))),
            )


def past_the_board(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A shunt route locks a way beyond the limit-of-shunt board at which it ends, as far as trains have one there."""
    for r in table.routes:
        board = next((g for g in layout.signalling.boards if g == r.exit), None)
        if board is None or r.kind is not RouteKind.SHUNT:
            continue
        g = layout.signalling.signal[board]
        for t in table.locks:
            if t.section == layout.track.section_of(g.into) and t.entry == g.node:
                longer = replace(r, path=replace(r.path, traversals=(*r.path.traversals, t.key)))
                routes = tuple(longer if x is r else x for x in table.routes)
                yield f"{r.id} into {t.section}", lower(layout, replace(table, routes=routes))


def nothing_beyond(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route that leads past a signal ends at it for the controller, and is shown as if it led on."""
    for r in table.routes:
        if r.path.onward is not None:
            less = replace(r, path=replace(r.path, onward=None))
            yield r.id, lower(layout, replace(table, routes=tuple(less if x is r else x for x in table.routes)))


def overlap_shorter(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """The last section of an overlap is left out."""
    for r in table.routes:
        if r.locking.overlap is None:
            continue
        cell = replace(r.locking.overlap, ways=r.locking.overlap.ways[:-1])
        kept = {s for s, _ in (*r.path.traversals, *cell.ways)}
        points = tuple(p for p in r.locking.points if p.section in kept)
        less = replace(r, locking=replace(r.locking, overlap=cell if cell.ways else None, points=points))
        same = [
            x
            for x in table.routes
            if x.locking.overlap is not None and x.locking.overlap.ways == r.locking.overlap.ways and x is not r
        ]
        if not same:
            yield r.id, lower(layout, replace(table, routes=tuple(less if x is r else x for x in table.routes)))


def overlap_inside(layout: Layout, table: InterlockingTable) -> Iterator[Mutant]:
    """A route holds the short overlap inside its own, at the speed for which its own is made."""
    for r in table.routes:
        for x in table.routes:
            own, other = r.locking.overlap, x.locking.overlap
            if own is None or other is None or (x.path.traversals, x.kind) != (r.path.traversals, r.kind):
                continue
            if len(other.ways) < len(own.ways) and own.ways[: len(other.ways)] == other.ways:
                less = replace(r, locking=replace(r.locking, overlap=other, points=x.locking.points))
                routes = tuple(less if y is r else y for y in table.routes)
                yield f"{r.id} with {other.option}", lower(layout, replace(table, routes=routes))
