"""One controller for a substation, and one panel for a record: a second one on this computer that would write the same
outputs or the same file is refused.

Locks on files that the operating system lets go of with the process, however that ends, in one folder for all users.
Outputs are known by every address to which the name of their host leads, and by the name, which may lead elsewhere
later, or nowhere.  What another computer writes cannot be seen from here, nor that two addresses lead to one device.

Whoever tidies that folder takes a file away and leaves its lock with nobody who could find it.  So it is looked after
while the controller runs (`Alone`), and made again; where another controller has come first, this one writes nothing
any more, for good: it does not know what the other one has let trains do.
"""

from __future__ import annotations

import hashlib
import ipaddress
import os
import socket
import sys
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from threading import Lock as Mutex
from threading import Thread
from typing import IO

from interlock.field.plc import Link, LinkLost

FOLDER = Path("/tmp") if os.name == "posix" else Path(os.environ.get("PROGRAMDATA", "C:/ProgramData"))
"""Where the files lie, whatever folder a user has of his own."""

LOOKUP_S = 2.0
"""Seconds for which names of hosts are looked up; one that has led nowhere by then is taken as typed."""

MOST = 32
"""Addresses of one host that are held, the first in their order."""

TRIES = 5
"""How often a file is opened that another process is just making, or that somebody sweeps away."""

LOOK_S = 2.0
"""Seconds after which it is looked again whether a lock is where others look for it (our choice)."""

LOOPBACK = "127.0.0.1"


class InUse(Exception):
    """Another process holds one of them, or nobody can see whether one does; the message says which."""


class Lock:
    """A file that is locked, and what it is held for, as whoever asks calls it."""

    def __init__(self, file: IO[bytes], path: Path, place: str) -> None:
        self._file, self._path, self.place = file, path, place
        self._lost = False

    def look(self) -> bool:
        """Whether it is held; one that somebody has removed is made again.  Where another one lies there, another
        process has held it in between, and it is lost for good."""
        if self._lost or _lies_at(self._file, self._path):
            return not self._lost
        try:
            again = None if os.path.lexists(self._path) else _taken(self._path, self.place)
        except InUse:
            again = None
        if again is None:
            self._lost = True
            return False
        self._file.close()
        self._file = again
        return True

    def close(self) -> None:
        """Let go of it."""
        self._file.close()


class Alone:
    """The way to a substation, as long as nobody else on this computer holds one of its locks."""

    def __init__(self, link: Link, held: Sequence[Lock], now: Callable[[], float] = time.monotonic) -> None:
        self._link, self._held, self._now = link, held, now
        self._looked, self._mutex = now(), Mutex()

    def read(self) -> Mapping[str, int]:
        """See `Link`."""
        self._look()
        return self._link.read()

    def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
        """See `Link`."""
        self._look()
        self._link.write(values, heartbeat)

    def close(self) -> None:
        """See `Link`."""
        self._link.close()

    def _look(self) -> None:
        with self._mutex:
            if self._now() - self._looked < LOOK_S:
                return
            if not all(lock.look() for lock in self._held):
                raise LinkLost("another interlock on this computer writes the same outputs: end one, start this again")
            self._looked = self._now()


def hold(places: list[str]) -> list[Lock]:
    """Hold outputs, each place as HOST:PORT[/DEVICE], until the locks that are returned are closed.  Raises
    `InUse`."""
    parts = [_parted(place) for place in places]
    addresses = _looked_up({host for host, _, _ in parts})
    owner: dict[str, str] = {}
    for place, (host, port, device) in zip(places, parts, strict=True):
        for address in sorted({host, *addresses[host]}):
            name = f"{address}:{port}/{device}"
            if name in owner:
                raise InUse(f"{owner[name]} and {place} are one place: each substation has its own")
            owner[name] = place
    return _hold(owner, "outputs")


def hold_file(path: Path) -> list[Lock]:
    """Hold a record, likewise."""
    return _hold({str(path.resolve()): str(path)}, "record")


def _parted(place: str) -> tuple[str, int, int]:
    """Host, port and device of a place."""
    host, _, tail = place.rpartition(":")
    port, _, device = tail.partition("/")
    return _plain(host.strip("[]").rstrip(".").lower()), int(port), int(device or 1)


def _plain(host: str) -> str:
    """An address in the one form that it has here, and a name as it is.  What this computer calls itself is one
    address."""
    try:
        found = ipaddress.ip_address(host)
    except ValueError:
        return host
    found = getattr(found, "ipv4_mapped", None) or found
    own = found.is_unspecified or (found.version == 6 and found.is_loopback)
    return LOOPBACK if own else str(found)


def _looked_up(hosts: Iterable[str]) -> Mapping[str, tuple[str, ...]]:
    """The addresses to which names lead; none where a name leads nowhere, or not in time."""
    found: dict[str, tuple[str, ...]] = dict.fromkeys(hosts, ())

    def look(host: str) -> None:
        with suppress(OSError, ValueError):  # no such name, or a text that cannot be one
            infos = socket.getaddrinfo(host, None, type=socket.SOCK_STREAM)
            found[host] = tuple(sorted({_plain(str(x[4][0])) for x in infos})[:MOST])

    until = time.monotonic() + LOOKUP_S
    threads = [Thread(target=look, args=(host,), daemon=True) for host in found]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(max(0.0, until - time.monotonic()))
    return dict(found)


def _hold(names: Mapping[str, str], what: str) -> list[Lock]:
    """Take a lock for each name, all or none; beside each what it is called by whoever asks."""
    held: list[Lock] = []
    try:
        for name, place in names.items():
            path = FOLDER / f"interlock-{hashlib.sha256(name.encode()).hexdigest()[:20]}.lock"
            file = _taken(path, place)
            if file is None:
                raise InUse(f"{place} is held by another interlock on this computer: two may not write the same {what}")
            held.append(Lock(file, path, place))
    except InUse:
        for one in held:
            one.close()
        raise
    return held


def _taken(path: Path, place: str) -> IO[bytes] | None:
    """The file of a place, locked; None where another process has it."""
    why = "it does not stay"
    for k in range(TRIES):
        time.sleep(0.01 * k)
        try:
            file = _open(path)
            if not _lock(file):
                file.close()
                return None
            if _lies_at(file, path):
                return file
            file.close()
        except OSError as error:
            why = error.strerror or type(error).__name__
    raise InUse(f"it cannot be seen whether another interlock holds {place}: {path}: {why}; remove that file")


def _lies_at(file: IO[bytes], path: Path) -> bool:
    """Whether this file is the one of that name."""
    try:
        return os.path.samestat(os.fstat(file.fileno()), os.lstat(path))
    except OSError:
        return False


def _open(path: Path) -> IO[bytes]:
    """The file, for every user of this computer.  One that is there is never opened as if it were to be made: systems
    refuse that, in a folder for all, with files of other users."""
    more = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    try:
        return os.fdopen(os.open(path, os.O_RDWR | more), "r+b")
    except FileNotFoundError:
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o666)
        if sys.platform != "win32":
            os.fchmod(handle, 0o666)  # whatever the umask
        return os.fdopen(handle, "r+b")
    except PermissionError:
        return os.fdopen(os.open(path, os.O_RDONLY | more), "rb")


def _lock(file: IO[bytes]) -> bool:
    """Take the lock; whether nobody else has it."""
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True
