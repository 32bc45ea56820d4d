"""The strengthening invariants that are inductive, and the claims that follow from them.

**Theorem.**  What holds in the initial states, and after every step from a state in which it holds, holds in all
reachable states, and so does what follows from it; dropping candidates until none fails gives the greatest inductive
subset of them.  (Floyd, 1967; Manna and Pnueli, *Temporal Verification of Reactive Systems*, 1995; Flanagan and Leino,
*Houdini*, 2001.)  Every solver answer other than UNSAT counts against a candidate.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from interlock.logic.expr import FALSE, NOT, TRUE, VAR, Expr, Substitution, settled
from interlock.logic.names import Name
from interlock.proof.abstraction.canonical import CanonicalForms
from interlock.proof.claims import Claim, Facts, Invariant, strengthening
from interlock.proof.engines import Answer, batch, solver
from interlock.proof.engines.batch import Decision
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.induction.parts import Goal, decide
from interlock.proof.induction.verdict import Progress, quiet
from interlock.proof.system.restart import InitialCondition
from interlock.proof.system.transition import System


def inductive(system: System, limits: Limits, progress: Progress = quiet) -> tuple[list[Invariant], list[str], int]:
    """The strengthening invariants that hold at the restart and are kept by every step, the dropped ones, and the
    number of obligations decided."""
    found = list(strengthening(Facts(system)))
    at_restart = holding_at_restart(system, found, limits)
    kept, dropped, obligations = keep(system, found, at_restart, None, limits, progress)
    return kept, dropped, obligations + len(found)


def keep(
    system: System,
    kept: list[Invariant],
    at_restart: Sequence[bool],
    first: Sequence[bool] | None,
    limits: Limits,
    progress: Progress,
) -> tuple[list[Invariant], list[str], int]:
    """Drop what does not hold at the restart, then what a step does not keep, until all is kept.

    `first`: which of all the invariants a step keeps if all of them hold before it, where that is known.
    """
    dropped = [f"{i.id} at {i.place} (at the restart)" for i, ok in zip(kept, at_restart, strict=True) if not ok]
    obligations = 0
    if dropped:
        kept, first = [i for i, ok in zip(kept, at_restart, strict=True) if ok], None
    while True:
        if first is None:
            goals = [Goal(i.expr, later=True) for i in kept]
            first = [d.follows for d in decided(system, kept, goals, limits, "invariants", progress)]
        obligations += len(kept)
        failed = [i for i, ok in zip(kept, first, strict=True) if not ok]
        if not failed:
            return kept, dropped, obligations
        dropped += [f"{i.id} at {i.place}" for i in failed]
        kept, first = [i for i, ok in zip(kept, first, strict=True) if ok], None


def decided(
    system: System, kept: Sequence[Invariant], goals: Sequence[Goal], limits: Limits, stage: str, progress: Progress
) -> list[Decision]:
    """Which goals follow, in one step, from the invariants."""
    hypotheses = [i.expr for i in kept]
    return decide(system.relation, system.where, hypotheses, goals, limits, partial(progress, stage))


def holding_at_restart(system: System, invariants: Sequence[Invariant], limits: Limits) -> list[bool]:
    """Which invariants hold at the restart.

    Most of the state has one value there: what is not true by these values alone is asked.
    Raises RuntimeError if there is no such state, or if that could not be decided: then nothing is proved.
    """
    fixed, others = restart_values(system.initial)
    put = Substitution(fixed)
    facts = [put(x) for x in others]
    cnf = Cnf()
    for x in facts:
        cnf.require(x)
    answer = solver(limits.engine, cnf, limits.query_ms).ask()
    if answer is Answer.UNSAT:
        raise RuntimeError("the restart states contradict each other")
    if answer is not Answer.SAT:
        raise RuntimeError("whether there is a restart state could not be decided")
    known = {name: x is TRUE for name, x in fixed.items()}
    left = [n for n, i in enumerate(invariants) if not settled(i.expr, known)]
    asked = [put(invariants[n].expr) for n in left]
    found = batch.decided(asked, facts, {}, limits, lambda: CanonicalForms({}).of({}, asked, facts))
    holds = [True] * len(invariants)
    for n, d in zip(left, found, strict=True):
        holds[n] = d.follows
    return holds


def restart_values(initial: InitialCondition) -> tuple[dict[Name, Expr], list[Expr]]:
    """The variables that have one value at a restart, and what is known besides."""
    fixed: dict[Name, Expr] = {}
    others: list[Expr] = []
    for x in initial.parts:
        leaf, value = (x.args[0], FALSE) if x.op is NOT else (x, TRUE)
        if leaf.op is not VAR:
            others.append(x)
        elif fixed.setdefault(leaf.name, value) is not value:
            raise RuntimeError("the restart states contradict each other")
    return fixed, others


def open_claims(
    system: System, kept: list[Invariant], wanted: tuple[Claim, ...], limits: Limits, progress: Progress = quiet
) -> dict[str, list[Claim]]:
    """The claims that do not follow from the invariants."""
    return left_open(wanted, decided(system, kept, [Goal(c.expr) for c in wanted], limits, "claims", progress))


def left_open(wanted: Sequence[Claim], decisions: Sequence[Decision]) -> dict[str, list[Claim]]:
    """The claims that do not follow, by id."""
    found: dict[str, list[Claim]] = {}
    for c, d in zip(wanted, decisions, strict=True):
        if not d.follows:
            found.setdefault(c.id, []).append(c)
    return found
