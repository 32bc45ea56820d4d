"""The interlocking table as frozen values.

Input: built by `derive`.  Output: read by `logic.lower`, the exporters and the audit.
Every derived cell carries `Because(rule, text)`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property
from typing import overload

from interlock.model.bits import chosen
from interlock.model.elements import (
    ConditionId,
    CrossingId,
    MachineId,
    NodeId,
    Position,
    RouteId,
    SectionId,
    SignalId,
)
from interlock.model.places import Approach

SCHEMA_VERSION = 7
TraversalKey = tuple[SectionId, int]


@dataclass(frozen=True)
class Because:
    """Why a cell is as it is: the rule (R1-R18) and a sentence about this very place."""

    rule: str
    text: str


class Role(StrEnum):
    """What a point demand is for."""

    PATH = "path"
    FLANK = "flank"
    DRIVEN = "driven"
    DEVICE = "device"
    OVERLAP = "overlap"
    ADDED = "added"


@dataclass(frozen=True)
class PointDemand:
    """A machine that must lie, be detected and stay locked in a position."""

    machine: MachineId
    position: Position
    role: Role
    section: SectionId
    because: Because


class ProviderKind(StrEnum):
    """What keeps vehicles off a leg or arm (R5)."""

    POINT = "point"
    SIGNAL = "signal"
    BUFFER = "end of track"
    BOUNDARY = "no train comes in"
    ONE_WAY = "one way"
    WAIVED = "waived"


@dataclass(frozen=True)
class Provider:
    """One provider of flank protection; `position` only for points."""

    kind: ProviderKind
    name: str
    position: Position | None = None

    def __str__(self) -> str:
        return f"{self.name} {self.position}" if self.position else self.name


@dataclass(frozen=True)
class FlankCell:
    """A requester (leg of a point or arm of a diamond) with everything that protects it."""

    requester: str
    section: SectionId
    providers: tuple[Provider, ...]
    because: Because


@dataclass(frozen=True)
class ClearCell:
    """A section that must be reported clear."""

    section: SectionId
    because: Because


@dataclass(frozen=True)
class FoulCell:
    """A section outside the path that must be clear and unlocked because of a foul joint (R7).

    `of`: the section of the path that it fouls.  With `when`, only while that machine is not detected in the other
    position (lost detection counts as foul).
    """

    section: SectionId
    of: SectionId
    when: tuple[MachineId, Position] | None
    because: Because


@dataclass(frozen=True)
class SpaceCell:
    """Flank space (R5): a section between a flank and its protection that must be clear, or (`lamp`) a protecting
    signal whose stop lamp must be intact."""

    name: str
    lamp: bool
    because: Because


@dataclass(frozen=True)
class Exclusion:
    """A lock that forbids other locks: while held, none of `others` may be held (diamonds, foul joints).

    `whole` means every lock of that section; otherwise those with the numbers.  A restart lock of the section
    forbids it in any case, since a train may stand anywhere in it.
    """

    section: SectionId
    whole: bool
    numbers: tuple[int, ...]
    because: Because


class HostileClass(StrEnum):
    """Conflict classes of R6, in the order in which they name a reason."""

    POINTS = "points in different positions"
    OPPOSING = "opposing"
    CONVERGING = "converging"
    CROSSING = "crossing"
    FOLLOWING = "following"
    SAME_ENTRY = "same entry"
    FLANK = "flank"
    FOUL = "foul"
    OVERLAP = "overlap"
    ADDED = "added"


@dataclass(frozen=True)
class Hostility:
    """How two routes are hostile: the first class that makes them so, every class, the shared resource that shows the
    first, and its rule.

    In `witness` `{one}` is the route of the lower number and `{other}` that of the higher; what many pairs have in
    common is the same value.
    """

    kind: HostileClass
    kinds: tuple[HostileClass, ...]
    witness: str
    rule: str


@dataclass(frozen=True)
class Hostile:
    """A route that is hostile to the route `of`; first: `of` has the lower number."""

    of: RouteId
    route: RouteId
    first: bool
    how: Hostility

    @property
    def kind(self) -> HostileClass:
        """The first class that makes it so."""
        return self.how.kind

    @property
    def kinds(self) -> tuple[HostileClass, ...]:
        """Every class that does."""
        return self.how.kinds

    @property
    def witness(self) -> str:
        """The shared resource that shows the first class."""
        one, other = (self.of, self.route) if self.first else (self.route, self.of)
        return self.how.witness.format(one=one, other=other)

    @property
    def because(self) -> Because:
        """Rule and reason."""
        return Because(self.how.rule, f"{self.of} and {self.route}: {self.kind}, {self.witness}")


class HostileRoutes(Sequence[Hostile]):
    """The hostile routes of one route, in order of number.

    Their number grows with the square of a yard, and most readers want no more than their ids: what makes each of them
    hostile is told when it is asked for.
    """

    def __init__(self, among: Sequence[RouteId], members: int, tell: Callable[[RouteId], Hostile]) -> None:
        """Those of some routes whose bit is set; `tell`: class, witness and reason of one of them."""
        self._among, self._members = among, members
        self._tell = tell

    @cached_property
    def routes(self) -> tuple[RouteId, ...]:
        """Their ids."""
        return tuple(chosen(self._members, self._among))

    @cached_property
    def _all(self) -> tuple[Hostile, ...]:
        return tuple(map(self._tell, self.routes))

    def __len__(self) -> int:
        return self._members.bit_count()

    @overload
    def __getitem__(self, at: int) -> Hostile: ...
    @overload
    def __getitem__(self, at: slice) -> Sequence[Hostile]: ...
    def __getitem__(self, at: int | slice) -> Hostile | Sequence[Hostile]:
        return self._all[at]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, HostileRoutes) and self._all == other._all

    def __hash__(self) -> int:
        return hash(self.routes)


@dataclass(frozen=True)
class BarredCell:
    """A route that the author declares hostile."""

    route: RouteId
    because: Because


@dataclass(frozen=True)
class ConditionCell:
    """An external input that must be true."""

    condition: ConditionId
    because: Because


@dataclass(frozen=True)
class ZoneCell:
    """A zone with a maximum of trains into which the route leads, and how often it comes in from outside."""

    zone: str
    entries: int
    because: Because


@dataclass(frozen=True)
class TokenCell:
    """The direction token that must be here when a train leaves over a boundary (R12)."""

    boundary: NodeId
    because: Because


@dataclass(frozen=True)
class BlockCell:
    """What must hold beyond a boundary: the approach section of the neighbour reported clear."""

    section: SectionId
    because: Because


@dataclass(frozen=True)
class OverlapCell:
    """The overlap that a route locks beyond its exit signal: one alternative, as ways through sections (R4).

    `swings`: the alternatives that may take its place while the route is set, until a train is close.
    """

    signal: SignalId
    option: int
    swings: tuple[int, ...]
    ways: tuple[TraversalKey, ...]
    metres: float
    because: Because


class Shows(StrEnum):
    """What an open signal shows for a route (R11)."""

    CLEAR = "clear"
    CAUTION = "caution"
    NEXT = "clear if the next signal is open"
    SHUNT = "shunt"
    CALL_ON = "call-on"
    IDENTIFIER = "identifier"


@dataclass(frozen=True)
class AspectCell:
    """What an open signal shows; `next` is the signal that decides between clear and caution."""

    shows: Shows
    next: SignalId | None
    because: Because


@dataclass(frozen=True)
class ApproachCell:
    """Approach locking: from where a train may come (nowhere detected: always approach locked) and the delay."""

    coming: Approach
    delay_s: float
    because: Because

    @property
    def section(self) -> SectionId | None:
        """The section in rear of the signal, None without detection."""
        return self.coming.section

    @property
    def sections(self) -> tuple[SectionId, ...]:
        """Every section from which a train may come, the nearest first; none where the signal is always approach
        locked."""
        always = self.coming.section is None or self.coming.unseen
        return () if always else tuple(dict.fromkeys(self.coming.sections()))


@dataclass(frozen=True)
class SpeedCell:
    """The lowest speed along the route in km/h, where the layout states any; shown to the driver (R11)."""

    kmh: int | None
    because: Because


@dataclass(frozen=True)
class ClosingCell:
    """When the open signal returns to stop: with the first axle, or when the section before it is clear (R3)."""

    whole: SectionId | None
    because: Because


@dataclass(frozen=True)
class ReleaseStep:
    """One section's release: after which section, and which occupation proves the train has gone on."""

    section: SectionId
    after: SectionId | None
    proved_by: str
    delay_s: float
    because: Because


