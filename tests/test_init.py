"""The layouts that `interlock init` writes."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app.init import STARTER, line, yard
from interlock.audit import audit
from interlock.cli.init import command
from interlock.logic.lower import lower
from interlock.proof.engines.limits import Limits
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from tests.layouts import grown


@pytest.mark.parametrize(
    ("text", "routes"), [(STARTER, 10), (line(1), 10), (line(3), 26), (yard(4), 40), (yard(5), 48), (yard(16), 136)]
)
def test_what_is_written_has_the_routes_that_it_should(text: str, routes: int) -> None:
    made = grown(text)
    assert made is not None and not made[2].has_errors
    assert len(made[1].routes) == routes and audit(made[0], made[1]) == ()


@pytest.mark.parametrize(("text", "jobs"), [(STARTER, 1), (line(8), 2), (yard(6), 2)])
def test_it_is_proved_whole_and_in_parts(text: str, jobs: int) -> None:
    made = grown(text)
    assert made is not None
    result = prove(System(made[0], lower(made[0], made[1])), Limits(jobs=jobs))
    assert result.proved and not result.dropped


def test_the_command_writes_a_file_once(tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    run = CliRunner().invoke(command, ["-o", str(path)])
    assert run.exit_code == 0 and path.read_text("utf-8") == STARTER and "interlock check" in run.output
    assert CliRunner().invoke(command, ["-o", str(path)]).exit_code == 1
    assert CliRunner().invoke(command, ["--yard", "4", "-o", str(path), "--force"]).exit_code == 0
    assert CliRunner().invoke(command, ["--yard", "4", "--line", "2"]).exit_code == 2
    assert CliRunner().invoke(command, ["--yard", "3"]).exit_code == 2
    assert CliRunner().invoke(command, ["--line", "1"]).output == line(1)


def test_the_next_command_can_be_copied(tmp_path: Path) -> None:
    done = CliRunner().invoke(command, ["-o", str(tmp_path / "my station.yaml")])
    assert f"next: interlock check '{tmp_path / 'my station.yaml'}'" in done.output
