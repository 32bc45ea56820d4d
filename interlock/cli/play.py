"""`interlock play`: a trace as a page that plays it."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.own import NotOurs, write_own
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, put_json, told
from interlock.emit.report import BadTrace, player_html


@click.command("play")
@click.argument("trace", type=click.Path(path_type=Path, dir_okay=False))
@click.option(
    "-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="The page; else beside the trace."
)
@force_option
@format_option
def command(trace: Path, output: Path | None, force: bool, form: str) -> None:
    """Make a page of an ITF TRACE, as `prove` and `compile` write them for refuted claims."""
    target = output or trace.with_name(trace.name.removesuffix(".json").removesuffix(".itf") + ".html")
    try:
        page = player_html(trace.read_text("utf-8"))
    except (OSError, UnicodeDecodeError, BadTrace) as error:
        failed(told(error, trace), form)
        sys.exit(FINDINGS)
    try:
        size = write_own(target, page.encode(), trace, force)
    except (NotOurs, OSError) as error:
        failed(told(error, target), form)
        sys.exit(FINDINGS)
    if form == "json":
        put_json({"ok": True, "file": str(target), "bytes": size})
    else:
        click.echo(f"{target}: open it in a browser")
    sys.exit(OK)
