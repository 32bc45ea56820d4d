"""Where trains come from and what becomes of them: they appear, stand about, turn round, divide, are taken away."""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

from interlock.model.elements import BlockKind
from interlock.simulate.local_rules import run_through
from interlock.simulate.track import NONE, Beyond
from interlock.simulate.train import Train

if TYPE_CHECKING:
    from interlock.simulate.world import World


class Traffic:
    """The trains of a world as such; how they run is the drivers' business."""

    def __init__(self, world: World, fastest: float) -> None:
        self.world, self.track, self.rng = world, world.track, world.rng
        self.fastest = fastest
        self.most = max(3, min(10, len(self.track.sections) * 2 // 3))
        """Trains at one time."""
        self.numbers = 0
        """Of trains so far."""

    def new(self, body: list[int], head: float, tail: float) -> Train:
        """A train with a temper of its own."""
        rng, rules = self.rng, self.world.layout.principles
        self.numbers += 1
        t = Train(self.numbers, body, head, tail, origin=self.numbers)
        t.handling.brakes = rules.braking_ms2 * rng.uniform(1.0, 1.5)
        t.handling.gathers = rng.uniform(0.3, 0.8)
        t.handling.fastest = self.fastest * rng.choice((0.4, 0.8, 1.0, 1.0))
        t.handling.clear_view = rng.choice((1.0, 1.0, 0.3))
        t.handling.margin = rng.choice((1.0, 2.0, 5.0, 15.0))
        t.handling.patience = rng.uniform(100.0, 500.0)
        t.under.looks(self.track, t.body)
        t.fouls(self.track)
        self.world.trains.append(t)
        return t

    def place(self) -> None:
        """A train stands somewhere in the layout, whatever lies under it (R9 at a restart)."""
        rng, s = self.rng, self.track.stretches
        inside = [i for i, x in enumerate(s) if not x.outside]
        d = rng.choice(inside)
        tail = rng.uniform(0.0, s[d].metres)
        body, left = [d], rng.choice((15.0, 40.0, 80.0, 150.0)) - (s[d].metres - tail)
        while left > 0:
            ends = s[d].facing
            d = rng.choice(ends) if ends is not None else s[d].on
            if d == NONE or s[d].outside or s[d].derails or d in body or d ^ 1 in body:
                return
            body.append(d)
            left -= s[d].metres
        t = self.new(body, s[d].metres + left, tail)
        w = self.world
        self.waits_on(t)
        if any(o is not t and (not t.under.edges.isdisjoint(o.under.edges) or self._foul(t, o)) for o in w.trains):
            w.trains.remove(t)

    def waits_on(self, t: Train) -> None:
        """It stands at a restart, and is called after it, or taken away before or after."""
        t.driver.rests = 0.0
        t.handling.patience += self.world.layout.principles.restart_delay_s * self.rng.uniform(0.3, 1.5)

    @staticmethod
    def _foul(a: Train, b: Train) -> bool:
        return bool((a.under.zones[0] & b.under.zones[1]) | (a.under.zones[1] & b.under.zones[0]))

    def come(self, dt: float) -> None:
        """Trains appear on the lines, as long as there are not too many."""
        w, rng = self.world, self.rng
        if len(w.trains) < self.most and rng.random() < 0.1 * dt:
            lines = [b for b in self.track.beyond if b.comes != NONE]
            full = sum(any(t.body[0] in b.comes_by for t in w.trains) for b in lines)
            if lines and 2 * full < len(lines) + 1 - rng.randrange(2):
                self._comes(rng.choice(lines))

    def _comes(self, line: Beyond) -> None:
        """A train appears at the far end of a line, if nothing else is on the part where it appears."""
        w, s = self.world, self.track.stretches
        far = line.comes
        if any(t.body[0] == far for t in w.trains):
            return
        if line.block is BlockKind.TOKEN:
            if not w.neighbours[line.name].may_send():
                return
            w.neighbours[line.name].sends = False
        elif any(t.body[0] in line.comes_by for t in w.trains) and self.rng.random() < 0.6:
            return
        length = self.rng.choice((12.0, 30.0, 60.0, 120.0, 250.0))
        head = s[far].metres - (self.rng.random() * 100.0 if line.approach_m else 100.0)
        t = self.new([far], head, head - length)
        stop = (
            s[far].metres - head + line.approach_m - t.handling.margin
        )  # he knows the line, and where its signal stands
        t.driver.called, t.speed = True, min(0.5 * t.handling.fastest, sqrt(2 * t.handling.brakes * max(stop, 0.0)))
        t.handling.patience = self.rng.uniform(60.0, 400.0)

    def turns(self, t: Train) -> None:
        """It changes ends, wholly within one section at the end of which a signal governs its new way (A-REVERSE)."""
        s, sight = self.track.stretches, self.world.sight
        if len(t.under.sections) != 1 or any(s[d].outside for d in t.body):
            return
        d = t.body[0] ^ 1
        first = s[d].section
        for _ in range(50):
            on = sight.follows(s[d])
            if on == NONE:
                return
            if s[on].section != first:
                if s[on].signal != NONE:
                    t.turned(self.track)
                return
            d = on

    def divide(self, t: Train) -> None:
        """It parts: the front goes on as it did, the rear stays and is a vehicle of its own."""
        length = t.length(self.track)
        if length < 25.0 or any(self.track.stretches[d].outside for d in t.body):
            return
        rear, s = length * self.rng.uniform(0.2, 0.8), self.track.stretches
        body, at, d = [t.body[0]], t.tail + rear, 0
        while at > s[t.body[d]].metres:
            at -= s[t.body[d]].metres
            d += 1
            body.append(t.body[d])
        left = self.new(body, at, t.tail)
        left.origin, left.driver.shunting, left.driver.called, left.moved = t.origin, t.driver.shunting, False, False
        left.driver.stuck = not set(left.under.sections) <= self.track.berths  # wagons without an engine
        t.body, t.tail = t.body[d:], at + 0.5
        if t.tail > s[t.body[0]].metres and len(t.body) > 1:
            t.tail -= s[t.body[0]].metres
            t.body = t.body[1:]
        t.under.looks(self.track, t.body)
        t.fouls(self.track)

    def taken_away(self, t: Train) -> None:
        """It is moved under local rules, and may run through points of the sections that it stood in (挤岔, R10)."""
        self.world.trains.remove(t)
        for m in {x.machine for x in self.track.stretches if x.section in t.under.sections and x.machine != NONE}:
            if self.rng.random() < self.world.faults.trail:
                run_through(self.world, m)
