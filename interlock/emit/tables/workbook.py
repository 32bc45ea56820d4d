"""The table as a workbook: for print on A3, and to be searched with filters.

Sheets are written row by row; of a large table the reasons of hostile pairs and the matrices stay in `table.json` and
`matrix.csv`, as the sheet says that leaves them out.
"""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from datetime import datetime
from typing import Any

from interlock.dataclass import dataclass
from interlock.emit.bundle import reproducible
from interlock.emit.tables.export import matrix_rows, printed_rows, reason_rows
from interlock.emit.tables.paper import (
    MARGIN_IN,
    NOT_CERTIFIED,
    PAPER_A3,
    SIGNED,
    TYPE_PT,
    shortened,
    title_block,
    widths,
)
from interlock.model.layout import Layout
from interlock.table.columns import COLUMNS, VOYAGE_COLUMNS
from interlock.table.national import Heading, Sheet, national_sheets
from interlock.table.rows import InterlockingTable
from interlock.table.runs import legend

LARGE = 200  # routes: from here on pairs of routes are told in table.json and matrix.csv alone
WIDE = {"Column": 20.0, "Item": 34.0, "Rule": 8.0, "Reason": 90.0, "Routes": 50.0}


def table_xlsx(layout: Layout, table: InterlockingTable, mark: str = "") -> bytes:
    """Table, voyages, national forms, reasons, matrices; every sheet for print bears the mark.  Dates are fixed, so
    that the contents are reproducible."""
    import xlsxwriter  # a proof writes none

    out = io.BytesIO()
    with xlsxwriter.Workbook(out, {"constant_memory": True}) as book:
        book.set_properties({"title": f"Interlocking table {layout.name}", "created": datetime(2000, 1, 1)})
        writer = _Writer(book, layout, table.layout_digest, _formats(book), mark)
        for sheet, name, file in _sheets(layout, table):
            writer.printed(sheet, name, file)
        large = len(table.routes) > LARGE
        writer.reasons(reason_rows(table, pairs=not large), large)
        writer.matrices(() if large else matrix_rows(table))
    return reproducible(out.getvalue())


def _sheets(layout: Layout, table: InterlockingTable) -> Iterator[tuple[Sheet, str, str]]:
    """Every printed sheet with its name and the file that has all of it."""
    headings = tuple(Heading(c.en, c.zh, c.de) for c in COLUMNS)
    title = Heading("Interlocking table", "联锁表", "Verschlusstabelle")
    rows = tuple(map(tuple, printed_rows(table)))
    yield Sheet("table", "en", title, headings, rows, True, legend=legend(rows)), "Table", "table.csv"
    if table.voyages:
        headings = tuple(Heading(v.en, v.zh, v.de) for v in VOYAGE_COLUMNS)
        rows = tuple(tuple(v.text(row) for v in VOYAGE_COLUMNS) for row in table.voyages)
        yield Sheet("voyages", "en", Heading("Voyages", "航程", "Fahrten"), headings, rows), "Voyages", "voyages.csv"
    for form in national_sheets(layout, table):
        yield form, form.key, f"table_{form.key}.csv"


def _formats(book: Any) -> dict[str, Any]:
    edge = {"border": 1, "border_color": "#808080", "font_size": TYPE_PT, "text_wrap": True, "valign": "top"}
    return {
        "title": book.add_format({"bold": True, "font_size": 14}),
        "label": book.add_format({"font_size": TYPE_PT}),
        "head": book.add_format({**edge, "bold": True, "bg_color": "#E8EDF2"}),
        "cell": book.add_format(edge),
        "note": book.add_format({"font_size": TYPE_PT, "font_color": "#404040"}),
    }


