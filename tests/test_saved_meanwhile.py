"""A file that is saved while a command works on it: what is written, and said, is of the bytes that were read first."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from interlock.app import check
from interlock.app.certify import certify_file
from interlock.app.check import check_file
from interlock.app.compile import compile_file
from interlock.app.own import NotOurs
from interlock.app.pin import pin_file
from interlock.frontend import load
from interlock.verify import judge
from tests.cli_runs import run

ROOT = Path(__file__).resolve().parent.parent
GOOD = (ROOT / "layouts/fig2_2.yaml").read_bytes()
COMMENT = b"# a word more\n"


@pytest.fixture
def layout(tmp_path: Path) -> Path:
    """A layout with its outputs, in a folder of its own."""
    path = tmp_path / "fig2_2.yaml"
    path.write_bytes(GOOD)
    assert compile_file(str(path), tmp_path / "generated").green
    return path


def saving(path: Path, data: bytes, at: str = "writing tables and plan") -> Callable[[str, int, int], None]:
    """Somebody who saves a file when a stage begins."""
    return lambda stage, done, total: (stage == at and path.write_bytes(data), None)[1]


def test_a_certificate_is_tied_to_the_layout_that_was_proved(layout: Path) -> None:
    """It was tied to what lay there when it was written: what nobody had proved was CERTIFIED, and accepted."""
    top = layout.parent
    done = certify_file(
        str(layout), top / "generated", top / "proofs", progress=saving(layout, GOOD + COMMENT, "obligations")
    )
    assert not done.ok and [n.code for n in done.notes] == ["IL5007"] and "fig2_2.yaml" in done.notes[0].message
    accepted, why = judge(str(top / "proofs/fig2_2"))
    assert not accepted and "../../fig2_2.yaml is not the file proved" in why
    layout.write_bytes(GOOD)
    assert judge(str(top / "proofs/fig2_2"))[0], "it is the certificate of what was read"


def test_a_certificate_is_current_for_the_layout_that_was_read_alone(layout: Path) -> None:
    top = layout.parent
    assert certify_file(str(layout), top / "generated", top / "proofs").ok
    layout.write_bytes(GOOD + COMMENT)
    done = certify_file(str(layout), top / "generated", top / "proofs", check=True, progress=saving(layout, GOOD))
    assert not done.ok and "fig2_2.yaml" in done.notes[0].message
    assert certify_file(str(layout), top / "generated", top / "proofs", check=True).ok


def test_a_layout_that_is_no_file_is_not_certified(layout: Path) -> None:
    """A pipe can be read once, and no certificate be tied to it; `certify` read it twice, and waited for ever."""
    pipe, top = layout.parent / "pipe.yaml", layout.parent
    os.mkfifo(pipe)
    writer = threading.Thread(target=pipe.write_bytes, args=(GOOD,), daemon=True)
    writer.start()
    done = certify_file(str(pipe), top / "generated", top / "proofs")
    assert not done.ok and [n.code for n in done.notes] == ["IL5007"]
    assert "pipe.yaml is no file" in done.notes[0].message and not (top / "proofs").exists()


def test_a_problem_that_comes_through_a_pipe_is_read_once(tmp_path: Path) -> None:
    """It was read again for the second opinion, and waited for ever."""
    pipe, problem = tmp_path / "pipe.json", (ROOT / "tests/schedules/swap.json").read_bytes()
    os.mkfifo(pipe)
    threading.Thread(target=pipe.write_bytes, args=(problem,), daemon=True).start()
    done = run("schedule", str(pipe))
    assert done.exit_code == 0 and "a plan that costs 30" in done.output


@pytest.fixture
def pinned(tmp_path: Path) -> Path:
    """A layout with pins beside it, as they were written."""
    path = tmp_path / "fig2_2.yaml"
    path.write_bytes(GOOD)
    pin_file(str(path)).write(False)
    return path


def test_whether_pins_were_changed_by_hand_is_seen_in_the_bytes_that_were_read(
    pinned: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = pinned.with_suffix(".pins")
    sound = file.read_bytes()
    file.write_bytes(COMMENT + sound)
    assert "IL5011" in {d.code for d in check_file(str(pinned)).diagnostics}

    def loaded(*args: object) -> object:
        found = load(*args)  # type: ignore[arg-type]
        file.write_bytes(sound)
        return found

    monkeypatch.setattr(check, "load", loaded)
    assert "IL5011" in {d.code for d in check_file(str(pinned)).diagnostics}


@pytest.mark.parametrize("force", [False, True])
def test_pins_that_somebody_has_written_meanwhile_are_kept(pinned: Path, force: bool) -> None:
    """What they say was not read, and would be lost: channels that are wired by now would move."""
    file = pinned.with_suffix(".pins")
    found, theirs = pin_file(str(pinned)), file.read_bytes() + COMMENT
    file.write_bytes(theirs)
    with pytest.raises(NotOurs, match="changed meanwhile"):
        found.write(force)
    assert file.read_bytes() == theirs
    file.unlink()
    with pytest.raises(NotOurs, match="changed meanwhile"):
        found.write(force)
    first = pin_file(str(pinned))
    file.write_bytes(theirs)
    with pytest.raises(NotOurs, match="changed meanwhile"):
        first.write(force)
