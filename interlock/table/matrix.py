"""The route-section matrix M of document A, with M.M^T and M^T.M, and what they miss.

M has a row for each route and a column for each section; M.M^T counts shared sections of two routes;
the diagonal of M^T.M counts the routes over a section.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from interlock.model.elements import RouteId, SectionId
from interlock.table.rows import InterlockingTable


@dataclass(frozen=True)
class Matrix:
    """M with its labels."""

    routes: tuple[str, ...]
    sections: tuple[SectionId, ...]
    rows: tuple[tuple[int, ...], ...]

    def m_mt(self) -> tuple[tuple[int, ...], ...]:
        """Shared sections of every pair of routes."""
        return tuple(tuple(sum(x * y for x, y in zip(a, b, strict=True)) for b in self.rows) for a in self.rows)

    def mt_m(self) -> tuple[tuple[int, ...], ...]:
        """Shared routes of every pair of sections."""
        columns = tuple(zip(*self.rows, strict=True))
        return tuple(tuple(sum(x * y for x, y in zip(a, b, strict=True)) for b in columns) for a in columns)


def _natural(name: str) -> tuple[tuple[int, int, str], ...]:
    """Sort key in which q2 comes before q10."""
    parts = re.findall(r"\d+|\D+", name)
    return tuple((0, int(p), "") if p.isdigit() else (1, 0, p) for p in parts)


def matrix(table: InterlockingTable, named_only: bool = False) -> Matrix:
    """M over all routes, or over the routes that the layout names."""
    sections = tuple(sorted({s for r in table.routes for s in r.section_ids}, key=_natural))
    picked: list[tuple[str, set[SectionId]]] = []
    for r in table.routes:
        if named_only:
            picked.extend((n, set(r.section_ids)) for n in r.names)
        else:
            picked.append((r.id, set(r.section_ids)))
    if named_only:
        picked.sort(key=lambda x: _natural(x[0]))
    return Matrix(
        tuple(n for n, _ in picked), sections, tuple(tuple(int(s in used) for s in sections) for _, used in picked)
    )


@dataclass(frozen=True)
class Beyond:
    """A hostile pair for which M.M^T is 0."""

    a: RouteId
    b: RouteId
    kind: str
    witness: str


def beyond_matrix(table: InterlockingTable) -> tuple[Beyond, ...]:
    """Hostile pairs that share no section, so that M.M^T does not show them."""
    found = []
    for r in table.routes:
        mine = set(r.section_ids)
        for h in r.hostile:
            other = table.route[h.route]
            if r.number < other.number and not mine & set(other.section_ids):
                found.append(Beyond(r.id, h.route, str(h.kind), h.witness))
    return tuple(found)
