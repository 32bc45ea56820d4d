"""A proof that is made: the controller of a table, its proof, and its texts.  Here the solvers are loaded."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack

from interlock import __version__
from interlock.app.check import Checked, audited
from interlock.app.proved import Proved
from interlock.app.texts import writers
from interlock.audit import Finding
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Severity
from interlock.logic.expr import interning
from interlock.logic.lower import lower
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.proof.claims import Facts, claims
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.pool import Begun, run
from interlock.proof.induction.trace import itf
from interlock.proof.induction.verdict import ClaimResult, Progress, ProofResult, Verdict
from interlock.proof.prover import if_proved, prove
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable


@dataclass(frozen=True)
class Wanted:
    """What is to be made: a proof with its texts, in what dialects beside the portable one; `keep`: the texts are given
    back, with their heading."""

    limits: Limits
    progress: Progress
    dialects: Sequence[str]
    keep: bool


def make(
    derived: Checked, layout: Layout, table: InterlockingTable, audit: Callable[[], Sequence[Finding]], wanted: Wanted
) -> tuple[Proved, dict[str, bytes]]:
    """Prove the controller of a layout's table beside its audit, and compare each text that is written with it."""
    limits, keep = wanted.limits, wanted.keep
    with interning(), ExitStack() as beside:
        controller = lower(layout, table)

        def begin(head: list[str]) -> Begun:
            tasks = writers(layout.bare, controller, head, wanted.dialects, keep)
            return beside.enter_context(Begun(tasks, min(limits.jobs - 1, 1)))

        if not keep:  # a text that is only compared needs no heading, and can be begun now
            texts = begin([])
        system = System(layout, controller)
        claimed = claims(Facts(system))
        hoped = _header(layout, if_proved(claimed), True) if keep else []
        if keep:
            texts = begin(hoped)
        proof = prove(system, limits, wanted.progress, claimed)
        wanted.progress("auditing the table", 0, 0)
        checked = audited(derived, audit())
        if not checked.ok:
            return Proved(checked), {}
        header = _header(layout, proof.claims, proof.proved) if keep else []
        tasks = writers(layout.bare, controller, header, wanted.dialects, keep)
        count = 0

        def compared(_: int) -> None:
            nonlocal count
            count += 1
            wanted.progress("comparing the texts", count, len(tasks))

        wanted.progress("comparing the texts", 0, len(tasks))
        written = texts.results(compared) if header == hoped else run(tasks, limits.jobs, compared)
    verdicts = [verdict for verdict, _ in written]
    files = {name: text for _, those in written for name, text in those.items()}
    notes = list(_notes(checked, proof))
    for t in verdicts:
        for d in t.differences:
            message = f"{t.file} and the controller differ at {d.name}: {d.text}"
            notes.append(Diagnostic("IL5001", Severity.ERROR, message))
    return Proved(checked, proof, tuple(verdicts), _traces(layout, system, proof), (), tuple(notes)), files


def _traces(layout: Layout, system: System, proof: ProofResult) -> tuple[tuple[str, str], ...]:
    stories = [c.story for c in proof.claims if c.story is not None]
    if not stories:
        return ()
    from interlock.emit.drawing import plan_svg  # a proof needs no picture

    plan = plan_svg(layout)
    return tuple((s.claim, itf(system.loop, system.relation.state, s, layout.digest, plan)) for s in stories)


def _notes(checked: Checked, proof: ProofResult) -> list[Diagnostic]:
    span = checked.source.at("name")
    out = []
    for c in proof.claims:
        where = ", ".join(c.open[:6]) + (" ..." if len(c.open) > 6 else "")
        if c.verdict is Verdict.REFUTED:
            out.append(
                Diagnostic(
                    "IL5001",
                    Severity.ERROR,
                    f"{c.id} is refuted at {where}: {c.sentence}",
                    span,
                    "read the counterexample below; change the layout, or remove the waiver",
                )
            )
        elif c.verdict is Verdict.UNKNOWN:
            out.append(
                Diagnostic(
                    "IL5002",
                    Severity.ERROR,
                    f"{c.id} could not be decided at {where}: {c.sentence}",
                    span,
                    "nothing may be concluded; try `--search-depth` or report the layout",
                )
            )
    return [*out, *_undriven(checked, proof)]


def _undriven(checked: Checked, proof: ProofResult) -> Iterator[Diagnostic]:
    """Routes that no run drives."""
    assert checked.table is not None
    entry: dict[str, SignalId] = {str(r.id): r.entry for r in checked.table.routes}
    for w in (w for w in proof.witnesses if not w.ok):
        where = checked.source.at("signals", entry[w.route])
        fix = "check lengths, directions and conditions on its way"
        yield Diagnostic("IL4006", Severity.ERROR, f"route {w.route} cannot be driven: {w.text}", where, fix)


NOT_PROVED = "NOT PROVED: for study only, never for a railway"
"""The mark of what people read of a layout of which not everything is proved."""


def _origin(layout: Layout) -> list[str]:
    return [
        f"Interlocking {layout.name}, made by interlock {__version__}. Standard program, not certified.",
        "Not an F-program.",
        f"layout {layout.digest}",
    ]


def _header(layout: Layout, results: Sequence[ClaimResult], proved: bool) -> list[str]:
    told = json.dumps(claims_json(results), sort_keys=True)
    head = [*_origin(layout), f"claims {hashlib.sha256(told.encode()).hexdigest()}"]
    if not proved:
        head.insert(0, NOT_PROVED)
    return head


def claims_json(results: Sequence[ClaimResult]) -> list[dict[str, object]]:
    """Verdicts as data, without timings, so that the bytes are reproducible."""
    return [
        {"id": c.id, "verdict": str(c.verdict), "places": c.places, "open": list(c.open), "sentence": c.sentence}
        for c in results
    ]
