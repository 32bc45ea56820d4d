"""A folder of outputs is replaced as a whole, or stays as it was."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from interlock.emit.bundle import write_folder


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


def test_a_folder_is_replaced_as_a_whole(tmp_path: Path) -> None:
    target = tmp_path / "x"
    write_folder(target, {"a": b"1", "st/b": b"2"})
    write_folder(target, {"a": b"3"})
    assert [p.relative_to(tmp_path).as_posix() for p in sorted(tmp_path.rglob("*"))] == ["x", "x/a"]
    assert (target / "a").read_bytes() == b"3"
