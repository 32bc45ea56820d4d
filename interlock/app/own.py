"""Single files that commands write: one that interlock has not written, or that somebody has changed since, is never
overwritten unless that is asked for.

A file is ours if its last line says so with the SHA-256 of all before it.
"""

from __future__ import annotations

import hashlib
import os
import re
import secrets
import stat
from pathlib import Path

from interlock.emit.half_written import taken_away

MARK = b"written by interlock, sha256 "
LINE = re.compile(rb"(?:<!-- |# |note,,,\")?" + MARK + rb"([0-9a-f]{64})(?: -->|\")?\n\Z")
FRAMES = {".aig": (b"", b"\n"), ".pins": (b"# ", b"\n"), ".csv": (b'note,,,"', b'"\n')}
"""What stands around the mark, by ending; elsewhere (SVG, HTML) it is a comment."""


class NotOurs(Exception):
    """The file is there, and was not written by interlock; the message says so, and what to do."""


def is_ours(data: bytes) -> bool:
    """Whether these bytes were written by interlock, and are as it wrote them, but for the ends of lines of text that
    git or an editor may have made those of Windows."""
    return _is_sealed(data) or _is_sealed(data.replace(b"\r\n", b"\n"))


def _is_sealed(data: bytes) -> bool:
    found = LINE.search(data)
    return found is not None and hashlib.sha256(data[: found.start()]).hexdigest().encode() == found[1]


def is_changed(data: bytes) -> bool:
    """Whether these bytes were written by interlock, and are no longer as it wrote them."""
    return MARK in data and not is_ours(data)


def unchanged(target: Path, read: bytes | None) -> None:
    """Raises `NotOurs` where a file is no longer as it was read, None for not there; and OSError."""
    if (target.read_bytes() if target.exists() else None) != read:
        raise NotOurs(f"{target} was changed meanwhile: run it again")


def write_own(target: Path, data: bytes, source: Path, force: bool = False) -> int:
    """Write a file with its mark; the number of bytes.  Raises `NotOurs`, and OSError.

    `source`: what it is made from, which is never overwritten.  `force`: overwrite what is not ours.
    """
    if target.exists():
        if source.exists() and target.samefile(source):
            raise NotOurs(f"{target} is what is to be read: choose another file with -o")
        if not force and not is_ours(target.read_bytes()):
            raise NotOurs(f"{target} exists and is not as interlock wrote it; --force overwrites it")
    before, after = FRAMES.get(target.suffix, (b"<!-- ", b" -->\n"))
    body = data if data.endswith(b"\n") else data + b"\n"
    body += before + MARK + hashlib.sha256(body).hexdigest().encode() + after
    write_whole(target, body)
    return len(body)


def write_whole(target: Path, data: bytes) -> None:
    """Write a file whole, or leave what was there as it was.  Raises OSError.

    What is no file (a pipe, a terminal) is written as it is, and a link leads to the file that is written.
    """
    if target.exists() and not target.is_file():
        target.write_bytes(data)
        return
    target = target.resolve()
    fresh = target.with_name(f".{target.name[:100]}.{secrets.token_hex(4)}")
    with taken_away():
        try:
            fresh.write_bytes(data)
            if target.exists():
                fresh.chmod(stat.S_IMODE(target.stat().st_mode))
            os.replace(fresh, target)
        except BaseException:
            fresh.unlink(missing_ok=True)
            raise
