"""Goals asked of a solver one after the other; what was answered before is not asked again.

**Theorem.**  A goal follows from facts exactly if its denial cannot hold together with them; what a solver learns while
literals are assumed follows from its clauses alone, so that no question changes the answer to a later one.  (Een and
Sorensson, *Temporal Induction by Incremental SAT Solving*, 2003.)
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

from interlock.logic.expr import Expr, parts_of
from interlock.logic.names import Name
from interlock.proof.engines import Answer, Sat, solver
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.plaisted_greenbaum import OneSided


class Decision(NamedTuple):
    """Whether a goal follows, and the seconds that the question took."""

    follows: bool
    seconds: float


def decided(
    goals: Sequence[Expr],
    facts: Iterable[Expr],
    meaning: Mapping[Name, Expr],
    limits: Limits,
    form: Callable[[], str],
    patience: int = 0,
) -> list[Decision]:
    """Which goals follow from facts over names that have a meaning; `form`: the canonical form of all of it."""
    key = limits.cache.key(form, limits.engine)
    known = limits.cache.known(key, len(goals))
    if all(known):
        return [Decision(True, 0.0)] * len(goals)
    cnf = OneSided(meaning)
    for x in facts:
        cnf.require(x)
    denials = [[cnf.denial(part) for part in parts_of(x) or (x,)] for x in goals]
    found = decisions(solver(limits.engine, cnf, limits.query_ms), denials, known, patience)
    limits.cache.keep(key, [d.follows for d in found])
    return found


def decisions(
    sat: Sat, denials: Sequence[Sequence[Sequence[int]]], known: Sequence[bool] = (), patience: int = 0
) -> list[Decision]:
    """Which goals follow, each by itself: those of which no part can be false.

    denials: by goal and part.  That some part is false would be searched for, where each alone is often seen at once.

    known: goals that need not be asked.  patience: when so many do not follow, the rest is left open.
    """
    found = [Decision(follows, 0.0) for follows in known or [False] * len(denials)]
    left = patience or len(denials)
    for n, parts in enumerate(denials):
        if found[n].follows:
            continue
        if left <= 0:
            break
        began = time.perf_counter()
        follows = all(sat.ask(*denial) is Answer.UNSAT for denial in parts)
        left -= not follows
        found[n] = Decision(follows, time.perf_counter() - began)
    return found
