"""The record of a panel's shift: restored, printed, played, gone on with, and what keeps it from being written."""

from __future__ import annotations

import errno
import html
import json
import os
import re
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from interlock.app.run import Ready
from interlock.cli.main import cli
from interlock.field.alone import InUse
from interlock.panel.desk import Desk
from interlock.panel.event import Event
from interlock.panel.journal import page, trace
from interlock.panel.recorder import Recorder
from interlock.record.log import Chain, Log, read_file
from tests.panels import in_cycles, kinds, panel


def test_blocks_and_reminders_are_restored_from_the_record_that_is_gone_on_with(ready: Ready, tmp_path: Path) -> None:
    path = tmp_path / "shift.log"
    with panel(ready, recorder=Recorder(path, ready)) as (_, browser), browser(name="Eva") as b:
        b.ask("block", section="s3", on=True)
        b.ask("block", section="s9", on=True)
        b.ask("remind", at="g:XB", text="lamp is being changed")
        b.ask("block", section="s9", on=False)
    for _ in range(2):  # the second time from a record in which it was restored
        with panel(ready, recorder=Recorder(path, ready)) as (_, browser), browser() as b:
            b.until(lambda: b.rest["reminders"].get("g:XB", [])[:2] == ["lamp is being changed", "Eva"])
            b.until(lambda: b.rest["sys"]["valid"] and b.state["s:s3"][3] == 1)
            assert b.state["s:s9"][3] == 0
            assert "section s3 is still blocked" in kinds(b.events, "note")
            b.released()
            b.ask("set", route="XB-XI7")
            b.until(lambda: kinds(b.events, "refusal"))
            assert ["section s3 is blocked", ["s:s3"]] in next(e["reasons"] for e in b.events if e["kind"] == "refusal")
    with panel(ready, recorder=Recorder(path, ready)) as (_, browser), browser() as b:
        b.ask("block", section="s3", on=False)
        b.ask("remind", at="g:XB", text="")
    with panel(ready, recorder=Recorder(path, ready)) as (_, browser), browser() as b:
        b.until(lambda: b.rest["sys"]["valid"])
        assert b.state["s:s3"][3] == 0 and not b.rest["reminders"]


def test_a_block_that_cannot_be_restored_is_an_alarm(ready: Ready, tmp_path: Path) -> None:
    """As where the record goes elsewhere from now on: nobody would look for the block of yesterday."""
    before, after = (tmp_path / f"heishan-20260101-0{n}0000.log" for n in (1, 2))
    with panel(ready, recorder=Recorder(before, ready)) as (_, browser), browser() as b:
        b.ask("block", section="s3", on=True)
    with panel(ready, recorder=Recorder(after, ready)) as (_, browser), browser() as b:
        told = "section s3 was blocked when heishan-20260101-010000.log ended, and is not blocked now: block it again"
        assert told in [a[1] for a in b.rest["alarms"]]
        assert b.state["s:s3"][3] == 0
    with Log.resume(after)[0] as log:
        log.add(0, "kept", blocks=["s99"], reminders={})
    with panel(ready, recorder=Recorder(after, ready)) as (_, browser), browser() as b:
        assert "the block of section s99 cannot be restored: there is no such section" in [
            a[1] for a in b.rest["alarms"]
        ]


def started(ready: Ready, folder: Path, day: int, *commands: dict[str, Any]) -> list[str]:
    """The alarms of a panel that begins a record of its own, after some commands."""
    desk = Desk(ready, None, 100, Recorder(folder / f"heishan-2026010{day}-060000.log", ready))
    before = [a.text for a in desk.operating.alarms.all.values()]
    in_cycles(desk, 10, {2: [("Ann", c) for c in commands]})
    return before


BLOCK: dict[str, Any] = {"do": "block", "section": "s6", "on": True}
WAS = "section s6 was blocked when heishan-20260101-060000.log ended, and is not blocked now: block it again"


