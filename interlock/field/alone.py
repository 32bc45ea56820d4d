"""One controller for a substation, and one panel for a record: a second one on this computer that would write the same
outputs or the same file is refused.

A lock on a file that the operating system lets go of with the process, however that ends.  What another computer writes
cannot be seen from here.
"""

from __future__ import annotations

import hashlib
import os
import sys
import tempfile
from pathlib import Path
from typing import IO


class InUse(Exception):
    """Another process holds one of them; the message says which."""


def hold(places: list[str], what: str = "outputs") -> list[IO[bytes]]:
    """Hold substations by their addresses, or a file by its path, as long as the files that are returned stay open;
    `what` is written there.  Raises `InUse`."""
    held: list[IO[bytes]] = []
    for place in places:
        name = hashlib.sha256(place.encode()).hexdigest()[:20]
        file = _open(Path(tempfile.gettempdir()) / f"interlock-{name}.lock")
        held.append(file)
        if not _lock(file):
            for one in held:
                one.close()
            raise InUse(f"{place} is held by another interlock on this computer: two may not write the same {what}")
    return held


def _open(path: Path) -> IO[bytes]:
    """The file, for every user of this computer."""
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    return os.fdopen(handle, "r+b")


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
