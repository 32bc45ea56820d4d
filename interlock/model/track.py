"""The track: the graph in which its edges meet at nodes, with its sections, its ends and its pointwork."""

from __future__ import annotations

from functools import cached_property

from interlock.dataclass import dataclass
from interlock.model.elements import (
    Blades,
    Boundary,
    Buffer,
    Crossing,
    CrossingId,
    Edge,
    EdgeId,
    Hand,
    MachineId,
    NodeId,
    Point,
    PointId,
    Section,
    SectionId,
)
from interlock.model.facts import Facts
from interlock.model.machines import grouped


@dataclass(frozen=True, eq=False)
class Track(Facts):
    """Sections and their edges, and the ends of the track: boundaries and buffers."""

    sections: tuple[Section, ...]
    edges: tuple[Edge, ...]
    boundaries: tuple[Boundary, ...]
    buffers: tuple[Buffer, ...]

    @cached_property
    def section(self) -> dict[SectionId, Section]:
        """Sections by id."""
        return {s.id: s for s in self.sections}

    @cached_property
    def edge(self) -> dict[EdgeId, Edge]:
        """Edges by id."""
        return {e.id: e for e in self.edges}

    @cached_property
    def edges_in(self) -> dict[SectionId, tuple[Edge, ...]]:
        """The edges of a section."""
        return grouped((e.section, e) for e in self.edges)

    @cached_property
    def edges_at(self) -> dict[NodeId, tuple[Edge, ...]]:
        """The edges that end at a node."""
        return grouped((n, e) for e in self.edges for n in (e.a, e.b))

    @cached_property
    def boundary_at(self) -> dict[NodeId, Boundary]:
        """The boundary at a node."""
        return {b.node: b for b in self.boundaries}

    @cached_property
    def buffer_at(self) -> dict[NodeId, Buffer]:
        """The buffer at a node."""
        return {b.node: b for b in self.buffers}

    @cached_property
    def undetected(self) -> frozenset[SectionId]:
        """Sections without detection."""
        return frozenset(s.id for s in self.sections if not s.detected)

    def section_of(self, edge: EdgeId) -> SectionId:
        """The section of an edge."""
        return self.edge[edge].section

    def far(self, edge: EdgeId, node: NodeId) -> NodeId:
        """The other end of an edge."""
        e = self.edge[edge]
        return e.b if e.a == node else e.a


@dataclass(frozen=True, eq=False)
class Pointwork(Facts):
    """Points, derailers, slips and diamond crossings."""

    points: tuple[Point, ...]
    crossings: tuple[Crossing, ...]
    blades: tuple[Blades, ...] = ()
    """Where the blades of slips lie."""
    hands: tuple[tuple[PointId, Hand], ...] = ()
    """The side to which the reverse leg of a point lies, where the layout states it; only printed."""
    supervision: tuple[tuple[MachineId, float], ...] = ()
    """Seconds of supervision of machines that have a time of their own."""

    @cached_property
    def point(self) -> dict[PointId, Point]:
        """Points by id."""
        return {p.id: p for p in self.points}

    @cached_property
    def slip_of(self) -> dict[PointId, str]:
        """The slips to which points belong that stand nowhere in the layout file: all their edges are named for it."""
        return {b.point: str(self.point[b.point].toe).rpartition(".")[0] for b in self.blades}

    @cached_property
    def crossing(self) -> dict[CrossingId, Crossing]:
        """Crossings by id."""
        return {c.id: c for c in self.crossings}

    @cached_property
    def point_at(self) -> dict[NodeId, Point]:
        """The point that stands at a node."""
        return {p.node: p for p in self.points}

    @cached_property
    def crossing_at(self) -> dict[NodeId, Crossing]:
        """The crossing that lies at a node."""
        return {c.node: c for c in self.crossings}

    @cached_property
    def hand(self) -> dict[PointId, Hand]:
        """The side to which the reverse leg of a point lies, seen from its toe, where it is stated."""
        return dict(self.hands)
