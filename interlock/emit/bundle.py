"""A folder of outputs with a manifest of digests, written atomically, or compared with what is there."""

from __future__ import annotations

import errno
import hashlib
import io
import json
import os
import re
import secrets
import shutil
import stat
import zipfile
from collections.abc import Mapping
from pathlib import Path, PurePosixPath

from interlock.emit.half_written import taken_away

MANIFEST = "manifest.json"


def with_manifest(files: Mapping[str, bytes], facts: Mapping[str, object]) -> dict[str, bytes]:
    """The files with a manifest that names each with its digest."""
    body = {
        "schema": "interlock-manifest/1",
        **facts,
        "files": {n: digest_of(n, files[n]) for n in sorted(files)},
    }
    text = json.dumps(body, indent=1, ensure_ascii=False) + "\n"
    return {**files, MANIFEST: text.encode()}


def digest_of(name: str, data: bytes) -> str:
    """SHA-256 of a file; of a workbook that of its parts, one after the other: how they are compressed depends on the
    machine's zlib."""
    return hashlib.sha256(_contents(name, data)).hexdigest()


def _contents(name: str, data: bytes) -> bytes:
    if not name.endswith(".xlsx"):
        return data
    with zipfile.ZipFile(io.BytesIO(data)) as book:
        parts = [(item.filename.encode(), book.read(item)) for item in book.infolist()]
    return b"".join(b"%d %s %d\n%s" % (len(part), part, len(body), body) for part, body in parts)


def reproducible(data: bytes) -> bytes:
    """The same archive, compressed and with fixed dates.  Its contents are the same everywhere; its bytes depend on the
    machine's zlib, and are therefore never compared."""
    out = io.BytesIO()
    with (
        zipfile.ZipFile(io.BytesIO(data)) as old,
        zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as new,
    ):
        for item in old.infolist():
            fresh = zipfile.ZipInfo(item.filename, (2000, 1, 1, 0, 0, 0))
            fresh.compress_type = zipfile.ZIP_DEFLATED
            new.writestr(fresh, old.read(item))
    return out.getvalue()


def _same(name: str, there: bytes, wanted: bytes) -> bool:
    try:
        return there == wanted or _contents(name, there) == _contents(name, wanted)
    except zipfile.BadZipFile:
        return False


def write_folder(target: Path, files: Mapping[str, bytes]) -> None:
    """Replace a folder by the files: all of them, or (on an error) none, and then the folder is as it was.  A link is
    followed, and the folder keeps its permissions.  Raises OSError, and ValueError for a name that leads out of the
    folder.

    What cannot be removed of the older folder stays beside it; `left_beside` names it."""
    for name in files:
        place = PurePosixPath(name)
        if place.is_absolute() or ".." in place.parts or not place.parts:
            raise ValueError(f"{name!r} is no place in a folder")
    target = _followed(target)
    target.parent.mkdir(parents=True, exist_ok=True)
    mode = stat.S_IMODE(target.stat().st_mode) if target.exists() else None
    fresh = target.with_name(f".{target.name}.{secrets.token_hex(4)}")
    with taken_away():
        try:
            fresh.mkdir()  # with the permissions of the umask, and the group of the folder above where that says so
            if mode is not None:
                fresh.chmod(mode | stat.S_IRWXU)
            for name, data in files.items():
                path = fresh / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
            if mode is not None:
                fresh.chmod(mode)
            _replace(target, fresh)
        except BaseException:
            shutil.rmtree(fresh, ignore_errors=True)
            raise


def _followed(target: Path) -> Path:
    """Where a link leads; anything else itself.  Raises OSError for links that lead round."""
    if not target.is_symlink():
        return target
    try:
        return target.resolve()
    except RuntimeError:
        raise OSError(errno.ELOOP, os.strerror(errno.ELOOP), str(target)) from None


def _replace(target: Path, fresh: Path) -> None:
    """Let a folder take the place of another; that one stays where this fails."""
    if not target.exists():
        os.rename(fresh, target)
        return
    old = fresh.with_name(fresh.name + ".old")
    os.rename(target, old)
    try:
        os.rename(fresh, target)
    except BaseException:
        if target.exists():  # somebody else was quicker
            shutil.rmtree(old, ignore_errors=True)
        else:
            os.rename(old, target)
        raise
    shutil.rmtree(old, ignore_errors=True)


def left_beside(target: Path) -> list[Path]:
    """What runs that were killed have left beside a folder, and what could not be removed of older ones; `.old` is what
    the folder was before.  Nothing where nobody may look."""
    name = re.compile(rf"\.{re.escape(target.name)}\.[0-9a-z_]{{8}}(\.old)?")
    try:
        target = _followed(target)
        return sorted(p for p in target.parent.iterdir() if name.fullmatch(p.name))
    except OSError:
        return []


def strangers(target: Path) -> list[str]:
    """What is in a folder that its manifest does not name: all of it where there is no manifest of ours.  A folder with
    none may be replaced, as one that is not there; a file in its place is a stranger itself.  Where nobody may look, or
    the name is too long, nothing is found, and writing says why."""
    if not os.path.exists(target):
        return []
    if not target.is_dir():
        return [target.name]
    there = {p.relative_to(target).as_posix() for p in target.rglob("*") if p.is_symlink() or not p.is_dir()}
    return sorted(there - _named(target / MANIFEST))


def _named(manifest: Path) -> set[str]:
    """The files that a manifest of outputs or of a certificate names, and itself; none where it is something else."""
    try:
        body = json.loads(manifest.read_bytes())
        ours = str(body["schema"]).startswith("interlock-")
        return {MANIFEST, *body["files"]} if ours else set()
    except (OSError, ValueError, TypeError, KeyError, RecursionError):
        return set()


def not_replaced(target: Path, found: list[str]) -> str:
    """Why a folder with strangers in it is not replaced, in words."""
    more = f" and {len(found) - 1} more" if len(found) > 1 else ""
    return f"{target} is not replaced: interlock has not written {found[0]}{more}"


def differences(target: Path, files: Mapping[str, bytes]) -> list[str]:
    """What differs between a folder and the files it should hold; empty when it is current."""
    out = []
    for name, data in sorted(files.items()):
        path = target / name
        if not path.is_file():
            out.append(f"{name} is missing")
        elif not _same(name, path.read_bytes(), data):
            out.append(f"{name} differs")
    if target.is_dir():
        there = {str(p.relative_to(target)) for p in target.rglob("*") if p.is_file()}
        out.extend(f"{n} is not an output" for n in sorted(there - set(files)))
    return out
