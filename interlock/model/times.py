"""Seconds that a layout states for one element, or its principles for all."""

from __future__ import annotations

from fractions import Fraction
from math import ceil, floor

from interlock.model.elements import MachineId, SignalId
from interlock.model.layout import Layout


def stated(number: float) -> Fraction:
    """A number as it was stated, exactly: what follows from it is rounded once, to the side that restricts."""
    return Fraction(repr(float(number)))


def whole_ms(seconds: float | Fraction) -> int:
    """Seconds as they were stated, or follow, in whole milliseconds: rounded up, so that no delay is shorter than
    ordered or needed."""
    return ceil(1000 * (seconds if isinstance(seconds, Fraction) else stated(seconds)))


def at_most_ms(seconds: float) -> int:
    """Seconds in which something must have happened, in whole milliseconds: rounded down."""
    return floor(1000 * stated(seconds))


def tenths(ms: int) -> str:
    """Milliseconds that are needed, in seconds as a sentence has them: rounded up to a tenth."""
    return f"{ceil(Fraction(ms, 100)) / 10:.1f}"


def supervision_s(layout: Layout, machine: MachineId) -> float:
    """Seconds after which the machine, commanded and not detected, raises an alarm (R10)."""
    return dict(layout.pointwork.supervision).get(machine, layout.principles.point_supervision_s)


def approach_release_s(layout: Layout, signal: SignalId) -> float:
    """Seconds for which the routes of a signal are held after a cancellation: one time for a signal (R8)."""
    g, p = layout.signalling.signal[signal], layout.principles
    rules = max(p.approach_release_s if g.main else 0.0, p.shunt_release_s if g.shunt else 0.0)
    return dict(layout.signalling.releases).get(signal, rules)


def overlap_release_s(layout: Layout, signal: SignalId) -> float:
    """Seconds for which a train must have been before a signal until its overlap is released (R4)."""
    return dict(layout.overlaps.releases).get(signal, layout.principles.overlap_release_s)
