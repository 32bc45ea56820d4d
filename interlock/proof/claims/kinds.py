"""Claims, invariants, and the facts that they are written in."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any, NamedTuple

from interlock.logic import names
from interlock.logic.expr import FALSE, TRUE, Expr, conj, disj, neg, var
from interlock.logic.names import Name
from interlock.logic.plant import lies, old_command
from interlock.logic.symbols import Symbols
from interlock.model.elements import EdgeId, MachineId, NodeId, Position, SectionId, SignalId
from interlock.model.foul import CrossedSection, FoulBeside, FoulJoint
from interlock.model.measured import Beyond
from interlock.model.traversal import Traversal
from interlock.proof.system.loop import ClosedLoop
from interlock.proof.system.transition import System


class Claim(NamedTuple):
    """One instance of a claim: `expr`, of the old state and the inputs of a step, must hold in every step from a
    reachable state."""

    id: str
    place: str
    expr: Expr


class Invariant(NamedTuple):
    """A strengthening invariant: holds initially and is kept by every step; proved, never assumed."""

    id: str
    place: str
    expr: Expr


class TrackFacts:
    """What of the track invariants speak of: ways, joints, whom signals speak to."""

    def __init__(self, loop: ClosedLoop) -> None:
        self._layout, self._topo, self._measured = loop.layout, loop.topo, loop.measured
        self._sym = loop.controller.symbols

    @property
    def shunts(self) -> bool:
        """Whether the layout has shunt signals, so that locks are of two kinds."""
        return bool(self._sym.sections.train)

    def berth(self, s: str) -> bool:
        """Vehicles may stand there in any number."""
        return self.shunts and s in self._topo.berths

    @cached_property
    def ends_of_shunts(self) -> frozenset[SectionId]:
        """The berths in which shunt routes end."""
        return frozenset(r.path.berth[0] for r in self._sym.routes if r.path.berth is not None)

    def functions(self, g: str) -> tuple[bool, ...]:
        """Whom a signal speaks to: False for trains, True for shunting movements."""
        signal = self._layout.signalling.signal[SignalId(g)]
        return (*([False] if signal.main else []), *([True] if signal.shunt else []))

    def way(self, s: str, n: int) -> tuple[NodeId, NodeId]:
        """Entry and exit of a way."""
        t = self._topo.traversals[SectionId(s)][n - 1]
        return t.entry, t.exit

    def signal_out(self, s: str, j: str) -> str | None:
        """The signal that governs leaving s at j."""
        ahead = self._topo.beyond(SectionId(s), NodeId(j))
        return None if ahead is None else self._topo.signal_into.get((NodeId(j), ahead))

    @property
    def fouls(self) -> tuple[FoulJoint, ...]:
        """The foul joints of the layout."""
        return self._measured.fouls

    @property
    def crossed(self) -> tuple[CrossedSection, ...]:
        """The sections across diamonds."""
        return self._measured.crossed

    @property
    def beside(self) -> tuple[FoulBeside, ...]:
        """The sections that are foul of each other beside a point or diamond."""
        return self._measured.beside

    def overlap_paths(self, g: SignalId) -> tuple[tuple[Traversal, ...], ...]:
        """The alternatives of a signal's overlap; none without one."""
        return self._topo.paths(self._measured.overlaps.get(g, ()))

    def longer_overlaps(self, g: SignalId, option: int) -> list[tuple[Traversal, ...]]:
        """The alternatives inside which one lies that is told apart from them by its speed; none of any other."""
        if option not in self.apart(g):
            return []
        paths = self.overlap_paths(g)
        short = paths[option - 1]
        return [p for p in paths if len(p) > len(short) and p[: len(short)] == short]

    def apart(self, g: SignalId) -> Mapping[int, int]:
        """The alternatives of a signal's overlap that lie inside longer ones and are told apart, by number: km/h."""
        return self._measured.apart.get(g, {})

    @property
    def beyond(self) -> Mapping[tuple[NodeId, EdgeId], Beyond]:
        """What lies beyond the legs of points and the arms of crossings."""
        return self._measured.beyond

    @cached_property
    def _passed(self) -> list[tuple[NodeId, SectionId, SectionId, bool]]:
        """See `passed_joints`."""
        out = []
        for j, a, b in self._topo.joints():
            for s, t in ((a, b), (b, a)):
                if (j, t) not in self._topo.main_into:
                    out.append((j, s, t, (j, t) in self._topo.signal_into))
        return out

    def passed_joints(self) -> list[tuple[NodeId, SectionId, SectionId, bool]]:
        """Every (joint, from, to) over which locks go on: no signal governs the passage, or (True) only a shunt one."""
        return self._passed

    @cached_property
    def _into(self) -> dict[SectionId, list[tuple[NodeId, SectionId, bool]]]:
        """See `passed_into`."""
        found: dict[SectionId, list[tuple[NodeId, SectionId, bool]]] = {}
        for j, a, b, past in self._passed:
            found.setdefault(b, []).append((j, a, past))
        return found

    def passed_into(self, s: SectionId) -> list[tuple[NodeId, SectionId, bool]]:
        """The (joint, from, past) of these that lead into a section."""
        return self._into.get(s, [])


