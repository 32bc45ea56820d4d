"""What diagnostics propose: their numbers and names are right, and whoever follows them is rid of the diagnostic."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.diag import Diagnostic
from interlock.logic.lower import lower
from interlock.proof.system.loop import closed_loop
from interlock.proof.witnesses.routes import witnesses
from tests.cli_runs import run


def said(folder: Path, text: str, code: str) -> list[Diagnostic]:
    """The diagnostics of a code that `check` gives for a layout."""
    return [d for d in check_file(str(written(folder, text))).diagnostics if d.code == code]


def written(folder: Path, text: str) -> Path:
    """A file with a layout."""
    path = folder / "layout.yaml"
    path.write_text(text, "utf-8")
    return path


PARTS = """interlock: 1
name: parts
buffers: [B1, B2, B3, B4, B5, B6]
tracks:
  one: [B1, a 100, b 100, B2]
  two: [B3, c 100, d 100, B4]
  three: [B5, e 100, B6]
signals:
  S: {from: a, into: b}
  T: {from: c, into: d}
"""


def test_a_layout_that_falls_into_parts_is_told_once_for_each(tmp_path: Path) -> None:
    two, three = said(tmp_path, PARTS, "IL3010")
    assert "no train can reach sections c, d: the layout falls into 3 parts" in two.message
    assert "no train can reach section e: " in three.message and "not joined to the part of signal S" in three.message
    text = PARTS.replace("buffers: [B1, ", "boundaries:\n  B1: {approach: w 900}\nbuffers: [")
    assert all("this one is joined to no boundary" in d.message for d in said(tmp_path, text, "IL3010"))
    assert len(said(tmp_path, PARTS.partition("signals:")[0], "IL3010")) in (0, 3), "no boundary, no signal"


@pytest.mark.parametrize(("metres", "told"), [(49, True), (50, False), (59, False), (60, False)])
def test_the_joint_at_which_an_overlap_ends_lies_between_those_metres(tmp_path: Path, metres: int, told: bool) -> None:
    text = Path("tests/diagnostics/IL3043.yaml").read_text("utf-8")
    (before,) = said(tmp_path, text, "IL3043")
    assert "between 50 and 80 m beyond X" in before.fix
    split = f"X1 {metres}, q1 {60 - metres}" if metres < 60 else "X1 60"
    text = text.replace("a1 800, q1 60", f"a1 800, {split}")
    found = said(tmp_path, text.replace("from: a1, into: q1", "from: a1, into: X1"), "IL3043")
    assert bool(found) == told


SIDING = """interlock: 1
name: siding
principles: {line_speed_kmh: 60}
boundaries:
  W: {approach: wa 400}
  E: {approach: ea 400}
buffers: [B]
tracks:
  west: [W, a 300]
  east: [b 60, c 300, E]
  siding: [s 100, B]
points:
  P: {section: b, toe: west.end, normal: east.start, reverse: siding.start, legs: 5}
sections:
  s: {detected: no}
signals:
  XW: {from: W, into: a}
  XE: {from: E, into: c}
  A: {from: a, into: b}
  C: {from: c, into: b}
  S: {from: s, into: b, kind: combined}
"""


def test_a_section_without_detection_within_the_fouling_point_is_an_error(tmp_path: Path) -> None:
    """Routes past it could never be set; the witness run shows the same."""
    (found,) = said(tmp_path, SIDING, "IL4002")
    assert "5 m from it, where 15.5 m are needed, and s has no detection" in found.message
    assert "routes A-E, C-W can never be set" in found.message
    (joint,) = (d for d in said(tmp_path, SIDING, "IL3018") if "b|s" in d.message)
    assert "routes over the other leg of P require s clear" in joint.message and "10.5 m further out" in joint.fix
    assert undriven(tmp_path, SIDING) == {"A-E", "C-W"}
    assert undriven(tmp_path, SIDING.replace("legs: 5", "legs: 15.5")) == set()
    assert undriven(tmp_path, SIDING.replace("s: {detected: no}", "s: {}")) == set()


def undriven(folder: Path, text: str) -> set[str]:
    """The routes of a layout that no run of its controller can set and drive."""
    done = check_file(str(written(folder, text)))
    assert done.layout is not None and done.table is not None
    return {w.route for w in witnesses(closed_loop(done.layout, lower(done.layout, done.table))) if not w.ok}


def test_a_board_before_a_boundary_needs_a_joint_there(tmp_path: Path) -> None:
    text = Path("tests/mistakes/shunting_to_a_boundary.yaml").read_text("utf-8")
    (found,) = said(tmp_path, text, "IL4003")
    assert "give the last metres of m3 a section of their own" in found.fix and "`kind: limit`" in found.fix
    text = text.replace("m3 400", "m3 380, m4 20") + "  L: {from: m3, into: m4, kind: limit}\n"
    assert not said(tmp_path, text, "IL4003") and check_file(str(tmp_path / "layout.yaml")).ok


RING = """interlock: 1
name: ring
principles: {line_speed_kmh: 40}
boundaries:
  DEP: {approach: dx 300}
