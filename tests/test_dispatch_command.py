"""`interlock dispatch`: screens, exit codes, plan files, and what is told of bad input."""

from __future__ import annotations

import json
import re
from functools import lru_cache
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app.dispatch import dispatch
from interlock.app.replay import to_text
from interlock.cli.dispatch import command
from interlock.cli.simulate import command as simulate
from interlock.diag.codes import CODES


def run(*arguments: str) -> tuple[int, str]:
    done = CliRunner().invoke(command, arguments, catch_exceptions=False)
    return done.exit_code, done.output.removeprefix(f"{arguments[0]}: planning\n")


def simulated(*arguments: str) -> tuple[int, str]:
    done = CliRunner().invoke(simulate, arguments, catch_exceptions=False)
    return done.exit_code, done.output


@pytest.mark.parametrize(
    ("layout", "commands", "routes"),
    [
        ("passing_loop", ("7:W>E",), "7 X-X1, 7 X1-E"),
        ("passing_loop", ("7:E>W",), "7 S-S1, 7 S1-W"),
        ("passing_loop", ("7:W>E", "8:E>W"), "7 X-X1, 8 S-S3, 8 S3-W, 7 X1-E"),
        ("mine11", ("7:W>E",), "7 X7-X1, 7 X1-X3, 7 X3-E"),
    ],
)
def test_a_plan_leads_straight_on_where_that_is_free(layout: str, commands: tuple[str, ...], routes: str) -> None:
    code, text = run(f"layouts/{layout}.yaml", *commands)
    told = text.splitlines()
    assert ", ".join(" ".join(x.split()) for x in told[1:-1]) == routes
    assert code == 0 and told[-1].startswith("replayed on the controller with its plant: each granted within ")


CLOSE = """interlock: 1
name: close
boundaries: {W: {approach: aW 600}, E: {approach: aE 600}}
tracks: {t: [W, a 400, b 40], u: [c 300, d 400, E], v: [s 200, SAND]}
traps: [SAND]
points: {P: {section: p, toe: t.end, normal: u.start, reverse: v.start}}
signals:
  X: {from: W, into: a}
  A: {from: a, into: b}
  B: {from: b, into: p}
  C: {from: c, into: d}
  Y: {from: E, into: d}
overlaps: {A: {length: 150, not_over: [P.normal]}, B: {length: 100, not_over: [P.reverse]}}
"""
"""The overlap of A leads past B, over other points than routes, and shuts the route from A on until it is given up."""


def test_a_train_that_is_too_long_for_its_overlaps_is_told_so(tmp_path: Path) -> None:
    layout = tmp_path / "close.yaml"
    layout.write_text(CLOSE, "utf-8")
    code, text = run(str(layout), "1:W>E", "--length", "420")
    assert (
        code == 1 and "no chain of routes takes 1, 420 m long, from W to E: it does not stand in a, which has" in text
    )
    assert (
        "which has 400 m there; 423 m are needed\n" in text and "take a shorter train: one of 397 m could go\n" in text
    )
    # 400 m of track hold 397 m of train: a driver may stand 3 m short of their end
    code, text = run(str(layout), "1:W>E", "--length", "397.5")
    assert code == 1 and "no chain of routes takes 1, 397.5 m long, from W to E" in text
    code, text = run(str(layout), "1:W>E", "--length", "397")
    assert code == 0 and "each granted within" in text


def test_a_train_longer_than_the_way_to_the_next_signal_keeps_an_overlap_over_which_it_runs_on() -> None:
    """It stands in the overlap of the signal before, which leads on over its own way."""
    code, text = run("tests/layouts_for_tests/overlap_head.yaml", "1:W17>W", "--length", "300")
    assert code == 0 and "each granted within" in text


def test_an_overlap_that_is_never_given_up_is_planned_as_kept(tmp_path: Path) -> None:
    """Where no approach section tells whether more of a train is to come, it never counts as wholly before the signal:
    a plan was shown that fails on the controller, and in a shift the route was refused for ever."""
    seen, unseen = tmp_path / "seen.yaml", tmp_path / "unseen.yaml"
    seen.write_text(CLOSE, "utf-8")
    unseen.write_text(CLOSE.replace("W: {approach: aW 600}", "W: {}"), "utf-8")
    code, text = run(str(seen), "1:W>E", "--length", "20")
    assert code == 0 and "each granted within" in text
    code, text = run(str(unseen), "1:W>E", "--length", "20")
    assert code == 1 and "it keeps the overlap of A, as nothing reports that all of it is in a\n" in text
    assert "fix: give trains an `approach` section, or detection, before a, or shorten the overlap of A" in text


