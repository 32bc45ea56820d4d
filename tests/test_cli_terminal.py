"""Terminals, pipes, closed streams, interrupts."""

from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from interlock.app.init import yard
from interlock.cli import common
from interlock.cli.main import cli
from tests.cli_runs import process


@pytest.mark.parametrize("closed", [(0,), (1,), (2,), (0, 1, 2)], ids=str)
def test_a_service_that_closes_the_streams_gets_its_answer(closed: tuple[int, ...]) -> None:
    args = (sys.executable, "-m", "interlock", "check", "layouts/fig2_2.yaml")
    done = subprocess.run(
        args, capture_output=True, text=True, check=False, preexec_fn=lambda: [os.close(n) for n in closed]
    )
    assert done.returncode == 0 and "error" not in done.stdout + done.stderr
    assert ("no problems" in done.stdout) is (1 not in closed)


@pytest.mark.parametrize(
    "args",
    [
        ("check", "layouts/cn6502.yaml"),
        ("check", "missing.yaml", "--format", "json"),
        ("why", "layouts/fig2_2.yaml"),
        ("explain",),
        ("schema",),
        ("draw", "missing.yaml"),
        ("--help",),
        ("schema", "--of", "nothing", "--format", "json"),
    ],
    ids=" ".join,
)
def test_a_reader_that_closes_the_pipe_ends_every_command_alike_and_quietly(args: tuple[str, ...]) -> None:
    read, write = os.pipe()
    os.close(read)
    command = (sys.executable, "-m", "interlock", *args)
    done = subprocess.run(command, stdout=write, stderr=subprocess.PIPE, text=True, check=False)
    os.close(write)
    assert done.returncode == 141
    assert "Traceback" not in done.stderr and "rror" not in done.stderr


def test_where_there_is_no_room_what_was_there_stays(tmp_path: Path) -> None:
    """A plan that does not fit leaves the one of before, and nothing half-written."""
    plan = tmp_path / "plan.svg"
    args = (sys.executable, "-m", "interlock", "draw", "layouts/fig2_2.yaml", "-o", str(plan))
    small = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))  # noqa: E731
    full = subprocess.run(args, capture_output=True, text=True, check=False, preexec_fn=small)
    assert full.returncode == 1 and "File too large" in full.stderr and not list(tmp_path.iterdir())
    assert subprocess.run(args, capture_output=True, check=False).returncode == 0
    before = plan.read_bytes()
    full = subprocess.run(args, capture_output=True, text=True, check=False, preexec_fn=small)
    assert full.returncode == 1 and plan.read_bytes() == before and list(tmp_path.iterdir()) == [plan]


