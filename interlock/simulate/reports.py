"""What the controller reads of a world: detectors, contacts, lamps, conditions; what is late, false or lost of it."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import TYPE_CHECKING

from interlock.model.portable import portable

if TYPE_CHECKING:
    from interlock.simulate.world import World


class Reports:
    """The inputs of a controller; given: restrictive value and size by name."""

    def __init__(self, world: World, given: Mapping[str, tuple[int, int]]) -> None:
        self._world = world
        sections = world.track.sections
        self.inputs: dict[str, int] = {name: restrictive for name, (restrictive, _) in given.items()}
        for name in self.inputs:
            if name.startswith(("RL_", "GL_", "CL_", "NL_", "UL_", "VL_", "E_", "SH_", "VALID")):
                self.inputs[name] = 1
        self.conditions = [n for n in self.inputs if n.startswith("E_")]
        self.lamps = [n for n in self.inputs if n.startswith(("RL_", "GL_", "CL_", "NL_", "UL_", "VL_"))]
        self.clear = [f"CLR_{portable(s)}" for s in sections]
        self.wired = [n in self.inputs for n in self.clear]
        self._all_wired = [n for n in self.clear if n in self.inputs]
        self._healthy = [f"SH_{portable(s)}" for s in sections]
        self._sensors = [i for i, n in enumerate(self._healthy) if n in self.inputs]
        self._sick: dict[int, tuple[float, int | None]] = {}
        """Detectors that are not healthy: for how long, and what they report, or None for anything."""
        self.count = [0] * len(sections)
        """Vehicles in each section."""
        self._was = [0] * len(sections)
        self.false: dict[int, float] = {}
        """Sections that report occupied whatever is there, and for how long."""
        self._shunt_lost: dict[int, float] = {}
        self.out: dict[str, float] = {}
        """Lamps and conditions that are out, and for how long."""
        self._invalid = 0.0
        self._garbled: int | None = None
        """What is read of sections while inputs are lost, or None for anything."""
        self.past: deque[tuple[Mapping[str, int], list[int]]] = deque(maxlen=2)
        """Inputs as the last two scans read them, and how many vehicles were in each section then."""

    def step(self, dt: float) -> None:
        """`dt` seconds have passed: things fail, or are well again, and the inputs are sampled."""
        self._fails(dt)
        self._detect(dt)

    def read(self) -> None:
        """A scan has read the inputs as they are."""
        self.past.append((dict(self.inputs), self.count))

    def _fails(self, dt: float) -> None:
        rng, f, contacts = self._world.rng, self._world.faults, self._world.machines.contacts
        if rng.random() < f.false * dt * len(self.clear):
            s = rng.randrange(len(self.clear))
            if not self._beside_false(s):
                self.false[s] = rng.choice((0.0, 1.0, 5.0, 30.0))
        if rng.random() < f.contact * dt * len(contacts.names) and contacts.names:
            m = rng.randrange(len(contacts.names))
            contacts.lost[m] = (rng.choice((0.0, 1.0, 20.0)), int(rng.random() < f.contradict))
        for m, (left, both) in tuple(contacts.lost.items()):
            if left < 0:
                del contacts.lost[m]
            else:
                contacts.lost[m] = (left - dt, both)
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
        return any(n in self.false for n in self._world.track.neighbours[s])

    def _detect(self, dt: float) -> None:
        """Sections as reported: late by a scan where a train has just come in or left, false where a fault says so."""
        count = [0] * len(self.count)
        for t in self._world.trains:
            for s in t.under.sections:
                count[s] += 1
        rng, late = self._world.rng, self._world.faults.late
        held: list[int] = []
        for s, n in enumerate(count):
            clear = not n
            if clear != (not self._was[s]) and rng.random() < late:
                if not clear:
                    clear = True  # just entered
                elif not self._beside_false(s) and not any(x in held for x in self._world.track.neighbours[s]):
                    clear = False  # just left
                    held.append(s)
            elif n and s in self._shunt_lost:
                clear = True
            if self.wired[s]:
                self.inputs[self.clear[s]] = int(clear)
        for s, left in tuple(self.false.items()):
            if self.wired[s] and not any(x in held for x in self._world.track.neighbours[s]):
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
        machines = self._world.machines
        machines.contacts.report(self.inputs, machines.position, machines.damaged)
        if self._invalid >= 0:
            for name in self._all_wired:
                self.inputs[name] = rng.randrange(2) if self._garbled is None else self._garbled
