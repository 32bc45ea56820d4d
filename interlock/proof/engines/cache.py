"""Questions that were answered before, in a folder (`interlock prove --cache`).

What is kept is no verdict about a layout: a file says which of some goals follow from some facts and definitions, and
its name is the digest of all of these (`canonical.py`: variables have numbers for names) and of the engine that was
asked.  A question that has changed in any other way has another name, so nothing can be out of date.  Each file ends
with a seal: an HMAC of its name and content under a key of the user's own, which lies in the user's configuration
folder and never in the cache.  What is damaged, was planted, or was written by somebody else is not believed: the
question is asked again.  Only "follows" is kept.  Who can read the key file can make answers that are believed;
nobody else can.

All that is asked of a layout at once is one question, too: see `app/kept.py`.

**Theorem.**  Whether goals follow from facts does not depend on what variables are called: an answer holds for every
question that differs by a renaming that is one to one.  Two questions have one name only if they are equal after
renaming, or if SHA-256 collides.  (Church, *Introduction to Mathematical Logic*, 1956: substitution of variables.)
"""

from __future__ import annotations

import hashlib
import hmac
import os
import secrets
import stat
import tempfile
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import lru_cache
from pathlib import Path

from interlock.dataclass import dataclass

KEY_BYTES = 32
OTHERS = stat.S_IRWXG | stat.S_IRWXO


@dataclass(frozen=True)
class Cache:
    """A folder of answers; without a folder nothing is kept."""

    folder: Path | None = None

    def key(self, form: Callable[[], str], engine: str) -> str:
        """The name of a question of which only the names of its variables are left out."""
        return hashlib.sha256(f"{engine} {form()}".encode()).hexdigest() if self.folder is not None else ""

    def known(self, key: str, count: int) -> list[bool]:
        """For each literal whether it is known to follow."""
        body = self.text(key)
        if body is None or len(body) != count or set(body) - {"0", "1"}:
            return [False] * count
        return [c == "1" for c in body]

    def keep(self, key: str, follows: Sequence[bool]) -> None:
        """Keep an answer."""
        self.keep_text(key, "".join("1" if x else "0" for x in follows))

    def text(self, key: str) -> str | None:
        """One line that was kept, and is as it was."""
        if self.folder is None:
            return None
        try:
            body, seal = (self.folder / key).read_text(encoding="ascii").split("\n")
        except (OSError, ValueError):
            return None
        return body if _sealed(key, body, seal) else None

    def foreign(self) -> int:
        """How many answers in the folder this user has not sealed: none of them is believed."""
        if self.folder is None or not self.folder.is_dir():
            return 0
        names = [
            f.name for f in self.folder.iterdir() if len(f.name) == 64 and not set(f.name) - set("0123456789abcdef")
        ]
        return sum(self.text(name) is None for name in names)

    def useless(self) -> str:
        """Why nothing can be kept; empty where something can, or where nothing is asked for."""
        if self.folder is None:
            return ""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            return error.strerror or str(error)
        if not os.access(self.folder, os.W_OK | os.X_OK):
            return "it cannot be written"
        return "" if _own() is not None else "no key of your own can be had in your configuration folder"

    def keep_text(self, key: str, body: str) -> None:
        """Keep one line of ASCII; a folder that cannot be written keeps nothing."""
        sealed = None if self.folder is None else _seal(key, body)
        if self.folder is None or sealed is None:
            return
        with suppress(OSError):
            self.folder.mkdir(parents=True, exist_ok=True)
            with tempfile.NamedTemporaryFile("w", encoding="ascii", dir=self.folder, delete=False) as file:
                file.write(f"{body}\n{sealed}")
            os.replace(file.name, self.folder / key)


def key_file() -> Path:
    """Where the user's key is: in the configuration folder, where other programs of this user keep their settings."""
    base = os.environ.get("APPDATA") if os.name == "nt" else os.environ.get("XDG_CONFIG_HOME")
    return (Path(base) if base else Path.home() / ".config") / "interlock" / "cache.key"


def _own() -> bytes | None:
    """The user's key; None where none can be had."""
    try:
        return _secret(key_file())
    except RuntimeError:  # the user has no home
        return None


def _seal(key: str, body: str) -> str | None:
    secret = _own()
    return None if secret is None else hmac.new(secret, f"interlock {key} {body}".encode(), hashlib.sha256).hexdigest()


def _sealed(key: str, body: str, seal: str) -> bool:
    wanted = _seal(key, body)
    return wanted is not None and hmac.compare_digest(wanted, seal)


@lru_cache(8)
def _secret(file: Path) -> bytes | None:
    """The user's key, made at first use for this user alone; None where none can be had, so that nothing is kept.

    A key that others may read or write is no key.
    """
    try:
        file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        with suppress(FileExistsError):
            _make(file)
        if os.name != "nt" and (file.stat().st_mode & OTHERS or file.stat().st_uid != os.getuid()):
            return None
        secret = file.read_bytes()
    except OSError:
        return None
    return secret if len(secret) == KEY_BYTES else None


def _make(file: Path) -> None:
    """A new key, whole from the moment at which it is there: processes may begin side by side."""
    if file.exists():
        return
    handle, name = tempfile.mkstemp(dir=file.parent)  # for this user alone
    try:
        with os.fdopen(handle, "wb") as made:
            made.write(secrets.token_bytes(KEY_BYTES))
        os.link(name, file)
    finally:
        os.unlink(name)
