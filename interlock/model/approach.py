"""From where a train may come that is about to pass a signal: comprehensive approach locking (R8).

A driver who has been told that a signal is open may be as far away as the braking distance from the highest speed
there, and as far as the first main signal in rear that shows a better aspect because this one is open.  If that signal
falls back when he is nearer to it than he runs until he reacts, he does not notice, so that this way belongs to the
approach, too.  Back to the farther of the two every section does, over every way on which a train can be called; where
detection ends before that, a train may always be on its way unseen.  A signal that may be passed at identifier light
tells nothing then, so that the one before it counts.
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
    return reaction_m(rules, kmh) + v * v / (2 * rules.braking_ms2)


def reaction_m(rules: Principles, kmh: float) -> float:
    """Metres that a train runs from the command of a worse aspect until its driver acts on it."""
    return kmh / 3.6 * (rules.output_delay_s + rules.reaction_s)


class TooManyWays(Exception):
    """A signal is come to over more ways than were to be looked at."""


def approach(layout: Layout, signal: SignalId, most: int | None = None) -> Approach:
    """From where a train may come to a signal.  Raises `TooManyWays` when more places than `most` were looked at."""
    looked = 0
    g, rules, topo = layout.signalling.signal[signal], layout.principles, topology(layout)

    def kmh(section: SectionId) -> float:
        stated = layout.track.section[section].speed if section in layout.track.section else None
        fastest = rules.line_speed_kmh if stated is None else float(stated)
        return fastest if g.main else min(fastest, rules.shunt_speed_kmh)

    def metres(section: SectionId, told_at: float | None) -> float:
        nonlocal looked
        looked += 1
        if most is not None and looked > most:
            raise TooManyWays
        v = kmh(section)
        return max(braking_m(rules, v), 0.0 if told_at is None else told_at + reaction_m(rules, v))

    first = layout.track.section_of(g.into)
    announced = not g.main or rules.caution is Caution.NEVER
    found = _before(layout, topo, metres, first, g.node, 0.0, 0.0, announced, None, frozenset({first}))
    return Approach(None) if found is None else found


def _before(
    layout: Layout,
    topo: Topology,
    metres: Callable[[SectionId, float | None], float],
    ahead: SectionId,
    node: NodeId,
    gone: float,
    needed: float,
    announced: bool,
    told_at: float | None,
    seen: frozenset[SectionId],
) -> Approach | None:
    """What lies in rear of `ahead` at `node`, `gone` metres from the signal; None where no train comes from.

    `needed`: the longest distance on the way so far.  `announced`: the first main signal in rear is passed.  `told_at`:
    how far from the signal that one stands, where it stands at `node`.
    """
    boundary = layout.track.boundary_at.get(node)
    if boundary is not None:
        if boundary.kind is BoundaryKind.OUT and len(seen) > 1:
            return None
        if boundary.approach is None:
            return Approach(None)
        far = gone + boundary.approach_m >= max(needed, metres(boundary.approach, told_at))
        return Approach(boundary.approach, unseen=not far)
    s = topo.beyond(ahead, node)
    if s is None or s in seen:
        return None
    needed = max(needed, metres(s, told_at))
    further = []
    silent = {None, *layout.signalling.identifiers}
    for t in topo.traversals[s]:
        tells = not announced and topo.main_into.get((t.entry, s)) not in silent
        run = gone + t.length
        if t.exit != node or (announced and run >= needed):
            continue
        at = run if tells else None
        x = _before(layout, topo, metres, s, t.entry, run, needed, announced or tells, at, seen | {s})
        if x is not None:
            further.append((t.number, x))
    return Approach(s, tuple(further))
