"""Alternatives of overlaps that are stated and do not exist, and overlaps of which none is left.  IL1014."""

from __future__ import annotations

from dataclasses import replace

from interlock.frontend.context import Context
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths, own_way


def check_overlaps(ctx: Context, layout: Layout) -> None:
    """Report entries of `ways` that fit no alternative of their overlap, and of `not_over` that bar none, or all."""
    used = [own_way(layout, o.signal, ways) for o in layout.overlaps for ways in overlap_paths(layout, o.signal)]
    for g in ctx.file.overlaps:
        own = [w for w in layout.overlap_ways if w.signal == g]
        for i, way in enumerate(own):
            if not any(way is x for x in used):
                ctx.add(
                    "IL1014",
                    f"no overlap of {g} of {way.length:g} m, to the next joint, leads over {', '.join(way.over)}",
                    ctx.at("overlaps", g, "ways", i),
                    "name sections that tell this way from the others, as near to the signal as possible; a short "
                    "overlap that lies wholly within a longer one of the same signal is not told apart (R4)",
                )
    for g in ctx.file.overlaps:
        _bars(ctx, layout, SignalId(g))


def _bars(ctx: Context, layout: Layout, g: SignalId) -> None:
    for i, s in enumerate(ctx.file.overlaps[g].not_over):
        others = tuple(x for x in layout.overlap_bars if x != (g, s))
        free = overlap_paths(replace(layout, overlap_bars=others), g)
        if not any(s in (t.section, *t.edges) for ways in free for t in ways):
            ctx.add(
                "IL1014",
                f"no overlap of {g} would lead over {s}: `not_over` bars nothing there",
                ctx.at("overlaps", g, "not_over", i),
                "remove it, or name what the unwanted way alone leads over",
            )
    if ctx.file.overlaps[g].not_over and g in layout.overlap_of and not overlap_paths(layout, g):
        ctx.add(
            "IL1014",
            f"`not_over` leaves {g} no overlap: every way of that length leads over {_listed(layout, g)}",
            ctx.at("overlaps", g, "not_over"),
            "leave one way; for no overlap at all: `length: 0`",
        )


def _listed(layout: Layout, g: SignalId) -> str:
    return " or ".join(s for h, s in layout.overlap_bars if h == g)
