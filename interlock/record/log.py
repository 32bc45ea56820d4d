"""An event log that is only ever appended to: one JSON object a line, each tied to all before it by a digest.

    {"n":0,"t":0,"kind":"begin",...,"chain":"<64 hexadecimal digits>"}

`n` counts the events, `t` is their time in milliseconds, `chain` is the SHA-256 of the previous event's chain (at first
of nothing), a line feed, and the line up to `,"chain"`.  A line is handed to the operating system in one piece before
`add` returns, so that whatever kills the process loses at most the event that was being written.  A power cut may lose
more, unless the log is opened with `sync`.

A log that ends within a line was broken off there: all events before it hold.  Anything else that does not fit (a line
that is missing, changed, doubled or out of order) is damage, and nothing after it is believed.  That lines are missing
at the end cannot be seen from a log alone; it ends with the event `end` if its writer came to its end.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import re
import sys
from dataclasses import field, replace
from pathlib import Path
from typing import Any

from interlock.dataclass import dataclass

END = "end"
"""The kind of the last event of a log whose writer came to its end."""

NO_EVENT = "this is no event of a log"

LATEST_MS = 250_000_000_000_000
"""The latest time of an event: that of a calendar, whose last year is 9999."""

DEEPEST = 40
"""Objects and lists within each other; events of panels and shifts have a few."""

Event = dict[str, Any]

_TAIL = re.compile(rb'(?s)(.*),"chain":"([0-9a-f]{64})"\}')


class LogExists(Exception):
    """The file is there already: a log is never written over."""


def link(before: str, body: bytes) -> str:
    """The chain of an event after another one; `body`: its line up to `,"chain"`."""
    return hashlib.sha256(before.encode() + b"\n" + body).hexdigest()


@dataclass
class Chain:
    """Where a log stands: how many events it has, and the chain of the last."""

    number: int = 0
    digest: str = ""

    def line(self, t_ms: int, kind: str, fields: dict[str, Any]) -> bytes:
        """The line of the next event; half a surrogate, as in the name of a file, becomes `?`.

        Raises `ValueError` for a field that is named like one of our own."""
        if not fields.keys().isdisjoint({"n", "t", "kind", "chain"}):
            raise ValueError(f"fields of an event are not called n, t, kind or chain: {sorted(fields)}")
        event = {"n": self.number, "t": t_ms, "kind": kind, **fields}
        text = json.dumps(event, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
        body = text.encode(errors="replace")[:-1]
        self.number += 1
        self.digest = link(self.digest, body)
        return body + b',"chain":"' + self.digest.encode() + b'"}\n'


@dataclass(frozen=True)
class Problem:
    """Damage: in which line (from 1), and what is wrong there."""

    line: int
    text: str


@dataclass(frozen=True)
class Recorded:
    """What a log says.  `torn`: bytes of a last event that was never whole.  `problem`: from where on it is damaged."""

    events: tuple[Event, ...]
    chain: Chain = field(default_factory=Chain)
    torn: int = 0
    problem: Problem | None = None

    @property
    def ended(self) -> bool:
        """Its writer came to its end."""
        return self.problem is None and not self.torn and bool(self.events) and self.events[-1]["kind"] == END


def read(data: bytes) -> Recorded:
    """Every event up to the first that is not whole, or does not fit to those before it."""
    chain, events = Chain(), list[Event]()
    *lines, rest = data.split(b"\n")
    for k, line in enumerate(lines, 1):
        found = _TAIL.fullmatch(line)
        if found is None:
            text = "its lines end with CR LF: some tool has changed them" if line.endswith(b"}\r") else NO_EVENT
            return Recorded(tuple(events), chain, 0, Problem(k, text))
        body, digest = found[1], found[2].decode()
        if link(chain.digest, body) != digest:
            text = "this event does not follow the one before it: something was changed, or lines are missing"
            return Recorded(tuple(events), chain, 0, Problem(k, text))
        event = _event(body + b"}")
        if event is None or event["n"] != chain.number:
            return Recorded(tuple(events), chain, 0, Problem(k, NO_EVENT))
        events.append(event)
        chain = Chain(chain.number + 1, digest)
    begun, rest_of = b'{"n":%d,"t":' % chain.number, rest.rstrip(b"\0")  # zeros: what a power cut leaves of a block
    if not (rest_of.startswith(begun) or begun.startswith(rest_of)):
        return Recorded(tuple(events), chain, 0, Problem(len(lines) + 1, NO_EVENT))
    return Recorded(tuple(events), chain, len(rest))


def _event(text: bytes) -> Event | None:
    """An event with a number, a time and a kind, nested no deeper than whoever reads it can follow."""
    try:
        event = json.loads(text)
    except (ValueError, RecursionError):
        return None
    if not isinstance(event, dict) or type(event.get("n")) is not int or type(event.get("kind")) is not str:
        return None
    t = event.get("t")
    return event if type(t) is int and 0 <= t <= LATEST_MS and not _deep(text, event) else None


def _deep(text: bytes, event: Event) -> bool:
    """Whether objects and lists stand within each other more than DEEPEST times."""
    if text.count(b"[") + text.count(b"{") <= DEEPEST:
        return False
    level: list[Any] = [event]
    for _ in range(DEEPEST):
        level = [y for x in level if isinstance(x, dict | list) for y in (x.values() if isinstance(x, dict) else x)]
    return bool(level)


def read_file(path: Path) -> Recorded:
    """The same of a file.  Raises `OSError`."""
    return read(path.read_bytes())


def _locked(handle: int, path: Path) -> int:
    """A file that nobody else writes by whatever name, as far as the system knows locks of files; it lets go of the
    lock with the file.  Raises `OSError`."""
    if sys.platform != "win32":
        import fcntl

        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(handle)
            raise OSError(errno.EWOULDBLOCK, "another program writes it", str(path)) from None
        except OSError:  # a share that has no locks
            pass
    return handle


class Log:
    """A log on disk, open for more events.  `sync`: each event is on the disk before `add` returns."""

    def __init__(self, handle: int, chain: Chain, sync: bool = False) -> None:
        self._handle, self.chain, self._sync = handle, chain, sync
        self.size = os.fstat(handle).st_size
        """Bytes of the events that are whole."""

    @staticmethod
    def create(path: Path, sync: bool = False) -> Log:
        """Begin a log.  Raises `LogExists`, `OSError`."""
        try:
            handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND, 0o644)
        except FileExistsError:
            raise LogExists(f"{path} exists; a log is never written over") from None
        return Log(_locked(handle, path), Chain(), sync)

    @staticmethod
    def resume(path: Path, sync: bool = False) -> tuple[Log, Recorded]:
        """Go on with a log whose writer was killed; what is torn off at its end is cut away.

        A damaged log is not gone on with.  Raises `ValueError` for one, `OSError`.
        """
        handle = _locked(os.open(path, os.O_WRONLY | os.O_APPEND), path)
        try:
            found = read_file(path)
            if found.problem is not None:
                raise ValueError(f"{path}:{found.problem.line}: {found.problem.text}")
            if found.torn:
                os.ftruncate(handle, os.fstat(handle).st_size - found.torn)
        except (OSError, ValueError):
            os.close(handle)
            raise
        return Log(handle, found.chain, sync), found

    @staticmethod
    def again(path: Path, before: Log) -> Log:
        """Go on where the same process could not write: what is torn off at the end is cut away.  Nothing is read but
        the last digest, so that a long log takes no longer than a short one.  A file that is empty begins anew.

        Raises `ValueError` where the file does not end as it was left, `OSError`.
        """
        handle = _locked(os.open(path, os.O_RDWR | os.O_APPEND), path)
        try:
            if not os.fstat(handle).st_size:
                return Log(handle, Chain(), before._sync)
            end = f'"chain":"{before.chain.digest}"}}\n'.encode() if before.chain.number else b""
            os.lseek(handle, before.size - len(end), os.SEEK_SET)
            if os.read(handle, len(end)) != end:
                raise ValueError(f"{path} is not the log that was written until then: move it away")
            os.ftruncate(handle, before.size)
            return Log(handle, before.chain, before._sync)
        except (OSError, ValueError):
            os.close(handle)
            raise

    def add(self, t_ms: int, kind: str, **fields: Any) -> None:
        """Append an event.  Raises `OSError` where there is no room: then the log ends within a line, and stands
        where it stood before."""
        before = replace(self.chain)
        line = self.chain.line(t_ms, kind, fields)
        size = len(line)
        try:
            while line:
                line = line[os.write(self._handle, line) :]
            if self._sync:
                os.fsync(self._handle)
        except OSError:
            self.chain = before
            raise
        self.size += size

    def differs(self, path: Path) -> str:
        """What has been done to the file of that name: moved away, removed, cut or written by another; empty where it
        is this log as it was left."""
        try:
            own, there = os.fstat(self._handle), os.stat(path)
        except OSError:
            return f"{path} was moved away or removed"
        if not os.path.samestat(own, there):
            return f"{path} was moved away or removed, and is another file"
        return "" if own.st_size == self.size else f"{path} was cut, or written by another program"

    def close(self) -> None:
        """Let go of the file."""
        os.close(self._handle)

    def __enter__(self) -> Log:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
