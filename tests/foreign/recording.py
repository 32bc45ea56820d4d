"""Trains in metres on the emitted runtime in its cabinet, laid down scan by scan as it stands on the wires.

The simulator says at times that the inputs are not valid; on the wires that is a substation whose heartbeat stands
still.  Cycles are stalled more often than in the simulator's campaign, and by exactly the bound and one millisecond
more; each power cut ends a segment.  A second recording has inputs at random, that no railway gives.

Nothing moves before the restart delay is over: lives shorter than it, and power cuts more often than it ends, would
record restarts and no railway.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from random import Random
from typing import Any

from interlock.field.plc import SoftPlc, runtime_scan
from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.simulate.faults import Faults
from interlock.simulate.run import Life, Outcome, load
from interlock.simulate.track import Track
from tests.foreign.wiring import Segment, Wiring

STALLED = 0.02
"""Chance of a stalled cycle in each scan of a life with stalls."""
STILL_MS = (400, 900, 1000, 1100, 3000)
"""How long a heartbeat stands still, at times."""
QUIET = Faults(inputs=0.0, stall=0.0, power=0.0)
CUTS = 0.5
"""Power cuts for each restart delay that passes, on average: most railways outlive one."""
ROUNDS = 8
"""How often all lives are lived, at most, to have as many movements and power cuts as are asked for."""
OFTEN = {"DN_": 0.5, "DR_": 0.5, "BLK_": 0.03, "CAN_": 0.03}
"""Of inputs at random: how often they are 1, by the beginning of their names; others nearly always."""
STARTS_MS = (0, 1, 86_400_000, 31 * 86_400_000)
"""What the clock of the PLC may say at power-on: no timer depends on it."""


@dataclass(frozen=True)
class Railway:
    """What is recorded: a layout, its runtime's text, its wires, what an operator knows of its routes, and the words
    of routes that are compared, by the routes' numbers."""

    layout: Layout
    controller: Controller
    allocation: Allocation
    runtime: str
    routes: Mapping[str, tuple[int, ...]]
    words: Mapping[int, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Recording:
    """Segments, what ran in them, stalled cycles, power cuts, and scans with inputs that were not valid."""

    wiring: Wiring
    segments: tuple[Segment, ...]
    trains: int
    movements: int
    stalls: int
    power_cuts: int
    invalid: int

    @property
    def scans(self) -> int:
        """Scans of all segments."""
        return sum(s.scans for s in self.segments)


class _Wire:
    """A substation as the soft PLC sees it."""

    def __init__(self) -> None:
        self.values: dict[str, int] = {}

    def read(self) -> Mapping[str, int]:
        return self.values

    def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
        """What is written is recorded from the cycle's outputs."""

    def close(self) -> None:
        """Nothing to let go of."""


class Recorder:
    """Stands where the runtime's class stands in a simulated life: makes a cabinet at each power-on."""

    def __init__(self, railway: Railway, rng: Random) -> None:
        self.railway, self.rng = railway, rng
        self.wiring = Wiring.of(railway.controller, railway.allocation, [*railway.words.values()])
        self.segments: list[Segment] = []
        self.stalls = self.invalid = 0
        self.cycle_max_ms: int = load(railway.runtime)["Controller"].cycle_max_ms

    def __call__(self) -> _Cabinet:
        """Power-on."""
        self.segments.append(Segment(self.rng.choice(STARTS_MS)))
        return _Cabinet(self, self.segments[-1])


class _Cabinet:
    """The soft PLC between its substations, from one power-on to the next."""

    def __init__(self, recorder: Recorder, segment: Segment) -> None:
        self.recorder, self.segment, self.rng = recorder, segment, recorder.rng
        allocation = recorder.railway.allocation
        self.beats = {c.variable: self.rng.randrange(2) for c in allocation.heartbeats}
        self.still: dict[str, int] = {}
        self.links = {s: _Wire() for s in allocation.stations}
        self.well = {c.variable: 1 for c in allocation.diagnoses}
        self.sent = [c.variable for c in allocation.sent]
        self.wires = [(c.variable, c.substation) for c in allocation.channels if c.direction == "I"]
        runtime = runtime_scan(recorder.railway.runtime)
        self.plc = SoftPlc(runtime, allocation, self.links, recorder.railway.controller.symbols.valid)

    def scan(self, inputs: Mapping[str, int], dt_ms: int) -> Mapping[str, bool]:
        """One scan, recorded."""
        recorder, allocation = self.recorder, self.recorder.railway.allocation
        self._beat(bool(inputs[self.plc.valid_name]), dt_ms)
        signs = {**self.beats, **self.well}
        for s in allocation.stations:
            self.links[s].values = {}
        for c in (*allocation.heartbeats, *allocation.diagnoses):
            self.links[c.substation].values[c.variable] = signs[c.variable]
        for name, station in self.wires:
            self.links[station].values[name] = inputs[name]
        cycle = self.plc.cycle({n: inputs[n] for n in allocation.written}, dt_ms)
        recorder.stalls += dt_ms > recorder.cycle_max_ms
        recorder.invalid += not cycle.valid or dt_ms > recorder.cycle_max_ms
        self.segment.given += recorder.wiring.given({**inputs, **signs}, dt_ms)
        beats = dict.fromkeys(self.sent, self.plc.heartbeat)
        said = cycle.words() if recorder.railway.words else {}
        words = {name: said[number] for number, name in recorder.railway.words.items()}
        self.segment.told += recorder.wiring.told({**cycle.outputs, **beats, **words})
        self.segment.scans += 1
        return cycle.outputs

    def _beat(self, valid: bool, dt_ms: int) -> None:
        """Heartbeats change in most cycles; now and then one stands still for a while, or as long as a fault lasts."""
        rng = self.rng
        if not valid and not self.still:
            self.still[rng.choice(sorted(self.beats))] = rng.choice(STILL_MS)
        elif rng.random() < 0.002:
            self.still.setdefault(rng.choice(sorted(self.beats)), rng.choice(STILL_MS))
        for name in self.beats:
            if name in self.still:
                self.still[name] -= dt_ms
                if self.still[name] < 0 and valid:
                    del self.still[name]
            elif rng.random() < 0.95:
                self.beats[name] ^= 1


class _Life(Life):
    """A railway with cycles that are stalled."""

    stalled = 0.0

    def _cycle(self, stopped: float) -> float:
        if self.rng.random() < self.stalled:
            exactly = self.rng.choice((0.0, 0.001))
            return self.longest_s + exactly if self.rng.random() < 0.5 else self.longest_s * self.rng.uniform(0.5, 4.0)
        return super()._cycle(stopped)


LIVES = ((False, False), (True, False), (False, True), (True, True))
"""Railways that are recorded: whether the operator is hostile, and whether there are many stalls, heartbeats that are
lost, and power cuts."""


def harsh_faults(railway: Railway) -> Faults:
    """Heartbeats that are lost, and power cuts as often as the layout's restart delay lets trains run between them."""
    return replace(QUIET, inputs=0.003, power=CUTS / railway.layout.principles.restart_delay_s)


def record(
    railway: Railway,
    scans: int,
    seed: int,
    lives: Sequence[tuple[bool, bool]] = LIVES,
    movements: int = 0,
    power_cuts: int = 0,
) -> Recording:
    """So many scans, each life its share; then as many again with other trains, until there were so many movements and
    power cuts, in eight rounds at most."""
    track = Track.of(railway.layout)
    total = Outcome()
    segments: list[Segment] = []
    stalls = invalid = 0
    for n in range(ROUNDS * len(lives)):
        if n >= len(lives) and n % len(lives) == 0 and total.movements >= movements and total.power_cuts >= power_cuts:
            break
        k = n % len(lives)
        hostile, harsh = lives[k]
        rng = Random(f"{seed} {n}")
        recorder = Recorder(railway, Random(f"wires {seed} {n}"))
        names: dict[str, Any] = {**load(railway.runtime), "Controller": recorder}
        faults = harsh_faults(railway) if harsh else QUIET
        life = _Life(railway.layout, track, names, rng, hostile, railway.routes, faults)
        life.stalled = STALLED if harsh else STALLED / 20
        life.run(scans * (k + 1) // len(lives) - scans * k // len(lives), total, lambda _: False, None)
        segments += [s for s in recorder.segments if s.scans]
        stalls, invalid = stalls + recorder.stalls, invalid + recorder.invalid
    wiring = recorder.wiring
    return Recording(wiring, tuple(segments), total.trains, total.movements, stalls, total.power_cuts, invalid)


def scramble(railway: Railway, scans: int, seed: int) -> Recording:
    """So many scans with inputs at random, most as they were in the scan before; cycles about as long as the bound."""
    rng, inputs = Random(f"scrambled {seed}"), railway.controller.inputs
    recorder = Recorder(railway, rng)
    cabinet, longest = recorder(), recorder.cycle_max_ms
    values = {i.name: i.restrictive for i in inputs}
    often = {i.name: next((c for p, c in OFTEN.items() if i.name.startswith(p)), 0.95) for i in inputs}
    for _ in range(scans):
        for i in inputs:
            if i.size and rng.random() < 0.3:
                values[i.name] = rng.randrange(i.size)
            elif not i.size and rng.random() < 0.2:
                values[i.name] = int(rng.random() < often[i.name])
        values[railway.controller.symbols.valid] = int(rng.random() < 0.999)
        cabinet.scan(
            values, rng.choice((longest + 1, 3 * longest) if rng.random() < 0.02 else (100, 400, 900, longest))
        )
    return Recording(recorder.wiring, tuple(recorder.segments), 0, 0, recorder.stalls, 0, recorder.invalid)
