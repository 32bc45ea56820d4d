"""What becomes of a weakening: which claims fail, and a train movement to harm where the search finds one.

**Theorem.**  A mutant is called redundant exactly if base, step and consequence hold for it as for a controller: then
every claim follows, since other conditions protect (`induction/inductive.py`).  Otherwise it is *killed*: a claim does
not follow by induction, which need not mean harm (strict), or a run from a restart violates one
(`induction/search.py`), which is told as a story.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import StrEnum

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.proof.claims import Facts, claims
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.inductive import inductive, open_claims
from interlock.proof.induction.search import search
from interlock.proof.induction.story import tell
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable


class Fate(StrEnum):
    """What became of a mutant."""

    KILLED = "killed by a train movement"
    STRICT = "killed, no movement found"
    REDUNDANT = "redundant"


@dataclass(frozen=True)
class Outcome:
    """One mutant's fate: the claims that fail, and a story when one was found."""

    kind: str
    place: str
    fate: Fate
    claims: tuple[str, ...]
    story: tuple[str, ...]


def run_mutants(
    layout: Layout,
    table: InterlockingTable,
    sample: int,
    limits: Limits,
    report: Callable[[Outcome], None] = lambda outcome: None,
    only: tuple[str, ...] = (),
) -> Iterator[Outcome]:
    """Up to `sample` evenly spread mutants of each kind (0: all), each judged when it is asked for."""
    for kind in KINDS:
        if only and kind.name not in only:
            continue
        mutants = list(kind.make(layout, table))
        step = max(1, -(-len(mutants) // sample)) if sample else 1
        for place, controller in mutants[::step]:
            outcome = judge(layout, kind.name, place, controller, limits)
            report(outcome)
            yield outcome


def judge(layout: Layout, kind: str, place: str, controller: Controller, limits: Limits) -> Outcome:
    """Prove a mutant; when a claim fails, look for the train movement."""
    system = System(layout, controller)
    kept, _, _ = inductive(system, limits)
    wanted = claims(Facts(system))
    open_ = open_claims(system, kept, wanted, limits)
    initial = {s.name: s.initial for s in controller.state}
    at_restart = [n for n in system.loop.controller.symbols.sections.restart.values() if not initial[n]]
    failing = [*open_, *(["P-START"] if at_restart else [])]
    if not failing:
        return Outcome(kind, place, Fate.REDUNDANT, (), ())
    run = search(system, [c for cs in open_.values() for c in cs], limits.search_depth, limits.search_s)
    if run is None:
        return Outcome(kind, place, Fate.STRICT, tuple(failing), ())
    order = [run.claim.id, *(f for f in failing if f != run.claim.id)]
    return Outcome(kind, place, Fate.KILLED, tuple(order), tell(system.loop, run).steps)
