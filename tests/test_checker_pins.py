"""A file of pins beside the layout that is not the one of which the mapping program was made."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from interlock.app.pin import pin_file
from interlock.checker.check import report
from tests.cli_runs import run

FIG = Path("layouts/fig2_2.yaml").resolve()


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A layout with pins, its outputs and its certificate."""
    top = tmp_path_factory.mktemp("pinned")
    layout = top / FIG.name
    shutil.copy(FIG, layout)
    pin_file(str(layout)).write(False)
    outputs, proofs = str(top / "generated"), str(top / "proofs")
    where = {"compile": ["-o", outputs], "certify": ["--outputs", outputs, "-o", proofs]}
    for command in where:
        done = run(command, str(layout), *where[command])
        assert done.exit_code == 0, done.output
    return top


@pytest.fixture
def copy(made: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(made, tmp_path / "copy"))


def told(top: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    code = report(top / FIG.name, top / "proofs" / "fig2_2")
    return code, capsys.readouterr().out


def test_pins_that_the_program_was_made_of_are_compared(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out = told(copy, capsys)
    assert code == 0 and "VERIFIED" in out and "channels where fig2_2.pins has them" in out
    assert "of st/iec/fig2_2_io.st all but its addresses" in out


def test_exchanged_channels_are_refused(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pins = copy / "fig2_2.pins"
    text = pins.read_text("utf-8")
    assert "CLR_DP: I0.1" in text and "CLR_SA: I0.2" in text
    text = text.replace("CLR_DP: I0.1", "CLR_DP: I9.9").replace("CLR_SA: I0.2", "CLR_SA: I0.1").replace("I9.9", "I0.2")
    pins.write_text(text, "utf-8")
    code, out = told(copy, capsys)
    assert code == 1 and "has CLR_DP at I0.1, and" in out and "has it at I0.2" in out


def test_a_channel_that_is_kept_for_what_is_gone_is_not_taken(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pins = copy / "fig2_2.pins"
    text = pins.read_text("utf-8").replace("CLR_DP: I0.1", "CLR_DX: I0.1")
    pins.write_text(text, "utf-8")
    code, out = told(copy, capsys)
    assert code == 1 and "keeps for CLR_DX" in out


def test_without_the_pins_it_is_said_that_they_were_not_compared(
    copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (copy / "fig2_2.pins").unlink()
    code, out = told(copy, capsys)
    assert code == 3 and "not compared with the layout: the pins from which st/iec/fig2_2_io.st was made" in out
