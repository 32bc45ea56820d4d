"""Inclined lanes ask for the hoist.  IL3021."""

from __future__ import annotations

from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.model.elements import Lane
from interlock.model.layout import Layout


def check_lanes(ctx: Context, layout: Layout) -> None:
    """Report inclined sections over which no condition is required (R17)."""
    guarded = {s for c in layout.signalling.conditions for s in c.over}
    guarded |= {s for d in layout.signalling.devices for s in d.over}
    for s in layout.track.sections:
        if s.lane is Lane.INCLINED and s.id not in guarded:
            ctx.add(
                "IL3021",
                f"{called('section', s.id)} is inclined, and no route over it asks for hoist, rope or barrier",
                ctx.at("sections", s.id, "lane"),
                f"say what must hold: `conditions: {{HOIST: {{text: hoist stopped, over: [{s.id}]}}}}`",
            )
