"""`interlock check`: every problem of a layout at once; no proof."""

from __future__ import annotations

import sys

import click

from interlock.app.check import check_file
from interlock.cli.common import FINDINGS, OK, format_option, layouts_argument, put_json, show
from interlock.diag import render


@click.command("check")
@layouts_argument
@format_option
def command(layouts: tuple[str, ...], form: str) -> None:
    """Report every problem of the layouts with place, code and fix (fast, no proof)."""
    results = [check_file(p) for p in layouts]
    if form == "json":
        put_json(
            [
                {
                    "file": r.path,
                    "ok": r.ok,
                    "diagnostics": render.as_json(r.diagnostics, {r.source.file: r.source.text}),
                    "routes": len(r.table.routes) if r.table else None,
                }
                for r in results
            ]
        )
    else:
        for r in results:
            show(r.diagnostics, {r.source.file: r.source.text}, form)
            count = f", {len(r.table.routes)} routes" if r.ok and r.table else ""
            click.echo(f"{r.path}: {render.summary(r.diagnostics) or 'no problems'}{count}")
    sys.exit(OK if all(r.ok for r in results) else FINDINGS)
