"""From a layout and its controller to one verdict per claim.

1. The strengthening invariants hold at the restart and are kept by every step: an invariant that is not kept is
   dropped, and the rest is checked again without it, until what remains is inductive.
2. Every claim follows from the remaining invariants in every step.
3. What does not follow is searched for from the restart: a run found is REFUTED; otherwise UNKNOWN.
Every solver answer other than UNSAT counts against the claim.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

from interlock.logic.expr import AND, FALSE, NOT, OR, TRUE, VAR, Expr, Substitution, conj, neg, var
from interlock.logic.names import Name
from interlock.model.elements import Position
from interlock.proof.asking import Decision
from interlock.proof.encode import Cnf
from interlock.proof.engines import Answer, solver
from interlock.proof.invariants import CLAIMS, Claim, Facts, Invariant, claims, strengthening
from interlock.proof.limits import Limits
from interlock.proof.parts import Goal, Inquiry, Start, decide
from interlock.proof.pool import Task, run
from interlock.proof.search import search
from interlock.proof.story import tell
from interlock.proof.system import System
from interlock.proof.verdict import ClaimResult, Progress, ProofResult, Verdict, quiet
from interlock.proof.witness import witnesses


def inductive(system: System, limits: Limits, progress: Progress = quiet) -> tuple[list[Invariant], list[str], int]:
    """The strengthening invariants that hold at the restart and are kept by every step, the dropped ones, and the
    number of obligations decided."""
    found = list(strengthening(Facts(system)))
    at_restart = _restart(system, found, limits)
    kept, dropped, obligations = _keep(system, found, at_restart, None, limits, progress)
    return kept, dropped, obligations + len(found)


def _keep(
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
            first = [d.follows for d in _decide(system, kept, goals, limits, "invariants", progress)]
        obligations += len(kept)
        failed = [i for i, ok in zip(kept, first, strict=True) if not ok]
        if not failed:
            return kept, dropped, obligations
        dropped += [f"{i.id} at {i.place}" for i in failed]
        kept, first = [i for i, ok in zip(kept, first, strict=True) if ok], None


def _decide(
    system: System, kept: Sequence[Invariant], goals: Sequence[Goal], limits: Limits, stage: str, progress: Progress
) -> list[Decision]:
    """Which goals follow, in one step, from the invariants."""
    hypotheses = [i.expr for i in kept]
    return decide(system, hypotheses, goals, limits, partial(progress, stage))


def prove(
    system: System,
    limits: Limits | None = None,
    progress: Progress = quiet,
    wanted: tuple[Claim, ...] | None = None,
) -> ProofResult:
    """One verdict per claim; `wanted` if the claims are known already.

    Invariants and claims are asked together, as if all invariants were kept; where one is not, the claims are asked
    again with those that are.
    """
    began = time.monotonic()
    limits = limits or Limits()
    wanted = claims(Facts(system)) if wanted is None else wanted
    found = list(strengthening(Facts(system)))
    goals = [*(Goal(i.expr, later=True) for i in found), *(Goal(c.expr) for c in wanted)]
    inquiry = Inquiry(system, [i.expr for i in found], goals, limits)
    questions = inquiry.first()
    tasks: list[Task] = [partial(witnesses, system), partial(_restart, system, found, limits)]
    tasks.append(partial(_start, system, limits))
    first = len(tasks)  # what comes before takes longer than the last questions
    tasks += [partial(inquiry.ask, q) for q in questions]
    done = 0

    def report(n: int) -> None:
        nonlocal done
        done += len(questions[n - first]) if n >= first else 0
        progress("proving", min(done, len(goals)), len(goals))

    runs, at_restart, start, *answers = run(tasks, limits.jobs, report)
    for question, those in zip(questions, answers, strict=True):
        inquiry.note(question, those)
    decisions = inquiry.finish(partial(progress, "proving"))
    steps = [d.follows for d in decisions[: len(found)]]
    kept, dropped, obligations = _keep(system, found, at_restart, steps, limits, progress)
    verdicts = decisions[len(found) :]
    if dropped:
        verdicts = _decide(system, kept, [Goal(c.expr) for c in wanted], limits, "claims", progress)
    claimed = [*_claims(system, wanted, verdicts, limits, progress), start]
    order = list(CLAIMS)
    claimed.sort(key=lambda r: order.index(r.id))
    obligations += len(found) + len(wanted) + 1
    return ProofResult(tuple(claimed), len(kept), tuple(dropped), obligations, runs, time.monotonic() - began)


def _restart(system: System, invariants: Sequence[Invariant], limits: Limits) -> list[bool]:
    """Which invariants hold at the restart.

    Most of the state has one value there: what is not true by these values alone is asked.
    """
    fixed, others = _at_restart(system)
    put = Substitution(fixed)
    facts = [put(x) for x in others]
    cnf = Cnf()
    for x in facts:
        cnf.require(x)
    if solver(limits.engine, cnf, limits.query_ms).ask() is not Answer.SAT:
        raise RuntimeError("the restart states contradict each other")
    known = {name: x is TRUE for name, x in fixed.items()}
    left = [n for n, i in enumerate(invariants) if not _true(i.expr, known)]
    asked = [Goal(put(invariants[n].expr)) for n in left]
    found = decide(Start(), facts, asked, replace(limits, jobs=1), lambda done, total: None)
    holds = [True] * len(invariants)
    for n, d in zip(left, found, strict=True):
        holds[n] = d.follows
    return holds


def _at_restart(system: System) -> tuple[dict[Name, Expr], list[Expr]]:
    """The variables that have one value at a restart, and what is known besides."""
    fixed: dict[Name, Expr] = {}
    others: list[Expr] = []
    for x in system.initial_parts:
        leaf, value = (x.args[0], FALSE) if x.op is NOT else (x, TRUE)
        if leaf.op is not VAR:
            others.append(x)
        elif fixed.setdefault(leaf.name, value) is not value:
            raise RuntimeError("the restart states contradict each other")
    return fixed, others


def _true(x: Expr, known: Mapping[Name, bool], wanted: bool = True) -> bool:
    """Whether values of some variables make an expression come out as wanted, whatever the others are."""
    op = x.op
    if op is VAR:
        return known.get(x.name) is wanted
    if op is NOT:
        return _true(x.args[0], known, not wanted)
    if op is AND or op is OR:
        enough = any if (op is OR) is wanted else all
        return enough(_true(a, known, wanted) for a in x.args)
    return x is (TRUE if wanted else FALSE)


def open_claims(
    system: System, kept: list[Invariant], wanted: tuple[Claim, ...], limits: Limits, progress: Progress = quiet
) -> dict[str, list[Claim]]:
    """The claims that do not follow from the invariants."""
    return _open(wanted, _decide(system, kept, [Goal(c.expr) for c in wanted], limits, "claims", progress))


def _open(wanted: Sequence[Claim], decisions: Sequence[Decision]) -> dict[str, list[Claim]]:
    """The claims that do not follow, by id."""
    found: dict[str, list[Claim]] = {}
    for c, d in zip(wanted, decisions, strict=True):
        if not d.follows:
            found.setdefault(c.id, []).append(c)
    return found


def if_proved(wanted: Sequence[Claim]) -> tuple[ClaimResult, ...]:
    """The results if every claim is proved."""
    places = Counter(c.id for c in wanted) | Counter({"P-START": 1})
    return tuple(ClaimResult(i, CLAIMS[i], Verdict.PROVED, places[i], (), 0.0) for i in CLAIMS)


def _claims(
    system: System, wanted: Sequence[Claim], decisions: Sequence[Decision], limits: Limits, progress: Progress
) -> list[ClaimResult]:
    open_ = _open(wanted, decisions)
    seconds: dict[str, float] = {}
    places: dict[str, int] = {}
    for c, d in zip(wanted, decisions, strict=True):
        places[c.id] = places.get(c.id, 0) + 1
        seconds[c.id] = seconds.get(c.id, 0.0) + d.seconds
    out = []
    for id_ in CLAIMS:
        if id_ == "P-START":
            continue
        verdict, story = Verdict.PROVED, None
        if id_ in open_:
            looking = partial(progress, f"searching a counterexample to {id_}")
            run = search(system, open_[id_], limits.search_depth, limits.search_s, looking)
            verdict = Verdict.REFUTED if run is not None else Verdict.UNKNOWN
            story = tell(system, run) if run is not None else None
        out.append(
            ClaimResult(
                id_,
                CLAIMS[id_],
                verdict,
                places.get(id_, 0),
                tuple(c.place for c in open_.get(id_, ())),
                seconds.get(id_, 0.0),
                story,
            )
        )
    return out


def start_claim(system: System) -> Expr:
    """P-START: at the restart nothing is commanded, all signals show stop, every section is locked."""
    sym = system.symbols
    devices = system.layout.device
    commands = [*sym.command.items(), *sym.drive.items()]
    out: list[Expr] = [neg(var(n)) for (m, x), n in commands if m not in devices or x is Position.NORMAL]
    out += [var(n) for n in sym.stop_aspect.values()]
    out += [neg(sym.shows(g.id)) for g in system.layout.signals]
    out += [var(n) for n in sym.restart.values()]
    return conj(out)


def _start(system: System, limits: Limits) -> ClaimResult:
    """The restart: nothing commanded, all signals at stop, every section locked."""
    began = time.monotonic()
    wanted = start_claim(system)
    ok = _true(wanted, {name: x is TRUE for name, x in _at_restart(system)[0].items()})
    if not ok:
        cnf = Cnf()
        cnf.require(system.initial)
        literal = cnf.literal(wanted)
        ok = solver(limits.engine, cnf, limits.query_ms).ask(-literal) is Answer.UNSAT
    return ClaimResult(
        "P-START",
        CLAIMS["P-START"],
        Verdict.PROVED if ok else Verdict.UNKNOWN,
        1,
        () if ok else ("restart",),
        time.monotonic() - began,
    )
