"""What an engineer reads from the Chinese table: no restriction is left out, and no condition hides one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from interlock.model.elements import MachineId, PointId, Position, RouteId
from interlock.model.layout import Layout
from interlock.table.cells import HostileClass, RouteKind
from interlock.table.national.cn import _Form, chinese_table
from interlock.table.rows import InterlockingTable
from tests.layouts import SHIPPED, built, grown
from tests.test_forms import BEYOND, POINTS_BEYOND, chinese_rows, of_tests
from tests.test_national import only, sheets

FACING = ("迎面进路 列车", "迎面进路 调车")


def rows(layout: str, **changes: str) -> list[dict[str, str]]:
    """The rows of the Chinese table of a layout of whatever railway."""
    return chinese_rows(sheets(layout, "cn", **changes)["cn"])


def table_of(name: str) -> tuple[Layout, InterlockingTable]:
    """A shipped layout, one for tests, or a station of another railway as a Chinese one."""
    if not name.startswith("stations/"):
        return built(name)[:2]
    text = Path(f"tests/{name}.yaml").read_text("utf-8")
    made = grown(re.sub(r"^profile: \w+$", "profile: cn", text, flags=re.MULTILINE))
    assert made is not None
    return made[0], made[1]


Needs = list[tuple[MachineId, Position]]


def hostile_signals(layout: Layout, cell: str) -> Iterator[tuple[str, Needs]]:
    """The signals of a cell, each with the points at whose position it is hostile."""
    for part in re.split(r"; |o\d+: ", cell):
        needs: Needs = []
        for said in filter(None, re.split(r"、(?![^<]*>)", part)):
            condition, signal = re.fullmatch(r"(?:<(.*)>)?(.*)", said).groups()  # type: ignore[union-attr]
            if condition is not None:  # it spans what follows up to the next one
                needs = [_need(layout, x) for x in condition.split("、")]
            yield signal, needs


def _need(layout: Layout, said: str) -> tuple[MachineId, Position]:
    name, lies = (said[1:-1], Position.REVERSE) if said.startswith("(") else (said, Position.NORMAL)
    point = layout.pointwork.point.get(PointId(name))
    return MachineId(name) if point is None else point.machine, lies


@pytest.mark.parametrize(
    "name",
    [
        *SHIPPED,
        *map(of_tests, ("called_on", "foul_facing", "identifiers", "spaces")),
        *("stations/daidoji", "stations/swtbahn"),
    ],
)
def test_every_hostile_route_is_in_the_chinese_table_or_left_out_as_it_says(name: str) -> None:
    """Under its signal, with no condition that it does not fulfil.  Left out: what points exclude, what the columns of
    facing routes tell, what an overlap alone keeps apart, and call-on routes."""
    layout, table = table_of(name)
    form, found = _Form(layout, table), {x["进路号码"]: x for x in chinese_rows(chinese_table(layout, table))}
    for number, way in enumerate(form.printed, start=1):
        r, row = way.rows[0], found[str(number)]
        held = {p.machine: p.position for q in table.parts(r) for p in q.locking.points}
        told = list(hostile_signals(layout, row["敌对信号"]))
        for h in r.locking.hostile:
            t = table.route[h.route]
            theirs = {p.machine: p.position for q in table.parts(t) for p in q.locking.points}
            if t.kind not in (RouteKind.MAIN, RouteKind.SHUNT) or set(h.kinds) == {HostileClass.OVERLAP}:
                continue
            if any(held.get(m, x) is not x for m, x in theirs.items()) or (t.entry, t.kind) == (r.entry, r.kind):
                continue
            ends = {table.parts(x)[-1].path.section_ids[-1] for x in (r, t)}
            facing = len(ends) == 1 and bool(row[FACING[t.kind is RouteKind.SHUNT]])
            names = {f"{t.entry}{mark}" for mark in ("", "LD"[t.kind is RouteKind.SHUNT])}
            fulfilled = (g for g, needs in told if all(theirs.get(m) is x for m, x in needs))
            assert facing or names & {*fulfilled}, (r.id, t.id, h.kinds)


def test_the_other_function_of_the_own_signal_is_hostile_too() -> None:
    """A shunting movement from 11L into the track into which a train is to run from there comes from its own side: no
    column of facing routes tells of it."""
    layout, table = table_of("stations/daidoji")
    row = only(
        chinese_rows(chinese_table(layout, table)), 信号机名称="11L", 进路="至11LT股道", 方向="11LT|42ﾛT@42ﾛ.toe发车"
    )
    assert "11LD" in row["敌对信号"].split("、")


CROSSOVERS = """interlock: 1
name: crossovers
profile: cn
boundaries: {DW: {approach: da 800}, DE: {approach: db 800}, UW: {approach: ua 800}, UE: {approach: ub 800}}
tracks: {d: [DW, d1 200], dm: [d3 200], de: [d5 200, DE], u: [UW, u1 200], um: [u3 200], ue: [u5 200, UE]}
points:
  1A: {section: dT1, machine: 1, toe: d.end, normal: dm.start, reverse: 1B.reverse}
  1B: {section: uT1, machine: 1, toe: um.start, normal: u.end}
  2A: {section: dT2, machine: 2, toe: dm.end, normal: de.start, reverse: 2B.reverse}
  2B: {section: uT2, machine: 2, toe: ue.start, normal: um.end}
signals:
  D0: {from: DW, into: d1}
  D1: {from: d1, into: dT1}
  U0: {from: UW, into: u1}
  U1: {from: u1, into: uT1}
  D8: {from: DE, into: d5}
  D9: {from: d5, into: dT2}
  U8: {from: UE, into: u5}
  U9: {from: u5, into: uT2}
