"""Warnings of usual practice: what they find, where they are silent, and how a layout departs from practice."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from interlock.app.check import Checked, check_file
from interlock.app.init import STARTER, line, yard
from interlock.diag import Element, Severity
from interlock.diag.codes import LINTS
from interlock.logic.lower import lower
from interlock.proof.engines.limits import Limits
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.proof.witnesses.availability import availability
from interlock.proof.witnesses.routes import witnesses
from tests.test_at_stop import RELEASE_POINTS


def station(tracks: int) -> str:
    """A station of parallel tracks between two lines, with starting signals at both ends of each."""
    rows, points, signals = [], [], ["  XW: {from: W, into: ww}", "  XE: {from: E, into: ee}"]
    for k in range(1, tracks + 1):
        rows.append(f"  t{k}: [g{k} 500]")
        signals += [f"  S{k}: {{from: g{k}, into: w{min(k, tracks - 1)}}}"]
        signals += [f"  X{k}: {{from: g{k}, into: e{min(k, tracks - 1)}}}"]
    for p, end in (("w", "start"), ("e", "end")):
        for k in range(1, tracks):
            toe = f", toe: {'west.end' if p == 'w' else 'east.start'}" if k == 1 else ""
            on = f"{p.upper()}{k + 1}.toe" if k < tracks - 1 else f"t{tracks}.{end}"
            points.append(f"  {p.upper()}{k}: {{section: {p}{k}{toe}, normal: t{k}.{end}, reverse: {on}}}")
    head = "interlock: 1\nname: station\nboundaries:\n  W: {approach: ap_W 800}\n  E: {approach: ap_E 800}\n"
    lines = ["tracks:", "  west: [W, ww 200]", "  east: [ee 200, E]", *rows, "points:", *points, "signals:", *signals]
    return head + "\n".join(lines) + "\n"


def checked(tmp_path: Path, text: str) -> Checked:
    path = tmp_path / "layout.yaml"
    path.write_text(text, "utf-8")
    return check_file(str(path))


def lints(tmp_path: Path, text: str) -> list[tuple[str, str]]:
    """Code and element of each warning of practice; a diagnostic with other places is told once."""
    done = checked(tmp_path, text)
    assert done.ok, done.diagnostics
    return [(d.code, str(d.about.name) if d.about else "") for d in done.diagnostics if d.code in LINTS]


@pytest.mark.parametrize("path", sorted(Path("layouts").glob("*.yaml")), ids=lambda p: p.stem)
def test_shipped_layouts_are_silent_or_say_why_they_depart(path: Path) -> None:
    found = [d for d in check_file(str(path)).diagnostics if d.severity is not Severity.INFO]
    assert found == []


@pytest.mark.parametrize("text", [STARTER, yard(4), yard(9), line(3)], ids=["starter", "yard4", "yard9", "line"])
def test_what_init_writes_is_silent(tmp_path: Path, text: str) -> None:
    assert lints(tmp_path, text) == []


@pytest.mark.parametrize("end", ["w", "e"])
@pytest.mark.parametrize("k", range(1, 6))
def test_a_turned_signal_of_a_five_track_station_is_found_and_said_once(tmp_path: Path, k: int, end: str) -> None:
    g, throat = f"{'S' if end == 'w' else 'X'}{k}", f"{end}{min(k, 4)}"
    text = station(5)
    assert lints(tmp_path, text) == []
    right, wrong = f"{g}: {{from: g{k}, into: {throat}}}", f"{g}: {{from: {throat}, into: g{k}}}"
    assert right in text
    text = text.replace(right, wrong)
    assert lints(tmp_path, text) == [("IL7001", g)]
    (done,) = (d for d in checked(tmp_path, text).diagnostics if d.severity is not Severity.INFO)
    assert done.span is not None and text.splitlines()[done.span.line - 1].strip() == wrong
    assert right in done.fix


@pytest.mark.parametrize("k", range(1, 6))
def test_a_missing_starting_signal_is_found_at_its_track(tmp_path: Path, k: int) -> None:
    text = station(5).replace(f"  S{k}: {{from: g{k}, into: w{min(k, 4)}}}\n", "")
    assert lints(tmp_path, text) == [("IL7002", f"g{k}")]


def test_the_same_at_five_tracks_is_one_warning_with_its_places(tmp_path: Path) -> None:
    text = "\n".join(x for x in station(5).splitlines() if not x.startswith("  S"))
    (one,) = [d for d in checked(tmp_path, text).diagnostics if d.code in LINTS]
    assert one.code == "IL7002" and [p.note.split()[0] for p in one.also] == ["g2", "g3", "g4", "g5"]


def test_a_station_without_signals_is_run_through(tmp_path: Path) -> None:
    text = "\n".join(x for x in station(3).splitlines() if not x.startswith(("  S", "  X1", "  X2", "  X3")))
    (one,) = [d for d in checked(tmp_path, text).diagnostics if d.code in LINTS]
    assert one.code == "IL7003" and one.about is not None and one.about.name == "XW"
    assert len(one.also) == 5  # three tracks, two directions


def test_a_long_crossover_between_two_lines_is_no_station(tmp_path: Path) -> None:
    text = Path("tests/stations/railml.yaml").read_text("utf-8")
    assert "k: [Sw12.reverse, ne24 170, Sw13.reverse]" in text
    assert lints(tmp_path, text) == [("IL7004", "ne13a")], "what the drawing has indeed: see the next test"


def test_past_the_last_signal_before_a_buffer_one_must_lead_back(tmp_path: Path) -> None:
    """In the railML example no signal leads back from the ends of two tracks: only further out stands one."""
    text = Path("tests/stations/railml.yaml").read_text("utf-8")
    (found,) = (d for d in checked(tmp_path, text).diagnostics if d.code == "IL7004")
    assert "past S09 no signal leads back out" in found.message and len(found.also) == 1
    back = "signals:\n  B1: {from: ne13a, into: ne13b}\n  B2: {from: ne14d, into: ne14c}"
    assert lints(tmp_path, text.replace("signals:", back)) == []
    mid = Path("layouts/terminus.yaml").read_text("utf-8").replace("[P1 200, B1]", "[P1 120, P1b 120, B1]")
    one = mid.replace("  S11:", "  M1: {from: P1, into: P1b}\n  S11:")
    assert lints(tmp_path, one) == [("IL7004", "P1b")]
    assert lints(tmp_path, one.replace("  S11:", "  M2: {from: P1b, into: P1}\n  S11:")) == []


def test_a_slip_rail_that_its_machine_bars_is_warned_of(tmp_path: Path) -> None:
    """A single slip with the machines of the points beside it: the straight way over it needs one of them in both
    positions, and the routes from the down line to platforms 2 and 3 were lost in a note."""
    text = Path("tests/stations/milton.yaml").read_text("utf-8")
    assert lints(tmp_path, text) == []
    head, _, rest = text.partition("crossings:\n")
    slip = "single: 2a-1b, machines: [8/32, 3/34]"
    rest = (
        "slips:\n  S: {section: x34, arms: [[up.end, ue.start], [3.reverse, 8.reverse]], "
        + slip
        + "}\nsignals:"
        + rest.partition("signals:")[2]
    )
    head = re.sub(r"  3[24]: .*\n", "", head).replace("reverse: X.2b, ", "").replace("reverse: 32.toe, ", "")
    text = re.sub(r"  5-rh[12]: .*\n", "", head + rest)
    (found,) = (d for d in checked(tmp_path, text).diagnostics if d.code == "IL4020")
    assert "from S5 to S7: machine 8/32 is needed in both" in found.message and found.also[0].note == "S5 to S1"
    allowed = text.replace("allow:", "allow:\n  - {lint: IL4020, at: [S5], reason: not run}")
    assert lints(tmp_path, allowed) == []
    own = text.replace("[8/32, 3/34]", "[32, 3/34]")
    assert lints(tmp_path, own) == [] and "IL4005" in {d.code for d in checked(tmp_path, own).diagnostics}


def test_a_platform_that_trains_cannot_leave(tmp_path: Path) -> None:
    text = Path("layouts/terminus.yaml").read_text("utf-8")
    assert lints(tmp_path, text.replace("  S12: {from: P2, into: T3}\n", "")) == [("IL4017", "B2"), ("IL7004", "P2")]
    turned = text.replace("S12: {from: P2, into: T3}", "S12: {from: T3, into: P2}")
    assert lints(tmp_path, turned) == [("IL4017", "B2"), ("IL7001", "S12")]


@pytest.mark.parametrize(
    ("old", "new", "where"),
    [
        ("q3 600", "q3 0.5", "q3"),
        ("q3 600", "q3 90000", "q3"),
        ("ap_W 600", "ap_W 60000", "W"),
        ("reverse: loop.start}", "reverse: loop.start, legs: 0.3}", "P1"),
        ("reverse: loop.start}", "reverse: loop.start, fouling: 500}", "P1"),
    ],
)
def test_lengths_that_are_hardly_meant(tmp_path: Path, old: str, new: str, where: str) -> None:
    text = STARTER.replace("name: starter\n", "name: starter\nprinciples: {restart_delay_s: 9000}\n")
    assert old in text
    assert ("IL7005", where) in lints(tmp_path, text.replace(old, new))


def test_an_approach_is_measured_by_the_speed_and_the_braking_of_the_layout(tmp_path: Path) -> None:
    short = STARTER.replace("ap_W 600", "ap_W 100")
    assert lints(tmp_path, short) == [("IL7006", "W")]
    slow = short.replace("name: starter\n", "name: starter\nprinciples: {line_speed_kmh: 30}\n")
    assert lints(tmp_path, slow) == []
    assert lints(tmp_path, short.replace("name: starter\n", "name: starter\nprofile: mine\n")) == []


def test_an_allowance_has_a_reason_and_an_effect(tmp_path: Path) -> None:
    short = STARTER.replace("ap_W 600", "ap_W 100")
    allow = "allow:\n  - {lint: IL7006, at: [W], reason: trains come slowly out of the works}\n"
    done = checked(tmp_path, short + allow)
    assert done.ok and done.diagnostics == ()
    (left,) = checked(tmp_path, STARTER + allow).diagnostics
    assert (left.code, left.severity) == ("IL2018", Severity.WARNING)
    for text, code in (
        (allow.replace(", reason: trains come slowly out of the works", ""), "IL1010"),
        (allow.replace("trains come slowly out of the works", "''"), "IL2009"),
        (allow.replace("IL7006", "IL3025"), "IL1017"),
        (allow.replace("at: [W]", "at: []"), "IL1012"),
    ):
        assert {d.code for d in checked(tmp_path, short + text).diagnostics} == {code}


def test_sidings_that_no_route_uses_are_told_at_once_and_may_be_meant_so(tmp_path: Path) -> None:
    text = STARTER.replace("loop: [q4 600]", "loop: [q4 600]\n  spur: [P3.reverse, y1 80, y2 80, B]\n  rest: [q7 100]")
    text = text.replace(
        "reverse: loop.end}", "reverse: rest.end}\n  P3: {section: t9, toe: loop.end, normal: rest.start}"
    )
    text = text.replace("X4: {from: q4, into: q5}", "X4: {from: q7, into: q5}")
    text += "buffers: [B]\nexclude:\n  - {to: B, reason: wagons are pushed in by hand}\n"
    (one,) = (d for d in checked(tmp_path, text).diagnostics if d.code == "IL3012")
    assert one.message == "no route uses section y1" and len(one.also) == 1
    reason = "reason: wagons are pushed in by hand"
    allow = f"allow:\n  - {{lint: IL3012, at: [y1, y2], {reason}}}\n"
    assert "IL3012" not in {d.code for d in checked(tmp_path, text + allow).diagnostics}


def test_an_allowance_changes_no_digest(tmp_path: Path) -> None:
    text = Path("layouts/heishan.yaml").read_text("utf-8")
    with_, without = checked(tmp_path, text), checked(tmp_path, text[: text.index("allow:")])
    assert with_.layout is not None and without.layout is not None
    assert with_.layout.digest == without.layout.digest


RING = """interlock: 1
name: ring
profile: mine
boundaries: {W: {approach: wa 300}}
tracks:
  west: [W, m1 200]
  ring: [r1 300, r2 300]
