"""What is installed is whole: the wheel holds every file of the package.  That every command runs from it in an empty
folder, `tests.campaigns.wheel` shows, which is a stage of CI."""

from __future__ import annotations

import tomllib
from importlib.metadata import version
from pathlib import Path

from interlock import __version__
from interlock.cli.main import VERBS
from tests.campaigns.wheel import COMMANDS, build, contents, packaged


def test_the_wheel_holds_every_file_of_the_package(tmp_path: Path) -> None:
    held = contents(build(tmp_path))
    assert packaged() <= held
    assert {"interlock/py.typed", "interlock/docs/rules/R5.md", "interlock/spec/claims.yaml"} <= held


def test_every_command_is_run_from_the_wheel() -> None:
    assert {line.split()[0] for _, line in COMMANDS} == set(VERBS)


def test_one_version_is_told_everywhere() -> None:
    project = tomllib.loads(Path("pyproject.toml").read_text("utf-8"))["project"]
    assert project["version"] == __version__ and f"## {__version__}" in Path("CHANGELOG.md").read_text("utf-8")
    assert project["authors"] == [{"name": "interlock maintainers"}] and version("interlock") == __version__
