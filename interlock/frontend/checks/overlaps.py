"""Alternatives of overlaps that are stated and do not exist.  IL1014."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths, own_way


def check_overlaps(ctx: Context, layout: Layout) -> None:
    """Report entries of `ways` that fit no alternative of their overlap (R4)."""
    used = [own_way(layout, o.signal, ways) for o in layout.overlaps for ways in overlap_paths(layout, o.signal)]
    for g in ctx.file.overlaps:
        own = [w for w in layout.overlap_ways if w.signal == g]
        for i, way in enumerate(own):
            if not any(way is x for x in used):
                ctx.add(
                    "IL1014",
                    f"no overlap of {g} of {way.length:g} m, to the next joint, leads over {', '.join(way.over)}",
                    ctx.at("overlaps", g, "ways", i),
                    "name sections that tell this way from the others, as near to the signal as possible",
                )
