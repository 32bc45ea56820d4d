"""How near to what it stops for a train stands: the same metres for whoever checks, plans and drives."""

from __future__ import annotations

SIGNAL_M = 2.0
"""Metres before a signal in which a driver stands (our choice)."""

END_M = 3.0
"""Metres before the end of a track in which a driver stands (our choice)."""

MARGIN_M = max(SIGNAL_M, END_M)
"""Metres by which track is longer than a train that stands wholly on it, whatever its driver stops for."""

ROUNDED_M = 1e-9
"""Metres by which a sum of lengths may be rounded."""


def stands_on(metres: float, length_m: float) -> bool:
    """A train stands wholly on so many metres of track when its driver has stopped at their end."""
    return length_m + MARGIN_M <= metres + ROUNDED_M
