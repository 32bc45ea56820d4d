"""A folder of outputs is replaced as a whole, or stays as it was."""

from __future__ import annotations

import os
import shutil
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.app.own import write_whole
from interlock.emit.bundle import left_beside, write_folder
from interlock.verify import judge


@pytest.mark.parametrize("failing", [1, 2])
def test_a_folder_that_cannot_be_replaced_stays_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failing: int
) -> None:
    target, rename, calls = tmp_path / "x", os.rename, 0
    write_folder(target, {"a": b"1", "st/b": b"2"})

    def busy(a: Path, b: Path) -> None:
        nonlocal calls
        calls += 1
        if calls == failing:
            raise PermissionError(13, "busy")
        rename(a, b)

    with monkeypatch.context() as patch:
        patch.setattr("interlock.emit.bundle.os.rename", busy)
        with pytest.raises(PermissionError):
            write_folder(target, {"a": b"3"})
    assert [p.name for p in tmp_path.iterdir()] == ["x"], "nothing is left beside it"
    assert (target / "a").read_bytes() == b"1" and (target / "st/b").read_bytes() == b"2"


def test_of_two_that_write_a_folder_at_once_none_leaves_anything(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target, rename = tmp_path / "x", os.rename
    write_folder(target, {"a": b"1"})

    def quicker(a: Path, b: Path) -> None:
        rename(a, b)
        if b.suffix == ".old":
            target.mkdir()
            (target / "a").write_bytes(b"2")

    with monkeypatch.context() as patch:
        patch.setattr("interlock.emit.bundle.os.rename", quicker)
        with pytest.raises(OSError, match="not empty"):
            write_folder(target, {"a": b"3"})
    assert [p.name for p in tmp_path.iterdir()] == ["x"] and (target / "a").read_bytes() == b"2"


def test_a_folder_is_replaced_as_a_whole(tmp_path: Path) -> None:
    target = tmp_path / "x"
    write_folder(target, {"a": b"1", "st/b": b"2"})
    write_folder(target, {"a": b"3"})
    assert [p.relative_to(tmp_path).as_posix() for p in sorted(tmp_path.rglob("*"))] == ["x", "x/a"]
    assert (target / "a").read_bytes() == b"3"


def test_a_link_is_followed(tmp_path: Path) -> None:
    """The link was replaced by a folder, and where it had led the old outputs stayed, while `written` was said."""
    real, link = tmp_path / "real", tmp_path / "out" / "x"
    link.parent.mkdir()
    link.symlink_to(real)
    for data in (b"1", b"2"):  # first there is nothing where it leads
        write_folder(link, {"a": data})
        assert link.is_symlink() and (real / "a").read_bytes() == data
    assert [p.name for p in link.parent.iterdir()] == ["x"] and {p.name for p in tmp_path.iterdir()} == {"real", "out"}
    (round_ := tmp_path / "round").symlink_to(round_)
    with pytest.raises(OSError, match="symbolic links"):
        write_folder(round_, {"a": b"1"})


def test_a_certificate_in_a_folder_behind_a_link_finds_what_it_names(tmp_path: Path) -> None:
    layout = tmp_path / "here" / "fig2_2.yaml"
    layout.parent.mkdir()
    shutil.copy("layouts/fig2_2.yaml", layout)
    for name in ("generated", "proofs"):
        (tmp_path / "far" / "away" / name).mkdir(parents=True)
        (tmp_path / "here" / name).symlink_to(tmp_path / "far" / "away" / name)
    assert compile_file(str(layout), tmp_path / "here/generated").green
    done = certify_file(str(layout), tmp_path / "here/generated", tmp_path / "here/proofs")
    assert done.ok, done.notes
    assert judge(str(tmp_path / "far/away/proofs/fig2_2"))[0]


def test_a_folder_keeps_its_permissions_and_a_new_one_has_those_of_the_umask(tmp_path: Path) -> None:
    """Each was 755: outputs that a umask of 077 hid from others were shown, and a folder of a group lost its group."""

    def mode(path: Path) -> int:
        return stat.S_IMODE(path.stat().st_mode)

    before = os.umask(0o077)
    try:
        write_folder(tmp_path / "x", {"st/a": b"1"})
        assert mode(tmp_path / "x") == 0o700
        (tmp_path / "x").chmod(0o2775)
        write_folder(tmp_path / "x", {"st/a": b"2"})
        assert mode(tmp_path / "x") == 0o2775 and mode(tmp_path / "x/st") & stat.S_ISGID
        (tmp_path / "group").mkdir()
        (tmp_path / "group").chmod(0o2770)
        write_folder(tmp_path / "group/y", {"a": b"1"})
        assert mode(tmp_path / "group/y") == 0o2700
    finally:
        os.umask(before)


ENDED = """
import os, signal, sys
from pathlib import Path
from interlock.app.own import write_whole
from interlock.emit.bundle import write_folder
number, place, kept = int(sys.argv[1]), Path(sys.argv[2]), Path.write_bytes
signal.signal(number, signal.SIG_DFL)  # whatever this test runs under may ignore it
def write_bytes(self, data):
    kept(self, data)
    os.kill(os.getpid(), number)
    os.kill(os.getpid(), number)
Path.write_bytes = write_bytes
write_folder(place, {"a": b"3", "b": b"4"}) if place.is_dir() else write_whole(place, b"3")
print("went on")
"""


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_who_is_asked_to_end_takes_away_what_is_half_written(tmp_path: Path, number: int) -> None:
    write_folder(tmp_path / "x", {"a": b"1"})
    write_whole(tmp_path / "y", b"2")
    for name in ("x", "y"):
        given = [sys.executable, "-c", ENDED, str(int(number)), str(tmp_path / name)]
        done = subprocess.run(given, capture_output=True, text=True, check=False)
        assert done.returncode == -number and not done.stdout and not done.stderr
    assert {p.name for p in tmp_path.iterdir()} == {"x", "y"}
    assert (tmp_path / "x/a").read_bytes() == b"1" and (tmp_path / "y").read_bytes() == b"2"


def test_what_a_run_that_was_killed_has_left_is_named(tmp_path: Path) -> None:
    layout = "layouts/fig2_2.yaml"
    compile_file(layout, tmp_path)
    os.rename(tmp_path / "fig2_2", tmp_path / ".fig2_2.01234567.old")
    (tmp_path / ".fig2_2.89abcdef").mkdir()
    (tmp_path / ".fig2_2_split.89abcdef").mkdir()  # another layout's
    names = [".fig2_2.01234567.old", ".fig2_2.89abcdef"]
    assert [p.name for p in left_beside(tmp_path / "fig2_2")] == names
    for check in (True, False, True):
        done = compile_file(layout, tmp_path, check=check)
        told = [n.message for n in done.notes if n.code == "IL5013"]
        assert [any(name in t for t in told) for name in names] == [True, True] and len(told) == 2
        assert done.green == (check is False or (tmp_path / "fig2_2").exists())
    done = certify_file(layout, tmp_path, tmp_path / "proofs")
    assert done.ok and not done.notes
    (tmp_path / "proofs/.fig2_2.01234567.old").mkdir()
    done = certify_file(layout, tmp_path, tmp_path / "proofs")
    assert done.ok and [n.code for n in done.notes] == ["IL5013"]
