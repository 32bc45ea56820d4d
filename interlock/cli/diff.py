"""`interlock diff`: what has changed in the interlocking table between two layouts."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from typing import Any

import click

from interlock.app.diff import Differences, diff
from interlock.cli.common import FINDINGS, OK, format_option, number_of, put_json, show
from interlock.diag import render
from interlock.table.changes import Change, RouteChange, TableChanges
from interlock.table.columns import COLUMNS
from interlock.table.rows import RouteRow


@click.command("diff")
@click.argument("old")
@click.argument("new")
@format_option
def command(old: str, new: str, form: str) -> None:
    """Print what has changed in the interlocking table from one layout to another, or to its next version.

    Channels that the files of pins beside them give otherwise are told, too.  Exit code 0: nothing, but for titles,
    labels, places on the plan and the author's reasons; 1: something, or one of the layouts has errors.
    """
    found = diff(old, new)
    if form == "json":
        put_json(_body(found))
    elif found.table is None:
        for one in (found.old, found.new):
            show(() if one.ok else one.diagnostics, one.source.texts, form)
    else:
        lines = _lines(found.table, found) if form == "full" else _each(found.table, found)
        for line in lines:
            click.echo(line)
        if _shown(found) and (besides := (*found.elsewhere, *found.printed)):
            click.echo(f"besides, the layouts differ in {', '.join(besides)}")
        click.echo(f"{old} -> {new}: {_summary(found.table, found)}")
    sys.exit(OK if found.same else FINDINGS)


def _shown(found: Differences) -> bool:
    """Whether something of table, elements, principles or channels differs."""
    return found.table is not None and not (
        found.table.none and not found.elements and not found.principles and not found.channels
    )


def _summary(t: TableChanges, found: Differences) -> str:
    renamed, changed = sum(c.route != c.was for c in t.routes), sum(bool(c.cells) for c in t.routes)
    said = {"removed": len(t.removed), "added": len(t.added), "called otherwise": renamed, "changed": changed}
    parts = [f"{number_of(n, 'route')} {what}" for what, n in said.items() if n]
    others = len(t.voyages) + len(t.automatic)
    parts += [number_of(others, "change") + " of voyages and automatic working"] if others else []
    if not parts and (found.elements or found.principles or found.channels):
        return "no cell of the table differs"
    if found.elsewhere and not _shown(found):
        facts = ", ".join((*found.elsewhere, *found.printed))
        return f"table, elements and principles are equal, but the layouts are not: they differ in {facts}"
    if found.printed and not _shown(found):
        return f"nothing differs but what is only printed: {', '.join(found.printed)}"
    return ", ".join(parts) or "nothing differs"


def _told(r: RouteRow) -> str:
    hostile = len(r.locking.hostile)
    over, beyond = ", ".join(s for s, _ in r.path.traversals), r.locking.overlap
    overlap = "" if beyond is None else f", overlap {', '.join(s for s, _ in beyond.ways)}"
    return f"{r.kind}, over {over}{overlap}, hostile to {number_of(hostile, 'route')}"


def _lines(t: TableChanges, found: Differences) -> Iterator[str]:
    """Routes of which the very same differs are told together."""
    yield from (c.text for c in (*found.principles, *found.elements, *found.channels))
    for what, rows in (("removed", t.removed), ("added", t.added)):
        yield from (f"route {r.id} {what}: {_told(r)}" for r in rows)
    yield from (f"route {c.route}, was called {c.was}" for c in t.routes if c.route != c.was)
    alike: dict[tuple[Change, ...], list[RouteChange]] = {}
    for c in t.routes:
        if c.cells:
            alike.setdefault(tuple(Change(x.what, x.was, x.now) for x in c.cells), []).append(c)
    for cells, routes in alike.items():
        yield click.style(", ".join(c.route for c in routes), bold=True)
        yield from (f"  {x}" for x in _together(cells))
    yield from (c.text for c in (*t.voyages, *t.automatic))
    numbers = [f"{c.route} {c.number[1]}, was {c.number[0]}" for c in t.routes if c.number]
    if numbers:
        yield f"other numbers: {'; '.join(numbers)}"


def _together(cells: Sequence[Change]) -> list[str]:
    """What has come into a cell in one line, and what is gone from it in one."""
    found: dict[tuple[str, bool, bool], list[Change]] = {}
    for x in cells:
        found.setdefault((x.what, x.was is None, x.now is None), []).append(x)
    out = []
    for (what, come, gone), those in found.items():
        if come or gone:
            items = ", ".join(str(x.now if come else x.was) for x in those)
            out.append(f"{what}: {items} {'added' if come else 'removed'}")
        else:
            out += [x.text for x in those]
    return out


def _each(t: TableChanges, found: Differences) -> Iterator[str]:
    """One line for each change of each route."""
    yield from (c.text for c in (*found.principles, *found.elements, *found.channels))
    for what, rows in (("removed", t.removed), ("added", t.added)):
        yield from (f"{r.id}: route {what}: {_told(r)}" for r in rows)
    for c in t.routes:
        yield from (f"{c.route}: {x}" for x in ([f"was called {c.was}"] if c.route != c.was else []))
        yield from (f"{c.route}: {x.text}" for x in c.cells)
        yield from ([f"{c.route}: No.: {c.number[1]}, was {c.number[0]}"] if c.number else [])
    yield from (c.text for c in (*t.voyages, *t.automatic))


def _body(found: Differences) -> dict[str, Any]:
    sides = {"old": found.old, "new": found.new}
    body: dict[str, Any] = {
        "ok": found.same,
        "same": found.same if found.ok else None,
        **{side: one.path for side, one in sides.items()},
        "diagnostics": [d for x in sides.values() if not x.ok for d in render.as_json(x.diagnostics, x.source.texts)],
    }
    t = found.table
    if t is None:
        return body
    return body | {
        "elsewhere": [*found.elsewhere],
        "printed": [*found.printed],
        "principles": [*map(_change, found.principles)],
        "elements": [*map(_change, found.elements)],
        "channels": [*map(_change, found.channels)],
        "removed": [*map(_row, t.removed)],
        "added": [*map(_row, t.added)],
        "routes": [
            {
                "route": c.route,
                "was_called": c.was,
                "number": None if c.number is None else {"was": c.number[0], "now": c.number[1]},
                "cells": [
                    _change(x)
                    | {"rule": x.because.rule if x.because else None, "text": x.because.text if x.because else None}
                    for x in c.cells
                ],
            }
            for c in t.routes
        ],
        "voyages": [*map(_change, t.voyages)],
        "automatic": [*map(_change, t.automatic)],
    }


def _change(c: Change) -> dict[str, str | None]:
    return {"what": c.what, "was": c.was, "now": c.now}


def _row(r: RouteRow) -> dict[str, Any]:
    return {"route": r.id, "cells": {c.en: [text for text, _ in c.items(r)] for c in COLUMNS}}
