"""Why trains wait, in classes that can be added up."""

from __future__ import annotations

_SIGNS = (
    ("was refused", "refused"),  # whatever else is said of it
    ("does not open", "signal is shut"),
    ("no train stands before", "on its way"),
    ("goes first", "another train goes first"),
    ("comes in before it", "another train goes first"),
    ("could not all go on", "no plan after it"),
    ("no plan exists", "no plan after it"),
    ("was not found out", "no plan after it"),
    (" is full", "zone is full"),
    ("is in the way", "another train is in the way"),
    ("is not clear", "section is occupied"),
    ("is locked", "section is locked"),
    ("is blocked", "section is blocked"),
    ("is not moved", "points are not moved"),
    ("line beyond", "line beyond is occupied"),
    ("to be loaded", "signal is shut"),
    ("being loaded", "at work"),
    ("in doubt", "number is in doubt"),
)

CAUSES = tuple(dict.fromkeys([*(c for _, c in _SIGNS), "no order", "other"]))
"""All classes."""


def cause(reason: str) -> str:
    """The class of a reason as the dispatcher tells it."""
    return next((c for sign, c in _SIGNS if sign in reason), "other")
