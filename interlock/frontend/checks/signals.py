"""Signals stand where they govern something.  IL3016, IL3019."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.elements import BoundaryKind
from interlock.model.layout import Layout

SHUNTED = "; shunting movements keep to it, too: where they run both ways, leave it out and `exclude` train routes"
"""A double line through a station, on whose tracks dwarf signals stand both ways."""


def check_signals(ctx: Context, layout: Layout) -> None:
    """Report layouts without signals, and signals that govern nothing."""
    if not layout.signalling.signals:
        ctx.add(
            "IL3016",
            "the layout has no signal",
            ctx.at_key("name"),
            "add `signals:` with at least one entry, for instance `X1: {from: W, into: q1}`",
        )
        return
    for g in layout.signalling.signals:
        boundary = layout.track.boundary_at.get(g.node)
        e = layout.track.edge[g.into]
        if boundary is not None and boundary.kind is BoundaryKind.OUT:
            ctx.add(
                "IL3019",
                f"{g.id} is an entry signal, but trains only leave at {g.node}",
                ctx.at_key("signals", g.id),
                "say `trains: both` or `trains: in`, or remove the signal",
            )
        if e.one_way and e.a != g.node:
            ctx.add(
                "IL3019",
                f"{g.id} leads against the only direction of {e.section}",
                ctx.at_key("signals", g.id),
                "turn the signal round, or change `one_way`",
            )
        behind = next((x for x in layout.track.edges_at[g.node] if x.id != g.into), None)
        if behind is not None and behind.one_way and behind.b != g.node:
            ctx.add(
                "IL3019",
                f"no train comes to {g.id}: the only direction of {behind.section} leads away from it",
                ctx.at_key("signals", g.id),
                f"turn the signal round, or change `one_way`{'' if g.main else SHUNTED}",
            )
