"""Signals stand where they govern something.  IL3008, IL3016, IL3019."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.elements import BoundaryKind, EdgeId, NodeId, SignalId
from interlock.model.layout import Layout


def check_signals(ctx: Context, layout: Layout) -> None:
    """Report layouts without signals, and signals that govern nothing."""
    if not layout.signals:
        ctx.add(
            "IL3016",
            "the layout has no signal",
            ctx.at_key("name"),
            "add `signals:` with at least one entry, for instance `X1: {from: W, into: q1}`",
        )
        return
    facing = {(g.node, g.into): g.id for g in layout.signals}
    for buffer in layout.buffers:
        found = _facing_stub(layout, buffer.node, facing)
        for later in found[:-1]:
            ctx.add(
                "IL3008",
                f"{found[-1]} and {later} both face the buffer {buffer.node} with no point between",
                ctx.at_key("signals", later),
                "one signal governs a dead-end track; remove this one, or join its two sections into one",
            )
    for g in layout.signals:
        boundary = layout.boundary_at.get(g.node)
        e = layout.edge[g.into]
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


def _facing_stub(layout: Layout, buffer: NodeId, facing: dict[tuple[NodeId, EdgeId], SignalId]) -> list[SignalId]:
    """Signals that face a buffer over plain track, nearest to the buffer first."""
    found: list[SignalId] = []
    node, edge = buffer, layout.edges_at[buffer][0].id
    while True:
        node = layout.far(edge, node)
        if (node, edge) in facing:
            found.append(facing[node, edge])
        others = [e.id for e in layout.edges_at[node] if e.id != edge]
        if node in layout.point_at or node in layout.crossing_at or len(others) != 1:
            return found
        edge = others[0]
