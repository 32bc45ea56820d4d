"""A section is one piece of track, and some train can reach it.  IL3009, IL3010."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.frontend.scalars import item_parts
from interlock.model.elements import Edge, NodeId
from interlock.model.layout import Layout


def _place(ctx: Context, section: str) -> tuple[str | int, ...]:
    for track, items in ctx.file.tracks.items():
        for i, item in enumerate(items):
            if item_parts(item)[0] == section:
                return ("tracks", track, i)
    for point, spec in ctx.file.points.items():
        if spec.section == section:
            return ("points", point, "section")
    for crossing, cross in ctx.file.crossings.items():
        for i, arm in enumerate(cross.arms):
            if arm.section == section:
                return ("crossings", crossing, "arms", i, "section")
    return ()


def _pieces(edges: Iterable[Edge]) -> list[set[NodeId]]:
    """The connected pieces of some edges.  (Ten lines: a graph library would double the start-up of `check`.)"""
    pieces: dict[NodeId, set[NodeId]] = {}
    for e in edges:
        a, b = pieces.setdefault(e.a, {e.a}), pieces.setdefault(e.b, {e.b})
        if a is not b:
            small, large = sorted((a, b), key=len)
            large |= small
            pieces.update(dict.fromkeys(small, large))
    return list({id(p): p for p in pieces.values()}.values())


def check_connected(ctx: Context, layout: Layout) -> None:
    """Report split and unreachable sections."""
    parts: dict[str, list[Edge]] = {}
    for e in layout.track.edges:
        parts.setdefault(e.section, []).append(e)
    for section, edges in sorted(parts.items()):
        count = len(_pieces(edges))
        if count > 1:
            ctx.add(
                "IL3009",
                f"{called('section', section)} is split into {count} pieces that do not touch",
                ctx.at(*_place(ctx, section)),
                "a detector watches one piece of track: name each piece",
            )
    _check_parts(ctx, layout, parts)


def _check_parts(ctx: Context, layout: Layout, sections: Mapping[str, Sequence[Edge]]) -> None:
    """Report each part of the layout that is joined to no boundary; where there is none, those beside the first
    signal's."""
    starts = {b.node for b in layout.track.boundaries} or {g.node for g in layout.signalling.signals[:1]}
    pieces = _pieces(layout.track.edges)
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
            ctx.at(*_place(ctx, those[0])),
            "join it to the rest of the layout, make a layout of its own of it, or remove it",
        )
