"""Approach sections that are shorter than the braking distance.  IL7006.

A driver who saw the entry signal open may be as far away as he brakes.  A train that has not reached the approach
section counts as on its way nevertheless (R8), so nothing is unsafe: but every cancellation takes the full delay, and a
signal that falls to stop meets trains that cannot stop before it.
"""

from __future__ import annotations

from interlock.diag import Element
from interlock.frontend.context import Context
from interlock.model.approach import braking_m
from interlock.model.elements import BoundaryKind
from interlock.model.layout import Layout
from interlock.model.principles import Principles


def check_approach(ctx: Context, layout: Layout) -> None:
    """Compare each approach section with the braking distance from the speed in it."""
    rules = layout.principles
    mains = {g.node for g in layout.signalling.signals if g.main}
    for b in layout.track.boundaries:
        if b.approach is None or b.kind is BoundaryKind.OUT or b.node not in mains:
            continue
        kmh = rules.line_speed_kmh
        needed = braking_m(rules, kmh)
        if b.approach_m < needed:
            ctx.add(
                "IL7006",
                f"the approach section {b.approach} is {b.approach_m:g} m long; a train needs {needed:.0f} m to stop "
                f"from {kmh:g} km/h",
                ctx.at("boundaries", b.node, "approach"),
                f"give the section its real length, or state the speed: `principles: {{line_speed_kmh: ...}}`"
                f"; {b.approach_m:g} m suffice below {_speed(rules, b.approach_m) + 1} km/h",
                about=Element("boundaries", b.node),
                cause="short approach",
                note=f"{b.approach}: {b.approach_m:g} m",
            )


def _speed(rules: Principles, metres: float) -> int:
    """The highest whole speed from which a train stops within some metres."""
    kmh = 1
    while braking_m(rules, kmh + 1) <= metres:
        kmh += 1
    return kmh
