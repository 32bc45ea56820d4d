"""What passes of the lowering ask of layout and table, by the kind of element: rows found by what they are asked for,
and the conditions that speak of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import pairwise

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, neg, var
from interlock.logic.names import Name
from interlock.model.elements import MachineId, NodeId, Position, RouteId, SectionId, SignalId
from interlock.model.foul import FoulJoint
from interlock.model.layout import Layout
from interlock.model.places import Approach
from interlock.model.shared_overlap import may_meet, shared_from
from interlock.model.traversal import Topology
from interlock.table.cells import RouteKind, TraversalKey
from interlock.table.rows import InterlockingTable, RouteRow, TraversalRow


class RouteIndex:
    """The routes of a table."""

    def __init__(self, layout: Layout, table: InterlockingTable) -> None:
        self._layout, self._table = layout, table

    @cached_property
    def over(self) -> Mapping[tuple[SectionId, int], tuple[RouteRow, ...]]:
        """The routes that use each lock."""
        out: dict[tuple[SectionId, int], list[RouteRow]] = {}
        for r in self._table.routes:
            for key in r.path.traversals:
                out.setdefault(key, []).append(r)
        return {k: tuple(v) for k, v in out.items()}

    @cached_property
    def into(self) -> Mapping[SectionId, tuple[RouteRow, ...]]:
        """The shunt routes that end in each berth."""
        out: dict[SectionId, list[RouteRow]] = {}
        for r in self._table.routes:
            if r.path.berth is not None:
                out.setdefault(r.path.berth, []).append(r)
        return {k: tuple(v) for k, v in out.items()}

    @cached_property
    def to(self) -> Mapping[tuple[SignalId, int], tuple[RouteRow, ...]]:
        """The routes that hold each overlap."""
        out: dict[tuple[SignalId, int], list[RouteRow]] = {}
        for r in self._table.routes:
            if r.locking.overlap is not None:
                out.setdefault((r.locking.overlap.signal, r.locking.overlap.option), []).append(r)
        return {k: tuple(v) for k, v in out.items()}

    @cached_property
    def adding(self) -> Mapping[MachineId, tuple[RouteRow, ...]]:
        """The routes to which the author has added each machine."""
        out: dict[MachineId, list[RouteRow]] = {}
        for r in self._table.routes:
            for m in dict.fromkeys(p.machine for p in r.locking.added):
                out.setdefault(m, []).append(r)
        return {m: tuple(rs) for m, rs in out.items()}

    @cached_property
    def of_signal(self) -> Mapping[SignalId, tuple[RouteRow, ...]]:
        """The routes of each signal."""
        out: dict[SignalId, list[RouteRow]] = {g.id: [] for g in self._layout.signalling.signals}
        for r in self._table.routes:
            out[r.entry].append(r)
        return {g: tuple(v) for g, v in out.items()}

    @cached_property
    def with_overlap(self) -> Mapping[SignalId, list[RouteRow]]:
        """The routes with an overlap, by the signal of which it is."""
        found: dict[SignalId, list[RouteRow]] = {}
        for r in self._table.routes:
            if r.locking.overlap is not None:
                found.setdefault(r.locking.overlap.signal, []).append(r)
        return found

    def leading_past(self, r: RouteRow) -> tuple[RouteRow, ...]:
        """The routes that lead past the signal of a route of kind identifier, and on over it: routes to that signal,
        and parts of such that lead past signals before it."""
        return self._leading_past.get(r.id, ())

    def set_with(self, r: RouteRow) -> tuple[RouteRow, ...]:
        """All that is set with a route of kind identifier and lies before it, back to the routes that are asked for."""
        found = dict.fromkeys(y for x in self.leading_past(r) for y in (x, *self.set_with(x)))
        return tuple(found)

    @cached_property
    def _leading_past(self) -> Mapping[RouteId, tuple[RouteRow, ...]]:
        out: dict[RouteId, list[RouteRow]] = {}
        for r in self._table.routes:
            if r.path.onward is not None:
                out.setdefault(r.path.onward, []).append(r)
        return {k: tuple(v) for k, v in out.items()}

    def onward(self, r: RouteRow) -> tuple[RouteRow, ...]:
        """What a route that leads past signals locks beyond them."""
        return self._table.parts(r)[1:]

    def identifies(self, g: SignalId) -> bool:
        """Whether a signal shows an identifier light."""
        return any(r.kind is RouteKind.IDENTIFIER for r in self.of_signal[g])

    @cached_property
    def parts_first(self) -> tuple[RouteRow, ...]:
        """The routes, those of kind identifier before the ones that lead on over them."""
        return tuple(
            sorted(self._table.routes, key=lambda r: (r.kind is not RouteKind.IDENTIFIER, len(r.path.passed or ())))
        )

    @cached_property
    def automatic(self) -> tuple[RouteRow, ...]:
        """The routes with a switch for automatic working, in the order in which they are offered (R14)."""
        return tuple(self._table.route[r] for r in self._table.automatic)

    @cached_property
    def open_for_trains(self) -> dict[SignalId, None]:
        """The signals that open for trains, in order."""
        trains = {r.entry for r in self._table.routes if r.kind is RouteKind.MAIN}
        return {g.id: None for g in self._layout.signalling.signals if g.id in trains}

    @cached_property
    def berths(self) -> frozenset[SectionId]:
        """Sections in which shunt routes end and vehicles may stand."""
        return frozenset(r.path.berth for r in self._table.routes if r.path.berth is not None)


class OverlapIndex:
    """The overlaps of a table: alternatives by signal and number."""

    def __init__(self, layout: Layout, table: InterlockingTable) -> None:
        self._layout, self._table = layout, table

    @cached_property
    def ways(self) -> Mapping[tuple[SignalId, int], tuple[TraversalKey, ...]]:
        """The overlap alternatives that some route uses: signal and number, ways."""
        cells = {
            (r.locking.overlap.signal, r.locking.overlap.option): r.locking.overlap.ways
            for r in self._table.routes
            if r.locking.overlap
        }
        return dict(sorted(cells.items()))

    @cached_property
    def of_signal(self) -> Mapping[SignalId, list[tuple[SignalId, int]]]:
        """The overlap alternatives of each signal that has any."""
        found: dict[SignalId, list[tuple[SignalId, int]]] = {}
        for o in self.ways:
            found.setdefault(o[0], []).append(o)
        return found

    @cached_property
    def swinging(self) -> Mapping[SignalId, tuple[int, ...]]:
        """The signals with overlaps that may swing, and the alternatives that may be taken."""
        cells = [
            r.locking.overlap for r in self._table.routes if r.locking.overlap is not None and r.locking.overlap.swings
        ]
        return {c.signal: tuple(sorted({c.option, *c.swings})) for c in sorted(cells, key=lambda c: c.signal)}

    def swing_number(self, g: SignalId) -> int:
        """The number by which an operator asks that the overlap of a signal swings: after those of the routes."""
        return len(self._table.routes) + 1 + list(self.swinging).index(g)

    @cached_property
    def requests(self) -> int:
        """How many values a request has: none, a route, an overlap that shall swing, any number else."""
        return len(self._table.routes) + len(self.swinging) + 2

    @cached_property
    def _over_section(self) -> Mapping[SectionId, list[tuple[SignalId, int]]]:
        found: dict[SectionId, list[tuple[SignalId, int]]] = {}
        for o, ways in self.ways.items():
            for s in dict.fromkeys(s for s, _ in ways):
                found.setdefault(s, []).append(o)
        return found

    def held(self, option: tuple[SignalId, int]) -> Expr:
        """An overlap alternative is held."""
        return var(names.OVERLAP(option[0], option[1]))

    def over(self, section: SectionId) -> list[tuple[SignalId, int]]:
        """The overlap alternatives that lie over a section."""
        return self._over_section.get(section, [])

    def apart_from(self, option: tuple[SignalId, int], section: SectionId) -> list[tuple[SignalId, int]]:
        """The overlap alternatives over a section that are not held together with one (R4)."""
        own = option[0], self.ways[option]
        return [o for o in self.over(section) if not may_meet(self._layout, own, (o[0], self.ways[o]))]

    @cached_property
    def led_over(self) -> Mapping[tuple[SignalId, TraversalKey], list[tuple[SignalId, int]]]:
        """By signal and way the overlap alternatives that may be held where a train route from there leads over it."""
        found: dict[tuple[SignalId, TraversalKey], list[tuple[SignalId, int]]] = {}
        for option, ways in self.ways.items():
            for g, shared in shared_from(self._layout, option[0], ways).items():
                for way in shared:
                    found.setdefault((g, way), []).append(option)
        return found

    @cached_property
    def led_over_past(self) -> frozenset[TraversalKey]:
        """The ways of overlaps over which train routes from another signal than the overlap's own may lead."""
        return frozenset(way for (g, way), those in self.led_over.items() if any(o[0] != g for o in those))

    def along(self, rear: SectionId, node: NodeId, section: SectionId) -> list[tuple[SignalId, int]]:
        """The overlap alternatives that lie over a joint, from one section on into the next."""
        return [option for option, a in self._over_joints.get((rear, section), ()) if self._table.lock[a].exit == node]

    @cached_property
    def _over_joints(self) -> Mapping[tuple[SectionId, SectionId], list[tuple[tuple[SignalId, int], TraversalKey]]]:
        """The overlap alternatives that lie over two sections, and over which way of the first."""
        found: dict[tuple[SectionId, SectionId], list[tuple[tuple[SignalId, int], TraversalKey]]] = {}
        for option, ways in self.ways.items():
            for a, b in pairwise(ways):
                found.setdefault((a[0], b[0]), []).append((option, a))
        return found

    def holding(self, way: TraversalKey, but: SignalId | None = None) -> Expr:
        """A way is held, by a route or as overlap (of another signal than one)."""
        over = [o for o in self._over_section.get(way[0], ()) if way in self.ways[o] and o[0] != but]
        return disj([var(names.LOCK(*way)), *map(self.held, over)])


