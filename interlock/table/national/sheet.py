"""A printed sheet: headings in three languages, rows of text, and what its reader must know of it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Generic, TypeVar

from interlock.dataclass import dataclass
from interlock.table.printed import PrintedRoute, joined, parts
from interlock.table.rows import RouteRow
from interlock.table.runs import natural

R = TypeVar("R")
Cell = str | tuple[str, ...]
"""A text, or a list of which some items may hold with one overlap only."""


@dataclass(frozen=True)
class Words:
    """What is said beside a table: that it has no rows, which columns it has not, and which are empty."""

    none: str
    left_out: str
    empty: str


WORDS = {
    "en": Words("none", "Columns of the form that a layout does not fill", "Empty in every row"),
    "zh": Words("无", "布置图未给出的栏", "全空的栏"),
    "de": Words("keine", "Spalten, von denen ein Layout nichts sagt", "In jeder Zeile leer"),
}


@dataclass(frozen=True)
class Heading:
    """A column's heading in English, Chinese and German.

    `mark`: the letter or number of the column in the form that the sheet follows; empty where that form has no such
    column.
    """

    en: str
    zh: str
    de: str
    mark: str = ""

    def native(self, language: str) -> str:
        """The heading in a language (en, zh, de)."""
        return {"en": self.en, "zh": self.zh, "de": self.de}[language]


@dataclass(frozen=True)
class Field(Generic[R]):
    """A column as it is computed: its heading, and the cell of one row."""

    heading: Heading
    text: Callable[[R], Cell]


@dataclass(frozen=True)
class Sheet:
    """One table as a railway prints it; `key` is part of its file name, `language` (en, zh, de) that of its cells.

    `of_routes`: it has rows for routes, and says how many of them are not listed.  `after`: the form whose columns it
    has, and where they are described.  `left_out`: columns of that form of which a layout says nothing.  `empty`:
    columns that would be empty in every row.  `legend`: signs, and what they mean.
    """

    key: str
    language: str
    title: Heading
    headings: tuple[Heading, ...]
    rows: tuple[tuple[str, ...], ...]
    of_routes: bool = False
    after: str = ""
    left_out: tuple[str, ...] = ()
    empty: tuple[str, ...] = ()
    legend: tuple[tuple[str, str], ...] = ()

    @property
    def words(self) -> Words:
        """What is said beside it, in its language."""
        return WORDS[self.language]

    def printed(self) -> Sheet:
        """Without its empty columns, which it names; of a sheet without rows nothing is left but that."""
        if not self.rows:
            return replace(self, headings=())
        full = [x for x in range(len(self.headings)) if any(row[x] for row in self.rows)]
        return replace(
            self,
            headings=tuple(self.headings[x] for x in full),
            rows=tuple(tuple(row[x] for x in full) for row in self.rows),
            empty=tuple(h.native(self.language) for x, h in enumerate(self.headings) if x not in full),
        )


def filled(fields: Iterable[Field[R]], rows: Iterable[R]) -> tuple[tuple[Heading, ...], tuple[tuple[str, ...], ...]]:
    """Headings and cells of rows."""
    columns = tuple(fields)
    cells = tuple(tuple(_text(f.text(row)) for f in columns) for row in rows)
    return tuple(f.heading for f in columns), cells


def _text(cell: Cell) -> str:
    return cell if isinstance(cell, str) else ", ".join(cell)


def by_way(
    fields: Iterable[Field[RouteRow]],
    ways: Iterable[PrintedRoute],
    mark: Callable[[PrintedRoute, RouteRow], str] = PrintedRoute.mark,
) -> tuple[tuple[Heading, ...], tuple[tuple[str, ...], ...]]:
    """Headings, and a row for each way with its overlaps, in the order in which signals are numbered."""
    columns = tuple(fields)
    listed = sorted(ways, key=lambda w: natural(w.rows[0].entry))
    return tuple(f.heading for f in columns), route_rows(listed, lambda _, r: tuple(f.text(r) for f in columns), mark)


def route_rows(
    ways: Iterable[PrintedRoute],
    cells: Callable[[PrintedRoute, RouteRow], tuple[Cell, ...]],
    mark: Callable[[PrintedRoute, RouteRow], str] = PrintedRoute.mark,
    separator: str = ", ",
) -> tuple[tuple[str, ...], ...]:
    """A row for each way; `cells`: those of each of its routes, which share them where they are the same."""
    return tuple(_row(way, cells, mark, separator) for way in ways)


def _row(
    way: PrintedRoute,
    cells: Callable[[PrintedRoute, RouteRow], tuple[Cell, ...]],
    mark: Callable[[PrintedRoute, RouteRow], str],
    separator: str,
) -> tuple[str, ...]:
    out = []
    for column in zip(*(cells(way, r) for r in way.rows), strict=True):
        items = [tuple(x for x in ((c,) if isinstance(c, str) else c) if x) for c in column]
        cell = parts(list(zip(way.rows, items, strict=True)))
        out.append(joined(cell, lambda r: mark(way, r), separator))
    return tuple(out)