def test_a_train_turns_in_the_last_section_of_an_overlap_which_its_own_route_keeps() -> None:
    """R4: the overlap of N2 over the siding is given up while the train stands in it, and its points let it back."""
    code, text = run("tests/layouts_for_tests/overlaps.yaml", "1:W>sid>W", "--length", "20", "--timings", "3")
    assert code == 0 and "  1          N1-N2.o2\n" in text and "each granted within" in text, text
    assert "with the rule: 0 of 3 timings stand for ever" in text


@pytest.mark.parametrize("layout", ["heishan", "depot", "mine11", "cn6502"])
def test_a_command_that_is_proposed_can_be_carried_out(layout: str) -> None:
    """Not every boundary is reached from every other one: at heishan loaded trains alone leave over OUT."""
    _, text = run(f"layouts/{layout}.yaml", "?")
    proposed = re.search("in quotes for the shell: '(.*)'", text)
    assert proposed is not None and run(f"layouts/{layout}.yaml", proposed[1])[0] == 0


def test_the_rails_of_a_derailer_are_no_place() -> None:
    """They end a track, and it was proposed to send a train there."""
    for place in ("nowhere", "D1.of", "D1.off"):
        _, text = run("layouts/depot.yaml", f"1:LINE>{place}")
        assert f"there is no place {place}\n" in text and ".off" not in text.split("fix:")[1], text


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("12:q4/X5>E", "13:q4/X5>E"), "13:q4/X5>E: 13 begins in q4, where 12 stands"),
        (("1:q4/X5>E", "--length", "500"), "1:q4/X5>E: a train of 500 m does not stand in q4, which has 300 m there"),
        (("1:q4/X5>E", "--length", "300"), "which has 300 m there, 3 m of them left by drivers at its end"),
        (("1:W>E>W",), "1:W>E>W: 1 leaves at E, and does not come back in the same command"),
        (("1:W>E+q4+q3",), "1:W>E+q4+q3: no chain of routes takes 1 from W over q3, q4 to E"),
        (("in", "in"), "name the voyage once; command another train with a number of its own: '12:W>E+q4'"),
        (("1:W>E", "1:E>W"), "give each train a number of its own, or one command with both ways"),
        (("1:q4/X5>W",), "routes lead from q4 to E; name another place"),
        (("7 W E",), "7 W E: '7 W E' is neither a voyage nor"),
        (("7 W E",), "write 7:W>E"),
        (("7 W>E",), "write 7:W>E"),
        (("7;W>E",), "write 7:W>E"),
        (("W>E",), "write the locomotive's number before it: 12:W>E"),
        (("7",), "write number, origin and destination, in quotes for the shell: '12:E>W'"),
        (("7:W>",), "in quotes for the shell: '12:E>W'"),
        (("7\nW",), "in quotes for the shell: '12:E>W'"),
        (("1:W>q7",), "routes lead from W to E, X1, X3, X5; name another place"),
    ],
)
def test_what_cannot_be_commanded_is_told_with_its_reason(arguments: tuple[str, ...], told: str) -> None:
    code, text = run("layouts/mine11.yaml", *arguments)
    assert code == 1 and told in text, text


def test_a_command_that_a_shell_has_cut_is_told_where_a_terminal_shows_it() -> None:
    done = CliRunner().invoke(command, ["layouts/mine11.yaml", "12:W"])
    assert done.exit_code == 2 and done.stdout == "", "what is shown there lies in a file by now"
    assert "12:W names no destination. Put the command in quotes" in " ".join(done.stderr.split())


def test_the_shortest_deadlock_is_told_and_shown_on_the_controller() -> None:
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:E>W", "--explore")
    assert code == 0 and "states 18 (where each train stands, and by which route it came there), unsafe 2" in text
    assert "deadlocks 2 (by where the trains stand)" in text
    assert "1. 1 runs over X7-X1 and stands in q1." in text
    assert "4. 1 in q3 cannot go on: X3-E is blocked by 2." in text
    assert "refuses all 2 routes that are left" in text


def test_timings_with_the_rule_and_without() -> None:
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:E>W", "--timings", "6")
    assert code == 0 and "with the rule: 0 of 6 timings stand for ever" in text
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:E>W", "--timings", "6", "--without-rule")
    assert code == 1 and "without the rule: 6 of 6" in text and "X2-W: q3 is not clear" in text


def test_who_is_caught_is_told_to_be_so_and_not_what_was_wanting_before() -> None:
    """All four are due at once; the dispatcher has told in its first scan that none stands there yet."""
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:E>W", "3:W>E", "4:E>W", "--timings", "1")
    assert code == 1 and "  1: no plan exists: 1, 2" in text and "no train stands before" not in text, text


