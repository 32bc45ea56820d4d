"""The generated runtime as a soft PLC: poll the substations, scan, write; a substation that is lost stops everything.

A cycle: (1) read each substation; (2) the inputs are valid only if all of them answered and their heartbeats change;
(3) one scan of the runtime; (4) write each substation, with a heartbeat of ours, so that it can let go of its outputs
when we are gone.  A run that ends, however it ends, writes every output restrictive before it lets go.  What could not
be read or written counts as lost, and lost inputs are not valid (R16).
"""

from __future__ import annotations

import types
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Protocol

from interlock.logic.cabinet import Allocation
from interlock.logic.on_delay import on_delay
from interlock.st.program import HEARTBEAT_MS

Scan = Callable[[dict[str, int], int], dict[str, bool]]


@dataclass(frozen=True)
class Memory:
    """What a controller remembers after a scan: its state, and the milliseconds that each timer has run (None: its
    input is false)."""

    state: Mapping[str, bool]
    elapsed: Mapping[str, int | None]


@dataclass(frozen=True)
class Runtime:
    """A generated runtime: its scan, the restrictive value of every output, what it remembers, and what its last scan
    says of every route by its number."""

    scan: Scan
    restrictive: Mapping[str, bool]
    remembers: Callable[[], Memory]
    words: Callable[[], Mapping[int, int]]


class LinkLost(Exception):
    """A substation did not answer, or not as it should."""


class Link(Protocol):
    """The way to one substation."""

    def read(self) -> Mapping[str, int]:
        """Its inputs by variable.  Raises `LinkLost`."""
        ...

    def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
        """Its outputs by variable.  Raises `LinkLost`."""
        ...

    def close(self) -> None:
        """Let go of it."""
        ...


def runtime_scan(text: str) -> Runtime:
    """A generated runtime, from its text."""
    module = types.ModuleType("runtime")
    exec(compile(text, "runtime.py", "exec"), module.__dict__)
    controller = module.Controller()
    return Runtime(
        controller.scan,
        dict(module.OUTPUTS),
        lambda: Memory(controller.state, dict(controller.elapsed)),
        controller.words,
    )


@dataclass
class Watch:
    """Alive while the heartbeat changes in time; as the block WATCH of the mapping program, scan by scan."""

    alive: bool = False
    _last: int = 0
    _runs: bool = False
    _still_ms: int | None = None

    def step(self, heartbeat: int, dt_ms: int) -> bool:
        """One scan."""
        same = heartbeat == self._last
        self._still_ms, over = on_delay(self._still_ms, same, HEARTBEAT_MS, dt_ms)
        self.alive = self._runs and not over and (self.alive or not same)
        self._last, self._runs = heartbeat, True
        return self.alive


@dataclass(frozen=True)
class Cycle:
    """What a cycle did: inputs as sampled, outputs, whether the inputs were valid, what was lost in words, and what the
    controller remembers.  `words`: what its scan says of every route, to be asked for before the next cycle."""

    inputs: Mapping[str, int]
    outputs: Mapping[str, bool]
    valid: bool
    lost: tuple[str, ...]
    memory: Memory = field(default=Memory({}, {}))
    words: Callable[[], Mapping[int, int]] = field(default=dict, compare=False)


@dataclass
class SoftPlc:
    """The runtime between its substations; `links` by substation, in the order in which they are polled."""

    runtime: Runtime
    allocation: Allocation
    links: Mapping[str, Link]
    valid_name: str = "VALID"
    watches: dict[str, Watch] = field(init=False)
    heartbeat: bool = field(default=False, init=False)
    scan: Scan = field(init=False)

    def __post_init__(self) -> None:
        self.scan = self.runtime.scan
        stations = [c.substation for c in self.allocation.heartbeats]
        if sorted(stations) != sorted(self.links):
            raise ValueError(f"links for {sorted(self.links)}, substations {sorted(stations)}")
        self.watches = {s: Watch() for s in stations}

    def cycle(self, operator: Mapping[str, int], dt_ms: int) -> Cycle:
        """One cycle, `dt_ms` milliseconds after the last; `operator`: what the operator's place writes."""
        inputs = {n: operator[n] for n in self.allocation.written if n in operator}
        lost: list[str] = []
        alive = []
        beats = {c.variable for c in self.allocation.heartbeats}
        for c in self.allocation.heartbeats:
            watch = self.watches[c.substation]
            try:
                values = self.links[c.substation].read()
                inputs |= {n: v for n, v in values.items() if n not in beats}
                alive.append(watch.step(values[c.variable], dt_ms))
            except LinkLost as error:
                self.watches[c.substation] = Watch()  # it has to show a change of its heartbeat again
                alive.append(False)
                lost.append(f"{c.substation}: {error}")
        valid = all(alive)
        inputs[self.valid_name] = int(valid)
        outputs = self.scan(inputs, dt_ms)
        self.heartbeat = not self.heartbeat
        for station, why in self._write(outputs).items():
            self.watches[station] = Watch()
            if not any(x.startswith(f"{station}:") for x in lost):
                lost.append(f"{station}: {why}")
        return Cycle(inputs, outputs, valid, tuple(lost), self.runtime.remembers(), self.runtime.words)

    def _write(self, outputs: Mapping[str, bool]) -> dict[str, str]:
        """Write every substation its outputs; those that cannot be written, and why."""
        lost: dict[str, str] = {}
        for station, link in self.links.items():
            wired = [x.variable for x in self.allocation.channels if x.direction == "Q" and x.substation == station]
            try:
                link.write({n: outputs[n] for n in wired}, self.heartbeat)
            except LinkLost as error:
                lost[station] = str(error)
        return lost

    def close(self) -> dict[str, str]:
        """Write every output restrictive, with a heartbeat that changes no more, and let go of all substations.

        Returns the substations that could not be written, and why: those have to let go by themselves.
        """
        try:
            return self._write(self.runtime.restrictive)
        finally:
            for link in self.links.values():
                link.close()
