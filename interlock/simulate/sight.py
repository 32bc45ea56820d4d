"""What lies ahead of a driver, as points lie: signals to stop for, other vehicles, moving rails; all in metres."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf
from typing import TYPE_CHECKING

from interlock.model.stopping import END_M
from interlock.simulate.track import NONE, Stretch
from interlock.simulate.train import Train

if TYPE_CHECKING:
    from interlock.simulate.scene import Scene

LOOK_M = 3000.0


class Sight:
    """Looks along the rails of a world."""

    def __init__(self, world: Scene) -> None:
        self.world, self.track = world, world.track
        self.main: list[bool] = [g.main for g in world.track.layout.signalling.signals]

    def obeys(self, t: Train, signal: int) -> bool:
        """A train obeys main signals, a shunting movement all."""
        return signal != NONE and (self.main[signal] or t.driver.shunting)

    def follows(self, here: Stretch, moving: bool = False) -> int:
        """The stretch after one, or NONE; over moving rails where they move to, if that is asked for."""
        if here.facing is None:
            return here.on
        machines = self.world.machines
        lies = machines.lies[here.machine]
        if lies == NONE and moving:
            lies = machines.target[here.machine]
        return here.facing[lies] if lies != NONE else NONE

    def ahead(self, t: Train, metres: float) -> Iterator[tuple[int, float]]:
        """The stretches ahead of a train, each with the metres from the head to its end, the head's own first."""
        s = self.track.stretches
        d, gone = t.body[-1], -t.head
        while d != NONE:
            gone += s[d].metres
            yield d, gone
            if gone > metres:
                return
            d = self.follows(s[d], moving=True)

    def meets(self, t: Train, machine: int, metres: float) -> bool:
        """Whether a train would meet a machine's points within so many metres, whatever signals show."""
        return any(self.track.stretches[d].machine == machine for d, _ in self.ahead(t, metres))

    def rails_lie(self, t: Train, metres: float) -> bool:
        """Whether no rails move within so many metres ahead."""
        lies, s = self.world.machines.lies, self.track.stretches
        return all(s[d].machine == NONE or lies[s[d].machine] != NONE for d, _ in self.ahead(t, metres))

    def look(self, t: Train) -> None:
        """How far to the next thing to stop for (a signal, the end of the track), and from there to the next ones."""
        view = t.view
        s, w = self.track.stretches, self.world
        d, gap = t.body[-1], -t.head
        first = s[d].section
        view.target, view.further = NONE, ()
        signals: list[int] = []
        view.at = w.machines.version
        called = t.driver.called
        stops: list[float] = []
        while gap < LOOK_M and len(stops) < 3:
            gap += s[d].metres
            on = self.follows(s[d], moving=True)
            if on == NONE:
                stops.append(gap - END_M if called else 0.0)
                break
            signal = s[on].signal
            if signal != NONE and (self.obeys(t, signal) or not called):
                if not stops:
                    view.target = signal
                stops.append(gap)
                signals.append(signal)
                called = True
            elif not called and s[on].section != first:
                stops.append(0.0)
                break
            if s[on].outside and s[on].on == NONE:
                break
            d = on
        view.signals = tuple(signals)
        view.gap = stops[0] if stops else inf
        view.further = tuple(x - view.gap for x in stops[1:])

    def vehicle(self, t: Train, reach: float, anywhere: bool) -> float:
        """Metres to the next vehicle ahead within reach: anywhere, or where it is looked out for (lines, berths)."""
        s, w = self.track.stretches, self.world
        if len(w.trains) < 2:
            return inf
        d, gap = t.body[-1], -t.head
        while gap < reach:
            if anywhere or s[d].outside or s[d].section in self.track.berths:
                nearest = inf
                for o in w.trains:
                    if o is not t and d >> 1 in o.under.edges:
                        nearest = min(nearest, self._on(o, d, gap))
                if nearest < inf:
                    return nearest
            gap += s[d].metres
            d = self.follows(s[d])
            if d == NONE:
                return inf
        return inf

    def _on(self, o: Train, d: int, gap: float) -> float:
        """Metres to a vehicle on a stretch that begins `gap` metres ahead; infinite where it lies behind."""
        metres, nearest = self.track.stretches[d].metres, inf
        for e in o.body:
            if e >> 1 == d >> 1:
                lo, hi = o.span(self.track, e)
                rear, front = (metres - hi, metres - lo) if d & 1 else (lo, hi)
                if gap + front > 0.0:
                    nearest = min(nearest, max(0.0, gap + rear))
        return nearest
