"""Track that is held as overlap (R4): which train routes may lead over it, and which overlaps may lie there, meanwhile.

An overlap may lead past further main signals in its direction.  It was found clear and free, so whoever stands before
one of them while it is held has come past its own signal, or nobody does.  What leads on from there the same way, over
points that lie alike, takes nothing from it: no other train can come in that way.  An overlap that may swing is shared
from its own signal alone.
"""

from __future__ import annotations

from interlock.model.elements import SectionId, SignalId
from interlock.model.layout import Layout, of_layout
from interlock.model.traversal import topology

Ways = tuple[tuple[SectionId, int], ...]
"""Ways through sections, in order: section, and number of the way."""


@of_layout
def passed_signals(layout: Layout, ways: Ways) -> dict[SignalId, int]:
    """The main signals past which an overlap leads in its direction, and how many of its ways lie before each."""
    topo = topology(layout)
    through = [topo.traversals[s][n - 1] for s, n in ways]
    joints = [(t.entry, t.section) for t in through]
    return {topo.main_into[x]: i for i, x in enumerate(joints) if i and x in topo.main_into}


@of_layout
def shared_from(layout: Layout, signal: SignalId, ways: Ways) -> dict[SignalId, Ways]:
    """The signals from which a train route may lead over an overlap that is held, and the ways over which each may: all
    of them from the overlap's own signal, those beyond it from one past which the overlap leads."""
    past = {} if _swings(layout, signal) else passed_signals(layout, ways)
    return {signal: ways, **{g: ways[i:] for g, i in past.items()}}


@of_layout
def may_meet(layout: Layout, one: tuple[SignalId, Ways], other: tuple[SignalId, Ways]) -> bool:
    """Whether two overlaps that lie over the same sections may be held together: one leads past the signal of the
    other, and beyond that, wherever both lie, they lie over the same ways; neither may swing."""
    return _leads_past(layout, one, other) or _leads_past(layout, other, one)


def _leads_past(layout: Layout, far: tuple[SignalId, Ways], near: tuple[SignalId, Ways]) -> bool:
    (g, over), (h, ways) = far, near
    shared = () if g == h or _swings(layout, h) else shared_from(layout, g, over).get(h, ())
    sections = {s for s, _ in over}
    return bool(shared) and all(key in shared for key in ways if key[0] in sections)


def _swings(layout: Layout, signal: SignalId) -> bool:
    return any(o.swing for o in layout.overlaps.all if o.signal == signal)
