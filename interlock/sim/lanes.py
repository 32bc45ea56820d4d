"""Many runs of one controller and plant side by side: every variable is a vector with a bit for each run.

A run is a generator: it yields what it wants of the next step and looks at its own bit in between.  Machines that are
commanded away move by themselves.  All runs begin at the restart and take their steps together.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import reduce
from operator import or_

from interlock.logic import names
from interlock.logic.bits import Bits
from interlock.logic.controller import Controller
from interlock.logic.expr import Substitution, var
from interlock.logic.names import Name
from interlock.logic.plant import Plant
from interlock.model.elements import Position
from interlock.sim.run import independent, missing


@dataclass(frozen=True)
class Wish:
    """What a run wants of a step: events, and inputs that differ from an undisturbed railway; numbers for ranges."""

    events: tuple[Name, ...] = ()
    inputs: Mapping[str, int] = field(default_factory=dict)


NOTHING = Wish()
Driver = Generator[Wish, None, str | None]
"""A run: yields wishes; returns None when it went well, or what went wrong."""
Record = Callable[[Mapping[str, int], int], None]
"""Told of each step: the vectors of inputs, old state, timers and wires, and that of the runs that are still going."""


class Lane:
    """One run's view of the railway."""

    def __init__(self, lanes: Lanes, number: int) -> None:
        self.lanes, self.number = lanes, number
        self.bit = 1 << number
        self.count = 0

    def is_on(self, name: str) -> bool:
        """A state variable."""
        return bool(self.lanes.state[name] & self.bit)

    def held(self) -> list[str]:
        """The sections that are locked, however."""
        return self.lanes.held.get(self.number, [])

    def troubles(self) -> list[str]:
        """Hazards and broken assumptions so far."""
        return [n for n, v in self.lanes.troubles.items() if v & self.bit]

    def missing(self, equation: str) -> list[str]:
        """The terms of an equation that were false in the last step, in words."""

        def value(name: str) -> int:
            size = self.lanes.sizes.get(name)
            if size is None:
                return int(bool(self.lanes.last.get(name, 0) & self.bit))
            return next((k for k in range(1, size) if self.lanes.last[f"{name}={k}"] & self.bit), 0)

        return missing(self.lanes.controller, equation, value)


_MOVES = (names.STANDS, names.LIES, names.TELEGRAM, names.ON_LINE)
"""What of the railway moves before its inputs are read."""


