"""A printed sheet: headings in three languages and rows of text."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from interlock.table.printed import PrintedRoute, joined, parts
from interlock.table.rows import RouteRow

Cell = str | tuple[str, ...]
"""A text, or a list of which some items may hold with one overlap only."""


@dataclass(frozen=True)
class Heading:
    """A column's heading in English, Chinese and German."""

    en: str
    zh: str
    de: str


@dataclass(frozen=True)
class Sheet:
    """One table as a railway prints it; `key` is part of its file name, `language` (en, zh, de) that of its cells.

    `of_routes`: it has rows for routes, and says how many of them are not listed.
    """

    key: str
    language: str
    title: Heading
    headings: tuple[Heading, ...]
    rows: tuple[tuple[str, ...], ...]
    of_routes: bool = False


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
