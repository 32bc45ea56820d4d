"""Flank protection (R5) as an AND/OR search.

Requesters: the unused leg of every point on the way, and both ends of the other arm of every diamond.
From there the search goes outward until something keeps vehicles away:
    leg of another point    that point turned away, OR whatever protects beyond its toe
    toe of another point    both legs must be protected (AND)
    signal at stop          if it stands clear of the fouling point; otherwise the search goes on
    buffer, outgoing boundary, one-way track    nothing can come
Nothing-can-come is preferred; then a point turned away or a signal, as the principle `flank_by` says.
A diamond is protected by a point wherever one can: the partner of a scissors crossover lies normal (防护道岔).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from math import inf

from interlock.model.elements import BoundaryKind, EdgeId, MachineId, NodeId, Position, SectionId
from interlock.model.layout import Layout
from interlock.model.principles import FlankChoice
from interlock.model.traversal import Traversal
from interlock.table.rows import Because, FlankCell, Provider, ProviderKind

Demands = Mapping[MachineId, Position]
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


def requesters(layout: Layout, t: Traversal) -> tuple[Requester, ...]:
    """The requesters of one way through a section."""
    out: list[Requester] = []
    margin = layout.principles.clearance_m
    waived = {(w.point, w.leg): w.reason for w in layout.waivers}
    for pid, position in t.points:
        p = layout.point[pid]
        leg = position.other
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
        c = layout.crossing[cid]
        for side, edge in zip("ab", c.arms[1 - arm], strict=True):
            out.append(
                Requester(f"{cid}.{2 - arm}{side}", c.node, edge, t.section, layout.principles.fouling_m + margin, None)
            )
    return tuple(out)


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
            self._preferred[key] = next(self._search(r), None)
        return self._preferred[key]

    def of(self, r: Requester) -> Iterator[tuple[Provider, ...]]:
        """Every set, preferred ones first."""
        first = self.preferred(r)
        if first is not None:
            yield first
            yield from islice(self._search(r), 1, None)

    def _search(self, r: Requester) -> Iterator[tuple[Provider, ...]]:
        return _outward(self._layout, r, r.edge, r.node, 0.0, frozenset({r.node}))


def _outward(
    layout: Layout, r: Requester, edge: EdgeId, node: NodeId, gone: float, seen: frozenset[NodeId]
) -> Iterator[tuple[Provider, ...]]:
    e = layout.edge[edge]
    if e.one_way and e.a == node:
        yield (Provider(ProviderKind.ONE_WAY, e.section),)
        return
    far = layout.far(edge, node)
    gone += e.length
    if far in seen:
        yield ()  # a closed ring: nothing comes from outside
        return
    seen = seen | {far}
    if far in layout.buffer_at:
        yield (Provider(ProviderKind.BUFFER, far),)
        return
    signal = layout.signal_facing.get((far, edge))
    if signal is not None and gone >= r.clear_of:
        yield (Provider(ProviderKind.SIGNAL, signal.id),)
        return
    boundary = layout.boundary_at.get(far)
    if boundary is not None:
        if boundary.kind is BoundaryKind.OUT:
            yield (Provider(ProviderKind.BOUNDARY, far),)
        return
    point = layout.point_at.get(far)
    if point is None:
        crossing = layout.crossing_at.get(far)
        onward = [x.id for x in layout.edges_at[far] if x.id != edge]
        if crossing is not None:
            onward = [b if edge == a else a for a, b in crossing.arms if edge in (a, b)]
        for nxt in onward:
            yield from _outward(layout, r, nxt, far, gone, seen)
        return
    position = point.position_of(edge)
    if position is None:
        for left in _outward(layout, r, point.normal, far, gone, seen):
            for right in _outward(layout, r, point.reverse, far, gone, seen):
                yield tuple(dict.fromkeys(left + right))
        return
    turned: tuple[Provider, ...] | None = (Provider(ProviderKind.POINT, point.machine, position.other),)
    if point.machine in layout.by_hand and position.other is Position.REVERSE:
        turned = None  # a key locks a hand-worked point in normal only
    beyond = _outward(layout, r, point.toe, far, gone, seen)
    first = next(beyond, None)
    by_signal = layout.principles.flank_by is FlankChoice.SIGNAL and r.node not in layout.crossing_at
    preferred = _BY_SIGNAL if by_signal else _PASSIVE
    if first is not None and all(p.kind in preferred for p in first):
        yield first
        first = None
    if turned is not None:
        yield turned
    if first is not None:
        yield first
    yield from beyond


def space(layout: Layout, r: Requester, providers: Sequence[Provider]) -> dict[tuple[str, bool], str]:
    """What the principles ask of the flank space: sections to be clear (False), stop lamps to be intact (True).

    Walks outward from the requester again and stops at the chosen providers; round a balloon loop it comes back the
    other way, as a vehicle could.
    """
    found: dict[tuple[str, bool], str] = {}
    rules = layout.principles
    todo: list[tuple[EdgeId, NodeId, float]] = [(r.edge, r.node, 0.0)]
    seen: dict[tuple[EdgeId, NodeId], float] = {}  # by the shortest way: there a signal counts least
    while todo:
        edge, node, gone = todo.pop()
        e = layout.edge[edge]
        if seen.get((edge, node), inf) <= gone or (e.one_way and e.a == node):
            continue
        seen[edge, node] = gone
        if rules.flank_space and e.section != r.section and e.section not in layout.undetected:
            found.setdefault((e.section, False), f"{e.section} lies between {r.name} and its protection")
        far = layout.far(edge, node)
        gone += e.length
        if far == r.node or far in layout.buffer_at or far in layout.boundary_at:
            continue
        signal = layout.signal_facing.get((far, edge))
        if signal is not None and gone >= r.clear_of:
            if rules.flank_lamp and rules.lamp_proof:
                found.setdefault((signal.id, True), f"{signal.id} protects {r.name} only while its stop lamp is intact")
            continue
        point = layout.point_at.get(far)
        crossing = layout.crossing_at.get(far)
        if point is None:
            onward = [x.id for x in layout.edges_at[far] if x.id != edge]
            if crossing is not None:
                onward = [b if edge == a else a for a, b in crossing.arms if edge in (a, b)]
        elif (position := point.position_of(edge)) is None:
            onward = [point.normal, point.reverse]
        elif Provider(ProviderKind.POINT, point.machine, position.other) in providers:
            onward = []
        else:
            onward = [point.toe]
        todo += [(x, far, gone) for x in onward]
    return found


def point_demands(providers: Sequence[Provider]) -> dict[MachineId, Position] | None:
    """The positions that providers demand, or None when they contradict each other."""
    found: dict[MachineId, Position] = {}
    for p in providers:
        if p.position is not None and found.setdefault(MachineId(p.name), p.position) is not p.position:
            return None
    return found


def consistent(a: Demands, b: Demands) -> bool:
    """Whether two sets of positions can hold together."""
    return all(b.get(m, x) is x for m, x in a.items())


def protect(
    layout: Layout, t: Traversal, own: Demands, routes: Sequence[Demands], options: Options
) -> tuple[tuple[FlankCell, ...], tuple[Requester, ...]]:
    """The flank cells of one way through a section, and the requesters left unprotected.

    The first choice of providers that contradicts neither the way itself nor any route over it wins; then one that
    leaves out waived places; then one that only contradicts routes (those are reported as impossible).
    """
    wanted = requesters(layout, t)
    open_: list[Requester] = []
    asked: list[Requester] = []
    for r in wanted:
        (asked if options.preferred(r) is not None else open_).append(r)
    unwaived = [r for r in asked if r.waiver is None]
    for search, others in ((asked, routes), (unwaived, routes), (asked, ())):
        chosen = _choose(options, search, 0, dict(own), others)
        if chosen is not None:
            cells = [_cell(r, providers) for r, providers in zip(search, chosen, strict=True)]
            cells += [
                FlankCell(
                    r.name,
                    r.section,
                    (Provider(ProviderKind.WAIVED, r.waiver),),
                    Because("R5", f"the layout waives the protection of {r.name}: {r.waiver}"),
                )
                for r in wanted
                if r not in search and r.waiver is not None
            ]
            return tuple(cells), tuple(r for r in open_ if r.waiver is None)
    return (), wanted


def _choose(
    options: Options, asked: Sequence[Requester], i: int, demands: dict[MachineId, Position], routes: Sequence[Demands]
) -> list[tuple[Provider, ...]] | None:
    if i == len(asked):
        return []
    for option in options.of(asked[i]):
        more = point_demands(option)
        if more is None or not consistent(more, demands) or any(not consistent(more, r) for r in routes):
            continue
        rest = _choose(options, asked, i + 1, {**demands, **more}, routes)
        if rest is not None:
            return [option, *rest]
    return None


def _cell(r: Requester, providers: tuple[Provider, ...]) -> FlankCell:
    told = {
        ProviderKind.POINT: "point {} turns vehicles away",
        ProviderKind.SIGNAL: "signal {} at stop, clear of the fouling point",
        ProviderKind.BUFFER: "the track ends at {}",
        ProviderKind.BOUNDARY: "no train comes in at {}",
        ProviderKind.ONE_WAY: "{} runs one way only",
        ProviderKind.WAIVED: "waived: {}",
    }
    text = " and ".join(told[p.kind].format(p) for p in providers) or "a closed ring, nothing comes from outside"
    return FlankCell(r.name, r.section, providers, Because("R5", f"towards {r.name}: {text}"))
