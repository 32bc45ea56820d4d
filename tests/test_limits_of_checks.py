"""Just enough, and just too little: where a diagnostic begins, from its trigger with one thing changed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.diag import Diagnostic
from interlock.frontend.checks.principles import USUAL
from tests.layouts import SLIPS


def told(tmp_path: Path, name: str, *edits: tuple[str, str]) -> list[Diagnostic]:
    """What is said of a diagnostic's trigger with some of its text changed."""
    text = Path(f"tests/diagnostics/{name}.yaml").read_text("utf-8")
    for old, new in edits:
        assert old in text, old
        text = text.replace(old, new)
    path = tmp_path / "edited.yaml"
    path.write_text(text, "utf-8")
    return list(check_file(str(path)).diagnostics)


def said(tmp_path: Path, name: str, *edits: tuple[str, str]) -> list[str]:
    """The messages of the diagnostic itself."""
    return [d.message for d in told(tmp_path, name, *edits) if d.code == name]


Edits = tuple[tuple[str, str], ...]
AS_SPEED_IS_RUN: Edits = (("{speed: 40}", "{speed: 80}"),)
SLIPS_INTO_ZONE: Edits = (("kind: combined", "kind: main"),)


@pytest.mark.parametrize(
    ("code", "edits", "count"),
    [
        # the length of an overlap for the speed at which trains come, or for none
        ("IL3044", (), 1),
        ("IL3044", AS_SPEED_IS_RUN, 0),
        ("IL3044", (("{speed: 40}", "{speed: 40, length: 60}"),), 0),
        # a derailer at the very end of the overlap is taken off for nothing, too; one before it is in the way
        ("IL3043", (), 1),
        ("IL3043", (("length: 50", "length: 80"),), 1),
        ("IL3043", (("length: 50", "length: 81"),), 0),
        # a zone into which an overlap leads, over whichever joint and alternative, and in which vehicles are shunted
        ("IL3022", (), 2),
        ("IL3022", SLIPS_INTO_ZONE, 1),
        ("IL3022", (("INSIDE: {sections: [q2, q3, q4]", "INSIDE: {sections: [q1, q2, q3, q4]"),), 2),
        ("IL3022", (("INSIDE: {sections: [q2, q3, q4]", "INSIDE: {sections: [q4]"), *SLIPS_INTO_ZONE), 1),
        ("IL3022", (("INSIDE: {sections: [q2, q3, q4]", "INSIDE: {sections: [q3]"), *SLIPS_INTO_ZONE), 1),
        # bytes of a telegram whose tags tell them apart; points by hand are in none
        ("IL3046", (), 1),
        ("IL3046", (("P13: {section: d,", "P13: {section: d, work: hand,"),), 0),
        # inclined lanes, each over which no condition and no device asks for anything
        ("IL3021", (), 1),
        ("IL3021", (("sections:\n", "conditions: {HOIST: {text: stopped, over: [q1]}}\nsections:\n"),), 0),
        ("IL3021", (("sections:\n", "interlocks: {GATE: {text: gate, over: [q1]}}\nsections:\n"),), 0),
        ("IL3021", (("sections:\n", "conditions: {HOIST: {text: stopped, over: [q3]}}\nsections:\n"),), 1),
        # names that stand twice, entries that say the same for whatever reason
        ("IL1022", (), 3),
        ("IL1022", (("{to: W, from: X2, reason: nor there}", "{to: W, from: X5, reason: nor there}"),), 2),
        ("IL1022", (("[q3, q4, q3]", "[q3, q4]"),), 2),
        # a berth under a door
        ("IL3025", (), 1),
        ("IL3025", (("over: [k2]", "over: [t1]"),), 0),
        # a section that is no berth anyway
        ("IL3031", (), 1),
        ("IL3031", (("p1: {berth: no}", "l2: {berth: no}"),), 0),
    ],
)
def test_a_diagnostic_begins_where_it_should(tmp_path: Path, code: str, edits: Edits, count: int) -> None:
    assert len(said(tmp_path, code, *edits)) == count, told(tmp_path, code, *edits)


@pytest.mark.parametrize(
    ("written", "why"),
    [
        *(("1.250", "no point divides thousands"), ("12.500", "no point divides thousands")),
        *(("125.000", "no point divides thousands"), ("1250", ""), ("0.5", "shorter than 5 m"), ("5", "")),
        *(("4.99", "shorter than 5 m"), ("30000", ""), ("30001", "longer than 30 km")),
    ],
)
def test_a_length_is_doubted_beyond_what_is_usual_or_where_a_point_may_divide_thousands(
    tmp_path: Path, written: str, why: str
) -> None:
    found = [d for d in told(tmp_path, "IL3021", ("q1 400", f"q1 {written}")) if d.code == "IL7005"]
    assert [why in d.message for d in found] == [True] * bool(why), found