class Lanes:
    """The runs.  Compile once, then `run` batch after batch."""

    def __init__(self, controller: Controller, plant: Plant, dt_ms: int = 1000, record: Record | None = None) -> None:
        """`record`: is given what each step computes of the controller."""
        self.controller, self.plant, self.dt_ms, self._record = controller, plant, dt_ms, record
        meaning = {e.name: e.expr for e in controller.equations} | plant.events.definitions
        sym = controller.symbols
        self.sizes: dict[str, int] = {i.name: i.size for i in controller.inputs if i.size}
        self._rest: dict[str, int] = {i.name: i.restrictive for i in controller.inputs}
        self._moves = {
            names.choice(names.MACHINE_STARTS(m, x)): sym.machines.drive[m, x.other] for m, x in sym.machines.drive
        }
        self._arrivals = [c for c in plant.choices if c.family is names.MACHINE_ARRIVES]
        moves = {n: e for n, e in plant.next.items() if n.family in _MOVES}
        self._timers = [*independent(controller)]
        waits = [{t.name: var(t.input) for t in group} for group in self._timers]
        scan = {e.name: e.expr for e in controller.next}
        shows = Substitution(scan)
        roots = plant.next | scan | {x.name: shows(x.expr) for x in controller.outputs}
        rules = {names.spelled(f"{i} {a.id}"): a.expr for i, a in enumerate(plant.assumptions)}
        hazards = {names.spelled(f"{h.id} {h.place}"): h.expr for h in plant.hazards}
        self._kept, self._hazards = frozenset(roots), tuple(hazards)
        self._rules = dict(zip(rules, (a.id for a in plant.assumptions), strict=True))
        self._wires = {e.name: e.expr for e in controller.equations} if record is not None else {}
        self._computed = Bits(moves, *waits, roots | rules | hazards | self._wires, meaning=meaning)
        """How the railway moves, what timers wait for, then all that is next."""
        self.state: dict[str, int] = {}
        self.last: dict[str, int] = {}
        self.troubles: dict[str, int] = {}
        self._held: dict[int, list[str]] | None = None

    def run(
        self, starts: Sequence[Mapping[str, int]], drivers: Sequence[Callable[[Lane], Driver]], first: bool = False
    ) -> list[tuple[str | None, int]]:
        """Each driver's outcome and number of steps; what a start does not name is an empty railway, points normal.

        `first`: nothing is done any more after the first run that goes wrong.
        """
        self.mask = (1 << len(starts)) - 1
        self._computed.forget()
        self.state = {s.name: self.mask if s.initial else 0 for s in self.controller.state}
        self.state |= {x.name: self.mask if x.restrictive else 0 for x in self.controller.outputs}
        self.state |= dict.fromkeys(self.plant.next, 0)
        for name in self.plant.state:
            if name.family is names.IMAGE or (name.family is names.LIES and name.at[1] == Position.NORMAL):
                self.state[name] = self.mask
        for number, start in enumerate(starts):
            bit = 1 << number
            for given, value in start.items():
                self.state[given] = self.state[given] | bit if value else self.state[given] & ~bit
        self.troubles = {}
        self._held = None
        self._running: dict[str, list[tuple[int, int]]] = {t.name: [] for t in self.controller.timers}
        self._clock = 0
        self.state[names.POWERED] = self.mask
        symbols, longest = self.controller.symbols, max(t.preset_ms for t in self.controller.timers)
        # runs begin when the restart delay is over; what is clear then, long has been
        for name in (symbols.start.restart_timer, *symbols.sections.release_timer.values()):
            self._running[name] = [(-longest, self.mask)]
        self._undisturbed = self._as_if_undisturbed()
        lanes = [Lane(self, n) for n in range(len(starts))]
        runs: list[Driver] = [d(lane) for d, lane in zip(drivers, lanes, strict=True)]
        outcomes: list[tuple[str | None, int]] = [(None, 0)] * len(starts)
        wishes: dict[int, Wish] = {}
        active = dict.fromkeys(range(len(starts)))
        while active:
            for n in list(active):
                try:
                    wishes[n] = next(runs[n])
                except StopIteration as end:
                    outcomes[n] = (end.value, lanes[n].count)
                    wishes.pop(n, None)
                    del active[n]
                    if first and end.value is not None:
                        return outcomes
            if active:
                self._step([(lanes[n], wishes[n]) for n in active])
        return outcomes

    @property
    def held(self) -> dict[int, list[str]]:
        """The locked sections of each run that has any; looked for once in a step, for all runs."""
        if self._held is None:
            self._held = {}
            for section, locks in self.controller.symbols.sections.locked_by.items():
                runs = reduce(or_, (self.state[n] for n in locks))
                while runs:
                    lowest = runs & -runs
                    self._held.setdefault(lowest.bit_length() - 1, []).append(section)
                    runs ^= lowest
        return self._held

    def _as_if_undisturbed(self) -> dict[str, int]:
        """What is read of an undisturbed railway in every step, whatever has happened."""
        sym, m = self.controller.symbols, self.mask
        values: dict[str, int] = dict.fromkeys(self.plant.choices, 0)
        for i in self.controller.inputs:
            if i.size:
                values |= {f"{i.name}={k}": 0 for k in range(i.size)}
                values[f"{i.name}={i.restrictive}"] = m
            else:
                values[i.name] = m if i.restrictive else 0
        values |= dict.fromkeys((t.name for t in self.controller.timers), 0)
        values |= dict.fromkeys(self._arrivals, m)
        values[sym.valid] = m
        values |= dict.fromkeys(sym.sections.blocked.values(), 0)
        proof = sym.lamp_proof
        lamps = (*proof.stop.values(), *proof.clear.values(), *proof.caution.values(), *proof.identifier.values())
        return values | dict.fromkeys((*sym.condition.values(), *sym.sections.healthy.values(), *lamps), m)

    def _step(self, wanted: list[tuple[Lane, Wish]]) -> None:
        sym = self.controller.symbols
        m = self.mask
        values = self.state | self._undisturbed
        for choice, command in self._moves.items():
            values[choice] = self.state[command]
        for lane, wish in wanted:
            lane.count += 1
            for e in wish.events:
                if names.choice(e) in values:
                    values[names.choice(e)] |= lane.bit
        moved = self._computed(values, m)
        for s, name in sym.sections.clear.items():
            there = moved.get(names.STANDS(s), 0)
            values[name] = m ^ there if there else m
        for (machine, x), name in sym.machines.detected.items():
            values[name] = moved[names.LIES(machine, x)]
        for b, wire in sym.token.items():
            values |= {wire.gives: moved[names.TELEGRAM(b, "gives")], wire.has: moved[names.TELEGRAM(b, "has")]}
            values[wire.keeps] = m ^ moved[names.TELEGRAM(b, "gives")]
            values[wire.clear] = m ^ reduce(or_, (moved.get(n, 0) for n in self.plant.on_line(b)))
        for lane, wish in wanted:
            for given, value in wish.inputs.items():
                if given in self.sizes:
                    values[f"{given}={self._rest[given]}"] &= ~lane.bit
                    values[f"{given}={value}"] |= lane.bit
                else:
                    values[given] = values[given] | lane.bit if value else values[given] & ~lane.bit
        self._run_timers(values)
        after = self._computed(values, m, len(self._timers) + 1)
        if self._record is not None:
            self._record(values | {w: after[w] for w in self._wires}, sum(lane.bit for lane, _ in wanted))
        for rule, broken in self._rules.items():
            if after[rule] != m:
                self.troubles[broken] = self.troubles.get(broken, 0) | (m ^ after[rule])
        for name in self._hazards:
            if after[name]:
                self.troubles[name] = self.troubles.get(name, 0) | after[name]
        self.last = values
        self.state.update({n: x for n, x in self._computed.changed.items() if n in self._kept})
        self._held = None
        self._clock += 1

    def _run_timers(self, values: dict[str, int]) -> None:
        for stage, group in enumerate(self._timers, 1):
            running = self._computed(values, self.mask, stage)
            for t in group:
                on = running[t.name]
                need = -(-t.preset_ms // self.dt_ms)
                going = [(began, both) for began, lanes in self._running[t.name] if (both := lanes & on)]
                fresh = on
                over = 0
                for began, lanes in going:
                    fresh &= ~lanes
                    if self._clock - began >= need:
                        over |= lanes
                if fresh:
                    going.append((self._clock, fresh))
                    if need <= 0:
                        over |= fresh
                self._running[t.name] = going
                values[t.name] = over
