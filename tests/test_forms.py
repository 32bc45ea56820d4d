"""Cells of national forms, each of which a small change of its form made wrong without another test that noticed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from interlock.logic.lower import lower
from interlock.logic.names import STANDING
from interlock.table.national import Sheet, national_sheets
from interlock.table.national.cn import chinese_table
from tests.layouts import built, grown
from tests.test_national import TWO_WAY, chinese, only, sheets, told


def test_what_a_chinese_signal_shows_for_a_departure_follows_the_block() -> None:
    """L, U or LU into automatic block, L alone into semi-automatic block."""
    shown = {r[0]: r[6] for r in chinese().values() if r[0].endswith("发车")}
    assert shown == {"北京方面发车": "L、U、LU", "东郊方面发车": "L"}


def test_an_alternative_is_told_by_a_signal_that_none_before_it_passes_and_only_else_by_a_button_of_its_own() -> None:
    """The routes before it are those of lower numbers, not itself."""
    table = chinese()
    assert table["XD", "至III股道", "2"][3] == "XDLA、D13A、SIIILA"
    assert table["X", "至4股道", "2"][3] == "XLA、D11A、S4LA"
    assert table["X", "至III股道", "3"][3] == "XLA、X2BA、SIIILA"


def test_a_through_route_has_every_cell() -> None:
    """A cell of a through route that is left out is an empty one."""
    (sheet,) = sheets("passing_loop", "cn").values()
    heads = [h.zh for h in sheet.headings]
    through = [dict(zip(heads, r, strict=True)) for r in sheet.rows if r[0].endswith("通过")]
    assert len(through) == 2
    for r in through:
        assert r["其他联锁"] == f"进路 {r['进路号码'].replace('/', '、')} 的全部条件"
        assert r["信号机显示"].startswith("L、")


def test_american_aspects_tell_the_speed_where_there_is_one() -> None:
    rows = told(sheets("flank_lab", "generic")["us_aspects"])
    speeds = {r["Route"]: r["Speed (km/h)"] for r in rows}
    assert speeds["S1-N8"] == "40" and speeds["S1-N2"] == "80" and speeds["F-B"] == speeds["L5-N8"] == ""


def test_british_remarks_call_devices_closed_and_no_points() -> None:
    rows = told(sheets("flank_lab", "uk")["uk_routes"])
    assert only(rows, Route="N8A(M)")["Remarks"].startswith("LC1 closed, stop lamp of N2")
    assert only(rows, Route="S1B(M)")["Remarks"] == "Gs1 on"


def test_german_shunt_routes_name_the_points_over_which_flank_protection_is_asked() -> None:
    """Whichever leg the movement uses."""
    rows = told(sheets("cn6502", **{"profile: cn": "profile: de"})["de_sslr"])
    assert only(rows, Start="D1", Destination="D15")["Points with flank"] == "1"  # its reverse leg asks
    assert only(rows, Start="D9", Destination="5G")["Points with flank"] == "9, 11, 21"


def test_british_routes_name_those_that_must_be_normal() -> None:
    """Hostile routes that neither points nor opposing locking exclude; the column was empty."""
    rows = told(sheets("flank_lab", "uk")["uk_routes"])
    required = {r["Route"]: r["Requires normal"] for r in rows}
    assert required["S1A(M)"] == "N8A(M), SAA(M).o2" and required["L5A(S)"] == "SAA(M).o2"
    assert required["N2A(M)"] == "o2: FA(M)" and required["SAA(M)"] == "o1: S1B(M); o2: L5A(S), S1A(M)"


def test_german_shunt_routes_tell_whether_movements_against_them_are_excluded() -> None:
    """Those that end in the same section, from the other side."""
    rows = told(sheets("cn6502", **{"profile: cn": "profile: de"})["de_sslr"])
    said = {(r["Start"], r["Destination"]): r["Opposing excluded"] for r in rows}
    assert said["D1", "D15"] == said["D1", "D9"] == said["D9", "D13"] == "ja"
    assert said["D3", "D11"] == said["D5", "IIAG"] == said["D7", "IAG"] == ""


FOUL_WHILE_LOCKED = """interlock: 1
name: foul_demanded
profile: cn
boundaries: {W: {approach: wa 600}, E: {trains: out}, V: {approach: va 600}, U: {trains: out}}
buffers: [B]
tracks: {west: [W, s1 200], east: [s3 200, E], v: [V, s5 200], u: [s7 200, U], b: [s4 200, B]}
points:
  1: {section: s2, toe: west.end, normal: east.start, reverse: 2.toe, legs: 40}
  2: {section: s2, normal: 3.normal, reverse: b.start, legs: 20}
  3: {section: s6, toe: v.end, reverse: u.start, legs: 10}
