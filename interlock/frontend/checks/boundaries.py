"""Where trains can come in, a signal stands.  IL3011."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.elements import Boundary, BoundaryKind, Edge
from interlock.model.layout import Layout


def check_boundaries(ctx: Context, layout: Layout) -> None:
    """Report boundaries over which trains could come in without a signal."""
    guarded = {g.node for g in layout.signalling.signals}
    for b in layout.track.boundaries:
        if b.kind is not BoundaryKind.OUT and b.node not in guarded:
            ctx.add(
                "IL3011",
                f"trains can come in at {b.node}, and no signal stands there",
                ctx.at_key("boundaries", b.node),
                _fix(layout, b),
            )


def _fix(layout: Layout, b: Boundary) -> str:
    """A signal, or, where the first one stands further in, the track before it as the approach: what a train does there
    is told by the signal before, which is the neighbour's."""
    inside = layout.track.edges_at[b.node][0].section
    signal = f"add a signal `from: {b.node}, into: {inside}`"
    before, name = _first_signal(layout, b)
    if not name:
        return f"{signal}, or say `trains: out`"
    section = before[-1].section
    metres = sum(e.length for e in before if e.section == section)
    into = layout.track.edge[layout.signalling.signal[name].into].section  # type: ignore[index]
    begins = f"the track begins `[{b.node}, {into} ...]`, `{name}: {{from: {b.node}, ...}}`"
    moved = f"`{b.node}: {{approach: {section} {metres:g}}}`, {begins}"
    return f"{signal}; or, if {name} is the first signal, the track before it is its approach: {moved}"


def _first_signal(layout: Layout, b: Boundary) -> tuple[list[Edge], str]:
    """The plain track over which trains come in, up to the first signal that they read, and its name; none before
    points."""
    node, before = b.node, [layout.track.edges_at[b.node][0]]
    for _ in layout.track.edges:
        node = layout.track.far(before[-1].id, node)
        onward = layout.onward(before[-1].id, node)
        if node in layout.pointwork.point_at or node in layout.pointwork.crossing_at or len(onward) != 1:
            break
        facing = layout.signalling.facing.get((node, onward[0].id))
        if facing is not None and facing.main:
            return before, facing.id
        before.append(onward[0])
    return [], ""
