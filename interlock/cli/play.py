"""`interlock play`: a trace as a page that plays it."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.cli.common import FINDINGS, OK
from interlock.emit.report import BadTrace, player_html


@click.command("play")
@click.argument("trace", type=click.Path(path_type=Path, dir_okay=False))
@click.option(
    "-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="The page; else beside the trace."
)
def command(trace: Path, output: Path | None) -> None:
    """Make a page of an ITF TRACE, as `prove` and `compile` write them for refuted claims."""
    target = output or trace.with_name(trace.name.removesuffix(".json").removesuffix(".itf") + ".html")
    try:
        page = player_html(trace.read_text("utf-8"))
        target.write_text(page, "utf-8")
    except (OSError, UnicodeDecodeError) as error:
        click.echo(f"{trace}: {getattr(error, 'strerror', None) or 'not UTF-8 text'}", err=True)
        sys.exit(FINDINGS)
    except BadTrace as error:
        click.echo(f"{trace}: {error}", err=True)
        sys.exit(FINDINGS)
    click.echo(f"{target}: open it in a browser")
    sys.exit(OK)
