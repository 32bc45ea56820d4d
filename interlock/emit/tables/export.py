"""The table in every file format; the same input gives the same bytes."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator

from interlock.table.columns import COLUMNS, VOYAGE_COLUMNS
from interlock.table.matrix import Matrix, beyond_matrix, matrix
from interlock.table.national import Sheet
from interlock.table.printed import Printed
from interlock.table.rows import InterlockingTable


def table_csv(table: InterlockingTable) -> str:
    """One line for each way from entry to exit, with its overlaps; English headings."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([c.en for c in COLUMNS])
    writer.writerows(printed_rows(table))
    return out.getvalue()


def printed_rows(table: InterlockingTable) -> list[list[str]]:
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


def matrix_rows(table: InterlockingTable) -> list[list[str]]:
    """M, M.M^T and M^T.M of document A, and the hostile pairs that they miss, as lines."""
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
    csv.writer(out, lineterminator="\n").writerows(matrix_rows(table))
    return out.getvalue()


def reason_rows(table: InterlockingTable, pairs: bool = True) -> Iterator[tuple[str, ...]]:
    """Route, column, item, rule and reason of every printed cell; with `pairs`, of hostile routes, too."""
    for way in Printed(table).all:
        for c in COLUMNS:
            for part in c.parts(way) if pairs or c.key != "hostile" else ():
                route = way.id if part.row is None else f"{way.id}.{way.mark(part.row)}"
                for text, because in part.items:
                    yield route, c.en, text, because.rule, because.text
