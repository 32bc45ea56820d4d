"""What `prove` tells of a layout."""

from __future__ import annotations

from typing import TYPE_CHECKING

from interlock.app.check import Checked
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Severity
from interlock.proof.induction.verdict import ProofResult, Verdict

if TYPE_CHECKING:
    from interlock.proof.equivalence.structured_text import Difference


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
    seconds: float = 0.0
    """What it took by the clock on the wall, from reading the file on."""

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
