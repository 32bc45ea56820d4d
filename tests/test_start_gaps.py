"""Supervision of machines that start one after the other lasts exactly as long as the last one needs (IL3023, R10)."""

from __future__ import annotations

import pytest

from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text

LADDER = """interlock: 1
name: ladder
profile: {profile}
principles: {{line_speed_kmh: 40, point_start_gap_s: {gap}, point_run_s: {run}, point_supervision_s: {own}{more}}}
boundaries:
  W: {{approach: wa 600, trains: in}}
  E: {{trains: out}}
  F: {{trains: out}}
  G: {{trains: out}}
  H: {{trains: out}}
tracks:
  west: [W, a 200]
  one: [qb 200, E]
  two: [qc 200, F]
  three: [qd 200, G]
  four: [qe 200, H]
points:
  1: {{section: p, toe: west.end, normal: one.start, reverse: 2.toe, legs: 40}}
  2: {{section: p, normal: two.start, reverse: 3.toe, legs: 40{two}}}
  3: {{section: p, normal: three.start, reverse: four.start, legs: 40}}
signals:
  X: {{from: W, into: a}}
  S: {{from: a, into: p}}
"""


def said(
    own: float, gap: float = 2, run: float = 5, profile: str = "generic", more: str = "", two: str = ""
) -> list[str]:
    sink = Sink()
    text = LADDER.format(own=own, gap=gap, run=run, profile=profile, more=more, two=two)
    layout, _ = load_text("ladder.yaml", text, sink)
    assert layout is not None, sink.diagnostics
    derive(layout, sink)
    return [d.message for d in sink.diagnostics if d.code == "IL3023" and "turns it after" in d.message]


@pytest.mark.parametrize(("own", "enough"), [(9, True), (8.9, False), (6, False), (5.5, False)])
def test_the_third_machine_starts_two_gaps_later_and_then_runs(own: float, enough: bool) -> None:
    """S-G turns 1, 2 and 3: 2 + 2 + 5 s."""
    found = said(own)
    assert bool(found) is not enough
    assert all("9.0 s are needed" in x and "2 others" in x for x in found), found


def test_a_machine_that_is_driven_along_counts_among_those_that_start_before() -> None:
    """S-E needs 1 alone; where points are driven along, 2 and 3 beside its path start after it (R10)."""
    text = LADDER.split("signals:")[0] + "signals:\n  X: {{from: W, into: a}}\n  S: {{from: a, into: p}}\n"
    text += "exclude:\n" + "".join(f"  - {{{{from: S, to: {x}, reason: for this test}}}}\n" for x in "FGH")
    for drives, enough in (("no", True), ("yes", False)):
        sink = Sink()
        made = text.format(own=8.9, gap=2, run=5, profile="generic", more=f", drive_points: {drives}", two="")
        layout, _ = load_text("ladder.yaml", made, sink)
        assert layout is not None, sink.diagnostics
        table = derive(layout, sink)
        assert bool(table.route["S-E"].locking.driven) is (drives == "yes")  # type: ignore[index]
        assert any(d.code == "IL3023" and "turns it after" in d.message for d in sink.diagnostics) is not enough


def test_a_key_starts_no_machine() -> None:
    """S-F turns 1 and has 2 locked by its key."""
    assert said(6, two=", work: hand") == [] and said(6) != []
