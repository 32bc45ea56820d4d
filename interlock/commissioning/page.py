"""A book of tests as a page for printing, and as a table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import groupby

from jinja2 import Environment, PackageLoader, select_autoescape

from interlock.commissioning.step import Sheet, Step
from interlock.model.layout import Layout
from interlock.spreadsheet import csv_text

HEADINGS = ("No.", "Sheet", "About", "Do", "What has to come", "Rule", "On the bench", "Seen", "By", "Date")

TITLES = {
    Sheet.WIRES: "Correspondence: each wire",
    Sheet.START: "Switching on",
    Sheet.MACHINES: "Machines, while nothing is set",
    Sheet.ROUTES: "Routes: each row of the interlocking table",
    Sheet.TIMES: "Delays, by a stopwatch",
}


WITHOUT = (
    "what voyages, automatic working, zones with a limit, swinging overlaps, priorities and releases by hand do",
    "points that a declared hostile pair or a demand holds longer than the route itself",
    "signals that show clear, and distants, while the next signal is open",
    "approach locking from places up to which no route can be set together with the one that is tried",
    "trains that are called on, behind their signal",
    "numbers of scans, and lamps that go out while they are lit",
)
"""What no test of a book tries; the proof speaks of it."""


def book_csv(steps: Sequence[Step]) -> str:
    """One row for each test, with room for what was seen, by whom and when."""
    rows = ((s.number, s.sheet, s.of, s.do, s.expect, s.rule, s.bench, "", "", "") for s in steps)
    return csv_text([HEADINGS, *rows])


def book_html(layout: Layout, steps: Sequence[Step], version: str, of: str = "", gone: str = "") -> str:
    """Sheets of A4 to be signed.  `version`: of this program; `of`: which tests these are, where they are not all;
    `gone`: which tests of an old book there are no more."""
    env = Environment(
        loader=PackageLoader("interlock.commissioning", "."),
        autoescape=select_autoescape(("j2",)),
        trim_blocks=True,
        lstrip_blocks=True,
    )
    sheets = [(TITLES[k], _groups(list(those))) for k, those in groupby(steps, lambda s: s.sheet)]
    return env.get_template("book.html.j2").render(
        title=layout.printed.title or layout.name,
        name=layout.name,
        digest=layout.digest,
        program=f"interlock {version}",
        sheets=sheets,
        of=of,
        gone=gone,
        without=WITHOUT,
        count=len(steps),
        by_sheet=[(TITLES[k], n) for k, n in Counter(s.sheet for s in steps).items()],
        tried=sum(s.tried for s in steps),
        failed=[s for s in steps if s.came],
    )


def _groups(steps: Sequence[Step]) -> list[tuple[str, list[Step]]]:
    """Tests of a sheet, by the route that they are about; the others have one table."""
    if steps[0].sheet is not Sheet.ROUTES:
        return [("", list(steps))]
    return [(route, list(those)) for route, those in groupby(steps, lambda s: s.of)]
