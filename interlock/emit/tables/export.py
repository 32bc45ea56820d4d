"""The table in every file format; the same input gives the same bytes."""

from __future__ import annotations

import csv
import io
import json
import zipfile
from dataclasses import asdict
from datetime import datetime

import xlsxwriter
from xlsxwriter.format import Format
from xlsxwriter.worksheet import Worksheet

from interlock.model.layout import Layout
from interlock.table.columns import COLUMNS, VOYAGE_COLUMNS
from interlock.table.matrix import Matrix, beyond_matrix, matrix
from interlock.table.national import Sheet, national_sheets
from interlock.table.printed import Printed
from interlock.table.rows import SCHEMA_VERSION, InterlockingTable

SCHEMA = f"interlock-table/{SCHEMA_VERSION}"

TOPOLOGY = ("sections", "edges", "points", "crossings", "signals", "boundaries", "buffers", "devices")
"""What a reader of the table needs of the layout: the graph in which its nodes, edges and sections are found."""


def table_json(layout: Layout, table: InterlockingTable) -> str:
    """Canonical JSON with a versioned schema (`schema.py`); every derived cell carries rule and text of its reason."""
    topology = {kind: [asdict(x) for x in getattr(layout, kind)] for kind in TOPOLOGY}
    body = {"schema": SCHEMA, **asdict(table), "topology": topology}
    for row, r in zip(body["routes"], table.routes, strict=True):
        row["hostile"] = [asdict(h) for h in r.hostile]
    return json.dumps(body, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def table_csv(table: InterlockingTable) -> str:
    """One line for each way from entry to exit, with its overlaps; English headings."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([c.en for c in COLUMNS])
    writer.writerows(_printed(table))
    return out.getvalue()


def _printed(table: InterlockingTable) -> list[list[str]]:
    """The rows of the routes that are listed, and one that tells how many are not."""
    printed = Printed(table)
    rows = [[c.printed(w) for c in COLUMNS] for w in printed.listed]
    if printed.unlisted:
        rows.append(["", f"{printed.unlisted} more routes are not listed", *[""] * (len(COLUMNS) - 2)])
    return rows


def voyages_csv(table: InterlockingTable) -> str:
    """One line per voyage; empty without voyages."""
    if not table.voyages:
        return ""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([c.en for c in VOYAGE_COLUMNS])
    writer.writerows([c.text(v) for c in VOYAGE_COLUMNS] for v in table.voyages)
    return out.getvalue()


def sheet_csv(sheet: Sheet) -> str:
    """A national form: headings in the language of its railway, one line per row, every column of the form.

    A Chinese one begins with a byte order mark, without which spreadsheets there misread it.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([h.native(sheet.language) for h in sheet.headings])
    writer.writerows(sheet.rows)
    return ("\ufeff" if sheet.language == "zh" else "") + out.getvalue()


def _matrix_rows(
    name: str, rows: tuple[str, ...], columns: tuple[str, ...], cells: tuple[tuple[int, ...], ...]
) -> list[list[str]]:
    body = [[r, *map(str, line)] for r, line in zip(rows, cells, strict=True)]
    return [[name, *columns], *body, []]


def _matrices(table: InterlockingTable) -> list[list[str]]:
    rows: list[list[str]] = []
    parts: list[tuple[str, Matrix]] = [("all routes", matrix(table))]
    named = matrix(table, named_only=True)
    if named.routes:
        parts.append(("named routes", named))
    for title, m in parts:
        rows += _matrix_rows(f"M ({title})", m.routes, m.sections, m.rows)
        rows += _matrix_rows(f"M.M^T ({title})", m.routes, m.routes, m.m_mt())
        rows += _matrix_rows(f"M^T.M ({title})", m.sections, m.sections, m.mt_m())
    beyond = beyond_matrix(table)
    rows.append(["Hostile pairs that M.M^T does not show", str(len(beyond))])
    rows += [[b.a, b.b, b.kind, b.witness] for b in beyond]
    return rows


def matrix_csv(table: InterlockingTable) -> str:
    """M, M.M^T and M^T.M of document A, and the hostile pairs that they miss."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(_matrices(table))
    return out.getvalue()


def _reasons(why: Worksheet, table: InterlockingTable, head: Format, cell: Format) -> None:
    """Rule and reason of every printed cell."""
    for x, (title, width) in enumerate((("Route", 14), ("Column", 20), ("Item", 30), ("Rule", 8), ("Reason", 90))):
        why.set_column(x, x, width)
        why.write_string(0, x, title, head)
    line = 1
    for way in Printed(table).all:
        for c in COLUMNS:
            for part in c.parts(way):
                route = way.id if part.row is None else f"{way.id}.{way.mark(part.row)}"
                for text, because in part.items:
                    for x, value in enumerate((route, c.en, text, because.rule, because.text)):
                        why.write_string(line, x, value, cell)
                    line += 1


def table_xlsx(layout: Layout, table: InterlockingTable) -> bytes:
    """A workbook: table, reasons, matrices.  Dates are fixed, so that the bytes are reproducible."""
    out = io.BytesIO()
    with xlsxwriter.Workbook(out, {"in_memory": True}) as book:
        book.set_properties({"title": f"Interlocking table {layout.name}", "created": datetime(2000, 1, 1)})
        head = book.add_format({"bold": True, "text_wrap": True, "valign": "top", "bottom": 1})
        cell = book.add_format({"text_wrap": True, "valign": "top"})
        sheet = book.add_worksheet("Table")
        sheet.set_landscape()
        sheet.set_paper(8)
        sheet.fit_to_pages(1, 0)
        sheet.repeat_rows(0)
        sheet.freeze_panes(1, 2)
        printed = _printed(table)
        for x, c in enumerate(COLUMNS):
            width = max([len(c.en), *(len(row[x]) for row in printed)], default=10)
            sheet.set_column(x, x, min(34, max(6, width + 1)))
            sheet.write_string(0, x, f"{c.en}\n{c.zh}", head)
            for y, row in enumerate(printed, 1):
                sheet.write_string(y, x, row[x], cell)
        if table.voyages:
            page = book.add_worksheet("Voyages")
            for x, v in enumerate(VOYAGE_COLUMNS):
                page.set_column(x, x, min(60, max([len(v.en), *(len(v.text(row)) for row in table.voyages)]) + 1))
                page.write_string(0, x, f"{v.en}\n{v.zh}", head)
                for y, voyage in enumerate(table.voyages, 1):
                    page.write_string(y, x, v.text(voyage), cell)
        for form in map(Sheet.printed, national_sheets(layout, table)):
            page = book.add_worksheet(form.key)
            page.set_landscape()
            page.set_paper(8)
            page.fit_to_pages(1, 0)
            page.repeat_rows(0)
            page.freeze_panes(1, 2)
            for x, h in enumerate(form.headings):
                width = max([8, *(len(row[x]) for row in form.rows)])
                page.set_column(x, x, min(34, width + 1))
                native = h.native(form.language)
                page.write_string(0, x, native if native == h.en else f"{native}\n{h.en}", head)
            for y, cells in enumerate(form.rows, 1):
                for x, value in enumerate(cells):
                    page.write_string(y, x, value, cell)
        _reasons(book.add_worksheet("Reasons"), table, head, cell)
        sheet = book.add_worksheet("Matrices")
        for y, row in enumerate(_matrices(table)):
            for x, value in enumerate(row):
                if value.isdigit() and x:
                    sheet.write_number(y, x, int(value))
                else:
                    sheet.write_string(y, x, value)
    return reproducible(out.getvalue())


def reproducible(data: bytes) -> bytes:
    """The same archive without compression and with fixed dates: equal bytes whatever zlib the machine has."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as new:
        for item in old.infolist():
            new.writestr(zipfile.ZipInfo(item.filename, (2000, 1, 1, 0, 0, 0)), old.read(item))
    return out.getvalue()
