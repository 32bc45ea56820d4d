"""`interlock commission`: the book of tests by which an installation is commissioned."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

import click

from interlock import __version__
from interlock.app.commission import Commissioning, NoRoute, commission, gone, not_in
from interlock.app.own import NotOurs, write_own
from interlock.cli.common import (
    FINDINGS,
    OK,
    exit_code,
    failed,
    force_option,
    format_option,
    number_of,
    progress,
    proof_body,
    put_json,
    show_proof,
    told,
)
from interlock.commissioning.page import book_csv, book_html
from interlock.commissioning.step import Step

FORMS = (".html", ".csv")
MOST = 20
"""Tests that came out otherwise which are told one by one."""


@click.command("commission")
@click.argument("layout", type=click.Path())
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path, dir_okay=False),
    multiple=True,
    help="The file to write: .html for printing, .csv for a table; by default NAME_tests.html and NAME_tests.csv here.",
)
@click.option("--route", "routes", multiple=True, metavar="NAME", help="Only the tests of this route; may be repeated.")
@click.option(
    "--since",
    type=click.Path(),
    metavar="OLD",
    help="Only the tests that the book of this layout, from before a change, does not have.",
)
@force_option
@format_option
def command(
    layout: str, output: tuple[Path, ...], routes: tuple[str, ...], since: str | None, force: bool, form: str
) -> None:
    """Write the tests by which LAYOUT is commissioned: each wire, each cell of each route's row, switching on, each
    delay.  Whatever a bench can try is tried on the emitted runtime first."""
    files = output or tuple(Path(f"{Path(layout).stem}_tests{x}") for x in FORMS)
    for file in files:
        if file.suffix.lower() not in FORMS:
            raise click.UsageError(f"{file}: a book of tests is called NAME.html, for printing, or NAME.csv")
    found = _book(layout, routes, form)
    assert found.steps is not None and found.ready.layout is not None
    steps, of = found.steps, f" of route {', '.join(routes)}" if routes else ""
    lost: dict[str, int] | None = None
    if since is not None:
        old = _book(since, (), form)
        assert old.steps is not None and old.ready.layout is not None
        lost = gone(steps, old.steps, [*dict.fromkeys(s.of for s in steps)] if routes else ())
        steps, of = not_in(steps, old.steps), f"{of} that the book of layout {old.ready.layout.digest} does not have"
    bodies = {
        ".html": lambda: book_html(found.ready.layout, steps, __version__, of, _told_gone(lost)),
        ".csv": lambda: book_csv(steps),
    }
    for file in files:
        try:
            write_own(file, bodies[file.suffix.lower()]().encode(), Path(layout), force)
        except (NotOurs, OSError) as error:
            failed(told(error, file), form)
            sys.exit(FINDINGS)
    _say(layout, steps, found.failed, files, form, lost)
    sys.exit(FINDINGS if found.failed else OK)


def _book(layout: str, routes: tuple[str, ...], form: str) -> Commissioning:
    """The tests of a proved layout; the command ends where it is not proved."""
    try:
        with progress(layout) as report:
            found = commission(layout, routes, report)
    except NoRoute as error:
        raise click.UsageError(f"--route: {error}") from None
    if found.steps is None:
        if form == "json":
            put_json({"ok": False, "proof": proof_body(found.ready.proved)})
        else:
            show_proof(found.ready.proved, form, False)
        sys.exit(exit_code([found.ready.proved]))
    return found


def _told_gone(lost: dict[str, int] | None) -> str:
    """The tests of the old book that the new one does not have, in words; empty where nothing was compared."""
    if lost is None:
        return ""
    if not lost:
        return "every test of the old book applies"
    several = sum(lost.values()) > 1
    apply = "apply as they were" if several else "applies as it was"
    by = ", ".join(f"{what} {n}" for what, n in lost.items())
    return f"{number_of(sum(lost.values()), 'test')} of the old book no longer {apply}: {by}"


def _say(
    layout: str,
    steps: tuple[Step, ...],
    wrong: tuple[Step, ...],
    files: tuple[Path, ...],
    form: str,
    lost: dict[str, int] | None,
) -> None:
    count = Counter(str(s.sheet) for s in steps)
    tried = sum(s.tried for s in steps)
    if form == "json":
        otherwise = [{"number": s.number, "do": s.do, "expect": s.expect, "came": s.came} for s in wrong]
        put_json(
            {
                "ok": not wrong,
                "tests": dict(count),
                "tried": tried,
                "otherwise": otherwise,
                "files": [str(f) for f in files],
            }
            | ({} if lost is None else {"gone": lost})
        )
        return
    for s in wrong[:MOST]:
        click.echo(f"  {click.style('OTHERWISE', fg='red')} {s.number} {s.do}: {s.expect}; on the bench {s.came}")
    parts = ", ".join(f"{n} {sheet}" for sheet, n in count.items())
    told_of = f"{number_of(len(steps), 'test')} ({parts})" if steps else "no test"
    ended = f"{len(wrong)} came out otherwise" if wrong else "all as expected"
    click.echo(f"{layout}: {told_of}; {tried} tried on the bench, {ended}")
    if lost is not None:
        click.echo(f"  {_told_gone(lost)}")
    for file in files:
        click.echo(f"  written: {file}")