class LockFacts:
    """How sections are locked, and as overlap of which signals."""

    def __init__(self, symbols: Symbols, track: TrackFacts) -> None:
        self._sym, self._track = symbols, track
        self._locks: dict[str, list[tuple[int, Expr]]] = {}
        for (sec, n), name in sorted(self._sym.sections.lock.items()):
            self._locks.setdefault(sec, []).append((n, var(name)))
        self._overlaps: dict[str, list[tuple[int, tuple[SignalId, int], Expr]]] = {}
        self._options: dict[str, dict[tuple[SignalId, int], Name]] = {}
        for option, name in self._sym.overlaps.held.items():
            for s, n in self._sym.overlaps.ways[option]:
                self._overlaps.setdefault(s, []).append((n, option, var(name)))
                self._options.setdefault(s, {})[option] = name

    def lock(self, s: str, n: int) -> Expr:
        """Locked for one way."""
        return var(self._sym.sections.lock[SectionId(s), n])

    def of(self, s: str) -> list[tuple[int, Expr]]:
        """All locks of a section."""
        return self._locks.get(s, [])

    def restart(self, s: str) -> Expr:
        """Restart lock."""
        return var(self._sym.sections.restart[SectionId(s)])

    def firm(self, s: str) -> Expr:
        """Firmly locked."""
        return var(self._sym.sections.firm[SectionId(s)])

    def train(self, s: str) -> Expr:
        """The lock is for a train movement that has not come to its end."""
        return var(self._sym.sections.train[SectionId(s)]) if self._track.shunts else TRUE

    def locked_in(self, s: str, j: str) -> Expr:
        """Locked for a way in at j."""
        return disj(x for n, x in self.of(s) if self._track.way(s, n)[0] == j)

    def locked_out(self, s: str, j: str) -> Expr:
        """Locked for a way out at j."""
        return disj(x for n, x in self.of(s) if self._track.way(s, n)[1] == j)

    def any_lock(self, s: str) -> Expr:
        """Locked for some way."""
        return disj(x for _, x in self.of(s))

    def locked(self, s: str) -> Expr:
        """Locked by the restart or for a route."""
        return disj((self.restart(s), self.any_lock(s)))

    def held(self, s: str) -> Expr:
        """Locked in any manner, as overlap too."""
        return disj((self.locked(s), *self.overlaps(s)))

    def overlaps(
        self, s: str, numbers: tuple[int, ...] | None = None, but: tuple[SignalId, int] | None = None
    ) -> list[Expr]:
        """Held as overlap (for one of the ways), of whichever alternative `but` one."""
        those = self._overlaps.get(s, ())
        return [x for n, option, x in those if option != but and (numbers is None or n in numbers)]

    def options(self, s: str) -> Mapping[tuple[SignalId, int], Name]:
        """The overlap alternatives that lie over a section, with their variables."""
        return self._options.get(s, {})


