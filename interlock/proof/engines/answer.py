"""What an engine says."""

from __future__ import annotations

from enum import StrEnum


class Answer(StrEnum):
    """SAT, UNSAT, or neither within the limit."""

    SAT = "sat"
    UNSAT = "unsat"
    UNKNOWN = "unknown"
