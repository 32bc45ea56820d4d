"""A printed table has one row for each way from entry to exit, with its overlaps, and loses nothing by it."""

from __future__ import annotations

import csv
import io
import json
import re
from functools import cache
from pathlib import Path

import pytest

from interlock.app.init import yard
from interlock.emit.drawing import plan_svg
from interlock.emit.report import report_html
from interlock.emit.tables.document import table_json
from interlock.emit.tables.export import matrix_csv, table_csv
from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.table.columns import COLUMNS
from interlock.table.national import national_sheets
from interlock.table.printed import Printed, PrintedRoute, grouped
from interlock.table.rows import InterlockingTable, RouteRow
from tests.layouts import grown
from tests.test_runs import read_back

SWING = Path("tests/layouts_for_tests/swing.yaml").read_text("utf-8")


@cache
def station(profile: str = "generic") -> tuple[Layout, InterlockingTable]:
    """Eight tracks whose signals have overlaps over the scissors, both ways."""
    text = yard(8).replace("overlap_m: 30", "overlap_m: 200").replace("name:", f"profile: {profile}\nname:", 1)
    made = grown(text)
    assert made is not None
    return made[0], made[1]


def ways(table: InterlockingTable) -> set[tuple[object, ...]]:
    """The routes without their overlaps."""
    return {(r.kind, r.entry, r.exit, r.path.traversals) for r in table.routes}


def lines(text: str) -> list[list[str]]:
    """The rows below the headings."""
    return list(csv.reader(io.StringIO(text)))[1:]


def test_a_row_for_each_way_with_its_overlaps() -> None:
    layout, table = station()
    assert (len(table.routes), len(ways(table))) == (128, 68)
    printed = lines(table_csv(table))
    assert len(printed) == 68 and len({row[1] for row in printed}) == 68
    assert len(json.loads(table_json(layout, table))["routes"]) == 128
    row = next(row for row in printed if row[1] == "HE1-SW1")
    cell = dict(zip((c.key for c in COLUMNS), row, strict=True))
    assert cell["overlap"] == "o1: Wf1n, Wf1, Ws1, Wa1; o2: Wf1n, Wf1, Ws1, Ws2", cell["overlap"]
    assert cell["overlap_points"].startswith("o1: ") and "; o2: " in cell["overlap_points"]
    assert re.fullmatch(r"o1: \d+; o2: \d+", cell["number"]) and cell["kind"] == "main"
    same = re.search(r"(?:^|[,;] )same entry: (.*?)(?:, |;|$)", cell["hostile"])
    assert same is not None and "HE1-SW1 with another overlap" in same[1].split(" + ")


@pytest.mark.parametrize("profile", ["generic", "uk", "de", "cn"])
def test_every_national_form_has_a_row_for_each_way(profile: str) -> None:
    layout, table = station(profile)
    for sheet in national_sheets(layout, table):
        if sheet.of_routes and sheet.rows:
            assert len(sheet.rows) == len(ways(table)), sheet.key
    if profile == "de":
        form = {s.key: s for s in national_sheets(layout, table)}
        row = next(r for r in form["de_sslz"].rows if r[-1] == "HE1-SW1")
        locking = next(r for r in form["de_verschluss"].rows if r[0] == "HE1-SW1")
        assert row[5] == "D1*, D2" and re.search(r"D1: .*; D2: ", locking[3])
        assert {"D1", "D2"} == {r[1] for r in form["de_ssld"].rows if r[0] == "SW1"}


def holds(way: PrintedRoute, r: RouteRow, column: int) -> list[str]:
    """What a printed cell says of one route."""
    found = [p for p in COLUMNS[column].parts(way) if p.row in (None, r)]
    return sorted(text for p in found for text, _ in p.items)


@pytest.mark.parametrize("profile", ["uk", "de"])
def test_nothing_is_lost_in_a_row(profile: str) -> None:
    _, table = station(profile)
    printed = Printed(table)
    assert sum(len(w.rows) for w in printed.all) == len(table.routes)
    changed = {"route", "names", "hostile"}
    for way in printed.all:
        for r in way.rows:
            for k, c in enumerate(COLUMNS):
                if c.key not in changed:
                    assert holds(way, r, k) == sorted(t for t, _ in c.items(r)), (r.id, c.key)


