"""Interlocking tables that others have published, row by row against what is derived of the same stations.

`stations/NAME.yaml` is the layout, whose routes bear the names of the published rows; `NAME.csv` what was published, as
facts; `NAME.why.yaml` the source, how its words are read, and why the two differ.  A difference that nothing explains,
and an explanation of nothing, are told (`Comparison.unexplained`, `idle`).
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import yaml

from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.table.cells import Role, RouteKind
from interlock.table.national.reading import Reading
from interlock.table.rows import InterlockingTable, RouteRow
from tests.layouts import grown

HERE = Path(__file__).resolve().parent / "stations"
STATIONS = (
    "komano",
    "shinnozaki",
    "akayama",
    "hbg",
    "railml",
    "swtbahn",
    "cranz",
    "tatehama",
    "spurs",
    "phausen",
    "edgware",
    "czbs",
    "munkerod",
    "swtbahnfull",
    "daidoji",
    "dongjiao",
    "ulanka",
    "enohara",
    "milton",
)
COLUMNS = (
    *("route", "ends", "past", "decides", "points", "flank", "driven"),
    *("overlap", "clear", "foul", "locked", "hostile", "delay"),
)
ROLES = {Role.PATH: "", Role.DEVICE: "", Role.FLANK: " (flank)", Role.ADDED: " (added)", Role.OVERLAP: " (overlap)"}


@dataclass(frozen=True)
class Difference:
    """Something that one of the two has in a column of a row, and the other has not."""

    route: str
    column: str
    side: str
    """`published` or `derived`: who has it."""
    item: str


@dataclass(frozen=True)
class Why:
    """An explanation, and which differences it is of."""

    mark: str
    column: str
    side: str
    items: str
    routes: str
    text: str

    def covers(self, d: Difference) -> bool:
        """Whether it explains a difference."""
        same = (d.column, d.side) == (self.column, self.side)
        return same and bool(re.fullmatch(self.items, d.item)) and bool(re.fullmatch(self.routes, d.route))


@dataclass(frozen=True)
class Station:
    """A published table, with what is derived of the layout."""

    name: str
    about: Mapping[str, Any]
    rows: tuple[Mapping[str, str], ...]
    layout: Layout
    table: InterlockingTable

    @property
    def columns(self) -> tuple[str, ...]:
        """The columns that were published."""
        given = {"route", "ends", *self.rows[0]} | (
            {"hostile"} if {"levers", "conflicts"} & set(self.rows[0]) else set()
        )
        return tuple(c for c in COLUMNS if c in given)

    @cached_property
    def derived(self) -> Mapping[str, RouteRow]:
        """Each derived route by the name of the row that it stands for; of several overlaps the first."""
        return {n: r for r in self.table.routes for n in r.names}

    def way(self, r: RouteRow) -> tuple[object, ...]:
        """What the routes of a row have in common that differ in their overlaps."""
        return r.kind, r.entry, *(p.path.traversals for p in self.table.parts(r))

    @cached_property
    def reading(self) -> Reading:
        """The table as national forms read it."""
        return Reading(self.layout, self.table)

    def overlaps(self, name: str) -> set[str]:
        """The overlaps of a row, each as its sections and its points: `q4+q5:P2+P3R`."""
        those = [r for r in self.table.routes if self.way(r) == self.way(self.derived[name])]
        last = [self.table.parts(r)[-1] for r in those]
        return {_overlap(r) for r in last if r.locking.overlap is not None}

    @cached_property
    def published(self) -> Mapping[str, Mapping[str, str]]:
        """Each row by its name."""
        return {self.called("route", r["route"]): r for r in self.rows}

    def called(self, column: str, word: str) -> str:
        """A word of a row as the layout writes it: some sources print numbers alone."""
        return self.about.get("prefix", {}).get(column, "") + word

    def points(self, row: Mapping[str, str]) -> set[str]:
        """The positions of a row: `41 43R` are 41 N and 43 R; some words stand for others."""
        reads = self.about.get("reads", {})
        words = [w for cell in ("points", "crossings") for w in row.get(cell, "").split()]
        return {self.position(x) for w in words for x in reads.get(w, w).split()}

    def position(self, word: str) -> str:
        return self.called("points", word[:-1] if word[-1] in "RN" else word) + (" R" if word[-1] == "R" else " N")

    def words(self, row: Mapping[str, str], column: str) -> set[str]:
        """Sections of a row."""
        return {self.called("clear", w) for w in row[column].split()}

    def sections(self, sections: Iterable[str]) -> set[str]:
        """Derived sections by the names that the source has for them: it may know larger pieces."""
        piece = re.compile(self.about.get("pieces", "(.*)"))
        return {m[1] if (m := piece.fullmatch(s)) else s for s in sections}

    def apart(self, one: str, other: str) -> bool:
        """Whether two rows are hostile as published: one names the other or its lever, or (where the source leaves
        such pairs to the points) they have a point in different positions."""
        a, b = self.published[one], self.published[other]
        if "levers" not in a:
            return other in {self.called("route", w) for w in a["conflicts"].split()}
        said = any({y["route"], y["entry"]} & set(x["levers"].split()) for x, y in ((a, b), (b, a)))
        theirs = self.points(b)
        return said or any(p[:-1] + "NR"[p[-1] == "N"] in theirs for p in self.points(a))


def _overlap(r: RouteRow) -> str:
    assert r.locking.overlap is not None
    sections = sorted(s for s, _ in r.locking.overlap.ways)
    points = sorted(
        f"{p.machine}{'R' if p.position == 'R' else ''}" for p in r.locking.points if p.role is Role.OVERLAP
    )
    return f"{'+'.join(sections)}:{'+'.join(points)}"


ADDITIONS = re.compile(r"^(exclude|demand|hostile|sections):\n((?:[ #].*\n|\n)*)", re.MULTILINE)
"""What the author of a layout says beyond its track, so that its table is the one that he has before him."""


def text_of(name: str) -> str:
    """The layout of a station."""
    return (HERE / f"{name}.yaml").read_text("utf-8")


def additions(name: str) -> dict[str, int]:
    """How many entries the layout has of each kind of addition."""
    return {m[1]: sum(line.startswith("  ") for line in m[2].splitlines()) for m in ADDITIONS.finditer(text_of(name))}


def station(name: str, bare: bool = False) -> Station:
    """A station with its published table; `bare`: without what its author adds."""
    about = yaml.safe_load((HERE / f"{name}.why.yaml").read_text("utf-8"))
    with (HERE / f"{name}.csv").open(encoding="utf-8") as file:
        rows = tuple(csv.DictReader(file))
    made = grown(ADDITIONS.sub("", text_of(name)) if bare else text_of(name))
    assert made is not None and not made[2].has_errors
    return Station(name, about, rows, made[0], made[1])


@dataclass(frozen=True)
class Comparison:
    """All differences of a station, and what explains them."""

    station: Station
    differences: tuple[Difference, ...]
    why: tuple[Why, ...]

    @property
    def unexplained(self) -> tuple[Difference, ...]:
        """Differences that nothing explains."""
        return tuple(d for d in self.differences if not any(w.covers(d) for w in self.why))

    def in_cell(self, route: str, column: str) -> tuple[tuple[Difference, str], ...]:
        """The differences of one cell, each with the mark of what explains it."""
        here = [d for d in self.differences if (d.route, d.column) == (route, column)]
        return tuple((d, next((w.mark for w in self.why if w.covers(d)), "?")) for d in here)

    @property
    def idle(self) -> tuple[Why, ...]:
        """Explanations of differences that are not there."""
        return tuple(w for w in self.why if not any(map(w.covers, self.differences)))


def compare(s: Station) -> Comparison:
    """Row by row, column by column."""
    found = [*_routes(s), *(d for n in s.published if n in s.derived for d in _row(s, n))]
    why = tuple(
        Why(w["mark"], w["column"], w["side"], str(w["items"]), str(w.get("routes", ".*")), w["why"])
        for w in s.about["differences"]
    )
    return Comparison(s, tuple(found), why)


def _routes(s: Station) -> Iterator[Difference]:
    for n in s.published:
        if n not in s.derived:
            yield Difference(n, "route", "published", n)
    told = {s.way(s.derived[n]) for n in s.published if n in s.derived}
    for r in s.table.routes:
        if r.kind is not RouteKind.IDENTIFIER and s.way(r) not in told and not set(r.names) & set(s.published):
            yield Difference(r.id, "route", "derived", r.id)


def _row(s: Station, name: str) -> Iterator[Difference]:
    row, r = s.published[name], s.derived[name]
    yield from _both(name, "ends", {s.called("entry", row["entry"])}, {str(r.entry)})
    yield from _both(name, "ends", {s.called("exit", row["exit"])}, {str(r.path.destination or r.exit)})
    yield from _more(s, name)
    roles = {f"{p.machine} {p.position}": ROLES[p.role] for p in r.locking.points} if "points" in s.columns else {}
    theirs = s.points(row)
    for d in _both(name, "points", theirs, set(roles)):
        yield Difference(name, d.column, d.side, d.item + (roles[d.item] if d.side == "derived" else ""))
    beside = () if "foul" in s.columns else r.clear.foul
    pieces = {
        "clear": {str(c.section) for c in (*r.clear.sections, *beside, *(r.clear.demanded or ()))},
        "locked": set(map(str, r.path.section_ids)),
    }
    for column, mine in pieces.items():
        if column in s.columns and row[column] != UNTOLD:
            yield from _both(name, column, s.words(row, "clear" if column == "clear" else column), s.sections(mine))
    if "delay" in s.columns:
        yield from _both(
            name, "delay", {f"{row['delay']} s"} if row["delay"] else set(), {f"{r.locking.approach.delay_s:g} s"}
        )
    if "hostile" in s.columns:
        named: dict[RouteId, str] = {x.id: n for n, x in s.derived.items()}
        mine = {named[h] for h in r.locking.hostile.routes if h in named}
        yield from _both(name, "hostile", {n for n in s.published if n != name and s.apart(name, n)}, mine)


def _more(s: Station, name: str) -> Iterator[Difference]:
    """What German tables have: signals at identifier light, deciding points, overlaps."""
    row, r = s.published[name], s.derived[name]
    if "past" in s.columns:
        yield from _both(name, "past", set(row["past"].split()), set(map(str, r.path.passed or ())))
    if "decides" in s.columns:
        chosen = {
            f"{s.layout.pointwork.point[p].machine}{'R' if x == 'R' else ''}" for p, x in s.reading.machines.deciding(r)
        }
        yield from _both(name, "decides", set(row["decides"].split()), chosen)
    if "overlap" in s.columns:
        yield from _both(name, "overlap", set(row["overlap"].split()), s.overlaps(name))
    yield from _beside(s, name)


def _beside(s: Station, name: str) -> Iterator[Difference]:
    """What Chinese tables tell apart: protecting [ ] and driven points { }, and sections beside the path, each with the
    position of a point in which it is asked for: `25DG:23/25` (<23/25>25DG)."""
    row, r = s.published[name], s.derived[name]
    mine = {
        "flank": {f"{p.machine} {p.position}" for p in r.locking.points if p.role is Role.FLANK},
        "driven": {f"{p.machine} {p.position}" for p in r.locking.driven},
    }
    for column, those in mine.items():
        if column in s.columns:
            yield from _both(name, column, {s.position(w) for w in row[column].split()}, those)
    if "foul" in s.columns:
        told = {
            f"{f.section}:{f.when[0]}{'R' * (f.when[1] == 'R')}" if f.when else str(f.section) for f in r.clear.foul
        }
        yield from _both(name, "foul", set(row["foul"].split()), told)


UNTOLD = "-"
"""A cell that this row of the source does not have."""


def _both(name: str, column: str, published: set[str], derived: set[str]) -> Iterator[Difference]:
    for side, items in (("published", published - derived), ("derived", derived - published)):
        yield from (Difference(name, column, side, i) for i in sorted(items))
