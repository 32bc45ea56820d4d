"""Where trains can come in, a signal stands that they obey.  IL3011."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.elements import Boundary, BoundaryKind, Edge, Signal
from interlock.model.layout import Layout


def check_boundaries(ctx: Context, layout: Layout) -> None:
    """Report boundaries over which trains could come in without a signal, or past one that says nothing to them."""
    guards = {g.node: g for g in layout.signalling.signals}
    for b in layout.track.boundaries:
        g = guards.get(b.node)
        if b.kind is BoundaryKind.OUT or (g is not None and g.main):
            continue
        why, fix = ("no signal stands there", _fix(layout, b)) if g is None else _unheeded(layout, g)
        ctx.add("IL3011", f"trains can come in at {b.node}, and {why}", ctx.at_key("boundaries", b.node), fix)


def _unheeded(layout: Layout, g: Signal) -> tuple[str, str]:
    """What stands there, and what must: trains pass a shunt signal, too, only where they are called or end."""
    if g.id in layout.signalling.boards:
        return f"trains pass the limit-of-shunt board {g.id} whatever it shows", f"let {g.id} be of `kind: main`"
    alone = "where shunting movements alone come in, `stops_trains: yes`"
    return f"trains pass the shunt signal {g.id} whatever it shows", f"let {g.id} be of `kind: combined`; {alone}"


def _fix(layout: Layout, b: Boundary) -> str:
    """A signal, or, where the first one stands further in, the track before it as the approach: what a train does there
    is told by the signal before, which is the neighbour's."""
    inside = layout.track.edges_at[b.node][0].section
    signal = f"add a signal `from: {b.node}, into: {inside}`"
    before, name = _first_signal(layout, b)
    if not name:
        return f"{signal}, or say `trains: out`"
    section = before[-1].section
    inside_too = {e.id: e.section for e in before}
    kept = next((g for g in layout.signalling.signals if g.id != name and g.into in inside_too), None)
    if kept is not None:
        stays = f"{kept.id} leads into {inside_too[kept.into]}, which lies inside the layout then"
        return f"{signal} ({stays}), or say `trains: out`"
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
