"""Prove a layout's controller, and that the text that would be emitted equals it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass

from interlock import __version__
from interlock.app.check import Checked, check_file
from interlock.diag import Diagnostic, Severity
from interlock.emit.drawing import plan_svg
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.model.elements import TelegramForm
from interlock.model.layout import Layout
from interlock.proof.cabinet import compare_program
from interlock.proof.python_text import compare_runtime
from interlock.proof.runner import Limits, Progress, ProofResult, Verdict, prove, quiet
from interlock.proof.system import System
from interlock.proof.telegram import compare_telegram
from interlock.proof.trace import itf
from interlock.proof.translation import Difference, compare_dialect
from interlock.st.dialects import DIALECTS, write_st
from interlock.st.printer import print_unit
from interlock.st.program import io_program
from interlock.st.telegram import telegram_unit


@dataclass(frozen=True)
class TextVerdict:
    """Whether an emitted text (a file, or a folder of files of one dialect) equals the controller."""

    file: str
    differences: tuple[Difference, ...]

    @property
    def equal(self) -> bool:
        """Proved equal, output by output."""
        return not self.differences


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
    checked = check_file(path)
    if not checked.ok:
        return Proved(checked)
    return prove_checked(checked, limits, progress)[0]


def prove_checked(
    checked: Checked, limits: Limits | None, progress: Progress, dialects: Sequence[str] = ()
) -> tuple[Proved, dict[str, bytes]]:
    """The proof of a checked layout, and its texts: the portable one, the runtime, and what other dialects are asked
    for; each is read back and compared."""
    assert checked.layout is not None and checked.table is not None
    controller = lower(checked.layout, checked.table)
    system = System(checked.layout, controller)
    proof = prove(system, limits, progress)
    header = _header(checked.layout, proof)
    files: dict[str, bytes] = {}
    verdicts = []
    wanted = [d for d in DIALECTS if d.name == "iec" or d.name in dialects]
    for n, dialect in enumerate(wanted):
        progress("comparing the text", n, len(wanted) + 1)
        written = write_st(controller, dialect, header)
        found = compare_dialect(controller, dialect, written)
        folder = f"st/{dialect.name}"
        name = f"{folder}/{next(iter(written))}" if len(written) == 1 else folder
        verdicts.append(TextVerdict(name, found.differences))
        files |= {f"{folder}/{n}": text.encode() for n, text in written.items()}
    sent = tuple(controller.symbols.trailed)  # the machines that are driven
    allocation = allocate(checked.layout, controller)
    mapping, place = print_unit(io_program(controller, allocation, header)), f"st/iec/{checked.layout.name}_io.st"
    verdicts.append(TextVerdict(place, compare_program(controller, allocation, mapping)))
    files[place] = mapping.encode()
    if checked.layout.telegram is not TelegramForm.NONE and sent:
        tagged = checked.layout.telegram is TelegramForm.TAGGED
        unit = telegram_unit(checked.layout.name, sent, tagged, header)
        text, place = print_unit(unit), f"st/iec/{checked.layout.name}_telegram.st"
        verdicts.append(TextVerdict(place, compare_telegram(checked.layout.name, sent, tagged, text)))
        files[place] = text.encode()
    runtime = runtime_py(controller, header)
    verdicts.append(TextVerdict("runtime.py", compare_runtime(controller, runtime).differences))
    files["runtime.py"] = runtime.encode()
    notes = list(_notes(checked, proof))
    for t in verdicts:
        for d in t.differences:
            message = f"{t.file} and the controller differ at {d.name}: {d.text}"
            notes.append(Diagnostic("IL5001", Severity.ERROR, message))
    stories = [c.story for c in proof.claims if c.story is not None]
    plan = plan_svg(checked.layout) if stories else ""
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