@pytest.mark.parametrize("seen_to", [{"do": "acknowledge"}, BLOCK])
def test_a_block_is_told_at_every_start_until_somebody_has_seen_to_it(
    ready: Ready, tmp_path: Path, seen_to: dict[str, Any]
) -> None:
    """It was told at the first start after it, and forgotten at the second."""
    started(ready, tmp_path, 1, BLOCK)
    for day in (2, 3):
        assert started(ready, tmp_path, day) == [WAS]
    path = tmp_path / "heishan-20260103-060000.log"
    again = Desk(ready, None, 100, Recorder(path, ready))
    assert [a.text for a in again.operating.alarms.all.values()] == [WAS], "where that record goes on, too"
    in_cycles(again, 10, {2: [("Ann", seen_to)]})
    told = [] if seen_to["do"] == "acknowledge" else [WAS.replace("20260101", "20260103")]
    assert started(ready, tmp_path, 4) == told


@pytest.mark.parametrize("spoil", ["empty", "unreadable", "damaged", "cut"])
def test_a_record_that_says_too_little_hides_no_block(ready: Ready, tmp_path: Path, spoil: str) -> None:
    started(ready, tmp_path, 1, BLOCK)
    path = tmp_path / "heishan-20260102-060000.log"
    if spoil == "cut":  # by a crash, as any record may be
        started(ready, tmp_path, 2)
        path.write_bytes(path.read_bytes()[:-9])
        assert started(ready, tmp_path, 3) == [WAS]
        return
    if spoil == "damaged":
        started(ready, tmp_path, 2)
        path.write_bytes(
            path.read_bytes().replace(b"is locked", b"is opened").replace(b'"kind":"end"', b'"kind":"eve"')
        )
    elif spoil == "empty":
        path.touch()
    else:
        path.mkdir()
    why = f"{path.name} cannot be read to its end: what was blocked then is not known, and is not blocked now"
    for day in (3, 4):
        assert sorted(started(ready, tmp_path, day)) == sorted([WAS, why])


def test_a_damaged_record_says_what_it_can(ready: Ready, tmp_path: Path) -> None:
    started(ready, tmp_path, 1, BLOCK)
    path = tmp_path / "heishan-20260101-060000.log"
    path.write_bytes(path.read_bytes().replace(b'"kind":"end"', b'"kind":"eve"'))
    assert len(started(ready, tmp_path, 2)) == 2
    path.write_bytes(b"x" + path.read_bytes())
    (tmp_path / "heishan-20260102-060000.log").unlink()
    assert len(started(ready, tmp_path, 2)) == 1


def test_a_record_of_before_says_what_is_blocked_in_its_operations(ready: Ready, tmp_path: Path) -> None:
    path = tmp_path / "old.log"
    recorder = Recorder(path, ready)
    for text in ("block section s3", "block section s9", "free section s9"):
        recorder.event(Event("operation", text))
    recorder.close()
    again = Recorder(path, ready)
    assert again.standing.blocks == ("s3",)
    again.close()


def shift(ready: Ready, path: Path) -> None:
    """A short shift with a record: a route, a refusal, a release, an alarm."""
    recorder = Recorder(path, ready)
    with panel(ready, recorder=recorder) as (_, browser), browser(name="Dora") as b:
        b.ask("speed", times=10)
        b.released()
        b.ask("set", route="XB-XI7")
        b.until(lambda: b.state["g:XB"][0] == "clear")
        b.ask("set", route="XL1-XT3")
        b.until(lambda: kinds(b.events, "refusal"))
        b.ask("fail", kind="machine", name="P4", on=True)
        b.until(lambda: any(a[0] == "trailed P4" for a in b.rest["alarms"]) or b.state["m:P4"][0] == "")
        b.ask("cancel", signal="XB")
        b.until(lambda: not b.state["s:s2"][1])