tracks:
  ring: [P1.normal, r1 150, r2 150, r3 150, P1.toe]
  dep: [DEP, d1 120, P1.reverse]
points:
  P1: {section: p}
signals:
  S1: {from: p, into: r1}
  S2: {from: r1, into: r2}
  S3: {from: r2, into: r3}
  S6: {from: r3, into: p}
  D: {from: DEP, into: d1}
  D2: {from: d1, into: p}
"""


def test_a_way_that_comes_back_to_its_own_section_lacks_a_signal(tmp_path: Path) -> None:
    (found,) = said(tmp_path, RING, "IL4003")
    assert found.message.endswith("signal D2: it meets p again") and "a signal is missing on the way" in found.fix
    assert not said(tmp_path, RING + "  U: {from: r2, into: r1}\n", "IL4003")


SHORT_BLOCKS = """interlock: 1
name: blocks
profile: uk
principles: {overlap_m: 0, line_speed_kmh: 60}
boundaries:
  A: {trains: in, approach: ax 400}
  O: {trains: out}
tracks:
  a: [A, a1 200, a2 60]
  o: [o1 60, o2 200, O]
  t: [t1 100, SAND]
traps: [SAND]
points:
  P: {section: p, toe: a.end, normal: o.start, reverse: t.start}
signals:
  S: {from: A, into: a1}
  S1: {from: a1, into: a2}
  S2: {from: a2, into: p}
  SO: {from: o1, into: o2}
overlaps:
  S1: {length: 180, not_over: [P.normal]}
"""


def test_an_overlap_past_a_signal_without_one_holds_the_train_that_ran_on_to_it(tmp_path: Path) -> None:
    """The planner, which knows nothing of the warning, finds no way through either, and one as soon as it is heeded."""
    (found,) = said(tmp_path, SHORT_BLOCKS, "IL7014")
    assert "no train runs through at S1" in found.message and "runs on to S2 stands in it there" in found.message
    assert "`overlaps: {S1: {length: 60}}`, without its `not_over`" in found.fix
    command = ("dispatch", str(tmp_path / "layout.yaml"), "1:A>O", "--length", "40")
    assert run(*command).exit_code == 1
    for old, new in (
        ("length: 180, not_over: [P.normal]", "length: 60"),
        ("P.normal", "P.reverse"),
    ):  # or it lies where trains run on
        assert not said(tmp_path, SHORT_BLOCKS.replace(old, new), "IL7014")
        assert run(*command).exit_code == 0 and "PLAN  4 routes" in run(*command).output


@pytest.mark.parametrize("name", ["P1", "A1"])
def test_a_name_that_two_elements_bear_is_told_where_a_substation_names_it(tmp_path: Path, name: str) -> None:
    text = Path("tests/diagnostics/IL7018.yaml").read_text("utf-8").replace("  P1: {from", f"  {name}: {{from")
    both = name == "P1"
    lists = text.replace("[P1]", f"[{name}]" if both else f"[P1, {name}]")
    found = said(tmp_path, lists, "IL7018")
    assert [d.message for d in found] == (
        ["substation hut: P1 is a machine of points and a signal, and all of it is wired there"] if both else []
    )
    allow = "allow:\n  - {lint: IL7018, at: [P1], reason: both hang there}\n"
    assert not said(tmp_path, lists + allow, "IL7018") and bool(said(tmp_path, lists + allow, "IL2018")) != both
    assert not said(tmp_path, text.partition("substations:")[0], "IL7018"), "nothing is ambiguous there"


@pytest.mark.parametrize(
    ("wrong", "fix"),
    [
        ("{from: k11, into: k20}", "did you mean k2?"),
        ("{from: k20, into: k11}", "did you mean k2?"),
        ("{from: k19, into: x}", "k19 meets: k18, k21"),
        ("{from: nowhere, into: k11}", "k11 meets: W, k2"),
        ("{from: k20, into: k30}", "did you mean k2?"),
    ],
)
def test_a_signal_into_no_section_is_told_those_that_meet_there(tmp_path: Path, wrong: str, fix: str) -> None:
    """k21, as like k20 as k2 is, lies a kilometre off, where no signal from k11 leads; only where nothing is known of
    the place, a name from anywhere may be meant."""
    text = "interlock: 1\nname: line\nboundaries: {W: {approach: w0 900}, E: {approach: e0 900}}\ntracks:\n"
    text += "  line: [W, k11 400, k2 400, k18 400, k19 400, k21 400, E]\nsignals:\n  X: {from: W, into: k11}\n"
    (found,) = said(tmp_path, f"{text}  Y: {wrong}\n", "IL2004")[:1]
    assert str(found.fix) == fix
