"""`interlock check`: every problem of a layout at once; no proof."""

from __future__ import annotations

import sys
import time

import click

from interlock.app.check import check_file
from interlock.cli.common import (
    FINDINGS,
    OK,
    format_option,
    layouts_argument,
    number_of,
    progress,
    put_json,
    show,
    took,
)
from interlock.diag import render


@click.command("check")
@layouts_argument
@format_option
def command(layouts: tuple[str, ...], form: str) -> None:
    """Report every problem in the layouts with its place, code and fix (fast, without proof)."""
    results = []
    for p in layouts:
        began = time.monotonic()
        with progress(p) as report:
            report("deriving", 0, 0)
            results.append((check_file(p), took(began)))
    if form == "json":
        put_json(
            [
                {
                    "file": r.path,
                    "ok": r.ok,
                    "diagnostics": render.as_json(r.diagnostics, r.source.texts),
                    "routes": len(r.table.routes) if r.table else None,
                }
                for r, _ in results
            ]
        )
    else:
        for r, time_taken in results:
            show(r.diagnostics, r.source.texts, form)
            count = f", {number_of(len(r.table.routes), 'route')}" if r.ok and r.table else ""
            click.echo(f"{r.path}: {render.summary(r.diagnostics) or 'no problems'}{count}, {time_taken}")
    sys.exit(OK if all(r.ok for r, _ in results) else FINDINGS)
