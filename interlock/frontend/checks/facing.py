"""Main signals that look the wrong way.  IL7001.

A signal stands before points and is read by trains that go over them.  One that is turned round is read by the trains
that have just passed them: they wait on the points, and those out of the track beyond pass without a signal.
"""

from __future__ import annotations

from interlock.diag import Element
from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.model.layout import Layout
from interlock.model.plain import plains


def check_facing(ctx: Context, layout: Layout) -> None:
    """Report turned signals."""
    found = plains(layout)
    for g in layout.signalling.signals:
        behind = found.behind_points(g)
        if g.id in layout.signalling.boards or behind is None or not found.turned(g):
            continue
        spec = ctx.file.signals[g.id]
        ctx.add(
            "IL7001",
            f"{called('signal', g.id)} looks the wrong way: it is read by trains that have just passed {behind[0]}, "
            f"and none is read by those that come out of {spec.into}",
            ctx.at_key("signals", g.id),
            f"turn it round: `{g.id}: {{from: {spec.into}, into: {spec.from_}}}`",
            about=Element("signals", g.id),
        )
