"""The generated runtime as a soft PLC: poll the substations, scan, write; a substation that is lost stops everything.

A cycle: (1) read each substation; (2) the inputs are valid only if all of them answered, are seen to be well by their
heartbeats and diagnosis bits, and the cycle was not too long; (3) one scan of the runtime; (4) write each substation,
then, if it has taken all of its outputs, a heartbeat of ours, so that it can let go of them when we are gone or when
some do not arrive.  A run that ends, however it ends, writes every output restrictive before it lets go.  What could
not be read, or not be written in the cycle before, counts as lost, and lost inputs are not valid (R16).
"""

from __future__ import annotations

import types
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import field
from functools import partial
from typing import Protocol

from interlock.dataclass import dataclass
from interlock.field.polling import InTurn, LinkLost, Poll
from interlock.logic.cabinet import Allocation
from interlock.logic.on_delay import CYCLE_MAX_MS, on_delay
from interlock.model.elements import HEARTBEAT_MS, Health

__all__ = ["Cycle", "Link", "LinkLost", "Memory", "Runtime", "SoftPlc", "Watch", "runtime_scan"]

LATE_CYCLE = "the controller's cycle"
"""What is lost where a cycle came too late.  No substation can have that name (`'` is in none)."""

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

    within_ms: int = HEARTBEAT_MS
    alive: bool = False
    _last: int = 0
    _runs: bool = False
    _still_ms: int | None = None

    def step(self, heartbeat: int, dt_ms: int) -> bool:
        """One scan."""
        same = heartbeat == self._last
        self._still_ms, over = on_delay(self._still_ms, same, self.within_ms, dt_ms)
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
    """The runtime between its substations; `links` by substation, asked as `poll` says."""

    runtime: Runtime
    allocation: Allocation
    links: Mapping[str, Link]
    valid_name: str = "VALID"
    poll: Poll = field(default_factory=InTurn)
    watches: dict[str, Watch] = field(init=False)
    heartbeat: bool = field(default=False, init=False)
    scan: Scan = field(init=False)

    def __post_init__(self) -> None:
        self.scan = self.runtime.scan
        stations = self.allocation.stations
        if sorted(stations) != sorted(self.links):
            raise ValueError(f"links for {sorted(self.links)}, substations {sorted(stations)}")
        self._signs = {c.variable for c in (*self.allocation.heartbeats, *self.allocation.diagnoses)}
        self._beats = {c.substation: c.variable for c in self.allocation.heartbeats}
        self._bits = {c.substation: c.variable for c in self.allocation.diagnoses}
        self.watches = {}
        self._unwritten: dict[str, str] = {}
        for h in self.allocation.health:
            self._forget(h)

    def _forget(self, h: Health) -> None:
        """A substation that was lost has to show a change of its heartbeat again."""
        self.watches[h.substation] = Watch(h.within_ms)

    def cycle(self, operator: Mapping[str, int], dt_ms: int) -> Cycle:
        """One cycle, `dt_ms` milliseconds after the last; `operator`: what the operator's place writes."""
        inputs = {n: operator[n] for n in self.allocation.written if n in operator}
        lost: dict[str, str] = {}
        answers = self.poll.ask({s: link.read for s, link in self.links.items()})
        for h in self.allocation.health:
            answer = answers[h.substation]
            if isinstance(answer, LinkLost):
                self._forget(h)
                lost[h.substation] = str(answer)
                continue
            inputs |= {n: v for n, v in answer.items() if n not in self._signs}
            ill = self._ill(h, answer, dt_ms)
            if why := self._unwritten.get(h.substation, ill):
                lost[h.substation] = why
        if dt_ms > CYCLE_MAX_MS:
            lost[LATE_CYCLE] = f"{dt_ms} ms since the last one, more than {CYCLE_MAX_MS}"
        valid = not lost
        inputs[self.valid_name] = int(valid)
        outputs = self.scan(inputs, dt_ms)
        self.heartbeat = not self.heartbeat
        self._unwritten = self._write(outputs)
        for h in self.allocation.health:
            if h.substation in self._unwritten:
                self._forget(h)
        told = tuple(f"{name}: {why}" for name, why in {**self._unwritten, **lost}.items())
        return Cycle(inputs, outputs, valid, told, self.runtime.remembers(), self.runtime.words)

    def _ill(self, h: Health, values: Mapping[str, int], dt_ms: int) -> str:
        """Why a substation that has answered is not well; empty when it is."""
        beats = not h.beats or self.watches[h.substation].step(values[self._beats[h.substation]], dt_ms)
        if h.diagnosed and not values[self._bits[h.substation]]:
            return "its diagnosis bit says that it is not well"
        return "" if beats else "its heartbeat does not change"

    def _write(self, outputs: Mapping[str, bool], last: bool = False) -> dict[str, str]:
        """Write every substation its outputs; those that cannot be written, and why."""
        calls = {}
        for station, link in self.links.items():
            wired = [x.variable for x in self.allocation.channels if x.direction == "Q" and x.substation == station]
            calls[station] = partial(link.write, {n: outputs[n] for n in wired}, self.heartbeat)
        answers = self.poll.ask(calls, last)
        return {station: str(answer) for station, answer in answers.items() if isinstance(answer, LinkLost)}

    def close(self) -> dict[str, str]:
        """Write every output restrictive, with the heartbeat of the last cycle, and let go of all substations.

        Returns the substations that could not be written, and why: those have to let go by themselves.
        """
        try:
            return self._write(self.runtime.restrictive, last=True)
        finally:
            self.poll.close()
            for link in self.links.values():
                with suppress(Exception):  # the others are let go of all the same
                    link.close()
