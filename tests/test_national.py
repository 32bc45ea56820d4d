"""National forms: the printed notation, row by row."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import pytest

from interlock.emit.tables.export import sheet_csv
from interlock.emit.tables.railml import railml_json
from interlock.table.cells import ProviderKind, RouteKind
from interlock.table.national import SHEETS, Sheet, national_sheets
from tests.layouts import SHIPPED, built, grown

Rows = list[dict[str, str]]


def sheets(layout: str, profile: str = "", **changes: str) -> dict[str, Sheet]:
    """The sheets of a shipped layout by key, under another profile and with pieces of its text changed."""
    text = Path(f"layouts/{layout}.yaml").read_text("utf-8")
    if profile:
        text = re.sub(
            r"^(name: .*)$", rf"\1\nprofile: {profile}", re.sub(r"^profile: .*$", "", text, flags=re.M), flags=re.M
        )
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    made = grown(text)
    assert made is not None, layout
    return {s.key: s for s in national_sheets(made[0], made[1])}


def told(sheet: Sheet) -> Rows:
    """Rows by English heading."""
    return [dict(zip([h.en for h in sheet.headings], row, strict=True)) for row in sheet.rows]


def only(rows: Rows, **wanted: str) -> dict[str, str]:
    """The row with some cells."""
    (found,) = [r for r in rows if all(r[k.replace("_", " ")] == v for k, v in wanted.items())]
    return found


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
            "IAG、5DG、<3>3DG、7DG、11-13DG、21DG、<25>25DG、5G",
        ),
        (
            "X",
            "至5股道",
            "2",
            "5/7、1/3、(9/11)、[13/15]、(21)",
            "D3、D7、D9、S5D",
            "IAG、5DG、3DG、9-15DG、11-13DG、21DG、<25>25DG、5G",
        ),
        (
            "XD",
            "至4股道",
            "",
            "5/7、(13/15)、[9/11]、(17/19)、{23/25}、(27)",
            "D11、D13、S4L",
            "7DG、11-13DG、9-15DG、17-23DG、19-27DG、4G",
        ),
        ("SII", "由II股道", "1", "27、17/19、1/3", "D1、D5、D15、SIID", "19-27DG、1/19WG、1DG、IIAG"),
        ("D1", "至D9", "", "(1/3)", "D7、<(3)>S5L、SIIIL、SIIL、S4L", "1DG、3DG、<5>5DG"),
        ("D5", "向D1", "", "1/3", "D1、<1>SIIL、S4L", "1DG"),
        ("D13", "至I股道", "", "17/19、23/25", "D17、<17>XD、X", "17-23DG"),
        ("S4", "至D5", "", "(27)、17/19", "D15、S4L、<1>D1", "19-27DG"),
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


LOOP = """interlock: 1
name: loop
profile: cn
boundaries: {W: {approach: a 1000}, E: {approach: b 1000}}
tracks: {west: [W, WG 200], main: [IG 850], loop: [3G 850], east: [EG 200, E]}
points:
  1: {section: 1DG, toe: west.end, normal: main.start, reverse: loop.start}
  2: {section: 2DG, toe: east.start, normal: main.end, reverse: loop.end}
signals:
  X: {from: W, into: WG}
  S: {from: E, into: EG}
  D1: {from: WG, into: 1DG, kind: shunt}
  D2: {from: EG, into: 2DG, kind: shunt}
  SI: {from: IG, into: 1DG, kind: combined}
  S3: {from: 3G, into: 1DG, kind: combined}
  XI: {from: IG, into: 2DG, kind: combined}
  X3: {from: 3G, into: 2DG, kind: combined}