class ExitKind(StrEnum):
    """Where a route ends."""

    SIGNAL = "signal"
    BOUNDARY = "boundary"
    BUFFER = "buffer"
    BERTH = "section"


class RouteKind(StrEnum):
    """Train route, shunt route, call-on route (引导): a train over sections that are reported occupied (R2), or what a
    train route past a signal locks beyond it, while that signal shows its identifier light."""

    MAIN = "main"
    SHUNT = "shunt"
    CALL_ON = "call-on"
    IDENTIFIER = "identifier"


@dataclass(frozen=True)
class TraversalRow:
    """One way through a section, as it is locked: what it demands and what it excludes."""

    section: SectionId
    number: int
    entry: NodeId
    exit: NodeId
    points: tuple[PointDemand, ...]
    crossings: tuple[tuple[CrossingId, int], ...]
    flank: tuple[FlankCell, ...]
    exclusions: tuple[Exclusion, ...]
    foul: tuple[FoulCell, ...]
    space: tuple[SpaceCell, ...]

    @property
    def key(self) -> TraversalKey:
        """Section and number."""
        return (self.section, self.number)


@dataclass(frozen=True)
class RouteRow:
    """One route: entry, exit, alternative, and every derived column.

    `berth`: the shunt route ends in a plain section in which vehicles may stand; it is the last traversal, and the
    only one that need not be clear.  `driven` points are moved along and never checked.  `barred`: those of the hostile
    routes that the author declares so.  `listed`: whether the route is printed.
    `onward`: past the signal at its exit, which shows its identifier light, the train runs on over this route, of kind
    identifier, which may run on over another in the same way; they are set together.  `destination`: where the last
    ends.  `passed`: the signals that the train passes at identifier light, in order.
    `demanded_clear`: sections beside or beyond the path that the author has it find clear; None where there are none.
    """

    id: RouteId
    number: int
    kind: RouteKind
    names: tuple[str, ...]
    entry: SignalId
    entry_node: NodeId
    exit: str
    exit_kind: ExitKind
    variant: int
    traversals: tuple[TraversalKey, ...]
    berth: SectionId | None
    length: float
    points: tuple[PointDemand, ...]
    driven: tuple[PointDemand, ...]
    sections: tuple[ClearCell, ...]
    foul: tuple[FoulCell, ...]
    flank: tuple[FlankCell, ...]
    space: tuple[SpaceCell, ...]
    hostile: HostileRoutes
    barred: tuple[BarredCell, ...]
    overlap: OverlapCell | None
    aspect: AspectCell
    closing: ClosingCell
    speed: SpeedCell
    conditions: tuple[ConditionCell, ...]
    zones: tuple[ZoneCell, ...]
    block: tuple[BlockCell, ...]
    token: TokenCell | None
    approach: ApproachCell
    release: tuple[ReleaseStep, ...]
    listed: bool
    because: Because
    onward: RouteId | None = None
    destination: str | None = None
    passed: tuple[SignalId, ...] | None = None
    demanded_clear: tuple[ClearCell, ...] | None = None

    @property
    def train(self) -> bool:
        """Whether trains run over it, not shunting movements."""
        return self.kind is not RouteKind.SHUNT

    @cached_property
    def kept_clear(self) -> frozenset[SectionId]:
        """The sections of the path that must be reported clear."""
        return frozenset(c.section for c in self.sections)

    @property
    def requirements(self) -> tuple[str, ...]:
        """What must hold besides sections, points and locks, in words: conditions, zones, lamps of the flank."""
        lamps = (f"stop lamp of {c.name}" for c in self.space if c.lamp)
        token = () if self.token is None else (f"direction at {self.token.boundary}",)
        return (*(c.condition for c in self.conditions), *token, *(f"{z.zone} not full" for z in self.zones), *lamps)

    @cached_property
    def added(self) -> tuple[PointDemand, ...]:
        """The machines that the author has the route lock."""
        return tuple(p for p in self.points if p.role is Role.ADDED)

    @property
    def locked(self) -> tuple[TraversalKey, ...]:
        """The ways that the route locks for itself alone: all but the berth."""
        return self.traversals[:-1] if self.berth is not None else self.traversals

    @property
    def section_ids(self) -> tuple[SectionId, ...]:
        """The sections of the path in order."""
        return tuple(s for s, _ in self.traversals)