"""


def test_a_signal_that_is_hostile_over_either_crossover_and_not_straight_on_stands_under_both_conditions() -> None:
    """D1 leads to UE over 1 or over 2, and to DE over neither: no position is common to the two, and D1 was told to be
    hostile to U8-U9 whatever it leads to."""
    made = grown(CROSSOVERS)
    assert made is not None
    layout, table, _ = made
    found = chinese_rows(chinese_table(layout, table))
    assert "D1-DE" not in table.route[RouteId("U8-U9")].locking.hostile.routes
    assert only(found, 信号机名称="U8")["敌对信号"] == "U1、<(1A)>D1、<(2A)>D1"
    assert only(found, 信号机名称="D0")["敌对信号"] == "D9、<(1B)>U9、<(2B)>U9"
    assert only(found, 信号机名称="D8")["敌对信号"] == "<1A、2A>D1"


def test_facing_routes_are_told_of_a_track_that_is_left_on_a_signal_alone() -> None:
    """Nothing is shunted into q1 from W; a train that departs comes to no track, and its hostile signals are told."""
    row = only(rows(of_tests("undetected")), 信号机名称="D2")
    assert (row[FACING[0]], row[FACING[1]]) == ("q1", "")
    row = only(rows("fig2_1"), 方向="I发车", 信号机名称="SD")
    assert (row["敌对信号"], row[FACING[0]], row[FACING[1]]) == ("SV、SI", "", "")


def test_points_that_protect_an_overlap_stand_with_it() -> None:
    row = only(rows(of_tests("overlap_flank")), 信号机名称="XA1")
    assert row["其他联锁"] == "o1: 保护区段 x，侵限 y，道岔 1、[2]; o2: 保护区段 x，侵限 n2，道岔 (1)"
    assert row["道岔"] == "", "no points lie in its path"


def test_what_the_author_demands_is_told_points_sections_and_how_long_they_are_held() -> None:
    row = only(rows(of_tests("held_longer")), 信号机名称="A")
    assert row["道岔"] == "[2]" and row["其他联锁"] == "2 延时 30 s 解锁"
    assert only(rows(of_tests("held_longer")), 信号机名称="B")["其他联锁"] == ""
    clear = "demand:\n  - {clear: IIAG, routes: {from: X}, reason: oversize loads}\nsignals:"
    for signal, asks in (("X", True), ("S3", False)):
        found = [
            x["轨道区段"].split("、") for x in rows("passing_loop", **{"signals:": clear}) if x["信号机名称"] == signal
        ]
        assert found and all(("IIAG" in x) is asks for x in found)


def test_sections_between_a_route_and_what_protects_its_flank_are_asked_clear() -> None:
    """Where the principles ask for it: 21DG lies between the route over 17-23DG and what keeps vehicles from it."""
    asked = {}
    for space in ("no", "yes"):
        found = rows("cn6502", **{"profile: cn": f"profile: cn\nprinciples: {{flank_space: {space}}}"})
        asked[space] = only(found, 信号机名称="XD", 进路="至I股道")["轨道区段"]
    assert asked["yes"] == f"{asked['no']}、21DG"


def test_the_block_and_every_condition_that_a_route_asks_for_are_told() -> None:
    """BS is the block of a semi-automatic line alone; of another line the section beyond is asked clear, as other forms
    have it, and a token and what the author names stand by their own names."""
    hoist = "conditions:\n  HOIST: {text: hoist stopped, over: [IG]}\nsignals:"
    found = rows("passing_loop", **{"signals:": hoist})
    asked = {(x["信号机名称"], x["进路"]): x["其他联锁"] for x in found if not x["方向"].endswith("通过")}
    assert asked["X1", "由I股道"] == asked["X3", "由3股道"] == "BS"
    assert asked["S1", "由I股道"] == asked["S3", "由3股道"] == "XJG 空闲、direction at W"
    assert asked["X", "至I股道"] == asked["S", "至I股道"] == "HOIST" and asked["X", "至3股道"] == ""


def test_a_route_past_a_signal_has_points_sections_and_conditions_beyond_it_too() -> None:
    """Each once: there is no other row in which trains that pass T at identifier light are told of."""
    found = []
    for text in (POINTS_BEYOND, BEYOND):
        made = grown(text.replace("profile: de", "profile: cn"))
        assert made is not None
        found.append(only(chinese_rows(chinese_table(made[0], made[1])), 信号机名称="S", 进路="越过T至E"))
    assert [(x["道岔"], x["轨道区段"]) for x in found] == [("5", "c、d、p、f"), ("", "c、d、f")]
    assert found[1]["其他联锁"] == "Z not full、ape 空闲、LC9 关闭、BRIDGE、越过T（标志灯）"


def test_an_overlap_is_told_with_the_speed_for_which_it_is_made() -> None:
    """Not with that of the path, which is 60 km/h over P1."""
    told = [x["其他联锁"] for x in rows(of_tests("entry_speeds")) if x["信号机名称"] == "X2"]
    assert told == [
        "o1: 保护区段 q4、q5、q6，道岔 P2、P3; o2: 保护区段 q4、q7，道岔 (P2)，限速 40 km/h",
        "保护区段 q5、q6，道岔 (P3)、[(P2)]，限速 50 km/h",
    ]


def test_two_yellows_are_told_of_signals_that_show_them() -> None:
    """Where signals have two aspects there is no second yellow lamp, however the points lie."""
    shown = {x["信号机显示"] for x in rows("cn6502") if x["方向"].endswith("接车")}
    assert shown == {"U", "UU"}
    plain = rows("cn6502", **{"profile: cn": "profile: cn\nprinciples: {caution: never}"})
    assert {x["信号机显示"] for x in plain if x["方向"].endswith("接车")} == {"U"}
