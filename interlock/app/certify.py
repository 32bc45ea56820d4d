"""Certificates: the proof of a layout as files that `interlock verify` checks again."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from interlock.app.check import Checked, derive_file
from interlock.app.compile import ELSEWHERE, build_derived, finish, left
from interlock.app.proved import Proved
from interlock.app.texts import C99
from interlock.app.writing import written_for
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Severity
from interlock.emit.bundle import MANIFEST as OUTPUTS
from interlock.emit.bundle import differences, not_replaced, strangers, write_folder
from interlock.logic.expr import interning
from interlock.logic.lower import lower
from interlock.proof.certificate.bundle import MANIFEST, NEEDED, PROOF, SYSTEM, manifest_text, proof_bytes, system_text
from interlock.proof.certificate.engine import prove_locally
from interlock.proof.certificate.facts import FactBase
from interlock.proof.certificate.needed import needs, needs_text
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.induction.verdict import Progress, quiet
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.verify import Rejected, check_files, verify


@dataclass(frozen=True)
class Certified:
    """What became of a layout's certificate; `summary` is empty when there is none."""

    proved: Proved
    summary: str = ""
    notes: tuple[Diagnostic, ...] = ()
    seconds: float = 0.0
    """What it took by the clock on the wall."""

    @property
    def ok(self) -> bool:
        """A certificate that was accepted."""
        return bool(self.summary) and not any(n.severity is Severity.ERROR for n in self.notes)


def certify_file(
    path: str,
    outputs: Path,
    proofs: Path,
    check: bool = False,
    progress: Progress = quiet,
) -> Certified:
    """Write (or check) the certificate of a layout whose outputs are current, in whatever dialects they are there."""
    began = time.monotonic()
    return replace(_certified(path, outputs, proofs, check, progress), seconds=time.monotonic() - began)


def _no_outputs(path: str, outputs: Path, derived: Checked, name: str) -> Certified:
    """Nothing is there to which a certificate could be tied."""
    said = f"{outputs / name}: there are no outputs, to which a certificate is tied"
    fix = f"run `interlock compile {path} -o {outputs}`"
    note = Diagnostic("IL5003", Severity.ERROR, said, derived.source.at("name"), fix)
    return Certified(Proved(derived), notes=(note,))


def _no_file(path: str, derived: Checked) -> Certified:
    """What can be read once (a pipe, a device) cannot be read again beside its certificate."""
    said = f"{path} is no file, and a certificate is tied to a file"
    note = Diagnostic("IL5007", Severity.ERROR, said, derived.source.at("name"), "save the layout as a file")
    return Certified(Proved(derived), notes=(note,))


def _real(path: str) -> str:
    """A file by its own name, in the folder where it lies."""
    folder, name = os.path.split(path)
    return os.path.join(os.path.realpath(folder), name)


def _tied(path: str, checked: Checked, outputs: Path, emitted: Mapping[str, bytes], target: Path) -> dict[str, bytes]:
    """The layout, as it was read, and what of its outputs a certificate names: by where it lies, seen from there.
    Raises `Rejected` for a name that stands in no manifest."""
    seat = os.path.realpath(target)  # `..` leads up from where a link leads
    found = {os.path.relpath(_real(path), seat): checked.source.data}
    # the texts themselves, and the manifest, which ties every other output by its digest
    own = [n for n in emitted if n.startswith(("st/", f"{C99}/")) or n == OUTPUTS]
    found |= {os.path.relpath(os.path.realpath(outputs / n), seat): emitted[n] for n in own}
    for name in found:
        if not name.isascii() and name.encode("utf-8", "replace").decode() != name:
            raise Rejected(f"a manifest cannot name {name!r}, which is not UTF-8: give it, or its folder, another name")
    return found


@interning()
def _certified(path: str, outputs: Path, proofs: Path, check: bool, progress: Progress) -> Certified:
    progress("deriving", 0, 0)
    derived = derive_file(path)
    if derived.ok and not Path(path).is_file():
        return _no_file(path, derived)
    if derived.ok and derived.layout is not None and not (outputs / derived.layout.name / OUTPUTS).exists():
        return _no_outputs(path, outputs, derived, derived.layout.name)
    others = written_for(outputs / derived.layout.name) if derived.layout is not None else ()
    proved, files = build_derived(derived, progress=progress, dialects=others)
    layout, table = proved.checked.layout, proved.checked.table
    if not proved.green or layout is None or table is None:
        return Certified(proved)
    span = proved.checked.source.at("name")
    emitted = finish(proved.checked, files)
    stale = differences(outputs / layout.name, emitted)
    if stale:
        note = Diagnostic(
            "IL5003",
            Severity.ERROR,
            f"{outputs / layout.name}: {stale[0]}",
            span,
            f"run `interlock compile {path} -o {outputs}`",
        )
        return Certified(proved, notes=(note,))
    controller = lower(layout, table)
    system = System(layout, controller)
    facts = Facts(system)
    base = FactBase(system.relation, system.initial, strengthening(facts), claims(facts), start_claim(system.loop))
    target = proofs / layout.name
    texts = {SYSTEM: system_text(base).encode()}
    if not check and (found := strangers(target)):
        note = Diagnostic("IL5004", Severity.ERROR, not_replaced(target, found), span, ELSEWHERE)
        return Certified(proved, notes=(note,))
    try:
        tied = _tied(path, proved.checked, outputs / layout.name, emitted, target)
        if not check:
            local = prove_locally(base, lambda done, total: progress("obligations", done, total))
            if local.open:
                g = local.open[0]
                note = Diagnostic("IL5002", Severity.ERROR, f"no certificate: {g.kind} of {g.source} is open", span)
                return Certified(proved, notes=(note,))
            texts[PROOF] = proof_bytes(local)
            texts[NEEDED] = needs_text(needs(local, controller)).encode()
            manifest = manifest_text(layout.name, {**texts, **tied})
            write_folder(target, {**texts, MANIFEST: manifest.encode()})
        progress("verifying the certificate", 0, 0)
        there = check_files(target)
        summary = verify(target, there)
        if there[SYSTEM] != texts[SYSTEM]:
            raise Rejected("another system")
        if other := [name for name, data in tied.items() if data not in there.values()]:
            raise Rejected(f"it is tied to another {other[0]}")
        return Certified(proved, summary, tuple(left(target, span)))
    except (Rejected, OSError, ValueError, KeyError, IndexError) as found:
        error = found
    note = Diagnostic("IL5007", Severity.ERROR, f"{target}: {error}", span, f"run `interlock certify {path}`")
    return Certified(proved, notes=(note,))