signals:
  X: {from: W, into: s1}
  A: {from: s1, into: s2}
  Y: {from: V, into: s5}
  D: {from: s5, into: s6}
  F: {from: s4, into: s2, at: 2}
"""
DEMANDED = "demand:\n  - {point: 2, lies: LIES, routes: {from: D}, reason: vehicles of the depot}\n"


def chinese_rows(sheet: Sheet) -> list[dict[str, str]]:
    """Rows by Chinese heading."""
    return [dict(zip([h.zh for h in sheet.headings], row, strict=True)) for row in sheet.rows]


def in_chinese(layout: str, more: str = "") -> list[dict[str, str]]:
    """The rows of the Chinese table of a layout, with what is added to it."""
    changes = {"signals:": f"{more}signals:"} if more else {}
    return chinese_rows(sheets(layout, "cn", **changes)["cn"])


def of_tests(name: str) -> str:
    """A layout that only tests use, beside those that are shipped."""
    return f"../tests/layouts_for_tests/{name}"


@pytest.mark.parametrize(
    ("demand", "sections"),
    [
        ("", "s6、<2>s2、s7"),
        (DEMANDED.replace("LIES", "normal"), "s6、s2、s7"),
        (DEMANDED.replace("LIES", "reverse"), "s6、s7"),
    ],
)
def test_a_chinese_foul_section_has_its_condition_where_the_route_does_not_settle_it(
    demand: str, sections: str
) -> None:
    """s2 fouls the way of D over 3 while 2 lies normal: a route that locks it so always asks for s2."""
    made = grown(FOUL_WHILE_LOCKED + demand)
    assert made is not None
    rows = chinese_rows(chinese_table(made[0], made[1]))
    assert only(rows, 信号机名称="D", 方向="U发车")["轨道区段"] == sections


def test_what_fouls_a_chinese_overlap_stands_with_it() -> None:
    told = only(in_chinese(of_tests("foul_overlap")), 信号机名称="S0")
    assert (told["轨道区段"], told["其他联锁"]) == ("q1", "保护区段 o，侵限 v1")
    told = only(chinese_rows(chinese_table(*built("junction")[:2])), 信号机名称="S1")
    assert told["其他联锁"] == "o1: 保护区段 AC、AD，道岔 101; o2: 保护区段 AC、CD，侵限 <102>BC，道岔 (101)"


def test_chinese_hostile_signals_are_those_of_declared_hostile_routes_too() -> None:
    hostile = "hostile:\n  - {one: {from: X1}, other: {from: S3}, reason: oversize loads meet}\n"
    for more, x1, s3 in (("", "S", "X"), (hostile, "S3、S", "X1、X")):
        rows = in_chinese("passing_loop", more)
        assert only(rows, 信号机名称="X1")["敌对信号"] == x1 and only(rows, 信号机名称="S3")["敌对信号"] == s3


def test_chinese_hostile_signals_are_those_of_routes_kept_apart_without_a_common_section_too() -> None:
    """By a foul joint, with the point that tells the hostile routes from others, and beside a diamond."""
    rows = in_chinese(of_tests("foul_berth"))
    assert {x["敌对信号"] for x in rows if x["信号机名称"] == "X"} == {"H", ""}
    assert only(rows, 信号机名称="H", 方向="N发车")["敌对信号"] == "<(P)>X"
    rows = in_chinese(of_tests("foul_facing"))
    assert only(rows, 信号机名称="SP", 方向="E发车")["敌对信号"] == "SN"
    assert only(rows, 信号机名称="SN", 方向="N接车")["敌对信号"] == "SW、<P>SP"


def test_a_chinese_route_past_signals_is_hostile_to_those_that_begin_there() -> None:
    rows = in_chinese(of_tests("identifiers"))
    assert only(rows, 进路="越过Y、Z至W")["敌对信号"] == "Y、Z"
    assert only(rows, 信号机名称="Z", 进路="至p3股道")["敌对信号"] == "Y、X"
    assert only(rows, 信号机名称="Y", 进路="至p2股道")["敌对信号"] == "X"


POINTS_BEYOND = """interlock: 1
name: points_beyond
profile: cn
principles: {line_speed_kmh: 40}
boundaries: {W: {approach: wa 300, trains: in}, V: {approach: va 300, trains: in}, E: {trains: out}}
tracks: {t: [W, a 100, b 100, c 100, d 100], g: [V, h 200], e: [f 100, E]}
points: {5: {section: p, toe: e.start, normal: t.end, reverse: g.end}}
signals:
  X: {from: W, into: a}
  S: {from: b, into: c}
  T: {from: d, into: p, identifier: yes}
  Y: {from: V, into: h}
  U: {from: h, into: p}
