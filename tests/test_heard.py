"""What a run says holds up nobody: not a terminal that was stopped, not a pipe that nobody reads, not a full disk."""

from __future__ import annotations

import errno
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from typing import Any

import pytest

from interlock.cli import heard
from interlock.cli.heard import Heard
from interlock.cli.run import _text


def said(event: dict[str, Any]) -> str:
    return str(event)


def until(so: Any) -> None:
    end = time.monotonic() + 10
    while not so():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_a_run_whose_output_finds_no_room_goes_on(capsys: pytest.CaptureFixture[str]) -> None:
    written, tries, full = list[str](), list[str](), [True]

    def write(text: str) -> None:
        tries.append(text)
        if full[0]:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        written.append(text)

    say = Heard(said, write)
    for k in range(3):
        say({"output": k})
    until(lambda: len(tries) == 3)
    full[0] = False
    assert say.close({"output": 3})
    assert written == ["{'output': 3}"]
    assert capsys.readouterr().err == "what happens cannot be written: No space left on device; the run goes on\n"


def test_what_is_not_read_is_dropped_and_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """The cycles stood still, the signal at proceed over an occupied section, for as long as nobody read."""
    monkeypatch.setattr(heard, "MOST", 10)
    written, reads = list[str](), threading.Event()

    def write(text: str) -> None:
        assert reads.wait(20)
        written.append(text)

    say = Heard(_text, write)
    say({"voyage": "first"})
    until(lambda: not say._waiting.qsize())
    for k in range(25):
        say({"voyage": str(k)})
    reads.set()
    until(lambda: len(written) == 11)
    say({"voyage": "again"})
    assert say.close({"voyage": "last"})
    dropped = "  15 lines were not written here: nobody had read what came before"
    assert written == ["  first", *(f"  {k}" for k in range(10)), dropped, "  again", "  last"]


def test_the_last_words_come_first_where_nobody_has_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(heard, "MOST", 10)
    monkeypatch.setattr(heard, "LAST_S", 0.2)
    written, reads = list[str](), threading.Event()

    def write(text: str) -> None:
        assert reads.wait(20)
        written.append(text)

    say = Heard(_text, write)
    for k in range(25):
        say({"voyage": str(k)})
    assert not say.close({"voyage": "last"}), "nobody reads, and it ends all the same"
    reads.set()
    say._thread.join(10)
    number = 25 - (len(written) - 2)
    told = f"  {number} lines were not written here: nobody had read what came before"
    assert written[-2:] == [told, "  last"] and number >= 14


def test_somebody_who_reads_no_more_ends_it() -> None:
    def write(text: str) -> None:
        raise BrokenPipeError

    say = Heard(said, write)
    say({"output": 1})
    until(lambda: say._gone)
    with pytest.raises(BrokenPipeError):
        say({"output": 2})
    with pytest.raises(BrokenPipeError):
        say.close({"output": 3})


RUN = """
import sys
from interlock.cli.common import end_as_by_ctrl_c
from interlock.cli.heard import Heard
from interlock.cli.main import _leave
say = Heard(lambda event: "x" * 1000)
end_as_by_ctrl_c()
try:
    import time
    for k in range(10_000_000):
        say({"output": k})
        if k % 500 == 0:
            sys.stderr.write(".")
            sys.stderr.flush()
            time.sleep(0.01)
except KeyboardInterrupt:
    pass
say.close({"stopped": 1})
_leave(0)
"""


@pytest.fixture
def unread() -> Iterator[subprocess.Popen[bytes]]:
    """A run whose output nobody reads."""
    process = subprocess.Popen([sys.executable, "-c", RUN], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        yield process
    finally:
        process.kill()
        process.communicate()


def test_a_process_whose_output_is_not_read_goes_on_and_ends_when_it_is_told_to(
    unread: subprocess.Popen[bytes],
) -> None:
    """It stood still for good, and was there five seconds after it was told to end."""
    assert unread.stderr is not None
    for _ in range(20):  # ten thousand lines, a thousand letters each: far more than a pipe holds
        assert unread.stderr.read(1) == b"."
    unread.send_signal(signal.SIGTERM)
    assert unread.wait(20) == 0
    assert b"Fatal" not in unread.stderr.read()
