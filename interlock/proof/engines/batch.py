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
) -> list[Decision]:
    """Which goals follow from facts over names that have a meaning; `form`: the canonical form of all of it."""

    def asked(known: Sequence[bool]) -> list[Decision]:
        cnf = OneSided(meaning)
        for x in facts:
            cnf.require(x)
        denials = [denials_of(cnf, x) for x in goals]
        sat = solver(limits.engine, cnf, limits.query_ms)
        return decisions(lambda n: follows(sat, denials[n]), known)

    return kept(len(goals), limits, form, asked)


def kept(
    count: int, limits: Limits, form: Callable[[], str], asked: Callable[[Sequence[bool]], list[Decision]]
) -> list[Decision]:
    """What was answered before to the question of a canonical form; what was not is asked, and kept."""
    key = limits.cache.key(form, limits.engine)
    known = limits.cache.known(key, count)
    if all(known):
        return [Decision(True, 0.0)] * count
    found = asked(known)
    limits.cache.keep(key, [d.follows for d in found])
    return found


def denials_of(cnf: OneSided, goal: Expr) -> list[list[int]]:
    """The denial of each part of a goal.

    That some part is false would be searched for, where each alone is often seen at once.
    """
    return [cnf.denial(part) for part in parts_of(goal) or (goal,)]


def follows(sat: Sat, denials: Sequence[Sequence[int]], assumed: Sequence[int] = ()) -> bool:
    """Whether no part of a goal can be false while some literals are assumed."""
    return all(sat.ask(*assumed, *denial) is Answer.UNSAT for denial in denials)


def decisions(follows: Callable[[int], bool], known: Sequence[bool], patience: int = 0) -> list[Decision]:
    """Which goals follow, each by itself, where `follows` asks for the one of a number.

    known: goals that need not be asked.  patience: when so many do not follow, the rest is left open.
    """
    found = [Decision(ok, 0.0) for ok in known]
    left = patience or len(found)
    for n, ok in enumerate(known):
        if ok:
            continue
        if left <= 0:
            break
        began = time.perf_counter()
        ok = follows(n)
        left -= not ok
        found[n] = Decision(ok, time.perf_counter() - began)
    return found