overlaps: {S: {length: 0}, T: {length: 0}, U: {length: 0}}
"""


def test_points_past_a_signal_at_identifier_light_exclude_too() -> None:
    """U over 5 reversed is not named by the route of S past T, over 5 normal."""
    made = grown(POINTS_BEYOND)
    assert made is not None
    rows = chinese_rows(chinese_table(made[0], made[1]))
    assert only(rows, 进路="越过T至E")["敌对信号"] == "T" and only(rows, 信号机名称="T")["敌对信号"] == "<5>S"
    assert only(rows, 信号机名称="U")["敌对信号"] == ""


BEYOND = """interlock: 1
name: beyond
profile: de
principles: {main_closes: whole-movement, line_speed_kmh: 40}
boundaries:
  W: {approach: apw 300}
  E: {approach: ape 300}
tracks:
  t: [W, a 100, b 100, c 100, d 100, f 100, E]
signals:
  X: {from: W, into: a}
  Y: {from: E, into: f}
  S: {from: b, into: c}
  T: {from: d, into: f, identifier: yes}
exclude:
  - {from: S, to: T, reason: trains do not stop at T}
level_crossings:
  LC9: {over: [f], text: road}
conditions:
  BRIDGE: {text: bridge locked, over: [f]}
zones:
  Z: {sections: [f], trains: 1}
