"""`interlock dispatch`: screens, exit codes, plan files, and what is told of bad input."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.cli.dispatch import command
from interlock.diag.codes import CODES


def run(*arguments: str) -> tuple[int, str]:
    done = CliRunner().invoke(command, arguments, catch_exceptions=False)
    return done.exit_code, done.output


def test_the_shortest_deadlock_is_told_and_shown_on_the_controller() -> None:
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:E>W", "--explore")
    assert code == 0 and "states 18, unsafe 2, deadlocks 2" in text
    assert "1. 1 runs over X7-X1 and stands in q1." in text
    assert "4. 1 in q3 cannot go on: X3-E is blocked by 2." in text
    assert "refuses all 2 routes that are left" in text


def test_timings_with_the_rule_and_without() -> None:
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:E>W", "--timings", "6")
    assert code == 0 and "with the rule: 0 of 6 timings stand for ever" in text
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:E>W", "--timings", "6", "--without-rule")
    assert code == 1 and "without the rule: 6 of 6" in text and "X2-W: q3 is not clear" in text


def test_trains_that_cannot_all_go_are_named() -> None:
    code, text = run("layouts/mine11.yaml", "1:W>E", "2:W>E", "3:E>W", "4:E>W")
    assert code == 1 and "no plan exists, shown by exhaustive search: " in text and text.rstrip().endswith("are caught")


def test_a_plan_is_written_and_replayed(tmp_path: Path) -> None:
    file = tmp_path / "plan.json"
    assert run("layouts/mine11.yaml", "in", "out", "--plan", str(file))[0] == 0
    code, text = run("layouts/mine11.yaml", "--replay", str(file))
    assert code == 0 and "each route granted within 2 scans" in text
    code, text = run("layouts/fig2_1.yaml", "--replay", str(file))
    assert code == 1 and "[IL6006]" in text and "another layout" in text
    file.write_text(file.read_text("utf-8")[:300])
    code, text = run("layouts/mine11.yaml", "--replay", str(file))
    assert code == 1 and "[IL6006]" in text
    assert run("layouts/mine11.yaml", "--replay", str(tmp_path / "none"))[0] == 1
    file.write_bytes(b"\xff\xfe\x00")
    assert "[IL6006]" in run("layouts/mine11.yaml", "--replay", str(file))[1]


def test_results_as_data() -> None:
    code, text = run("layouts/fig2_1.yaml", "V1", "V2", "--explore", "--format", "json")
    body = json.loads(text)
    assert code == 0 and body["verdict"] == "PLAN" and body["replayed"]["wrong"] is None
    assert body["explored"] == {
        "states": 25,
        "unsafe": 1,
        "deadlocks": 1,
        "moves_between_safe_states": 36,
        "moves_held_back": 2,
    }


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("layouts/mine11.yaml", "ouf"), "IL6004"),
        (("layouts/mine11.yaml", "1:W>Q"), "IL6004"),
        (("layouts/mine11.yaml", "in", "in"), "IL6004"),
        (("layouts/mine11.yaml", "1:W>E>W"), "IL6005"),
        (("layouts/nothing.yaml", "in"), "IL1001"),
        (("layouts/rejected/no_provider.yaml", "in"), ""),
    ],
)
def test_bad_input_is_told_with_its_code(arguments: tuple[str, ...], code: str) -> None:
    done, text = run(*arguments)
    assert done == 1 and "Traceback" not in text
    assert f"[{code}]" in text if code else text


def test_every_code_of_dispatch_is_known() -> None:
    assert {c for c in CODES if c.startswith("IL6")} >= {"IL6001", "IL6004", "IL6005", "IL6006", "IL6007"}
