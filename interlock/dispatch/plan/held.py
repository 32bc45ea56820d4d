"""What trains keep from others where they stand, and what nobody else may hold so that a route can be set and driven.

From the table alone.  The overlap of a route is held until its train stands wholly before the signal (R4).  So a train
that is longer than the last section of its route keeps it, one that came in where nothing reports whether more of it
is to come keeps it, and one behind which another stands may keep it, too, if that one followed so closely that the
approach was never seen clear between them: these go on only by routes that go with the overlap, and no other train is
sent over it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import pairwise

from interlock.dispatch.plan.errands import OUTSIDE, Place
from interlock.dispatch.plan.problem import Followed
from interlock.model.elements import MachineId, Position, RouteId, SectionId
from interlock.model.layout import Layout
from interlock.model.overlap import may_be_short
from interlock.model.shared_overlap import may_meet, shared_from
from interlock.model.traversal import topology
from interlock.table.cells import Role, RouteKind, TraversalKey
from interlock.table.rows import InterlockingTable, RouteRow

Lies = tuple[str, MachineId, Position]
"""A machine that is held where it lies, as ("lies", machine, position)."""


class Held:
    """What is held and needed on a railway.  `zones`: with how often trains may count there."""

    def __init__(self, table: InterlockingTable, layout: Layout) -> None:
        self._table, self._layout, self._topo = table, layout, topology(layout)
        self._entry = {t.key: t.entry for s in self._topo.sections for t in self._topo.traversals[s]}
        self._approach = {str(b.node): b.approach for b in layout.track.boundaries}
        self.zones = [(z.id, z.trains) for z in layout.declared.zones]
        self._zone_of = {s: z.id for z in layout.declared.zones for s in z.sections}

    def holds(self, under: Iterable[TraversalKey]) -> frozenset[object]:
        """What a train that stands on ways keeps from others."""
        things: set[object] = set()
        for section, number in under:
            if number == OUTSIDE:
                approach = self._approach.get(section)
                things |= {("outside", section)} | ({("section", approach)} if approach else set())
            else:
                things.add(("section", section))
                self._locks((section, number), things)
        return frozenset(things)

    def _locks(self, key: TraversalKey, things: set[object]) -> None:
        """What the lock of a way keeps from others."""
        section, number = key
        things |= {("locked", section), ("way", section, number)}
        lock = self._table.lock.get(key)
        for e in lock.exclusions if lock else ():
            things |= {("shut", e.section, k) for k in (e.numbers if not e.whole else (0,))}
        things |= {("lies", d.machine, d.position) for d in (lock.points if lock else ())}

    def stay(self, blocked: Collection[str], lies: Mapping[MachineId, Position]) -> frozenset[Lies]:
        """The points that no route moves while sections are blocked, each kept where it lies (R10)."""
        machines = self._layout.machines
        here = (m for m in lies if m not in machines.device and not set(machines.sections[m]).isdisjoint(blocked))
        return frozenset(("lies", m, lies[m]) for m in here)

    def at_first(self, under: Iterable[TraversalKey] = ()) -> dict[MachineId, Position]:
        """How machines lie when a plan begins, where nothing else is known: normal, but under trains that stand."""
        stood = (d for key in under if key in self._table.lock for d in self._table.lock[key].points)
        found = dict.fromkeys(self._layout.machines, Position.NORMAL)
        return found | {d.machine: d.position for d in stood if d.role is Role.PATH}

    def kept(self, place: Place) -> frozenset[object]:
        """What a train keeps of the routes by which it came, beyond what it stands on: what the author has added, and
        the overlap of the last one while it does not stand wholly before the signal."""
        overlap = self._own_overlap(place)
        never = bool(overlap) and (len(place.under) > 1 or self.unseen(place))
        return (overlap if never else frozenset()) | self.under_way(place) | self._inside_of(place)

    def followed(self, place: Place) -> Followed | None:
        """What a train may keep besides while another is behind it: the overlap before which it stands, where that one
        came so closely that nothing has reported that all of the first is in the last section (R4)."""
        overlap = self._own_overlap(place)
        if not overlap or len(place.under) > 1 or self.unseen(place):
            return None
        return Followed(overlap, self._behind(place))

    def overlap_sections(self, place: Place) -> frozenset[SectionId]:
        """The sections of the overlap before which a train stands, without those under it."""
        overlap = None if place.route is None else self._table.route[place.route].locking.overlap
        under = {s for s, _ in place.under}
        return frozenset(s for s, _ in overlap.ways if s not in under) if overlap is not None else frozenset()

    def _own_overlap(self, place: Place) -> frozenset[object]:
        """What the overlap keeps from others before which a train stands."""
        things: set[object] = set()
        if place.route is not None and place.under:
            for key in self._overlap(self._table.route[place.route]):
                self._locks(key, things)
        return frozenset(things)

    def _inside_of(self, place: Place) -> frozenset[object]:
        """What a train keeps by standing in overlaps of signals that it has passed (R4)."""
        things: set[object] = set()
        for x in place.inside:
            for key in self._overlap(self._table.route[x]):
                self._locks(key, things)
        return frozenset(things)

    def still_inside(
        self, place: Place, chain: Sequence[RouteRow], turned: bool, under: Iterable[TraversalKey]
    ) -> frozenset[RouteId]:
        """The routes of a train's way from a place on, in whose overlaps it stands afterwards: unless the overlap was
        given up before, since the next route does not go with it, or is, since all of it stands in the last section."""
        before = [] if place.route is None or turned else [self._table.route[place.route]]
        rows = [*before, *chain]
        kept = {a.id for a, b in pairwise(rows) if a.locking.overlap is not None and self.goes_with(a, b)}
        at = {s for s, _ in under}
        return frozenset(x for x in kept | place.inside if self._stands_in(self._table.route[x], at))

    def _stands_in(self, r: RouteRow, at: Collection[SectionId]) -> bool:
        """A train keeps the overlap of a route by standing in some sections."""
        overlap = r.locking.overlap
        if overlap is None or not any(s in at for s, _ in overlap.ways):
            return False
        lies = [self._topo.traversals[s][n - 1] for s, n in overlap.ways]
        return at != {lies[-1].section} or may_be_short(self._layout, overlap.signal, lies)

    @staticmethod
    def _overlap(r: RouteRow) -> Sequence[TraversalKey]:
        return r.locking.overlap.ways if r.locking.overlap is not None else ()

    def under_way(self, place: Place) -> frozenset[object]:
        """What a train keeps of what the author has added to the routes by which it came."""
        things: set[object] = set()
        for x in place.under_way:
            things |= {("under way", x)} | {("lies", d.machine, d.position) for d in self._table.route[x].locking.added}
        return frozenset(things)

    def needs(self, r: RouteRow) -> frozenset[object]:
        """What nobody else may hold so that a route can be set and driven."""
        things: set[object] = set()
        for key in r.path.traversals:
            self._way(key, key[0] == r.path.berth, things)
        for key in r.locking.overlap.ways if r.locking.overlap else ():
            self._way(key, False, things)
        demanded = {(d.machine, d.position) for d in r.locking.points}
        for f in r.clear.foul:
            if f.when is None or (f.when[0], f.when[1].other) not in demanded:
                things.add(("section", f.section))
        things |= {("section", c.name) for c in r.clear.space if not c.lamp}
        things |= {("section", c.section) for c in r.conditions.block}
        things |= {("section", c.section) for c in r.clear.demanded or ()}
        things |= {("under way", c.route) for c in r.locking.barred}
        things |= {("lies", d.machine, d.position.other) for d in r.locking.added}
        if r.conditions.token is not None:
            things.add(("outside", str(r.conditions.token.boundary)))
        return frozenset(things)

    def _way(self, key: TraversalKey, berth: bool, things: set[object]) -> None:
        section, number = key
        if not berth:
            things |= {("section", section), ("locked", section)}
        things.add(("blocked", section))
        things |= {("shut", section, 0), ("shut", section, number)}
        lock = self._table.lock.get(key)
        for e in lock.exclusions if lock else ():
            whole = {("section", e.section), ("locked", e.section)}
            things |= whole if e.whole else {("way", e.section, k) for k in e.numbers}
        things |= {("lies", d.machine, d.position.other) for d in (lock.points if lock else ())}

    def goes_with(self, before: RouteRow, r: RouteRow) -> bool:
        """Whether a route can be set, from the signal where another ends or further on, while the overlap of that is
        held."""
        over, beyond = before.locking.overlap, r.locking.overlap
        if over is None:
            return True
        shared = shared_from(self._layout, over.signal, over.ways).get(r.entry, ())
        meets = beyond is not None and may_meet(self._layout, (over.signal, over.ways), (beyond.signal, beyond.ways))
        held: set[object] = set()
        needed: set[object] = set()
        for key in over.ways:
            self._locks(key, held)
        for key in r.path.traversals:
            if key not in shared or r.kind is not RouteKind.MAIN:
                self._way(key, key[0] == r.path.berth, needed)
        for key in beyond.ways if beyond is not None else ():
            if not (meets and key in over.ways):
                self._way(key, False, needed)
        needed |= {("lies", d.machine, d.position.other) for d in r.locking.added}
        return not held & needed

    def released(self, place: Place, r: RouteRow) -> frozenset[object] | None:
        """What must be free of others so that a train has given up its overlap before a route that does not go with it;
        None where it never does."""
        assert place.route is not None
        if self.goes_with(self._table.route[place.route], r):
            return frozenset()
        if len(place.under) > 1:
            return None
        return None if self.unseen(place) else self._behind(place)

    def _behind(self, place: Place) -> frozenset[object]:
        """What another train would hold that is right behind one in a section."""
        section, number = place.under[0]
        entry = self._entry[section, number]
        if entry in self._layout.track.boundary_at:
            approach = self._approach.get(str(entry))
            return frozenset({("outside", str(entry))} | ({("section", approach)} if approach else set()))
        rear = self._topo.beyond(section, entry)
        return frozenset({("section", rear)} if rear is not None else ())

    def unseen(self, place: Place) -> bool:
        """Nothing ever reports that a train stands wholly before its signal: it came past a main signal from where
        nothing detects it."""
        section, number = place.under[0]
        entry = self._entry[section, number]
        outside = entry in self._layout.track.boundary_at
        rear = self._approach.get(str(entry)) if outside else self._topo.beyond(section, entry)
        dark = rear is None or rear in self._layout.track.undetected
        return dark and (entry, section) in self._topo.main_into

    def inside(self, under: Iterable[TraversalKey]) -> Mapping[str, int]:
        """How often a train on ways counts in zones: with each section."""
        return Counter(self._zone_of[s] for s, n in under if n != OUTSIDE and s in self._zone_of)

    def entering(self, chain: Sequence[RouteRow]) -> Mapping[str, int]:
        """The room that routes in the order of travel ask for in zones, the last of them set first: a section of a zone
        counts from when it is locked, until what leads to it inside the zone is locked, too."""
        room: dict[str, int] = {}
        ahead: Counter[str] = Counter()
        for r in reversed(chain):
            for c in r.conditions.zones:
                room[c.zone] = max(room.get(c.zone, 0), ahead[c.zone] + c.entries)
            for before, s in pairwise((None, *r.path.section_ids)):
                zone = self._zone_of.get(s) if s is not None else None
                if zone is not None and (before is None or self._zone_of.get(before) != zone):
                    ahead[zone] += 1
        return room