overlaps: {T: {length: 0}}
"""


def test_german_train_routes_tell_what_is_asked_past_a_signal_at_identifier_light() -> None:
    """Level crossings, conditions, zones and the line beyond: trains have no row there."""
    made = grown(BEYOND)
    assert made is not None
    forms = {s.key: told(s) for s in national_sheets(made[0], made[1])}
    past, own = only(forms["de_sslz"], Route="S/E"), only(forms["de_sslz"], Route="T/E")
    assert past["Level crossings"] == own["Level crossings"] == "LC9"
    asked = {"BRIDGE", "Z nicht voll", "ape frei (Strecke)"}
    assert asked <= set(own["Remarks"].split(", ")) and asked <= set(past["Remarks"].split(", "))
    assert "T zeigt Kennlicht" in past["Remarks"]


def test_german_shunt_routes_tell_the_speed_of_their_path() -> None:
    """Sslr has no column for it."""
    made = sheets("cn6502", **{"profile: cn": "profile: de\nsections: {3DG: {speed: 25}}"})
    rows = told(made["de_sslr"])
    assert not any("v Fahrweg" in r["Remarks"] for r in told(made["de_sslz"])), "trains have a column for it"
    said = {(r["Start"], r["Destination"]): "v Fahrweg 25 km/h" in r["Remarks"].split(", ") for r in rows}
    assert said["D1", "D9"] and not said["D5", "IIAG"]


@pytest.mark.parametrize(("profile", "key"), [("uk", "uk_routes"), ("generic", "us_locking"), ("de", "de_verschluss")])
def test_a_form_without_a_column_for_driven_points_says_where_they_stand(profile: str, key: str) -> None:
    driven = sheets(of_tests("driven"), **{"profile: cn": f"profile: {profile}\nprinciples: {{drive_points: yes}}"})
    assert sum("Driven" in sign or "mitlaufend" in sign for sign, _ in driven[key].legend) == 1
    plain = sheets(of_tests("driven"), **{"profile: cn": f"profile: {profile}"})
    assert len(plain[key].legend) == len(driven[key].legend) - 1


def test_german_remarks_tell_what_is_asked_beside_points_and_track() -> None:
    """Stop lamps that protect a flank, when the signal closes, what stays locked longer, past a signal, too, and a
    berth that may be occupied."""
    found = {r["Route"]: r["Remarks"] for r in told(sheets("flank_lab")["de_sslz"])}
    assert found["S1/N2"] == "Haltlicht von N8" and found["S1/N8"] == ""
    held = "demand:\n  - {point: LC9, lies: reverse, routes: {from: T}, hold: 20, reason: wagons}\nconditions:"
    made = grown(BEYOND.replace("conditions:", held))
    assert made is not None
    (sslz,) = (s for s in national_sheets(made[0], made[1]) if s.key == "de_sslz")
    found = {r["Route"]: r["Remarks"] for r in told(sslz)}
    assert {r for r, notes in found.items() if "LC9 20 s länger verschlossen" in notes} == {"S/E", "T/E"}
    assert "Haltfall erst, wenn d frei" in found["T/E"]
    berths = {r["Route"]: r["Remarks"] for r in told(sheets("cn6502", "de")["de_sslr"])}
    assert berths["D1/D15"] == "Zielgleis 1/19WG darf besetzt sein" and berths["D1/D9"] == ""


def test_a_german_route_past_a_signal_locks_its_overlap_and_ends_with_the_one_at_its_destination() -> None:
    (past,) = (r for r in told(sheets(of_tests("identifiers"), "de")["de_sslz"]) if r["Route"] == "X/W")
    assert {f"D1 von {g} mitverschlossen" for g in "YZ"} <= {*past["Remarks"].split(", ")}
    made = grown(Path("tests/stations/phausen.yaml").read_text("utf-8"))
    assert made is not None
    (sslz,) = (s for s in national_sheets(made[0], made[1]) if s.key == "de_sslz")
    past = next(r for r in told(sslz) if r["Route"] == "60G/60P13" and r["Signals passed at identifier light"])
    assert past["Speed of the overlap (km/h)"] == "40", "that at 60P13, not the one at the signal that is passed"


def test_a_level_crossing_that_must_be_open_is_no_level_crossing_that_is_closed() -> None:
    """In the German table the column names those that are closed to the road; what else is locked stands in remarks."""
    demand = "demand:\n  - {point: LC1, lies: normal, routes: {from: SA}, reason: the fire brigade first}\nsignals:"
    rows = told(sheets("flank_lab", **{"signals:": demand})["de_sslz"])
    asked = only(rows, Route="SA/S1")
    assert (asked["Level crossings"], asked["Remarks"]) == ("", "LC1 offen")
    assert only(rows, Route="N2/F")["Level crossings"] == "LC1"


def test_added_points_stand_beside_those_that_protect_a_flank() -> None:
    """A form of three railways has no column of its own for what the author demands: 3 shall lie normal for S1-W."""
    for profile, key, column, said in (
        ("de", "de_verschluss", "Flank points", "3+"),
        ("uk", "uk_routes", "Flank N", "3"),
        ("generic", "us_locking", "Switches normal", "1, 3"),
    ):
        rows = told(sheets(of_tests("added"), profile)[key])
        start = {"de_verschluss": "S1-W", "us_locking": "S1-W", "uk_routes": "S1A(M)"}[key]
        assert only(rows, Route=start)[column] == said, profile
    switches = only(told(sheets(of_tests("added"), "generic")["us_switches"]), Switch="3")
    assert "S1-W" in switches["Normal, protecting"] and "S1-W" not in switches["Normal for routes"]


@pytest.mark.parametrize("name", ["cn6502", "depot", "flank_lab", "pit_bottom", "terminus_slip"])
def test_all_that_protects_a_flank_is_named_in_the_german_table(name: str) -> None:
    """Every point, derailer and signal, every end of the track, and a track that is run the other way alone."""
    text = re.sub(r"^profile: .*$", "", Path(f"layouts/{name}.yaml").read_text("utf-8"), flags=re.MULTILINE)
    made = grown(re.sub(r"^(name: .*)$", r"\1\nprofile: de", text, flags=re.MULTILINE))
    assert made is not None
    (sslf,) = (s for s in national_sheets(made[0], made[1]) if s.key == "de_sslf")
    found = [{x for cell in row for x in cell.split(", ")} for row in sslf.rows]
    for c in {c for t in made[1].locks for c in t.flank}:
        assert any({p.name for p in c.providers} <= row for row in found), c.requester


def test_flank_protection_is_not_looked_for_against_the_direction_of_a_track() -> None:
    """At the pit bottom nothing comes over q4_tippler from P4, at which a request would be handed on."""
    row = only(told(sheets("pit_bottom", "de")["de_sslf"]), Requester="P1", Position_passed="−")
    assert (row["End of track or line"], row["Handed on to"], row["As for"]) == ("q4_tippler", "", "")


def test_points_wanted_both_ways_by_one_route_are_told_from_those_wanted_by_different_ones() -> None:
    said: dict[str, tuple[str, str]] = {}
    for name in ("cn6502", "slip_junction"):
        rows = told(sheets(name, "de")["de_sslw"])
        said |= {r["Points in position"]: (r["Same route"], r["Different routes"]) for r in rows}
    assert said["1/3+"] == said["1/3−"] == ("", "x") and said["201a+"] == ("x", "x")


@pytest.mark.parametrize(
    ("key", "profile", "word", "said"),
    [
        ("de_sslr", "de", "oder", "[3DG oder 1/3−]"),
        ("uk_routes", "uk", "or", "[3DG or 1/3 R]"),
        ("us_locking", "generic", "or", "[3DG or 1/3 R]"),
    ],
)
def test_a_foul_section_is_left_out_where_the_point_beside_it_lies_the_other_way(
    key: str, profile: str, word: str, said: str
) -> None:
    """3DG fouls the way over 5DG while 1/3 lies normal: it is asked clear, or 1/3 reverse."""
    rows = sheets("cn6502", profile)[key].rows
    assert {x for row in rows for cell in row for x in re.findall(rf"\[3DG {word} [^\]]*\]", cell)} == {said}


def test_a_german_form_tells_by_the_side_how_points_lie_that_make_a_foul_section_clear() -> None:
    """Over the diamond BC must be clear while 102 lies normal, which is to the right: reverse is L, and R would tell
    the opposite."""
    made = sheets("junction", "de")
    clear = {r["Route"]: r["Sections clear"] for r in told(made["de_verschluss"])}
    assert clear["S1J-S5"] == "AC, CD, [BC oder 102L], CE"
    assert dict(made["de_verschluss"].legend)["[BC oder 102L]"].startswith("BC ist frei")
    assert not any(sign.startswith("[") for sign, _ in sheets("flank_lab")["de_verschluss"].legend)


def test_the_german_locking_table_tells_what_a_route_with_one_of_its_overlaps_is() -> None:
    legend = dict(sheets("flank_lab")["de_verschluss"].legend)
    assert legend["N2-F.o2"] == "die Fahrstraße mit D-Weg D2; mit einem anderen schließt sie nicht aus"
    assert not any(".o" in sign for sign in dict(sheets("passing_loop", "de")["de_sslz"].legend))


def test_german_two_way_protection_tells_for_which_movements_in_words_of_the_form() -> None:
    made = grown(TWO_WAY)
    assert made is not None
    (form,) = (s for s in national_sheets(made[0], made[1]) if s.key == "de_sslw")
    said = {r["Points in position"]: r["Remarks"] for r in told(form)}
    assert said == {"3L": "für 1 bei Fahrt über L", "3R": "für 2 bei Fahrt über R"}


def test_what_the_author_declares_hostile_is_told_though_points_exclude_it_too() -> None:
    """S1 and S3 lead over point 1 in two positions; it is given back behind the train, and the declaration lasts until
    the train is wholly in the last section (R6).  Forms that leave out what points exclude said nothing of it."""
    hostile = "hostile:\n  - {one: {from: S1}, other: {from: S3}, reason: one crew works both}\nsignals:"
    for more in ({}, {"signals:": hostile}):
        rows = [r for r in chinese_rows(sheets("passing_loop", "cn", **more)["cn"]) if r["方向"].endswith("发车")]
        assert {r["信号机名称"] for r in rows if "S1" in r["敌对信号"].split("、")} == ({"S3"} if more else set())
        uk = {
            r["Route"]: r["Requires normal"].split(", ")
            for r in told(sheets("passing_loop", "uk", **more)["uk_routes"])
        }
        assert ("S3A(M)" in uk["S1A(M)"]) is ("S1A(M)" in uk["S3A(M)"]) is bool(more)


CLEAR = {
    "de": ("de_verschluss", "Route", "Sections clear"),
    "uk": ("uk_routes", "In the other tables", "Tracks clear (route, foul, overlap, flank)"),
    "generic": ("us_locking", "Route", "Track circuits (OS)"),
}
"""By railway the form, its column of routes, and that of what a route has clear."""


@pytest.mark.parametrize("profile", CLEAR)
def test_flank_space_and_what_the_author_demands_are_among_the_sections_clear(profile: str) -> None:
    """21DG lies between XD-E1 and what protects it; 3G lies beside S1-W."""
    key, name, column = CLEAR[profile]

    def asked(layout: str, route: str, **more: str) -> list[str]:
        (row,) = (r for r in told(sheets(layout, profile, **more)[key]) if r[name] == route)
        return row[column].split(", ")

    head = f"name: cn6502\nprofile: {profile}\n"
    for space in ("yes", "no"):
        found = asked("cn6502", "XD-E1", **{head: f"{head}principles: {{flank_space: {space}}}\n"})
        assert ("21DG" in found) is (space == "yes")
    clear = {"signals:": "demand:\n  - {clear: 3G, routes: {from: S1}, reason: oversize loads}\nsignals:"}
    assert "3G" in asked("passing_loop", "S1-W", **clear) and "3G" not in asked("passing_loop", "S1-W")


def test_a_machine_whose_points_turn_to_different_sides_lies_normal_or_reverse() -> None:
    """Left of the one point is right of the other: the German table has + and − for such a machine."""
    for machine, said in (("", {"1L", "1R", "2L", "2R"}), (", machine: 1/2", {"1/2+", "1/2−"})):
        made = grown(TWO_WAY.replace("hand: right}", f"hand: right{machine}}}").replace(
            "reverse: 3.reverse, hand: left}", f"reverse: 3.reverse, hand: left{machine}}}"))  # fmt: skip
        assert made is not None
        (form,) = (s for s in national_sheets(made[0], made[1]) if s.key == "de_verschluss")
        points = {p for r in told(form) for p in r["Points"].split(", ") if p[:1] in "12"}
        assert points - {""} == said


def test_british_and_american_forms_tell_that_the_line_beyond_must_be_clear() -> None:
    rows = told(sheets("passing_loop", "uk")["uk_routes"])
    said = {r["In the other tables"]: "XJG clear (line)" in r["Remarks"].split(", ") for r in rows}
    assert said["S1-W"] and said["S3-W"] and not said["X-X1"] and not said["X1-E"]
    locking = {r["Route"]: r["Traffic locking"] for r in told(sheets("passing_loop", "generic")["us_locking"])}
    assert locking["S1-W"] == "XJG" and locking["X1-E"] == "SJG" and locking["X-X1"] == ""
    chart = {r["Route"]: r["Returns to stop"] for r in told(sheets("passing_loop", "generic")["us_aspects"])}
    whole = {"name: passing_loop": "name: passing_loop\nprinciples: {main_closes: whole-movement}"}
    closing = {r["Route"]: r["Returns to stop"] for r in told(sheets("passing_loop", **whole)["us_aspects"])}
    assert chart["S1-W"] == "first axle" and closing["S1-W"] == "IG clear"


def test_the_german_locking_table_tells_how_long_points_are_held_and_keys_apart_from_points() -> None:
    (row,) = (r for r in told(sheets(of_tests("held_longer"), "de")["de_verschluss"]) if r["Route"] == "A-N")
    assert (row["Held longer"], row["Release delay (s)"]) == ("2 30 s", "180")


HALF_PLATFORMS = """interlock: 1
name: half_platforms
profile: uk
principles: {overlap_m: OVERLAP}
boundaries: {W: {approach: wa 1500}, E: {approach: ea 1500}}
tracks: {w: [W, w1 250], main: [m1 450], plat: [pA 200, pB 200], e: [e1 250, E]}
points:
  1: {section: T1, toe: w.end, normal: main.start, reverse: plat.start}
  2: {section: T2, toe: e.start, normal: main.end, reverse: plat.end}
