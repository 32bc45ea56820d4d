"""Did you mean: the nearest known name."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A sentence that proposes the nearest known name, or lists the known ones when they are few."""
    names = sorted(set(known))
    lowered = {n.lower(): n for n in names}
    if name.lower() in lowered:
        return f"did you mean {lowered[name.lower()]}?"
    near = difflib.get_close_matches(name, names, n=1, cutoff=0.6)
    if near:
        return f"did you mean {near[0]}?"
    if 0 < len(names) <= 12:
        return "known here: " + ", ".join(names)
    return ""
