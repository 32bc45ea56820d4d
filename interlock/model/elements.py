"""The elements of a layout, resolved and frozen.

A layout is a graph.  An `Edge` is a stretch of track within one section; edges meet at nodes.  A node
is a point, a crossing, a boundary, a buffer, a joint between two sections, or a plain continuation.
All lengths are in metres.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import field
from enum import StrEnum
from math import isinf
from typing import NewType

from interlock.dataclass import dataclass

SectionId = NewType("SectionId", str)
SignalId = NewType("SignalId", str)
PointId = NewType("PointId", str)
MachineId = NewType("MachineId", str)
CrossingId = NewType("CrossingId", str)
NodeId = NewType("NodeId", str)
EdgeId = NewType("EdgeId", str)
ConditionId = NewType("ConditionId", str)
RouteId = NewType("RouteId", str)


class Position(StrEnum):
    """How a point lies.  Normal is 定位 / Plus, reverse is 反位 / Minus."""

    NORMAL = "N"
    REVERSE = "R"

    @property
    def other(self) -> Position:
        """The opposite position."""
        return Position.REVERSE if self is Position.NORMAL else Position.NORMAL


class Hand(StrEnum):
    """The side to which a leg of a point lies, seen from its toe."""

    LEFT = "left"
    RIGHT = "right"

    @property
    def other(self) -> Hand:
        """The other side."""
        return Hand.RIGHT if self is Hand.LEFT else Hand.LEFT


class BoundaryKind(StrEnum):
    """Which way trains pass a boundary, seen from inside the layout."""

    BOTH = "both"
    IN = "in"
    OUT = "out"


class BlockKind(StrEnum):
    """How trains are kept apart on the line beyond a boundary (R12)."""

    NONE = "none"
    SEMI_AUTOMATIC = "semi-automatic"
    AUTOMATIC = "automatic"
    TOKEN = "token"


class Lane(StrEnum):
    """Kind of line in a mine (document A, section 1)."""

    LEVEL = "level"
    INCLINED = "inclined"


@dataclass(frozen=True)
class Section:
    """A section.  An approach section lies outside, in rear of an entry signal.

    A siding without detection is a section all the same: it always counts as occupied.  `speed`: km/h permitted in it,
    where the layout states it.
    """

    id: SectionId
    approach: bool = False
    lane: Lane = Lane.LEVEL
    detected: bool = True
    speed: int | None = None


@dataclass(frozen=True)
class Edge:
    """A stretch of track between two nodes within one section; trains run over it from a to b alone if it is `one_way`,
    and so does whatever rolls, but for vehicles that run away on an inclined lane."""

    id: EdgeId
    a: NodeId
    b: NodeId
    length: float
    section: SectionId
    one_way: bool = False
    inclined: bool = False

    def nothing_comes_to(self, node: NodeId) -> bool:
        """Whether nothing comes over it to one of its ends: neither a train nor vehicles that roll (R5)."""
        return self.one_way and not self.inclined and self.a == node


class Work(StrEnum):
    """How a point is worked: by a motor, or by hand once a key is released (normal is the locked position)."""

    MOTOR = "motor"
    HAND = "hand"


@dataclass(frozen=True)
class Point:
    """One end of a set of points: three edges at one node, worked by a machine.

    `fouling` is the distance from the node to the fouling point (警冲标 / Grenzzeichen) on either leg.
    `speed`: km/h permitted over the reverse leg, where the layout states it.
    A derailer is a point whose normal leg leads off the rails: normal is on, reverse is off.
    """

    id: PointId
    machine: MachineId
    node: NodeId
    toe: EdgeId
    normal: EdgeId
    reverse: EdgeId
    fouling: float
    work: Work = Work.MOTOR
    derailer: bool = False
    speed: int | None = None

    def leg(self, position: Position) -> EdgeId:
        """The edge to which the point leads in that position."""
        return self.normal if position is Position.NORMAL else self.reverse

    def position_of(self, edge: EdgeId) -> Position | None:
        """The position that leads to the edge, or None for the toe."""
        if edge == self.normal:
            return Position.NORMAL
        return Position.REVERSE if edge == self.reverse else None


@dataclass(frozen=True)
class Blades:
    """Where the blades of a point of a slip lie, and to which end of the slip they lead in normal and in reverse.

    Printed for those who wire it.  Blades at two ends are those of one side: they lead to the same end.
    """

    point: PointId
    at: tuple[str, ...]
    normal: str
    reverse: str

    def to(self, position: Position) -> str:
        """The end to which they lead in a position."""
        return self.normal if position is Position.NORMAL else self.reverse


@dataclass(frozen=True)
class Anchor:
    """Where the layout says that an element lies on the plan: to the right and downwards, in pixels; of a slip that is
    two points the middle of both."""

    nodes: tuple[NodeId, ...]
    x: float
    y: float


@dataclass(frozen=True)
class Crossing:
    """A diamond crossing: two arms through one node, each a pair of edges.

    `fouling` is the distance in metres, along each arm to either side, within which a vehicle is in the way of whoever
    passes the other arm; of a slip's diamond it is not less than the principle, since the slip's own is counted from
    its points.
    """

    id: CrossingId
    node: NodeId
    arms: tuple[tuple[EdgeId, EdgeId], tuple[EdgeId, EdgeId]]
    fouling: float


@dataclass(frozen=True)
class Boundary:
    """Where trains come in or leave; `approach` is the section outside it, in rear of the entry signal.

    `button`: the name of the operator's button that ends departure routes here; `indicator`: departures this way are
    shown by a route indicator.  `approach_m`: metres of the approach section.
    """

    node: NodeId
    kind: BoundaryKind
    approach: SectionId | None
    block: BlockKind = BlockKind.NONE
    button: str = ""
    indicator: bool = False
    approach_m: float = 0.0

    @property
    def checked(self) -> bool:
        """Whether a departure is tied to the line beyond: by its block, or by a section reported clear."""
        return self.block is not BlockKind.NONE or self.approach is not None


class BufferKind(StrEnum):
    """What the end of a track is: a buffer stop, a trap (sand drag, 安全线) that no route enters, or off the rails."""

    STOP = "stop"
    TRAP = "trap"
    DERAIL = "derail"


@dataclass(frozen=True)
class Buffer:
    """End of track."""

    node: NodeId
    kind: BufferKind = BufferKind.STOP


class DeviceKind(StrEnum):
    """What a device is, other than a point, that routes lock."""

    LEVEL_CROSSING = "level crossing"
    INTERLOCK = "interlock"
    DOOR = "door"


@dataclass(frozen=True)
class Device:
    """A level crossing, bridge, door or hoist: normal is open (released), reverse is closed (secured for trains); of
    what is told as a door, normal is shut and reverse is open.

    It is worked like a machine, and brought to reverse for every movement over one of `over`.
    `air_lock`: the air lock whose door it is, of which never more than one is open (R13); empty: of none.  `beside`:
    its other doors.
    """

    id: MachineId
    kind: DeviceKind
    text: str
    over: tuple[SectionId, ...]
    air_lock: str = ""
    beside: tuple[MachineId, ...] = ()


class SignalKind(StrEnum):
    """What a signal governs: train movements, shunting, or both (combined: 列车兼调车)."""

    MAIN = "main"
    SHUNT = "shunt"
    COMBINED = "combined"


@dataclass(frozen=True)
class Signal:
    """A signal at a joint; a movement that passes it goes onto edge `into`.

    A train obeys main and combined signals and passes a shunt signal whatever it shows; a shunting movement obeys all.
    `call_on`: beside the stop aspect it can call a train on over sections that are reported occupied.
    """

    id: SignalId
    node: NodeId
    into: EdgeId
    kind: SignalKind = SignalKind.MAIN
    call_on: bool = False

    @property
    def main(self) -> bool:
        """Whether train routes begin and end here."""
        return self.kind is not SignalKind.SHUNT

    @property
    def shunt(self) -> bool:
        """Whether shunt routes begin here (shunt routes end at every signal)."""
        return self.kind is not SignalKind.MAIN


@dataclass(frozen=True)
class Distant:
    """A distant or repeating signal: it announces a main signal, and is never at stop itself."""

    id: SignalId
    of: SignalId


@dataclass(frozen=True)
class Condition:
    """A named input from outside (hoist stopped, barrier closed) that routes require.

    It is required by every route over one of `over`, or with an overlap over one, by every route from one of `signals`,
    and by every train route that leaves at one of `exits`.
    """

    id: ConditionId
    text: str
    over: tuple[SectionId, ...]
    signals: tuple[SignalId, ...]
    exits: tuple[NodeId, ...] = ()


@dataclass(frozen=True)
class Zone:
    """Sections in which no more than a number of trains may be (R17)."""

    id: str
    sections: tuple[SectionId, ...]
    trains: int


@dataclass(frozen=True)
class Waiver:
    """Flank protection that the author gives up for one leg of a point, with the reason."""

    point: PointId
    leg: Position
    reason: str


@dataclass(frozen=True)
class NamedRoute:
    """A name that the author gives to a derived route, for instance one that a document uses."""

    name: str
    entry: SignalId
    exit: str
    via: tuple[SectionId, ...] = field(default=())


@dataclass(frozen=True)
class Voyage:
    """A chain of routes that one command sets (航程), asked for from the near end or, combined routes, from the far.

    `forward`: in the main direction of transport (顺向).
    """

    name: str
    entry: SignalId
    exit: str
    via: tuple[SectionId, ...]
    shunt: bool
    far_first: bool
    forward: bool = True


@dataclass(frozen=True)
class Overlap:
    """The track beyond a signal that a train may overrun: metres needed; whether its alternatives may change (swing).

    Infinite: a successive route (延续进路), to the next main signal, a boundary or the end of the track.
    """

    signal: SignalId
    length: float
    swing: bool = False

    @property
    def text(self) -> str:
        """The length in words."""
        return "as far as the next main signal" if isinf(self.length) else f"{self.length:g} m"


@dataclass(frozen=True)
class OverlapWay:
    """Those alternatives of a signal's overlap that lead over all of some sections, with values of their own: metres
    needed, and the highest speed that is shown to a train for which one of them is held (entry speed, km/h)."""

    signal: SignalId
    over: tuple[SectionId, ...]
    length: float
    entry: int | None = None


class TelegramForm(StrEnum):
    """How point commands travel to the machines, if not by a wire each (document C)."""

    NONE = "none"
    PLAIN = "plain"
    TAGGED = "tagged"


@dataclass(frozen=True)
class Substation:
    """A cabinet of inputs and outputs (分站), and the elements that are wired to it; empty: all that no other has."""

    name: str
    elements: tuple[str, ...]


class HealthBy(StrEnum):
    """By what it is seen that a substation is well."""

    HEARTBEAT = "heartbeat"
    DIAGNOSIS = "diagnosis"
    BOTH = "both"


HEARTBEAT_MS = 1000
"""Milliseconds in which a heartbeat must change: ten polls (our choice; document D asks for more than a ring's 50)."""


@dataclass(frozen=True)
class Health:
    """How a substation is seen to be well: by a heartbeat, which it changes by itself at least once in `within_ms`, by
    a diagnosis bit of what masters the bus (PROFINET, a Modbus gateway), which is 1 while it is, or by both."""

    substation: str
    by: HealthBy = HealthBy.HEARTBEAT
    within_ms: int = HEARTBEAT_MS

    @property
    def beats(self) -> bool:
        """It has a heartbeat."""
        return self.by is not HealthBy.DIAGNOSIS

    @property
    def diagnosed(self) -> bool:
        """It has a diagnosis bit."""
        return self.by is not HealthBy.HEARTBEAT


@dataclass(frozen=True)
class Choice:
    """Routes chosen by the author: all that begin, end and pass as given (None: anything)."""

    entry: SignalId | None
    exit: str | None
    via: tuple[SectionId, ...]
    not_via: tuple[SectionId, ...]
    shunt: bool | None
    called_on: bool = field(default=False, kw_only=True)
    """Of train routes those alone over which trains are called on; without it these are among the train routes."""

    def fits(
        self,
        entry: SignalId,
        ends: Collection[str],
        sections: Collection[SectionId],
        shunt: bool,
        called_on: bool,
    ) -> bool:
        """Whether a route is among them; `ends`: where it ends, and its last section; `called_on`: a call-on route."""
        return (
            (called_on or not self.called_on)
            and self.entry in (None, entry)
            and (self.exit is None or self.exit in ends)
            and all(s in sections for s in self.via)
            and not any(s in sections for s in self.not_via)
            and self.shunt in (None, shunt)
        )


@dataclass(frozen=True)
class Exclude(Choice):
    """Routes that the author does not want."""

    reason: str


@dataclass(frozen=True)
class TitleBlock:
    """What the title block of printed forms says besides the layout's own title; only printed."""

    company: str = ""
    author: str = ""
    number: str = ""
    revision: str = ""
    date: str = ""


@dataclass(frozen=True)
class Barred:
    """Routes that the author declares hostile, each of the one choice to each of the other, with the reason (R6)."""

    one: Choice
    other: Choice
    reason: str


@dataclass(frozen=True)
class DemandedClear:
    """A section beside or beyond their paths that the author has routes find clear, with the reason (R3)."""

    section: SectionId
    routes: Choice
    reason: str


@dataclass(frozen=True)
class Demanded:
    """A machine that the author has routes lock in a position, with the reason (R5)."""

    machine: MachineId
    position: Position
    routes: Choice
    reason: str
    hold: float = 0.0
    """Seconds for which the routes hold what was added to them after they would let it go."""
    air_lock: str = ""
    """The air lock of which it is another door, where that demands it (R13)."""


def of_points(demands: Iterable[Demanded | DemandedClear]) -> list[Demanded]:
    """The demands of machines."""
    return [d for d in demands if isinstance(d, Demanded)]


def of_sections(demands: Iterable[Demanded | DemandedClear]) -> list[DemandedClear]:
    """The demands of clear sections."""
    return [d for d in demands if isinstance(d, DemandedClear)]
