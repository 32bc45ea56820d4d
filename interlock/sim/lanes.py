"""Many runs of one controller and plant side by side: every variable is a vector with a bit for each run.

A run is a generator: it yields what it wants of the next step and looks at its own bit in between.  Machines that are
commanded away move by themselves.  All runs begin at the restart and take their steps together.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import field
from functools import reduce
from operator import or_

from interlock.dataclass import dataclass
from interlock.logic import names
from interlock.logic.bits import Bits
from interlock.logic.controller import Controller, Timer
from interlock.logic.expr import FALSE, Expr, Substitution, disj, neg, var
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
        self._choices = {c.base: c for c in plant.choices if c.form is names.Form.CHOICE}
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
        self.told = self._told()
        """What inputs tell of how the railway moves."""
        self._computed = Bits(self.told, *waits, roots | rules | hazards | self._wires, meaning=meaning)
        """What inputs tell, what timers wait for, then all that is next."""
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
        self._waiting: set[str] = set()
        self._clock = 0
        self.state[names.POWERED] = self.mask
        symbols, longest = self.controller.symbols, max(t.preset_ms for t in self.controller.timers)
        # runs begin when the restart delay is over; what is clear then, long has been
        for name in (symbols.start.restart_timer, *symbols.sections.release_timer.values()):
            self._running[name] = [(-longest, self.mask)]
        self._undisturbed = self._as_if_undisturbed()
        self._values: dict[str, int] = {}
        self._new = self.state | self._undisturbed
        """What is read anew: of what the last step has read all else stays as it was."""
        self._disturbed: set[str] = set()
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

    def _told(self) -> dict[Name, Expr]:
        """What inputs tell of how the railway moves: no movement reads an input."""
        moves = {n: e for n, e in self.plant.next.items() if n.family in _MOVES}
        sym = self.controller.symbols
        told = {name: neg(moves.get(names.STANDS(s), FALSE)) for s, name in sym.sections.clear.items()}
        told |= {name: moves[names.LIES(m, x)] for (m, x), name in sym.machines.detected.items()}
        for b, wire in sym.token.items():
            gives, there = moves[names.TELEGRAM(b, "gives")], [moves.get(n, FALSE) for n in self.plant.on_line(b)]
            told |= {wire.gives: gives, wire.has: moves[names.TELEGRAM(b, "has")]}
            told |= {wire.keeps: neg(gives), wire.clear: neg(disj(there))}
        return told

    def _as_if_undisturbed(self) -> dict[str, int]:
        """What is read of an undisturbed railway, at first."""
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
        told = (proof.stop, proof.clear, proof.caution, proof.second, proof.identifier, proof.speed)
        lamps = [n for of in told for n in of.values()]
        return values | dict.fromkeys((*sym.condition.values(), *sym.sections.healthy.values(), *lamps), m)

    def _step(self, wanted: list[tuple[Lane, Wish]]) -> None:
        m = self.mask
        for choice, command in self._moves.items():
            self._new[choice] = self._undisturbed[choice] = self.state[command]
        for lane, wish in wanted:
            lane.count += 1
            for e in wish.events:
                if e in self._choices:
                    self._disturb(self._choices[e], lane.bit, True)
        changed = self._compute(0)
        self._new = {n: x for n, x in changed.items() if n in self.told}
        self._undisturbed.update(self._new)
        for lane, wish in wanted:
            for given, value in wish.inputs.items():
                if given in self.sizes:
                    self._disturb(f"{given}={self._rest[given]}", lane.bit, False)
                    self._disturb(f"{given}={value}", lane.bit, True)
                else:
                    self._disturb(given, lane.bit, bool(value))
        for stage, group in enumerate(self._timers, 1):
            self._run_timers(group, self._compute(stage))
        changed = self._compute(len(self._timers) + 1)
        if self._record is not None:
            wires = {w: self._computed.found[w] for w in self._wires}
            self._record(self._values | wires, sum(lane.bit for lane, _ in wanted))
        for rule, broken in self._rules.items():
            if (kept := changed.get(rule, m)) != m:
                self.troubles[broken] = self.troubles.get(broken, 0) | (m ^ kept)
        for name in self._hazards:
            if there := changed.get(name, 0):
                self.troubles[name] = self.troubles.get(name, 0) | there
        self.last = self._values
        self._new = {n: x for n, x in changed.items() if n in self._kept and x is not self.state[n]}
        self.state.update(self._new)
        self._new.update([(n, self._undisturbed[n]) for n in self._disturbed])
        self._disturbed.clear()
        self._held = None
        self._clock += 1

    def _compute(self, stage: int) -> Mapping[str, int]:
        """Compute a stage with all that is read anew; what has changed in this step."""
        self._computed(self._new, self.mask, stage)
        self._values.update(self._new)
        self._new = {}
        return self._computed.changed

    def _disturb(self, name: str, bit: int, value: bool) -> None:
        """One run reads something else in this step than of an undisturbed railway."""
        vector = self._new[name] if name in self._new else self._values[name]
        self._new[name] = vector | bit if value else vector & ~bit
        self._disturbed.add(name)

    def _run_timers(self, group: Sequence[Timer], changed: Mapping[str, int]) -> None:
        """Those timers whose inputs have changed, or which run and are not over."""
        for t in group:
            if t.name not in changed and t.name not in self._waiting:
                continue
            on = self._computed.found[t.name]
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
            self._new[t.name] = over
            (self._waiting.discard if over == on else self._waiting.add)(t.name)
