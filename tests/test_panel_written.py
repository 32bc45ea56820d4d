"""A panel's record whose file is full, cut or gone: nothing is lost silently, and what is written can be played."""

from __future__ import annotations

import errno
import json
import os
from collections.abc import Callable
from dataclasses import field
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from interlock.app.run import Ready
from interlock.dataclass import dataclass
from interlock.field.plc import Cycle, Memory
from interlock.panel import written
from interlock.panel.event import Event
from interlock.panel.journal import page, trace
from interlock.panel.recorder import Recorder
from interlock.panel.standing import Standing
from interlock.record.log import read_file


@dataclass
class Disk:
    """A disk with room for so many more lines, and a clock."""

    room: float = 1e9
    now: float = 100.0
    write: Callable[[int, bytes], int] = field(default=os.write)

    def writes(self, handle: int, data: bytes) -> int:
        """As the system does."""
        if self.room <= 0:
            self.write(handle, data[:5])  # a part of it finds room
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        self.room -= 1
        return self.write(handle, data)


@pytest.fixture
def disk(monkeypatch: pytest.MonkeyPatch) -> Disk:
    found = Disk()
    monkeypatch.setattr("interlock.record.log.os.write", found.writes)
    monkeypatch.setattr("interlock.panel.recorder.time.monotonic", lambda: found.now)
    return found


def later(recorder: Recorder, disk: Disk, cycle: Cycle | None = None, seconds: float = 2.0) -> None:
    """Some time, and a cycle after it."""
    disk.now += seconds
    recorder.cycle(cycle)


def occupied(ready: Ready, *sections: str) -> Cycle:
    """A cycle in which these sections are reported occupied, and no others."""
    assert ready.controller is not None
    clear = ready.controller.symbols.sections.clear
    return Cycle({n: int(s not in sections) for s, n in clear.items()}, {}, True, (), Memory({}, {}))


def told(path: Path) -> list[str]:
    """Kinds of events, or what they say."""
    return [e["text"] if e["kind"] in ("operation", "note") else e["kind"] for e in read_file(path).events]


def can_be_used(ready: Ready, path: Path) -> bool:
    """Printed, played and gone on with."""
    found = read_file(path)
    Recorder(path, ready).close()
    return bool(found.ended and page(found) and json.loads(trace(found))["states"])


def test_a_record_begun_on_a_full_disk_begins_when_there_is_room(ready: Ready, tmp_path: Path, disk: Disk) -> None:
    path, disk.room = tmp_path / "x.log", 0
    recorder = Recorder(path, ready)
    recorder.cycle(None)
    later(recorder, disk)
    disk.room = 1e9
    later(recorder, disk)
    recorder.event(Event("note", "seen"))
    recorder.close()
    assert told(path) == ["begin", "gap", "picture", "seen", "end"] and can_be_used(ready, path)


@pytest.mark.parametrize("room", [0, 1, 2, 3])
def test_a_record_removed_while_the_disk_is_full_begins_anew(
    ready: Ready, tmp_path: Path, disk: Disk, room: int
) -> None:
    """However many lines find room when it is tried first."""
    path = tmp_path / "x.log"
    recorder = Recorder(path, ready)
    recorder.cycle(occupied(ready, "s3"))
    recorder.stands(Standing(("s9",)))
    disk.room = 0
    recorder.event(Event("operation", "block section s6", "Ann"))
    path.unlink()
    later(recorder, disk, occupied(ready, "s3"))
    disk.room = room
    later(recorder, disk, occupied(ready, "s3"))
    disk.room = 1e9
    for _ in range(2):
        later(recorder, disk, occupied(ready, "s3"))
    assert recorder.lost == ""
    recorder.close()
    first = [x for x in told(path) if x != "gap"]
    first = [x for k, x in enumerate(first) if x not in first[:k]]
    assert first == ["begin", "picture", "kept", "block section s6", "end"], told(path)
    found = read_file(path)
    assert next(e["blocks"] for e in found.events if e["kind"] == "kept") == ["s9"]
    assert all(s["CLR_s3"] for s in json.loads(trace(found))["states"][1:]) and can_be_used(ready, path)