def last_left(r: RouteRow) -> TraversalKey:
    """The way whose lock a train leaves behind when it is wholly in the last section; the last one, where it leaves the
    layout or there is no other."""
    through = r.locked if r.berth is not None or r.exit_kind is ExitKind.BOUNDARY else r.locked[:-1]
    return (through or r.locked)[-1]


@dataclass(frozen=True)
class Meeting:
    """Two voyages over one single line in opposite directions (敌对航程).

    `sections` in the order of the first voyage.
    """

    voyage: str
    sections: tuple[SectionId, ...]
    because: Because


@dataclass(frozen=True)
class VoyageRow:
    """A voyage: its routes in the order of travel, which of them are asked for first, and whom it meets.

    priority: 1 inclined lane, main direction; 2 inclined, against it; 3 level, main direction; 4 level, against it.
    """

    name: str
    number: int
    routes: tuple[RouteId, ...]
    far_first: bool
    priority: int
    meetings: tuple[Meeting, ...]
    because: Because


@dataclass(frozen=True)
class InterlockingTable:
    """All routes of a layout and the locks that they are made of."""

    layout: str
    layout_digest: str
    routes: tuple[RouteRow, ...]
    locks: tuple[TraversalRow, ...]
    voyages: tuple[VoyageRow, ...] = ()
    automatic: tuple[RouteId, ...] = ()
    """The routes with a switch for automatic working, in the order in which they are offered."""

    @cached_property
    def bare(self) -> InterlockingTable:
        """The same table without lengths, and without the hostile routes, which follow from the rest."""
        return replace(self, layout_digest="", routes=tuple([_bare(r) for r in self.routes]))

    @cached_property
    def route(self) -> dict[RouteId, RouteRow]:
        """Routes by id."""
        return {r.id: r for r in self.routes}

    def parts(self, r: RouteRow) -> tuple[RouteRow, ...]:
        """A route, and what is set with it past one signal after the other."""
        return (r,) if r.onward is None else (r, *self.parts(self.route[r.onward]))

    @cached_property
    def lock(self) -> dict[TraversalKey, TraversalRow]:
        """Locks by section and number."""
        return {t.key: t for t in self.locks}


def _bare(r: RouteRow) -> RouteRow:
    overlap = None if r.overlap is None else replace(r.overlap, metres=0.0)
    return replace(r, length=0.0, hostile=HostileRoutes((), 0, _no_reason), overlap=overlap)


def _no_reason(route: RouteId) -> Hostile:
    raise LookupError(f"a bare table does not tell why {route} is hostile")
