"""One diagnostic: code, severity, sentence, places and fix.

Input: facts from any phase.  Output: a frozen value that every renderer understands.
"""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple

from interlock.dataclass import dataclass
from interlock.diag.shortened import shortened
from interlock.diag.suggest import Suggestion


class Severity(StrEnum):
    """How much a diagnostic matters.  Only errors stop the compilation."""

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"


class Span(NamedTuple):
    """A place in a source file; lines and columns count from 1, `width` is in characters."""

    file: str
    line: int
    column: int
    width: int = 1


@dataclass(frozen=True)
class Element:
    """What a diagnostic speaks of, told by a phase that has no text at hand: the key of the layout file under which
    elements of its kind stand, and its name (its number from 0 in a list)."""

    room: str
    name: str | int


@dataclass(frozen=True)
class Place:
    """Another place with the same cause; `note` says what is particular to it."""

    span: Span | None
    note: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "note", shortened(self.note))


@dataclass(frozen=True)
class Diagnostic:
    """What is wrong (`message`), where (`span`, and of which element), and what to do about it (`fix`); what the layout
    names at length, shortened.

    `also`: the other places at which the same is wrong, in the order of the source.
    """

    code: str
    severity: Severity
    message: str
    span: Span | None = None
    advice: str | Suggestion = ""
    about: Element | None = None
    also: tuple[Place, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "message", shortened(self.message))

    @property
    def fix(self) -> str:
        """What to do about it.  (A suggestion is searched for only when somebody reads it.)"""
        return shortened(str(self.advice))

    def order(self) -> tuple[str, int, int, str, str]:
        """Sort key: by file, then place, then code."""
        s = self.span
        return (s.file if s else "", s.line if s else 0, s.column if s else 0, self.code, self.message)
