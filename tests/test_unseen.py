"""A-SCAN against lengths and speeds: what is run through between two scans is told, by two readers."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.checker.check import agree
from interlock.checker.lengths import Lengths
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.checker.specification import shipped as specification
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.model.needs import passages
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


def test_verify_says_where_the_assumption_cannot_hold() -> None:
    said = [agree(*told(x), specification()).compared[3] for x in (LINE, LINE.replace("q2 12", "q2 10"))]
    assert "but A-SCAN" not in said[0]
    assert said[1].endswith("but A-SCAN holds of no train at full speed through q2 in 0.45 s")
