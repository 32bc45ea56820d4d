"""From a layout and its controller to one verdict per claim.

1. The strengthening invariants hold at the restart and are kept by every step (`induction/inductive.py`); each claim
   follows from those that are.
2. What does not follow is searched for from the restart: a run found is REFUTED; otherwise UNKNOWN.
3. Every route is driven by a witness run.

Every solver answer other than UNSAT counts against the claim.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence
from functools import partial

from interlock.logic.expr import TRUE, Expr, conj, neg, settled, var
from interlock.model.elements import Position
from interlock.proof.claims import CLAIMS, Claim, Facts, claims, strengthening
from interlock.proof.engines import Answer, solver
from interlock.proof.engines.batch import Decision
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.pool import Begun, Task
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.induction.inductive import decided, holding_at_restart, keep, left_open, restart_values
from interlock.proof.induction.parts import Goal, Inquiry
from interlock.proof.induction.search import search
from interlock.proof.induction.story import tell
from interlock.proof.induction.verdict import ClaimResult, Progress, ProofResult, Verdict, quiet
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.system.transition import System
from interlock.proof.witnesses.routes import witnesses


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
    inquiry = Inquiry(system.relation, system.where, [i.expr for i in found], goals, limits)
    questions = inquiry.first()
    others: list[Task] = [partial(witnesses, system.loop), partial(holding_at_restart, system, found, limits)]
    with Begun([*others, partial(_start, system, limits)], min(limits.jobs - 1, 1)) as beside:
        inquiry.settle(questions, partial(progress, "proving"))
        decisions = inquiry.finish(partial(progress, "proving"))
        runs, at_restart, start = beside.results()
    steps = [d.follows for d in decisions[: len(found)]]
    kept, dropped, obligations = keep(system, found, at_restart, steps, limits, progress)
    verdicts = decisions[len(found) :]
    if dropped:
        verdicts = decided(system, kept, [Goal(c.expr) for c in wanted], limits, "claims", progress)
    claimed = [*_claims(system, wanted, verdicts, limits, progress), start]
    order = list(CLAIMS)
    claimed.sort(key=lambda r: order.index(r.id))
    obligations += len(found) + len(wanted) + 1
    return ProofResult(tuple(claimed), len(kept), tuple(dropped), obligations, runs, time.monotonic() - began)


def if_proved(wanted: Sequence[Claim]) -> tuple[ClaimResult, ...]:
    """The results if every claim is proved."""
    places = Counter(c.id for c in wanted) | Counter({"P-START": 1})
    return tuple(ClaimResult(i, CLAIMS[i], Verdict.PROVED, places[i], (), 0.0) for i in CLAIMS)


def _claims(
    system: System, wanted: Sequence[Claim], decisions: Sequence[Decision], limits: Limits, progress: Progress
) -> list[ClaimResult]:
    open_ = left_open(wanted, decisions)
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
            story = tell(system.loop, run) if run is not None else None
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


def start_claim(loop: ClosedLoop) -> Expr:
    """P-START: at the restart nothing is commanded, all signals show stop, every section is locked, and no train has
    gone on or been missed."""
    sym = loop.controller.symbols
    devices = loop.layout.machines.device
    commands = [*sym.machines.command.items(), *sym.machines.drive.items()]
    out: list[Expr] = [neg(var(n)) for (m, x), n in commands if m not in devices or x is Position.NORMAL]
    out += [var(n) for n in sym.aspects.stop.values()]
    out += [neg(sym.aspects.signal(g.id, shunt)) for g in loop.layout.signalling.signals for shunt in (False, True)]
    out += [var(n) for n in sym.sections.restart.values()]
    out += [neg(var(n)) for n in (*sym.sections.passed.values(), *sym.sections.stale.values())]
    return conj(out)


def _start(system: System, limits: Limits) -> ClaimResult:
    """The restart: nothing commanded, all signals at stop, every section locked."""
    began = time.monotonic()
    wanted = start_claim(system.loop)
    ok = settled(wanted, {name: x is TRUE for name, x in restart_values(system.initial)[0].items()})
    if not ok:
        cnf = Cnf()
        cnf.require(system.initial.whole)
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
