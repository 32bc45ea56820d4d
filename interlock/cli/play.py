"""`interlock play`: a trace as a page that plays it."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.own import NotOurs, write_own
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, put_json, told
from interlock.emit.report import BadTrace, player_html
from interlock.panel.journal import NotAPanels
from interlock.panel.journal import page as shift_page
from interlock.panel.journal import trace as recorded_trace
from interlock.record.log import read


@click.command("play")
@click.argument("trace", type=click.Path(path_type=Path, dir_okay=False))
@click.option(
    "-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="The page; else beside the trace."
)
@click.option("--from", "first", default="", help="Of a panel's record: from HH:MM[:SS] on.")
@click.option("--to", "last", default="", help="Of a panel's record: until then.")
@click.option("--journal", is_flag=True, help="Of a panel's record: the page of the shift, for printing.")
@force_option
@format_option
def command(trace: Path, output: Path | None, first: str, last: str, journal: bool, force: bool, form: str) -> None:
    """Make a page of an ITF TRACE, as `prove` and `compile` write them for refuted claims, or of a panel's record."""
    target = output or trace.with_name(trace.name.removesuffix(".json").removesuffix(".itf") + ".html")
    try:
        data = trace.read_bytes()
        if data.startswith(b'{"n":'):
            page = _recorded(data, trace, first, last, journal)
        elif journal or first or last:
            raise NotAPanels(f"{trace} is no record of a panel")
        else:
            page = player_html(data.decode("utf-8"))
    except (OSError, UnicodeDecodeError, BadTrace, NotAPanels) as error:
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


def _recorded(data: bytes, path: Path, first: str, last: str, journal: bool) -> str:
    """A page of a panel's record.  Raises `NotAPanels` for one that is damaged, too."""
    found = read(data)
    if found.problem is not None:
        raise NotAPanels(f"{path}:{found.problem.line}: {found.problem.text}")
    return shift_page(found, first, last) if journal else player_html(recorded_trace(found, first, last))