"""


def test_routes_from_both_ends_into_one_track_are_told_once() -> None:
    """In the columns of facing routes, and not as hostile signals of the other throat, too."""
    made = grown(LOOP)
    assert made is not None
    (sheet,) = national_sheets(made[0], made[1])
    cells = {(r[5], r[1]): (r[9], r[11], r[12]) for r in sheet.rows}
    assert cells["X", "至3股道"] == ("D1、S3", "3G", "3G") and cells["S", "至3股道"] == ("D2、X3", "3G", "3G")
    assert cells["D1", "至3股道"] == ("S3、X", "3G", "3G"), (
        "two shunting movements into one track exclude each other (R2)"
    )
    assert cells["S3", "由3股道"] == ("D1、S3D、X", "", "")


@pytest.mark.parametrize("name", SHIPPED)
def test_every_form_is_a_rectangle_and_names_every_route(name: str) -> None:
    layout, table, _ = built(name)
    sheets = national_sheets(layout, table)
    assert len(sheets) == len(SHEETS.get(layout.profile, ()))
    for sheet in sheets:
        assert all(len(r) == len(sheet.headings) for r in sheet.rows), sheet.key
    body = json.loads(railml_json(layout, table))
    assert [r["id"] for r in body["routes"]] == [r.id for r in table.routes]
    named = {r["elementNumber"]: r["id"] for r in body["routes"]}
    told = [
        (c["refersToRoute"], named[other], c["reasonForConflict"])
        for c in body["conflictingRoutes"]
        for group in c["conflictsWithRoutes"]
        for other in body["routeGroups"][group]
    ]
    assert sorted(told) == sorted((r.id, h.route, h.kind) for r in table.routes for h in r.locking.hostile)
    stops = {
        r["refersToRoute"]: {
            g for a in r["requiredSignalAspect"] for k in a["refersTo"] for g in body["signalGroups"][k]
        }
        for r in body["routeRelations"]
    }
    signals = {
        r.id: {p.name for c in r.locking.flank for p in c.providers if p.kind is ProviderKind.SIGNAL}
        for r in table.routes
    }
    assert stops == signals


def test_a_chinese_through_route_bears_the_numbers_of_its_two_routes() -> None:
    (sheet,) = sheets("passing_loop", "cn").values()
    rows = {r[14]: r for r in sheet.rows}
    through = {n: r for n, r in rows.items() if "/" in n}
    assert set(through) == {"2/8", "6/4"}
    for number, row in through.items():
        received, departs = (rows[n] for n in number.split("/"))
        assert row[0].endswith("通过") and row[1] == f"经{received[1][1:]}"
        assert row[5] == f"{received[5]}、{departs[5]}" and row[3] == f"{received[5]}TA、{departs[3].split('、')[-1]}"
        assert "(" not in received[8] + departs[8]  # all points normal
    assert [n for n in rows if "/" not in n] == [str(n) for n in range(1, len(rows) - 1)]


def test_chinese_alternatives_are_told_apart_by_their_buttons_and_the_csv_has_a_byte_order_mark() -> None:
    layout, table, _ = built("cn6502")
    (sheet,) = national_sheets(layout, table)
    trains = [r[3] for r in sheet.rows if r[0] != "调车"]
    assert len(set(trains)) == len(trains) and "XLA、X2BA、SIIILA" in trains
    assert sheet_csv(sheet).startswith("\ufeff方向,进路,")


@pytest.mark.parametrize("profile", ["cn", "de", "uk", "generic"])
def test_a_form_lists_call_on_routes_or_says_how_many_it_leaves_out(profile: str) -> None:
    text = Path("layouts/cn6502.yaml").read_text("utf-8").replace("profile: cn", f"profile: {profile}")
    found = grown(text)
    assert found is not None
    calling = [r for r in found[1].routes if r.kind is RouteKind.CALL_ON]
    (sheet, *_) = (s for s in national_sheets(found[0], found[1]) if s.of_routes)
    told = {sign: text.split()[0] for sign, text in sheet.legend if "条不列" in text}
    if profile == "cn":
        others = [r for r in found[1].routes if r.kind is RouteKind.SHUNT and r.path.variant > 1]
        assert told == {"引导进路": str(len(calling)), "变更调车进路": str(len(others))} and calling and others
        assert not any("引导" in x for row in sheet.rows for x in row)
    else:
        assert not told and calling
    plain = grown(text.replace(", call_on: yes", ""))
    assert plain is not None
    (bare, *_) = (s for s in national_sheets(plain[0], plain[1]) if s.of_routes)
    assert "引导进路" not in dict(bare.legend)
    assert len(sheet.rows) - len(bare.rows) == (0 if profile == "cn" else len(calling))


def test_german_tables_print_left_and_right_where_the_hand_is_stated() -> None:
    made = sheets("flank_lab")
    routes = told(made["de_sslz"])
    # points 1 and 2 are turnouts to the right and to the left
    assert only(routes, Route="N2/F")["Deciding points"] == ""
    assert only(routes, Start="S1", Destination="N8")["Deciding points"] == ""  # one way to N8: nothing to decide
    assert only(routes, Route="N2/F")["Overlap"] == "D1*, D2"
    overlap = only(told(made["de_ssld"]), From="S1", Overlap="D2")
    assert (overlap["Points locked"], overlap["Length needed (m)"], overlap["Length (m)"]) == ("1R, 5R", "200", "380")
    assert (overlap["Release section"], overlap["Its length (m)"], overlap["Delay (s)"]) == ("w0", "60", "45")
    unstated = sheets("flank_lab", **{", hand: right}": "}", ", hand: left}": "}"})
    assert only(told(unstated["de_ssld"]), From="S1", Overlap="D2")["Points locked"] == "1−, 5+"


def test_deciding_points_are_those_whose_other_leg_leads_to_the_same_end() -> None:
    """As in the public example of the German planning tables: not every point at which a route to elsewhere leaves."""
    rows = told(sheets("cn6502", **{"profile: cn": "profile: de"})["de_sslz"])
    own = {r["Route"]: r["Deciding points"] for r in rows}
    assert own["XD/E1"] == own["XD/E4"] == own["S5/DJ"] == "", "facing points on the way, and one way to the end"
    ways = [own[x] for x in ("X/E3", "X/E3 [U2]", "X/E3 [U3]", "X/E3 [U4]")]
    assert ways == ["5+, 9+", "5−, 13+", "5+, 9−", "5−, 13−"]


def test_german_tables_call_the_halves_of_a_slip_as_the_drawing_does() -> None:
    text = Path("tests/stations/phausen.yaml").read_text("utf-8")
    made = grown(text)
    assert made is not None
    form = {s.key: told(s) for s in national_sheets(made[0], made[1])}
    assert only(form["de_sslz"], Route="60ZR4/60L123X [U2]", Overlap="D1*")["Deciding points"] == "60W28AB−"
    assert {r["Requester"] for r in form["de_sslf"]} >= {"60W28AB", "60W28CD"}
    assert not any(
        "60W28a" in cell for rows in form.values() for r in rows for k, cell in r.items() if k != "Conflicts"
    )


def test_german_flank_protection_tells_transfer_and_space() -> None:
    rows = told(sheets("flank_lab")["de_sslf"])
    trap = only(rows, Requester="5", Position_passed="L")
    assert (trap["Points or derailer"], trap["Position"], trap["Two-way"]) == ("1", "L", "nein")
    derailer = only(rows, Requester="5", Position_passed="R")
    assert (derailer["Points or derailer"], derailer["Position"]) == ("Gs1", "aufgelegt")
    signal = only(rows, Requester="2", Position_passed="L")
    assert signal["Signal"] == "N2" and signal["Handed on to"] == ""
    turned = only(rows, Requester="1", Position_passed="L")
    assert (turned["Points or derailer"], turned["Position"], turned["End of track or line"]) == ("5", "L", "")
    handed = only(rows, Requester="1", Position_passed="R")
    # behind the loop the request meets point 6 at its toe, so both of its legs are looked at
    assert (handed["Handed on to"], handed["As for"], handed["End of track or line"]) == ("6", "L+R", "B, C")


TWO_WAY = """\
interlock: 1
name: two_way
profile: de
boundaries:
  A: {approach: aa 1900, label: A}
  B: {approach: ab 1900, label: B}
