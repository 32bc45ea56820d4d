"""Goals asked of a solver one after the other."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass

from interlock.proof.engines import Answer, Sat


@dataclass(frozen=True, slots=True)
class Decision:
    """Whether a goal follows, and the seconds that the question took."""

    follows: bool
    seconds: float


def decisions(
    sat: Sat, denials: Sequence[Sequence[int]], known: Sequence[bool] = (), patience: int = 0
) -> list[Decision]:
    """Which goals follow, each by itself: those whose denial cannot be.

    known: those that need not be asked.  patience: when so many do not follow, the rest is left open.
    """
    found = [Decision(follows, 0.0) for follows in known or [False] * len(denials)]
    left = patience or len(denials)
    for n, denial in enumerate(denials):
        if found[n].follows:
            continue
        if left <= 0:
            break
        began = time.perf_counter()
        follows = sat.ask(*denial) is Answer.UNSAT
        left -= not follows
        found[n] = Decision(follows, time.perf_counter() - began)
    return found
