"""From a layout and its controller to one verdict per claim.

1. The strengthening invariants hold at the restart and are kept by every step: an invariant that is not kept is
   dropped, and the rest is checked again without it, until what remains is inductive.
2. Every claim follows from the remaining invariants in every step.
3. What does not follow is searched for from the restart: a run found is REFUTED; otherwise UNKNOWN.
Every solver answer other than UNSAT counts against the claim.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum

from interlock.logic.expr import Expr, conj, neg, var
from interlock.proof.encode import Cnf
from interlock.proof.engines import Answer, solver
from interlock.proof.invariants import CLAIMS, Claim, Facts, Invariant, claims, strengthening
from interlock.proof.parts import Decision, decide
from interlock.proof.search import search
from interlock.proof.story import Story, tell
from interlock.proof.system import System
from interlock.proof.witness import Witness, witnesses

Progress = Callable[[str, int, int], None]


class Verdict(StrEnum):
    """UNKNOWN is never green."""

    PROVED = "PROVED"
    REFUTED = "REFUTED"
    UNKNOWN = "UNKNOWN"


@dataclass(frozen=True)
class ClaimResult:
    """One claim over all its places."""

    id: str
    sentence: str
    verdict: Verdict
    places: int
    open: tuple[str, ...]
    seconds: float
    story: Story | None = None


@dataclass(frozen=True)
class ProofResult:
    """All claims, the invariants that carried them, and the witnesses."""

    claims: tuple[ClaimResult, ...]
    invariants: int
    dropped: tuple[str, ...]
    obligations: int
    witnesses: tuple[Witness, ...]
    seconds: float

    @property
    def proved(self) -> bool:
        """Whether every claim is proved and every route has its witness."""
        return all(c.verdict is Verdict.PROVED for c in self.claims) and all(w.ok for w in self.witnesses)


@dataclass(frozen=True)
class Limits:
    """How long to try."""

    query_ms: int = 20_000
    engine: str = "minisat"
    jobs: int = 1
    search_depth: int = 16
    search_s: float = 60.0


def quiet(stage: str, done: int, total: int) -> None:
    """A progress report that goes nowhere."""
    del stage, done, total


def inductive(system: System, limits: Limits, progress: Progress = quiet) -> tuple[list[Invariant], list[str], int]:
    """The strengthening invariants that hold at the restart and are kept by every step, the dropped ones, and the
    number of obligations decided."""
    kept = list(strengthening(Facts(system)))
    obligations = len(kept)
    kept, dropped = _base(system, kept, limits)
    while True:
        goals = [system.after(i.expr) for i in kept]
        proved = _decide(system, kept, goals, limits, "invariants", progress)
        obligations += len(kept)
        failed = [i for i, d in zip(kept, proved, strict=True) if not d.follows]
        if not failed:
            return kept, dropped, obligations
        dropped += [f"{i.id} at {i.place}" for i in failed]
        gone = set(map(id, failed))
        kept = [i for i in kept if id(i) not in gone]


def _decide(
    system: System, kept: Sequence[Invariant], goals: Sequence[Expr], limits: Limits, stage: str, progress: Progress
) -> list[Decision]:
    """Which goals follow, in one step, from the invariants."""
    hypotheses = [i.expr for i in kept]

    def report(done: int, total: int) -> None:
        progress(stage, done, total)

    return decide(system, hypotheses, goals, limits.engine, limits.query_ms, limits.jobs, report)


def prove(system: System, limits: Limits | None = None, progress: Progress = quiet) -> ProofResult:
    """One verdict per claim."""
    limits = limits or Limits()
    began = time.monotonic()
    kept, dropped, obligations = inductive(system, limits, progress)
    wanted = claims(Facts(system))
    results = _claims(system, kept, wanted, limits, progress)
    obligations += len(wanted) + 1
    runs = witnesses(system)
    results.append(_start(system, limits))
    order = list(CLAIMS)
    results.sort(key=lambda r: order.index(r.id))
    return ProofResult(tuple(results), len(kept), tuple(dropped), obligations, runs, time.monotonic() - began)


def _base(system: System, invariants: list[Invariant], limits: Limits) -> tuple[list[Invariant], list[str]]:
    cnf = Cnf()
    cnf.require(system.initial)
    goals = [cnf.literal(i.expr) for i in invariants]
    sat = solver(limits.engine, cnf, limits.query_ms)
    if sat.ask() is not Answer.SAT:
        raise RuntimeError("the restart states contradict each other")
    kept, dropped = [], []
    for inv, lit in zip(invariants, goals, strict=True):
        if sat.ask(-lit) is Answer.UNSAT:
            kept.append(inv)
        else:
            dropped.append(f"{inv.id} at {inv.place} (at the restart)")
    return kept, dropped


def open_claims(
    system: System, kept: list[Invariant], wanted: tuple[Claim, ...], limits: Limits, progress: Progress = quiet
) -> dict[str, list[Claim]]:
    """The claims that do not follow from the invariants."""
    return decided(system, kept, wanted, limits, progress)[0]


def decided(
    system: System, kept: list[Invariant], wanted: tuple[Claim, ...], limits: Limits, progress: Progress
) -> tuple[dict[str, list[Claim]], dict[str, float]]:
    """The open claims by id, and the seconds spent on each id."""
    open_: dict[str, list[Claim]] = {}
    seconds: dict[str, float] = {}
    found = _decide(system, kept, [c.expr for c in wanted], limits, "claims", progress)
    for c, d in zip(wanted, found, strict=True):
        seconds[c.id] = seconds.get(c.id, 0.0) + d.seconds
        if not d.follows:
            open_.setdefault(c.id, []).append(c)
    return open_, seconds


def _claims(
    system: System, kept: list[Invariant], wanted: tuple[Claim, ...], limits: Limits, progress: Progress
) -> list[ClaimResult]:
    open_, seconds = decided(system, kept, wanted, limits, progress)
    places: dict[str, int] = {}
    for c in wanted:
        places[c.id] = places.get(c.id, 0) + 1
    out = []
    for id_ in CLAIMS:
        if id_ == "P-START":
            continue
        verdict, story = Verdict.PROVED, None
        if id_ in open_:
            progress(f"searching a counterexample to {id_}", 0, 1)
            run = search(system, open_[id_], limits.search_depth, limits.search_s)
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
    out: list[Expr] = [neg(var(n)) for n in sym.command.values()]
    out += [neg(sym.shows(g.id)) for g in system.layout.signals]
    out += [var(n) for n in sym.restart.values()]
    return conj(out)


def _start(system: System, limits: Limits) -> ClaimResult:
    """The restart: nothing commanded, all signals at stop, every section locked."""
    began = time.monotonic()
    cnf = Cnf()
    cnf.require(system.initial)
    lit = cnf.literal(start_claim(system))
    ok = solver(limits.engine, cnf, limits.query_ms).ask(-lit) is Answer.UNSAT
    return ClaimResult(
        "P-START",
        CLAIMS["P-START"],
        Verdict.PROVED if ok else Verdict.UNKNOWN,
        1,
        () if ok else ("restart",),
        time.monotonic() - began,
    )