points:
  P: {section: T, toe: west.end, normal: ring.start, reverse: ring.end}
signals:
  X1: {from: W, into: m1}
  X2: {from: m1, into: T}
  S1: {from: r2, into: T}
  S2: {from: r1, into: T}
"""


def test_where_all_trains_run_one_way_a_signal_behind_points_looks_the_right_way(tmp_path: Path) -> None:
    """An outer home behind a junction on a track to which trains come from both lines, and from which none leaves over
    them: turned round it would lead nowhere."""
    text = Path("tests/stations/edgware.yaml").read_text("utf-8")
    assert lints(tmp_path, text) == []
    home, both = "S36: {from: BA, into: BB}", text.replace("131B 300, trains: in", "131B 300")
    assert home in text and lints(tmp_path, both)[:1] == [("IL7001", "S36")]


def test_in_a_balloon_loop_both_ways_are_told_apart(tmp_path: Path) -> None:
    """Both ends of its track are one set of points."""
    assert lints(tmp_path, RING) == []
    turned = RING.replace("S1: {from: r2, into: T}", "S1: {from: T, into: r2}")
    assert lints(tmp_path, turned) == [("IL4017", "P"), ("IL7001", "S1")]


CROSSOVER = """interlock: 1
name: crossover
principles: {point_start_gap_s: 20}
boundaries: {W1: {approach: wa 1200}, E1: {approach: ea 1200}, W2: {approach: wb 1200}, E2: {approach: eb 1200}}
tracks: {a: [W1, a1 300], b: [b1 300, E1], c: [W2, c1 300], d: [d1 300, E2]}
points:
  1A: {section: s1, toe: a.end, normal: b.start, reverse: 1B.reverse}
  1B: {section: s2, toe: d.start, normal: c.end}
