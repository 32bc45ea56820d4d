"""`interlock why`: the reasons of a route's cells."""

from __future__ import annotations

import sys

import click

from interlock.app.check import check_file
from interlock.app.why import why
from interlock.cli.common import FINDINGS, OK, format_option, put_json, show
from interlock.diag import render
from interlock.table.columns import COLUMNS


@click.command("why")
@click.argument("layout")
@click.argument("route", required=False)
@click.argument("column", required=False)
@format_option
def command(layout: str, route: str | None, column: str | None, form: str) -> None:
    """Print the reason for each cell of a route's row (all columns, or one); without a route, the routes."""
    if route is None:
        sys.exit(_routes(layout, form))
    checked, reasons, problems = why(layout, route, column)
    failed = bool(problems) or not checked.ok
    if form == "json":
        put_json(
            {
                "ok": not failed,
                "route": route,
                "reasons": [{"column": r.column, "item": r.item, "rule": r.rule, "text": r.text} for r in reasons],
                "diagnostics": render.as_json([*checked.diagnostics, *problems], checked.source.texts),
            }
        )
        sys.exit(FINDINGS if failed else OK)
    if failed:
        show(
            [*(d for d in checked.diagnostics if not checked.ok), *problems],
            checked.source.texts,
            form,
        )
        sys.exit(FINDINGS)
    if not reasons:
        click.echo(f"{route} has nothing in the column {next(c.en for c in COLUMNS if column in (c.key, c.en))}")
    last = ""
    for r in reasons:
        if r.column != last:
            click.echo(click.style(r.column, bold=True))
            last = r.column
        click.echo(f"  {r.item:32} {r.rule:6} {r.text}")
    sys.exit(OK)


def _routes(layout: str, form: str) -> int:
    """The routes that can be named, each with the sections over which it leads; the exit code."""
    checked = check_file(layout)
    rows = checked.table.routes if checked.table is not None else ()
    named = [(r.id, ", ".join((str(r.kind), *r.names)), ", ".join(s for s, _ in r.path.traversals)) for r in rows]
    if form == "json":
        put_json(
            {
                "routes": [{"route": n, "kind": kind, "over": over} for n, kind, over in named],
                "diagnostics": render.as_json(checked.diagnostics, checked.source.texts),
            }
        )
    elif not checked.ok:
        show(checked.diagnostics, checked.source.texts, form)
    for n, kind, over in named if form != "json" and checked.ok else ():
        click.echo(f"{n:22} {kind:16} over {over}")
    return OK if checked.ok else FINDINGS
