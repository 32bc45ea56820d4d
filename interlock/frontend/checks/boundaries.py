"""Where trains can come in, a signal stands.  IL3011."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.elements import BoundaryKind
from interlock.model.layout import Layout


def check_boundaries(ctx: Context, layout: Layout) -> None:
    """Report boundaries over which trains could come in without a signal."""
    guarded = {g.node for g in layout.signals}
    for b in layout.boundaries:
        inside = layout.edges_at[b.node][0].section
        if b.kind is not BoundaryKind.OUT and b.node not in guarded:
            ctx.add(
                "IL3011",
                f"trains can come in at {b.node}, and no signal stands there",
                ctx.at_key("boundaries", b.node),
                f"add a signal `from: {b.node}, into: {inside}`, or say `trains: out`",
            )
