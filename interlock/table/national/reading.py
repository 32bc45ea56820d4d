"""What the national forms read from layout and table in common."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.model.elements import Hand, MachineId, NodeId, PointId, Position, RouteId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.needs import arrival
from interlock.model.overlap import entry_speed
from interlock.model.times import overlap_release_s
from interlock.model.traversal import Topology, Traversal, path_speed, topology
from interlock.table.cells import Hostile, HostileClass, OverlapCell, PointDemand, ProviderKind, Role
from interlock.table.printed import Printed, PrintedRoute, grouped
from interlock.table.rows import InterlockingTable, RouteRow
from interlock.table.runs import natural

ON_PATH = (Role.PATH, Role.OVERLAP)
NOT_CHECKED = ("Driven points", "moved along, never a condition of the signal: they stand in table.csv")
"""What a form says of them that has no column for them."""
DERAILER = {Position.NORMAL: "on", Position.REVERSE: "off"}


@dataclass(frozen=True)
class Opposing:
    """An opposing route that the points do not exclude: the tracks, in its order, over which a train of it must have
    gone.  `into`: where that is the berth in which this route ends, the train need only be in, until it stands (R2).

    `by_overlap`: else, or beyond that, only its overlap is in the way, until the train stands in `end`, its last one.
    `stands_s`: seconds after which the train stands in that berth; None where no time is waited.
    """

    hostile: Hostile
    tracks: tuple[SectionId, ...]
    by_overlap: bool
    end: SectionId
    into: SectionId | None
    stands_s: float | None


class MachineReading:
    """Points and derailers of routes, as forms print them: on which side they lie, which a route passes facing."""

    def __init__(self, layout: Layout, table: InterlockingTable) -> None:
        self._layout, self._table, self._topo = layout, table, topology(layout)

    def is_machine(self, p: PointDemand) -> bool:
        """Whether a demand is of points, not of a derailer or another device."""
        return p.machine not in self._layout.machines.device and not self.is_derailer(p.machine)

    def is_derailer(self, m: MachineId) -> bool:
        """Whether a machine is a derailer, and works no points."""
        return self._layout.machines.is_derailer(m)

    def devices(self, r: RouteRow) -> dict[MachineId, Position]:
        """Level crossings, doors and other devices that a route locks, each as it must be."""
        return {p.machine: p.position for p in r.locking.points if p.machine in self._layout.machines.device}

    def devices_lie(self, r: RouteRow) -> list[str]:
        """The same in words: `LC1 closed`, `D1 open`, of a door."""
        return [f"{m} {self._layout.machines.word(m, x)}" for m, x in self.devices(r).items()]

    def derailers(self, r: RouteRow) -> dict[PointId, Position]:
        """The derailers that a route locks, also those whose machine works points, and how they lie."""
        asked = [(p.machine, p.position) for p in r.locking.points]
        return {end.id: x for m, x in asked for end in self._layout.machines.ends.get(m, ()) if end.derailer}

    def derailers_lie(self, r: RouteRow) -> list[str]:
        """The same in words, on or off."""
        return [f"{d} {DERAILER[x]}" for d, x in self.derailers(r).items()]

    def points(self, r: RouteRow, position: Position, *roles: Role) -> str:
        """Points of a route in a position."""
        return ", ".join(
            p.machine
            for p in r.locking.points
            if p.position is position and p.role in (roles or tuple(Role)) and self.is_machine(p)
        )

    def side(self, p: PointId, x: Position) -> Hand | None:
        """The side to which a point lies, seen from its toe; None where the layout does not state its hand."""
        hand = self._layout.pointwork.hand.get(p)
        return hand if hand is None or x is Position.REVERSE else hand.other

    def machine_side(self, m: MachineId, x: Position) -> Hand | None:
        """The side to which all points of a machine lie, where it is stated and they agree."""
        sides = {self.side(p.id, x) for p in self._layout.machines.ends.get(m, ()) if not p.derailer}
        return sides.pop() if len(sides) == 1 else None

    @cached_property
    def _by_entry(self) -> dict[str, list[RouteRow]]:
        out: dict[str, list[RouteRow]] = {}
        for r in self._table.routes:
            out.setdefault(r.entry, []).append(r)
        return out

    def facing_ends(self, r: RouteRow) -> list[tuple[PointId, Position]]:
        """The point ends that the route passes facing, in order."""
        return [f for key in r.path.traversals for f in self._facing_in(self._topo.traversals[key[0]][key[1] - 1])]

    def _facing_in(self, t: Traversal) -> list[tuple[PointId, Position]]:
        out = []
        node: NodeId = t.entry
        for here, onward in zip(t.edges, t.edges[1:], strict=False):
            node = self._layout.track.far(here, node)
            p = self._layout.pointwork.point_at.get(node)
            if p is not None and here == p.toe:
                out.append((p.id, Position.NORMAL if onward == p.normal else Position.REVERSE))
        return out

    def facing(self, r: RouteRow) -> list[tuple[str, Position]]:
        """The points that the route passes facing, in order: they decide where it goes."""
        return [(str(self._layout.pointwork.point[p].machine), x) for p, x in self.facing_ends(r)]

    def choices(self, r: RouteRow) -> list[tuple[PointId, Position]]:
        """The points that a route passes facing where another route from its signal, of its kind, goes the other way,
        in order: there the operator's choice decides."""
        others = [dict(self.facing_ends(t)) for t in self._by_entry[r.entry] if t.kind is r.kind and t is not r]
        out = []
        for p, x in self.facing_ends(r):
            if any(o.get(p, x) is not x for o in others):
                out.append((p, x))
                others = [o for o in others if o.get(p) is x]
        return out

    def called(self, point: PointId) -> str:
        """A point end by the name that a drawing has for it: what a slip is made of has the names of its machines."""
        of_slip = any(b.point == point for b in self._layout.pointwork.blades)
        return str(self._layout.pointwork.point[point].machine if of_slip else point)

    def deciding(self, r: RouteRow) -> list[tuple[PointId, Position]]:
        """The points that a route passes facing where the other leg leads to its end, too, in order: of several ways
        from start to end they tell this one, whether or not the others are routes."""
        ways = [self._topo.traversals[s][n - 1] for p in self._table.parts(r) for s, n in p.path.traversals]
        end = ways[-1].section, ways[-1].exit
        out = []
        for i, t in enumerate(ways):
            mine = self._facing_in(t)
            others = self._topo.through(t.section, t.entry)
            for k, (p, x) in enumerate(mine):
                those = [u for u in others if self._facing_in(u)[: k + 1] == [*mine[:k], (p, x.other)]]
                if self._lead(those, end, {w.section for w in ways[:i]}):
                    out.append((p, x))
        return out

    def _lead(self, ways: list[Traversal], end: tuple[SectionId, NodeId], before: set[SectionId]) -> bool:
        """Whether one of some ways goes on to an end, and not back over where the route came from."""
        todo, seen = list(ways), {(t.section, t.number) for t in ways}
        while todo:
            t = todo.pop()
            if (t.section, t.exit) == end:
                return True
            onward = self._topo.beyond(t.section, t.exit)
            if onward is not None and onward not in before:
                further = [u for u in self._topo.through(onward, t.exit) if u.key not in seen]
                seen |= {u.key for u in further}
                todo += further
        return False