signals:
  X1: {from: W1, into: a1}
  X2: {from: a1, into: s1}
  Y1: {from: E1, into: b1}
  Y2: {from: b1, into: s1}
  U1: {from: W2, into: c1}
  U2: {from: c1, into: s2}
  V1: {from: E2, into: d1}
  V2: {from: d1, into: s2}
"""


def test_supervision_lasts_for_the_machines_that_start_before(tmp_path: Path) -> None:
    """It counts from the command, and machines start one after the other: each second one raised an alarm."""

    def said(more: str) -> list[tuple[str, str]]:
        stated = CROSSOVER.replace("principles: {point_start_gap_s: 20}", f"principles: {{{more}}}")
        return [(d.message, str(d.fix)) for d in checked(tmp_path, stated).diagnostics if d.code == "IL3023"]

    ((why, fix),) = said("point_start_gap_s: 20")
    assert why.startswith("point_supervision_s is 13 s, and 26.0 s are needed for 1B: where ")
    assert why.endswith(
        "turns it after another machine, 20 s apart, it starts 20 s after it is commanded, and runs for 6 s"
    )
    assert fix == "state at least 26 s, or a `point_start_gap_s` of at most 7 s, if the supply bears it"
    assert said("point_start_gap_s: 20, point_supervision_s: 26") == said("point_start_gap_s: 7") == []
    assert len(said("point_start_gap_s: 20, point_supervision_s: 25.9")) == len(said("point_start_gap_s: 7.1")) == 1
    own = CROSSOVER.replace("reverse: 1B.reverse}", "reverse: 1B.reverse, supervision: 8}")
    own = own.replace("normal: c.end}", "normal: c.end, supervision: 25}")
    ((one),) = (d for d in checked(tmp_path, own).diagnostics if d.code == "IL3023")
    assert one.message.startswith("the supervision of 1B is 25 s, and 26.0 s are needed for 1B")
    assert one.span is not None and one.span.line == 8, "1A starts first"


def test_the_fix_of_a_restart_delay_is_one_that_helps(tmp_path: Path) -> None:
    """Lower speeds make it worse: what ran at a power cut takes longer to the next signal."""
    text = STARTER.replace("q3 600", "q3 2600").replace("q4 600", "q4 2600")
    (one,) = (d for d in checked(tmp_path, text).diagnostics if d.code == "IL3023")
    assert "at half of 80 km/h" in one.message and "speed" not in str(one.fix)
    slower = text.replace("name: starter\n", "name: starter\nprinciples: {line_speed_kmh: 60}\n")
    (other,) = (d for d in checked(tmp_path, slower).diagnostics if d.code == "IL3023")
    assert "at half of 60 km/h" in other.message
    delays = [float(re.search(r"and ([\d.]+) s are needed", d.message)[1]) for d in (one, other)]  # type: ignore[index]
    assert delays[0] < delays[1]
    stated = text.replace("name: starter\n", f"name: starter\n{re.search(r'`(principles: .*?)`', str(one.fix))[1]}\n")  # type: ignore[index]
    assert "IL3023" not in {d.code for d in checked(tmp_path, stated).diagnostics}


GROUP = """interlock: 1
name: group
boundaries: {W: {approach: wa 1000, trains: in}, E: {trains: out}}
tracks: {west: [W, w1 200], one: [g1 400], two: [g2 400], three: [g3 400], out: [x1 200, E]}
points:
  P1: {section: t1, toe: west.end, normal: one.start, reverse: P2.toe}
  P2: {section: t1, normal: two.start, reverse: three.start}
  Q1: {section: t2, toe: out.start, normal: one.end, reverse: Q2.toe}
  Q2: {section: t2, normal: two.end, reverse: three.end}
