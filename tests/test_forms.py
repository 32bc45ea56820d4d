"""Cells of national forms, each of which a small change of its form made wrong without another test that noticed."""

from __future__ import annotations

from tests.test_national import chinese, only, sheets, told


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