class SectionIndex:
    """The sections inside a layout: what locks each, and what is reported of it."""

    def __init__(
        self,
        layout: Layout,
        table: InterlockingTable,
        fouls: Sequence[FoulJoint],
        topo: Topology,
        routes: RouteIndex,
    ) -> None:
        self._layout, self._table, self._fouls, self._topo, self._routes = layout, table, fouls, topo, routes
        self._shunting = any(g.shunt for g in layout.signalling.signals)

    @cached_property
    def all(self) -> tuple[SectionId, ...]:
        """Sections inside the layout."""
        return self._topo.sections

    @cached_property
    def locks_of(self) -> Mapping[SectionId, tuple[TraversalRow, ...]]:
        """The locks of each section."""
        out: dict[SectionId, list[TraversalRow]] = {s: [] for s in self.all}
        for t in self._table.locks:
            out[t.section].append(t)
        return {s: tuple(ts) for s, ts in out.items()}

    @cached_property
    def foul_of(self) -> Mapping[SectionId, frozenset[SectionId]]:
        """The sections with a way of which vehicles at a joint of another section stand foul, by that other: any way,
        since a train may have stood at the restart on one over which no route leads."""
        out: dict[SectionId, set[SectionId]] = {}
        for f in self._fouls:
            out.setdefault(f.neighbour, set()).add(f.section)
        return {s: frozenset(those) for s, those in out.items()}

    @cached_property
    def healthy(self) -> Mapping[SectionId, Name]:
        """The inputs that tell that a section's detector is healthy, where the principle asks for them."""
        asked = self._layout.principles.sensor_faults
        return {s.id: names.HEALTHY(s.id) for s in self._layout.track.sections if asked and s.detected}

    @cached_property
    def blockable(self) -> tuple[SectionId, ...]:
        """Sections that an operator may block: those that some route or overlap locks, and those of points."""
        machines = self._layout.machines
        those = {s for m in machines if m not in machines.device for s in machines.sections[m]}
        return tuple(s for s in self.all if self.locks_of[s] or s in those)

    def rear(self, section: SectionId, node: NodeId) -> SectionId | None:
        """The section that a train comes from: the neighbour, or the approach section of a boundary."""
        boundary = self._layout.track.boundary_at.get(node)
        return boundary.approach if boundary is not None else self._topo.beyond(section, node)

    def lock(self, section: SectionId, number: int) -> Expr:
        """Section locked for one way through it."""
        return var(names.LOCK(section, number))

    def locked_in(self, section: SectionId, node: NodeId) -> Expr:
        """Locked for a way that comes in at an end."""
        return disj(self.lock(*t.key) for t in self.locks_of[section] if t.entry == node)

    def locked_out(self, section: SectionId, node: NodeId) -> Expr:
        """Locked for a way that goes out at an end."""
        return disj(self.lock(*t.key) for t in self.locks_of[section] if t.exit == node)

    def occupied(self, section: SectionId | None) -> Expr:
        """Reported occupied (or not reported at all); what has no detection counts as occupied."""
        if section is None or section in self._layout.track.undetected:
            return TRUE
        return var(names.OCCUPIED(section))

    def clear(self, section: SectionId | None) -> Expr:
        """Reported clear without a break for the release delay: no moment's reading of clear is relied on (R15)."""
        if section is None or section in self._layout.track.undetected:
            return FALSE
        return var(names.LONG_CLEAR(section))

    def train(self, section: SectionId) -> Expr:
        """The lock of a section is for a train movement that has not come to its end."""
        return var(names.TRAIN_LOCK(section)) if self._shunting else TRUE

    def into_berth(self, t: TraversalRow) -> Expr:
        """A way is locked for a shunting movement that ends in the berth ahead."""
        ahead = self._topo.beyond(t.section, t.exit)
        if ahead is None or ahead not in self._routes.berths or (t.exit, ahead) in self._topo.signal_into:
            return FALSE
        return conj((self.lock(*t.key), neg(self.train(t.section))))


