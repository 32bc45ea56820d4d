"""`interlock draw`: the track plan."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.draw import draw_file
from interlock.cli.common import FINDINGS, OK, show


@click.command("draw")
@click.argument("layout", type=click.Path())
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="The file; else NAME.svg here.")
def command(layout: str, output: Path | None) -> None:
    """Draw the track plan of LAYOUT as SVG, from its topology alone."""
    drawn = draw_file(layout)
    if drawn.svg is None:
        show(drawn.diagnostics, {drawn.source.file: drawn.source.text}, "full")
        sys.exit(FINDINGS)
    target = output or Path(Path(layout).stem + ".svg")
    try:
        target.write_text(drawn.svg, "utf-8")
    except OSError as error:
        click.echo(f"{target}: {error.strerror}", err=True)
        sys.exit(FINDINGS)
    for note in drawn.notes:
        click.echo(f"note: {note}")
    click.echo(f"{target}: {len(drawn.svg)} bytes")
    sys.exit(OK)
