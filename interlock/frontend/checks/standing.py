"""Tell the author which road is no berth for what lies over it, and where none is denied (R2).  IL3025, IL3031."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.layout import Layout
from interlock.model.traversal import topology


def check_standing(ctx: Context, layout: Layout) -> None:
    """Report each road in which vehicles could stand, were there no door, bridge or level crossing over it; and what is
    denied in vain."""
    topo = topology(layout)
    for d in layout.signalling.devices:
        kind = "level_crossings" if d.id in ctx.file.level_crossings else "interlocks"
        for s in d.over:
            if s in topo.standing - topo.berths:
                ctx.add(
                    "IL3025",
                    f"{s} is no berth: {d.id} lies over it",
                    ctx.at_key(kind, str(d.id)),
                    f"shunting movements need {s} clear; give the part under {d.id} a section of its own "
                    f"if vehicles shall stand beside it",
                )
    for s in layout.declared.no_berths:
        if s not in topo.standing:
            points = any(t.points or t.crossings for t in topo.traversals[s])
            why = "points lie in it" if points else "it can be left without a signal"
            ctx.add("IL3031", f"{s} is no berth anyway: {why}", ctx.at("sections", s, "berth"), "remove `berth: no`")
