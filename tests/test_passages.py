"""Trains from boundary to boundary: every plan holds on the controller, and no train that is commanded stands for ever.

The layouts are those on which plans once failed, or trains stood: lines with a direction token, overlaps that a train
keeps, routes that are declared hostile.  All others: `python -m tests.campaigns.passages`.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.dispatch import dispatch
from tests.campaigns.passages import tried
from tests.test_dispatch_command import CLOSE


@pytest.mark.parametrize(
    "path",
    [
        "layouts/passing_loop.yaml",
        "layouts/flank_lab.yaml",
        "layouts/junction.yaml",
        "layouts/slip_junction.yaml",
        *(f"tests/layouts_for_tests/{x}.yaml" for x in ("spaces", "added", "token", "overlap_unused", "overlaps")),
    ],
)
def test_every_plan_holds_on_the_controller_and_no_train_stands_for_ever(path: str) -> None:
    found = tried(path, most=10, runs=3)
    assert found.plans[1] > 0 and found.unknown == 0 and found.runs > 0
    assert found.wrong == [] and found.stuck == [] and found.troubles == set()


def test_who_is_followed_closely_keeps_its_overlap_and_is_caught(tmp_path: Path) -> None:
    """Train 1 needs the overlap of its next route, over which its own overlap lies otherwise; train 2 stands right
    behind it."""
    layout = tmp_path / "close.yaml"
    layout.write_text(CLOSE, "utf-8")
    found = dispatch(str(layout), ["1:W>E", "2:W>A"])
    assert found.answer is not None and str(found.answer.verdict) == "NONE" and found.caught == ("1", "2")
    found = dispatch(str(layout), ["1:W>E"])
    assert found.replayed is not None and found.replayed.wrong is None


@pytest.mark.parametrize("orders", [["1:UM2>G", "2:UM2>UM"], ["1:UM2>UM", "2:UM2>G"]])
def test_who_runs_on_along_its_overlap_is_followed_closely(orders: list[str]) -> None:
    """The overlap of S2J to G leads past G3, whose own lies along it."""
    found = dispatch("layouts/slip_junction.yaml", orders)
    assert found.replayed is not None and found.replayed.wrong is None