def test_hostile_routes_of_a_row_are_those_of_its_routes() -> None:
    _, table = station()
    printed = Printed(table)
    column = next(k for k, c in enumerate(COLUMNS) if c.key == "hostile")
    for way in printed.all:
        for r in way.rows:
            told = grouped([(h.route, h.kind) for h in r.locking.hostile], printed.ways, r)
            meant = {q.id for x in told for q in x.way.rows if q is not r and (x.whole or q.id == x.route)}
            assert meant == set(r.locking.hostile.routes), r.id
            names = {x.name() for x in told if x.way is not way}
            assert names == {re.sub(r" \(.*", "", t) for t in holds(way, r, column) if "another overlap" not in t}


def test_the_printed_cell_says_each_reason_once_with_all_its_routes() -> None:
    _, table = station()
    column = next(c for c in COLUMNS if c.key == "hostile")
    for way in Printed(table).all:
        for part, text in zip(column.parts(way), column.printed(way).split("; "), strict=True):
            text = text.removeprefix(f"{way.mark(part.row)}: ") if part.row else text
            groups = [g.partition(": ") for g in text.split(", ")]
            assert len({kind for kind, _, _ in groups}) == len(groups)
            said = sorted(f"{name} ({kind})" for kind, _, names in groups for name in read_back(names.split(" + ")))
            assert said == sorted(t for t, _ in part.items), way.id


def test_one_overlap_of_a_way_is_named_with_its_mark() -> None:
    made = grown(SWING)
    assert made is not None
    table = made[1]
    hostile = next(c for c in COLUMNS if c.key == "hostile")
    way = Printed(table).ways[next(r.id for r in table.routes if r.id == "X8-E")]
    assert hostile.printed(way).startswith("overlap: X2-X3.o1, points")
    assert "X2-X3.o2" not in hostile.printed(way)
    assert "X2-X3 (overlap)" in hostile.text(way.rows[0]), "by itself a route is named as the controller does"


def test_matrices_and_report_have_a_row_for_each_way() -> None:
    layout, table = station()
    first = [row[0] for row in csv.reader(io.StringIO(matrix_csv(table))) if row]
    assert first.index("M.M^T (all routes)") == 2 + len(ways(table))
    page = report_html(layout, table, plan_svg(layout), [], [], {}, {}, "")
    body = page[page.index('<tbody id="routes">') : page.index("</tbody>")]
    assert body.count("<tr ") == len(ways(table)) and "68 routes, 128 with their overlaps" in page
    marks = set(re.findall(r'data-route="(\d+)"', body))
    assert marks == {str(r.number - 1) for w in Printed(table).all if w.several for r in w.rows}


def test_a_way_that_is_not_listed_is_not_listed_with_any_overlap() -> None:
    made = grown(SWING + "routes:\n  in: {from: X2, to: X3, listed: no}\n")
    assert made is not None
    table = made[1]
    assert [r.id for r in table.routes if not r.listed] == ["X2-X3", "X2-X3.o2"]
    printed = lines(table_csv(table))
    assert printed[-1][1] == "1 more route is not listed" and not any(row[1] == "X2-X3" for row in printed)


def test_the_american_sheet_names_the_overlap_with_which_alone_a_signal_conflicts() -> None:
    """B stood for B-Z.o2, as if every route from it were locked; B-Z with its first overlap is not."""
    text = Path("tests/layouts_for_tests/overlap_inside.yaml").read_text("utf-8")
    made = grown(re.sub(r"(?m)^profile:.*\n", "", text))
    assert made is not None
    layout, table, _ = made
    assert {r.id for r in table.routes if r.entry == "B"} >= {"B-Z", "B-Z.o2"}
    assert "B-Z" not in table.route[RouteId("X-E")].locking.hostile.routes
    sheet = next(s for s in national_sheets(layout, table) if s.key == "us_locking")
    heads = [h.en for h in sheet.headings]
    locked = {
        row[heads.index("Route")]: row[heads.index("Opposing and conflicting signals locked")] for row in sheet.rows
    }
    assert (locked["X-E"], locked["A-X"]) == ("Z, B-Z.o2", "o2: Z, B-Z.o2")
    assert [sign for sign, _ in sheet.legend] == ["A-X.o2"]
