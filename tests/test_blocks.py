"""Block lengths: the book's figures, what the formulas do not know, and the screen."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.cli.blocks import command
from interlock.diag import Sink
from interlock.dispatch.blocks import block, blocks, braking, lengths
from interlock.dispatch.language import LineSpec, TrafficSpec, load_text
from interlock.model.elements import SectionId
from tests.layouts import built

BOOK = TrafficSpec.model_validate({"shifts": "3", "days": "300", "train_t": "60"})
MAIN = LineSpec.model_validate({"tonnes": "900000", "men": "2", "waste": "4", "minutes": "6"})
EAST = LineSpec.model_validate({"tonnes": "300000", "men": "1", "waste": "1", "minutes": "20", "rounding": "none"})
MINE = Path("layouts/mine11.dispatch").read_text("utf-8")


def test_the_books_main_line() -> None:
    b = block("main", MAIN, BOOK, True)
    assert (b.loaded, b.trains) == (17, 23)
    assert b.hours == pytest.approx(1.70)
    assert round(b.headway_min, 3) == 5.739
    assert (round(b.longest_m, 1), round(b.built_m, 1)) == (765.2, 510.1)


def test_the_books_branch_is_not_rounded() -> None:
    b = block("east", EAST, BOOK, False)
    assert round(b.loaded, 3) == 5.556 and round(b.trains, 3) == 7.556
    assert round(b.hours, 3) == 1.852
    assert round(b.headway_min, 2) == 18.68
    assert (round(b.longest_m, 1), round(b.built_m, 1)) == (2490.2, 1660.1)


def test_rounding_is_an_option() -> None:
    up = block("east", EAST, BOOK, False, "up")
    assert (up.loaded, up.trains) == (6, 8) and round(up.headway_min, 2) == 18.75
    none = block("main", MAIN, BOOK, True, "none")
    assert round(none.loaded, 2) == 16.67 and round(none.headway_min, 3) == 5.735
    exact = LineSpec.model_validate({"tonnes": "54000", "minutes": "6"})
    assert block("x", exact, BOOK, True).loaded == 1, "a whole number is not rounded up"


def test_a_tippler_that_cannot_keep_up() -> None:
    slow = block("main", MAIN.model_copy(update={"minutes": 30.0}), BOOK, True)
    assert slow.hours == 8.5 and not slow.feasible
    assert block("main", MAIN, BOOK, True).feasible


def test_braking_gives_the_least_length() -> None:
    layout = built("mine11")[0]
    stop = braking(layout)
    v = 20 / 3.6
    assert stop.stopping_m == pytest.approx(v * 5 + v * v / 0.8) and stop.least_m == 100
    fast = braking(built("junction")[0])
    assert fast.least_m == fast.stopping_m > 100


def test_the_layouts_sections_against_the_figures() -> None:
    layout = built("mine11")[0]
    heavy = BOOK.model_copy(update={"main": MAIN.model_copy(update={"sections": ["q1", "q2", "q3"]}), "speed_kmh": 4.0})
    graded = {x.section: x.grade for x in lengths(layout, heavy, blocks(heavy))}
    assert graded == {"q1": "too long", "q2": "fine", "q3": "no reserve"}
    (long,) = [x for x in lengths(layout, heavy, blocks(heavy)) if x.section == SectionId("q1")]
    assert "divide it into 2 of 200 m" in long.advice


def run(*arguments: str) -> tuple[int, str]:
    done = CliRunner().invoke(command, arguments, catch_exceptions=False)
    return done.exit_code, done.output


def test_the_command() -> None:
    code, text = run("layouts/mine11.yaml")
    assert code == 0
    for figure in ("5.739 min", "765.2 m", "510.1 m", "18.676 min", "2490.2 m", "1660.1 m"):
        assert figure in text
    code, text = run("layouts/mine11.yaml", "--format", "json", "--rounding", "up")
    assert code == 0 and json.loads(text)["lines"][1]["loaded"] == 6


def test_findings_have_the_exit_code_1(tmp_path: Path) -> None:
    file = tmp_path / "mine.dispatch"
    file.write_text(MINE.replace("minutes: 6", "minutes: 30"))
    code, text = run("layouts/mine11.yaml", "--dispatch", str(file))
    assert code == 1 and "loaded wagons pile up" in text


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("dispatch: 1\n", "", "IL6001"),
        ("layout: mine11", "layout: heishan", "IL6001"),
        ("q11]", "q99]", "IL6002"),
        ("tonnes: 900000, ", "", "IL1010"),
        ("tonnes: 900000", "tonnes: 0", "IL1014"),
        ("days: 300", "days: 0", "IL1014"),
        ("days: 300", "days: many", "IL1013"),
        ("shifts: 3 ", "shift: 3 ", "IL1011"),
        ("rounding: none", "rounding: down", "IL1017"),
        ("minutes: 20", "minutes: 0", "IL1014"),
        ("dispatch: 1", "dispatch: 2", "IL1015"),
        ("main:", "main: [", "IL1004"),
        ("layout: mine11", "layout: [a]", "IL1012"),
    ],
)
def test_a_bad_file_is_told_with_code_and_place(old: str, new: str, code: str) -> None:
    assert old in MINE
    sink = Sink()
    assert load_text("x.dispatch", MINE.replace(old, new), built("mine11")[0], sink) is None
    told = [d for d in sink.diagnostics if d.code == code]
    assert told and told[0].span is not None and told[0].span.line > 1


def test_a_file_without_traffic_or_none_at_all(tmp_path: Path) -> None:
    file = tmp_path / "x.dispatch"
    file.write_text("# nothing\ndispatch: 1\nlayout: mine11\n")
    assert run("layouts/mine11.yaml", "--dispatch", str(file), "--format", "concise")[1].count("IL6003") == 1
    code, text = run("layouts/fig2_1.yaml")
    assert code == 1 and "IL1001" in text
