"""The interlocking table as frozen values: its rows, made of cells.

Input: built by `derive`.  Output: read by `logic.lower`, the exporters and the audit.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.model.elements import CrossingId, MachineId, NodeId, RouteId, SectionId, SignalId
from interlock.table.cells import (
    ApproachCell,
    AspectCell,
    BarredCell,
    Because,
    BlockCell,
    ClearCell,
    ClosingCell,
    ConditionCell,
    Exclusion,
    ExitKind,
    FlankCell,
    FoulCell,
    Hostile,
    HostileRoutes,
    OverlapCell,
    PointDemand,
    ReleaseStep,
    Role,
    RouteKind,
    SpaceCell,
    SpeedCell,
    TokenCell,
    TraversalKey,
    ZoneCell,
)

SCHEMA_VERSION = 7


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
class RoutePath:
    """The way of a route over the track, from the node of its entry to its exit.

    `berth`: the shunt route ends in a plain section in which vehicles may stand; it is the last traversal, and the
    only one that need not be clear.
    `onward`: past the signal at its exit, which shows its identifier light, the train runs on over this route, of kind
    identifier, which may run on over another in the same way; they are set together.  `destination`: where the last
    ends.  `passed`: the signals that the train passes at identifier light, in order.
    """

    entry_node: NodeId
    exit_kind: ExitKind
    variant: int
    traversals: tuple[TraversalKey, ...]
    berth: SectionId | None
    length: float
    onward: RouteId | None = None
    destination: str | None = None
    passed: tuple[SignalId, ...] | None = None

    @property
    def locked(self) -> tuple[TraversalKey, ...]:
        """The ways that the route locks for itself alone: all but the berth."""
        return self.traversals[:-1] if self.berth is not None else self.traversals

    @property
    def section_ids(self) -> tuple[SectionId, ...]:
        """The sections of the path in order."""
        return tuple(s for s, _ in self.traversals)


@dataclass(frozen=True)
class RouteLocking:
    """What a route locks and excludes, what keeps it locked, and when it is released.

    `driven` points are moved along and never checked.  `barred`: those of the hostile routes that the author declares
    so.
    """

    points: tuple[PointDemand, ...]
    driven: tuple[PointDemand, ...]
    flank: tuple[FlankCell, ...]
    hostile: HostileRoutes
    barred: tuple[BarredCell, ...]
    overlap: OverlapCell | None
    approach: ApproachCell
    release: tuple[ReleaseStep, ...]

    @cached_property
    def added(self) -> tuple[PointDemand, ...]:
        """The machines that the author has the route lock."""
        return tuple(p for p in self.points if p.role is Role.ADDED)

    @cached_property
    def hold(self) -> float:
        """Seconds for which the route holds what was added to it after it would let it go: the longest of its
        demands'."""
        return max((p.hold for p in self.added if p.hold is not None), default=0.0)

    @property
    def held_longer(self) -> tuple[MachineId, ...]:
        """The machines that it holds so."""
        return tuple(p.machine for p in self.added) if self.hold else ()


@dataclass(frozen=True)
class RouteClear:
    """The track that a route must find clear: of its path, at foul joints, between flanks and their protection.

    `demanded`: sections beside or beyond the path that the author has it find clear; None where there are none.
    """

    sections: tuple[ClearCell, ...]
    foul: tuple[FoulCell, ...]
    space: tuple[SpaceCell, ...]
    demanded: tuple[ClearCell, ...] | None = None

    @cached_property
    def section_ids(self) -> frozenset[SectionId]:
        """The sections of the path that must be reported clear."""
        return frozenset(c.section for c in self.sections)


@dataclass(frozen=True)
class RouteConditions:
    """What a route asks besides points and clear track: external inputs, room in zones, the line beyond a boundary."""

    external: tuple[ConditionCell, ...]
    zones: tuple[ZoneCell, ...]
    block: tuple[BlockCell, ...]
    token: TokenCell | None


@dataclass(frozen=True)
class RouteSignal:
    """What the signal at the entry shows for a route, and when it returns to stop."""

    aspect: AspectCell
    closing: ClosingCell
    speed: SpeedCell


@dataclass(frozen=True)
class RouteRow:
    """One route: entry, exit, and every derived column.  `listed`: whether the route is printed."""

    id: RouteId
    number: int
    kind: RouteKind
    names: tuple[str, ...]
    entry: SignalId
    exit: str
    path: RoutePath
    locking: RouteLocking
    clear: RouteClear
    conditions: RouteConditions
    signal: RouteSignal
    listed: bool
    because: Because

    @property
    def train(self) -> bool:
        """Whether trains run over it, not shunting movements."""
        return self.kind is not RouteKind.SHUNT

    @property
    def requirements(self) -> tuple[str, ...]:
        """What must hold besides sections, points and locks, in words: conditions, zones, lamps of the flank."""
        asked, lamps = self.conditions, (f"stop lamp of {c.name}" for c in self.clear.space if c.lamp)
        token = () if asked.token is None else (f"direction at {asked.token.boundary}",)
        zones = (f"{z.zone} not full" for z in asked.zones)
        return (*(c.condition for c in asked.external), *token, *zones, *lamps)


def leads_to(r: RouteRow) -> str:
    """Where a route leads, with the signals that it passes."""
    return r.exit if r.path.passed is None else f"{r.path.destination} past {', '.join(r.path.passed)}"


def last_left(r: RouteRow) -> TraversalKey:
    """The way whose lock a train leaves behind when it is wholly in the last section; the last one, where it leaves the
    layout or there is no other."""
    path = r.path
    through = path.locked if path.berth is not None or path.exit_kind is ExitKind.BOUNDARY else path.locked[:-1]
    return (through or path.locked)[-1]


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
        onward = r.path.onward
        return (r,) if onward is None else (r, *self.parts(self.route[onward]))

    @cached_property
    def lock(self) -> dict[TraversalKey, TraversalRow]:
        """Locks by section and number."""
        return {t.key: t for t in self.locks}


def _bare(r: RouteRow) -> RouteRow:
    locking = r.locking
    overlap = None if locking.overlap is None else replace(locking.overlap, metres=0.0)
    locking = replace(locking, hostile=HostileRoutes((), 0, _no_reason), overlap=overlap)
    return replace(r, path=replace(r.path, length=0.0), locking=locking)


def _no_reason(route: RouteId) -> Hostile:
    raise LookupError(f"a bare table does not tell why {route} is hostile")
