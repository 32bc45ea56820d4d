"""Questions that were answered before, in a folder (`interlock prove --cache`).

What is kept is no verdict about a layout: a file says that some literals follow from some clauses, and its name is the
digest of all these clauses and literals, and of the engine that was asked.  A question that has changed in any way has
another name, so nothing can be out of date.  Each file ends with a digest of its content; one that is damaged is not
believed: the question is asked again.  Only "follows" is kept.
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from array import array
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import chain
from pathlib import Path

from interlock.proof.encode import Cnf


@dataclass(frozen=True)
class Cache:
    """A folder of answers; without a folder nothing is kept."""

    folder: Path | None = None

    def key(self, cnf: Cnf, literals: Sequence[int], engine: str) -> str:
        """The name of a question: which of the literals follow from the clauses."""
        if self.folder is None:
            return ""
        sizes = array("q", map(len, cnf.clauses))
        every = array("q", chain.from_iterable(cnf.clauses))
        digest = hashlib.sha256(f"{engine} {cnf.count} {len(sizes)} {len(every)} {len(literals)}\n".encode())
        for part in (sizes, every, array("q", literals)):
            digest.update(part.tobytes())
        return digest.hexdigest()

    def known(self, key: str, count: int) -> list[bool]:
        """For each literal whether it is known to follow."""
        nothing = [False] * count
        if self.folder is None:
            return nothing
        try:
            body, seal = (self.folder / key).read_text(encoding="ascii").split("\n")
        except (OSError, ValueError):
            return nothing
        if seal != _seal(key, body) or len(body) != count or set(body) - {"0", "1"}:
            return nothing
        return [c == "1" for c in body]

    def keep(self, key: str, follows: Sequence[bool]) -> None:
        """Keep an answer; a folder that cannot be written keeps nothing."""
        if self.folder is None:
            return
        body = "".join("1" if x else "0" for x in follows)
        with suppress(OSError):
            self.folder.mkdir(parents=True, exist_ok=True)
            with tempfile.NamedTemporaryFile("w", encoding="ascii", dir=self.folder, delete=False) as file:
                file.write(f"{body}\n{_seal(key, body)}")
            os.replace(file.name, self.folder / key)


def _seal(key: str, body: str) -> str:
    return hashlib.sha256(f"interlock {key} {body}".encode()).hexdigest()