class MachineIndex:
    """The point machines and devices of a layout."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout

    @cached_property
    def all(self) -> tuple[MachineId, ...]:
        """Machines in order."""
        return tuple(self._layout.machines)

    @cached_property
    def powered(self) -> dict[MachineId, None]:
        """Point machines that the controller drives: no devices, no points worked by hand."""
        by_hand = self._layout.machines.by_hand
        return dict.fromkeys(m for m in self.all if m not in self._layout.machines.device and m not in by_hand)

    def sections_of(self, machine: MachineId) -> tuple[SectionId, ...]:
        """The sections in which a machine's ends lie."""
        return self._layout.machines.sections[machine]

    def started(self, machine: MachineId) -> Expr:
        """The machine may run: its turn has come, where machines start one after the other."""
        sequence = self._layout.principles.point_start_gap_s and machine in self.powered
        return var(names.MAY_RUN(machine)) if sequence else TRUE

    def kept_off(self, machine: MachineId) -> Expr:
        """The drive of a point is kept off, since a section of it is blocked, or was and is not clear since."""
        return var(names.KEPT_OFF(machine)) if machine in self.powered else FALSE

    @staticmethod
    def detected(machine: MachineId, position: Position) -> Expr:
        """Detected in a position, by valid and unambiguous contacts."""
        return var(names.DETECTED(machine, position))

    @staticmethod
    def command(machine: MachineId, position: Position) -> Expr:
        """Commanded to a position."""
        return var(names.COMMAND(machine, position))


