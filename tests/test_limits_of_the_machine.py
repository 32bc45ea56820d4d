"""What the machine has no room for is said as that, with what to do: it was told as a defect of interlock."""

from __future__ import annotations

import errno
import multiprocessing
import os
import resource
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from xlsxwriter.exceptions import FileCreateError

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.cli.limits import limit_of
from interlock.exceptions import Ended
from interlock.proof.engines.pool import Begun

ROOT = Path(__file__).resolve().parent.parent
LAYOUT = str(ROOT / "layouts/fig2_2.yaml")


def limited(limit: Callable[[], None], *args: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "interlock", *args]
    return subprocess.run(command, capture_output=True, text=True, check=False, preexec_fn=limit)


def test_a_workbook_that_may_not_be_so_large_is_said_to_be_too_large(tmp_path: Path) -> None:
    small = partial(resource.setrlimit, resource.RLIMIT_FSIZE, (4096, 4096))
    done = limited(small, "compile", LAYOUT, "-o", str(tmp_path))
    assert done.returncode == 1 and "File too large; a file may not be so large here: see `ulimit -f`" in done.stderr
    assert "defect" not in done.stderr and not list(tmp_path.iterdir())


@pytest.mark.parametrize("files", [10, 14, 20])
def test_where_few_files_may_be_open_fewer_processes_do_it_or_it_is_said(tmp_path: Path, files: int) -> None:
    few = partial(resource.setrlimit, resource.RLIMIT_NOFILE, (files, files))
    done = limited(few, "compile", LAYOUT, "-o", str(tmp_path), "-j", "4")
    assert done.returncode == 0 or (done.returncode == 3 and "raise `ulimit -n`, or try fewer jobs" in done.stderr)
    assert "defect" not in done.stderr


@pytest.mark.parametrize("code", [errno.EROFS, errno.ENOENT, errno.EMFILE, errno.EAGAIN])
def test_without_room_for_what_processes_share_one_does_the_work(monkeypatch: pytest.MonkeyPatch, code: int) -> None:
    """`/dev/shm` that is not there, or read-only: `-j 2` ended."""

    def none(*_: object, **__: object) -> None:
        raise OSError(code, os.strerror(code), "/dev/shm")

    for where in ("Value", "Pipe", "Process"):
        with monkeypatch.context() as patch:
            patch.setattr(multiprocessing.get_context("fork"), where, none, raising=False)
            with Begun([partial(pow, 2, n) for n in range(4)], 2) as begun:
                assert begun.results() == [1, 2, 4, 8]


@pytest.mark.parametrize(
    ("error", "said", "code"),
    [
        (OSError(errno.ENOSPC, "No space left on device"), "No space left on device; make room there", 1),
        (FileCreateError(OSError(errno.EFBIG, "File too large")), "`ulimit -f`", 1),
        (OSError(errno.EMFILE, "Too many open files"), "`ulimit -n`", 3),
        (OSError(errno.ENOMEM, "Cannot allocate memory"), "memory has run out", 3),
        (MemoryError(), "memory has run out", 3),
        (ImportError("pysolvers.so: failed to map segment from shared object"), "memory has run out", 3),
        (Exception(b"out of memory"), "memory has run out", 3),
        (Ended("a process has ended"), "a process has ended", 3),
    ],
)
def test_what_there_is_no_room_for_is_named_with_a_way_out(error: Exception, said: str, code: int) -> None:
    found = limit_of(error)
    assert found is not None and said in found[0] and found[1] == code


def test_anything_else_is_no_limit() -> None:
    assert limit_of(ValueError("x")) is None and limit_of(OSError(errno.EACCES, "Permission denied")) is None


@pytest.mark.parametrize(("layout", "code"), [("fig2_2.yaml", 0), ("refuted/wrong_waiver.yaml", 1)])
def test_what_finds_no_room_on_the_standard_error_ends_nothing(tmp_path: Path, layout: str, code: int) -> None:
    """With a full device there the command did nothing, and its exit code was 120."""
    args = [sys.executable, "-m", "interlock", "compile", str(ROOT / "layouts" / layout)]
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(args, cwd=tmp_path, stdout=subprocess.PIPE, stderr=full, text=True, check=False)
    assert done.returncode == code and ("PROVED" if code == 0 else "NOT SAFE") in done.stdout
    assert (tmp_path / "generated" / Path(layout).stem / "table.json").exists()


def test_usage_that_finds_no_room_has_its_exit_code() -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run([sys.executable, "-m", "interlock", "prove"], stderr=full, check=False)
    assert done.returncode == 2


def test_an_interrupt_while_it_loads_gives_no_traceback(tmp_path: Path) -> None:
    (tmp_path / "click.py").write_text("raise KeyboardInterrupt\n", encoding="utf-8")
    env = {**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{ROOT}"}
    args = [sys.executable, "-m", "interlock", "check", LAYOUT]
    done = subprocess.run(args, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 130 and done.stderr == "interrupted\n"


def test_a_name_that_no_manifest_can_hold_is_said_to_be_one(tmp_path: Path) -> None:
    """It was said that a codec cannot encode something."""
    path = tmp_path / os.fsdecode(b"\xff.yaml")
    path.write_bytes(Path(LAYOUT).read_bytes())
    assert compile_file(str(path), tmp_path / "generated").green
    done = certify_file(str(path), tmp_path / "generated", tmp_path / "proofs")
    assert [n.code for n in done.notes] == ["IL5007"]
    assert r"a manifest cannot name '../../\udcff.yaml', which is not UTF-8" in done.notes[0].message
    assert not (tmp_path / "proofs").exists()
