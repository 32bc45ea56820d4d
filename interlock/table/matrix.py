"""The route-section matrix M of document A, with M.M^T and M^T.M, and what they miss.

M has a row for each route and a column for each section; M.M^T counts shared sections of two routes;
the diagonal of M^T.M counts the routes over a section.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from interlock.dataclass import dataclass
from interlock.model.elements import RouteId, SectionId
from interlock.table.cells import Hostile
from interlock.table.printed import Printed, PrintedRoute, grouped
from interlock.table.rows import InterlockingTable
from interlock.table.runs import natural


@dataclass(frozen=True)
class Matrix:
    """M with its labels."""

    routes: tuple[str, ...]
    sections: tuple[SectionId, ...]
    rows: tuple[tuple[int, ...], ...]

    def m_mt(self) -> tuple[tuple[int, ...], ...]:
        """Shared sections of every pair of routes."""
        return _products(self.rows)

    def mt_m(self) -> tuple[tuple[int, ...], ...]:
        """Shared routes of every pair of sections."""
        return _products(tuple(zip(*self.rows, strict=True)))


def _products(rows: tuple[tuple[int, ...], ...]) -> tuple[tuple[int, ...], ...]:
    """In how many columns two rows of zeros and ones have both a one, for every two rows."""
    bits = [int("0" + "".join(map(str, row)), 2) for row in rows]
    return tuple(tuple((a & b).bit_count() for b in bits) for a in bits)


def matrix(table: InterlockingTable, named_only: bool = False) -> Matrix:
    """M over all ways from entry to exit, or over the routes that the layout names.

    Overlaps are no part of M: the routes over one way, which differ in nothing else, have one row.
    """
    sections = tuple(sorted({s for r in table.routes for s in r.path.section_ids}, key=natural))
    picked: list[tuple[str, set[SectionId]]] = []
    for way in Printed(table).all:
        for n in [n for r in way.rows for n in r.names] if named_only else [way.id]:
            picked.append((n, set(way.rows[0].path.section_ids)))
    if named_only:
        picked.sort(key=lambda x: natural(x[0]))
    return Matrix(
        tuple(n for n, _ in picked), sections, tuple(tuple(int(s in used) for s in sections) for _, used in picked)
    )


@dataclass(frozen=True)
class Beyond:
    """A hostile pair for which M.M^T is 0: ways with all of their overlaps, or each with one (`A-B.o1`)."""

    a: str
    b: str
    kind: str
    witness: str


def beyond_matrix(table: InterlockingTable) -> tuple[Beyond, ...]:
    """Hostile pairs that share no section, so that M.M^T does not show them."""
    found: dict[tuple[RouteId, RouteId, str], dict[RouteId, list[Hostile]]] = {}
    ways = Printed(table).ways
    over = {r.id: frozenset(r.path.section_ids) for r in table.routes}
    for r in table.routes:
        for h in r.locking.hostile:
            a, b = ways[r.id].rows[0], ways[h.route].rows[0]
            if a.number < b.number and over[a.id].isdisjoint(over[b.id]):
                found.setdefault((a.id, b.id, str(h.kind)), {}).setdefault(r.id, []).append(h)
    return tuple(x for (way, _, kind), those in found.items() for x in _named(ways, ways[way], kind, those))


def _named(
    ways: Mapping[RouteId, PrintedRoute], way: PrintedRoute, kind: str, those: Mapping[RouteId, list[Hostile]]
) -> Iterator[Beyond]:
    """The pairs of two ways, hostile in one manner: as few names as say of which overlaps that is so."""
    alike: dict[tuple[RouteId, ...], list[RouteId]] = {}
    for route, hostile in those.items():
        alike.setdefault(tuple(h.route for h in hostile), []).append(route)
    for routes in alike.values():
        others = grouped([(h.route, kind) for h in those[routes[0]]], ways)
        for one in grouped([(r, kind) for r in routes], ways):
            for other in others:
                why = next(h.witness for h in those[one.route] if h.route == other.route)
                yield Beyond(one.name(), other.name(), kind, why)
