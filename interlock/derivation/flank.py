"""Flank protection (R5) as an AND/OR search.

Requesters: the unused leg of every point on the way, and both ends of the other arm of every diamond.
From there the search goes outward until something keeps vehicles away:
    leg of another point    that point turned away, OR whatever protects beyond its toe
    toe of another point    both legs must be protected (AND)
    signal at stop          if it stands clear of the fouling point; otherwise the search goes on
    buffer, outgoing boundary, one-way track    nothing can come
    inclined lane           vehicles run away over it: nothing beyond protects, nor points within; but a trap
Nothing-can-come is preferred, but to the end of a track, where vehicles may stand, a point that is turned away before
it; then a point turned away or a signal, as the principle `flank_by` says; a diamond prefers points.  The partner of a
scissors crossover lies normal, whatever else there is (防护道岔): nothing else is offered there.  Which of the sets is
taken is settled for all routes together (`derivation/settle.py`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from math import inf
from typing import NamedTuple

from interlock.dataclass import dataclass
from interlock.diag.called import called
from interlock.model.elements import (
    BoundaryKind,
    BufferKind,
    Crossing,
    EdgeId,
    MachineId,
    NodeId,
    Point,
    Position,
    SectionId,
    SignalId,
)
from interlock.model.layout import Layout
from interlock.model.principles import FlankChoice
from interlock.model.traversal import Traversal, onward_edges, runaways
from interlock.table.cells import Because, FlankCell, Provider, ProviderKind

_PASSIVE = (ProviderKind.BUFFER, ProviderKind.BOUNDARY, ProviderKind.ONE_WAY)
_BY_SIGNAL = (*_PASSIVE, ProviderKind.SIGNAL)


@dataclass(frozen=True)
class Requester:
    """A place at which a vehicle must not come in: looking outward from `node` along `edge`."""

    name: str
    node: NodeId
    edge: EdgeId
    section: SectionId
    clear_of: float
    waiver: str | None
    partner: MachineId | None = None
    """The machine of the other crossover of a scissors, at the end of a diamond's other arm."""


def requesters(layout: Layout, t: Traversal) -> tuple[Requester, ...]:
    """The requesters of one way through a section; nobody comes in from where a derailer leads off the rails."""
    out: list[Requester] = []
    margin = layout.principles.clearance_m
    waived = {(w.point, w.leg): w.reason for w in layout.declared.waivers}
    for pid, position in t.points:
        p = layout.pointwork.point[pid]
        leg = position.other
        if p.derailer and leg is Position.NORMAL:
            continue
        out.append(
            Requester(
                f"{pid}.{'normal' if leg is Position.NORMAL else 'reverse'}",
                p.node,
                p.leg(leg),
                t.section,
                p.fouling + margin,
                waived.get((pid, leg)),
            )
        )
    for cid, arm in t.crossings:
        c = layout.pointwork.crossing[cid]
        partners = _partners(layout, c, c.arms[1 - arm])
        for side, edge, partner in zip("ab", c.arms[1 - arm], partners, strict=True):
            name, clear_of = f"{cid}.{2 - arm}{side}", c.fouling + margin
            out.append(Requester(name, c.node, edge, t.section, clear_of, None, partner))
    return tuple(out)


def _partners(layout: Layout, c: Crossing, arm: tuple[EdgeId, EdgeId]) -> tuple[MachineId | None, MachineId | None]:
    """The machines at the two ends of an arm that is a crossover of a scissors: both ends lead over plain track to the
    reverse leg of a point."""
    ends = [next_point(layout, c.node, e) for e in arm]
    if all(p is not None and p.position_of(e) is Position.REVERSE for p, e in ends):
        first, second = (p.machine if p is not None else None for p, _ in ends)
        return first, second
    return None, None


def next_point(layout: Layout, node: NodeId, edge: EdgeId) -> tuple[Point | None, EdgeId]:
    """The first point over an edge away from a node, if nothing but plain track lies between, and the edge to it."""
    for _ in layout.track.edges:
        node = layout.track.far(edge, node)
        if node in layout.pointwork.point_at:
            return layout.pointwork.point_at[node], edge
        onward = [e.id for e in layout.track.edges_at[node] if e.id != edge]
        if len(onward) != 1:
            break
        edge = onward[0]
    return None, edge


