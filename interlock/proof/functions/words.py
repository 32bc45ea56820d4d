"""The words in which functions are said: over layout, inputs and states, never over the controller's wires."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from itertools import pairwise

from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, neg, var
from interlock.logic.symbols import RouteSymbols
from interlock.model.elements import MachineId, NodeId, Position, SectionId, SignalId
from interlock.model.foul import Foul
from interlock.model.machines import other_doors
from interlock.model.measured import Beyond
from interlock.model.places import Approach
from interlock.model.traversal import Traversal
from interlock.proof.claims import Facts
from interlock.proof.claims.reasons import first_behind, met

Way = tuple[SectionId, int]


class SectionWords:
    """Sections: what is reported of each, what comes in, and when it is released."""

    def __init__(self, w: Words) -> None:
        self._w = w

    def signal_at(self, s: SectionId, j: NodeId) -> SignalId | None:
        """The signal that governs entry into a section at an end."""
        found = self._w.topo.signal_into.get((j, s))
        return None if found is None else SignalId(str(found))

    def main_at(self, s: SectionId, j: NodeId) -> bool:
        """A signal for trains governs entry into a section at an end."""
        return (j, s) in self._w.topo.main_into

    def rear(self, s: SectionId, j: NodeId) -> str | None:
        """The section that a train comes from: the neighbour, or the approach section of a boundary."""
        boundary = self._w.layout.track.boundary_at.get(j)
        return boundary.approach if boundary is not None else self._w.topo.beyond(s, j)

    def ends_shunts(self, s: SectionId | None) -> bool:
        """Shunting movements end there, among standing vehicles."""
        return s is not None and s in self._w.f.track.ends_of_shunts

    def occupied(self, s: str | None) -> Expr:
        """Counts as occupied: not validly reported clear, or without detection (R3)."""
        return TRUE if s is None else neg(conj((self._w.valid, self._w.f.seen.clear(s))))

    def long(self, s: str | None) -> Expr:
        """Steadily clear: without a break for the release delay (R15); never, without detection."""
        name = None if s is None else self._w.sym.sections.release_timer.get(SectionId(s))
        return FALSE if name is None or s in self._w.layout.track.undetected else var(name)

    def on(self, s: SectionId, j: NodeId, rear: SectionId) -> Expr:
        """Locks go on over a joint: past a shunt signal only those of trains."""
        return (
            TRUE if self.signal_at(s, j) is None else conj((self._w.f.locking.train(s), self._w.f.locking.train(rear)))
        )

    def none_set_into(self, s: SectionId) -> list[Expr]:
        """No further shunting movement is set into a berth in this scan."""
        into = [r for r in self._w.sym.routes if r.path.berth is not None and r.path.berth[0] == s]
        return [neg(self._w.signals.set_now(r)) for r in into]

    def rear_released(self, s: SectionId) -> Expr:
        """No lock in rear leads into the section, and no shunting movement is set into it in this scan (R9)."""
        out = self.none_set_into(s)
        for j in self._w.topo.ends[s]:
            rear = self._w.topo.beyond(s, j)
            if rear is None or self.main_at(s, j):
                continue
            locked, leads = self._w.f.locking.locked_in(s, j), self._w.f.locking.locked_out(rear, j)
            if locked is FALSE or leads is FALSE:
                continue
            if self.ends_shunts(s) and self.signal_at(s, j) is None:
                locked = TRUE
            out.append(neg(conj((locked, leads, self.on(s, j, rear)))))
        return conj(out)

    def wholly_in(self, s: SectionId) -> Expr:
        """A train has come in, and nothing stood in rear of it since that may still come in (R4)."""
        out = [self._w.valid, self._w.f.seen.used(s), self.rear_released(s)]
        cleared, trains = self._w.sym.cancellation.rear_cleared, dict(first_behind(self._w.f, s))
        for j in self._w.topo.ends[s]:
            g = self._w.topo.main_into.get((j, s))
            if g in trains and s in cleared:
                vehicles = conj((neg(self._w.f.locking.train(s)), self._before(s, j)))
                out.append(disj((var(cleared[s]), neg(disj((trains[g], vehicles))))))
            elif g is not None:
                out.append(neg(self._before(s, j)))
        return conj(out)

    def arrived(self, s: SectionId) -> Expr:
        """The same, and nothing stands before a signal that leads there; or, where shunting movements come in towards
        the train, it has stood before its signal by time (R2)."""
        timer, there = self._w.sym.overlaps.timer, met(self._w.f, s)
        stood = (disj((neg(towards), var(timer[g]) if g in timer else FALSE)) for g, towards in there)
        before = (self._before(s, j) for j in self._w.topo.ends[s] if self.main_at(s, j) and not there)
        return conj((self.wholly_in(s), *stood, neg(disj(before))))

    def _before(self, s: SectionId, j: NodeId) -> Expr:
        """A section is locked from an end, and something stands in rear of that."""
        return conj((self._w.f.locking.locked_in(s, j), neg(self.long(self.rear(s, j)))))

    def coming_in(self, s: SectionId, j: NodeId) -> Expr:
        """The three-point check sees a train come into a section at an end (R9)."""
        f = self._w.f
        locked = f.locking.locked_in(s, j)
        if locked is FALSE:
            return FALSE
        if self.ends_shunts(s) and self.signal_at(s, j) is None:
            locked = f.locking.any_lock(s)
        rear = self.rear(s, j)
        out = [self._w.valid, f.locking.firm(s), neg(f.seen.stale(s)), neg(f.seen.used(s)), locked]
        out += [self.occupied(s), self.occupied(rear)]
        inside = self._w.topo.beyond(s, j)
        if inside is not None and not self.main_at(s, j):
            own = [neg(f.locking.train(s))] if self.signal_at(s, j) is not None else []
            own += self._overrunning(inside, j, s)
            out.append(disj((*own, f.seen.used(inside))))
            out.append(disj((*own, f.locking.locked_out(inside, j))))
        return conj(out)

    def _overrunning(self, rear: SectionId, j: NodeId, s: SectionId) -> list[Expr]:
        """The overlaps over a joint, within which a train that has overrun a signal runs on."""
        found = []
        for option, ways in self._w.sym.overlaps.ways.items():
            for a, b in pairwise(ways):
                if a[0] == rear and b[0] == s and self._w.f.track.way(*a)[1] == j:
                    found.append(var(self._w.sym.overlaps.held[option]))
        return found

    def into_berth(self, s: SectionId, n: int) -> Expr:
        """A way is locked for a shunting movement that ends in the section ahead."""
        exit_ = self._w.f.track.way(s, n)[1]
        ahead = self._w.topo.beyond(s, exit_)
        if ahead is None or not self.ends_shunts(ahead) or self.signal_at(ahead, exit_) is not None:
            return FALSE
        return conj((self._w.f.locking.lock(s, n), neg(self._w.f.locking.train(s))))

    def outward(self, s: SectionId, j: NodeId) -> Expr:
        """What came in at an end has nobody to release the section behind it: it leaves over a boundary, or goes among
        standing vehicles."""
        out = []
        for n, lock in self._w.f.locking.of(s):
            entry, exit_ = self._w.f.track.way(s, n)
            if entry == j:
                out.append(lock if exit_ in self._w.layout.track.boundary_at else self.into_berth(s, n))
        return disj(out)

    def closed(self, s: SectionId) -> Expr:
        """No signal into the section is open for a movement that passes it."""
        signals = [g for j in self._w.topo.ends[s] if (g := self.signal_at(s, j)) is not None]
        return neg(disj(map(self._w.signals.passing, signals)))


class SignalWords:
    """Signals and the routes from them."""

    def __init__(self, w: Words) -> None:
        self._w = w

    def set_now(self, r: RouteSymbols) -> Expr:
        """The route is set in this scan."""
        return self._w.rises(var(r.active))

    def active(self, g: SignalId) -> Expr:
        """A route from the signal is set and not yet used."""
        return disj(var(r.active) for r in self._w.sym.routes.of_signal.get(g, ()))

    def passing(self, g: SignalId) -> Expr:
        """The signal is still open for a movement that has begun to pass it."""
        return disj(self._w.sym.routes.passing(g, shunt) for shunt in (False, True))

    def seen(self, g: SignalId) -> Expr:
        """The signal has been open for the route that is set."""
        return disj(var(r.shown) for r in self._w.sym.routes.of_signal.get(g, ()))

    def nobody(self, g: SignalId, unseen: Expr = TRUE) -> Expr:
        """No train can be on its way to the signal (R8); `unseen` is said of what has no detection."""
        return neg(self._coming(self._w.f.measured.approaches[g], unseen))

    def _coming(self, x: Approach, unseen: Expr) -> Expr:
        if x.section is None or x.section in self._w.layout.track.undetected:
            return unseen
        lock = self._w.sym.sections.lock
        ways = ((lock.get((x.section, n)), y) for n, y in x.further)
        further = (conj((var(name), self._coming(y, unseen))) for name, y in ways if name is not None)
        return disj((neg(self._w.sections.long(x.section)), *further, *([unseen] if x.unseen else [])))

    def safe(self, g: SignalId) -> Expr:
        """No train can be about to pass the signal: none is on its way or starts there, or the delay is over (R8)."""
        if g not in self._w.sym.cancellation.approach_timer:
            return TRUE
        return disj((self.nobody(g), var(self._w.sym.cancellation.approach_timer[g])))

    def first(self, g: SignalId) -> SectionId:
        """The section just beyond a signal."""
        return self._w.layout.track.section_of(self._w.layout.signalling.signal[g].into)

    def given_up(self, g: SignalId) -> Expr:
        """The cancelled route may be given up (R8)."""
        if g not in self._w.sym.cancellation.cancelling:
            return FALSE
        permitted = disj((self.safe(g), neg(self.seen(g))))
        return conj(
            (
                var(self._w.sym.cancellation.cancelling[g]),
                self.active(g),
                self._w.valid,
                self._w.sections.long(self.first(g)),
                permitted,
            )
        )


class PointWords:
    """Point machines and devices: where they lie, and when they may move."""

    def __init__(self, w: Words) -> None:
        self._w = w

    def detected(self, m: MachineId, x: Position) -> Expr:
        """Detected there by valid and unambiguous contacts (R10)."""
        return conj(
            (
                self._w.valid,
                var(self._w.sym.machines.detected[m, x]),
                neg(var(self._w.sym.machines.detected[m, x.other])),
            )
        )

    def commanded(self, m: MachineId, x: Position) -> Expr:
        """Commanded to a position."""
        return var(self._w.sym.machines.command[m, x])

    def anew(self, m: MachineId) -> Expr:
        """Commanded with this scan to where it was not commanded."""
        return disj(self._w.rises(self.commanded(m, x)) for x in Position)

    def powered(self, m: MachineId) -> bool:
        """Whether the controller drives the machine, so that it may be trailed."""
        return m in self._w.sym.machines.trailed

    def holding(self, way: Way) -> Expr:
        """A way is held, by a route or as overlap."""
        over = [var(self._w.sym.overlaps.held[o]) for o, ways in self._w.sym.overlaps.ways.items() if way in ways]
        return disj((self._w.f.locking.lock(*way), *over))

    @cached_property
    def _flanks(self) -> Mapping[MachineId, list[Way]]:
        """The ways that demand a machine which lies in none of their section's points: as flank protection."""
        found: dict[MachineId, list[Way]] = {}
        for way, those in self._w.sym.ways.demands.items():
            for m, _ in those:
                if way[0] not in self._w.layout.machines.sections[m]:
                    found.setdefault(m, []).append(way)
        return found

    def flanks(self, m: MachineId) -> list[Way]:
        """The ways that demand a machine as flank protection."""
        return self._flanks.get(m, [])

    def movable(self, m: MachineId) -> Expr:
        """Nothing is locked or occupied over the machine, and nobody needs it as flank protection (R10)."""
        free = [self._w.valid]
        for s in self._w.layout.machines.sections[m]:
            free += [neg(self._w.f.locking.held(s)), self._w.sections.long(s)]
        free += [
            neg(var(r.added))
            for r in self._w.sym.routes
            if r.added is not None and any(m == n for n, _ in r.path.demands)
        ]
        return conj((*free, *(neg(self.holding(way)) for way in self.flanks(m))))

    def closing(self, m: MachineId, x: Position) -> bool:
        """To close a crossing or bridge is always permitted, but for one that routes hold open to its road, and for the
        doors of an air lock (R13)."""
        held_open = any((m, x.other) in r.path.demands for r in self._w.sym.routes)
        machines = self._w.layout.machines
        return m in machines.device and not other_doors(machines, m) and x is Position.REVERSE and not held_open

    def obtainable(self, m: MachineId, x: Position) -> Expr:
        """The machine can be had in a position (R10); a door of an air lock open while the others are shut (R13)."""
        if self.closing(m, x):
            return TRUE
        lies = conj((self.detected(m, x), *(neg(self.commanded(m, y)) for y in Position)))
        off = self._w.sym.machines.kept_off.get(m)
        arrives = (
            self.commanded(m, x)
            if off is None
            else conj((self.commanded(m, x), disj((self.detected(m, x), neg(var(off))))))
        )
        return conj((disj((arrives, conj((self.movable(m), self.unblocked(m))), lies)), self.alone(m, x)))

    def alone(self, m: MachineId, x: Position) -> Expr:
        """To open a door of an air lock: it is commanded so already, or the others are shut, and not commanded open."""
        others = other_doors(self._w.layout.machines, m) if x is Position.REVERSE else ()
        shut = [y for o in others for y in (self.detected(o, x.other), neg(self.commanded(o, x)))]
        return disj((self.commanded(m, x), conj(shut)))

    def swings(self, m: MachineId) -> Expr:
        """An overlap over the machine swings from one alternative to another."""
        sym, found = self._w.sym, []
        for g, name in sym.overlaps.swings.items():
            over = [way for o, ways in sym.overlaps.ways.items() if o[0] == g for way in ways]
            those = (p for s, n in over for p, _ in self._w.topo.traversals[s][n - 1].points)
            if any(self._w.layout.pointwork.point[p].machine == m for p in those):
                found.append(var(name))
        return disj(found)

    def unblocked(self, m: MachineId) -> Expr:
        """Nobody has blocked a section of a point, so that it may move for a route; crossings always may."""
        if m in self._w.layout.machines.device:
            return TRUE
        return conj(neg(self._w.ways.blocked(s)) for s in self._w.layout.machines.sections[m])


