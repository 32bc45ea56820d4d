"""One controller for a substation, and one panel for a record: a second one on this computer that would write the same
outputs or the same file is refused.

Locks on files that the operating system lets go of with the process, however that ends, in one folder for all users.
Outputs are known by every address to which the name of their host leads, and by the name, which may lead elsewhere
later, or nowhere.  What another computer writes cannot be seen from here, nor that two addresses lead to one device.
"""

from __future__ import annotations

import hashlib
import ipaddress
import os
import socket
import sys
import time
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from threading import Thread
from typing import IO

FOLDER = Path("/tmp") if os.name == "posix" else Path(os.environ.get("PROGRAMDATA", "C:/ProgramData"))
"""Where the files lie, whatever folder a user has of his own."""

LOOKUP_S = 2.0
"""Seconds for which names of hosts are looked up; one that has led nowhere by then is taken as typed."""

MOST = 32
"""Addresses of one host that are held, the first in their order."""

TRIES = 5
"""How often a file is opened that another process is just making, or that somebody sweeps away."""

LOOPBACK = "127.0.0.1"


class InUse(Exception):
    """Another process holds one of them, or nobody can see whether one does; the message says which."""


def hold(places: list[str]) -> list[IO[bytes]]:
    """Hold outputs, each place as HOST:PORT[/DEVICE], as long as the files that are returned stay open.  Raises
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


def hold_file(path: Path) -> list[IO[bytes]]:
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


def _hold(names: Mapping[str, str], what: str) -> list[IO[bytes]]:
    """Take a lock for each name, all or none; beside each what it is called by whoever asks."""
    held: list[IO[bytes]] = []
    try:
        for name, place in names.items():
            file = _taken(FOLDER / f"interlock-{hashlib.sha256(name.encode()).hexdigest()[:20]}.lock", place)
            if file is None:
                raise InUse(f"{place} is held by another interlock on this computer: two may not write the same {what}")
            held.append(file)
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
            if os.path.samestat(os.fstat(file.fileno()), os.lstat(path)):
                return file
            file.close()
        except OSError as error:
            why = error.strerror or type(error).__name__
    raise InUse(f"it cannot be seen whether another interlock holds {place}: {path}: {why}; remove that file")


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
