"""What is installed is whole: the wheel holds every file of the package.  That every command runs from it in an empty
folder, `tests.campaigns.wheel` shows, which is a stage of CI."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
from importlib.metadata import version
from pathlib import Path

from interlock import __version__
from interlock.cli.main import VERBS
from tests.campaigns.wheel import COMMANDS, SOURCES, build, contents, lowest, packaged


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


def test_the_lowest_versions_are_those_of_the_extras_wherever_they_stand() -> None:
    """`tests.campaigns.wheel --lowest` runs every command with them; `dev` has the same bounds."""
    pins = dict(p.split("==") for p in lowest())
    assert pins.keys() >= {"click", "pydantic", "python-sat", "uvicorn", "pymodbus", "ortools"}
    dev = tomllib.loads(Path("pyproject.toml").read_text("utf-8"))["project"]["optional-dependencies"]["dev"]
    for found in dev:
        name, _, bound = found.partition(">=")
        assert pins.get(name, bound) == bound, found


def test_the_source_distribution_has_the_licence_and_no_part_of_the_tests(tmp_path: Path) -> None:
    """192 modules of tests were in it, without the layouts and helpers that they need."""
    for name in (*SOURCES, "MANIFEST.in", "tests"):
        if Path(name).is_dir():
            skipped = shutil.ignore_patterns("__pycache__", "campaigns")
            shutil.copytree(name, tmp_path / name, ignore=skipped)
        else:
            shutil.copy(name, tmp_path)
    made = "import setuptools.build_meta as b; b.build_sdist('dist')"
    done = subprocess.run([sys.executable, "-c", made], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "Deprecat" not in done.stderr + done.stdout
    (file,) = (tmp_path / "dist").glob("*.tar.gz")
    with tarfile.open(file) as archive:
        held = {n.partition("/")[2] for n in archive.getnames()}
        about = archive.extractfile(next(n for n in archive.getnames() if re.fullmatch(r"[^/]*/PKG-INFO", n)))
        assert about is not None and b"License-Expression: MIT\n" in about.read()
    assert {"LICENSE", "interlock/verify.py", "pyproject.toml"} <= held
    assert not [n for n in held if n.startswith("tests")]


def test_git_changes_no_end_of_a_line() -> None:
    """With `core.autocrlf` each file would be another than the one whose digest is told."""
    assert "* -text" in Path(".gitattributes").read_text("utf-8").splitlines()