def test_a_shift_is_recorded_printed_and_played(ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "shift.log"
    shift(ready, path)
    found = read_file(path)
    assert found.ended and found.problem is None
    text = page(found)
    assert "route XL1-XT3 is refused" in text and "section s3 is locked for route XB-XI7" in text
    assert "counter 0 before, 1 after" in text and "by Dora" in text and found.chain.digest in text
    states = json.loads(trace(found))["states"]
    proceed = [k for k, s in enumerate(states) if any(v is True and n.startswith("S_R") for n, v in s.items())]
    assert proceed and "route XB-XI7 is set" in " ".join(s["#meta"]["text"] for s in states[: proceed[0] + 1])
    assert not any(v is True and n.startswith("K_") for n, v in states[-1].items())
    for more, file in (([], "shift.html"), (["--journal", "-o", str(tmp_path / "page.html")], "page.html")):
        done = CliRunner().invoke(cli, ["play", str(path), *more])
        assert done.exit_code == 0 and (tmp_path / file).stat().st_size > 1000, done.output
    played = (tmp_path / "shift.html").read_text("utf-8")
    assert "reported occupied" in played and "a train</span>" not in played, "what is reported is no train yet"
    assert "the panel's record, 20" in html.unescape(played) and '<p class="mark"' not in played, "nothing is violated"
    assert all(len(s["#meta"]["text"].split("  ", 1)[1]) > 2 for s in states[:-1]), "every step says what it is"
    for more in (["--from", "tea"], ["--from", "2001-01-01", "--to", "2001-01-02"]):
        assert CliRunner().invoke(cli, ["play", str(path), *more, "-o", str(tmp_path / "x.html")]).exit_code == 1
    shift(ready, path)  # the same file: the count of releases goes on
    again = read_file(path)
    assert "counter 0 before, 2 after" in page(again) and len(again.events) > len(found.events)
    path.write_bytes(path.read_bytes().replace(b"Dora", b"Erna", 1))
    done = CliRunner().invoke(cli, ["play", str(path), "--journal", "-o", str(tmp_path / "x.html")])
    assert done.exit_code == 1 and "something was changed" in done.output
    with pytest.raises(ValueError, match="something was changed"):
        Recorder(path, ready)


def test_nothing_is_left_out_of_a_night_or_where_the_clock_is_set_back(
    ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def recorded(name: str, hours: list[float]) -> Path:
        """One event at each hour after midnight, and the end a minute after the last."""
        now = [datetime(2026, 3, 3).timestamp() + 3600 * hours[0]]
        monkeypatch.setattr("interlock.panel.recorder.time.time", lambda: now[0])
        recorder = Recorder(tmp_path / name, ready)
        for k, hour in enumerate(hours):
            now[0] = datetime(2026, 3, 3).timestamp() + 3600 * hour
            recorder.event(Event("note", f"event {k}"))
        now[0] += 60
        recorder.close()
        return tmp_path / name

    def played(log: Path, *more: str) -> tuple[int, str]:
        made = tmp_path / "page.html"
        done = CliRunner().invoke(cli, ["play", str(log), *more, "-o", str(made)])
        return done.exit_code, made.read_text("utf-8") if done.exit_code == 0 else done.output

    back = recorded("back.log", [8.0, 9.0, 7.0, 7.5])
    for more in ([], ["--journal"]):
        text = played(back, *more)[1]
        assert all(f"event {k}" in text for k in range(4)) and "was set back by 7200 s" in text
    night = recorded("night.log", [22.0, 23.5, 26.0, 29.0])
    text = played(night, "--journal", "--from", "23:00", "--to", "02:30")[1]
    assert [k for k in range(4) if f"event {k}" in text] == [1, 2] and "set back" not in text
    assert re.findall(r'class="day"><th colspan="3">(.*?)<', text) == ["2026-03-03", "2026-03-04"]
    assert text.index("2026-03-04</th>") > text.index("event 1") and text.index("2026-03-04</th>") < text.index(
        "event 2"
    )
    assert played(night, "--from", "23:40", "--to", "23:00") == (1, "error: --to 23:00 is before --from 23:40\n")


def test_a_record_of_something_else_is_not_gone_on_with(ready: Ready, tmp_path: Path) -> None:
    """What is recorded from now on would be told with the plan, and under the digest, of something else."""
    of_a_shift, of_before = tmp_path / "shift.log", tmp_path / "before.log"
    with Log.create(of_a_shift) as log:
        log.add(0, "begin", what="shift", layout="heishan")
    with pytest.raises(ValueError, match=r"shift\.log is no record of a panel: choose another file"):
        Recorder(of_a_shift, ready)
    assert ready.table is not None
    changed = replace(ready, table=replace(ready.table, layout_digest="another"))
    Recorder(of_before, changed).close()
    with pytest.raises(ValueError, match="heishan as it was before its layout was changed: choose another file"):
        Recorder(of_before, ready)
    assert len(read_file(of_a_shift).events) == 1 and len(read_file(of_before).events) == 2


def test_a_refusal_says_what_is_blocked_there(ready: Ready, tmp_path: Path) -> None:
    """Nothing else would: the record that takes its place knows of no block."""
    assert ready.table is not None
    changed = replace(ready, table=replace(ready.table, layout_digest="another"))
    path = tmp_path / "shift.log"
    before = Recorder(path, changed)
    before.event(Event("operation", "block section s3"))
    before.event(Event("operation", "block section s9"))
    before.close()
    told = r"choose another file; sections s3, s9 are blocked there: block them again"
    with pytest.raises(ValueError, match=told):
        Recorder(path, ready)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("shift.log", "heishan-20260101-020000.log"),
        ("heishan-20260101-010000.log", "shift.log"),
        ("monday.log", "tuesday.log"),
    ],
)
@pytest.mark.parametrize("changes", ["digest", "name", "nothing"])
def test_a_block_is_not_lost_with_the_file(ready: Ready, tmp_path: Path, old: str, new: str, changes: str) -> None:
    """Whatever the records are called, and though the layout was changed, or got another name."""
    assert ready.table is not None and ready.layout is not None
    was = ready
    if changes == "digest":
        was = replace(ready, table=replace(ready.table, layout_digest="another"))
    elif changes == "name":
        was = replace(ready, layout=replace(ready.layout, name="heishan_east"))
    for name, sections in (("aa.log", ["s9"]), (old, ["s3"])):
        recorder = Recorder(tmp_path / name, was)
        for s in sections:
            recorder.event(Event("operation", f"block section {s}"))
        recorder.close()
    (tmp_path / "zz.log").write_text("of something else\n", "utf-8")
    (tmp_path / "empty.log").touch()
    recorder = Recorder(tmp_path / new, ready)
    recorder.close()
    assert recorder.left_behind == (("s3", old),)


