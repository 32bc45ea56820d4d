"""The railway that the runtime controls: machines, detection, lamps, trains that come and go, and what may go wrong.

One step: the world runs for the time since the last scan under the outputs as shown, then the inputs are sampled.
Outputs reach the ground at once or one scan late (A-LATE-OUTPUT).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from math import ceil
from random import Random

from interlock.model.elements import BlockKind, Work
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.simulate.called import Called
from interlock.simulate.driver import Drivers
from interlock.simulate.faults import Faults
from interlock.simulate.hazards import Watch
from interlock.simulate.neighbour import Neighbour
from interlock.simulate.sight import Sight
from interlock.simulate.track import NONE, Track
from interlock.simulate.traffic import Traffic
from interlock.simulate.train import Train


class Machines:
    """Points, devices and keys: position 0 or 1, or moving with seconds left; contacts may be lost."""

    def __init__(self, layout: Layout, track: Track, rng: Random) -> None:
        n = len(track.machines)
        self._track, self._rng = track, rng
        self._run_s = layout.principles.point_run_s
        self.position = [rng.randrange(2) for _ in range(n)]
        self.target = list(self.position)
        self.left = [0.0] * n
        self.names = [portable(m) for m in track.machines]
        self.hand = [m in {str(p.machine) for p in layout.points if p.work is Work.HAND} for m in track.machines]
        self._device = [m in {str(d.id) for d in layout.devices} for m in track.machines]
        self._drives = [(f"YN_{n}", f"YR_{n}") for n in self.names]
        self.contacts = [(f"DN_{n}", f"DR_{n}") for n in self.names]
        self._confirms = [f"TC_{n}" for n in self.names]
        self._alarms = [f"YT_{n}" for n in self.names]
        self.lost: dict[int, tuple[float, int]] = {}
        self.driven: set[int] = set()
        """Machines that the controller has driven since its last restart: it knows where they belong."""
        self.damaged: dict[int, float] = {}
        """Points that were run through, with the seconds until their contacts meet again; their rails lie nowhere."""
        self.lies = list(self.position)
        """How the rails lie, NONE while they move; of a hand-worked point its key tells only whether it may move."""
        self.version = 0

    def lay(self, m: int, position: int) -> None:
        """The rails lie otherwise, or nowhere."""
        if m in self.damaged:
            position = NONE
        if self.lies[m] != position:
            self.lies[m] = position
            self.version += 1

    def run(self, dt: float, shown: Mapping[str, int], both: list[int]) -> list[int]:
        """Move for a while; the machines whose rails began to move, and in `both` those that are driven both ways."""
        started = []
        for m, (normal, reverse) in enumerate(self._drives):
            if shown[normal] and shown[reverse]:
                both.append(m)
            to = 0 if shown[normal] else 1 if shown[reverse] else NONE
            if to == NONE and not self.left[m]:
                continue
            if to != NONE:
                self.driven.add(m)
            if to not in (NONE, self.target[m]):
                self.target[m] = to
                self.left[m] = self._run_s * self._rng.uniform(0.3, 1.0)
                self.position[m] = NONE
                if not self.hand[m]:
                    started.append(m)
                    self.lay(m, NONE)
            elif self.left[m] and to != NONE:
                self.left[m] = max(0.0, self.left[m] - dt)
                if not self.left[m]:
                    self.damaged.pop(m, None)  # a full throw puts them right, too
                    self.position[m] = self.target[m]
                    self.lay(m, 0 if self.hand[m] and not self.position[m] else self._final(m))
            if self.hand[m] and self.position[m] == 1 and self._rng.random() < 0.02:
                started.append(m)
                self.lay(m, self._rng.choice((0, 1, NONE)))
            elif self.hand[m] and self.position[m] == NONE and self.target[m] == 0 and self.lies[m] != 0:
                started.append(m)
                self.lay(m, 0)  # turned back by hand before the key is locked
        return started

    def _final(self, m: int) -> int:
        return self.lies[m] if self.hand[m] else self.position[m]

    def damage(self, m: int, seconds: float) -> None:
        """Points are run through: their rails are not to be trusted, their contacts open and meet again by and by."""
        self.damaged[m] = seconds
        self.lay(m, NONE)

    def mend(self, inputs: Mapping[str, int], shown: Mapping[str, int]) -> None:
        """Whoever is told of trailed points, and confirms that they were looked at, has put them right."""
        for m in tuple(self.damaged):
            if inputs.get(self._confirms[m]) and shown.get(self._alarms[m]):
                del self.damaged[m]
                self.lay(m, self.position[m])

    def report(self, inputs: dict[str, int]) -> None:
        """Contacts as sampled."""
        for m, (normal, reverse) in enumerate(self.contacts):
            p = self.position[m]
            inputs[normal], inputs[reverse] = int(p == 0), int(p == 1)
        for m, left in self.damaged.items():
            if left > 0.0:
                inputs[self.contacts[m][0]] = inputs[self.contacts[m][1]] = 0
        for m, (_, both) in self.lost.items():
            inputs[self.contacts[m][0]] = inputs[self.contacts[m][1]] = both


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
        self.rules = layout.principles
        self.inputs: dict[str, int] = {name: restrictive for name, (restrictive, _) in inputs.items()}
        for name in self.inputs:
            if name.startswith(("RL_", "GL_", "CL_", "NL_", "E_", "SH_", "VALID")):
                self.inputs[name] = 1
        self.conditions = [n for n in self.inputs if n.startswith("E_")]
        self.lamps = [n for n in self.inputs if n.startswith(("RL_", "GL_", "CL_", "NL_"))]
        self.clear = [f"CLR_{portable(s)}" for s in track.sections]
        self._healthy = [f"SH_{portable(s)}" for s in track.sections]
        self._sensors = [i for i, n in enumerate(self._healthy) if n in self.inputs]
        self._sick: dict[int, tuple[float, int | None]] = {}
        """Detectors that are not healthy: for how long, and what they report, or None for anything."""
        self._wired = [n for n in self.clear if n in self.inputs]
        self.clear_wired = [n in self.inputs for n in self.clear]
        self.machines = Machines(layout, track, rng)
        self.trains: list[Train] = []
        self.count = [0] * len(track.sections)
        self._was = [0] * len(track.sections)
        self.false: dict[int, float] = {}
        self._shunt_lost: dict[int, float] = {}
        self.out: dict[str, float] = {}
        self._invalid = 0.0
        self._garbled: int | None = None
        """What is read of sections while inputs are lost, or None for anything."""
        self.clock = 0.0
        self.scan_s = 0.1
        """Seconds from one scan to the next, at most, while something moves and nothing is wrong."""
        self.watch = Watch(layout, track)
        self.past: deque[tuple[Mapping[str, int], list[int]]] = deque(maxlen=2)
        """Inputs as the last two scans read them, and how many vehicles were in each section then."""
        kmh = sorted({int(n.split("_", 1)[0][2:]) for n in outputs if n.startswith("YV")})
        self.speeds = [(v, [f"YV{v}_{portable(g)}" for g in track.signals]) for v in kmh]
        self.sight: Sight = Sight(self)
        self.drivers = Drivers(self)
        self.traffic = Traffic(self, self.drivers.fastest)
        self.called = Called(self)
        self.lines = [Neighbour(self, b) for b in track.beyond if b.block is BlockKind.TOKEN]
        self.token_at = {n.line.name: n for n in self.lines}
        self.most = max(3, min(10, len(track.sections) * 2 // 3))
        self.numbers = 0
        self.movements = 0
        self.passed_at_stop: list[str] = []
        for _ in range(rng.randrange(self.most + 4 * sum(z.trains for z in layout.zones))):
            self.traffic.place()

    def new_number(self) -> int:
        """The number of a new train."""
        self.numbers += 1
        return self.numbers

    def step(self, dt: float, shown: Mapping[str, int]) -> dict[str, int]:
        """The world runs for `dt` seconds under the outputs as shown; the inputs as sampled then."""
        parts = ceil(dt)
        for _ in range(parts):  # drivers act at least once a second, however long a cycle is
            self._runs(dt / parts, shown)
        self._faults(dt)
        self._detect(dt)
        for line in self.lines:
            line.step(shown)
        return self.inputs

    def _runs(self, dt: float, shown: Mapping[str, int]) -> None:
        self.clock += dt
        both: list[int] = []
        for m in self.machines.run(dt, shown, both):
            self.watch.machine_moves(self, m)
        for m in both:
            self.watch.both_ways(self, m)
        for m in self.machines.damaged:
            self.machines.damaged[m] -= dt * self.inputs["VALID"]  # nobody could see what happens while inputs are lost
        self.drivers.step(dt, shown)
        self.traffic.come(dt)
        self.watch.trains(self)

    def power_cut(self) -> None:
        """The controller has gone dark: whoever stands needs a new call; points may be cranked, devices open."""
        for t in self.trains:
            if t.speed == 0.0:
                t.driver.called = t.driver.accepted = t.driver.expects = False
                self.traffic.waits_on(t)
        self.machines.lost.clear()
        self.machines.driven.clear()

    def run_through(self, m: int) -> None:
        """A vehicle runs through points under local rules, where no train is called over them."""
        machines, position = self.machines, self.machines.position[m]
        if m not in machines.driven or machines.hand[m] or position == NONE or m in machines.damaged:
            return
        contact = machines.contacts[m][position]
        if not all(past["VALID"] and past[contact] for past, _ in self.past):
            return
        if any((t.speed or t.driver.accepted) and self.sight.meets(t, m, 1500.0) for t in self.trains):
            return
        if self.watch.under_train(self, m) is None:
            machines.damage(m, self.rng.uniform(6.0, 20.0))

    def cranked(self) -> None:
        """While everything stands without power points are cranked and devices open, but no point under a train."""
        for m in range(len(self.machines.names)):
            if self.rng.random() < 0.3 and not self.watch.under_train(self, m):
                p = self.rng.randrange(2)
                self.machines.position[m] = self.machines.target[m] = p
                self.machines.left[m] = 0.0
                self.machines.lay(m, p)

    def _faults(self, dt: float) -> None:
        rng, f = self.rng, self.faults
        if rng.random() < f.false * dt * len(self.clear):
            s = rng.randrange(len(self.clear))
            if not self._beside_false(s):
                self.false[s] = rng.choice((0.0, 1.0, 5.0, 30.0))
        if rng.random() < f.contact * dt * len(self.machines.names) and self.machines.names:
            m = rng.randrange(len(self.machines.names))
            self.machines.lost[m] = (rng.choice((0.0, 1.0, 20.0)), int(rng.random() < f.contradict))
        for m, (left, both) in tuple(self.machines.lost.items()):
            if left < 0:
                del self.machines.lost[m]
            else:
                self.machines.lost[m] = (left - dt, both)
        for names, rate in ((self.lamps, f.lamp), (self.conditions, f.condition)):
            if names and rng.random() < rate * dt * len(names):
                self.out[rng.choice(names)] = rng.choice((1.0, 10.0, 60.0))
        for name, left in tuple(self.out.items()):
            self.out[name] = left - dt
            self.inputs[name] = 0
            if left < 0:
                del self.out[name]
                self.inputs[name] = 1
        if rng.random() < f.inputs * dt:
            self._invalid, self._garbled = rng.choice((0.0, 1.0, 5.0, 20.0)), rng.choice((1, 1, 0, None))
        if self._sensors and rng.random() < f.sensor * dt * len(self._sensors):
            held = [s for s in self._sensors if self.count[s]]
            s = rng.choice(held if held and rng.random() < 0.5 else self._sensors)
            self._sick[s] = rng.choice((0.0, 2.0, 20.0, 60.0)), rng.choice((1, 1, 0, None))
        self.inputs["VALID"] = int(self._invalid < 0)
        self._invalid -= dt if self._invalid >= 0 else 0.0
        if f.shunt and rng.random() < f.shunt * dt * len(self.clear):
            s = rng.randrange(len(self.clear))
            if self.count[s] and s not in self._shunt_lost:
                self._shunt_lost[s] = rng.uniform(0.0, f.shunt_s)

    def _beside_false(self, s: int) -> bool:
        return any(n in self.false for n in self.track.neighbours[s])

    def _detect(self, dt: float) -> None:
        """Sections as reported: late by a scan where a train has just come in or left, false where a fault says so."""
        count = [0] * len(self.count)
        for t in self.trains:
            for s in t.under.sections:
                count[s] += 1
        rng, late = self.rng, self.faults.late
        held: list[int] = []
        for s, n in enumerate(count):
            clear = not n
            if clear != (not self._was[s]) and rng.random() < late:
                if not clear:
                    clear = True  # just entered
                elif not self._beside_false(s) and not any(x in held for x in self.track.neighbours[s]):
                    clear = False  # just left
                    held.append(s)
            elif n and s in self._shunt_lost:
                clear = True
            if self.clear_wired[s]:
                self.inputs[self.clear[s]] = int(clear)
        for s, left in tuple(self.false.items()):
            if self.clear_wired[s] and not any(x in held for x in self.track.neighbours[s]):
                self.inputs[self.clear[s]] = 0
            self.false[s] = left - dt
            if left < 0:
                del self.false[s]
        for s, left in tuple(self._shunt_lost.items()):
            self._shunt_lost[s] = left - dt
            if left < 0:
                del self._shunt_lost[s]
        for s, (left, read) in tuple(self._sick.items()):
            self.inputs[self._healthy[s]] = int(left < 0)
            if left < 0:
                del self._sick[s]
            else:
                self.inputs[self.clear[s]] = rng.randrange(2) if read is None else read
                self._sick[s] = left - dt, read
        self._was, self.count = count, count
        self.machines.report(self.inputs)
        if self._invalid >= 0:
            for name in self._wired:
                self.inputs[name] = rng.randrange(2) if self._garbled is None else self._garbled
