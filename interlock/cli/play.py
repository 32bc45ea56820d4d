"""`interlock play`: a trace as a page that plays it."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import click

from interlock.app.own import NotOurs, write_own
from interlock.app.replaying import trace as of_record
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, put_json, show, told
from interlock.diag import Sink
from interlock.emit.report import BadTrace, player_html
from interlock.frontend import load
from interlock.record import read_file
from interlock.record.shift import NoShift


@click.command("play")
@click.argument("trace", type=click.Path(path_type=Path, dir_okay=False))
@click.option("--layout", help="The layout of a shift's record, which is then played instead of a trace.")
@click.option("--from", "since", default="0:00", show_default=True, metavar="H:MM", help="Where it begins.")
@click.option("--to", "until", default="9999:00", metavar="H:MM", help="Where it ends.")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="The page; else beside the trace."
)
@force_option
@format_option
def command(
    trace: Path, layout: str | None, since: str, until: str, output: Path | None, force: bool, form: str
) -> None:
    """Make a page of an ITF TRACE, as `prove` and `compile` write them for refuted claims.

    With --layout, TRACE is the record of a shift, as `simulate` writes it, and a span of it is played.
    """
    name = trace.name.removesuffix(".json").removesuffix(".itf").removesuffix(".log")
    target = output or trace.with_name(name + ".html")
    try:
        if layout is None:
            text = trace.read_text("utf-8")
        else:
            text = _record(trace, layout, _seconds(since), _seconds(until), form)
        page = player_html(text)
    except (OSError, UnicodeDecodeError, BadTrace, NoShift) as error:
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


def _record(log: Path, path: str, since: float, until: float, form: str) -> str:
    """A span of a record as a trace.  Raises `NoShift`, `OSError`."""
    sink = Sink()
    layout, source = load(path, sink)
    if layout is None:
        show(sink.diagnostics, {source.file: source.text}, form)
        sys.exit(FINDINGS)
    found = read_file(log)
    if found.problem is not None:
        failed(f"{log}:{found.problem.line}: {found.problem.text}", form, "IL6011", "take it from where it came from")
        sys.exit(FINDINGS)
    return of_record(layout, found.events, since, until)


def _seconds(text: str) -> float:
    found = re.fullmatch(r"(\d{1,4}):([0-5]\d)", text)
    if found is None:
        raise click.UsageError(f"'{text}' is no time of a shift: write hours and minutes, as 1:30")
    return 3600.0 * int(found[1]) + 60.0 * int(found[2])
