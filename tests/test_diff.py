"""What `interlock diff` tells of edits that are made every day: against what was edited, not against what it told."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.app.diff import Differences, diff
from interlock.app.pin import pin_file
from interlock.app.untold import PRINTED, REASONED
from interlock.logic.lower import lower
from interlock.table.columns import COLUMNS
from tests.cli_runs import run

BASE = """interlock: 1
name: base
principles: {line_speed_kmh: 60}
boundaries:
  W: {approach: wa 400}
  E: {approach: ea 400}
buffers: [B1]
tracks:
  west: [W, q1 200]
  main: [g1 500]
  loop: [g2 500]
  east: [q9 200, E]
  sid:  [s1 120, B1]
points:
  P1: {section: w1, toe: west.end, normal: main.start, reverse: loop.start, legs: 30}
  P2: {section: w2, toe: P3.normal, normal: main.end, reverse: loop.end, legs: 30}
  P3: {section: w2, toe: east.start, reverse: sid.start, legs: 30}
signals:
  A:  {from: W, into: q1}
  AA: {from: q1, into: w1}
  F:  {from: E, into: q9}
  FF: {from: q9, into: w2}
  N1: {from: g1, into: w2}
  N2: {from: g2, into: w2}
  S1: {from: g1, into: w1}
  S2: {from: g2, into: w1}
  LS: {from: s1, into: w2, kind: combined}