Allowed = Callable[[MachineId, Position], bool]
"""Whether a machine may be demanded in a position."""


class Options:
    """The sets of providers that protect requesters.  The preferred one is searched for once: all ways over a point and
    all that run beside it ask for the same."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        self._preferred: dict[tuple[NodeId, EdgeId, float], tuple[Provider, ...] | None] = {}

    def preferred(self, r: Requester) -> tuple[Provider, ...] | None:
        """The preferred set, or None if nothing protects the requester."""
        key = r.node, r.edge, r.clear_of
        if key not in self._preferred:
            self._preferred[key] = next(self.of(r, lambda m, x: True), None)
        return self._preferred[key]

    def of(self, r: Requester, allowed: Allowed) -> Iterator[tuple[Provider, ...]]:
        """Every set that demands nothing but what is allowed, preferred ones first."""
        found = _outward(self._layout, r, allowed, r.edge, r.node, _Past())
        if r.partner is not None:
            lane, turned = _lane_before(self._layout, r), Provider(ProviderKind.POINT, r.partner, Position.NORMAL)
            if allowed(r.partner, Position.NORMAL):
                for option in found if lane else islice(found, 1):
                    yield (turned, *(p for p in option if lane and p.kind is ProviderKind.SIGNAL))
            return
        yield from (option for option in found if point_demands(option) is not None)


def _lane_before(layout: Layout, r: Requester) -> bool:
    """Whether an inclined lane lies between a diamond and the partner of a scissors, which keeps nothing off that
    stands there."""
    node, edge = r.node, r.edge
    while node not in layout.pointwork.point_at:
        if over_lane(layout, r, edge):
            return True
        node = layout.track.far(edge, node)
        edge = next((e.id for e in layout.track.edges_at[node] if e.id != edge), edge)
    return False


def over_lane(layout: Layout, r: Requester, edge: EdgeId) -> bool:
    """Whether an edge lies on an inclined lane from which vehicles may run away towards a requester: not in the section
    of the way itself, nor in the one across a diamond, where none stand."""
    e = layout.track.edge[edge]
    return e.inclined and e.section not in (r.section, layout.track.section_of(r.edge))


Outward = tuple[EdgeId, NodeId]
"""An edge, run over outward from a node."""


class _Past(NamedTuple):
    """What has been passed on the way outward: metres, edges; `spur`: a derailer or an inclined lane; `lane`: the
    section of the inclined lane on which one is; `against`: a section over which nothing comes this way but what runs
    away."""

    gone: float = 0.0
    seen: frozenset[Outward] = frozenset()
    spur: bool = False
    lane: SectionId | None = None
    against: bool = False


def _outward(
    layout: Layout, r: Requester, allowed: Allowed, edge: EdgeId, node: NodeId, past: _Past
) -> Iterator[tuple[Provider, ...]]:
    e = layout.track.edge[edge]
    if past.lane is not None and e.section != past.lane:
        return  # what stands on the inclined lane runs away, whatever is beyond
    against = past.against or e.nothing_comes_to(node)
    if against and not past.spur and (edge, node) not in runaways(layout):
        yield (Provider(ProviderKind.ONE_WAY, e.section),)
        return
    far = layout.track.far(edge, node)
    gone, spur, lane = past.gone + e.length, past.spur or e.inclined, e.section if over_lane(layout, r, edge) else None
    if far == r.node or (edge, node) in past.seen or (spur and far in {n for _, n in past.seen}):
        if not spur:
            yield ()  # a closed ring: nothing comes from outside; or over the path itself, which is no flank
        return
    signal = layout.signalling.facing.get((far, edge))
    held = signal is not None and gone >= r.clear_of and lane is None
    ended = far in layout.track.buffer_at or far in layout.track.boundary_at
    if held and signal is not None:
        yield (Provider(ProviderKind.SIGNAL, signal.id),)
        return
    if ended:
        yield from _end(layout, far, spur)
        return
    # round a balloon loop it comes back the other way, as a vehicle could
    past = _Past(gone, past.seen | {(edge, node)}, spur, lane, against)
    point = layout.pointwork.point_at.get(far)
    if point is not None:
        yield from _over_point(layout, r, allowed, point, edge, past)
        return
    for nxt in onward_edges(layout, far, edge):
        yield from _outward(layout, r, allowed, nxt, far, past)


def _over_point(
    layout: Layout, r: Requester, allowed: Allowed, point: Point, edge: EdgeId, past: _Past
) -> Iterator[tuple[Provider, ...]]:
    """Outward over a point to which one comes over an edge: from its toe over both legs; from a leg it may be turned
    away."""
    position = point.position_of(edge)
    if position is None:
        for left in _outward(layout, r, allowed, point.normal, point.node, past):
            for right in _outward(layout, r, allowed, point.reverse, point.node, past):
                yield tuple(dict.fromkeys(left + right))
        return
    turned: tuple[Provider, ...] | None = (Provider(ProviderKind.POINT, point.machine, position.other),)
    keyed = point.machine in layout.machines.by_hand and position.other is Position.REVERSE  # locked in normal only
    if past.lane is not None or keyed or not allowed(point.machine, position.other):
        turned = None
    beyond = _outward(layout, r, allowed, point.toe, point.node, past._replace(spur=past.spur or point.derailer))
    first = next(beyond, None)
    preferred = _BY_SIGNAL if _signal_before(layout, r, point, position.other) else _PASSIVE
    ends = first is not None and any(p.kind is ProviderKind.BUFFER for p in first)  # vehicles may stand before it
    if first is not None and all(p.kind in preferred for p in first) and not ends:
        yield first
        first = None
    if turned is not None:
        yield turned
    if first is not None:
        yield first
    yield from beyond


def _signal_before(layout: Layout, r: Requester, point: Point, position: Position) -> bool:
    """Whether a signal at stop is preferred to a point in a position that turns vehicles away.

    Not to a derailer, nor to a point that leads into a trap (safety siding, 安全线): they are there for nothing else.
    """
    if layout.principles.flank_by is FlankChoice.POINT or r.node in layout.pointwork.crossing_at:
        return False
    end = layout.track.buffer_at.get(end_of_leg(layout, point, position))
    return not point.derailer and (end is None or end.kind is not BufferKind.TRAP)


def end_of_leg(layout: Layout, point: Point, position: Position) -> NodeId:
    """Where plain track over a leg of a point ends."""
    edge, node = point.leg(position), point.node
    while True:
        node = layout.track.far(edge, node)
        onward = [e.id for e in layout.track.edges_at[node] if e.id != edge]
        if len(onward) != 1:
            return node
        edge = onward[0]


def _end(layout: Layout, node: NodeId, spur: bool) -> Iterator[tuple[Provider, ...]]:
    """The end of a track, or a boundary where no train comes in.  `spur`: a derailer or an inclined lane has been
    passed; neither protects from what is behind it, since vehicles stand there that nobody trusts to stay.  None are
    brought into a trap."""
    buffer, boundary = layout.track.buffer_at.get(node), layout.track.boundary_at.get(node)
    if buffer is not None and not (spur and buffer.kind is BufferKind.STOP):
        yield (Provider(ProviderKind.BUFFER, node),)
    if boundary is not None and boundary.kind is BoundaryKind.OUT and not spur:
        yield (Provider(ProviderKind.BOUNDARY, node),)


def space(layout: Layout, r: Requester, providers: Sequence[Provider]) -> dict[tuple[str, bool], str]:
    """What the principles ask of the flank space: sections to be clear (False), stop lamps to be intact (True)."""
    rules = layout.principles
    between, signals, _ = reached(layout, r, providers)
    found: dict[tuple[str, bool], str] = {}
    if rules.flank_space:
        for s in between:
            if s != r.section and s not in layout.track.undetected:
                found[s, False] = f"{s} lies between {r.name} and its protection"
    if rules.flank_lamp and rules.lamp_proof:
        for g in signals:
            found[g, True] = f"{g} protects {r.name} only while its stop lamp is intact"
    return found


def reached(
    layout: Layout, r: Requester, providers: Sequence[Provider]
) -> tuple[dict[SectionId, None], dict[SignalId, None], bool]:
    """The sections between a requester and what protects it, its own among them; the signals that protect it; whether
    the track closes in a ring.

    Walks outward from the requester again and stops at the chosen providers; round a balloon loop it comes back the
    other way, as a vehicle could; against one way it goes on towards what runs away, and nowhere else.  The section of
    a protecting point (all its legs are in one) does not lie between the point and its joint: a train that passes the
    point on its other leg is there, and does no harm.
    """
    between: dict[SectionId, None] = {}
    signals: dict[SignalId, None] = {}
    ring = not providers
    todo: list[tuple[EdgeId, NodeId, _Past]] = [(r.edge, r.node, _Past())]
    seen: dict[tuple[EdgeId, NodeId, bool, bool], float] = {}  # by the shortest way: there a signal counts least
    while todo:
        edge, node, past = todo.pop()
        e = layout.track.edge[edge]
        against = past.against or e.nothing_comes_to(node)
        if against and not past.spur and (edge, node) not in runaways(layout):
            continue
        here = edge, node, past.spur, against
        if seen.get(here, inf) <= past.gone:
            continue
        seen[here] = past.gone
        far, gone = layout.track.far(edge, node), past.gone + e.length
        point, signal = layout.pointwork.point_at.get(far), layout.signalling.facing.get((far, edge))
        kept = point is not None and point.derailer and point.toe != edge
        onward: Sequence[EdgeId] = ()
        if signal is not None and gone >= r.clear_of:
            between[e.section] = None
            signals[signal.id] = None
        elif far == r.node or far in layout.track.buffer_at or far in layout.track.boundary_at:
            between[e.section] = None
            ring = ring or far == r.node
        elif not _turns_away(layout, far, edge, providers):
            onward = onward_edges(layout, far, edge)
        for x in onward:
            if layout.track.section_of(x) != e.section:
                between[e.section] = None
            todo.append((x, far, _Past(gone, spur=past.spur or e.inclined or kept, against=against)))
    return between, signals, ring


def _turns_away(layout: Layout, node: NodeId, leg: EdgeId, providers: Sequence[Provider]) -> bool:
    """Whether the point at a node is one of the providers, turned away from a leg."""
    point = layout.pointwork.point_at.get(node)
    position = point.position_of(leg) if point is not None else None
    if point is None or position is None:
        return False
    return Provider(ProviderKind.POINT, point.machine, position.other) in providers


def point_demands(providers: Sequence[Provider]) -> dict[MachineId, Position] | None:
    """The positions that providers demand, or None when they contradict each other."""
    found: dict[MachineId, Position] = {}
    for p in providers:
        if p.position is not None and found.setdefault(MachineId(p.name), p.position) is not p.position:
            return None
    return found


def told(providers: Sequence[Provider]) -> str:
    """A set of providers in words."""
    stops = [p.name for p in providers if p.kind is ProviderKind.SIGNAL]
    if len(stops) > 1:
        others = [p for p in providers if p.kind is not ProviderKind.SIGNAL]
        signals = f"signals {', '.join(stops[:-1])} and {stops[-1]} at stop, clear of the fouling point"
        return " and ".join([*([told(others)] if others else []), signals])
    words = {
        ProviderKind.POINT: "{} turns vehicles away",
        ProviderKind.SIGNAL: "{} at stop, clear of the fouling point",
        ProviderKind.BUFFER: "the track ends at {}",
        ProviderKind.BOUNDARY: "no train comes in at {}",
        ProviderKind.ONE_WAY: "{} runs one way only",
        ProviderKind.WAIVED: "waived: {}",
    }
    movable = (ProviderKind.POINT, ProviderKind.SIGNAL)
    named = [words[p.kind].format(called(p.kind, str(p)) if p.kind in movable else p) for p in providers]
    return " and ".join(named) or "a closed ring, nothing comes from outside"


def cell(r: Requester, providers: tuple[Provider, ...]) -> FlankCell:
    """What protects a requester, as a cell of the table."""
    text = told(providers)
    if r.partner is not None:
        text = f"the partner {r.partner} of the scissors lies normal"
    if any(p.kind is ProviderKind.WAIVED for p in providers):
        return FlankCell(
            r.name, r.section, providers, Because("R5", f"the layout waives the protection of {r.name}: {r.waiver}")
        )
    return FlankCell(r.name, r.section, providers, Because("R5", f"towards {r.name}: {text}"))
