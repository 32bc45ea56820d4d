"""What a bystander would call harm, found from positions in metres alone.

Two vehicles in the same place or foul of each other; a vehicle that runs over a point which does not lie for it, over a
derailer that is on, over a device that is not closed; rails that move under a vehicle, or ahead of one that was called
over them; more trains in a zone than are allowed; trains against each other on a line with a direction token.
"""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from interlock.dataclass import dataclass
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.simulate.track import NONE, Track
from interlock.simulate.train import Train

if TYPE_CHECKING:
    from interlock.simulate.scene import Scene

AHEAD_M = 4000.0
"""How far ahead of a called train points are looked at."""


@dataclass
class Watch:
    """Collects hazards, each told once for the same place and trains."""

    layout: Layout
    track: Track
    found: list[str] = field(default_factory=list)
    told: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        t, layout = self.track, self.layout
        number = {str(e.id): i for i, e in enumerate(layout.track.edges)}
        self._machine_nodes: list[list[frozenset[int]]] = [[] for _ in t.machines]
        for p in layout.pointwork.points:
            legs = frozenset(number[str(x)] for x in (p.toe, p.normal, p.reverse))
            self._machine_nodes[t.machines.index(str(p.machine))].append(legs)
        section = {s: i for i, s in enumerate(t.sections)}
        self._devices = [
            (
                t.machines.index(str(d.id)),
                frozenset(section[str(s)] for s in d.over),
                layout.machines.word(d.id, Position.REVERSE),
            )
            for d in layout.signalling.devices
        ]
        """Each device, the sections over which it lies, and how it is said to be for trains."""
        self.limits = [(z.id, z.trains, frozenset(section[str(s)] for s in z.sections)) for z in layout.declared.zones]

    def tell(self, clock: float, key: str, text: str) -> None:
        """A hazard, once."""
        if key not in self.told:
            self.told.add(key)
            self.found.append(f"{clock:.1f} s: {text}")

    def trains(self, world: Scene) -> None:
        """Vehicles in the same place or foul of each other, devices under them."""
        trains = world.trains
        for i, a in enumerate(trains):
            if not a.moved:
                continue
            for j, b in enumerate(trains):
                if i == j or (b.moved and j < i):
                    continue
                if not a.under.edges.isdisjoint(b.under.edges):
                    self._same(world, a, b)
                fouled = (a.under.zones[0] & b.under.zones[1]) | (a.under.zones[1] & b.under.zones[0])
                if fouled:
                    name = self.track.names_of_zones[fouled.bit_length() - 1]
                    text = f"trains {a.number} and {b.number} are foul of each other at {name}"
                    self.tell(world.clock, f"foul {a.number} {b.number} {name}", text)
            for m, over, secured in self._devices:
                if world.machines.position[m] != 1 and not over.isdisjoint(a.under.sections):
                    name = self.track.machines[m]
                    said = f"train {a.number} runs over {name}, not {secured}"
                    self.tell(world.clock, f"open {a.number} {name}", said)

    def comes_in(self, world: Scene, t: Train, section: int) -> None:
        """A head comes into a section in which another vehicle is (a shunting movement may, on sight in a berth, but
        not before a train that is still running in), or into a zone in which there are as many trains as there may be;
        what stands there at a restart may be more."""
        for name, most, inside in self.limits:
            if section in inside and inside.isdisjoint(x for x in t.under.sections if x != section):
                within = {o.origin for o in world.trains if not inside.isdisjoint(o.under.sections)} - {t.origin}
                if len(within) >= most:
                    text = f"train {t.number} comes into {name}, where {len(within)} are, {most} allowed"
                    self.tell(world.clock, f"zone {name} {t.number}", text)
        on_sight = t.driver.shunting and section in self.track.berths
        for o in world.trains:
            if o is not t and section in o.under.sections and (not on_sight or self._runs_in(o, section)):
                text = f"train {t.number} comes into {self.track.sections[section]}, where train {o.number} is"
                self.tell(world.clock, f"comes {t.number} {o.number} {section}", text)

    def _runs_in(self, t: Train, section: int) -> bool:
        """A train was called into a section, and is not yet wholly in."""
        tail, head = (self.track.stretches[d].section for d in (t.body[0], t.body[-1]))
        return t.driver.called and not t.driver.shunting and head == section != tail

    def contradicts(self, world: Scene, signal: int) -> None:
        """A signal shows two things at once."""
        name = self.track.signals[signal]
        self.tell(world.clock, f"lamps {name}", f"{name} shows contradicting lamps")

    def both_ways(self, world: Scene, machine: int) -> None:
        """A machine is driven both ways at once."""
        name = self.track.machines[machine]
        self.tell(world.clock, f"drives {name}", f"{name} is driven both ways at once")

    def _same(self, world: Scene, a: Train, b: Train) -> None:
        stretches = self.track.stretches
        for d in a.body:
            if stretches[d].outside or d >> 1 not in b.under.edges:
                continue
            lo, hi = a.span(self.track, d)
            for e in b.body:
                if e >> 1 == d >> 1:
                    low, high = b.span(self.track, e)
                    if lo < high and low < hi:
                        where = str(self.layout.track.edges[d >> 1].id)
                        text = f"trains {a.number} and {b.number} collide on {where}"
                        self.tell(world.clock, f"collide {a.number} {b.number}", text)

    def under_train(self, world: Scene, machine: int) -> Train | None:
        """A train that lies over one of a machine's points."""
        for legs in self._machine_nodes[machine]:
            for t in world.trains:
                if len(t.under.edges & legs) > 1 and self._over(t, legs):
                    return t
        return None

    def _over(self, t: Train, legs: frozenset[int]) -> bool:
        return any(a >> 1 in legs and b >> 1 in legs for a, b in zip(t.body, t.body[1:], strict=False))

    def machine_moves(self, world: Scene, machine: int) -> None:
        """Rails begin to move: under a vehicle, or ahead of one that was called over them?"""
        name = self.track.machines[machine]
        under = self.under_train(world, machine)
        if under is not None:
            self.tell(world.clock, f"under {name} {under.number}", f"{name} moves under train {under.number}")
        for t in world.trains:
            if t.driver.called and self._ahead(world, t, machine):
                text = f"{name} moves ahead of train {t.number}, which was called over it"
                self.tell(world.clock, f"ahead {name} {t.number}", text)

    def _ahead(self, world: Scene, t: Train, machine: int) -> bool:
        """Whether a called train meets the machine's points before the next signal that it obeys; one that has overrun
        a signal, before it stands."""
        s = self.track.stretches
        d, gone = t.body[-1], -t.head
        reach = t.driver.overruns if t.driver.stuck else AHEAD_M
        while gone < reach:
            gone += s[d].metres
            if s[d].machine == machine:
                return not t.driver.stuck or gone <= reach
            on = s[d].on
            ends = s[d].facing
            if ends is not None:
                lies = world.machines.lies[s[d].machine]
                if lies == NONE:
                    return False
                on = ends[lies]
            if on == NONE or world.sight.obeys(t, s[on].signal) or s[on].outside:
                return False
            d = on
        return False

    def starts(self, world: Scene, t: Train) -> None:
        """A vehicle begins to move: do the rails under it lie, are devices under it closed?"""
        s = self.track.stretches
        for a, b in zip(t.body, t.body[1:], strict=False):
            m = s[a].machine
            if m == NONE:
                continue
            ends = s[a].facing
            wanted = s[a].needs if ends is None else ends.index(b) if b in ends else NONE
            if world.machines.lies[m] != wanted:
                name = self.track.machines[m]
                self.tell(world.clock, f"starts {t.number} {name}", f"train {t.number} starts over {name}, lying wrong")

    def runs_over(self, world: Scene, t: Train, machine: int, text: str) -> None:
        """A vehicle comes to a point that does not lie for it."""
        name = self.track.machines[machine]
        self.tell(world.clock, f"over {t.number} {name}", f"train {t.number} {text} {name}")

    def derails(self, world: Scene, t: Train) -> None:
        """A vehicle comes off the rails."""
        self.tell(world.clock, f"derails {t.number}", f"train {t.number} runs off the rails")
