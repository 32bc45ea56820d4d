"""The railway that the runtime controls: machines, detection, lamps, trains that come and go, and what may go wrong.

One step: the world runs for the time since the last scan under the outputs as shown, then the inputs are sampled.
Outputs reach the ground at once or one scan late (A-LATE-OUTPUT).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import ceil
from random import Random

from interlock.model.elements import BlockKind
from interlock.model.layout import Layout
from interlock.simulate.driver import Drivers
from interlock.simulate.faults import Faults
from interlock.simulate.hazards import Watch
from interlock.simulate.machines import Machines
from interlock.simulate.neighbour import Neighbour
from interlock.simulate.reports import Reports
from interlock.simulate.sight import Sight
from interlock.simulate.track import Track
from interlock.simulate.traffic import Traffic
from interlock.simulate.train import Train


class World:
    """Everything outside the controller."""

    def __init__(
        self,
        layout: Layout,
        track: Track,
        inputs: Mapping[str, tuple[int, int]],
        outputs: Iterable[str],
        rng: Random,
        faults: Faults,
    ) -> None:
        self.layout, self.track, self.rng, self.faults = layout, track, rng, faults
        self.reports = Reports(self, inputs)
        self.machines = Machines(layout, track, rng)
        self.trains: list[Train] = []
        self.clock = 0.0
        self.watch = Watch(layout, track)
        self.sight: Sight = Sight(self)
        self.drivers = Drivers(self, outputs)
        self.traffic = Traffic(self, self.drivers.fastest)
        self.neighbours = {b.name: Neighbour(self, b) for b in track.beyond if b.block is BlockKind.TOKEN}
        for _ in range(rng.randrange(self.traffic.most + 4 * sum(z.trains for z in layout.declared.zones))):
            self.traffic.place()

    def step(self, dt: float, shown: Mapping[str, int]) -> dict[str, int]:
        """The world runs for `dt` seconds under the outputs as shown; the inputs as sampled then."""
        parts = ceil(dt)
        for _ in range(parts):  # drivers act at least once a second, however long a cycle is
            self._runs(dt / parts, shown)
        self.reports.step(dt)
        for neighbour in self.neighbours.values():
            neighbour.step(shown)
        return self.reports.inputs

    def _runs(self, dt: float, shown: Mapping[str, int]) -> None:
        self.clock += dt
        both: list[int] = []
        for m in self.machines.run(dt, shown, both):
            self.watch.machine_moves(self, m)
        for m in both:
            self.watch.both_ways(self, m)
        for m in self.machines.damaged:
            # nobody could see what happens while inputs are lost
            self.machines.damaged[m] -= dt * self.reports.inputs["VALID"]
        self.drivers.step(dt, shown)
        self.traffic.come(dt)
        self.watch.trains(self)
