"""Times in a panel's record: summer time, a clock that is put forward or has lost the time, sessions that broke off,
and another version of the program that goes on."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from interlock.app.run import Ready
from interlock.panel import recorder as recorder_module
from interlock.panel.event import Event
from interlock.panel.journal import NotAPanels, page, trace
from interlock.panel.recorder import Recorder
from interlock.record.log import Chain, Recorded, read, read_file

Recording = Callable[[str, Sequence[str]], Recorded]


@pytest.fixture(autouse=True)
def _berlin(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("TZ", "Europe/Berlin")
    time.tzset()
    yield
    monkeypatch.undo()
    time.tzset()


@pytest.fixture
def recorded(ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Recording:
    """A record of an event at each of some times (UTC), called by its number; time passes as the clock says."""

    def made(name: str, times: Sequence[str], real: Sequence[float] = ()) -> Recorded:
        moments = [datetime.fromisoformat(t).replace(tzinfo=UTC).timestamp() for t in times]
        now = [moments[0], 0.0]
        monkeypatch.setattr("interlock.panel.recorder.time.time", lambda: now[0])
        monkeypatch.setattr("interlock.panel.recorder.since_boot", lambda: now[1])
        recorder = Recorder(tmp_path / f"{name}.log", ready)
        for k, t in enumerate(moments):
            now[:] = t, real[k] if real else t - moments[0]
            recorder.event(Event("note", f"event {k}"))
        recorder.close()
        monkeypatch.undo()
        monkeypatch.setenv("TZ", "Europe/Berlin")
        return read_file(tmp_path / f"{name}.log")

    return made


SPRING = ("2026-03-28T23:30", "2026-03-29T04:12", "2026-03-29T05:12")
AUTUMN = ("2026-10-24T22:30", "2026-10-25T00:30", "2026-10-25T01:10", "2026-10-25T01:30", "2026-10-25T06:12")


@pytest.mark.parametrize(
    ("times", "first", "last", "within"),
    [
        (("2026-05-01T02:00", "2026-05-01T21:00", "2026-05-02T01:00", "2026-05-02T06:00"), "22:00", "05:00", [1, 2]),
        (("2028-02-28T20:00", "2028-02-29T05:12"), "06:10", "06:15", [1]),
        (("2028-02-28T20:00", "2028-02-29T05:12"), "20:00", "20:30", []),
        (("2028-02-28T20:00", "2028-02-29T05:12"), "", "06:15", [0, 1]),
        (SPRING, "06:10", "06:15", [1]),
        (SPRING, "07:10", "07:15", [2]),
        (SPRING, "02:10", "06:15", [1]),
        (AUTUMN, "07:10", "07:15", [4]),
        (AUTUMN, "02:25", "02:35", [1, 2, 3]),
        (AUTUMN, "2026-10-25T02:25", "2026-10-25T02:35", [1, 2, 3]),
        (AUTUMN, "2026-10-25T02:25+01:00", "2026-10-25T02:35+01:00", [3]),
    ],
)
def test_a_time_is_what_the_clock_shows_then(
    recorded: Recording, times: Sequence[str], first: str, last: str, within: list[int]
) -> None:
    """Of a night in which summer time begins or ends, all after it was an hour off; what the clock shows twice is
    both."""
    text = page(recorded("x", times), first, last)
    assert [k for k in range(len(times)) if f"event {k}" in text] == within


def test_times_have_their_zone(recorded: Recording) -> None:
    text = page(recorded("autumn", AUTUMN))
    assert "2026-10-25 00:30:00 +02:00 to 2026-10-25 07:12:00 +01:00" in text
    assert "02:30:00 +02:00" in text and "02:10:00 +01:00" in text
    may = recorded("may", ("2026-05-01T06:00", "2026-05-01T07:00"))
    assert "2026-05-01 08:00:00 +02:00 to" in page(may) and ">08:00:00<" in page(may)
    assert "08:00:00 +02:00 to 2026-05-01 09:00:00 +02:00" in json.loads(trace(may))["#meta"]["title"]


def test_a_clock_that_is_put_forward_is_told_and_one_that_passes_is_not(recorded: Recording) -> None:
    times = ("2026-05-01T06:00", "2026-05-01T06:01", "2026-05-01T09:01", "2026-05-01T09:02")
    assert "was put forward by 10800 s" in page(recorded("jump", times, (0.0, 60.0, 60.5, 120.0)))
    assert "put forward" not in page(recorded("quiet", times))


def test_a_clock_that_has_lost_the_time_can_be_recorded(recorded: Recording) -> None:
    found = recorded("x", ("1969-12-31T20:00", "2028-02-29T05:12"))
    assert found.problem is None and found.events[0]["t"] == 0
    assert "event 0" in page(found) and "event 1" in page(found)


def test_a_session_that_broke_off_is_told_where_the_next_one_goes_on(ready: Ready, tmp_path: Path) -> None:
    """A record that was cut, and gone on with, was told as whole."""
    path = tmp_path / "x.log"
    first = Recorder(path, ready)
    first.event(Event("operation", "release section s6 by hand", "Bob"))
    first._written._log.close()  # type: ignore[union-attr]  # killed
    first._let_go()
    path.write_bytes(path.read_bytes()[:-50])
    torn = len(path.read_bytes()) - path.read_bytes().rindex(b"\n") - 1
    Recorder(path, ready).close()
    Recorder(path, ready).close()
    told = [e["text"] for e in read_file(path).events if e["kind"] == "note"]
    assert len(told) == 1 and told[0].startswith("the session before did not come to its end: its last event is of 20")
    assert told[0].endswith(f"; {torn} bytes of another were torn off")
    assert "3 sessions, 1 of them broken off without an end" in page(read_file(path))


def test_another_version_goes_on_with_no_record_whose_variables_it_calls_otherwise(
    ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    Recorder(tmp_path / "x.log", ready).close()
    before = (tmp_path / "x.log").read_bytes()
    views = recorder_module.views(ready)
    monkeypatch.setattr(recorder_module, "views", lambda ready: {f"V2_{k}": v for k, v in views.items()})
    with pytest.raises(ValueError, match=r"by interlock .*, which calls what it shows otherwise: choose another file"):
        Recorder(tmp_path / "x.log", ready)
    assert (tmp_path / "x.log").read_bytes() == before


def test_a_record_of_two_versions_is_played_as_each_calls_it() -> None:
    """What the second one wrote was shown by the names of the first: nothing was occupied any more."""
    chain, lines = Chain(), list[bytes]()

    def add(t: int, kind: str, **fields: Any) -> None:
        lines.append(chain.line(t, kind, fields))

    head: dict[str, Any] = {"title": "a", "digest": "c", "plan": "<svg></svg>"}
    for k, name in enumerate(("old", "new")):
        add(60_000 * k, "begin", **head, program=f"interlock 0.{k}", views={name: [["section", "s1", "occupied"]]})
        add(60_000 * k + 1000, "picture", on=[name], off=[], whole=True)
        add(60_000 * k + 9000, "note", text="seen")
        add(60_000 * k + 9001, "end")
    found = read(b"".join(lines))
    with pytest.raises(NotAPanels, match="another version of the program writes it"):
        trace(found)
    for first, last, name in (("01:00:00", "01:00:30", "old"), ("01:01:00", "01:01:30", "new")):
        played = json.loads(trace(found, first, last))
        assert played["vars"] == [name] and all(s[name] for s in played["states"][1:])
    assert "interlock 0.0, interlock 0.1" in page(found)
