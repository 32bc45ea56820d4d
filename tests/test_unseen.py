"""Assumptions against lengths and speeds, by two readers: what is run through between two scans (A-SCAN), where an
overlap is given up under a train that runs (A-STAND), and where one stands foul beyond a boundary (A-BEYOND)."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from interlock.checker.check import agree
from interlock.checker.doubted import foul_boundaries, released_early
from interlock.checker.lengths import Lengths
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.checker.specification import shipped as specification
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.model.foul import foul_boundaries as ours_foul
from interlock.model.needs import passages, standing_s
from tests.layouts import SHIPPED
from tests.written import told

OTHERS = ("devices", "flank_point", "overlaps_join", "spaces", "speeds", "turning_loop", "undetected", "trap_beyond")
PLACES = (*(f"layouts/{x}.yaml" for x in SHIPPED), *(f"tests/layouts_for_tests/{x}.yaml" for x in OTHERS))


def warned(text: str) -> list[str]:
    sink = Sink()
    load_text("a.yaml", text, sink)
    return [d.message for d in sink.diagnostics if d.code == "IL3037"]


@pytest.mark.parametrize("place", PLACES)
def test_both_readers_find_the_same_passages(place: str) -> None:
    """With a delay that no section can keep, so that each has its passage compared."""
    text = Path(place).read_text("utf-8")
    layout, _ = load_text(place, text, Sink())
    railway = Railway(loaded(text))
    railway.drawn.rules["detection_delay_s"] = 86400
    theirs = Lengths(railway).unseen()
    assert layout is not None
    ours = {str(x.section): x.seconds for x in passages(layout)}
    assert theirs.keys() == ours.keys() and ours
    assert all(abs(theirs[s] - ours[s]) < 1e-9 for s in ours)


@pytest.mark.parametrize("name", SHIPPED)
def test_no_shipped_layout_has_one(name: str) -> None:
    assert warned(Path(f"layouts/{name}.yaml").read_text("utf-8")) == []


LINE = """interlock: 1
name: line
boundaries:
  W: {approach: wa 300}
  E: {trains: out}
tracks:
  main: [W, q1 100, q2 12, q3 100, E]
signals:
  X1: {from: W,  into: q1}
  X2: {from: q1, into: q2}
"""


def test_speed_length_and_delay_decide() -> None:
    assert warned(LINE) == []  # 80 km/h: 0.54 s
    assert "12 m at 90 km/h are run through in 0.48 s" in warned(LINE + "principles: {line_speed_kmh: 90}\n")[0]
    assert warned(LINE + "principles: {line_speed_kmh: 90}\nsections: {q2: {speed: 80}}\n") == []
    assert warned(LINE + "principles: {line_speed_kmh: 90, detection_delay_s: 0.4}\n") == []
    assert len(warned(LINE + "principles: {detection_delay_s: 20}\n")) == 2  # sections in a group, and the approach


@pytest.mark.parametrize(("metres", "seen"), [(11.1, False), (11.12, True)])
def test_a_section_is_seen_where_the_delay_is_over_before_its_end(metres: float, seen: bool) -> None:
    """At 80 km/h 11.1 m take 0.4995 s, and a scan may not have read it for 0.5 s."""
    assert (warned(LINE.replace("q2 12", f"q2 {metres}")) == []) is seen


def test_a_length_that_is_hardly_meant_hides_no_other_section() -> None:
    (found,) = warned(LINE.replace("q2 12, q3 100", "q2 10, q3 100, q4 2"))
    assert found.startswith("section q2 may be run through unseen")


@pytest.mark.parametrize("metres", [12.05, 12.2, 13.7])
def test_at_the_speed_that_is_advised_a_section_is_seen(metres: float) -> None:
    sink, text = Sink(), LINE.replace("q2 12", f"q2 {metres}") + "principles: {line_speed_kmh: 120}\n"
    load_text("a.yaml", text, sink)
    (fix,) = [d.fix or "" for d in sink.diagnostics if d.code == "IL3037"]
    stated = re.search(r"`(sections: .*?\}\})`", fix)
    assert stated is not None and warned(f"{text}{stated[1]}\n") == []


def test_verify_says_where_the_assumption_cannot_hold() -> None:
    said = [agree(*told(x), specification()).compared[3] for x in (LINE, LINE.replace("q2 12", "q2 10"))]
    assert "but A-SCAN" not in said[0]
    assert said[1].endswith("but A-SCAN holds of no train at full speed through q2 in 0.45 s")


EARLY = Path("tests/diagnostics/IL3035.yaml").read_text("utf-8")
FOUL = Path("tests/diagnostics/IL3041.yaml").read_text("utf-8")


@pytest.mark.parametrize("place", PLACES)
def test_both_readers_find_the_same_overlaps_and_boundaries(place: str) -> None:
    """With a braking so weak that no release suffices, each section before an overlap has its time compared; with a
    clearance that no boundary has, each has its points."""
    text = Path(place).read_text("utf-8")
    layout, _ = load_text(place, text, Sink())
    railway = Railway(loaded(text))
    assert layout is not None
    braking = layout.principles.braking_ms2
    railway.drawn.rules["overlap_release_s"] = 0.001
    stated = {g for g, _ in layout.overlaps.releases}
    theirs = {g: s for g, (_, s) in released_early(Lengths(railway)).items() if g not in stated}
    ours = {str(o.signal): standing_s(layout, o.signal) for o in layout.overlaps.all if o.signal not in stated}
    assert theirs.keys() == ours.keys() and braking > 0
    assert all(abs(theirs[g] - ours[g]) < 1e-9 for g in ours)
    for clearance in (layout.principles.clearance_m, 500.0):
        railway.drawn.rules["clearance_m"] = clearance
        far = replace(layout, principles=replace(layout.principles, clearance_m=clearance))
        assert foul_boundaries(railway.drawn) == sorted({(str(b.node), str(b.element)) for b in ours_foul(far)})


def test_verify_says_where_a_train_runs_on_or_stands_foul() -> None:
    held = (
        EARLY,
        EARLY.replace("overlap_release_s: 60", "overlap_release_s: 86"),
        FOUL,
        FOUL.replace("legs: 9", "legs: 16"),
    )
    said = [agree(*told(x), specification()).compared[3] for x in held]
    assert said[0].endswith("but A-STAND holds of no train at full speed to X, whose overlap is released after 60 s")
    assert said[2].endswith("but A-BEYOND says nothing of a train that stands at W8, foul of P3")
    assert "but" not in said[1] and "but" not in said[3]
