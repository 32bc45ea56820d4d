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
from interlock.checker import lengths
from interlock.checker.check import check
from interlock.logic.lower import lower
from interlock.model.times import whole_ms
from tests.certified import certified
from tests.layouts import grown

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
