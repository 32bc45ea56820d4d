"""Prove a layout's controller, and that the text that would be emitted equals it."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass

from interlock import __version__
from interlock.app.check import Checked, check_file
from interlock.diag import Diagnostic, Severity
from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.runner import Limits, Progress, ProofResult, Verdict, prove, quiet
from interlock.proof.system import System
from interlock.proof.translation import compare_st
from interlock.st.lower import lower_st
from interlock.st.printer import print_unit


@dataclass(frozen=True)
class Proved:
    """A checked layout with its proof (None when it has errors)."""

    checked: Checked
    proof: ProofResult | None = None
    text_equal: bool | None = None
    text_differences: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    notes: tuple[Diagnostic, ...] = ()

    @property
    def green(self) -> bool:
        """Everything proved; UNKNOWN is never green."""
        return (
            self.proof is not None
            and self.proof.proved
            and self.text_equal is not False
            and not any(d.severity is Severity.ERROR for d in self.notes)
        )

    @property
    def unknown(self) -> bool:
        """Something could not be decided, and nothing is refuted."""
        verdicts = {c.verdict for c in self.proof.claims} if self.proof is not None else set()
        return Verdict.UNKNOWN in verdicts and Verdict.REFUTED not in verdicts


def prove_file(path: str, limits: Limits | None = None, progress: Progress = quiet) -> Proved:
    """Check a file and prove its controller and the text that would be emitted."""
    checked = check_file(path)
    if not checked.ok:
        return Proved(checked)
    return prove_checked(checked, limits, progress)[0]


def prove_checked(checked: Checked, limits: Limits | None, progress: Progress) -> tuple[Proved, dict[str, bytes]]:
    assert checked.layout is not None and checked.table is not None
    controller = lower(checked.layout, checked.table)
    system = System(checked.layout, controller)
    proof = prove(system, limits, progress)
    progress("comparing the text", 0, 1)
    texts = _texts(checked.layout, controller, proof)
    translation = compare_st(controller, texts[f"st/iec/{checked.layout.name}.st"].decode())
    notes = list(_notes(checked, proof))
    notes += [
        Diagnostic("IL5001", Severity.ERROR, f"text and controller differ at {d.name}: {d.text}")
        for d in translation.differences
    ]
    return Proved(
        checked, proof, translation.proved, tuple(d.name for d in translation.differences), (), tuple(notes)
    ), texts


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


def _header(layout: Layout, proof: ProofResult) -> list[str]:
    claims = json.dumps(claims_json(proof), sort_keys=True)
    head = [
        f"Interlocking {layout.name}, made by interlock {__version__}. Standard program, not certified.",
        "Not an F-program.",
        f"layout {layout.digest}",
        f"claims {hashlib.sha256(claims.encode()).hexdigest()}",
    ]
    if not proof.proved:
        head.insert(0, "NOT PROVED: for study only, never for a railway")
    return head


def claims_json(proof: ProofResult) -> list[dict[str, object]]:
    """Verdicts as data, without timings, so that the bytes are reproducible."""
    return [
        {"id": c.id, "verdict": str(c.verdict), "places": c.places, "open": list(c.open), "sentence": c.sentence}
        for c in proof.claims
    ]


def _texts(layout: Layout, controller: Controller, proof: ProofResult) -> dict[str, bytes]:
    header = _header(layout, proof)
    return {
        f"st/iec/{layout.name}.st": print_unit(lower_st(controller, header)).encode(),
        "runtime.py": runtime_py(controller, header).encode(),
    }