def test_after_lines_that_were_dropped_all_is_shown_as_it_is(
    ready: Ready, tmp_path: Path, disk: Disk, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Changes of what nobody had written showed an occupied section clear."""
    monkeypatch.setattr(written, "WAITING", 20)
    recorder = Recorder(tmp_path / "x.log", ready)
    recorder.cycle(occupied(ready))
    disk.room = 0
    recorder.cycle(occupied(ready, "s3"))
    recorder.stands(Standing(("s9",)))
    for k in range(25):
        recorder.event(Event("note", f"note {k}"))
    disk.room = 1e9
    later(recorder, disk, occupied(ready, "s3"))
    later(recorder, disk, occupied(ready, "s3", "s6"))
    recorder.close()
    events = read_file(tmp_path / "x.log").events
    kinds = [e["kind"] for e in events]
    at = kinds.index("gap")
    assert events[at]["dropped"] == 7 and kinds[at + 1 : at + 3] == ["picture", "kept"]
    assert events[at + 1]["whole"] and events[at + 2]["blocks"] == ["s9"]
    states = json.loads(trace(read_file(tmp_path / "x.log")))["states"]
    assert [s["CLR_s3"] for s in states[-2:]] == [True, True] and states[-1]["CLR_s6"]
    again = Recorder(tmp_path / "x.log", ready)
    assert again.standing.blocks == ("s9",)
    again.close()


def test_what_is_done_after_the_file_was_removed_is_in_the_next(ready: Ready, tmp_path: Path, disk: Disk) -> None:
    """It was looked for once a second, and until then all went to the file that nobody could find."""
    path = tmp_path / "x.log"
    recorder = Recorder(path, ready)
    later(recorder, disk)
    path.unlink()
    for text in ("release section s6", "block section s3"):
        recorder.event(Event("operation", text, "Ann"))
        later(recorder, disk, seconds=0.4)
    later(recorder, disk)
    recorder.close()
    assert told(path) == ["begin", "picture", "gap", "release section s6", "block section s3", "end"]


def test_a_file_that_is_emptied_begins_anew(ready: Ready, tmp_path: Path, disk: Disk) -> None:
    """As where logs are copied and emptied at night: what came then did not follow what was there, and nothing of it
    could be read."""
    path = tmp_path / "x.log"
    recorder = Recorder(path, ready)
    later(recorder, disk)
    os.truncate(path, 0)
    recorder.event(Event("operation", "release section s6", "Ann"))
    assert "was cut, or written by another program" in recorder.lost
    later(recorder, disk)
    assert recorder.lost == ""
    recorder.close()
    assert told(path) == ["begin", "picture", "gap", "release section s6", "end"] and can_be_used(ready, path)


def test_a_file_that_was_cut_is_left_as_it_is(
    ready: Ready, tmp_path: Path, disk: Disk, capsys: pytest.CaptureFixture[str]
) -> None:
    """It is evidence; what is kept goes to the next one, or is told when the panel ends."""
    path = tmp_path / "x.log"
    recorder = Recorder(path, ready)
    later(recorder, disk)
    os.truncate(path, path.stat().st_size - 9)
    before = path.read_bytes()
    recorder.event(Event("operation", "release section s6", "Ann"))
    later(recorder, disk)
    assert "is not the log that was written until then: move it away" in recorder.lost
    recorder.close()
    assert path.read_bytes() == before
    assert capsys.readouterr().err.startswith(f"error: the last 2 events are not in {path}: the record cannot be")


def test_at_its_end_it_is_tried_once_more_and_said_what_is_missing(
    ready: Ready, tmp_path: Path, disk: Disk, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, room in (("room.log", 1e9), ("full.log", 0)):
        recorder = Recorder(tmp_path / name, ready)
        recorder.cycle(None)
        disk.room = 0
        recorder.event(Event("operation", "release section s6", "Ann"))
        disk.room = room
        recorder.close()
        disk.room = 1e9
    assert told(tmp_path / "room.log")[2:] == ["gap", "release section s6", "end"]
    err = capsys.readouterr().err
    assert err.count("\n") == 1 and "error: the last 2 events are not in" in err and "No space left" in err


def test_what_was_dropped_is_counted_once_and_gaps_do_not_fill_the_disk(
    ready: Ready, tmp_path: Path, disk: Disk, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(written, "WAITING", 20)
    recorder = Recorder(tmp_path / "x.log", ready)
    recorder.cycle(None)
    disk.room = 0
    for k in range(25):
        recorder.event(Event("operation", f"{k}"))
    for _ in range(6):
        disk.room = 1
        later(recorder, disk)
    disk.room = 1e9
    later(recorder, disk)
    recorder.close()
    found: list[dict[str, Any]] = list(read_file(tmp_path / "x.log").events)
    assert sum(e["dropped"] for e in found if e["kind"] == "gap") == 5
    assert [e["text"] for e in found if e["kind"] == "operation"] == [f"{k}" for k in range(5, 25)]
    assert sum(e["kind"] == "gap" for e in found) < 6


def test_releases_that_were_dropped_are_counted(
    ready: Ready, tmp_path: Path, disk: Disk, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(written, "WAITING", 20)
    recorder = Recorder(tmp_path / "x.log", ready)
    recorder.cycle(None)
    disk.room = 0
    for k in range(22):
        recorder.event(Event("release", f"release section s{k} by hand", "Ann"))
    disk.room = 1e9
    recorder.close()
    text = page(read_file(tmp_path / "x.log"))
    assert "2 events were dropped, 2 of them releases by hand" in text and "counter 0 before, 22 after" in text
    again = Recorder(tmp_path / "x.log", ready)
    assert again.releases == 22
    again.close()


def test_what_was_kept_is_written_over_many_cycles(ready: Ready, tmp_path: Path, disk: Disk) -> None:
    """A hundred thousand lines in one cycle took it a second, and inputs were not valid for that."""
    recorder = Recorder(tmp_path / "x.log", ready)
    recorder.cycle(None)
    disk.room = 0
    for k in range(2500):
        recorder.event(Event("operation", f"{k}"))
    disk.room, lines = 1e9, [0]
    for k in range(4):
        later(recorder, disk, seconds=1.1 if k == 0 else 0.1)
        recorder.event(Event("operation", f"{2500 + k}"))
        lines.append(len(read_file(tmp_path / "x.log").events))
    assert all(b - a <= written.IN_A_CYCLE + 4 for a, b in pairwise(lines)), lines
    recorder.close()
    found = read_file(tmp_path / "x.log")
    assert [e["text"] for e in found.events if e["kind"] == "operation"] == [f"{k}" for k in range(2504)]
