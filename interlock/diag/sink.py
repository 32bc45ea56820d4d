"""Where a phase puts what it finds, so that the reader sees every problem at once."""

from __future__ import annotations

from interlock.diag.codes import severity_of
from interlock.diag.diagnostic import Diagnostic, Severity, Span


class Sink:
    """Collects diagnostics, so that a phase can report everything that it finds."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str, Span | None], Diagnostic] = {}

    def add(self, code: str, message: str, span: Span | None = None, fix: str = "") -> None:
        """Record one problem.  The severity belongs to the code, so that it cannot vary by place."""
        self._found.setdefault((code, message, span), Diagnostic(code, severity_of(code), message, span, fix))

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Everything found so far, in the order of the source text."""
        return tuple(sorted(self._found.values(), key=Diagnostic.order))

    @property
    def has_errors(self) -> bool:
        """Whether anything found so far forbids going on."""
        return any(d.severity is Severity.ERROR for d in self._found.values())
