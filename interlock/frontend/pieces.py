"""A section is one piece of track.  IL3009."""

from __future__ import annotations

from collections.abc import Iterable

from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.frontend.scalars import item_parts
from interlock.model.elements import Edge, NodeId, SectionId


def place_of(ctx: Context, section: str) -> tuple[str | int, ...]:
    """Where a file first speaks of a section of its tracks, points or crossings; empty where nowhere."""
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


def pieces_of(edges: Iterable[Edge]) -> list[set[NodeId]]:
    """The connected pieces of some edges.  (Ten lines: a graph library would double the start-up of `check`.)"""
    pieces: dict[NodeId, set[NodeId]] = {}
    for e in edges:
        a, b = pieces.setdefault(e.a, {e.a}), pieces.setdefault(e.b, {e.b})
        if a is not b:
            small, large = sorted((a, b), key=len)
            large |= small
            pieces.update(dict.fromkeys(small, large))
    return list({id(p): p for p in pieces.values()}.values())


def report_split(ctx: Context, edges: Iterable[Edge]) -> frozenset[SectionId]:
    """Report the sections that lie in several pieces; these."""
    parts: dict[SectionId, list[Edge]] = {}
    for e in edges:
        parts.setdefault(e.section, []).append(e)
    counts = {s: n for s, those in sorted(parts.items()) if (n := len(pieces_of(those))) > 1}
    for section, n in counts.items():
        ctx.add(
            "IL3009",
            f"{called('section', section)} is split into {n} pieces that do not touch",
            ctx.at(*place_of(ctx, section)),
            "a detector watches one piece of track: name each piece",
        )
    return frozenset(counts)
