"""The railway that a panel works when no Modbus address is given: `simulate`'s world, in which nothing happens that
nobody has asked for.

Trains come, turn, divide and go when the person at the panel says so (`stock`); faults come and go likewise (`faults`).
Drivers obey signals by themselves.  The substations are links like any other, with heartbeats: the same soft PLC runs
on them.
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.field.plc import LinkLost
from interlock.logic.cabinet import Allocation
from interlock.model.layout import Layout
from interlock.panel.faults import Faults
from interlock.panel.stock import CommandedWorld, Stock
from interlock.simulate.local_rules import power_cut


class SimulatedField:
    """The railway, and the links to its substations."""

    def __init__(
        self,
        layout: Layout,
        allocation: Allocation,
        inputs: Mapping[str, tuple[int, int]],
        outputs: Mapping[str, bool],
        scan_s: float,
    ) -> None:
        """`inputs`: restrictive value and size by name, `outputs`: restrictive value by name, `scan_s`: seconds from
        one scan to the next at most."""
        self.layout, self.allocation = layout, allocation
        self.world = CommandedWorld(layout, inputs, outputs)
        self.world.drivers.scan_s = scan_s
        self.restrictive = {n: int(v) for n, v in outputs.items()}
        self.shown = dict(self.restrictive)
        self.stock = Stock(self.world)
        self.faults = Faults(self.world, allocation.stations)
        self.links = {s: _Link(self, s) for s in allocation.stations}

    def step(self, dt: float, operator: Mapping[str, int]) -> None:
        """The railway runs on under the outputs as shown; `operator`: what is written at the operator's place."""
        w = self.world
        w.reports.inputs |= operator
        self.stock.arrive()
        inputs = w.step(dt, self.shown)
        if w.machines.damaged:
            w.machines.mend(inputs, self.shown)
        w.reports.read()

    def dark(self) -> None:
        """The controller has no power: outputs fall back, whoever stands needs a new call."""
        self.shown = dict(self.restrictive)
        self.world.reports.past.clear()
        power_cut(self.world)


class _Link:
    """A substation of the simulated railway."""

    def __init__(self, field: SimulatedField, station: str) -> None:
        self.field, self.station = field, station
        a = field.allocation
        self.wired = [c.variable for c in a.channels if c.direction == "I" and c.substation == station]
        self.beats = [c.variable for c in a.heartbeats if c.substation == station]
        self.bits = [c.variable for c in a.diagnoses if c.substation == station]
        self.beat = 0

    def _alive(self) -> None:
        if self.station in self.field.faults.cut:
            raise LinkLost("no answer")

    def read(self) -> Mapping[str, int]:
        """Inputs as the railway has them now."""
        self._alive()
        self.beat ^= 1
        inputs = self.field.world.reports.inputs
        told = {**{n: inputs[n] for n in self.wired}, **dict.fromkeys(self.beats, self.beat)}
        return {**told, **dict.fromkeys(self.bits, 1)}

    def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
        """Outputs as they are shown from now on."""
        del heartbeat
        if self.station in self.field.faults.cut:
            self.field.shown |= {n: self.field.restrictive[n] for n in values}
        self._alive()
        self.field.shown |= {n: int(v) for n, v in values.items()}

    def close(self) -> None:
        """Nothing is left to be closed."""
