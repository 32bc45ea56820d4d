"""Routes whose train can never have come to their signal under another one.

What stands in a section at a restart, on points that lie anyhow or across a diamond, is moved under local rules and is
never called (R16): only a train that has come in under a route goes on from there.  Where none leads in, or only such
as can never be driven themselves, the routes that begin there are refused (IL4018).
"""

from __future__ import annotations

from collections.abc import Sequence

from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import NodeId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import topology
from interlock.table.cells import RouteKind


def check_reached(layout: Layout, paths: Sequence[Path], sink: Sink) -> None:
    """IL4018, once for each signal."""
    found: dict[SignalId, list[Path]] = {}
    for p in _never_begun(layout, paths):
        found.setdefault(p.entry, []).append(p)
    topo = topology(layout)
    for g, those in found.items():
        rear = topo.beyond(those[0].ways[0].section, those[0].entry_node)
        over = {p: None for t in topo.traversals[rear] for p, _ in t.points} if rear is not None else {}
        lies = f"points {_listed([*over], 'and')} lie" if over else "a diamond lies"
        many = "s" if len(those) > 1 else ""
        text = f"no train can drive route{many} {_listed([p.id for p in those], 'or')}: none comes to {g}, which is "
        text += f"left from {called('section', str(rear))}, where {lies}: no route brings a train there, and what a "
        text += "restart finds on points is never called"
        fix = f"add a signal from which a route leads to {g}, or a joint between {g} and the points; or exclude what "
        fix += f"begins there: `exclude: [{{from: {g}, reason: ...}}]`"
        sink.add("IL4018", text, None, fix, about=Element("signals", g))


def _never_begun(layout: Layout, paths: Sequence[Path]) -> list[Path]:
    """The routes for which no train can ever stand before the signal: all but those found from where one can.

    From the section in which its route ends a train leaves at one end of its way through it, the other one after it has
    turned: the points under it lie for that way.
    """
    topo = topology(layout)
    own = [p for p in paths if p.kind is not RouteKind.IDENTIFIER]  # a part is set with a route that leads past
    begins: dict[tuple[SectionId | None, NodeId], list[Path]] = {}
    for p in own:
        begins.setdefault((topo.beyond(p.ways[0].section, p.entry_node), p.entry_node), []).append(p)
    plain = {s for s, ways in topo.traversals.items() if not any(t.points or t.crossings for t in ways)}
    there = {at for at in begins if at[0] is None or at[0] in plain}
    todo = list(there)
    while todo:
        for p in begins.get(todo.pop(), ()):
            last = p.parts[-1].ways[-1]
            new = {(last.section, last.exit), (last.section, last.entry)} - there
            there |= new
            todo += new
    return [p for at, those in begins.items() if at not in there for p in those]


def _listed(names: Sequence[str], word: str) -> str:
    shown = names if len(names) < 4 else [*names[:2], f"{len(names) - 2} more"]
    return f" {word} ".join(filter(None, (", ".join(shown[:-1]), shown[-1])))