"""


class Edited:
    """A layout with some of its text replaced, and what that has changed."""

    def __init__(self, folder: Path, *edits: tuple[str, str], before: str = BASE) -> None:
        text = before
        for was, now in edits:
            assert was in text
            text = text.replace(was, now)
        self.old, self.new = folder / "old.yaml", folder / "new.yaml"
        self.old.write_text(before, "utf-8")
        self.new.write_text(text, "utf-8")
        self.found: Differences = diff(str(self.old), str(self.new))
        assert self.found.table is not None, [*self.found.old.diagnostics, *self.found.new.diagnostics]
        self.table = self.found.table
        self.shown = run("diff", str(self.old), str(self.new))
        assert self.shown.exit_code == (0 if self.found.same else 1)

    def cells(self, route: str) -> list[str]:
        """What has changed of a route, in words."""
        return [x.text for c in self.table.routes if c.route == route for x in c.cells]

    def elements(self) -> list[str]:
        """What has changed of elements and principles, in words."""
        return [x.text for x in (*self.found.principles, *self.found.elements)]


def test_a_file_does_not_differ_from_itself_in_another_order(tmp_path: Path) -> None:
    signals = BASE.partition("signals:\n")[2].splitlines(keepends=True)
    same = Edited(tmp_path, ("".join(signals), "".join(reversed(signals))))
    assert same.found.same and not same.found.elsewhere and "nothing differs" in same.shown.output


def test_a_derailer_is_told_with_its_cells(tmp_path: Path) -> None:
    derailer = "derailers:\n  D1: {section: w2, inner: P3.reverse, outer: sid.start}\n"
    e = Edited(tmp_path, ("reverse: sid.start, ", ""), ("signals:", f"{derailer}signals:"))
    assert e.cells("N1-E") == ["Flank points: D1 N added", "Flank protection: P3.reverse: D1 N, was P3.reverse: LS"]
    assert "point: D1 (derailer, in w2, fouling point 1 m) added" in e.elements()
    assert "FF-S1, FF-S2, N1-E, N2-E\n  Flank points: D1 N added\n" in e.shown.output
    assert "6 routes changed" in e.shown.output
    body = json.loads(run("diff", str(e.old), str(e.new), "--format", "json").stdout)
    assert not body["ok"] and body["same"] is False and not body["added"]
    (cell, _) = next(r["cells"] for r in body["routes"] if r["route"] == "N1-E")
    assert (cell["what"], cell["was"], cell["now"], cell["rule"]) == ("Flank points", None, "D1 N", "R5")


def test_a_signal_that_is_called_otherwise_takes_its_routes_along(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("N1:", "N7:"))
    assert [(c.was, c.route) for c in e.table.routes if c.was != c.route] == [("AA-N1", "AA-N7"), ("N1-E", "N7-E")]
    assert not e.table.added and not e.table.removed
    assert e.cells("AA-N2") == [], "AA-N7 is hostile to it as AA-N1 was"
    assert e.cells("N7-E") == ["Entry signal: N7, was N1"]
    assert e.cells("N2-E") == ["Flank protection: P2.normal: N7, was P2.normal: N1"]


def test_a_signal_that_is_gone(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("  LS: {from: s1, into: w2, kind: combined}\n", ""))
    assert [r.id for r in e.table.removed] == ["LS-E"] and not e.table.added
    assert "route LS-E removed: main, over w2, q9, hostile to" in e.shown.output
    assert e.elements() == ["signal: LS (combined, from s1 into w2) removed"]


def test_two_signals_that_exchange_their_names_are_no_renaming(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("N1:", "NX:"), ("N2:", "N1:"), ("NX:", "N2:"))
    assert all(c.was == c.route for c in e.table.routes) and not e.found.same
    assert "Points: P2 R, was P2 N" in e.cells("N1-E")


def test_points_that_exchange_their_names_are_told_in_their_new_order(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("P2", "PX"), ("P3", "P2"), ("PX", "P3"))
    assert "Points, in order: P3 N, P2 N, was P2 N, P3 N" in e.cells("N1-E")


def test_a_joint_that_is_moved_changes_lengths_alone(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("east: [q9 200, E]", "east: [w2 60, q9 140, E]"))
    assert e.elements() == ["section q9: 140 m, was 200 m", "section w2: 240 m, was 180 m"]
    assert e.cells("F-FF") == ["Length (m): 140, was 200"] and e.cells("N1-E") == []


def test_a_section_that_is_split(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("[g1 500]", "[g1 200, g1b 300]"), ("N1: {from: g1,", "N1: {from: g1b,"))
    assert "Sections clear: g1b added" in e.cells("AA-N1")
    assert "section: g1b (300 m) added" in e.elements()
    assert "signal N1: from g1b into w2, was from g1 into w2" in e.elements()


def test_a_siding_that_is_added_is_told_once_and_not_of_every_hostile_route(tmp_path: Path) -> None:
    e = Edited(
        tmp_path,
        ("buffers: [B1]", "buffers: [B1, B2]"),
        ("  sid:", "  new: [n1 100, B2]\n  sid:"),
        (
            "reverse: sid.start, legs: 30}",
            "reverse: P4.toe, legs: 30}\n  P4: {section: w2, normal: sid.start, reverse: new.start, legs: 30}",
        ),
        ("  LS:", "  LN: {from: n1, into: w2, kind: combined}\n  LS:"),
    )
    assert {r.id for r in e.table.added} == {"LN-E", "FF-B2"}
    assert not any("LN-E" in x or "FF-B2" in x for c in e.table.routes for x in [y.text for y in c.cells])
    assert "Points: P4 N added" in e.cells("LS-E")


def test_an_overlap_that_is_taken_away(tmp_path: Path) -> None:
    with_overlaps = BASE + "overlaps:\n  N2: {length: 50}\n"
    e = Edited(tmp_path, ("overlaps:\n  N2: {length: 50}\n", ""), before=with_overlaps)
    assert e.elements() == ["signal N2: overlap 50 m removed"]
    assert "Overlap: w2 removed" in e.cells("AA-N2")
    assert "Hostile routes: AA-N2 (overlap) removed" in e.cells("N1-E")
    assert "  Overlap points: P2 R, P3 N removed\n" in e.shown.output


def test_principles_are_told_though_no_cell_shows_them(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("{line_speed_kmh: 60}", "{line_speed_kmh: 60, release_delay_s: 5}"))
    assert e.elements() == ["release_delay_s: 5, was 3"]
    assert e.table.none and not e.found.same and "no cell of the table differs" in e.shown.output


def test_a_voyage_and_an_automatic_route(tmp_path: Path) -> None:
    more = "automatic: [{from: A, to: AA}]\nvoyages:\n  V: {from: A, to: N1}\n"
    e = Edited(tmp_path, ("signals:", f"{more}signals:"))
    assert [x.text for x in e.table.automatic] == ["automatic working: A-AA added"]
    assert e.table.voyages[0].text.startswith("voyage: V (Routes: A-AA, AA-N1") and "voyage: V" in e.shown.output


def test_one_line_for_each_change(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("N1:", "N7:"))
    lines = run("diff", str(e.old), str(e.new), "--format", "concise").output.splitlines()
    assert "N7-E: was called N1-E" in lines and "N7-E: Entry signal: N7, was N1" in lines
    assert "AA-N2: No.: 2, was 3" in lines


def test_of_layouts_with_errors_their_diagnostics_are_shown(tmp_path: Path) -> None:
    good = tmp_path / "good.yaml"
    good.write_text(BASE, "utf-8")
    for args in ((good, "missing.yaml"), ("missing.yaml", good)):
        done = run("diff", *map(str, args))
        assert done.exit_code == 1 and "IL1001" in done.output
        body = json.loads(run("diff", *map(str, args), "--format", "json").stdout)
        assert body["same"] is None and [d["code"] for d in body["diagnostics"]] == ["IL1001"]


@pytest.mark.parametrize(("name", "profile"), [("mine11", "de"), ("pit_bottom", "cn"), ("depot", "uk")])
def test_every_cell_that_differs_is_told(tmp_path: Path, name: str, profile: str) -> None:
    """Of a shipped layout by the principles of another railway, against the texts of its cells, one by one."""
    text = Path(f"layouts/{name}.yaml").read_text("utf-8")
    other = tmp_path / "other.yaml"
    other.write_text(re.sub(r"^profile: \w+$", f"profile: {profile}", text, flags=re.MULTILINE), "utf-8")
    old, new = check_file(f"layouts/{name}.yaml").table, check_file(str(other)).table
    found = diff(f"layouts/{name}.yaml", str(other)).table
    assert old is not None and new is not None and found is not None
    assert {r.id for r in found.added} == new.route.keys() - old.route.keys()
    assert {r.id for r in found.removed} == old.route.keys() - new.route.keys()
    told = {c.route: c.cells for c in found.routes}
    shown = [c for c in COLUMNS if c.key not in ("number", "route")]
    seen = 0
    for r in old.route.keys() & new.route.keys():
        for c in shown:
            was, now = ([t for t, _ in c.items(x.route[r])] for x in (old, new))
            if c.key == "hostile":
                both = tuple(f"{x} (" for x in old.route.keys() & new.route.keys())
                was, now = (sorted(t for t in x if t.startswith(both)) for x in (was, now))
            cells = [x for x in told.get(r, ()) if x.what.removesuffix(", in order") == c.en]
            assert bool(cells) == (was != now), (r, c.en, was, now)
            if cells and not cells[0].what.endswith(", in order"):
                assert {x.was for x in cells} - {None} == {*was} - {*now}
                assert {x.now for x in cells} - {None} == {*now} - {*was}
            seen += bool(cells)
    assert seen > 10


# --- layouts whose tables look alike --------------------------------------------------------------


def of(name: str) -> str:
    """A layout of the tests."""
    return Path(f"tests/layouts_for_tests/{name}.yaml").read_text("utf-8")


def equations(path: str) -> dict[str, object]:
    """What a controller computes and how long it waits."""
    one = check_file(path)
    assert one.layout is not None and one.table is not None
    made = lower(one.layout, one.table)
    return {"steps": made.steps, "next": made.next, "timers": made.timers, "outputs": made.outputs}


HELD = BASE.replace("signals:", "exclude:\n  - {from: LS, to: E, reason: none is wanted}\nsignals:")
HOISTED = Path("layouts/incline_hoist.yaml").read_text("utf-8")


def test_a_further_reason_of_routes_that_are_hostile_already(tmp_path: Path) -> None:
    """The printed cell names the first class alone; the second keeps them apart for longer, by equations of its own."""
    e = Edited(tmp_path, ("other: {from: E2, to: S2}", "other: {from: E2}"), before=of("added"))
    assert equations(str(e.old)) != equations(str(e.new))
    added = "Also hostile: E2-S1 (declared hostile: the platform between the roads is narrow) added"
    assert e.cells("A2-N1") == [added] and added.replace("E2-S1", "A2-N1") in e.cells("E2-S1")
    assert not e.found.elsewhere and "declared hostile" in e.shown.output


@pytest.mark.parametrize(
    ("before", "was", "now", "told"),
    [
        (
            of("slow_barrier"),
            "text: mill road, supervision: 20",
            "text: mill road, supervision: 40",
            "device LC: supervision 40 s, was supervision 20 s",
        ),
        (of("slow_barrier"), "text: mill road", "text: a road", "device LC: a road, was mill road"),
        (of("one_way_rear"), "sections:\n  l1: {one_way: backward}\n", "", "section l1: one way to W removed"),
        (of("overlap_one_way"), "one_way: ", "lane: inclined, one_way: ", "section l3: inclined added"),
        (HOISTED, "  i2: {lane: inclined}\n", "", "section i2: inclined removed"),
        (
            HOISTED,
            "text: nobody on the incline",
            "text: nobody in the lane",
            "condition NO_PERSON: nobody in the lane, was nobody on the incline",
        ),
        (
            of("overlap_inside"),
            "X: {length: 60, entry_speed: 40, ways: [{over: [T], length: 150}]}",
            "X: {length: 60, entry_speed: 40, ways: [{over: [T], length: 140}]}",
            "signal X: overlap over T 140 m, was overlap over T 150 m",
        ),
    ],
)
def test_what_no_cell_shows_is_told_of_its_element(tmp_path: Path, before: str, was: str, now: str, told: str) -> None:
    e = Edited(tmp_path, (was, now), before=before)
    assert told in e.elements() and e.shown.exit_code == 1 and not e.found.elsewhere


def test_a_route_that_is_not_printed_any_more(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("into_1: {from: Y, to: S1, listed: no}", "into_1: {from: Y, to: S1}"), before=of("added"))
    assert e.cells("Y-S1") == ["Listed: yes, was no"] and not e.found.elsewhere and not e.found.same


@pytest.mark.parametrize(
    ("more", "key"),
    [
        ("target: {cpu: s7-315t-2dp}\n", "target"),
        ("substations:\n  KA: [A, AA]\n  KB: []\n", "substations"),
        ("exclude:\n  - {from: A, kind: shunt, reason: none is wanted}\n", "excluded"),
    ],
)
def test_what_is_told_by_nothing_is_not_passed_over(tmp_path: Path, more: str, key: str) -> None:
    e = Edited(tmp_path, ("signals:", f"{more}signals:"), before=BASE)
    assert key in e.found.elsewhere and not e.found.same and e.shown.exit_code == 1
    said = "table, elements and principles are equal, but the layouts are not: they differ in "
    assert said in e.shown.output and key in e.shown.output
    body = json.loads(run("diff", str(e.old), str(e.new), "--format", "json").stdout)
    assert body["same"] is False and key in body["elsewhere"]
    assert run("diff", str(e.old), str(e.new), "--format", "concise").exit_code == 1


@pytest.mark.parametrize(
    ("before", "was", "now", "key"),
    [
        (BASE, "name: base", "name: base\ntitle: Base", "title"),
        (BASE, "name: base", "name: base\ntitle_block: {company: Mine}", "title_block"),
        (BASE, "{approach: wa 400}", "{approach: wa 400, label: to the port}", "labels"),
        (BASE, "signals:", "drawing: {g2: 1}\nsignals:", "drawing"),
        (BASE, "P1: {section", "P1: {xy: [300, 200], section", "anchors"),
        (HELD, "reason: none is wanted", "reason: nobody drives there", "excluded"),
    ],
)
def test_what_is_only_printed_is_said_to_be_so(tmp_path: Path, before: str, was: str, now: str, key: str) -> None:
    e = Edited(tmp_path, (was, now), before=before)
    assert e.found.same and not e.found.elsewhere and e.found.printed == (key,)
    assert f"nothing differs but what is only printed: {key}" in e.shown.output and e.shown.exit_code == 0
    assert equations(str(e.old)) == equations(str(e.new))
    body = json.loads(run("diff", str(e.old), str(e.new), "--format", "json").stdout)
    assert body["same"] is True and body["printed"] == [key] and body["elsewhere"] == []


def test_no_other_facts_are_taken_for_printed(tmp_path: Path) -> None:
    """Neither beside a title, nor beside a reason."""
    target = ("name: base", "name: base\ntitle: Base\ntarget: {cpu: s7-315t-2dp}")
    e = Edited(tmp_path, target)
    assert e.found.elsewhere == ("target",) and e.found.printed == ("title",) and e.shown.exit_code == 1
    other = Edited(tmp_path, ("{from: LS, to: E,", "{from: LS, to: E, via: [q9],"), before=HELD)
    assert other.found.elsewhere == ("excluded",) and other.shown.exit_code == 1
    assert {"title", "title_block", "labels", "drawing", "anchors"} == PRINTED
    assert {"excluded", "barred", "demanded", "waivers"} == REASONED


@pytest.mark.parametrize(
    ("more", "key"),
    [
        ("addresses: {CLR_q1: I4.0}\n", "addresses"),
        ("substations: {KA: [A, AA], KB: []}\n", "substations"),
        ("telegram: plain\n", "telegram"),
        ("health: {main: {by: diagnosis}}\n", "health"),
        ("exclude: [{from: A, kind: shunt, reason: r}]\n", "excluded"),
        ("target: {cpu: s7-315t-2dp}\n", "target"),
    ],
)
def test_what_is_told_by_nothing_is_not_passed_over_beside_what_is(tmp_path: Path, more: str, key: str) -> None:
    e = Edited(tmp_path, ("kmh: 60", "kmh: 60, release_delay_s: 5"), ("signals:", f"{more}signals:"))
    assert e.elements() == ["release_delay_s: 5, was 3"] and e.found.elsewhere == (key,)
    assert f"besides, the layouts differ in {key}" in e.shown.output
    body = json.loads(run("diff", str(e.old), str(e.new), "--format", "json").stdout)
    assert body["elsewhere"] == [key]


def test_what_is_gone_and_told_by_nothing_is_not_passed_over(tmp_path: Path) -> None:
    """As what has come."""
    e = Edited(tmp_path, ("telegram: plain\n", ""), before=BASE.replace("signals:", "telegram: plain\nsignals:"))
    assert e.found.elsewhere == ("telegram",) and not e.found.same


def test_lengths_that_no_section_tells_are_not_passed_over_beside_those_that_one_does(tmp_path: Path) -> None:
    """The legs of P2 and P3 have other lengths, and their section the same."""
    legs = ("normal: main.end, reverse: loop.end, legs: 30", "normal: main.end, reverse: loop.end, legs: 40")
    shorter = ("reverse: sid.start, legs: 30", "reverse: sid.start, legs: 20")
    e = Edited(tmp_path, legs, shorter, ("g1 500", "g1 600"))
    told = [x for x in e.elements() if x.startswith("section")]
    assert told == ["section g1: 600 m, was 500 m"] and e.found.elsewhere == ("edges",)


@pytest.mark.parametrize(
    "edits",
    [
        [("q9", "q_9")],
        [("P2", "P7")],
        [("g1 500", "g1 300, g1b 200"), ("N1: {from: g1,", "N1: {from: g1b,")],
        [("west: [W, q1 200]", "west: [W, q1 160, w1 40]")],
        [("  N1: {from: g1, into: w2}\n", "")],
        [("wa 400", "wa 350")],
        [("legs: 30}\nsignals:", "legs: 30}\noverlaps: {N1: {length: 50}}\nsignals:")],
    ],
)
def test_what_is_told_of_elements_is_not_told_twice(tmp_path: Path, edits: list[tuple[str, str]]) -> None:
    assert Edited(tmp_path, *edits).found.elsewhere == ()


def test_numbers_are_told_with_all_their_digits(tmp_path: Path) -> None:
    e = Edited(tmp_path, ("kmh: 60", "kmh: 60, approach_release_s: 1234.569"), ("g1 500", "g1 500.0004"))
    assert e.elements()[0].startswith("approach_release_s: 1234.569, was")
    assert "section g1: 500.0004 m, was 500 m" in e.elements()


@pytest.mark.parametrize(
    ("was", "now", "told"),
    [
        (
            ["q1: {CLR_q1: I0.4}", "q9: {CLR_q9: I0.5}"],
            ["q1: {CLR_q1: I0.5}", "q9: {CLR_q9: I0.4}"],
            ["channel CLR_q1: main I0.5, was main I0.4", "channel CLR_q9: main I0.4, was main I0.5"],
        ),
        (["3: Q0,"], ["6: Q0,"], ["card in slot 3 of main: Q0 removed", "card in slot 6 of main: Q0 added"]),
        (
            ["channels:"],
            ["reserved:\n  main:\n    q77: {CLR_q77: I2.7}\nchannels:"],
            ["reserved channel CLR_q77: main I2.7 added"],
        ),
        ([], [], []),
    ],
)
def test_channels_that_are_pinned_otherwise_are_told(
    tmp_path: Path, was: list[str], now: list[str], told: list[str]
) -> None:
    (tmp_path / "old").mkdir()
    (tmp_path / "new").mkdir()
    old, new = tmp_path / "old" / "base.yaml", tmp_path / "new" / "base.yaml"
    for layout in (old, new):
        layout.write_text(BASE, "utf-8")
    pin_file(str(old)).write(False)
    text = old.with_suffix(".pins").read_text("utf-8")
    for before, after in zip(was, now, strict=True):
        assert before in text
        text = text.replace(before, after)
    new.with_suffix(".pins").write_text(text, "utf-8")
    found = diff(str(old), str(new))
    assert [c.text for c in found.channels] == told and found.same is not bool(told)
    shown = run("diff", str(old), str(new))
    assert shown.exit_code == (1 if told else 0) and all(x in shown.output for x in told)
    assert [c["what"] for c in json.loads(run("diff", str(old), str(new), "--format", "json").stdout)["channels"]] == [
        x.partition(":")[0] for x in told
    ]


def test_that_nothing_is_pinned_any_more_is_told_once(tmp_path: Path) -> None:
    (tmp_path / "old").mkdir()
    (tmp_path / "new").mkdir()
    old, new = tmp_path / "old" / "base.yaml", tmp_path / "new" / "base.yaml"
    for layout in (old, new):
        layout.write_text(BASE, "utf-8")
    pin_file(str(old)).write(False)
    assert [c.text for c in diff(str(old), str(new)).channels] == ["pins: none, was channels are pinned"]
