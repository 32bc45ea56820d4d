"""One diagnostic: code, severity, sentence, place and fix.

Input: facts from any phase.  Output: a frozen value that every renderer understands.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Severity(StrEnum):
    """How much a diagnostic matters.  Only errors stop the compilation."""

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"


@dataclass(frozen=True, order=True)
class Span:
    """A place in a source file; lines and columns count from 1, `width` is in characters."""

    file: str
    line: int
    column: int
    width: int = 1


@dataclass(frozen=True)
class Diagnostic:
    """What is wrong (`message`), where (`span`), and what to do about it (`fix`)."""

    code: str
    severity: Severity
    message: str
    span: Span | None = None
    fix: str = ""

    def order(self) -> tuple[str, int, int, str, str]:
        """Sort key: by file, then place, then code."""
        s = self.span
        return (s.file if s else "", s.line if s else 0, s.column if s else 0, self.code, self.message)