signals:
  A: {from: W, into: w1}
  B: {from: w1, into: t1}
  G: {from: t2, into: x1}
"""
"""Three tracks that join before one starting signal."""
OWN = "".join(f"  L{k}: {{from: g{k}, into: t2, kind: shunt, stops_trains: yes}}\n" for k in (1, 2, 3))


def test_one_starting_signal_for_several_tracks_wants_a_shunt_signal_at_each(tmp_path: Path) -> None:
    alone = checked(tmp_path, GROUP)
    fixes = {d.code: d.fix for d in alone.diagnostics}
    assert {"IL7003", "IL7007"} <= set(fixes)
    assert (
        "if G serves several tracks, a shunt signal at the end of each: `kind: shunt, stops_trains: yes`"
        in fixes["IL7003"]
    )
    whole = checked(tmp_path, GROUP + OWN)
    assert whole.ok and whole.table is not None and whole.layout is not None and not lints(tmp_path, GROUP + OWN)
    assert {r.id for r in whole.table.routes} >= {"B-L1", "B-L2", "B-L3", "L1-G.s", "L2-G.s", "L3-G.s", "G-E"}
    system = System(whole.layout, lower(whole.layout, whole.table))
    assert prove(system, limits=Limits(search_s=0)).proved and all(w.ok for w in witnesses(system.loop))
    assert not [p for p in availability(system.loop, whole.table).pairs if p.failure is not None]


PASSED = """interlock: 1
name: passed
principles: {line_speed_kmh: 40}
boundaries: {W: {approach: a 600}}
buffers: [B, B2, B3]
tracks: {lead: [W, l1 200], one: [r1 200, B], mid: [m1 100], two: [r2 200, B2]}
points:
  1: {section: p1, toe: lead.end, normal: mid.start, reverse: two.start}
  2: {section: p2, toe: mid.end, normal: one.start, reverse: B3}
signals:
  X: {from: W, into: l1}
  Y1: {from: m1, into: p1}
  Y2: {from: r2, into: p1}
