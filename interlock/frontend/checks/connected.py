"""A section is one piece of track, and some train can reach it.  IL3009, IL3010."""

from __future__ import annotations

import networkx as nx

from interlock.frontend.context import Context
from interlock.model.layout import Layout


def _place(ctx: Context, section: str) -> tuple[str | int, ...]:
    for track, items in ctx.file.tracks.items():
        for i, item in enumerate(items):
            if item.split()[0] == section:
                return ("tracks", track, i)
    for point, spec in ctx.file.points.items():
        if spec.section == section:
            return ("points", point, "section")
    for crossing, cross in ctx.file.crossings.items():
        for i, arm in enumerate(cross.arms):
            if arm.section == section:
                return ("crossings", crossing, "arms", i, "section")
    return ()


def check_connected(ctx: Context, layout: Layout) -> None:
    """Report split and unreachable sections."""
    whole = nx.Graph()
    parts: dict[str, nx.Graph] = {}
    for e in layout.edges:
        whole.add_edge(e.a, e.b)
        parts.setdefault(e.section, nx.Graph()).add_edge(e.a, e.b)
    for section, graph in sorted(parts.items()):
        pieces = sorted(sorted(c) for c in nx.connected_components(graph))
        if len(pieces) > 1:
            ctx.add(
                "IL3009",
                f"section {section} is split into {len(pieces)} pieces that do not touch",
                ctx.at(*_place(ctx, section)),
                "a detector watches one piece of track: name each piece",
            )
    starts = [b.node for b in layout.boundaries] or [g.node for g in layout.signals][:1]
    reached: set[str] = set()
    for node in starts:
        if node in whole and node not in reached:
            reached |= nx.node_connected_component(whole, node)
    for section, graph in sorted(parts.items()):
        if not reached & set(graph.nodes):
            ctx.add(
                "IL3010",
                f"no train can reach section {section}: it is joined to no boundary",
                ctx.at(*_place(ctx, section)),
                "join it to the rest of the layout, or remove it",
            )
