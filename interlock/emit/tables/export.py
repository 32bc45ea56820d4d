"""The table in every file format; the same input gives the same bytes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from interlock.spreadsheet import csv_text
from interlock.table.columns import COLUMNS, VOYAGE_COLUMNS
from interlock.table.matrix import Matrix, beyond_matrix, matrix
from interlock.table.national import Sheet
from interlock.table.printed import Printed, unlisted
from interlock.table.rows import InterlockingTable
from interlock.table.runs import MEANING, in_runs


def table_csv(table: InterlockingTable) -> str:
    """One line for each way from entry to exit, with its overlaps; English headings."""
    return csv_text([[c.en for c in COLUMNS], *printed_rows(table)])


def printed_rows(table: InterlockingTable) -> list[list[str]]:
    """The rows of the routes that are listed, and one that tells how many are not."""
    printed = Printed(table)
    rows = [[c.printed(w) for c in COLUMNS] for w in printed.listed]
    if printed.unlisted:
        rows.append(["", unlisted(printed.unlisted), *[""] * (len(COLUMNS) - 2)])
    return rows


def voyages_csv(table: InterlockingTable) -> str:
    """One line per voyage; empty without voyages."""
    if not table.voyages:
        return ""
    return csv_text([[c.en for c in VOYAGE_COLUMNS], *([c.text(v) for c in VOYAGE_COLUMNS] for v in table.voyages)])


def sheet_csv(sheet: Sheet) -> str:
    """A national form: headings in the language of its railway, one line per row, every column of the form.

    A Chinese one begins with a byte order mark, without which spreadsheets there misread it.
    """
    text = csv_text([[h.native(sheet.language) for h in sheet.headings], *sheet.rows])
    return f"\ufeff{text}" if sheet.language == "zh" else text


def _matrix_rows(
    name: str, rows: tuple[str, ...], columns: tuple[str, ...], cells: tuple[tuple[int, ...], ...], half: bool = False
) -> list[list[str]]:
    """A matrix with its labels; half: what stands below the diagonal of a symmetric one is left empty, as zeros are."""
    body = [
        [r, *("" if (half and x < y) or not value else str(value) for x, value in enumerate(line))]
        for y, (r, line) in enumerate(zip(rows, cells, strict=True))
    ]
    return [[name, *columns], *body, []]


LARGE = 200  # rows: from here on a matrix is a list of what is not 0
EMPTY_IS_ZERO = "Empty cells are 0; M.M^T and M^T.M are symmetric, and only their upper half is written"
LISTED = "What is not listed is 0; M.M^T and M^T.M are symmetric, and only their upper half is written; S1 to S9: {}"


def _listed(name: str, what: str, rows: Sequence[str], cells: Sequence[Sequence[int]]) -> list[list[str]]:
    """The upper half of a large symmetric matrix: for each row the numbers in it, and where they stand."""
    out = [[name, what, "With"]]
    for y, line in enumerate(cells):
        places: dict[int, list[str]] = {}
        for x, value in enumerate(line[y:], y):
            if value:
                places.setdefault(value, []).append(rows[x])
        out += [
            [rows[y], str(value), ", ".join(in_runs(names))] for value, names in sorted(places.items(), reverse=True)
        ]
    return [*out, []]


def _of_matrix(title: str, m: Matrix) -> list[list[str]]:
    """M and its products; of many routes as lists."""
    if len(m.routes) <= LARGE:
        return [
            *_matrix_rows(f"M ({title})", m.routes, m.sections, m.rows),
            *_matrix_rows(f"M.M^T ({title})", m.routes, m.routes, m.m_mt(), half=True),
            *_matrix_rows(f"M^T.M ({title})", m.sections, m.sections, m.mt_m(), half=True),
        ]
    over = [
        [r, ", ".join([s for s, x in zip(m.sections, line, strict=True) if x])]
        for r, line in zip(m.routes, m.rows, strict=True)
    ]
    return [
        [f"M ({title})", "Sections"],
        *over,
        [],
        *_listed(f"M.M^T ({title})", "Shared sections", m.routes, m.m_mt()),
        *_listed(f"M^T.M ({title})", "Shared routes", m.sections, m.mt_m()),
    ]


def matrix_rows(table: InterlockingTable) -> list[list[str]]:
    """M, M.M^T and M^T.M of document A, and the hostile pairs that they miss, as lines.

    Zeros, and the lower half of what is symmetric, are left empty; of more than `LARGE` routes what is not 0 is listed.
    """
    parts: list[tuple[str, Matrix]] = [("all routes", matrix(table))]
    named = matrix(table, named_only=True)
    if named.routes:
        parts.append(("named routes", named))
    large = len(parts[0][1].routes) > LARGE
    rows: list[list[str]] = [[LISTED.format(MEANING[1]) if large else EMPTY_IS_ZERO], []]
    for title, m in parts:
        rows += _of_matrix(title, m)
    beyond = beyond_matrix(table)
    rows.append(["Hostile pairs that M.M^T does not show", str(len(beyond))])
    rows += [[b.a, b.b, b.kind, b.witness] for b in beyond]
    return rows


def matrix_csv(table: InterlockingTable) -> str:
    """M, M.M^T and M^T.M of document A, and the hostile pairs that they miss."""
    return csv_text(matrix_rows(table))


def reason_rows(table: InterlockingTable, pairs: bool = True) -> Iterator[tuple[str, ...]]:
    """Column, item, rule and reason of every printed cell, once, and the routes for which it holds; with `pairs`, of
    hostile routes, too."""
    said: dict[tuple[str, str, str, str], list[str]] = {}
    for way in Printed(table).all:
        for c in COLUMNS:
            for part in c.parts(way) if pairs or c.key != "hostile" else ():
                route = way.id if part.row is None else f"{way.id}.{way.mark(part.row)}"
                for text, because in part.items:
                    said.setdefault((c.en, text, because.rule, because.text), []).append(route)
    for (column, text, rule, why), routes in said.items():
        yield column, text, rule, why, ", ".join(in_runs(routes))
