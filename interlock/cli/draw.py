"""`interlock draw`: the track plan."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.draw import draw_file
from interlock.app.own import NotOurs, write_own
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, put_json, show, told


@click.command("draw")
@click.argument("layout", type=click.Path())
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="The file; else NAME.svg here.")
@force_option
@format_option
def command(layout: str, output: Path | None, force: bool, form: str) -> None:
    """Draw the track plan of LAYOUT as SVG, from its topology alone."""
    drawn = draw_file(layout)
    if drawn.svg is None:
        show(drawn.diagnostics, drawn.source.texts, form)
        sys.exit(FINDINGS)
    target = output or Path(Path(layout).stem + ".svg")
    try:
        size = write_own(target, drawn.svg.encode(), Path(layout), force)
    except (NotOurs, OSError) as error:
        failed(told(error, target), form)
        sys.exit(FINDINGS)
    if form == "json":
        put_json({"ok": True, "file": str(target), "bytes": size, "notes": list(drawn.notes)})
    else:
        for note in drawn.notes:
            click.echo(f"note: {note}")
        click.echo(f"{target}: {size} bytes")
    sys.exit(OK)
