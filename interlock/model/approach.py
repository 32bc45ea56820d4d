"""From where a train may come that is about to pass a signal: comprehensive approach locking (R8).

A driver who has been told that a signal is open may be as far away as the braking distance from the highest speed
there, and as far as the first main signal in rear that shows a better aspect because this one is open.  Back to the
farther of the two every section belongs to the approach, over every way on which a train can be called; where detection
ends before that, a train may always be on its way unseen.
"""

from __future__ import annotations

from collections.abc import Callable

from interlock.model.elements import BoundaryKind, NodeId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.places import Approach
from interlock.model.principles import Caution, Principles
from interlock.model.traversal import Topology, topology


def braking_m(rules: Principles, kmh: float) -> float:
    """Metres from the command of stop until a train that runs at so many km/h stands: delay, reaction, braking."""
    v = kmh / 3.6
    return v * (rules.output_delay_s + rules.reaction_s) + v * v / (2 * rules.braking_ms2)


def approach(layout: Layout, signal: SignalId) -> Approach:
    """From where a train may come to a signal."""
    g, rules, topo = layout.signal[signal], layout.principles, topology(layout)

    def metres(section: SectionId) -> float:
        stated = layout.section[section].speed if section in layout.section else None
        kmh = rules.line_speed_kmh if stated is None else float(stated)
        return braking_m(rules, kmh if g.main else min(kmh, rules.shunt_speed_kmh))

    first = layout.section_of(g.into)
    announced = not g.main or rules.caution is Caution.NEVER
    found = _before(layout, topo, metres, first, g.node, 0.0, 0.0, announced, frozenset({first}))
    return Approach(None) if found is None else found


def _before(
    layout: Layout,
    topo: Topology,
    metres: Callable[[SectionId], float],
    ahead: SectionId,
    node: NodeId,
    gone: float,
    needed: float,
    announced: bool,
    seen: frozenset[SectionId],
) -> Approach | None:
    """What lies in rear of `ahead` at `node`, `gone` metres from the signal; None where no train comes from.

    `needed`: the longest braking distance on the way so far.  `announced`: the first main signal in rear is passed.
    """
    boundary = layout.boundary_at.get(node)
    if boundary is not None:
        if boundary.kind is BoundaryKind.OUT and len(seen) > 1:
            return None
        if boundary.approach is None:
            return Approach(None)
        far = gone + boundary.approach_m >= max(needed, metres(boundary.approach))
        return Approach(boundary.approach, unseen=not far)
    s = topo.beyond(ahead, node)
    if s is None or s in seen:
        return None
    needed = max(needed, metres(s))
    further = []
    for t in topo.traversals[s]:
        done = announced or (t.entry, s) in topo.main_into
        if t.exit != node or (done and gone + t.length >= needed):
            continue
        x = _before(layout, topo, metres, s, t.entry, gone + t.length, needed, done, seen | {s})
        if x is not None:
            further.append((t.number, x))
    return Approach(s, tuple(further))