"""
"""A short piece with a signal that leads back, into which no route leads, but over which two lead to buffers."""


def test_a_place_that_trains_pass_and_where_none_stops_is_told_so(tmp_path: Path) -> None:
    said = [d.message for d in checked(tmp_path, PASSED).diagnostics if d.code == "IL7004"]
    assert "no train comes to stand in m1: no route, or chain of routes, from a boundary ends there" in said


def test_a_delay_that_is_too_short_is_told_where_principles_stand(tmp_path: Path) -> None:
    """Written beside them, and not as a second `principles`, which would be a duplicate key."""
    (one,) = (d for d in checked(tmp_path, PASSED.replace("l1 200", "l1 9000")).diagnostics if d.code == "IL3023")
    assert one.span is not None and one.span.line == 3 and "under `principles`" in str(one.fix)


def test_a_dwarf_signal_against_the_trains_is_told_the_way_out(tmp_path: Path) -> None:
    """Main tracks of a double line, in one direction for trains, in both for shunting."""
    text = PASSED.replace("  Y1: {from: m1, into: p1}", "  Y1: {from: m1, into: p1, kind: shunt}")
    (found,) = (d for d in checked(tmp_path, text + "sections: {m1: {one_way: forward}}\n").diagnostics)
    assert found.code == "IL3019" and "`exclude` train routes" in str(found.fix)


@pytest.mark.parametrize(
    ("stated", "told"),
    [
        ("overlaps: {X3: {length: 300}, X4: {length: 0}}", ["X3 is held for 240 of 300 m, as far as the boundary E"]),
        ("overlaps: {X3: {length: 240}, X4: {successive: yes}}", []),
        (
            "principles: {overlap_m: 241}\noverlaps: {X3: {length: 0}, X2: {length: 0}, Y2: {length: 0}}",
            ["X4", "Y3", "Y4"],
        ),
        ("overlaps: {X3: {length: 300}}\nallow: [{lint: IL7012, at: [X3], reason: the block keeps 60 m clear}]", []),
    ],
)
def test_an_overlap_that_the_layout_does_not_hold_in_full_is_told(tmp_path: Path, stated: str, told: list[str]) -> None:
    text = Path("tests/diagnostics/IL7012.yaml").read_text("utf-8").partition("overlaps:")[0]
    done = checked(tmp_path, f"{text}{stated}\n")
    found = [d.message for d in done.diagnostics if d.code == "IL7012"]
    assert len(found) == len(told) and all(what in said for what, said in zip(told, found, strict=True))
    assert done.table is not None
    overlap = done.table.route["X2-X3"].locking.overlap
    short = "length: 300" in stated
    assert short == (overlap is not None and "240 m to E, where the layout ends, of 300 m" in overlap.because.text)


def test_an_overlap_to_which_no_train_comes_is_not_cut_short(tmp_path: Path) -> None:
    """A starter on a track that ends behind it: a train begins there, and none comes to it."""
    text = """
interlock: 1
name: starters
principles: {overlap_m: 200, line_speed_kmh: 40}
boundaries: {W: {approach: wa 600}}
buffers: [B1]
tracks:
  in: [W, a1 60]
  t1: [b1s 300, B1]
  t2: [b2s 300]
points:
  P1: {section: p, toe: in.end, normal: t1.start, reverse: t2.start}
signals:
  A: {from: W, into: a1}
  X: {from: a1, into: p}
  S1: {from: b1s, into: p}
  S2: {from: b2s, into: p}
"""
    beyond = "tracks:\n  t3: [b3s 300, E]\n"
    for changed, cut in (
        (text.replace("t2: [b2s 300]", "t2: [b2s 300, B2]").replace("[B1]", "[B1, B2]"), set()),
        (
            text.replace("tracks:\n", beyond)
            .replace("{W: {approach: wa 600}}", "{W: {approach: wa 600}, E: {approach: ea 600}}")
            .replace("  S2: {from", "  Y: {from: E, into: b3s}\n  S3: {from: b3s, into: b2s}\n  S2: {from")
            .replace("t2: [b2s 300]", "t2: [b2s 300, t3.start]"),
            {"S2"},
        ),
    ):
        (tmp_path / "x.yaml").write_text(changed, "utf-8")
        found = check_file(str(tmp_path / "x.yaml"))
        assert {d.about.name for d in found.diagnostics if d.code == "IL7012" and d.about} == cut, found.diagnostics


MARKED = {
    "a line with a direction token": ("", "", True),
    "another line": (", block: token", "", False),
    "a board before the boundary": ("  H: {", "  L: {from: e1, into: e2, kind: limit}\n  H: {", False),
    "no berth": ("signals:", "sections: {e2: {berth: no}}\nsignals:", False),
    "allowed": ("signals:", "allow: [{lint: IL7013, at: [E], reason: a mark stands there}]\nsignals:", False),
}


@pytest.mark.parametrize("which", MARKED)
def test_shunting_movements_that_end_before_a_token_line_see_where(tmp_path: Path, which: str) -> None:
    before, after, warned = MARKED[which]
    text = Path("tests/diagnostics/IL7013.yaml").read_text("utf-8").replace(before, after, 1)
    done = checked(tmp_path, text)
    assert done.ok and {d.code for d in done.diagnostics if d.severity != "info"} == ({"IL7013"} if warned else set())


PAST = Path("tests/diagnostics/IL7014.yaml").read_text("utf-8")
FORKED = """interlock: 1
name: forked
principles: {line_speed_kmh: 60, overlap_m: 180}
boundaries: {W: {trains: in, approach: wa 800}, E: {trains: out}, F: {trains: out}}
tracks:
  line: [W, a 300, b 300]
  on: [d 50]
  off: [n 30]
  main: [g 300, E]
  branch: [k 300, F]
  sand1: [u 100, S1]
  sand2: [v 100, S2]
