"""The layout: every element, resolved and checked, in a fixed order.

Built by the front end; read by everything else.  The digest ignores spans, and the source order of named elements; that
of lists (what is excluded, hostile, demanded) and of substations counts.
"""

from __future__ import annotations

import hashlib
import inspect
import json
from collections.abc import Callable, Hashable, Mapping
from dataclasses import asdict, field, replace
from functools import cached_property, wraps
from typing import Any, TypeVar, TypeVarTuple

from interlock.dataclass import dataclass
from interlock.model.elements import (
    Anchor,
    Barred,
    Demanded,
    DemandedClear,
    Edge,
    EdgeId,
    Exclude,
    Health,
    NamedRoute,
    NodeId,
    SectionId,
    Substation,
    TelegramForm,
    TitleBlock,
    Voyage,
    Waiver,
    Zone,
)
from interlock.model.facts import Facts
from interlock.model.machines import Machines
from interlock.model.pins import Pins
from interlock.model.principles import Principles
from interlock.model.signalling import Overlaps, Signalling
from interlock.model.target import Target
from interlock.model.track import Pointwork, Track

V = TypeVar("V")
Ts = TypeVarTuple("Ts")


@dataclass(frozen=True, eq=False)
class Declared(Facts):
    """What the author says of routes and movements, which follows from no element."""

    excluded: tuple[Exclude, ...] = ()
    barred: tuple[Barred, ...] = ()
    demanded: tuple[Demanded | DemandedClear, ...] = ()
    waivers: tuple[Waiver, ...] = ()
    named_routes: tuple[NamedRoute, ...] = ()
    named_kinds: tuple[tuple[str, bool | None], ...] = ()
    """Names of routes of which the kind is stated: whether it is a shunt route; None: a call-on route."""
    unlisted: tuple[str, ...] = ()
    """Names of routes that are not printed."""
    automatic: tuple[NamedRoute, ...] = ()
    voyages: tuple[Voyage, ...] = ()
    zones: tuple[Zone, ...] = ()
    no_berths: tuple[SectionId, ...] = ()
    """Roads that would be berths, and into which shunting movements are to come only when they are clear."""


@dataclass(frozen=True, eq=False)
class Hardware(Facts):
    """The controller and its substations."""

    target: Target | None = None
    """The controller for which the text is meant; no text and no proof depends on it."""
    substations: tuple[Substation, ...] = ()
    addresses: tuple[tuple[str, str], ...] = ()
    telegram: TelegramForm = TelegramForm.NONE
    health: tuple[Health, ...] = ()
    """How substations are seen to be well, where that is stated."""
    pins: Pins = field(default_factory=Pins)
    """Addresses that stay, of a file beside the layout; no fact about the railway, and not in its digest."""


@dataclass(frozen=True, eq=False)
class Printed(Facts):
    """What is only drawn and printed."""

    title: str = ""
    title_block: TitleBlock | None = None
    """What the title block of printed forms says, where the layout states it."""
    labels: Mapping[str, str] = field(default_factory=dict)
    """What is written at a boundary in place of its name."""
    drawing: tuple[tuple[SectionId, int], ...] = ()
    anchors: tuple[Anchor, ...] = ()
    """Elements that have a place on the plan."""


@dataclass(frozen=True, eq=False)
class Layout(Facts):
    """A railway as resolved facts.  Every tuple is ordered by id, where its entries have one."""

    name: str
    profile: str
    principles: Principles
    track: Track
    pointwork: Pointwork
    signalling: Signalling
    overlaps: Overlaps
    declared: Declared
    hardware: Hardware
    printed: Printed

    @cached_property
    def _found(self) -> dict[Hashable, Any]:
        """What functions `of_layout` have found about it."""
        return {}

    @cached_property
    def machines(self) -> Machines:
        """Everything that is moved and locked: machines of points, and devices."""
        points = self.pointwork.points
        return Machines(points, self.signalling.devices, {p.id: self.track.section_of(p.toe) for p in points})

    def onward(self, edge: EdgeId, node: NodeId) -> tuple[Edge, ...]:
        """The edges onto which a vehicle can go on that comes over an edge to a node, whatever points do."""
        point, crossing = self.pointwork.point_at.get(node), self.pointwork.crossing_at.get(node)
        if point is not None:
            ways: tuple[EdgeId, ...] = (point.normal, point.reverse) if edge == point.toe else (point.toe,)
        elif crossing is not None:
            ways = tuple(b if edge == a else a for a, b in crossing.arms if edge in (a, b))
        else:
            return tuple(e for e in self.track.edges_at[node] if e.id != edge)
        return tuple(self.track.edge[x] for x in ways)

    @cached_property
    def bare(self) -> Layout:
        """The same railway without lengths, for whatever controller, and without what is only printed: hands of
        points, the title block, places on the plan."""
        track, pointwork, overlaps = self.track, self.pointwork, self.overlaps
        return replace(
            self,
            track=replace(
                track,
                edges=tuple(replace(e, length=0.0) for e in track.edges),
                boundaries=tuple(replace(b, approach_m=0.0) for b in track.boundaries),
            ),
            pointwork=replace(
                pointwork,
                points=tuple(replace(p, fouling=0.0) for p in pointwork.points),
                crossings=tuple(replace(c, fouling=0.0) for c in pointwork.crossings),
                hands=(),
            ),
            overlaps=replace(
                overlaps,
                all=tuple(replace(o, length=0.0) for o in overlaps.all),
                ways=tuple(replace(o, length=0.0) for o in overlaps.ways),
            ),
            hardware=replace(self.hardware, target=None),
            printed=replace(self.printed, title_block=None, anchors=()),
        )

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the facts (labels and titles included), independent of the source order of named elements."""
        return hashlib.sha256(self.to_text().encode()).hexdigest()

    def to_text(self) -> str:
        """One readable, canonical text form."""
        stated = asdict(self, dict_factory=lambda found: {k: v for k, v in found if v or k not in _OF_ENTRIES})
        for part in _PARTS:
            stated |= {_IN_TEXT.get((part, k), k): v for k, v in stated.pop(part).items()}
        facts = {k: v for k, v in stated.items() if k != "pins" and (v or k not in _ONLY_STATED)}
        return json.dumps(facts, indent=1, sort_keys=True, ensure_ascii=False)


_PARTS = ("track", "pointwork", "signalling", "overlaps", "declared", "hardware", "printed")
_IN_TEXT = {
    ("signalling", "releases"): "signal_releases",
    ("overlaps", "all"): "overlaps",
    ("overlaps", "ways"): "overlap_ways",
    ("overlaps", "bars"): "overlap_bars",
    ("overlaps", "releases"): "overlap_releases",
}
"""Facts of a part whose key in the text is not their name there."""
_OF_ENTRIES = frozenset({"not_via", "called_on", "hold"})
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
        found = layout._found
        if key not in found:
            found[key] = f(layout, *args)
        value: V = found[key]
        return value

    return known


def carried(f: Callable[[Layout], V], layout: Layout, made: Layout) -> None:
    """What a function `of_layout` finds about a layout holds of one that is made of it, too: there it is not asked."""
    made._found[inspect.unwrap(f), ()] = f(layout)