FAST = ("profile: mine", "profile: generic")


@pytest.mark.parametrize(
    ("written", "codes"),
    [
        *(("q1 3, q1 3", ["IL3037"]), ("q1 2, q1 2", ["IL7005"]), ("q1 20, q1 20", [])),
        *(("q1 20000, q1 20000", ["IL7005"]), ("0+000, q1, 0+003, q1 3", ["IL3037"])),
    ],
)
def test_a_section_that_is_written_in_pieces_is_as_long_as_all_of_them(
    tmp_path: Path, written: str, codes: list[str]
) -> None:
    """A piece of 3 m was told to be the section, and that a train may run through the 6 m unseen was not told."""
    found = [d for d in told(tmp_path, "IL3021", ("[W, q1 400]", f"[W, {written}]"), FAST) if "q1" in d.message]
    assert [d.code for d in found if d.code in ("IL7005", "IL3037")] == codes, found


def test_each_kind_of_pointwork_has_its_legs_looked_at(tmp_path: Path) -> None:
    """Each leg of a point, a derailer and a slip."""
    derailer = ("outer: t.end}", "outer: t.end, legs: 301}")
    assert any("each leg of derailer G" in d.message for d in told(tmp_path, "IL3043", derailer))
    assert any(
        "each leg of point 1" in d.message
        for d in told(tmp_path, "IL3043", ("normal: n.start", "normal: n.start, legs: 1"))
    )
    slip = tmp_path / "slip.yaml"
    slip.write_text(SLIPS % ", legs: 301", "utf-8")
    found = [d.message for d in check_file(str(slip)).diagnostics if d.code == "IL7005"]
    assert found == ["each leg of slip 7 is 301 m long, longer than 300 m"]


@pytest.mark.parametrize(
    ("edits", "text"),
    [
        ((("q1: {lane: inclined}", "q3: {one_way: forward}"),), "no train comes to X2"),
        ((("q1: {lane: inclined}", "q1: {lane: inclined, one_way: backward}"),), "X7 leads against the only direction"),
        ((("W: {approach: ap_W 100}", "W: {trains: out}"),), "X7 is an entry signal, but trains only leave at W"),
        ((("W: {approach: ap_W 100}", "W: {approach: ap_W 100, trains: in}"),), ""),
    ],
)
def test_signals_that_govern_nothing(tmp_path: Path, edits: Edits, text: str) -> None:
    found = [d.message for d in told(tmp_path, "IL3021", *edits) if d.code == "IL3019"]
    assert any(text in x for x in found) if text else not found, found


@pytest.mark.parametrize("name", USUAL)
def test_principles_are_taken_as_they_are_from_the_least_to_the_greatest_that_is_built(
    tmp_path: Path, name: str
) -> None:
    least, most, unit, _ = USUAL[name]
    layout = Path("tests/diagnostics/IL3021.yaml").read_text("utf-8")
    for value, count in ((least, 0), (most, 0), (least * 0.99, 1), (most * 1.01, 1)):
        path = tmp_path / "edited.yaml"
        path.write_text(layout.replace("profile: mine", f"profile: mine\nprinciples: {{{name}: {value:g}}}"), "utf-8")
        found = [d.message for d in check_file(str(path)).diagnostics if d.code == "IL3040"]
        assert len(found) == count and all(f"{name} is {value:g} {unit}" in x for x in found), (value, found)


def test_whoever_follows_the_advice_on_a_short_approach_or_section_is_not_told_again(tmp_path: Path) -> None:
    """The speed that is named suffices, and a higher one does not."""
    (short,) = said(tmp_path, "IL7006")
    assert "a train needs" in short
    (found,) = (d for d in told(tmp_path, "IL7006") if d.code == "IL7006")
    below = re.search(r"suffice below (\d+) km/h", found.fix)
    assert below is not None
    head = ("boundaries:", "principles: {line_speed_kmh: SPEED}\nboundaries:")
    for speed, count in ((int(below[1]) - 1, 0), (int(below[1]), 1)):
        assert len(said(tmp_path, "IL7006", (head[0], head[1].replace("SPEED", str(speed))))) == count


def test_a_boundary_over_which_trains_only_come_in_is_guarded_and_long_enough_too(tmp_path: Path) -> None:
    """`trains: in` is not `trains: out`."""
    enters = ("ap9 600, trains: out", "ap9 600, trains: in")
    (told_out,), (told_in,) = said(tmp_path, "IL3041"), said(tmp_path, "IL3041", enters)
    assert "a train that has left may still stand" in told_out and "a train that waits to come in may stand" in told_in
    unguarded = [d.message for d in told(tmp_path, "IL3041", enters) if d.code == "IL3011"]
    assert unguarded == ["trains can come in at W8, and no signal stands there"]