traps: [S1, S2]
points:
  P: {section: c, toe: line.end, normal: on.start, reverse: off.start}
  Q: {section: h, toe: on.end, normal: main.start, reverse: sand1.start}
  R: {section: m, toe: off.end, normal: branch.start, reverse: sand2.start}
signals:
  X1: {from: W, into: a}
  X2: {from: a, into: b}
  X3: {from: b, into: c}
  X4: {from: d, into: h}
  X5: {from: n, into: m}
overlaps:
  X2: {length: 0}
  X3: {length: 180, not_over: [Q.normal, R.normal], ways: [{over: [n], length: 160}]}
"""


@pytest.mark.parametrize(
    ("text", "advice", "old", "new"),
    [
        (PAST, "`overlaps: {X3: {length: 80}}`", "length: 180, not_over: [P.normal]", "length: 80"),
        (
            PAST,
            "`overlaps: {X3: {length: 80, entry_speed: 40, ways: [{over: [d], length: 180}]}}`",
            "length: 180, not_over: [P.normal]",
            "length: 80, entry_speed: 40, ways: [{over: [d], length: 180}]",
        ),
        (
            PAST.replace("c 80", "c 80.1234567"),
            "`overlaps: {X3: {length: 80.123}}`",
            "length: 180, not_over: [P.normal]",
            "length: 80.123",
        ),
        (
            FORKED,
            "`overlaps: {X3: {length: 90}}` and `length: 70` in `ways` over n",
            "length: 180, not_over: [Q.normal, R.normal], ways: [{over: [n], length: 160}]",
            "length: 90, ways: [{over: [n], length: 70}]",
        ),
    ],
    ids=["for all", "for slow trains", "no whole millimetres", "ways"],
)
def test_a_shorter_overlap_that_is_advised_lets_trains_through_and_is_proved(
    text: str, advice: str, old: str, new: str, tmp_path: Path
) -> None:
    """80.1235 was advised for 80.1234567 m, which leads past the next signal again; of `ways` nothing was said."""
    first = checked(tmp_path, text)
    fixes = [d.fix for d in first.diagnostics if d.code == "IL7014"]
    assert len(fixes) == 1 and advice in fixes[0], fixes
    done = checked(tmp_path, text.replace(old, new, 1))
    assert done.ok and done.layout is not None and done.table is not None
    assert "IL7014" not in {d.code for d in done.diagnostics}
    hostile = {r.id: set(r.locking.hostile.routes) for r in done.table.routes}
    assert any(b not in hostile[a] for a in hostile for b in hostile if a.startswith("X2-X3") and b.startswith("X3-"))
    assert prove(System(done.layout, lower(done.layout, done.table)), Limits(search_s=0)).proved


def exchanged(text: str, point: str, leg: str) -> str:
    """A layout with the toe and a leg of a point exchanged, wherever they are written."""
    own = re.search(rf"^  {point}: {{.*$", text, re.MULTILINE)
    assert own is not None
    turn = {"toe": leg, leg: "toe"}
    line_ = re.sub(rf"\b(toe|{leg}):", lambda m: f"{turn[m[1]]}:", own[0])
    text = text.replace(own[0], line_)
    return re.sub(rf"\b{point}\.(toe|{leg})\b", lambda m: f"{point}.{turn[m[1]]}", text)


@pytest.mark.parametrize("leg", ["normal", "reverse"])
@pytest.mark.parametrize("point", [f"{end}{k}" for end in "WE" for k in range(1, 5)])
def test_points_with_toe_and_leg_exchanged_make_a_loop_that_is_told(tmp_path: Path, point: str, leg: str) -> None:
    """At every end of a station of five tracks, with the point that is wrong."""
    text = exchanged(station(5), point, leg)
    assert text != station(5) and exchanged(text, point, leg) == station(5)
    told = [d for d in checked(tmp_path, text).diagnostics if d.code == "IL7017"]
    assert told and all(f"`toe` and `{leg}` of {point}" in d.fix for d in told)
    about = {str(d.about.name) for d in told if d.about is not None}
    allow = f"allow:\n  - {{lint: IL7017, at: [{', '.join(sorted(about))}], reason: trains turn here}}\n"
    assert not [d for d in checked(tmp_path, text + allow).diagnostics if d.code in ("IL7017", "IL2018")]


SLIPPED = """interlock: 1
name: slipped
principles: {line_speed_kmh: 20}
boundaries: {W: {approach: ap 200}, V: {approach: av 200}, E: {approach: ae 200}}
buffers: [B]
tracks:
  t1: [W, s2 90]
  t7: [s8 90, V]
  t9: [s6 40]
  t10: [s4 20]
  t13: [s14 90, E]
  t15: [s16 40, B]
points:
  P3: {section: T4, normal: t1.end, toe: t10.start}
  P5: {section: T6, toe: P3.reverse, reverse: t7.start, normal: t9.start}
slips:
  Z11: {section: s12, arms: [[t9.end, t13.start], [t10.end, t15.start]]}
signals:
  X: {from: W, into: s2}
  X21: {from: E, into: s14}
