"""`interlock record`: an event log checked, as Parquet, and asked with SQL."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import click

from interlock.app.own import NotOurs, write_own, write_whole
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, put_json, told
from interlock.record import Recorded, read_file
from interlock.record.graph import graph_svg
from interlock.record.report import shift_html
from interlock.record.shift import NoShift, figures, to_csv
from interlock.record.tables import BadQuery, NoTables, query, write_parquet

PARQUET = b"PAR1"
"""The first bytes of a Parquet file."""


@click.command("record")
@click.argument("logs", nargs=-1, required=True, metavar="LOG...", type=click.Path(path_type=Path, dir_okay=False))
@click.option("--parquet", type=click.Path(path_type=Path, dir_okay=False), help="Write all events as Parquet.")
@click.option("--sql", help="Query the table `events`: log, n, t (milliseconds), kind, and every field of the events.")
@click.option("--report", type=click.Path(path_type=Path, file_okay=False), help="A folder for reports of shifts.")
@force_option
@format_option
def command(
    logs: tuple[Path, ...], parquet: Path | None, sql: str | None, report: Path | None, force: bool, form: str
) -> None:
    """Check event LOGs against their digests, convert them to Parquet, query them with SQL, report shifts."""
    if sum(x is not None for x in (sql, parquet, report)) > 1:
        raise click.UsageError("--parquet, --sql and --report are asked for one at a time")
    found: dict[str, Recorded] = {}
    for file in logs:
        try:
            found[str(file)] = read_file(file)
        except OSError as error:
            failed(told(error, file), form)
            sys.exit(FINDINGS)
    for name in [n for n, r in found.items() if r.problem is None and not r.events]:
        failed(f"{name}: there is no whole event in it", form, "IL6011", "take the log from where it was copied from")
        sys.exit(FINDINGS)
    damaged = {n: r for n, r in found.items() if r.problem is not None}
    for name, r in damaged.items():
        assert r.problem is not None
        n = len(r.events)
        few = {0: "no event comes before it", 1: "the event before it holds"}
        before = few.get(n, f"the {n} events before it hold")
        text = f"{name}:{r.problem.line}: {r.problem.text}; {before}"
        failed(text, form, "IL6011", "take the log from where it was copied from")
    if damaged:
        sys.exit(FINDINGS)
    try:
        if sql is not None:
            _answer(*query(sql, {n: r.events for n, r in found.items()}), form)
        if parquet is not None:
            _parquet(parquet, found, force, form)
        if report is not None:
            _report(report, found, force, form)
    except (NoTables, BadQuery, NoShift, NotOurs, OSError) as error:
        failed(told(error, parquet or report or Path()) if isinstance(error, OSError) else str(error), form)
        sys.exit(FINDINGS)
    if sql is None and parquet is None and report is None:
        _summary(found, form)
    sys.exit(OK)


def _answer(names: list[str], rows: list[tuple[object, ...]], form: str) -> None:
    """The rows of a query: tab-separated under their names, or as JSON."""
    if form == "json":
        put_json({"ok": True, "columns": names, "rows": [[_plain(v) for v in r] for r in rows]})
        return
    click.echo("\t".join(names))
    for r in rows:
        click.echo("\t".join("" if v is None else str(v) for v in r))


def _plain(value: object) -> object:
    try:
        json.dumps(value)
    except TypeError:
        return str(value)
    return value


def _parquet(target: Path, found: dict[str, Recorded], force: bool, form: str) -> None:
    if target.exists() and not force and target.read_bytes()[:4] != PARQUET:
        failed(f"{target} exists and is no Parquet file; --force overwrites it", form)
        sys.exit(FINDINGS)
    rows = write_parquet(target, {n: r.events for n, r in found.items()})
    if form == "json":
        put_json({"ok": True, "file": str(target), "rows": rows})
    else:
        click.echo(f"{target}: {rows} events")


def _report(folder: Path, found: dict[str, Recorded], force: bool, form: str) -> None:
    """Page, figures and graph of each shift.  Raises `NoShift`, `NotOurs`, `OSError`."""
    _told_apart(found, form)
    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for name, r in found.items():
        stem = _stem(name)
        page = shift_html(r)
        made = {".html": page, ".csv": to_csv(figures(r.events)), ".svg": graph_svg(r.events)}
        for ending, text in made.items():
            target = folder / (stem + ending)
            if ending == ".csv":
                _write_csv(target, text, force)
            else:
                write_own(target, text.encode(), Path(name), force)
            files.append(str(target))
    if form == "json":
        put_json({"ok": True, "files": files})
    else:
        for f in files:
            click.echo(f"written: {f}")


def _stem(log: str) -> str:
    """How the files of a log's report are called, but for their endings."""
    return Path(log).name.removesuffix(".log")


def _told_apart(found: dict[str, Recorded], form: str) -> None:
    """Ends the command where two reports would have the same names: the second would overwrite the first."""
    first: dict[str, str] = {}
    for name in found:
        other = first.setdefault(_stem(name), name)
        if other != name:
            text = f"{other} and {name} would both be reported as {_stem(name)}"
            failed(text, form, fix="report them into folders of their own, or rename one of them")
            sys.exit(FINDINGS)


def _write_csv(target: Path, text: str, force: bool) -> None:
    """A table has no place for a mark: another one with the same heading is ours.  Raises `NotOurs`, `OSError`."""
    heading = text.partition("\n")[0]
    if target.exists() and not force and target.read_text("utf-8", "replace").partition("\n")[0] != heading:
        raise NotOurs(f"{target} exists and is not as interlock wrote it; --force overwrites it")
    write_whole(target, text.encode())


def _summary(found: dict[str, Recorded], form: str) -> None:
    if form == "json":
        body = [
            {"log": n, "events": len(r.events), "ended": r.ended, "torn_bytes": r.torn, "chain": r.chain.digest}
            for n, r in found.items()
        ]
        put_json({"ok": True, "logs": body})
        return
    for name, r in found.items():
        last = r.events[-1]["t"] / 1000 if r.events else 0.0
        how = "whole, to its end" if r.ended else f"whole up to its last event, at {last:.1f} s; it has no end"
        rest = f"; {r.torn} bytes of an event that was being written are left out" if r.torn else ""
        click.echo(f"{name}: {len(r.events)} events, {how}{rest}; chain {r.chain.digest[:16]}")