buffers: [E]
tracks:
  west: [A, a1 300]
  mid: [m1 800]
  east: [b1 300, B]
  sid: [s1 200, E]
points:
  1: {section: p1, toe: west.end, normal: mid.start, reverse: 3.normal, hand: right}
  2: {section: p2, toe: east.start, normal: mid.end, reverse: 3.reverse, hand: left}
  3: {section: p3, toe: sid.start, hand: left}
signals:
  X: {from: A, into: a1}
  X1: {from: m1, into: p2}
  Y1: {from: m1, into: p1}
  Y: {from: B, into: b1}
  L: {from: s1, into: p3}
"""


def test_a_point_wanted_both_ways_has_two_rows() -> None:
    made = grown(TWO_WAY)
    assert made is not None
    forms = {s.key: s for s in national_sheets(made[0], made[1])}
    left, right = told(forms["de_sslw"])
    # movements over 1 to the left ask 3 to lie left; over 2 to the right they would ask it to lie right
    assert (left["Points in position"], left["Locked"], left["Substitute signal"]) == ("3L", "x", "")
    assert (right["Points in position"], right["Locked"], right["Substitute signal"]) == ("3R", "", "L")
    assert left["Same route"] == left["Different routes"] == "x" and right["Space proved clear"] == "p3"
    asking = only(told(forms["de_sslf"]), Requester="1", Position_passed="L")
    assert (asking["Points or derailer"], asking["Position"], asking["Two-way"]) == ("3", "L", "ja")


def test_british_routes_count_from_the_left() -> None:
    rows = told(sheets("junction")["uk_routes"])
    letters = {r["In the other tables"]: r["Route"] for r in rows}
    assert letters["S1J-S5"] == "S1JA(M)" and letters["S1J-S3"] == "S1JB(M)"  # the branch lies to the left
    assert letters["S1-S1J"] == "S1A(M)"
    turned = sheets("junction", **{"normal: down2.start, hand: left": "normal: down2.start, hand: right"})
    assert {r["In the other tables"]: r["Route"] for r in told(turned["uk_routes"])}["S1J-S3"] == "S1JA(M)"
    unstated = sheets("junction", **{", hand: left": ""})["uk_routes"]
    assert any("101" in text for sign, text in unstated.legend if sign == "Letters")


def test_british_opposing_locking_is_told_by_tracks_and_times() -> None:
    made = sheets("passing_loop", "uk")
    rows = told(made["uk_routes"])
    names = [r["Route"] for r in rows]
    assert len(set(names)) == len(names)
    into = only(rows, Route="SA(M)")["Opposing locking: routes – tracks [or time]"].split(", ")
    # X1A leaves IG over the same points: they do not exclude it; X3A gives them back before it leaves IIAG
    assert "X1A(M) – 2DG IIAG" in into and "X3A(M) – IIAG" in into
    # out of the loop, only the overlap of a route into it is in the way: until that train stands
    over = only(told(made["uk_points"]), Points="1")["N to R: locked by routes – tracks"].split(", ")
    assert "SA(M) + SA(C) – IIAG 2DG IG 1DG [or IG occ 60 s]" in over


def test_british_points_lock_against_what_a_route_calls() -> None:
    for made in (sheets("junction"), sheets("terminus_slip")):
        names = {r[0] for r in made["uk_routes"].rows}
        for row in told(made["uk_points"]):
            reverse, normal = row["N to R: called by"], row["R to N: called by"]
            assert not set(reverse.split(", ")) & set(normal.split(", ")) - {""}
            for called, locked in (
                (normal, "N to R: locked by routes – tracks"),
                (reverse, "R to N: locked by routes – tracks"),
            ):
                held = [n for group in row[locked].split(", ") for n in group.split(" – ")[0].split(" + ")]
                assert sorted(held) == sorted(called.split(", ")) and {n.split(".o")[0] for n in held} - {""} <= names


def test_american_aspects_follow_the_next_signal() -> None:
    made = sheets("passing_loop")
    row = only(told(made["us_aspects"]), Route="S-S3")
    assert row["Switches in order"] == "2 R" and row["Next signal"] == "S3"
    assert (row["Aspect, next at stop"], row["Aspect, next at proceed"]) == ("caution", "clear")
    switch = only(told(made["us_switches"]), Switch="1")
    assert switch["Normal for routes"] == "S1-W, X-X1, X-X1.c" and switch["Supervision (s)"] == "13"


def test_a_printed_sheet_has_no_empty_column_and_names_those_left_out() -> None:
    for name in SHIPPED:
        for sheet in map(Sheet.printed, sheets(name).values()):
            assert all(any(row[x] for row in sheet.rows) for x in range(len(sheet.headings)) if sheet.rows), sheet.key
            assert sheet.after
    sslz = sheets("flank_lab")["de_sslz"]
    assert "Überwachte Ssp" in sslz.printed().empty and "T Zs3" in sslz.left_out
    assert len(next(csv.reader(io.StringIO(sheet_csv(sslz))))) == len(sslz.headings)  # a program finds every column


@pytest.mark.parametrize(
    ("profile", "form", "column"), [("uk", "uk_routes", "Route"), ("generic", "us_locking", "Entering signal")]
)
def test_signal_2_stands_before_signal_10(profile: str, form: str, column: str) -> None:
    """Forms had S1, S10, S11 ... S2, as a computer sorts, and not as the signals are numbered."""
    text = Path("tests/stations/milton.yaml").read_text("utf-8").replace("profile: uk", f"profile: {profile}")
    made = grown(text)
    assert made is not None
    found = {s.key: s for s in national_sheets(made[0], made[1])}
    entries = [re.sub(r"(?<=\d)[A-Z].*", "", r[column]) for r in told(found[form])]
    assert list(dict.fromkeys(entries))[:4] == ["S1", "S2", "S3", "S4"] and entries[-3].startswith("S19")
    points = told(found["uk_points" if profile == "uk" else "us_switches"])
    assert [next(iter(r.values())) for r in points][:4] == ["3/34", "5/7", "8/32", "9/6"]