class SignalIndex:
    """The signals of a layout: where they stand, and what may be before them."""

    def __init__(
        self,
        layout: Layout,
        table: InterlockingTable,
        topo: Topology,
        routes: RouteIndex,
        sections: SectionIndex,
        arrive: Mapping[SignalId, int],
    ) -> None:
        self._layout, self._table, self._topo, self._routes, self._sections = layout, table, topo, routes, sections
        self.arrive = arrive
        """Milliseconds for which a train runs on to a signal at the end of a berth."""

    @cached_property
    def shunting(self) -> bool:
        """Whether there are shunt signals at all."""
        return any(g.shunt for g in self._layout.signalling.signals)

    def before(self, g: SignalId) -> SectionId:
        """The section before a signal inside the layout."""
        rear = self._topo.beyond(self.first_section(g), self._layout.signalling.signal[g].node)
        assert rear is not None
        return rear

    @cached_property
    def met(self) -> Mapping[SectionId, tuple[SignalId, ...]]:
        """By berth the main signals at its ends before which trains come to a stand, and over whose joint shunting
        movements come in, towards such a train (R2)."""
        out: dict[SectionId, tuple[SignalId, ...]] = {}
        ends = {(t.section, t.exit) for t, train in self._last if train}
        begins = {(t.section, t.entry) for t, train in self._last if not train}
        for s in sorted(self._routes.berths):
            met = [node for node in self._topo.ends[s] if (s, node) in ends & begins]
            ahead = [(node, b) for node in met if (b := self._topo.beyond(s, node)) is not None]
            out[s] = tuple(g for node, b in ahead if (g := self.main_at(b, node)) is not None)
        return {s: those for s, those in out.items() if those}

    @cached_property
    def _last(self) -> list[tuple[TraversalRow, bool]]:
        """The last way of each train route, and the way of each shunt route in the berth where it ends."""
        ends = (r for r in self._table.routes if r.train or r.path.berth is not None)
        return [(self._table.lock[r.path.traversals[-1]], r.train) for r in ends]

    def first_section(self, g: SignalId) -> SectionId:
        """The section just beyond a signal."""
        return self._layout.track.section_of(self._layout.signalling.signal[g].into)

    def signal_at(self, section: SectionId, node: NodeId) -> SignalId | None:
        """The signal that governs entry into a section at an end."""
        return self._topo.signal_into.get((node, section))

    def main_at(self, section: SectionId, node: NodeId) -> SignalId | None:
        """The signal that trains obey on entry into a section at an end."""
        return self._topo.main_into.get((node, section))

    def passing(self, section: SectionId, node: NodeId, rear: SectionId) -> tuple[Expr, ...]:
        """What tells that a lock goes on over a joint: nothing without signal; past a shunt signal, trains do."""
        if self.signal_at(section, node) is None:
            return ()
        return (self._sections.train(section), self._sections.train(rear))

    def any_active(self, g: SignalId) -> Expr:
        """A route from the signal is set and not yet used."""
        return disj(var(names.ACTIVE(r.number)) for r in self._routes.of_signal[g])

    def passing_signal(self, g: SignalId) -> Expr:
        """The signal is still open for a movement that has begun to pass it."""
        return disj(
            var(names.PASSING(r.number)) for r in self._routes.of_signal[g] if r.signal.closing.whole is not None
        )

    def coming(self, x: Approach, unseen: Expr = TRUE) -> Expr:
        """A train may be on its way from there: where it may stand or run, or over a way that is locked for it;
        `unseen` is said of what has no detection."""
        if x.section is None or x.section in self._layout.track.undetected:
            return unseen
        known = self._table.lock
        further = (
            conj((self._sections.lock(x.section, n), self.coming(y, unseen)))
            for n, y in x.further
            if (x.section, n) in known
        )
        return disj((neg(self._sections.clear(x.section)), *further, *([unseen] if x.unseen else [])))

    def approach_clear(self, g: SignalId) -> Expr:
        """No train can be on its way to the signal."""
        found = self._routes.of_signal[g][0].locking.approach.coming
        return var(names.APPROACH_CLEAR(g)) if found.further else neg(self.coming(found))

    def approach_reads_clear(self, g: SignalId) -> Expr:
        """No train is reported from where one can be on its way to the signal, as far as there is detection."""
        found = self._routes.of_signal[g][0].locking.approach.coming
        reported = self.coming(found, FALSE)
        return self.approach_clear(g) if reported is self.coming(found) else neg(reported)

    def approach_safe(self, g: SignalId) -> Expr:
        """No train can be about to pass the signal: approach clear, the delay has run out, or no route begins there."""
        if not self._routes.of_signal[g]:
            return TRUE
        return disj((self.approach_clear(g), var(names.APPROACH_OVER(g))))
