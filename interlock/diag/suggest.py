"""Did you mean: the nearest known name."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Collection
from functools import lru_cache
from unicodedata import normalize

from interlock.dataclass import dataclass

_FEW = 12
_MANY = 500


@dataclass(frozen=True)
class Suggestion:
    """The nearest known name as a sentence.  Comparing takes milliseconds a name, and of ten thousand misspelt names
    few are shown: so it is done when the sentence is asked for."""

    name: str
    known: Collection[str]
    otherwise: str = ""
    of_another_kind: Callable[[str], str] | None = None
    """What to write where something else bears the very name; empty where nothing does."""

    def __str__(self) -> str:
        if self.of_another_kind is not None and (said := self.of_another_kind(self.name)):
            return said
        found = nearest(self.name, self.known)
        if found is not None:
            return f"did you mean {found}?"
        if self.otherwise:
            return self.otherwise
        names = sorted(set(self.known))
        more = f" and {len(names) - _FEW} more" if len(names) > _FEW else ""
        return f"known here: {', '.join(names[:_FEW])}{more}" if names else "nothing of the kind is known here"

    def __reduce__(self) -> tuple[type[str], tuple[str]]:
        """To another process goes the sentence: who bears the name is asked of a function, which cannot go there."""
        return str, (str(self),)


def did_you_mean(
    name: str, known: Collection[str], otherwise: str = "", of_another_kind: Callable[[str], str] | None = None
) -> Suggestion:
    """A sentence that says what bears the name if that is something else; else proposes the nearest known name; else
    what to do `otherwise`, else the known ones."""
    return Suggestion(name, known, otherwise, of_another_kind)


def nearest(name: str, known: Collection[str]) -> str | None:
    """The known name that is most like a name, upper and lower case alike, and full-width signs as others; None when
    none is near."""
    return _nearest(name, known if isinstance(known, tuple) else tuple(known))


@lru_cache(maxsize=256)
def _nearest(name: str, known: tuple[str, ...]) -> str | None:
    lowered = {n.lower(): n for n in sorted(known)}
    own = name.strip().lower()
    if own in lowered:
        return lowered[own]
    same, wanted = {normalize("NFKC", n): n for n in lowered}, normalize("NFKC", own)
    if wanted in same:
        return lowered[same[wanted]]
    names = list(lowered)
    if len(names) > _MANY:
        names = [n for n in names if abs(len(n) - len(own)) <= 2 and (n[:1] == own[:1] or n[-1:] == own[-1:])]
    near = difflib.get_close_matches(own, names, n=1, cutoff=0.6)
    return lowered[near[0]] if near else None
