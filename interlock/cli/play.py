"""`interlock play`: a trace, or a span of a record, as a page that plays it."""

from __future__ import annotations

import re
import sys
from math import inf
from pathlib import Path

import click

from interlock.app.own import NotOurs, write_own
from interlock.app.replaying import trace as of_shift
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, put_json, show, told
from interlock.diag import Sink
from interlock.emit.report import BadTrace, player_html
from interlock.frontend import load
from interlock.panel.journal import NotAPanels
from interlock.panel.journal import page as shift_page
from interlock.panel.journal import trace as of_panel
from interlock.record.log import read
from interlock.record.shift import NoShift


@click.command("play")
@click.argument("trace", type=click.Path(path_type=Path, dir_okay=False))
@click.option("--layout", help="The layout of a shift's record, as `simulate` writes it.")
@click.option(
    "--from", "first", default="", metavar="TIME", help="Replay a record from H:MM on (a panel's: HH:MM[:SS])."
)
@click.option("--to", "last", default="", metavar="TIME", help="Replay a record until then.")
@click.option("--journal", is_flag=True, help="Make the printable page of the shift from a panel's record.")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path, dir_okay=False),
    help="The page to write; by default beside the trace.",
)
@force_option
@format_option
def command(
    trace: Path, layout: str | None, first: str, last: str, journal: bool, output: Path | None, force: bool, form: str
) -> None:
    """Make a page of an ITF TRACE, as `prove` and `compile` write them for refuted claims, or of a record.

    TRACE may be the record of a panel, or with --layout that of a shift.
    """
    if layout is not None and journal:
        raise click.UsageError("--journal is of a panel's record; of a shift's: interlock record LOG --report FOLDER")
    if not trace.name:
        raise click.UsageError("name the trace to play: counterexamples/NAME.itf.json, or a record")
    name = trace.name.removesuffix(".json").removesuffix(".itf").removesuffix(".log")
    target = output or trace.with_name(name + ".html")
    try:
        data = trace.read_bytes()
        if layout is not None:
            page = player_html(_shift(data, trace, layout, first, last, form))
        elif data.startswith(b'{"n":'):
            page = _panel(data, trace, first, last, journal)
        elif journal or first or last:
            raise NotAPanels(f"{trace} is no record of a panel")
        else:
            page = player_html(data.decode("utf-8"))
    except BadTrace as error:
        failed(f"{trace}: {error}", form)
        sys.exit(FINDINGS)
    except (OSError, UnicodeDecodeError, NotAPanels, NoShift) as error:
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


def _shift(data: bytes, log: Path, path: str, first: str, last: str, form: str) -> str:
    """A span of a shift's record as a trace.  Raises `NoShift`."""
    sink = Sink()
    layout, source = load(path, sink)
    if layout is None:
        show(sink.diagnostics, source.texts, form)
        sys.exit(FINDINGS)
    found = read(data)
    if found.problem is not None:
        failed(f"{log}:{found.problem.line}: {found.problem.text}", form, "IL6011", "take it from where it came from")
        sys.exit(FINDINGS)
    if found.events and "views" in found.events[0]:
        raise NoShift(f"{log} is the record of a panel, which has its own plan: leave out --layout")
    since, until = _seconds(first, 0.0), _seconds(last, inf)
    if since > until:
        raise NoShift(f"--to {last} is before --from {first}")
    return of_shift(layout, found.events, since, until)


def _panel(data: bytes, path: Path, first: str, last: str, journal: bool) -> str:
    """A page of a panel's record.  Raises `NotAPanels` for one that is damaged, too."""
    found = read(data)
    if found.problem is not None:
        raise NotAPanels(f"{path}:{found.problem.line}: {found.problem.text}")
    return shift_page(found, first, last) if journal else player_html(of_panel(found, first, last))


def _seconds(text: str, without: float) -> float:
    if not text:
        return without
    found = re.fullmatch(r"(\d{1,4}):([0-5]\d)", text)
    if found is None:
        raise click.UsageError(f"'{text}' is no time of a shift: write hours and minutes, as 1:30")
    return 3600.0 * int(found[1]) + 60.0 * int(found[2])
