"""Published interlocking tables of nineteen stations and lines against what is derived; every difference is explained.

[The page](../proofs/stations.md) is written by `python -m tests.campaigns.published`.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.logic.lower import lower
from interlock.proof.engines.limits import Limits
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.campaigns.published import table_lines
from tests.published import COLUMNS, STATIONS, Comparison, Station, additions, compare, station, text_of
from tests.written import told


@cache
def compared(name: str) -> Comparison:
    """A station as it is shipped for the tests."""
    return compare(station(name))


ROWS = dict(zip(STATIONS, (43, 20, 16, 12, 14, 45, 33, 8, 16, 150, 20, 26, 106, 160, 59, 54, 42, 36, 42), strict=True))


def count(c: Comparison) -> dict[str, int]:
    """Differences by column."""
    return {k: n for k in COLUMNS if (n := sum(d.column == k for d in c.differences))}


@pytest.mark.parametrize("name", STATIONS)
def test_every_difference_is_explained_and_every_explanation_is_of_one(name: str) -> None:
    c = compared(name)
    assert c.unexplained == () and c.idle == ()
    assert len(c.station.rows) == ROWS[name] and set(c.station.published) <= set(c.station.derived)
    assert audit(c.station.layout, c.station.table) == ()


@pytest.mark.parametrize("name", ["komano", "shinnozaki"])
def test_stations_are_proved_and_the_second_checker_agrees(name: str) -> None:
    """The page has all of them, certified."""
    s = compared(name).station
    assert prove(System(s.layout, lower(s.layout, s.table)), Limits(search_s=0)).proved
    assert agree(*told(text_of(name)), specification.shipped()).left == ()


def test_what_differs_and_what_does_not() -> None:
    assert count(compared("komano")) == {"ends": 24, "points": 10, "clear": 2, "locked": 28, "hostile": 12, "delay": 8}
    assert count(compared("shinnozaki")) == {"ends": 16, "points": 4, "clear": 4, "locked": 11, "delay": 8}
    assert count(compared("akayama")) == {"ends": 4, "points": 2, "clear": 1, "locked": 7, "delay": 4}
    assert count(compared("hbg")) == {"ends": 12, "points": 4}, "sidings that we drew, behind points"
    assert count(compared("railml")) == {"route": 7, "points": 4, "clear": 15}
    assert count(compared("swtbahn")) == {"points": 65}
    assert count(compared("cranz")) == {"route": 19, "points": 25, "clear": 48}
    assert count(compared("spurs")) == {"route": 1, "clear": 18}
    assert count(compared("phausen")) == {"route": 4, "past": 5, "decides": 2, "overlap": 12, "clear": 28}
    assert count(compared("edgware")) == {"route": 7, "points": 12, "hostile": 4}
    assert count(compared("czbs")) == {"route": 10, "points": 2, "clear": 5, "hostile": 4}
    assert count(compared("munkerod")) == {"route": 77, "points": 110}
    assert count(compared("swtbahnfull")) == {"points": 310}, "flank protection, and nothing else"
    assert count(compared("daidoji")) == {"ends": 36, "points": 11, "clear": 5, "delay": 18}
    assert count(compared("dongjiao")) == {"route": 2, "clear": 5, "hostile": 2}
    assert count(compared("ulanka")) == {"points": 6}
    assert count(compared("enohara")) == {"route": 11, "ends": 48, "points": 19, "clear": 1, "hostile": 8}
    assert count(compared("milton")) == {"route": 2, "points": 21, "hostile": 34}
    assert count(compared("tatehama")) == {"points": 12, "clear": 1, "locked": 4}


@pytest.mark.parametrize(("name", "conflicts"), [("swtbahn", 1004), ("swtbahnfull", 8104)])
def test_all_conflicts_of_swtbahn_are_derived_and_no_other(name: str, conflicts: int) -> None:
    s = compared(name).station
    assert (
        sum(len(r.locking.hostile) for r in s.table.routes)
        == conflicts
        == sum(len(r["conflicts"].split()) for r in s.rows)
    )


def test_all_hostile_pairs_of_the_chinese_station_are_derived_and_no_other() -> None:
    """Of 325 pairs of rows; the one that differs is that of a misprinted name."""
    s = compared("czbs").station
    pairs = {(d.route, d.item) for d in compared("czbs").differences if d.column == "hostile"}
    assert pairs == {("r11", "r13"), ("r11", "r14"), ("r13", "r11"), ("r14", "r11")}
    assert sum(len(s.derived[n].locking.hostile) for n in s.published) > 300


def test_a_chinese_throat_is_derived_whole() -> None:
    """Of 1,431 pairs of rows one differs; protecting and driven points, and joints beside the way, are as printed."""
    s = compared("dongjiao").station
    assert {"flank", "driven", "foul", "hostile"} <= set(s.columns)
    cells = [len(r[k].split()) for k in ("flank", "driven", "foul") for r in s.rows]
    assert sum(cells) == 55 and sum(s.apart(a, b) for a in s.published for b in s.published if a < b) == 860


def test_overlaps_and_deciding_points_of_the_german_example_are_those_published() -> None:
    s = compared("phausen").station
    rows = [(n, set(r["overlap"].split())) for n, r in s.published.items() if r["overlap"]]
    assert (len(rows), sum(len(o) for _, o in rows), sum(len(o & s.overlaps(n)) for n, o in rows)) == (47, 71, 65)
    assert sum(bool(r["decides"]) for r in s.rows) == 22 and count(compared("phausen"))["decides"] == 2  # one misprint


def test_what_the_author_of_komano_adds_is_what_the_table_has_beyond_the_track() -> None:
    assert additions("komano") == {"exclude": 4, "demand": 11, "hostile": 16, "sections": 8}
    bare, full = compare(station("komano", bare=True)), compared("komano")
    assert {d.column for d in bare.unexplained} == {"route", "points", "clear", "hostile"}
    assert not [d for d in bare.unexplained if d.side == "derived" and d.column != "route"], "additions only restrict"
    assert count(bare)["hostile"] > 5 * count(full)["hostile"]


def changed(name: str, route: str, column: str, cell: str) -> Station:
    """A station whose source had another word in one cell."""
    s = station(name)
    return replace(s, rows=tuple({**r, column: cell} if r["route"] == route else r for r in s.rows))


@pytest.mark.parametrize(
    ("name", "route", "column", "cell"),
    [
        ("komano", "5RA", "points", "46 49"),
        ("komano", "9LC", "clear", "9LT 50ﾛT"),
        ("komano", "9LC", "locked", "9LT 9LCT"),
        ("komano", "24R", "levers", "7R 15L 34L 2L"),
        ("komano", "6L", "delay", "30"),
        ("komano", "6L", "exit", "TO"),
        ("shinnozaki", "4LZ", "levers", "4L 6R 21L"),
        ("akayama", "2RA", "clear", "2RT 21T 2RAT"),
        ("hbg", "a3", "points", "W1 W2a W2bR W7b"),
        ("railml", "R_06", "crossings", ""),
        ("swtbahn", "44", "conflicts", "6"),
        ("swtbahn", "44", "clear", "2 1 3"),
        ("cranz", "R_09", "points", "Sw06R Sw07RR"),
        ("cranz", "R_01", "crossings", ""),
        ("cranz", "R_12", "route", "R_99"),
        ("spurs", "R_07", "clear", "41"),
        ("tatehama", "5LB", "points", "27R 26 25 24 23"),
        ("phausen", "60G/60ZV4", "decides", "60W34R"),
        ("phausen", "60G/60P13", "past", ""),
        ("phausen", "60ZR3/60N21", "overlap", "60G221:60W35"),
        ("phausen", "60LW52X/60L124X R", "clear", "60W24"),
        ("edgware", "5", "points", "21R"),
        ("edgware", "12", "points", "26"),
        ("czbs", "9", "levers", "4"),
        ("czbs", "27", "points", "6R 8R 12/14"),
        ("daidoji", "10R", "levers", "5L 6L 12L"),
        ("daidoji", "22RE", "points", "45R 47R 48"),
        ("swtbahnfull", "0", "conflicts", "1 2 3"),
        ("swtbahnfull", "0", "clear", "33 34 35 67 68"),
        ("dongjiao", "14", "levers", "24 41 42 44"),
        ("dongjiao", "9", "flank", ""),
        ("dongjiao", "4", "driven", "23/25R"),
        ("dongjiao", "10", "foul", "5DG:5/7 21DG:21R"),
        ("ulanka", "123", "points", "1R 3R Vk1"),
        ("ulanka", "150", "locked", "V7-9 V5"),
        ("enohara", "15L2", "clear", "56T 61T 2T"),
        ("enohara", "4L", "delay", "60"),
        ("milton", "4-main", "levers", "5-main"),
        ("milton", "6-lh1", "points", "11 14 9"),
        ("munkerod", "35-95", "points", "25 27 29R 31R 33R"),
    ],
)
def test_another_word_in_the_source_is_noticed(name: str, route: str, column: str, cell: str) -> None:
    assert compare(changed(name, route, column, cell)).unexplained


def test_the_page_has_a_row_for_each_published_row() -> None:
    lines = table_lines(compared("komano"))
    assert len(lines) == 2 + 43
    assert lines[2] == "| 1RD5 | 1R-25R | = | +42 N (flank) K2 | +43ﾛT K3 | = | = | = |"