@dataclass(frozen=True)
class Reading:
    """A layout with its table."""

    layout: Layout
    table: InterlockingTable

    @cached_property
    def printed(self) -> Printed:
        """The table as it is printed, a row for each way."""
        return Printed(self.table)

    @property
    def drives(self) -> bool:
        """Whether a route moves points along that it does not need (R10): most forms have no column for them."""
        return any(r.locking.driven for r in self.table.routes)

    def named(
        self,
        routes: Iterable[RouteId],
        name: Callable[[PrintedRoute], str] = lambda w: w.id,
        by: RouteRow | None = None,
    ) -> tuple[str, ...]:
        """Routes as they are printed, a way once where all of its overlaps are meant.

        by: the route that says it; that its own way cannot be set twice is not said.
        """
        said = grouped(((r, None) for r in routes), self.printed.ways, by)
        own = None if by is None else self.printed.ways[by.id]
        return tuple(x.name(name) for x in said if x.way is not own)

    @cached_property
    def topo(self) -> Topology:
        """Ways and joints."""
        return topology(self.layout)

    @cached_property
    def machines(self) -> MachineReading:
        """Its points and derailers."""
        return MachineReading(self.layout, self.table)

    def way(self, key: tuple[SectionId, int]) -> Traversal:
        """The way of a lock."""
        return self.topo.traversals[key[0]][key[1] - 1]

    def sections(
        self, r: RouteRow, unless: Callable[[MachineId, Position], str] = lambda m, at: f"or {m} {at}"
    ) -> list[str]:
        """Sections to be clear: path, foul sections with their condition, overlap, flank space, what was added.

        unless: says, in the form's words, that a foul section need not be clear where a machine lies so.
        """
        foul = [
            f.section if f.when is None else f"[{f.section} {unless(f.when[0], f.when[1].other)}]" for f in r.clear.foul
        ]
        over = [s for s, _ in r.locking.overlap.ways] if r.locking.overlap else []
        space = [c.name for c in r.clear.space if not c.lamp]
        added = [c.section for c in r.clear.demanded or ()]
        return list(dict.fromkeys([*(c.section for c in r.clear.sections), *foul, *over, *space, *added]))

    def overlap_release_s(self, r: RouteRow) -> float:
        """Seconds after which the overlap of a route is given up behind a train that stands."""
        return overlap_release_s(self.layout, r.locking.overlap.signal) if r.locking.overlap is not None else 0.0

    @cached_property
    def _arrival(self) -> dict[SignalId, int]:
        return arrival(self.layout)

    def _stands_s(self, r: RouteRow) -> float | None:
        """Seconds after which the train of a route stands before the main signal at its end, when vehicles may be
        shunted towards it (R2); None where it is no train, or ends elsewhere."""
        g = self.layout.signalling.signal.get(SignalId(r.exit)) if r.train else None
        if g is None or not g.main:
            return None
        return max(overlap_release_s(self.layout, g.id), self._arrival.get(g.id, 0) / 1000)

    def overlap_ways(self, o: OverlapCell) -> list[Traversal]:
        """The ways over which an overlap lies."""
        return [self.way(key) for key in o.ways]

    def path_kmh(self, r: RouteRow) -> str:
        """The lowest speed stated along a route, and past the signals that it passes, whatever its overlap permits."""
        kmh = path_speed(self.layout, [self.way(key) for part in self.table.parts(r) for key in part.path.traversals])
        return "" if kmh is None else str(kmh)

    def entry_kmh(self, r: RouteRow) -> str:
        """The speed for which the overlap of a route is made, where one is stated."""
        kmh = (
            None
            if r.locking.overlap is None
            else entry_speed(self.layout, r.locking.overlap.signal, self.overlap_ways(r.locking.overlap))
        )
        return "" if kmh is None else str(kmh)

    def stops(self, r: RouteRow) -> list[str]:
        """The signals that protect the flank of a route at stop."""
        return sorted(
            {p.name for c in r.locking.flank for p in c.providers if p.kind is ProviderKind.SIGNAL}, key=natural
        )

    def opposing(self, r: RouteRow) -> list[Opposing]:
        """The opposing routes that stay in the way of a route although, or after, the points are free.

        A train gives back the points behind it (sectional release).  Of a hostile route what counts is therefore the
        track that it shares with this one beyond the last of its points that lie otherwise.
        """
        mine = self._stretch(r)
        needs = {p.machine: p.position for p in r.locking.points}
        out = []
        for h in r.locking.hostile:
            if HostileClass.OPPOSING not in h.kinds:
                continue
            other = self.table.route[h.route]
            theirs = [k[0] for k in other.path.traversals]
            over = [] if other.locking.overlap is None else [s for s, _ in other.locking.overlap.ways]
            first = 1 + max((i for i, k in enumerate(other.path.traversals) if self._differs(k, needs)), default=-1)
            ahead = [*theirs[first:], *over]
            last = max((i for i, s in enumerate(ahead) if s in mine), default=-1)
            if last >= 0:
                shared = [s for s in theirs[first:] if s in mine]
                into = r.path.berth if shared[-1:] == [r.path.berth] else None
                by_overlap = last >= len(theirs) - first if into is not None else not shared
                stands = self._stands_s(other) if into == theirs[-1] else None
                out.append(Opposing(h, tuple(dict.fromkeys(ahead[: last + 1])), by_overlap, theirs[-1], into, stands))
        return out

    def _stretch(self, r: RouteRow) -> frozenset[SectionId]:
        over = () if r.locking.overlap is None else r.locking.overlap.ways
        return frozenset(s for s, _ in (*r.path.traversals, *over))

    def _differs(self, key: tuple[SectionId, int], needs: dict[MachineId, Position]) -> bool:
        points = ((self.layout.pointwork.point[p].machine, x) for p, x in self.way(key).points)
        return any(needs.get(m, x) is not x for m, x in points)
