"""The event log: what is lost by a kill, what damage is told, and what can be asked of it."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
from pathlib import Path
from random import Random

import pytest
from click.testing import CliRunner

from interlock.cli.main import cli
from interlock.cli.record import command
from interlock.record import Chain, Log, LogExists, read, read_file
from interlock.record.log import link
from interlock.record.tables import BadQuery, query, write_parquet
from tests.campaigns.record import MOMENTS, killed


def made(count: int) -> list[bytes]:
    """So many lines."""
    chain = Chain()
    return [chain.line(10 * k, "section", {"section": f"s{k}", "occupied": k % 2}) for k in range(count)]


def test_events_are_read_as_they_were_written(tmp_path: Path) -> None:
    file = tmp_path / "a.log"
    with Log.create(file, sync=True) as log:
        log.add(0, "begin", layout="矿", most=3)
        log.add(250, "end")
    found = read_file(file)
    assert found.ended and found.problem is None and found.torn == 0
    assert [e["kind"] for e in found.events] == ["begin", "end"] and found.events[0]["layout"] == "矿"
    assert found.chain.digest == json.loads(file.read_text("utf-8").splitlines()[-1])["chain"]
    with pytest.raises(LogExists):
        Log.create(file)
    with pytest.raises(ValueError, match="not called n, t, kind or chain"):
        Chain().line(0, "x", {"n": 1})


def test_a_log_that_ends_anywhere_gives_all_whole_events() -> None:
    data = b"".join(made(4))
    whole = [len(b"".join(made(k))) for k in range(5)]
    for cut in range(len(data) + 1):
        found = read(data[:cut])
        events = sum(w <= cut for w in whole) - 1
        assert found.problem is None and len(found.events) == events and found.torn == cut - whole[events]


def test_a_log_that_was_killed_goes_on(tmp_path: Path) -> None:
    file = tmp_path / "a.log"
    file.write_bytes(b"".join(made(3)) + b'{"n":3,"t":3')
    log, found = Log.resume(file)
    with log:
        assert len(found.events) == 3 and found.torn == 12
        log.add(99, "end")
    assert read_file(file).ended and len(read_file(file).events) == 4


@pytest.mark.parametrize("before", [0, 2])
def test_what_is_no_beginning_of_an_event_is_not_cut_away(tmp_path: Path, before: int) -> None:
    """A file that somebody named by mistake was emptied; zeros are what a power cut leaves."""
    file = tmp_path / "notes.txt"
    for rest in (b"remember: look at P3", b'{"n":7,"t":3'):
        file.write_bytes(b"".join(made(before)) + rest)
        with pytest.raises(ValueError, match=f"notes.txt:{before + 1}: this is no event of a log"):
            Log.resume(file)
        assert file.read_bytes().endswith(rest)
    file.write_bytes(b"".join(made(before)) + b'{"n":%d,"t' % before + bytes(9))
    log, found = Log.resume(file)
    log.close()
    assert found.torn == 18 and len(read_file(file).events) == before


def test_a_log_goes_on_where_there_was_no_room_without_being_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file, write, full = tmp_path / "a.log", os.write, [False]

    def writes(handle: int, data: bytes) -> int:
        if full[0]:
            write(handle, data[:7])  # a part of it finds room
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return write(handle, data)

    monkeypatch.setattr("interlock.record.log.os.write", writes)
    with Log.create(file) as log:
        for k in range(3):
            log.add(k, "event", k=k)
        full[0] = True
        for _ in range(2):
            with pytest.raises(OSError, match="No space"):
                log.add(9, "event", k=9)
        full[0] = False
    monkeypatch.setattr("interlock.record.log.read", lambda data: pytest.fail("the log was read"))
    with Log.again(file, log) as again:
        again.add(4, "end")
    monkeypatch.undo()
    assert read_file(file).ended and [e.get("k") for e in read_file(file).events] == [0, 1, 2, None]
    file.write_bytes(b"".join(made(3)))
    with pytest.raises(ValueError, match="is not the log that was written until then"):
        Log.again(file, log)


@pytest.mark.parametrize("seed", range(200))
def test_any_other_change_is_told_with_its_line(seed: int) -> None:
    rng, lines = Random(seed), made(8)
    k = rng.randrange(7)
    kind = seed % 5
    if kind == 0:  # cut out in the middle
        del lines[k]
    elif kind == 1:
        lines.insert(k + 1, lines[k])
    elif kind == 2:
        lines[k], lines[k + 1] = lines[k + 1], lines[k]
    elif kind == 3:  # one bit turned
        at = rng.randrange(len(lines[k]) - 1)
        lines[k] = lines[k][:at] + bytes([lines[k][at] ^ 1 << rng.randrange(8)]) + lines[k][at + 1 :]
    else:  # the half of a line in the middle
        lines[k] = lines[k][: rng.randrange(1, len(lines[k]))]
    found = read(b"".join(lines))
    assert found.problem is not None and found.problem.line <= k + 2
    assert [e["n"] for e in found.events] == list(range(len(found.events))), "what is told before it holds"
    assert not found.ended


@pytest.mark.parametrize(
    "body",
    [
        '{"n":1,"t":1,"kind":"x","a":' + "[" * 5000 + "]" * 5000,
        '{"n":1,"t":1,"kind":"x","a":' + "[" * 500 + "]" * 500,
        '{"n":1,"t":1,"kind":"x","a":' + "9" * 5000,
        '{"n":1,"t":"1","kind":"x"',
        '{"n":1,"t":1.5,"kind":"x"',
        '{"n":1,"t":true,"kind":"x"',
        '{"n":1,"t":-1,"kind":"x"',
        '{"n":1,"t":99999999999999999,"kind":"x"',
        '{"n":1,"t":1,"kind":["x"]',
        '{"n":true,"t":1,"kind":"x"',
    ],
    ids=lambda x: x[:40],
)
def test_an_event_of_another_kind_is_told_with_its_line(tmp_path: Path, body: str) -> None:
    """Whoever can compute digests can write one; no command ends in an internal error for it."""
    first, file = made(1)[0], tmp_path / "a.log"
    digest = read(first).chain.digest
    chain = link(digest, body.encode())
    file.write_bytes(first + body.encode() + f',"chain":"{chain}"}}\n'.encode())
    found = read_file(file)
    assert found.problem is not None and found.problem.line == 2 and len(found.events) == 1
    for verb in ("record", "play"):
        done = CliRunner().invoke(cli, [verb, str(file)])
        assert done.exit_code == 1 and f"{file}:2" in " ".join(done.output.split()), done.output


def test_what_an_event_holds_may_be_nested_as_far_as_is_needed() -> None:
    chain, log = Chain(), b""
    for k in range(3):
        log += chain.line(k, "x", {"a": [{"b": [[c, [c]] for c in range(100)]}]})
    assert read(log).problem is None and len(read(log).events) == 3


def test_a_damaged_log_is_not_gone_on_with(tmp_path: Path) -> None:
    file = tmp_path / "a.log"
    file.write_bytes(b"".join(made(4)[1:]))
    with pytest.raises(ValueError, match=r"a\.log:1: this event does not follow"):
        Log.resume(file)


def test_a_killed_writer_loses_nothing_that_it_had_said(tmp_path: Path) -> None:
    rng = Random(1)
    for k in range(3):
        lost, torn = killed(tmp_path / f"{k}.log", rng.random() * MOMENTS)
        assert lost == 0 and torn >= 0


def test_parquet_and_questions(tmp_path: Path) -> None:
    logs = {"one": read(b"".join(made(9))).events, "two": read(b"".join(made(4))).events}
    names, rows = query("SELECT log, count(*) AS n FROM events WHERE occupied = 1 GROUP BY log ORDER BY log", logs)
    assert (names, rows) == (["log", "n"], [("one", 4), ("two", 2)])
    file = tmp_path / "a.parquet"
    assert write_parquet(file, logs) == 13
    with pytest.raises(BadQuery):
        query("SELECT nothing FROM events", logs)
    for empty in ("", " ", ";", "-- kind"):
        with pytest.raises(BadQuery, match="there is no query"):
            query(empty, logs)
    with pytest.raises(BadQuery, match="disabled"):
        query(f"SELECT * FROM '{file}'", logs)
    import duckdb

    assert duckdb.sql(f"SELECT max(t), count(DISTINCT log) FROM '{file}'").fetchall() == [(80, 2)]
    odd = [{"n": 0, "t": 0, "kind": "a", "x": 1}, {"n": 1, "t": 1, "kind": "b", "x": "two", "y": [1], "z": 0.5}]
    assert query("SELECT x, y, z FROM events ORDER BY n", {"odd": odd})[1] == [("1", None, None), ("two", "[1]", 0.5)]


def test_a_field_called_log_and_numbers_of_any_length_have_their_columns(tmp_path: Path) -> None:
    odd = [{"n": 0, "t": 0, "kind": "a", "log": "x", "v": 10**30}, {"n": 1, "t": 1, "kind": "a", "v": 2, "w": 1 << 62}]
    found = query("SELECT log, log_, v, w FROM events ORDER BY n", {"odd": odd})[1]
    assert found == [("odd", "x", str(10**30), None), ("odd", None, "2", 1 << 62)]
    assert write_parquet(tmp_path / "a.parquet", {"odd": odd}) == 2


def test_writing_needs_nothing_but_python() -> None:
    code = "import sys, interlock.record.log; sys.exit(any(m in sys.modules for m in ('pyarrow', 'duckdb')))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def run(*arguments: str) -> tuple[int, str]:
    done = CliRunner().invoke(command, arguments, catch_exceptions=False)
    return done.exit_code, done.output


def test_the_command_checks_asks_and_writes(tmp_path: Path) -> None:
    file, target = tmp_path / "a.log", tmp_path / "a.parquet"
    file.write_bytes(b"".join(made(5)) + b'{"n":')
    code, text = run(str(file))
    assert code == 0 and "5 events, whole up to its last event, at 0.0 s; it has no end; 5 bytes" in text
    code, text = run(str(file), "--sql", "SELECT n, section FROM events WHERE occupied = 1")
    assert (code, text.splitlines()) == (0, ["n\tsection", "1\ts1", "3\ts3"])
    code, text = run(str(file), "--sql", "SELECT 1.5::DECIMAL AS x", "--format", "json")
    assert code == 0 and json.loads(text)["columns"] == ["x"]
    code, text = run(str(file), "--sql", "SELEKT")
    assert code == 1 and "syntax error" in text.lower() and "Traceback" not in text
    assert run(str(file), "--parquet", str(target)) == (0, f"{target}: 5 events\n")
    target.write_text("mine")
    assert run(str(file), "--parquet", str(target))[0] == 1 and target.read_text() == "mine"
    assert json.loads(run(str(file), "--format", "json")[1])["logs"][0]["torn_bytes"] == 5


def test_a_log_cut_in_the_middle_is_told_with_code_and_place(tmp_path: Path) -> None:
    file = tmp_path / "a.log"
    file.write_bytes(b"".join(made(9)[:3] + made(9)[4:]))
    code, text = run(str(file))
    assert code == 1 and "error[IL6011]" in text and f"{file}:4: this event does not follow" in text
    assert "the 3 events before it hold" in text
    for k, said in ((0, "no event comes before it"), (1, "the event before it holds")):
        file.write_bytes(b"".join(made(9)[:k]) + b"none\n")
        assert said in run(str(file))[1]
    assert run(str(tmp_path / "none.log"))[0] == 1


def test_a_log_without_events_or_with_other_line_ends_is_told(tmp_path: Path) -> None:
    file = tmp_path / "shift.log"
    file.write_bytes(b"")
    code, text = run(str(file))
    assert code == 1 and "error[IL6011]" in text and "there is no whole event in it" in text
    log = Log.create(tmp_path / "own.log")
    log.add(0, "begin")
    log.add(5, "end")
    file.write_bytes((tmp_path / "own.log").read_bytes().replace(b"\n", b"\r\n"))
    code, text = run(str(file))
    assert code == 1 and f"{file}:1: its lines end with CR LF" in text
