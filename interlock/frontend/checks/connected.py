"""A section is one piece of track, and some train can reach it.  IL3009, IL3010."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.frontend.pieces import pieces_of, place_of, report_split
from interlock.model.elements import Edge
from interlock.model.layout import Layout


def check_connected(ctx: Context, layout: Layout) -> None:
    """Report split and unreachable sections."""
    report_split(ctx, layout.track.edges)
    parts: dict[str, list[Edge]] = {}
    for e in layout.track.edges:
        parts.setdefault(e.section, []).append(e)
    _check_parts(ctx, layout, parts)


def _check_parts(ctx: Context, layout: Layout, sections: Mapping[str, Sequence[Edge]]) -> None:
    """Report each part of the layout that is joined to no boundary; where there is none, those beside the first
    signal's."""
    starts = {b.node for b in layout.track.boundaries} or {g.node for g in layout.signalling.signals[:1]}
    pieces = pieces_of(layout.track.edges)
    for piece in (p for p in pieces if not p & starts):
        those = sorted(s for s, edges in sections.items() if any(e.a in piece for e in edges))
        more = f" and {len(those) - 8} more" if len(those) > 8 else ""
        named = called("section", those[0]) if len(those) == 1 else f"sections {', '.join(those[:8])}{more}"
        apart = "joined to no boundary"
        if starts and not layout.track.boundaries:
            apart = f"not joined to the part of signal {layout.signalling.signals[0].id}"
        ctx.add(
            "IL3010",
            f"no train can reach {named}: the layout falls into {len(pieces)} parts that do not touch, and this one is "
            f"{apart}",
            ctx.at(*place_of(ctx, those[0])),
            "join it to the rest of the layout, make a layout of its own of it, or remove it",
        )
