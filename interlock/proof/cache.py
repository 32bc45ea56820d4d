"""Questions that were answered before, in a folder (`interlock prove --cache`).

What is kept is no verdict about a layout: a file says which of some goals follow from some facts and definitions, and
its name is the digest of all of these (`alike.py`: variables have numbers for names) and of the engine that was asked.
A question that has changed in any other way has another name, so nothing can be out of date.  Each file ends with a
digest of its content; one that is damaged is not believed: the question is asked again.  Only "follows" is kept.

All that is asked of a layout at once is one question, too: see `app/kept.py`.
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path


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
        return body if seal == _seal(key, body) else None

    def keep_text(self, key: str, body: str) -> None:
        """Keep one line of ASCII; a folder that cannot be written keeps nothing."""
        if self.folder is None:
            return
        with suppress(OSError):
            self.folder.mkdir(parents=True, exist_ok=True)
            with tempfile.NamedTemporaryFile("w", encoding="ascii", dir=self.folder, delete=False) as file:
                file.write(f"{body}\n{_seal(key, body)}")
            os.replace(file.name, self.folder / key)


def _seal(key: str, body: str) -> str:
    return hashlib.sha256(f"interlock {key} {body}".encode()).hexdigest()
