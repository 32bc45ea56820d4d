"""Seconds that a layout states for one element, or its principles for all."""

from __future__ import annotations

from decimal import Decimal
from math import ceil

from interlock.model.elements import MachineId, SignalId
from interlock.model.layout import Layout


def whole_ms(seconds: float) -> int:
    """Seconds as they were stated, in whole milliseconds: rounded up, so that no delay is shorter than ordered."""
    return ceil(1000 * Decimal(repr(float(seconds))))


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
