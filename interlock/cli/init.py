"""`interlock init`: a layout to begin with, or a large one."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.init import STARTER, line, yard
from interlock.cli.common import FINDINGS, OK


@click.command("init")
@click.option("--yard", "tracks", type=click.IntRange(4, 2000), help="A yard with that many parallel tracks.")
@click.option("--line", "stations", type=click.IntRange(1, 5000), help="A single line with that many stations.")
@click.option("-o", "--output", type=click.Path(dir_okay=False), default="-", help="The file; - for the screen.")
@click.option("--force", is_flag=True, help="Overwrite the file.")
def command(tracks: int | None, stations: int | None, output: str, force: bool) -> None:
    """Write a small layout to edit, or with --yard or --line a large one for trials."""
    if tracks is not None and stations is not None:
        raise click.UsageError("say --yard or --line, not both")
    text = yard(tracks) if tracks is not None else line(stations) if stations is not None else STARTER
    if output == "-":
        click.echo(text, nl=False)
        sys.exit(OK)
    path = Path(output)
    if path.exists() and not force:
        click.echo(f"{output} exists; --force overwrites it", err=True)
        sys.exit(FINDINGS)
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        click.echo(f"{output}: {error.strerror}", err=True)
        sys.exit(FINDINGS)
    click.echo(f"{output}: {text.count(chr(10))} lines; next: interlock check {output}")
    sys.exit(OK)