"""


@pytest.mark.parametrize("kind", ["", ", single: 1a-2b"])
def test_a_loop_that_begins_at_a_slip_is_told_of_the_slip(tmp_path: Path, kind: str) -> None:
    """Its points stand nowhere in the text; a point that does is the one to look at."""
    text = SLIPPED.replace("t15.start]]", f"t15.start]]{kind}")
    told = [d for d in checked(tmp_path, text).diagnostics if d.code == "IL7017"]
    line = 1 + text[: text.index("  Z11:")].count("\n")
    at_slip = [d for d in told if d.about == Element("slips", "Z11")]
    assert [d.span.line for d in at_slip if d.span is not None] == [line] == [line] * len(at_slip)
    assert "comes back to slip Z11" in at_slip[0].message and "Z11a" not in str(told) and "Z11/" not in str(told)
    assert at_slip[0].fix == "if no loop is meant, see whether `toe` and `reverse` of P5 are exchanged"
    assert all(d.about == at_slip[0].about or d.about.room == "points" for d in told if d.about is not None)
    names = ", ".join(sorted({str(d.about.name) for d in told if d.about is not None}))
    allow = f"allow:\n  - {{lint: IL7017, at: [{names}], reason: trains turn here}}\n"
    assert not [d for d in checked(tmp_path, text + allow).diagnostics if d.code in ("IL7017", "IL2018")]


SINGLE = """interlock: 1
name: single
principles: {line_speed_kmh: 20}
boundaries: {W: {approach: ap 200}, E: {approach: ae 200}}
tracks:
  t1: [W, s1 90]
  a: [a1 60]
  b: [b1 60]
  c: [c1 60]
  d: [d1 60]
  t2: [s2 90, E]
points:
  P1: {section: T1, toe: t1.end, normal: a.start, reverse: b.start}
  P2: {section: T2, toe: t2.start, normal: c.end, reverse: d.end}
slips:
  Z: {section: s12, arms: [[a.end, c.start], [b.end, d.start]], single: 1a-2b}
signals:
  X: {from: W, into: s1}
  Y: {from: E, into: s2}
"""


def test_ends_of_a_slip_that_are_exchanged_are_looked_for_in_its_arms(tmp_path: Path) -> None:
    assert not [d for d in checked(tmp_path, SINGLE).diagnostics if d.code == "IL7017"]
    text = SINGLE.replace("[[a.end, c.start], [b.end, d.start]]", "[[a.end, b.end], [c.start, d.start]]")
    told = [d for d in checked(tmp_path, text).diagnostics if d.code == "IL7017"]
    assert told and {d.fix for d in told} == {
        "if no loop is meant, see whether ends in the `arms` of slip Z are exchanged"
    }
    assert Element("points", "P1") in {d.about for d in told}


@pytest.mark.parametrize("kind", ["", ", machines: [Z]", ", machines: [ZL, ZR]", ", blades: near"])
@pytest.mark.parametrize("arms", ["[[a.end, b.end], [c.start, d.start]]", "[[d.start, c.start], [b.end, a.end]]"])
def test_ends_of_a_double_slip_that_are_exchanged_are_told_though_its_slip_rails_lead_on(
    tmp_path: Path, arms: str, kind: str
) -> None:
    """Straight over it one comes back to the point from which one came; over the slip rails one still goes on."""
    double = SINGLE.replace(", single: 1a-2b", kind)
    assert not [d for d in checked(tmp_path, double).diagnostics if d.code == "IL7017"]
    text = double.replace("[[a.end, c.start], [b.end, d.start]]", arms)
    told = [d for d in checked(tmp_path, text).diagnostics if d.code == "IL7017"]
    assert [d.about for d in told] == [Element("slips", "Z")], "once, whatever other ways are alike"
    loop = "straight over slip Z comes back to point P1 over its other leg: a balloon loop"
    assert told[0].message == f"whoever runs over P1.normal and {loop}, while only slip rails lead to E"
    assert told[0].fix == "if no loop is meant, see whether ends in the `arms` of slip Z are exchanged"
    allow = "allow:\n  - {lint: IL7017, at: [Z], reason: trains turn here}\n"
    assert not [d for d in checked(tmp_path, text + allow).diagnostics if d.code in ("IL7017", "IL2018")]


@pytest.mark.parametrize("name", ["turning_loop", "loading_loop"])
def test_a_balloon_that_leads_nowhere_else_is_meant(name: str) -> None:
    assert not any(d.code == "IL7017" for d in check_file(f"tests/layouts_for_tests/{name}.yaml").diagnostics)


PIT = """interlock: 1
name: pit
profile: mine
boundaries:
  W: {approach: ap 150}
buffers: [HOIST]
tracks:
  lead: [W, q1 120]
  loopa: [la 240]
  loopb: [lb 150]
  cage: [cg 40, HOIST]
points:
  P1: {section: q2, toe: lead.end, normal: loopa.start, reverse: loopb.end, legs: 15}
  P2: {section: q3, toe: loopa.end, normal: loopb.start, reverse: cage.start, legs: 15}
