"""Prove a layout's controller, and that the text that would be emitted equals it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial

from interlock import __version__
from interlock.app.check import Checked, audited, derive_file, second_opinion
from interlock.app.kept import Kept
from interlock.app.texts import TextVerdict, writers
from interlock.diag import Diagnostic, Severity
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.invariants import Facts, claims
from interlock.proof.limits import Limits
from interlock.proof.pool import Begun, run
from interlock.proof.runner import ClaimResult, Progress, ProofResult, Verdict, if_proved, prove, quiet
from interlock.proof.system import System
from interlock.proof.trace import itf


@dataclass(frozen=True)
class Proved:
    """A checked layout with its proof (None when it has errors)."""

    checked: Checked
    proof: ProofResult | None = None
    texts: tuple[TextVerdict, ...] = ()
    traces: tuple[tuple[str, str], ...] = ()
    """For each refuted claim its name and the ITF trace of its counterexample."""
    files: tuple[str, ...] = ()
    notes: tuple[Diagnostic, ...] = ()

    @property
    def green(self) -> bool:
        """Everything proved; UNKNOWN is never green."""
        return (
            self.proof is not None
            and self.proof.proved
            and self.text_equal
            and not any(d.severity is Severity.ERROR for d in self.notes)
        )

    @property
    def text_equal(self) -> bool:
        """Every text that was compared equals the controller, and there was one."""
        return bool(self.texts) and all(t.equal for t in self.texts)

    @property
    def unknown(self) -> bool:
        """Something could not be decided, and nothing is refuted."""
        verdicts = {c.verdict for c in self.proof.claims} if self.proof is not None else set()
        return Verdict.UNKNOWN in verdicts and Verdict.REFUTED not in verdicts


def prove_file(path: str, limits: Limits | None = None, progress: Progress = quiet) -> Proved:
    """Check a file and prove its controller and the text that would be emitted."""
    return prove_derived(derive_file(path), limits, progress, keep=False)[0]


def prove_derived(
    derived: Checked, limits: Limits | None, progress: Progress, dialects: Sequence[str] = (), keep: bool = True
) -> tuple[Proved, dict[str, bytes]]:
    """The proof of a layout, and its texts: the portable one, the runtime, and what other dialects are asked for; each
    is read back and compared, and given back if `keep`.  The audit, the texts and the proof are done beside each other.
    """
    if not derived.ok or derived.layout is None or derived.table is None:
        return Proved(derived), {}
    layout, limits = derived.layout, limits or Limits()
    with ExitStack() as beside:
        audit = beside.enter_context(Begun([partial(second_opinion, derived)], limits.jobs))
        controller = lower(layout, derived.table)

        def begin(head: list[str]) -> Begun:
            return beside.enter_context(Begun(writers(layout.bare, controller, head, dialects, keep), limits.jobs))

        kept = None
        if limits.cache.folder is not None and not keep:
            kept = beside.enter_context(Kept(limits, controller))
        elif not keep:  # a text that is only compared needs no heading, and can be begun now
            texts = begin([])
        system = System(layout, controller)
        if kept is not None:
            kept.about(system)
        wanted = claims(Facts(system))
        good = kept.look(wanted) if kept is not None else None
        if good is not None:
            checked = audited(derived, audit.results()[0])
            return Proved(checked, *(good if checked.ok else ())), {}
        hoped = _header(layout, if_proved(wanted), True) if keep else []
        if keep or kept is not None:
            texts = begin(hoped)
        proof = prove(system, limits, progress, wanted)
        checked = audited(derived, audit.results()[0])
        if not checked.ok:
            return Proved(checked), {}
        header = _header(layout, proof.claims, proof.proved) if keep else []
        progress("comparing the text", 0, 1)
        if header == hoped:
            written = texts.results()
        else:
            written = run(writers(layout.bare, controller, header, dialects, keep), limits.jobs)
        if kept is not None:
            kept.keep(proof, tuple(verdict for verdict, _ in written))
    verdicts = [verdict for verdict, _ in written]
    files = {name: text for _, those in written for name, text in those.items()}
    notes = list(_notes(checked, proof))
    for t in verdicts:
        for d in t.differences:
            message = f"{t.file} and the controller differ at {d.name}: {d.text}"
            notes.append(Diagnostic("IL5001", Severity.ERROR, message))
    return Proved(checked, proof, tuple(verdicts), _traces(system, proof), (), tuple(notes)), files


def _traces(system: System, proof: ProofResult) -> tuple[tuple[str, str], ...]:
    stories = [c.story for c in proof.claims if c.story is not None]
    if not stories:
        return ()
    from interlock.emit.drawing import plan_svg  # a proof needs no picture

    plan = plan_svg(system.layout)
    return tuple((s.claim, itf(system, s, plan)) for s in stories)


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
    for w in proof.witnesses:
        if not w.ok:
            out.append(
                Diagnostic(
                    "IL4006",
                    Severity.ERROR,
                    f"route {w.route} cannot be driven: {w.text}",
                    span,
                    "check lengths, directions and conditions on its way",
                )
            )
    return out


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
        head.insert(0, "NOT PROVED: for study only, never for a railway")
    return head


def claims_json(results: Sequence[ClaimResult]) -> list[dict[str, object]]:
    """Verdicts as data, without timings, so that the bytes are reproducible."""
    return [
        {"id": c.id, "verdict": str(c.verdict), "places": c.places, "open": list(c.open), "sentence": c.sentence}
        for c in results
    ]


def run_many(work: Callable[..., Proved], calls: Sequence[tuple[object, ...]], jobs: int) -> list[Proved]:
    """Several layouts on several processes; the results are in the order of the calls."""
    from concurrent.futures import ProcessPoolExecutor

    with ProcessPoolExecutor(min(jobs, len(calls))) as pool:
        return [f.result() for f in [pool.submit(work, *c) for c in calls]]