def test_trains_that_cannot_all_go_are_named() -> None:
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:W>E", "3:E>W", "4:E>W")
    *_, caught, assumed = text.splitlines()
    assert code == 1 and "no plan exists, shown by exhaustive search: " in caught and caught.endswith("are caught")
    assert assumed.startswith("assumed: every train stands at its origin already")


@pytest.mark.parametrize(
    ("arguments", "code", "told"),
    [
        (("1:W>E", "--failed", "P1:N"), 0, "  1          X1-X3\n"),
        (("1:W>E", "--failed", "P1:R"), 0, "  1          X1-X5\n"),
        (("1:W>E", "--failed", "P1"), 1, "exhaustive search: 1 is caught, with P1 in the way\n"),
        (("1:W>E", "--occupied", "q4"), 0, "  1          X1-X3\n"),
        (("1:W>E", "2:E>W", "--occupied", "q4"), 1, "exhaustive search: 1 and 2 are caught, with q4 in the way\n"),
        (("1:W>q3", "2:E>q10", "3:W>E", "--failed", "P2"), 1,
         "exhaustive search: 2 and 3 are caught, with P2 in the way\nthe others: can all go on\n"),
        (("1:W>E", "--failed", "P9"), 1, "error[IL6004]: P9: there is no machine or position of this name"),
        (("1:W>E", "--occupied", "q99"), 1, "error[IL6004]: there is no section q99"),
        (("1:W>E", "--occupied", "q4", "--explore"), 2, "a plan is made, and nothing is run or explored"),
    ],
)  # fmt: skip
def test_with_a_failed_point_or_a_lost_detection(arguments: tuple[str, ...], code: int, told: str) -> None:
    done, text = run("layouts/mine11.yaml", *arguments)
    assert done == code and told in text, text
    assert done != 0 or "replayed on the controller with its plant, where nothing has failed: each" in text


@pytest.mark.parametrize(("blocked", "over"), [("q3", "X1-X5"), ("q5", "X1-X5"), ("q4", "X1-X3"), ("q6", "X1-X3")])
def test_no_train_is_planned_through_what_the_dispatch_file_closes(blocked: str, over: str, tmp_path: Path) -> None:
    """The plan is replayed, and the trains run, with the section blocked."""
    file = tmp_path / "x.dispatch"
    file.write_text(
        "dispatch: 1\nlayout: mine11\nfleet: {1: {length: 60, at: bottom}}\nplaces:\n"
        "  bottom: {kind: waiting, at: W}\n  load: {kind: loading, at: q1}\n  tip: {kind: tipping, at: E}\n"
        f"orders: {{a: {{from: load, to: tip, trains: 1}}}}\nblocked: [{blocked}]\n",
        "utf-8",
    )
    code, text = run("layouts/mine11.yaml", "--orders", str(file), "--timings", "2", "--explore")
    assert code == 0 and f"  1          {over}\n" in text and "each granted within" in text, text
    assert "with the rule: 0 of 2 timings stand for ever" in text


def one_train(tmp_path: Path, layout: str, ways: tuple[str, str, str], blocked: str) -> str:
    """A dispatch file of one train with one order: over a boundary, to a section, out over a boundary."""
    file = tmp_path / f"{blocked}.dispatch"
    come, load, go = ways
    file.write_text(
        f"dispatch: 1\nlayout: {layout}\nfleet: {{1: {{length: 60, at: out}}}}\nplaces:\n"
        f"  out: {{kind: waiting, at: {come}}}\n  load: {{kind: loading, at: {load}, minutes: 5}}\n"
        f"  tip: {{kind: tipping, at: {go}, minutes: 5}}\norders: {{a: {{from: load, to: tip, trains: 1}}}}\n"
        f"blocked: [{blocked}]\n",
        "utf-8",
    )
    return str(file)


@pytest.mark.parametrize(
    ("ways", "blocked", "why"),
    [
        (("W", "q8", "E"), "q4", "need P2 reverse, which is not moved while q4 is blocked"),
        (("W", "q3", "W"), "q4", "have q4, which is blocked, as its overlap\n"),
        (("W", "q3", "W"), "q5", "have q5, which is blocked, as its overlap"),
    ],
)
def test_points_in_what_is_blocked_are_not_moved_for_flank_or_overlap(
    ways: tuple[str, str, str], blocked: str, why: str, tmp_path: Path
) -> None:
    """A plan was found with them, and the controller refused it for ever."""
    layout, file = "tests/layouts_for_tests/swing_condition.yaml", one_train(tmp_path, "swing_condition", ways, blocked)
    for done, text in (run(layout, "--orders", file), simulated(layout, "--dispatch", file)):
        assert done == 1 and "IL6016" in text and why in text, text


