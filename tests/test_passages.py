"""Trains from boundary to boundary: every plan holds on the controller, and no train that is commanded stands for ever.

The layouts are those on which plans once failed, or trains stood: lines with a direction token, overlaps that a train
keeps, routes that are declared hostile.  All others: `python -m tests.campaigns.passages`.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.check import derive_file
from interlock.app.dispatch import dispatch
from interlock.app.dispatching import Coming, Ground
from interlock.dispatch import Dispatcher
from interlock.dispatch.commands import errand
from tests.campaigns.passages import tried
from tests.test_dispatch import panel
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


@pytest.mark.parametrize(
    ("path", "orders"),
    [
        ("layouts/slip_junction.yaml", ["1:UM2>G", "2:UM2>G", "3:G>DM2"]),
        ("tests/layouts_for_tests/scissors_two.yaml", ["1:W2>E2", "2:E2>W1", "3:W2>E2"]),
    ],
)
def test_nobody_is_sent_over_an_overlap_that_is_kept_by_who_is_followed(path: str, orders: list[str]) -> None:
    """Train 1 was sent in first: with the other behind it nothing reports that all of it stands before its signal, its
    overlap is not given up, and whoever was to come out over that stood for ever, and so did they."""
    checked = derive_file(path)
    assert checked.layout is not None and checked.table is not None
    ground = Ground(checked.layout, checked.table)
    comings = [Coming(errand(ground.railway, x, 60.0)[0]) for x in orders]
    for outcome in ground.run([comings], lambda: Dispatcher(ground.railway, ground.controller.symbols)):
        assert outcome.stuck == {} and outcome.troubles == ()


def test_an_overlap_that_was_given_up_stays_so_whoever_comes_behind() -> None:
    """Train 1 stands before S2J for so long that its overlap over BD is given up; then train 2 comes behind it.
    Train 3 runs over BD to UM, and 1 goes on when somebody who stood in its way has gone."""
    p = panel("slip_junction")

    def command(text: str) -> None:
        p.dispatcher.carry_out(errand(p.dispatcher.railway, text, 60.0)[0])

    command("1:UM2>G")
    p.stand("BA")
    p.run(20)
    assert p.opened() == {"S2"} and p.shown["YL_BD"]
    p.drive("BA", "BB")
    p.stand("BB", "GX")
    p.run(1000)
    assert not p.shown["YL_BD"] and p.opened() == set()
    p.stand("BB", "GX", "BA", "CB")
    command("2:UM2>UM")
    command("3:CB/S4J>UM")
    p.run(20)
    assert p.opened() == {"S4J"}, [r.reason for r in p.dispatcher.runs]
    for at in (("CB", "BE"), ("BE", "BD"), ("BD",), ()):
        p.stand("BB", "BA", *at)
        p.run(20)
    assert p.opened() == {"S2J"}, [r.reason for r in p.dispatcher.runs]