def test_nothing_said_is_lost_at_the_end(tmp_path: Path) -> None:
    """The process ends at once; what it wrote is there, and its code tells what happened."""
    for args, code, said in (
        (["prove", "layouts/fig2_2.yaml", "--format", "json"], 0, '"text_equals_controller": true'),
        (["check", str(tmp_path / "none.yaml")], 1, "none.yaml"),
        (["prove"], 2, "Usage"),
    ):
        done = process(*args)
        assert done.returncode == code and said in done.stdout + done.stderr
    for verb in ("prove", "check"):
        with Path("/dev/full").open("w") as full:
            args = [sys.executable, "-m", "interlock", verb, "layouts/fig2_2.yaml"]
            lost = subprocess.run(args, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        assert lost.returncode == 1 and "internal" not in lost.stderr, lost.stderr
    out = tmp_path / "out.json"
    with out.open("w") as file:
        args = [sys.executable, "-m", "interlock", "prove", "layouts/passing_loop.yaml", "--format", "json"]
        subprocess.run(args, stdout=file, check=True)
    assert json.loads(out.read_text())[0]["text_equals_controller"] is True


def test_colour_is_for_terminals(monkeypatch: pytest.MonkeyPatch) -> None:
    args = ["check", "tests/diagnostics/IL2004.yaml"]
    plain = CliRunner().invoke(cli, args)
    assert "\x1b[" not in plain.output and "\x1b[" not in CliRunner().invoke(cli, args, color=True).output  # NO_COLOR
    monkeypatch.delenv("NO_COLOR")
    coloured = CliRunner().invoke(cli, args, color=True).output
    assert "\x1b[31m" in coloured and click.unstyle(coloured).split(",")[0] == plain.output.split(",")[0]


def on_a_terminal(*args: str) -> str:
    """What a command writes to a terminal."""
    controller, terminal = os.openpty()
    command = [sys.executable, "-m", "interlock", *args]
    with subprocess.Popen(command, stdout=terminal, stderr=terminal, env={**os.environ, "TERM": "xterm"}) as running:
        os.close(terminal)
        said = b""
        try:
            while chunk := os.read(controller, 4096):
                said += chunk
        except OSError:  # the other end is closed
            pass
        running.wait()
    os.close(controller)
    return said.decode()


def test_a_terminal_sees_a_bar(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "yard.yaml").write_text(yard(16), "utf-8")
    monkeypatch.chdir(tmp_path)
    said = on_a_terminal("prove", "yard.yaml")
    assert "\x1b[?25l" in said and "yard.yaml: proving" in said and "PROVED" in said


def test_the_bar_moves_in_every_stage() -> None:
    bar = common._Bar("yard.yaml")
    try:
        bar._begin()
        for stage, done, total in (("deriving", 0, 0), ("proving", 7, 40), ("searching", 3, 16)):
            bar.report(stage, done, total)
            (task,) = bar._bar.tasks
            assert (task.description, task.completed, task.total) == (f"yard.yaml: {stage}", done, total or None)
    finally:
        bar.end()


def test_elsewhere_each_stage_is_a_line(tmp_path: Path) -> None:
    done = process("compile", "layouts/fig2_2.yaml", "-o", str(tmp_path))
    stages = [line.removeprefix("layouts/fig2_2.yaml: ") for line in done.stderr.splitlines()]
    assert stages == ["deriving", "proving", "auditing the table", "comparing the texts", "writing tables and plan"]
    loop = "layouts/fig2_2.yaml"
    for stage, args in {
        "running every two routes": ("availability", loop),
        "drawing": ("draw", loop, "-o", str(tmp_path / "l.svg")),
        "making the circuit": ("export", loop, "-o", str(tmp_path / "l.aig")),
        "planning": ("dispatch", loop, "1:X1>A"),
        "judging mutants": ("mutate", loop, "--family", "initial RQZ"),
    }.items():
        assert process(*args).stderr.splitlines()[0] == f"{loop}: {stage}"
    done = process("check", "layouts/fig2_2.yaml")
    assert re.search(r"no problems, 4 routes, \d+\.\d s$", done.stdout.strip())


def test_an_internal_error_gives_no_traceback(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from interlock.cli import main as module

    def broken(**_: object) -> None:
        raise ZeroDivisionError("one over nothing")

    monkeypatch.setattr(module, "cli", broken)
    with pytest.raises(SystemExit) as stop:
        module.main()
    assert stop.value.code == 70 and "Traceback" not in capsys.readouterr().err
    monkeypatch.setattr(sys, "argv", ["interlock", "check", "x.yaml", "--format", "json"])
    with pytest.raises(SystemExit) as stop:
        module.main()
    said = capsys.readouterr()
    assert stop.value.code == 70 and "one over nothing" in json.loads(said.out)["error"] and not said.err


@pytest.mark.parametrize(("given", "after"), [(("prove", "yard.yaml", "-j", "2"), 2), (("prove", "yard.yaml"), 6)])
def test_an_interrupt_ends_all_processes_without_a_word_of_python(
    given: tuple[str, ...], after: int, tmp_path: Path
) -> None:
    """In the midst of it: with texts and runs beside the proof, and in a solver."""
    (tmp_path / "yard.yaml").write_text(yard(124), encoding="utf-8")
    interrupted(given, after, tmp_path)


def test_an_interrupt_ends_the_proofs_of_several_layouts(tmp_path: Path) -> None:
    for n in range(4):
        (tmp_path / f"y{n}.yaml").write_text(yard(60).replace("name: ", f"name: y{n}_"), encoding="utf-8")
    interrupted(("prove", *sorted(p.name for p in tmp_path.iterdir()), "-j", "2"), 3, tmp_path)


def test_an_interrupt_ends_shifts_that_only_begin(tmp_path: Path) -> None:
    """Processes that are being started are in the midst of reading Python's own modules."""
    for name in ("heishan.yaml", "heishan.dispatch"):
        (tmp_path / name).write_text(Path(f"layouts/{name}").read_text("utf-8"), encoding="utf-8")
    interrupted(("simulate", "heishan.yaml", "--shifts", "2000", "-j", "2"), 2.5, tmp_path)


def interrupted(given: tuple[str, ...], after: float, folder: Path) -> None:
    """Run a command, press Ctrl-C after some seconds, and see that nothing is left of it."""
    program = [sys.executable, "-m", "interlock", *given]
    with subprocess.Popen(
        program, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True, text=True
    ) as running:
        time.sleep(after)
        os.killpg(running.pid, signal.SIGINT)
        said, _ = running.communicate(timeout=30)
    assert running.returncode == 130 and said.splitlines()[-1] == "interrupted" and "Traceback" not in said
    for _ in range(50):
        try:
            os.killpg(running.pid, 0)
        except ProcessLookupError:
            return
        time.sleep(0.1)
    raise AssertionError("a process is left")