@dataclass(frozen=True)
class _Writer:
    """A workbook in the making."""

    book: Any
    layout: Layout
    digest: str
    formats: dict[str, Any]
    mark: str

    def printed(self, sheet: Sheet, name: str, file: str) -> None:
        """A sheet for print: title block, table, what it leaves out, legend, signature boxes."""
        form = sheet.printed()
        heads = [_head(h, form.language) for h in form.headings]
        rows = [[shortened(c, file) for c in row] for row in form.rows]
        page = self.book.add_worksheet(name)
        wide = widths(heads, rows) if heads else [22.0] * 4
        for x, width in enumerate(wide):
            page.set_column(x, x, width)
        self._paper(page, name)
        block = title_block(self.layout, self.digest, form.language)
        page.write_string(0, 0, form.title.native(form.language), self.formats["title"])
        page.write_string(1, 0, "   ".join(f"{label}: {fact}" for label, fact in block), self.formats["label"])
        about = [x for x in (self.mark, NOT_CERTIFIED[form.language], form.after) if x]
        page.write_string(2, 0, "; ".join(about) + ".", self.formats["note"])
        page.repeat_rows(0, 3)
        if heads:
            page.freeze_panes(4, min(2, len(heads) - 1))
            page.autofilter(3, 0, 3 + len(rows), len(heads) - 1)
        self._row(page, 3, heads, "head")
        for y, row in enumerate(rows, 4):
            self._row(page, y, row, "cell")
        self._signed(page, self._notes(page, 5 + len(rows), form), wide, form.language)

    def _paper(self, page: Any, name: str) -> None:
        page.set_landscape()
        page.set_paper(PAPER_A3)
        page.set_margins(MARGIN_IN, MARGIN_IN, MARGIN_IN, 0.6)
        page.fit_to_pages(1, 0)
        block = self.layout.printed.title_block
        revision = "" if block is None else " ".join(x for x in (block.number, block.revision, block.date) if x)
        left, middle = (t.replace("&", "&&") for t in (f"{self.layout.name} {name}  {self.mark}".rstrip(), revision))
        page.set_footer(f"&L{left}&C{middle}&R&P / &N")

    def _row(self, page: Any, y: int, cells: Sequence[str], style: str) -> None:
        for x, cell in enumerate(cells):
            page.write_string(y, x, cell, self.formats[style])

    def _notes(self, page: Any, y: int, form: Sheet) -> int:
        """What the table leaves out, and its legend; returns the next row."""
        notes = [] if form.rows else [form.words.none]
        notes += [f"{form.words.left_out}: {'; '.join(form.left_out)}"] * bool(form.left_out)
        notes += [f"{form.words.empty}: {'; '.join(form.empty)}"] * bool(form.empty)
        notes += [f"{sign}: {text}" for sign, text in form.legend]
        for line in notes:
            page.write_string(y, 0, line, self.formats["note"])
            y += 1
        return y + 1

    def _signed(self, page: Any, y: int, wide: Sequence[float], language: str) -> None:
        """A box for each signature: who, name, date, signature."""
        who, what = SIGNED[language]
        spans = _spans(wide, len(what) + 1, 22.0)
        for row in (("", *what), *((w, *[""] * len(what)) for w in who)):
            for (first, last), text in zip(spans, row, strict=False):
                style = self.formats["cell" if row[0] else "head"]
                if first == last:
                    page.write_string(y, first, text, style)
                else:
                    page.merge_range(y, first, y, last, text, style)
            y += 1

    def reasons(self, rows: Iterator[Sequence[str]], large: bool) -> None:
        """Rule and reason of every printed cell, with all routes for which it holds."""
        page = self.book.add_worksheet("Reasons")
        self._paper(page, "Reasons")
        for x, width in enumerate(WIDE.values()):
            page.set_column(x, x, width)
        page.repeat_rows(0, 0)
        page.freeze_panes(1, 0)
        self._row(page, 0, list(WIDE), "head")
        last = 0
        for last, row in enumerate(rows, 1):
            self._row(page, last, [shortened(x, "table.json") for x in row], "cell")
        page.autofilter(0, 0, max(1, last), len(WIDE) - 1)
        if large:
            note = "Why two routes are hostile: table.json, `interlock why`, and the report page"
            page.write_string(last + 2, 0, note, self.formats["note"])

    def matrices(self, rows: Sequence[Sequence[str]]) -> None:
        """M, its products, and what they do not show."""
        page = self.book.add_worksheet("Matrices")
        if not rows:
            page.write_string(0, 0, "In matrix.csv: too large for a sheet", self.formats["note"])
        for y, row in enumerate(rows):
            for x, value in enumerate(row):
                if value.isdigit() and x:
                    page.write_number(y, x, int(value))
                else:
                    page.write_string(y, x, value)


def _head(h: Heading, language: str) -> str:
    native = h.native(language)
    second = h.zh if language == "en" else h.en
    return "\n".join([native, *([second] if second != native else []), *([h.mark] if h.mark else [])])


def _spans(wide: Sequence[float], count: int, least: float) -> list[tuple[int, int]]:
    """So many runs of neighbouring columns, each at least so wide, as far as there are columns."""
    out, first = list[tuple[int, int]](), 0
    while first < len(wide) and len(out) < count:
        last = first
        while sum(wide[first : last + 1]) < least and last + 1 < len(wide):
            last += 1
        out.append((first, last))
        first = last + 1
    return out
