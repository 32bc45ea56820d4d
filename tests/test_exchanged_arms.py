"""IL7023: ends of a diamond's arms that are exchanged, as where a scissors is drawn wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.diag import Diagnostic, Element
from tests.layouts import SHIPPED, grown

SCISSORS = """interlock: 1
name: exchanged
principles: {line_speed_kmh: 40}
boundaries: {W1: {approach: wa 800}, W2: {approach: wb 800}, E: {approach: ea 800}}
tracks: {a: [W1, a1 200], b: [W2, b1 200], e: [e1 200, E]}
points:
  11A: {machine: 11, section: TA, toe: a.end, normal: 12B.normal}
  12A: {machine: 12, section: TB, toe: b.end, normal: 11B.normal}
  12B: {machine: 12, section: TA, toe: J.normal}
  11B: {machine: 11, section: TB, toe: J.reverse}
  J: {section: TJ, toe: e.start}
crossings:
  X: {arms: [{section: TA, ends: [11A.reverse, 11B.reverse]}, {section: TB, ends: [12A.reverse, 12B.reverse]}]}
signals:
  S1: {from: W1, into: a1}
  S2: {from: W2, into: b1}
  A1: {from: a1, into: TA}
  B1: {from: b1, into: TB}
  N0: {from: E, into: e1}
  E1: {from: e1, into: TJ}
"""
APART = SCISSORS.replace("machine: 11, section: TB", "machine: 13, section: TB").replace(
    "machine: 12, section: TA", "machine: 14, section: TA"
)
TURNED = "[11A.reverse, 12A.reverse]", "[11B.reverse, 12B.reverse]"
LENGTHWISE = "[11A.reverse, 12B.reverse]", "[12A.reverse, 11B.reverse]"


def wired(text: str, arms: tuple[str, str]) -> str:
    """With other arms."""
    return text.replace("[11A.reverse, 11B.reverse]", arms[0]).replace("[12A.reverse, 12B.reverse]", arms[1])


def told(tmp_path: Path, text: str) -> list[Diagnostic]:
    """What is said of arms, or of an `allow` for it."""
    path = tmp_path / "layout.yaml"
    path.write_text(text, "utf-8")
    return [d for d in check_file(str(path)).diagnostics if d.code in ("IL7023", "IL2018")]


@pytest.mark.parametrize("text", [SCISSORS, APART])
def test_arms_that_join_what_they_should_are_passed_over(tmp_path: Path, text: str) -> None:
    assert told(tmp_path, text) == []


@pytest.mark.parametrize(("arms", "second"), [(TURNED, "12A"), (LENGTHWISE, "12B")])
def test_a_machine_that_leads_onto_both_arms_of_a_diamond_is_told(
    tmp_path: Path, arms: tuple[str, str], second: str
) -> None:
    text = wired(SCISSORS, arms)
    (found,) = told(tmp_path, text)
    assert found.message == (
        "the machine 11 leads onto both arms of diamond X at once, over 11A.reverse and over 11B.reverse, and ways "
        "over these cross each other"
    )
    assert found.fix.endswith(f"see whether `{second}.reverse` and `11B.reverse` are exchanged in the `arms` of X")
    assert found.about == Element("crossings", "X")
    right = wired(SCISSORS, (arms[0].replace(second, "11B"), arms[1].replace("11B", second)))
    assert right != text and told(tmp_path, right) == [], "who follows the fix is rid of it"
    assert told(tmp_path, f"{text}allow:\n  - {{lint: IL7023, at: [X], reason: trains turn here}}\n") == []


def test_points_of_machines_of_their_own_lead_back_over_an_arm_to_the_point_from_which_one_came(tmp_path: Path) -> None:
    """So who followed the fix of IL4002 had a layout without a warning, whose trains turn on the diamond."""
    (found,) = told(tmp_path, wired(APART, TURNED))
    assert found.message == (
        "whoever runs over J.reverse, then over 11B.reverse, diamond X and 12B.reverse, comes back to point J over its "
        "other leg"
    )
    assert found.fix == "if no loop is meant, see whether ends are exchanged in the `arms` of X"


CROSSING = """interlock: 1
name: shut_off
principles: {line_speed_kmh: 40}
boundaries: {A: {approach: wa 800}, B: {trains: out}, C: {approach: wc 800}, D: {trains: out}}
traps: [V, W]
tracks: {a: [A, a1 200], b: [b1 200, B], c: [C, c1 200], d: [d1 200, D], v: [v1 30, V], w: [w1 30, W]}
points:
  1A: {machine: 1, section: TA, toe: a.end, normal: X.1a, reverse: v.start}
  1B: {machine: 1, section: TC, toe: c.end, ONE: X.2a, OTHER: w.start}
crossings: {X: {arms: [{section: TA, ends: [1A.normal, b.start]}, {section: TC, ends: [1B.ONE, d.start]}]}}
signals: {SA: {from: A, into: a1}, SC: {from: C, into: c1}, TA: {from: a1, into: TA}, TC: {from: c1, into: TC}}
"""


def test_one_machine_may_open_either_arm_and_shut_off_the_other(tmp_path: Path) -> None:
    apart = CROSSING.replace("ONE", "reverse").replace("OTHER", "normal")
    assert told(tmp_path, apart) == []
    (found,) = told(tmp_path, CROSSING.replace("ONE", "normal").replace("OTHER", "reverse"))
    assert "see whether `X.1b` and `1B.normal` are exchanged" in found.fix


@pytest.mark.parametrize(
    "path", [*(f"layouts/{n}.yaml" for n in SHIPPED), "tests/stations/swtbahnfull.yaml", "tests/stations/swtbahn.yaml"]
)
def test_diamonds_as_they_are_built_are_passed_over(path: str) -> None:
    """Also those in double slips of one machine, and a scissors between two tracks of one loop."""
    assert not [d for d in check_file(path).diagnostics if d.code == "IL7023"]


def test_the_flank_that_finds_no_protection_there_says_first_that_ends_are_exchanged() -> None:
    """A machine of its own for 11B was all the advice of IL4002."""
    made = grown(wired(SCISSORS, TURNED))
    assert made is not None
    found = [d for d in made[2].diagnostics if d.code == "IL4002"]
    assert len(found) == 2
    for d in found:
        assert str(d.fix).startswith("see whether ends are exchanged in the `arms` of X ("), d.fix
        assert "from 11A.reverse to 11B.reverse), or give 1" in str(d.fix)
    mended = grown(SCISSORS)
    assert mended is not None and not mended[2].has_errors, mended and mended[2].diagnostics
