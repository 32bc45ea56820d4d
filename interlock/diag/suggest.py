"""Did you mean: the nearest known name."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Collection, Sequence
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
    none is near, and where it would be a guess among opposites: of a negation (`abnormal`), of an end (`X.2c`)."""
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
    head, dot, end = own.rpartition(".")
    ends = [n[len(head) + 1 :] for n in lowered if n.startswith(f"{head}.")] if dot else []
    if ends:
        found = _nearest_end(end, ends)
        return lowered[f"{head}.{found}"] if found is not None else None
    names = list(lowered)
    if len(names) > _MANY:
        names = [n for n in names if abs(len(n) - len(own)) <= 2 and (n[:1] == own[:1] or n[-1:] == own[-1:])]
    near = _closest(own, names)
    return lowered[near] if near is not None else None


_BEGINNINGS = {"begin": "start", "beginning": "start"}
_OPPOSITES = (("forward", "backward"), ("far", "near"), ("normal", "reverse"), ("left", "right"), ("inner", "outer"))
_OPPOSITE = {a: b for pair in _OPPOSITES for a, b in (pair, pair[::-1])}
_APART = 0.2
"""By so much a word is nearer to what is proposed than to its opposite."""
_NEGATIONS = ("un", "non", "not", "no", "ab", "in", "dis", "anti", "de")


def _nearest_end(end: str, ends: Sequence[str]) -> str | None:
    """The end of one element that is meant.  `a2` is `2a`, and nothing else of two signs is guessed: where they differ
    in one sign, a misspelt one is as near to the opposite."""
    turned = [e for e in ends if sorted(e) == sorted(end)]
    if len(turned) == 1 or _BEGINNINGS.get(end) in ends:
        return turned[0] if turned else _BEGINNINGS[end]
    if all(len(e) <= 2 for e in ends):
        return None
    begun = [e for e in ends if end and e.startswith(end)]
    return begun[0] if len(begun) == 1 else _closest(end, ends)


def _closest(own: str, names: Sequence[str]) -> str | None:
    """The name most like a word, unless the word denies it, or is about as near to its opposite."""
    near = difflib.get_close_matches(own, names, n=1, cutoff=0.6)
    if not near or _denies(own, near[0]):
        return None
    other = _OPPOSITE.get(near[0])
    if other in names and _alike(own, near[0]) - _alike(own, str(other)) < _APART:
        return None
    return near[0]


def _denies(own: str, name: str) -> bool:
    """Whether a word is another one with a negation before or behind it, which is as good as its opposite."""
    rests = [own[len(p) :] for p in _NEGATIONS if own.startswith(p) and not name.startswith(p)]
    rests += [own[:-4]] if own.endswith("less") and not name.endswith("less") else []
    return len(name) > 2 and any(_alike(r.strip("-_ "), name) > _alike(own, name) for r in rests)


def _alike(one: str, other: str) -> float:
    return difflib.SequenceMatcher(None, one, other).ratio()