def test_with_a_blocked_section_another_overlap_is_taken_in_a_shift_too(tmp_path: Path) -> None:
    """The dispatcher asked for the first one that leads there, though its plan had the other."""
    file = one_train(tmp_path, "flank_lab", ("A", "g8", "B"), "g2")
    done, text = run("layouts/flank_lab.yaml", "--orders", file)
    assert done == 0 and "  1          SA-S1.o2\n" in text and "each granted within" in text, text
    done, text = simulated("layouts/flank_lab.yaml", "--dispatch", file)
    assert done == 0 and "trains tipped a shift: 1" in text, text


def test_a_train_is_loaded_where_it_stands_wholly_on_the_way_by_which_it_comes(tmp_path: Path) -> None:
    """p1 has 60 m over its derailer and 40 m on the way from E: a train of 40 m was let in there, was never wholly in
    p1, and stood for ever, "to be loaded"."""
    layout, file = "tests/layouts_for_tests/devices.yaml", Path(one_train(tmp_path, "devices", ("E", "p1", "W"), "sid"))
    for length, code in ((60, 1), (40, 1), (37, 0)):
        file.write_text(re.sub(r"length: \d+", f"length: {length}", file.read_text("utf-8")), "utf-8")
        for done, text in (run(layout, "--orders", str(file)), simulated(layout, "--dispatch", str(file))):
            assert done == code, text
            if length == 40:
                assert "[IL6005]" in text and "it does not stand in p1, which has 40 m there; 43 m are needed" in text
    assert "trains tipped a shift: 1" in text, text


def test_a_plan_is_written_and_replayed(tmp_path: Path) -> None:
    file = tmp_path / "plan.json"
    assert run("layouts/mine11.yaml", "in", "out", "--plan", str(file))[0] == 0
    code, text = run("layouts/mine11.yaml", "--replay", str(file))
    assert code == 0 and "each route granted within 2 scans" in text
    code, text = run("layouts/fig2_1.yaml", "--replay", str(file))
    assert code == 1 and "[IL6006]" in text and "another layout" in text
    file.write_text(file.read_text("utf-8")[:300])
    code, text = run("layouts/mine11.yaml", "--replay", str(file))
    assert code == 1 and "[IL6006]" in text
    assert run("layouts/mine11.yaml", "--replay", str(tmp_path / "none"))[0] == 1
    file.write_bytes(b"\xff\xfe\x00")
    assert "[IL6006]" in run("layouts/mine11.yaml", "--replay", str(file))[1]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"length_m": 60.0', '"length_m": NaN', "length_m: a number of metres is expected, 1 to 2000, not NaN"),
        ('"length_m": 60.0', '"length_m": -60', "not -60"),
        ('"length_m": 60.0', '"length_m": "60 m"', 'not "60 m"'),
        ('"length_m": 60.0', f'"length_m": {"9" * 5000}', "a number or a nesting that no plan has"),
        ('"comes": 0', '"comes": -1', "trains[0].comes: a whole number is expected, not -1"),
        ('"name": "out"', '"name": "in"', "train in is there twice"),
        ('"moves": [', '"moves": 5, "was": [', "moves: a list is expected"),
        ('"trains": [', '"trains": [null, ', "trains[0]: `comes` is missing"),
        ('"X7-X1"', '"X99-X1"', "over X99-X1, which is no route of the layout"),
        ('"moves": [', '"moves": [["77", "X7-X1"], ', "for 77, which is no train of the plan"),
        ('"interlock_plan": 1', '"interlock_plan": 2', "version 2 of plan files is not read here"),
        ('"interlock_plan": 1', '"plan": 1', "the key `interlock_plan` is missing"),
        ('"start": "W"', '"start": 5', "trains[0].start: a boundary, or a list of ways, is expected, not 5"),
        ("{", "[" * 60_000 + "{", "a number or a nesting that no plan has"),
        ('"trains"', "trains", "line 4, column 2: this is no plan file"),
    ],
)  # fmt: skip
def test_a_plan_that_was_changed_is_told_with_its_place(tmp_path: Path, old: str, new: str, said: str) -> None:
    file = tmp_path / "plan.json"
    file.write_text(written_plan().replace(old, new, 1), "utf-8")
    code, text = run("layouts/mine11.yaml", "--replay", str(file))
    assert code == 1 and "[IL6006]" in text and said in text and "fix: make it again with --plan" in text, text


