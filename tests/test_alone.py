"""Two controllers on one computer never hold the same outputs, whatever their addresses are called."""

from __future__ import annotations

import os
import secrets
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from interlock.cli.main import cli
from interlock.field import alone
from interlock.field.alone import LOOK_S, Alone, InUse, hold, hold_file
from interlock.field.plc import LinkLost
from interlock.record.log import Log
from tests.test_links import STATION

ALIASES = {"plc-west": ["10.7.0.1", "10.7.0.2"], "west": ["10.7.0.2"], "localhost": ["127.0.0.1", "::1"]}


@pytest.fixture
def port(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """A port that nobody else tries, and names for some addresses."""

    def looked_up(host: str, *args: Any, **more: Any) -> list[tuple[Any, ...]]:
        if host == "hangs":
            time.sleep(5)
        if host not in ALIASES and not host.replace(".", "").isdecimal() and ":" not in host:
            raise OSError("no such name")
        return [(2, 1, 6, "", (a, 0)) for a in ALIASES.get(host, [host])]

    monkeypatch.setattr("interlock.field.alone.socket.getaddrinfo", looked_up)
    yield 20000 + secrets.randbelow(40000)


@pytest.mark.parametrize(
    ("first", "second", "free"),
    [
        ("127.0.0.1:{}/1", "localhost:{}/1", False),
        ("127.0.0.1:{}/1", "127.0.0.1:0{}/1", False),
        ("127.0.0.1:{}/1", "127.0.0.1:{}", False),
        ("127.0.0.1:{}/1", "127.0.0.1:{}/01", False),
        ("localhost:{}", "[::1]:{}", False),
        ("127.0.0.1:{}", "::ffff:127.0.0.1:{}", False),
        ("127.0.0.1:{}", "0.0.0.0:{}", False),
        ("west:{}", "plc-west:{}", False),
        ("10.7.0.1:{}", "PLC-west.:{}", False),
        ("not-known:{}", "NOT-known:{}", False),
        ("west:{}", "10.7.0.1:{}", True),
        ("west:{}/1", "west:{}/2", True),
        ("west:{}", "west:1{}", True),
    ],
)
def test_a_place_is_one_place_however_it_is_written(first: str, second: str, free: bool, port: int) -> None:
    held = hold([first.format(port)])
    try:
        if free:
            held += hold([second.format(port)])
        else:
            with pytest.raises(InUse, match="is held by another interlock on this computer"):
                hold([second.format(port)])
    finally:
        for one in held:
            one.close()
    for one in hold([second.format(port)]):
        one.close()


def test_a_name_that_leads_nowhere_for_once_is_still_that_name(port: int, monkeypatch: pytest.MonkeyPatch) -> None:
    held = hold([f"west:{port}"])
    monkeypatch.setitem(ALIASES, "west", ["10.7.0.9"])
    with pytest.raises(InUse):
        hold([f"west:{port}"])
    for one in held:
        one.close()


def test_a_name_is_looked_up_for_a_limited_time(port: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(alone, "LOOKUP_S", 0.2)
    began = time.monotonic()
    for one in hold([f"hangs:{port}", f"west:{port}"]):
        one.close()
    assert time.monotonic() - began < 3


def test_two_substations_at_one_place_are_told_as_that(port: int, tmp_path: Path) -> None:
    with pytest.raises(InUse, match=f"west:{port}/1 and plc-west:{port} are one place"):
        hold([f"west:{port}/1", f"plc-west:{port}"])
    more = [f"east=west:{port}", "--modbus", f"west=10.7.0.2:{port}"]
    (tmp_path / "two.yaml").write_text(STATION + "substations: {east: [q1], west: []}\n", "utf-8")
    done = CliRunner().invoke(cli, ["run", str(tmp_path / "two.yaml"), "--modbus", *more])
    assert done.exit_code == 2 and "are one place" in done.output, done.output


def other(place: str, **environment: str) -> str:
    """What another process is told that would hold a place."""
    code = "import sys; from interlock.field.alone import *\ntry: hold([sys.argv[1]]); print('held')\n"
    code += "except InUse as error: print(error)"
    command = [sys.executable, "-c", code, place]
    return subprocess.run(command, capture_output=True, text=True, env={**os.environ, **environment}).stdout.strip()


def test_another_folder_for_files_that_pass_changes_nothing(port: int, tmp_path: Path) -> None:
    held = hold([f"127.0.0.1:{port}"])
    assert "is held by another interlock" in other(f"127.0.0.1:{port}/1", TMPDIR=str(tmp_path))
    held[0].close()
    assert other(f"127.0.0.1:{port}/1", TMPDIR=str(tmp_path)) == "held" and not list(tmp_path.iterdir())


def test_a_file_is_for_every_user(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(alone, "FOLDER", tmp_path)
    before = os.umask(0o077)
    try:
        held = hold_file(tmp_path / "one.log")
    finally:
        os.umask(before)
    (path,) = tmp_path.glob("*.lock")
    assert path.stat().st_mode & 0o777 == 0o666
    with pytest.raises(InUse, match="two may not write the same record"):
        hold_file(tmp_path / "one.log")
    held[0].close()
    lock = alone._lock

    def swept(file: Any) -> bool:
        monkeypatch.setattr(alone, "_lock", lock)
        path.unlink()  # between the opening and the lock
        return lock(file)

    monkeypatch.setattr(alone, "_lock", swept)
    held = hold_file(tmp_path / "one.log")
    with pytest.raises(InUse):
        hold_file(tmp_path / "one.log")
    held[0].close()


@pytest.mark.parametrize("mode", [0o666, 0o644])
def test_a_second_user_is_told_that_it_is_held_and_has_it_afterwards(
    mode: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file that can only be read is enough: one was made so by an earlier version.  Whoever may not become somebody
    else is the second user himself, in another process."""
    folder = Path("/tmp") / f"interlock-test-{secrets.token_hex(4)}"
    folder.mkdir(0o1777)
    folder.chmod(0o1777)
    monkeypatch.setattr(alone, "FOLDER", folder)
    try:
        held = hold_file(folder / "x.log")
        (path,) = folder.glob("*.lock")
        path.chmod(mode)
        assert "is held by another interlock" in as_nobody(folder)
        held[0].close()
        assert as_nobody(folder) == "held"
        path.chmod(0o600 if os.geteuid() == 0 else 0)
        said = as_nobody(folder)
        assert "it cannot be seen whether another interlock holds" in said and "Permission denied; remove" in said
    finally:
        for path in folder.iterdir():
            path.unlink()
        folder.rmdir()


def as_nobody(folder: Path) -> str:
    """What another user is told."""
    code = (
        "import fcntl, os, pathlib, sys; from interlock.field import alone\nalone.FOLDER = pathlib.Path(sys.argv[1])\n"
    )
    code += "if os.geteuid() == 0: os.setgid(65534); os.setuid(65534)\n"
    code += "try: alone.hold_file(alone.FOLDER / 'x.log'); print('held')\nexcept alone.InUse as error: print(error)"
    return subprocess.run([sys.executable, "-c", code, str(folder)], capture_output=True, text=True).stdout.strip()


def test_a_link_in_its_place_is_not_followed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(alone, "FOLDER", tmp_path)
    for one in hold_file(tmp_path / "one.log"):
        one.close()
    (path,) = tmp_path.glob("*.lock")
    path.unlink()
    path.symlink_to(tmp_path / "elsewhere")
    with pytest.raises(InUse, match="it cannot be seen whether"):
        hold_file(tmp_path / "one.log")
    assert not (tmp_path / "elsewhere").exists()


def test_a_file_that_is_there_is_not_opened_as_if_it_were_to_be_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Linux refuses that in a folder for all where the file is another user's (fs.protected_regular)."""
    monkeypatch.setattr(alone, "FOLDER", tmp_path)
    hold_file(tmp_path / "one.log")[0].close()
    opened: list[int] = []
    system = os.open

    def told(path: Any, flags: int, *more: Any) -> int:
        opened.append(flags)
        return system(path, flags, *more)

    monkeypatch.setattr(os, "open", told)
    hold_file(tmp_path / "one.log")[0].close()
    assert opened and not any(flags & os.O_CREAT for flags in opened)


def test_many_at_once_one_gets_it(port: int) -> None:
    got: list[Any] = []

    def one() -> None:
        with suppress(InUse):
            got.append(hold([f"west:{port}"]))

    threads = [threading.Thread(target=one) for _ in range(8)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert len(got) == 1
    for file in got[0]:
        file.close()


class Outputs:
    """A substation that counts what is written."""

    written = 0

    def read(self) -> dict[str, int]:
        return {}

    def write(self, values: Any, heartbeat: bool) -> None:
        self.written += 1

    def close(self) -> None:
        pass


@pytest.mark.parametrize("second", ["none", "runs", "has ended"])
def test_where_the_lock_is_swept_away_one_controller_writes(
    port: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, second: str
) -> None:
    """A second one started, and both wrote the same outputs until somebody ended one."""
    monkeypatch.setattr(alone, "FOLDER", tmp_path)
    now, link = [0.0], Outputs()
    held = hold([f"10.7.0.1:{port}"])
    first = Alone(link, held, lambda: now[0])
    first.write({}, True)
    for path in tmp_path.glob("*.lock"):
        path.unlink()
    other = [] if second == "none" else hold([f"10.7.0.1:{port}"])
    if second == "has ended":
        for lock in other:
            lock.close()
    now[0] += 2 * LOOK_S
    for _ in range(3):
        if second == "none":
            first.write({}, True)
            assert first.read() == {}
        else:
            with pytest.raises(LinkLost, match="another interlock on this computer writes the same outputs"):
                first.write({}, True)
    assert link.written == (4 if second == "none" else 1)
    if second == "none":
        with pytest.raises(InUse):
            hold([f"10.7.0.1:{port}"])
    for lock in (*held, *other):
        lock.close()


def test_one_file_of_two_names_has_one_writer(tmp_path: Path) -> None:
    """The events of two panels stood between each other's, and neither record could be read."""
    path, name = tmp_path / "a.log", tmp_path / "b.log"
    with Log.create(path) as log:
        log.add(1, "begin")
        name.hardlink_to(path)
        with pytest.raises(OSError, match="another program writes it"):
            Log.resume(name)
    Log.resume(name)[0].close()