class SeenFacts:
    """What detection reports, and what has been seen of the movement for which a section is locked."""

    def __init__(self, loop: ClosedLoop) -> None:
        self._layout, self._sym, self._plant = loop.layout, loop.controller.symbols, loop.plant

    def clear(self, s: str) -> Expr:
        """Reported clear by a healthy detector; never, without detection."""
        if SectionId(s) not in self._sym.sections.clear:
            return FALSE
        healthy = [var(self._sym.sections.healthy[SectionId(s)])] if SectionId(s) in self._sym.sections.healthy else []
        return conj((var(self._sym.sections.clear[SectionId(s)]), *healthy))

    def steadily_clear(self, s: str) -> Expr:
        """Reported clear, and that without a break for the release delay (R15); never, without detection."""
        timer = self._sym.sections.release_timer.get(SectionId(s))
        return FALSE if timer is None else conj((self.clear(s), var(timer)))

    def reported(self, m: MachineId, x: Position) -> Expr:
        """A machine is detected in a position, by valid and unambiguous contacts."""
        contact, opposite = var(self._sym.machines.detected[m, x]), var(self._sym.machines.detected[m, x.other])
        return conj((var(self._sym.valid), contact, neg(opposite)))

    def settled(self, m: MachineId, x: Position) -> Expr:
        """The machine lies so, and no drive the other way can still reach it."""
        return conj((lies(m, x), neg(old_command(m, x.other))))

    def used(self, s: str) -> Expr:
        """Used by a train."""
        return var(self._sym.sections.used[SectionId(s)])

    def passed(self, s: str) -> Expr:
        """The train has gone on."""
        return var(self._sym.sections.passed[SectionId(s)])

    def stale(self, s: str) -> Expr:
        """Inputs were lost while locked."""
        return var(self._sym.sections.stale[SectionId(s)])

    def been(self, s: str) -> Expr:
        """History: a train has come in since it was locked."""
        return var(names.BEEN(s))

    def shut(self, route: int) -> Expr:
        """History: the signal has been open, or the path was blocked, or a point in it trailed; it is closed while the
        route stays set, and nobody has just asked for it."""
        return var(names.SHUT(route))

    @cached_property
    def _overrun(self) -> dict[str, list[SignalId]]:
        order = {g: n for n, g in enumerate(self._layout.overlaps.length)}
        found: dict[str, list[SignalId]] = {}
        for name in self._plant.state:
            if name.family is names.OVERRAN:
                g, s = map(str, name.at)
                found.setdefault(s, []).append(SignalId(g))
        return {s: sorted(those, key=order.__getitem__) for s, those in found.items()}

    def overrun(self, s: str) -> list[SignalId]:
        """The signals with an overlap that what stands in a section may have overrun."""
        return self._overrun.get(s, [])


class Facts:
    """All that claims and invariants may see of a system, with short names for what they speak of: the railway, the
    plant, the names of the controller's variables and its timers, never an equation."""

    def __init__(self, system: System) -> None:
        loop = system.loop
        self.layout, self.topo, self.measured = loop.layout, loop.topo, loop.measured
        self.plant = loop.plant
        self.sym = loop.controller.symbols
        self.timers = system.relation.timers
        self.ties = system.ties
        self.zones = system.zones
        self.after = system.relation.after
        """The expression one step later."""
        self.track = TrackFacts(loop)
        self.locking = LockFacts(self.sym, self.track)
        self.seen = SeenFacts(loop)
        self.paths: dict[tuple[SignalId, bool], list[Any]] = {}
        self.movements: dict[SectionId, list[frozenset[SectionId]]] = {}


__all__ = ["Claim", "Facts", "Invariant", "conj", "neg"]
