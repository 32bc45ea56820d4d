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
    found: list[Decision] = []
    left = patience or len(denials)
    for denial, follows in zip(denials, known or [False] * len(denials), strict=True):
        began = time.perf_counter()
        if not follows and left > 0:
            follows = sat.ask(*denial) is Answer.UNSAT
            left -= not follows
        found.append(Decision(follows, time.perf_counter() - began))
    return found