class WayWords:
    """Ways through sections: whether each lies and is clear."""

    def __init__(self, w: Words) -> None:
        self._w = w

    def way(self, s: SectionId, n: int) -> Traversal:
        """A way through a section."""
        return self._w.topo.traversals[s][n - 1]

    def blocked(self, s: SectionId) -> Expr:
        """Somebody has blocked the section."""
        return var(self._w.sym.sections.blocked[s]) if s in self._w.sym.sections.blocked else FALSE

    def trailed(self, s: SectionId, n: int) -> Expr:
        """A point that a way needs was trailed."""
        machines, demands = self._w.sym.machines, self._w.sym.ways.demands[s, n]
        return disj(var(machines.trailed[m]) for m, _ in demands if self._w.points.powered(m))

    def trouble(self, s: SectionId, n: int, wide: bool = True) -> Expr:
        """Why a way can neither be had nor be shown: a trailed point, something foul, the flank space (`wide`: wherever
        something in it might count)."""
        f, t = self._w.f, self.way(s, n)
        out = [self.trailed(s, n)]
        beside: list[Foul] = [*f.track.fouls, *f.track.crossed, *f.track.beside]
        out += [neg(self._not_foul(x)) for x in beside if x.fouls(t)]
        return disj((*out, self._space(t) if wide else FALSE))

    def _not_foul(self, at: Foul) -> Expr:
        clear = self._w.sections.long(at.neighbour)
        return clear if at.when is None else disj((clear, self._w.points.detected(at.when[0], at.when[1].other)))

    def _space(self, t: Traversal) -> Expr:
        """Something stands in the flank space, or a lamp that protects it is out: anywhere that may count (R5)."""
        rules, out = self._w.layout.principles, []
        if not rules.flank_space and not rules.flank_lamp:
            return FALSE
        for pid, x in t.points:
            p = self._w.layout.pointwork.point[pid]
            out.append(self._anything(t.section, self._w.f.track.beyond[p.node, p.leg(x.other)]))
        for cid, arm in t.crossings:
            c = self._w.layout.pointwork.crossing[cid]
            out += [self._anything(t.section, self._w.f.track.beyond[c.node, edge]) for edge in c.arms[1 - arm]]
        return disj(out)

    def _anything(self, own: SectionId, beyond: Beyond) -> Expr:
        s = beyond.section
        out = [neg(self._w.sections.long(s))] if s != own and s not in self._w.layout.track.undetected else []
        if beyond.signal is not None and beyond.signal in self._w.sym.lamp_proof.stop:
            out.append(neg(var(self._w.sym.lamp_proof.stop[beyond.signal])))
        return disj((*out, *(self._anything(own, x) for x in beyond.onward)))

    def lies(self, s: SectionId, n: int, wide: bool = True) -> Expr:
        """The points and devices of a way are detected, and nothing is in its way from beside (R3)."""
        there = (self._w.points.detected(m, x) for m, x in self._w.sym.ways.demands[s, n])
        return conj((*there, neg(self.trouble(s, n, wide))))

    def overlap_lies(self, r: RouteSymbols, wide: bool = True) -> Expr:
        """The overlap that the route needs lies and is clear: its own, or the one to which it has swung (R4)."""
        if r.path.overlap is None:
            return TRUE
        own = r.path.overlap
        swings = own[0] in self._w.sym.overlaps.swings
        options = [o for o in self._w.sym.overlaps.held if o[0] == own[0]] if swings else [own]

        def clear(o: tuple[SignalId, int]) -> Expr:
            ways = self._w.sym.overlaps.ways[o]
            return conj(x for s, n in ways for x in (self._w.sections.long(s), self.lies(s, n, wide)))

        if not swings:
            return clear(own)
        return disj(conj((var(self._w.sym.overlaps.held[o]), clear(o))) for o in options)


class Words:
    """Short names for what functions speak of."""

    def __init__(self, f: Facts) -> None:
        self.f, self.sym, self.topo, self.layout = f, f.sym, f.topo, f.layout
        self.after = f.after
        self.valid = var(f.sym.valid)
        self.sections, self.signals, self.points, self.ways = (
            SectionWords(self),
            SignalWords(self),
            PointWords(self),
            WayWords(self),
        )

    def rises(self, x: Expr) -> Expr:
        """It begins to hold with this scan."""
        return conj((self.after(x), neg(x)))

    def ends(self, x: Expr) -> Expr:
        """It holds until this scan."""
        return conj((x, neg(self.after(x))))
