"""A railway with a fleet, event by event: trains in closed form, points that take their time, sections that report.

Every harm that `hazards` knows is looked for whenever a train comes to a joint or rails begin to move.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from random import Random

from interlock.model.stopping import SIGNAL_M
from interlock.simulate.agenda import Agenda
from interlock.simulate.driving import Build, Driving, Rolling
from interlock.simulate.hazards import Watch
from interlock.simulate.inputs import Inputs
from interlock.simulate.motion import standing
from interlock.simulate.points import Points
from interlock.simulate.sight import Sight
from interlock.simulate.track import Track
from interlock.simulate.train import Handling, Train


class Yard:
    """The world of a shift.  `inputs`: those of the controller, written here; `say`: whom events are told."""

    def __init__(
        self, track: Track, inputs: dict[str, int], agenda: Agenda, rng: Random, say: Callable[..., None]
    ) -> None:
        self.track, self.agenda, self.say = track, agenda, say
        self.inputs = Inputs(track, inputs, agenda)
        self.trains: list[Train] = []
        self.rolling: dict[str, Rolling] = {}
        self.machines = Points(self, rng)
        self.sight = Sight(self)
        self.watch = Watch(track.layout, track)
        self.driving = Driving(self)
        self._numbers = 0

    @property
    def clock(self) -> float:
        """Seconds."""
        return self.agenda.clock

    def shown(self, outputs: Mapping[str, int]) -> None:
        """The outputs of a scan reach the ground."""
        self.machines.drive(outputs)
        self.driving.shown(outputs)

    def room(self, boundary: str) -> bool:
        """No train is on the line beyond a boundary over which trains come in, neither on its way in nor out."""
        line = next({*b.comes_by, b.goes} for b in self.track.beyond if b.name == boundary)
        return not any(d in line for t in self.trains for d in t.body)

    def comes(self, name: str, build: Build, boundary: str) -> Rolling:
        """A train comes towards a boundary, over the approach section if there is one."""
        line = next(b for b in self.track.beyond if b.name == boundary)
        first = line.comes_by[0]
        metres = self.track.stretches[first].metres
        self._numbers += 1
        t = Train(self._numbers, [first], metres - 1.0, metres - 1.0 - build.length, origin=self._numbers)
        t.driver.called = True
        t.handling = Handling(build.brakes, build.gathers, build.speed, SIGNAL_M)
        t.under.looks(self.track, t.body)
        r = Rolling(name, build, t, standing(self.clock, 0.0), -t.head, -t.tail)
        self.trains.append(t)
        self.rolling[name] = r
        self.say("comes", train=name, at=boundary)
        self.driving.drives(r)
        return r

    def taken_away(self, r: Rolling) -> None:
        """A train is moved off under local rules."""
        self.trains.remove(r.train)
        del self.rolling[r.name]
        self.agenda.forget(f"train {r.name}")
        self.agenda.forget(f"reads {r.name}")
        r.train.body = []
        self.driving.recount(r)
