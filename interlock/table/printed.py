"""Routes as they are printed: one row for each way from entry to exit, with all overlaps that it may have.

The table has a route for each overlap of a way (R4), since each is asked for, locked and proved by itself.  A printed
table has one row for the way: what holds with every overlap stands once, what holds with one of them stands behind its
mark (`o2: ...`).  Another route is named by its way where all of its overlaps are meant, and with an overlap (`A-B.o2`;
the first one, too: `A-B.o1`) where some are.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import Generic, TypeVar

from interlock.dataclass import dataclass
from interlock.model.elements import RouteId
from interlock.table.cells import RouteKind
from interlock.table.rows import InterlockingTable, RouteRow

T = TypeVar("T")


@dataclass(frozen=True)
class PrintedRoute:
    """One printed row: the routes over one way, which differ in their overlaps alone, in order of number."""

    rows: tuple[RouteRow, ...]
    ways: Mapping[RouteId, PrintedRoute] = field(repr=False, compare=False)
    """The printed row of every route of the table."""

    @property
    def several(self) -> bool:
        """Whether there are overlaps to choose from."""
        return len(self.rows) > 1

    @cached_property
    def id(self) -> str:
        """The way's name: the route's own where it has one overlap or none."""
        first = self.rows[0]
        if not self.several or first.locking.overlap is None or first.locking.overlap.option == 1:
            return first.id
        return first.id.removesuffix(f".o{first.locking.overlap.option}")

    def mark(self, r: RouteRow) -> str:
        """Which of several overlaps a route has; empty where there is no choice."""
        return f"o{r.locking.overlap.option}" if self.several and r.locking.overlap is not None else ""


@dataclass(frozen=True)
class Part(Generic[T]):
    """A part of a cell: `row` is None for what holds with every overlap."""

    row: RouteRow | None
    items: tuple[T, ...]


def parts(
    cells: Sequence[tuple[RouteRow, Sequence[T]]], key: Callable[[T], Hashable] = lambda x: x, apart: bool = False
) -> tuple[Part[T], ...]:
    """What all rows of a way have in common, and then what each has besides.

    apart: a row's items belong together; they stand once only where all rows have the very same.
    """
    keys = [[key(x) for x in items] for _, items in cells]
    if all(k == keys[0] for k in keys):
        return (Part(None, tuple(cells[0][1])),)
    common = set() if apart else set.intersection(*map(set, keys))
    first = Part(None, tuple(x for x in cells[0][1] if key(x) in common))
    own = (Part(r, tuple(x for x in items if key(x) not in common)) for r, items in cells)
    return tuple(p for p in (first, *own) if p.items)


def joined(cell: Sequence[Part[str]], mark: Callable[[RouteRow], str], separator: str = ", ") -> str:
    """The text of a cell: `q1, q2; o1: q3; o2: q4`."""
    texts = (separator.join(p.items) for p in cell)
    marks = ("" if p.row is None else f"{mark(p.row)}: " for p in cell)
    return "; ".join(f"{m}{t}" for m, t in zip(marks, texts, strict=True))


def unlisted(rows: int) -> str:
    """So many rows are not printed, in English."""
    return f"{rows} more routes are not listed" if rows > 1 else "1 more route is not listed"


@dataclass(frozen=True)
class Printed:
    """A table as it is printed."""

    table: InterlockingTable

    @cached_property
    def ways(self) -> Mapping[RouteId, PrintedRoute]:
        """The printed row of every route."""
        found: dict[tuple[str, RouteKind, str, int, RouteId | None], list[RouteRow]] = {}
        for r in self.table.routes:
            found.setdefault((r.entry, r.kind, r.exit, r.path.variant, r.path.onward), []).append(r)
        out: dict[RouteId, PrintedRoute] = {}
        for rows in found.values():
            way = PrintedRoute(tuple(rows), out)
            out.update((r.id, way) for r in rows)
        return out

    @cached_property
    def all(self) -> tuple[PrintedRoute, ...]:
        """All printed rows, in order of number, those that are not listed among them."""
        return tuple(w for r in self.table.routes if (w := self.ways[r.id]).rows[0] is r)

    @cached_property
    def listed(self) -> tuple[PrintedRoute, ...]:
        """The rows of the routes that are listed."""
        return tuple(w for w in self.all if w.rows[0].listed)

    @property
    def unlisted(self) -> int:
        """How many rows are not printed."""
        return len(self.all) - len(self.listed)


@dataclass(frozen=True)
class Said(Generic[T]):
    """Something said of another route: of its way with every overlap (`whole`), or of the one with this overlap."""

    way: PrintedRoute
    route: RouteId
    whole: bool
    what: T

    def name(self, of: Callable[[PrintedRoute], str] = lambda w: w.id) -> str:
        """The other route as it is printed."""
        mark = "" if self.whole else self.way.mark(next(r for r in self.way.rows if r.id == self.route))
        return f"{of(self.way)}.{mark}" if mark else of(self.way)


def grouped(
    said: Iterable[tuple[RouteId, T]], ways: Mapping[RouteId, PrintedRoute], by: RouteRow | None = None
) -> list[Said[T]]:
    """What is said of routes, way by way where the same is said of all overlaps of a way.

    by: the route of which nothing is said, since it is the one that says it.
    """
    found: dict[tuple[int, T], list[RouteId]] = {}
    for route, what in said:
        found.setdefault((id(ways[route]), what), []).append(route)
    out: list[Said[T]] = []
    for (_, what), routes in found.items():
        way = ways[routes[0]]
        whole = len(routes) == sum(r is not by for r in way.rows)
        out += [Said(way, route, whole, what) for route in (routes[:1] if whole else routes)]
    return out
