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


def decisions(sat: Sat, literals: Sequence[int], known: Sequence[bool] = (), patience: int = 0) -> list[Decision]:
    """Which literals follow; what follows is a fact for the questions after it.

    known: those that need not be asked.  patience: when so many do not follow, the rest is left open.
    """
    known = known or [False] * len(literals)
    for x, follows in zip(literals, known, strict=True):
        if follows:
            sat.learn(x)
    found: list[Decision] = []
    left = patience or len(literals)
    for x, follows in zip(literals, known, strict=True):
        began = time.perf_counter()
        if not follows and left > 0:
            follows = sat.ask(-x) is Answer.UNSAT
            if follows:
                sat.learn(x)
            else:
                left -= 1
        found.append(Decision(follows, time.perf_counter() - began))
    return found