signals:
  X0: {from: W, into: w1}
  X1: {from: w1, into: T1, kind: combined}
  MA: {from: pA, into: pB, kind: combined}
  MB: {from: pB, into: pA, kind: combined}
  X3: {from: pB, into: T2, kind: combined}
  X4: {from: m1, into: T2}
  Y0: {from: E, into: e1}
  Y1: {from: e1, into: T2, kind: combined}
  Y3: {from: pA, into: T1, kind: combined}
  Y4: {from: m1, into: T1}
"""


def opposing(overlap: str) -> dict[str, str]:
    """The opposing locking of each route."""
    made = grown(HALF_PLATFORMS.replace("OVERLAP", overlap))
    assert made is not None
    (sheet,) = [s for s in national_sheets(made[0], made[1]) if s.key == "uk_routes"]
    return {r["Route"]: r["Opposing locking: routes – tracks [or time]"] for r in told(sheet)}


@pytest.mark.parametrize("overlap", ["0", "60"])
def test_a_train_is_out_of_the_way_of_shunting_into_its_berth_when_it_stands_there(overlap: str) -> None:
    """The berth need not be clear: the form said that the train has cleared it.  A train route needs it clear."""
    said = {route: cell.split(", ") for route, cell in opposing(overlap).items()}
    beyond = "" if overlap == "0" else " T2"
    assert (
        said["X3B(S)"][0] == "Y0A(M) – until wholly in e1 and e1 occ 60 s"
        and said["X3A(M)"][0] == f"Y0A(M) – e1{beyond}"
    )
    assert said["Y1B(S)"][:2] == ["MAA(M) – until wholly in pB and pB occ 60 s", "MAA(S) – until wholly in pB"]
    assert said["Y1B(M)"][0] == ("MAA(M) + MAA(S) – pB" if overlap == "0" else "MAA(M) – pB T2")


def test_a_long_berth_takes_a_train_longer() -> None:
    """Without an overlap: as long as it takes that runs through all of it and brakes as late as it can."""
    made = grown(HALF_PLATFORMS.replace("OVERLAP", "0, restart_delay_s: 500").replace("e1 250", "e1 5000"))
    assert made is not None
    controller = lower(made[0], made[1])
    (timer,) = [t for t in controller.timers if t.name == STANDING("Y1")]
    (sheet,) = [s for s in national_sheets(made[0], made[1]) if s.key == "uk_routes"]
    said = {r["Route"]: r["Opposing locking: routes – tracks [or time]"] for r in told(sheet)}
    assert timer.preset_ms > 60_000
    assert said["X3B(S)"].startswith(f"Y0A(M) – until wholly in e1 and e1 occ {timer.preset_ms / 1000:g} s")
