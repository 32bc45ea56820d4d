"""Diagnostics: where a problem is, what it is called, and how it is shown."""

from interlock.diag.diagnostic import Diagnostic, Element, Place, Severity, Span
from interlock.diag.sink import Sink

__all__ = ["Diagnostic", "Element", "Place", "Severity", "Sink", "Span"]