@lru_cache
def written_plan() -> str:
    found = dispatch("layouts/mine11.yaml", ["in", "out"])
    assert found.plan is not None
    return to_text(found.plan)


def test_a_plan_overwrites_nothing_that_is_read(tmp_path: Path) -> None:
    layout = tmp_path / "mine11.yaml"
    layout.write_bytes(Path("layouts/mine11.yaml").read_bytes())
    before = layout.read_bytes()
    code, text = run(str(layout), "in", "--plan", str(layout), "--force")
    assert code == 1 and "is what is read" in text and layout.read_bytes() == before


def test_results_as_data() -> None:
    code, text = run("layouts/fig2_1.yaml", "V1", "V2", "--explore", "--format", "json")
    body = json.loads(text)
    assert code == 0 and body["verdict"] == "PLAN" and body["replayed"]["wrong"] is None
    assert body["explored"] == {
        "states": 25,
        "unsafe": 1,
        "deadlocks": 1,
        "deadlocked_states": 1,
        "moves_between_safe_states": 36,
        "moves_held_back": 2,
    }


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("layouts/mine11.yaml", "ouf"), "IL6004"),
        (("layouts/mine11.yaml", "1:W>Q"), "IL6004"),
        (("layouts/mine11.yaml", "in", "in"), "IL6004"),
        (("layouts/mine11.yaml", "1:W>E>W"), "IL6005"),
        (("layouts/mine11.yaml", "01:W>E", "1:E>W"), "IL6015"),
        (("layouts/mine11.yaml", "1:W>E+"), "IL6004"),
        (("layouts/mine11.yaml", "1：W>E"), "IL6004"),
        (("layouts/nothing.yaml", "in"), "IL1001"),
        (("layouts/rejected/no_provider.yaml", "in"), ""),
    ],
)
def test_bad_input_is_told_with_its_code(arguments: tuple[str, ...], code: str) -> None:
    done, text = run(*arguments)
    assert done == 1 and "Traceback" not in text
    assert f"[{code}]" in text if code else text


def test_every_code_of_dispatch_is_known() -> None:
    assert {c for c in CODES if c.startswith("IL6")} >= {"IL6001", "IL6004", "IL6005", "IL6006", "IL6007"}


GAP = "tests/layouts_for_tests/zone_with_a_gap.yaml"


def test_plans_count_zones_as_the_controller_does(tmp_path: Path) -> None:
    """A train in a zone that comes into it once more counts itself, one over two of its sections twice: what is planned
    without that is refused, and trains stand for ever."""
    code, text = run(GAP, "1:W>E", "2:E>W", "--length", "120", "--timings", "12")
    assert code == 0 and "each granted within" in text and "0 of 12 timings stand for ever" in text, text
    long = Path(GAP).read_text("utf-8").replace("Z2: {sections: [a2, b2, q2]", "Z2: {sections: [p3, a2, b2, p4]")
    (tmp_path / "long.yaml").write_text(long.replace("  Z1: {sections: [a1, b1], trains: 1}\n", ""), "utf-8")
    code, text = run(str(tmp_path / "long.yaml"), "1:W>E", "2:E>W", "3:W>E", "--length", "250")
    assert code == 0 and "each granted within" in text, text


FAR = """
interlock: 1
name: far
profile: mine
boundaries: {W: {approach: wa 200}, E: {approach: ea 200}}
tracks: {s0: [W, q0 200], a: [a1 200, a2 200], b: [b1 400], s1: [q1 200, E]}
points:
  P1: {section: t1, toe: s0.end, normal: a.start, reverse: b.start, legs: 20}
  P2: {section: t2, toe: s1.start, normal: a.end, reverse: b.end, legs: 20}
signals:
  XW: {from: W, into: q0}
  XE: {from: E, into: q1}
  I1: {from: q0, into: t1}
  O2: {from: q1, into: t2}
  Ma: {from: a1, into: a2}
  Ea: {from: a2, into: t2}
  Na: {from: a2, into: a1}
  Va: {from: a1, into: t1}
  Eb: {from: b1, into: t2}
  Vb: {from: b1, into: t1}
voyages: {wi: {from: XW, to: a2, via: [a1], order: far}}
"""


def test_the_story_of_a_deadlock_has_every_route_with_its_train(tmp_path: Path) -> None:
    """A train all whose routes are set at once, from the far end, and another one that comes against it."""
    (tmp_path / "far.yaml").write_text(FAR, "utf-8")
    _, text = run(str(tmp_path / "far.yaml"), "wi", "2:E>W+a1", "--explore")
    assert "wi runs over XW-I1, I1-Ma and Ma-Ea and stands in a2." in text, text
    assert "2 runs over XE-O2 and stands in q1." in text
