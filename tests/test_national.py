"""National forms: the printed notation, row by row."""

from __future__ import annotations

import json

import pytest

from interlock.emit.tables.railml import railml_json
from interlock.table.national import SHEETS, national_sheets
from tests.layouts import SHIPPED, built


def rows() -> tuple[tuple[str, ...], ...]:
    layout, table, _ = built("cn6502")
    (sheet,) = national_sheets(layout, table)
    return sheet.rows


def chinese() -> dict[tuple[str, str, str], tuple[str, ...]]:
    """The rows by signal, route and alternative; departures from one track to two lines come last first."""
    return {(r[5], r[1], r[2]): r for r in rows()}


@pytest.mark.parametrize(
    ("signal", "route", "way", "points", "hostile", "sections"),
    [
        (
            "X",
            "至I股道",
            "1",
            "5/7、1/3、9/11、13/15、17/19、23/25",
            "D3、D7、D9、D13、D17",
            "IAG、5DG、3DG、9-15DG、17-23DG、IG",
        ),
        (
            "X",
            "至5股道",
            "1",
            "(5/7)、13/15、9/11、(21)",
            "D3、D11、S5D",
            "IAG、5DG、<1/3>3DG、7DG、11-13DG、21DG、<23/25>25DG、5G",
        ),
        (
            "X",
            "至5股道",
            "2",
            "5/7、1/3、(9/11)、[13/15]、(21)",
            "D3、D7、D9、S5D",
            "IAG、5DG、3DG、9-15DG、11-13DG、21DG、<23/25>25DG、5G",
        ),
        (
            "XD",
            "至4股道",
            "",
            "5/7、(13/15)、[9/11]、(17/19)、{23/25}、(27)",
            "D11、D13、S4L",
            "7DG、11-13DG、9-15DG、17-23DG、19-27DG、4G",
        ),
        ("SII", "由II股道", "1", "27、17/19、1/3", "D1、D5、D15", "19-27DG、1/19WG、1DG、IIAG"),
        ("D1", "至D9", "", "(1/3)", "D7、<(1/3)>S5L、SIIIL、SIIL、S4L", "1DG、3DG、<5/7>5DG"),
        ("D5", "向D1", "", "1/3", "D1、<1/3>SIIL、S4L", "1DG"),
        ("D13", "至I股道", "", "17/19、23/25", "D17、<17/19>XD、X", "17-23DG"),
        ("S4", "至D5", "", "(27)、17/19", "D15、<1/3>D1", "19-27DG"),
    ],
)
def test_rows_of_the_chinese_table(signal: str, route: str, way: str, points: str, hostile: str, sections: str) -> None:
    row = chinese()[signal, route, way]
    assert (row[8], row[9], row[10]) == (points, hostile, sections)


def test_counts_and_order_of_the_chinese_table() -> None:
    printed = list(rows())
    assert [r[14] for r in printed] == [str(n) for n in range(1, len(printed) + 1)]
    trains = [r for r in printed if r[0] != "调车"]
    # fifteen receiving routes (none onto track II) and twelve departures
    assert sum("接车" in r[0] for r in trains) == 15 and sum("发车" in r[0] for r in trains) == 12
    assert printed.index(trains[-1]) == len(trains) - 1  # train routes first
    assert all(r[6] == "B" for r in printed[len(trains) :])


def test_buttons_aspects_and_facing_routes() -> None:
    table = chinese()
    assert table["X", "至5股道", "1"][3] == "XLA、S5LA" and table["SII", "由II股道", "1"][3] == "SIILA、SLZA"
    assert table["D1", "至D15", ""][3] == "D1A、D5A"  # signals back to back share their buttons
    assert table["X", "至I股道", "1"][6] == "U" and table["X", "至4股道", "1"][6] == "UU"
    assert table["X", "至I股道", "1"][11:13] == ("", "IG") and table["X", "至5股道", "1"][11:13] == ("5G", "5G")
    assert table["S5", "由5股道", ""][13] in ("BS", "")


@pytest.mark.parametrize("name", SHIPPED)
def test_every_form_is_a_rectangle_and_names_every_route(name: str) -> None:
    layout, table, _ = built(name)
    sheets = national_sheets(layout, table)
    assert len(sheets) == len(SHEETS.get(layout.profile, ()))
    for sheet in sheets:
        assert all(len(r) == len(sheet.headings) for r in sheet.rows), sheet.key
    body = json.loads(railml_json(layout, table))
    assert [r["id"] for r in body["routes"]] == [r.id for r in table.routes]
    assert {c["refersToRoute"] for c in body["conflictingRoutes"]} == {r.id for r in table.routes}


def test_british_points_lock_against_what_a_route_calls() -> None:
    layout, table, _ = built("junction")
    routes, points = national_sheets(layout, table)
    names = {r[0] for r in routes.rows}
    for row in points.rows:
        calls_reverse, needs_normal = set(row[1].split(", ")), set(row[2].split(", "))
        assert {n.split(".o")[0] for n in calls_reverse | needs_normal} <= names and not calls_reverse & needs_normal
        assert row[2] == row[3] and row[1] == row[4]
