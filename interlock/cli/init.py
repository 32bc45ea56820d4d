"""`interlock init`: a layout to begin with, or a large one."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

import click

from interlock.app.init import STARTER, line, yard
from interlock.app.own import write_whole
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, put_json, told


@click.command("init")
@click.option("--yard", "tracks", type=click.IntRange(4, 2000), help="A yard with this many parallel tracks.")
@click.option("--line", "stations", type=click.IntRange(1, 5000), help="A single line with this many stations.")
@click.option(
    "-o",
    "--output",
    type=click.Path(dir_okay=False),
    default="-",
    help="The file to write; without it, or with -, it is shown on the screen.",
)
@force_option
@format_option
def command(tracks: int | None, stations: int | None, output: str, force: bool, form: str) -> None:
    """Write a small layout to edit, or with --yard or --line a large one for trials."""
    if tracks is not None and stations is not None:
        raise click.UsageError("say --yard or --line, not both")
    text = yard(tracks) if tracks is not None else line(stations) if stations is not None else STARTER
    lines = text.count("\n")
    if output == "-":
        if form == "json":
            put_json({"ok": True, "file": None, "lines": lines, "text": text})
        else:
            click.echo(text, nl=False)
            if sys.stdout.isatty():
                click.echo("\nto write it to a file: interlock init -o NAME.yaml", err=True)
        sys.exit(OK)
    path = Path(output)
    try:
        if path.exists() and not force:  # a layout is there to be edited
            failed(f"{output} exists; --force overwrites it", form)
            sys.exit(FINDINGS)
        write_whole(path, text.encode())
    except OSError as error:
        failed(told(error, path), form)
        sys.exit(FINDINGS)
    if form == "json":
        put_json({"ok": True, "file": output, "lines": lines})
    else:
        click.echo(f"{output}: {lines} lines; next: interlock check {shlex.quote(output)}")
    sys.exit(OK)
