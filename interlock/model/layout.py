"""The layout: every element, resolved and checked, in a fixed order.

Built by the front end; read by everything else.  The digest ignores source order and spans.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Hashable, Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from functools import cached_property, wraps
from typing import Any, TypeVar, TypeVarTuple

from interlock.model.elements import (
    Anchor,
    Barred,
    Blades,
    Boundary,
    Buffer,
    Condition,
    Crossing,
    CrossingId,
    Demanded,
    DemandedClear,
    Device,
    Distant,
    Edge,
    EdgeId,
    Exclude,
    Hand,
    Health,
    MachineId,
    NamedRoute,
    NodeId,
    Overlap,
    OverlapWay,
    Point,
    PointId,
    Section,
    SectionId,
    Signal,
    SignalId,
    Substation,
    TelegramForm,
    TitleBlock,
    Voyage,
    Waiver,
    Zone,
)
from interlock.model.machines import Machines, grouped
from interlock.model.pins import Pins
from interlock.model.principles import Principles
from interlock.model.target import Target

V = TypeVar("V")
Ts = TypeVarTuple("Ts")


@dataclass(frozen=True, eq=False)
class Layout:
    """A railway as resolved facts.  Every tuple is ordered by id."""

    name: str
    title: str
    profile: str
    principles: Principles
    sections: tuple[Section, ...]
    edges: tuple[Edge, ...]
    points: tuple[Point, ...]
    crossings: tuple[Crossing, ...]
    boundaries: tuple[Boundary, ...]
    buffers: tuple[Buffer, ...]
    signals: tuple[Signal, ...]
    conditions: tuple[Condition, ...]
    devices: tuple[Device, ...]
    waivers: tuple[Waiver, ...]
    named_routes: tuple[NamedRoute, ...]
    excluded: tuple[Exclude, ...] = ()
    overlaps: tuple[Overlap, ...] = ()
    distants: tuple[Distant, ...] = ()
    voyages: tuple[Voyage, ...] = ()
    automatic: tuple[NamedRoute, ...] = ()
    zones: tuple[Zone, ...] = ()
    substations: tuple[Substation, ...] = ()
    addresses: tuple[tuple[str, str], ...] = ()
    telegram: TelegramForm = TelegramForm.NONE
    drawing: tuple[tuple[SectionId, int], ...] = ()
    anchors: tuple[Anchor, ...] = ()
    """Elements that have a place on the plan."""
    blades: tuple[Blades, ...] = ()
    barred: tuple[Barred, ...] = ()
    demanded: tuple[Demanded | DemandedClear, ...] = ()
    boards: tuple[SignalId, ...] = ()
    """Boards without lamps, of the kind of signal whose routes end there; no route begins at one."""
    stops: tuple[SignalId, ...] = ()
    """Where train routes end and none begins: stop boards, and shunt signals that the author says so of."""
    identifiers: tuple[SignalId, ...] = ()
    """Main signals that a longer route can pass: they show an identifier light meanwhile."""
    overlap_ways: tuple[OverlapWay, ...] = ()
    overlap_bars: tuple[tuple[SignalId, SectionId | EdgeId], ...] = ()
    """Sections and edges over which no alternative of a signal's overlap leads, as the author chose (R4)."""
    """Alternatives of overlaps with values of their own; of several that fit, the first counts."""
    entry_speeds: tuple[tuple[SignalId, int], ...] = ()
    """Signals with an overlap that is made for a speed (km/h): no train to it is shown more, but where its alternative
    has a speed of its own."""
    overlap_releases: tuple[tuple[SignalId, float], ...] = ()
    """Seconds after which the overlap of a signal is released, where it has a time of its own."""
    signal_releases: tuple[tuple[SignalId, float], ...] = ()
    """Seconds for which the routes of a signal are held after a cancellation, where it has a time of its own."""
    supervision: tuple[tuple[MachineId, float], ...] = ()
    """Seconds of supervision of machines that have a time of their own."""
    unlisted: tuple[str, ...] = ()
    """Names of routes that are not printed."""
    named_kinds: tuple[tuple[str, bool | None], ...] = ()
    """Names of routes of which the kind is stated: whether it is a shunt route; None: a call-on route."""
    no_berths: tuple[SectionId, ...] = ()
    """Roads that would be berths, and into which shunting movements are to come only when they are clear."""
    hands: tuple[tuple[PointId, Hand], ...] = ()
    """The side to which the reverse leg of a point lies, where the layout states it; only printed."""
    target: Target | None = None
    """The controller for which the text is meant; no text and no proof depends on it."""
    health: tuple[Health, ...] = ()
    """How substations are seen to be well, where that is stated."""
    title_block: TitleBlock | None = None
    """What the title block of printed forms says, where the layout states it."""
    labels: Mapping[str, str] = field(default_factory=dict, compare=False)
    pins: Pins = field(default_factory=Pins)
    """Addresses that stay, of a file beside the layout; no fact about the railway, and not in its digest."""

    def __getstate__(self) -> dict[str, Any]:
        """The facts alone; what was found about them is found again elsewhere."""
        return {f.name: getattr(self, f.name) for f in fields(self)}

    @cached_property
    def found(self) -> dict[Hashable, Any]:
        """What functions `of_layout` have found about it."""
        return {}

    @cached_property
    def edge(self) -> dict[EdgeId, Edge]:
        """Edges by id."""
        return {e.id: e for e in self.edges}

    @cached_property
    def section(self) -> dict[SectionId, Section]:
        """Sections by id."""
        return {s.id: s for s in self.sections}

    @cached_property
    def point(self) -> dict[PointId, Point]:
        """Points by id."""
        return {p.id: p for p in self.points}

    @cached_property
    def crossing(self) -> dict[CrossingId, Crossing]:
        """Crossings by id."""
        return {c.id: c for c in self.crossings}

    @cached_property
    def signal(self) -> dict[SignalId, Signal]:
        """Signals by id."""
        return {s.id: s for s in self.signals}

    @cached_property
    def point_at(self) -> dict[NodeId, Point]:
        """The point that stands at a node."""
        return {p.node: p for p in self.points}

    @cached_property
    def points_in(self) -> dict[SectionId, tuple[Point, ...]]:
        """The points of a section: those whose toe lies in it."""
        return grouped((self.section_of(p.toe), p) for p in self.points)

    @cached_property
    def crossing_at(self) -> dict[NodeId, Crossing]:
        """The crossing that lies at a node."""
        return {c.node: c for c in self.crossings}

    @cached_property
    def boundary_at(self) -> dict[NodeId, Boundary]:
        """The boundary at a node."""
        return {b.node: b for b in self.boundaries}

    @cached_property
    def buffer_at(self) -> dict[NodeId, Buffer]:
        """The buffer at a node."""
        return {b.node: b for b in self.buffers}

    @cached_property
    def edges_at(self) -> dict[NodeId, tuple[Edge, ...]]:
        """The edges that end at a node."""
        return grouped((n, e) for e in self.edges for n in (e.a, e.b))

    @cached_property
    def edges_in(self) -> dict[SectionId, tuple[Edge, ...]]:
        """The edges of a section."""
        return grouped((e.section, e) for e in self.edges)

    @cached_property
    def signal_facing(self) -> dict[tuple[NodeId, EdgeId], Signal]:
        """The signal that a vehicle meets at a node before it goes onto an edge."""
        return {(g.node, g.into): g for g in self.signals}

    @cached_property
    def hand(self) -> dict[PointId, Hand]:
        """The side to which the reverse leg of a point lies, seen from its toe, where it is stated."""
        return dict(self.hands)

    @cached_property
    def machines(self) -> Machines:
        """Everything that is moved and locked: machines of points, and devices."""
        return Machines(self.points, self.devices, {p.id: self.section_of(p.toe) for p in self.points})

    @cached_property
    def overlap_of(self) -> dict[SignalId, float]:
        """Metres of overlap beyond each main signal that has one."""
        return {o.signal: o.length for o in self.overlaps}

    @cached_property
    def undetected(self) -> frozenset[SectionId]:
        """Sections without detection."""
        return frozenset(s.id for s in self.sections if not s.detected)

    def opens(self, signal: SignalId, shunt: bool) -> bool:
        """Whether routes for trains, or for shunting movements, may begin at a signal."""
        return signal not in self.boards and (shunt or signal not in self.stops)

    def onward(self, edge: EdgeId, node: NodeId) -> tuple[Edge, ...]:
        """The edges onto which a vehicle can go on that comes over an edge to a node, whatever points do."""
        point, crossing = self.point_at.get(node), self.crossing_at.get(node)
        if point is not None:
            ways: tuple[EdgeId, ...] = (point.normal, point.reverse) if edge == point.toe else (point.toe,)
        elif crossing is not None:
            ways = tuple(b if edge == a else a for a, b in crossing.arms if edge in (a, b))
        else:
            return tuple(e for e in self.edges_at[node] if e.id != edge)
        return tuple(self.edge[x] for x in ways)

    def far(self, edge: EdgeId, node: NodeId) -> NodeId:
        """The other end of an edge."""
        e = self.edge[edge]
        return e.b if e.a == node else e.a

    def section_of(self, edge: EdgeId) -> SectionId:
        """The section of an edge."""
        return self.edge[edge].section

    @cached_property
    def bare(self) -> Layout:
        """The same railway without lengths, for whatever controller, and without what is only printed: hands of
        points, the title block, places on the plan."""
        return replace(
            self,
            target=None,
            edges=tuple(replace(e, length=0.0) for e in self.edges),
            points=tuple(replace(p, fouling=0.0) for p in self.points),
            overlaps=tuple(replace(o, length=0.0) for o in self.overlaps),
            overlap_ways=tuple(replace(o, length=0.0) for o in self.overlap_ways),
            boundaries=tuple(replace(b, approach_m=0.0) for b in self.boundaries),
            hands=(),
            title_block=None,
            anchors=(),
        )

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the facts (labels and titles included), independent of source order."""
        return hashlib.sha256(self.to_text().encode()).hexdigest()

    def to_text(self) -> str:
        """One readable, canonical text form."""
        stated = asdict(self, dict_factory=lambda found: {k: v for k, v in found if v or k not in _OF_CHOICES})
        facts = {k: v for k, v in stated.items() if k != "pins" and (v or k not in _ONLY_STATED)}
        return json.dumps(facts, indent=1, sort_keys=True, ensure_ascii=False)


_OF_CHOICES = frozenset({"not_via", "called_on"})
_ONLY_STATED = frozenset(
    {"blades", "barred", "demanded", "boards", "stops", "supervision", "unlisted", "hands", "target", "health"}
    | {"title_block", "named_kinds", "no_berths", "signal_releases", "anchors"}
    | {"overlap_ways", "overlap_bars", "entry_speeds", "overlap_releases", "identifiers"}
)
"""Written only where there are any: a new element of the language changes no digest of layouts that do not have it."""


def of_layout(f: Callable[[Layout, *Ts], V]) -> Callable[[Layout, *Ts], V]:
    """A function of a layout and of values that can be hashed; it remembers in the layout what it has found about it,
    for as long as the layout lives."""

    @wraps(f)
    def known(layout: Layout, *args: *Ts) -> V:
        key = (f, args)
        found = layout.found
        if key not in found:
            found[key] = f(layout, *args)
        value: V = found[key]
        return value

    return known
