"""Delays count in whole milliseconds, and none is shorter than the layout orders: in the controller, in every text, in
the claims and for the second checker."""

from __future__ import annotations

import re
from fractions import Fraction
from math import ceil
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from interlock.app.compile import build
from interlock.app.run import Operator
from interlock.checker import lengths
from interlock.checker.check import check
from interlock.checker.lengths import Lengths
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.model.needs import needs
from interlock.model.times import whole_ms
from tests.certified import certified
from tests.layouts import grown
from tests.panels import unproved

FINE = "principles: {release_delay_s: 0.0001, restart_delay_s: 600.0004}\n"
"""No whole milliseconds."""


@pytest.fixture(scope="module")
def layout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("fine") / "fig2_2.yaml"
    text = Path("layouts/fig2_2.yaml").read_text("utf-8")
    assert "principles:" not in text
    path.write_text(text + FINE, "utf-8")
    return path


@given(st.decimals(0, 86_400, places=6))
def test_both_readers_round_up_what_is_stated(seconds: object) -> None:
    wanted = ceil(1000 * Fraction(str(seconds)))
    assert whole_ms(float(str(seconds))) == lengths.whole_ms(float(str(seconds))) == wanted


def test_presets_are_no_shorter_than_ordered(layout: Path) -> None:
    made = grown(layout.read_text("utf-8"))
    assert made is not None
    presets = {str(t.name): t.preset_ms for t in lower(*made[:2]).timers}
    assert {ms for name, ms in presets.items() if name.startswith("RT_")} == {1}
    assert presets["RST"] == 600_001


def test_every_text_has_them(layout: Path) -> None:
    proved, files = build(str(layout), dialects=("c99",))
    assert proved.green
    for name, pattern in (
        ("st/iec/fig2_2.st", r"TON_RT_\w+\(IN := [\w.]+, PT := (\S+)\)"),
        ("runtime.py", r"'RT_\w+': (\d+),"),
        ("c99/fig2_2.c", r"delay\.RT_\w+, \S+, (\d+)u"),
    ):
        assert set(re.findall(pattern, files[name].decode())) == ({"T#1ms"} if name.endswith(".st") else {"1"}), name


def test_the_second_checker_agrees(layout: Path, tmp_path: Path) -> None:
    assert check(layout, certified(layout, tmp_path)).left == ()


NEEDED = """interlock: 1
name: needed
principles: {line_speed_kmh: 80, restart_delay_s: 900}
boundaries: {W: {approach: wa 900, trains: in}, E: {trains: out}}
tracks: {line: [W, q1 %s, q2 500, E]}
signals: {X1: {from: W, into: q1}, X2: {from: q1, into: q2}}
overlaps: {X2: {length: 100, release_by_length: yes}}
"""
"""A train that runs at 80 km/h stands 5 s + 80 / 3.6 / 0.6 s after stop is shown: 42.037037... s."""


def both(metres: str) -> tuple[Layout, Lengths]:
    """The layout with a first section of so many metres, as either reader has it."""
    made = grown(NEEDED % metres)
    assert made is not None
    return made[0], Lengths(Railway(loaded(NEEDED % metres)))


def test_what_the_world_needs_is_rounded_up_by_both_readers() -> None:
    """42.037037... s were 42037 ms, and a release of that time was held to be enough."""
    layout, other = both("600")
    least = needs(layout)
    assert least.stop["X1"] == other.halt(80.0) == 42_038  # type: ignore[index]
    assert least.shunt == other.halt(40.0) == 23_519
    # on over 600 m and 500 m at half the speed: 99 s more
    assert least.restart == other.until_all_stand() == 42_038 + 99_000
    layout, other = both("600.001")
    assert needs(layout).restart == other.until_all_stand() == 42_038 + 99_001


def test_a_release_that_is_short_by_less_than_half_a_millisecond_is_refused() -> None:
    for release, enough in (("42.037", False), ("42.038", True)):
        sink = Sink()
        load_text("x", NEEDED.replace("into: q2}", f"into: q2, release: {release}}}") % "600", sink)
        told = [d.message for d in sink.diagnostics if d.code == "IL3023"]
        assert bool(told) != enough and all("42.1 s are needed" in x for x in told), told


@pytest.mark.parametrize("metres", ["599.58847736625", "599.5885", "599.58", "0.1", "1234.567"])
def test_the_release_by_length_is_rounded_up_by_both_readers(metres: str) -> None:
    """599.5885 m at half of 80 km/h, and 42.038 s, are 96 s and 0.0009 ms: they were 96 s."""
    layout, other = both(metres)
    wanted = ceil(Fraction(metres) * 72 / 800 + Fraction(42038, 1000))
    signal = next(g for g in other.r.signals.values() if g.name == "X2")
    assert dict(layout.overlaps.releases)["X2"] == wanted  # type: ignore[index]
    assert other.overlap_release(signal) == 1000 * wanted


@pytest.mark.parametrize(
    ("within", "ms"), [("0.9996", 999), ("0.57", 570), ("0.2", 200), ("0.20009", 200), ("1", 1000)]
)
def test_a_heartbeat_is_waited_for_no_longer_than_ordered(within: str, ms: int) -> None:
    made = grown(f"{NEEDED % '600'}substations: {{main: []}}\nhealth: {{main: {{within: {within}}}}}\n")
    assert made is not None and [h.within_ms for h in made[0].hardware.health] == [ms]


def test_a_voyage_that_may_wait_for_a_moment_does_not_wait_for_ever() -> None:
    """0 stands for ever, and 0.0004 s were 0 ms."""
    text = NEEDED.replace("restart_delay_s: 900", "restart_delay_s: 900, priority_wait_s: 0.0004") % "600"
    assert Operator(unproved(text)).dispatcher.arbiter.wait_ms == 1
