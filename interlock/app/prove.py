"""Prove a layout's controller, and that the text that would be emitted equals it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial

from interlock import __version__
from interlock.app.check import Checked, audited, derive_file, second_opinion
from interlock.app.texts import TextVerdict, writers
from interlock.diag import Diagnostic, Severity
from interlock.emit.drawing import plan_svg
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
        if not keep:  # a text that is only compared need not tell what is proved, and can be begun now
            texts = beside.enter_context(
                Begun(writers(layout, controller, _origin(layout), dialects, keep), limits.jobs)
            )
        system = System(layout, controller)
        wanted = claims(Facts(system))
        hoped = _header(layout, if_proved(wanted), True)
        if keep:
            texts = beside.enter_context(Begun(writers(layout, controller, hoped, dialects, keep), limits.jobs))
        proof = prove(system, limits, progress, wanted)
        checked = audited(derived, audit.results()[0])
        if not checked.ok:
            return Proved(checked), {}
        header = _header(layout, proof.claims, proof.proved)
        progress("comparing the text", 0, 1)
        if header == hoped or not keep:
            written = texts.results()
        else:
            written = run(writers(layout, controller, header, dialects, keep), limits.jobs)
    verdicts = [verdict for verdict, _ in written]
    files = {name: text for _, those in written for name, text in those.items()}
    notes = list(_notes(checked, proof))
    for t in verdicts:
        for d in t.differences:
            message = f"{t.file} and the controller differ at {d.name}: {d.text}"
            notes.append(Diagnostic("IL5001", Severity.ERROR, message))
    stories = [c.story for c in proof.claims if c.story is not None]
    plan = plan_svg(layout) if stories else ""
    traces = tuple((s.claim, itf(system, s, plan)) for s in stories)
    return Proved(checked, proof, tuple(verdicts), traces, (), tuple(notes)), files


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