def test_two_panels_do_not_write_one_record(ready: Ready, tmp_path: Path) -> None:
    """Their events would be between each other's, and the digests of neither would hold."""
    path = tmp_path / "one.log"
    path.touch()  # it may be there, and empty
    recorder = Recorder(path, ready)
    with pytest.raises(InUse, match="two may not write the same record"):
        Recorder(path, ready)
    more = ["--panel", "--port", "0", "--record", str(path)]
    done = CliRunner().invoke(cli, ["run", ready.proved.checked.path, *more])
    assert done.exit_code == 2 and "two may not write the same record" in done.output, done.output
    recorder.close()
    Recorder(path, ready).close()
    assert read_file(path).ended


def test_a_record_that_is_moved_away_is_an_alarm_and_begins_anew(
    ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What goes to a file that nobody can find any more is lost; the new one can be printed and played."""
    now = [100.0]
    monkeypatch.setattr("interlock.panel.recorder.time.monotonic", lambda: now[0])
    recorder = Recorder(tmp_path / "shift.log", ready)
    recorder.cycle(None)
    (tmp_path / "shift.log").rename(tmp_path / "old.log")
    now[0] += 2
    recorder.cycle(None)
    assert "shift.log was moved away or removed" in recorder.lost
    recorder.event(Event("note", "seen meanwhile"))
    now[0] += 2
    recorder.cycle(None)
    recorder.close()
    assert recorder.lost == "" and not read_file(tmp_path / "old.log").ended
    found = read_file(tmp_path / "shift.log")
    assert [e["kind"] for e in found.events] == ["begin", "picture", "gap", "note", "end"]
    assert "seen meanwhile" in page(found) and "set back" not in page(found)
    assert json.loads(trace(found))["states"]


def test_where_nothing_can_be_written_the_panel_works_on_and_nothing_is_lost(
    ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    recorder = Recorder(tmp_path / "full.log", ready)
    write, full = os.write, [False]

    def writes(handle: int, data: bytes) -> int:
        if full[0] and b'"kind"' in data:
            write(handle, data[:9])  # a part of it finds room
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return write(handle, data)

    monkeypatch.setattr("interlock.record.log.os.write", writes)
    with panel(ready, recorder=recorder) as (_, browser), browser(name="Fay") as b:
        b.ask("speed", times=10)
        b.released()
        full[0] = True
        b.ask("block", section="s3", on=True)
        b.until(lambda: any(a[0] == "record" for a in b.rest["alarms"]))
        b.ask("block", section="s3", on=False)
        full[0] = False
        b.until(lambda: any(a[0] == "record" and not a[4] for a in b.rest["alarms"]))
    found = read_file(tmp_path / "full.log")
    told = [e.get("text", "") for e in found.events]
    assert found.ended and "block section s3" in told and "free section s3" in told
    assert [e["dropped"] for e in found.events if e["kind"] == "gap"] == [0]


FORGED = [
    (0, {"title": 1}, "`title`"),
    (0, {"program": None}, "`program`"),
    (0, {"digest": []}, "`digest`"),
    (0, {"views": []}, "`views`"),
    (1, {"on": 3}, "`on`"),
    (1, {"on": [["a"]]}, "`on`"),
    (1, {"off": None}, "`off`"),
    (1, {"whole": "yes"}, "`whole`"),
    (2, {"reasons": 7}, "`reasons`"),
    (2, {"reasons": [["a"]]}, "`reasons`"),
    (2, {"reasons": [[1, []]]}, "`reasons`"),
    (2, {"rules": 1}, "`rules`"),
    (2, {"text": 1}, "`text`"),
    (2, {"who": []}, "`who`"),
]


@pytest.mark.parametrize(("event", "fields", "told"), FORGED, ids=lambda x: str(x)[:30])
@pytest.mark.parametrize("more", [[], ["--journal"]], ids=["played", "printed"])
def test_a_forged_record_is_told_with_its_line(
    tmp_path: Path, event: int, fields: dict[str, object], told: str, more: list[str]
) -> None:
    """Whoever can compute digests can write one; that ended in an internal error."""
    path, chain, lines = tmp_path / "forged.log", Chain(), list[bytes]()
    events: list[tuple[str, dict[str, object]]] = [
        ("begin", {"title": "a", "program": "b", "digest": "c", "plan": "<svg></svg>", "views": {"x": ["a", "b"]}}),
        ("picture", {"on": ["x"], "off": [], "whole": True}),
        ("refusal", {"text": "no", "who": "Dora", "reasons": [["it is locked", []]], "rules": ["R3"]}),
    ]
    events[event][1].update(fields)
    lines += [chain.line(1000, kind, x) for kind, x in events]
    path.write_bytes(b"".join(lines))
    done = CliRunner().invoke(cli, ["play", str(path), *more])
    assert done.exit_code == 1 and f"line {event + 1}: {told} is missing, or not as a panel writes it" in done.output
