"""The cells of the interlocking table, each with its reason.

Every derived cell carries `Because(rule, text)`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import StrEnum
from functools import cached_property
from typing import overload

from interlock.dataclass import dataclass
from interlock.model.bits import chosen
from interlock.model.elements import (
    ConditionId,
    CrossingId,
    MachineId,
    NodeId,
    PointId,
    Position,
    RouteId,
    SectionId,
    SignalId,
)
from interlock.model.places import Approach

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
    hold: float | None = None
    """Seconds for which the route holds what was added to it after it would let it go; None where it does not."""


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
    """A section outside the path that must be clear because of a foul joint (R7), or of a diamond's other arm (R6).

    `of`: the section of the path that it fouls.  With `when`, only while that machine is not detected in the other
    position (lost detection counts as foul).  `crossing`: the diamond on which a vehicle there may stand, or the point
    or diamond, not on the way, beside which it is too near to the way; None at a foul joint of what lies on the way.
    """

    section: SectionId
    of: SectionId
    when: tuple[MachineId, Position] | None
    because: Because
    crossing: CrossingId | PointId | None = None


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


DEMANDED = "demanded: "
"""With which the reason begins of what the author demands."""


def authors_reason(because: Because) -> str:
    """The reason of what the author demands, in his own words."""
    return because.text.removeprefix(DEMANDED)


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
    TWO_YELLOWS = "two yellows"
    NEXT = "clear if the next signal is open"
    SHUNT = "shunt"
    CALL_ON = "call-on"
    IDENTIFIER = "identifier"


@dataclass(frozen=True)
class AspectCell:
    """What an open signal shows; `next`: the signal that decides between clear and caution; `indicator`: true where its
    route indicator is lit, too, which tells a branching direction of departure."""

    shows: Shows
    next: SignalId | None
    because: Because
    indicator: bool | None = None


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
