"""Numbers as a layout states them."""

from __future__ import annotations


def exact(number: float) -> str:
    """A number with all its digits, and without those that say nothing: `60`, `1234.567`; two that differ read
    otherwise."""
    return f"{number:.15g}"


def metres(length: float) -> str:
    """A length, or several that were added, to a tenth of a millimetre."""
    return f"{round(length, 4):.15g} m"