signals:
  S0: {from: W, into: q1}
  S1: {from: q1, into: q2}
  SA: {from: la, into: q3}
  SB: {from: lb, into: q2}
  SC: {from: cg, into: q3}
"""


def test_a_pit_bottom_with_sidings_on_its_loop_is_meant(tmp_path: Path) -> None:
    """Only a boundary beside the loop makes it likely that a point is drawn wrong."""
    assert "IL7017" not in {code for code, _ in lints(tmp_path, PIT)}
    out = PIT.replace("buffers: [HOIST]\n", "").replace("{approach: ap 150}", "{approach: ap 150}\n  E: {trains: out}")
    assert ("IL7017", "P1") in lints(tmp_path, out.replace("HOIST", "E"))


LINE = """interlock: 1
name: line
profile: {profile}
boundaries:
  W: {{approach: ap_W 800}}
  E: {{approach: ap_E 800, trains: out}}
tracks:
  line: [W, q1 400, q2 400, q3 400, E]
signals:
  X1: {{from: W,  into: q1}}
  X2: {{from: q1, into: q2}}
  X3: {{from: q2, into: q3}}
{more}
"""
SLOW, CLASSES = "principles: {slow_below_kmh: 40}", "principles: {priorities: yes}"
VOYAGE = "voyages: {V: {from: X1, to: X3}}"


@pytest.mark.parametrize(
    ("profile", "more", "told"),
    [
        ("generic", SLOW, ["slow_below_kmh"]),
        ("generic", f"{SLOW}\nsections: {{q2: {{speed: 25}}}}", []),
        ("generic", f"{SLOW}\nsections: {{q2: {{speed: 60}}}}", []),
        ("generic", f"{SLOW}\noverlaps: {{X2: {{entry_speed: 25}}}}", []),
        ("mine", f"{SLOW}\nsections: {{q2: {{speed: 15}}}}", ["slow_below_kmh"]),
        ("mine", SLOW.replace("}", ", caution: next}") + "\nsections: {q2: {speed: 15}}", []),
        ("generic", CLASSES, ["priorities"]),
        ("mine", "", []),
        ("mine", CLASSES, []),
        ("generic", f"{CLASSES}\n{VOYAGE}", []),
        ("generic", f"{CLASSES}\nsections: {{q2: {{lane: inclined}}}}", []),
        ("generic", "principles: {priority_wait_s: 60}", []),
    ],
)
def test_a_principle_that_has_no_effect_is_told(tmp_path: Path, profile: str, more: str, told: list[str]) -> None:
    """IL7021: the author takes signals for showing caution, and none does; voyages for going by class."""
    text = LINE.format(profile=profile, more=more)
    assert [name for code, name in lints(tmp_path, text) if code == "IL7021"] == told
    allow = f"allow: [{{lint: IL7021, at: [{', '.join(told)}], reason: r}}]\n"
    assert not told or "IL7021" not in {code for code, _ in lints(tmp_path, text + allow)}


@pytest.mark.parametrize(
    ("zone", "told"),
    [
        ("sections: [q2, q3], trains: 1", ""),
        ("sections: [q2, q3], trains: 2", ""),
        ("sections: [q2, q3], trains: 3", "has 2 sections"),
        ("sections: [q3], trains: 9", "has 1 section,"),
    ],
)
def test_a_zone_that_is_never_full_is_told(tmp_path: Path, zone: str, told: str) -> None:
    """IL7022: with a train in each section there was still room."""
    text = LINE.format(profile="generic", more=f"zones: {{Z: {{{zone}}}}}")
    found = [d for d in checked(tmp_path, text).diagnostics if d.code == "IL7022"]
    assert [told in d.message for d in found] == [True] * bool(told)
    assert not found or found[0].about == Element("zones", "Z")


def test_a_zone_into_which_no_route_leads_is_told(tmp_path: Path) -> None:
    zone = "zones: {Z: {sections: [q3], trains: 1}}\nexclude: [{from: X3, reason: closed}]"
    text = LINE.format(profile="generic", more=zone)
    (found,) = [d for d in checked(tmp_path, text).diagnostics if d.code == "IL7022"]
    assert "no route leads into it from outside" in found.message


def test_an_engine_that_would_be_shut_in_behind_its_coaches_is_told_of(tmp_path: Path) -> None:
    """The route leads to the buffer over platform and release points; with a signal before these it does not."""
    (found,) = [d for d in checked(tmp_path, RELEASE_POINTS).diagnostics if d.code == "IL7002"]
    assert found.message.endswith(
        "(X1-BB); an engine that leaves its coaches in g1 cannot come back: P2 stays locked as long"
    )
    signal = found.fix.removeprefix("add a signal ")
    assert signal == "`from: g1` into the section before P2"
    text = f"{RELEASE_POINTS}  S: {{from: g1, into: T2, kind: combined}}\n"
    assert not [d for d in checked(tmp_path, text).diagnostics if d.code == "IL7002"]
    through = RELEASE_POINTS.replace("buffers: [BB]\n", "").replace("wa 800}", "wa 800}, BB: {trains: out}")
    (found,) = [d for d in checked(tmp_path, through).diagnostics if d.code == "IL7002"]
    assert "coaches" not in found.message
