"""Controller and plant run together, step by step, with chosen events and truthful inputs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from interlock.logic import names
from interlock.logic.bits import Bits
from interlock.logic.controller import Controller, Equation, Join, Timer
from interlock.logic.expr import EQ, VAR, Expr, Substitution, evaluate, walk
from interlock.logic.names import Name
from interlock.logic.on_delay import on_delay
from interlock.logic.plant import Plant
from interlock.model.elements import Position


def _computed(roots: Mapping[Name, Expr]) -> Callable[[Mapping[str, int]], dict[str, bool]]:
    """A function from values of variables to values of the named roots."""
    bits, compared = Bits(roots), [x for x in walk(roots.values()) if x.op is EQ]

    def values(given: Mapping[str, int]) -> dict[str, bool]:
        numbers = {f"{x.name}={x.value}": int(given[x.name] == x.value) for x in compared}
        return {n: bool(x) for n, x in bits({k: int(v) for k, v in given.items()} | numbers, 1).items()}

    return values


class Simulator:
    """One run.  `compile` once per system, then `reset` for each run."""

    def __init__(self, controller: Controller, plant: Plant, dt_ms: int = 1000) -> None:
        self.controller = controller
        self.plant = plant
        self.dt_ms = dt_ms
        flat = plant.flat
        self._events = _computed(flat.events)
        # the plant's next state, except the parts that depend on this scan's inputs (img.*)
        self._move = _computed({n: e for n, e in flat.next.items() if n.family is not names.IMAGE})
        self._timers = [
            (group, _computed({t.name: controller.expanded[t.input] for t in group}))
            for group in independent(controller)
        ]
        shows = Substitution(controller.next_state)
        self._next = _computed(controller.next_state | {x.name: shows(x.expr) for x in controller.outputs})
        self._rules = _computed({names.spelled(f"{i}"): x for i, (_, x) in enumerate(flat.assumptions)})
        self._hazards = _computed({names.spelled(h): x for h, x in flat.hazards})
        self._choices = dict.fromkeys(plant.choices, 0)
        self.reset({})

    def reset(self, plant_state: dict[str, int]) -> None:
        """Back to the restart, with the given plant state on top of an empty railway with all points normal."""
        self.state: dict[str, int] = {s.name: int(s.initial) for s in self.controller.state}
        self.state |= {x.name: int(x.restrictive) for x in self.controller.outputs}
        self.state |= dict.fromkeys(self.plant.next, 0)
        for name in self.plant.state:
            if name.family is names.IMAGE or (name.family is names.LIES and name.at[1] == Position.NORMAL):
                self.state[name] = 1
        self.state |= plant_state
        self.elapsed: dict[str, int | None] = {t.name: None for t in self.controller.timers}
        self.state[names.POWERED] = 1  # runs begin when the restart delay is over
        symbols = self.controller.symbols  # all that is clear then has been clear all the while
        for name in (symbols.start.restart_timer, *symbols.sections.release_timer.values()):
            self.elapsed[name] = max(t.preset_ms for t in self.controller.timers)
        self.count = 0
        self.last: dict[str, int] = {}
        self.hazards: list[str] = []
        self.broken: list[str] = []

    def is_on(self, name: str) -> bool:
        """The value of a state variable of controller or plant."""
        return bool(self.state[name])

    def step(self, events: Iterable[Name] = (), inputs: dict[str, int] | None = None) -> None:
        """One step: the wanted events (if possible), true inputs with `inputs` on top, one scan."""
        self.count += 1
        values = dict(self.state) | self._choices
        for e in events:
            values[names.choice(e)] = 1
        for i in self.controller.inputs:
            values[i.name] = i.restrictive
        for t in self.controller.timers:
            values[t.name] = 0
        moved = self._move(values)
        for s in self.controller.symbols.sections.clear:
            values[self.controller.symbols.sections.clear[s]] = int(not moved.get(names.STANDS(s), False))
        for (m, x), name in self.controller.symbols.machines.detected.items():
            values[name] = int(moved[names.LIES(m, x)])
        values[self.controller.symbols.valid] = 1
        for name in self.controller.symbols.sections.blocked.values():
            values[name] = 0
        sym = self.controller.symbols
        lamps = (
            *sym.lamp_proof.stop.values(),
            *sym.lamp_proof.clear.values(),
            *sym.lamp_proof.caution.values(),
        )
        lamps = (
            *lamps,
            *sym.lamp_proof.identifier.values(),
            *sym.lamp_proof.second.values(),
            *sym.lamp_proof.speed.values(),
        )
        for name in (*sym.condition.values(), *sym.sections.healthy.values(), *lamps):
            values[name] = 1
        for b, wire in sym.token.items():
            values |= {
                wire.gives: int(moved[names.TELEGRAM(b, "gives")]),
                wire.has: int(moved[names.TELEGRAM(b, "has")]),
            }
            values[wire.keeps] = int(not moved[names.TELEGRAM(b, "gives")])
            values[wire.clear] = int(not any(moved.get(n) for n in self.plant.on_line(b)))
        values |= inputs or {}
        self._run_timers(values)
        moved = self._move(values)  # again: what depends on timers that have run out
        new = self._next(values)
        rules = self._rules(values)
        self.broken += [self.plant.assumptions[int(i)].id for i, ok in rules.items() if not ok]
        self.hazards += [h for h, bad in self._hazards(values).items() if bad]
        self.last = values
        valid = bool(values[self.controller.symbols.valid])
        self.state = {**self.state, **{k: int(v) for k, v in moved.items()}, **{k: int(v) for k, v in new.items()}}
        for s, name in self.controller.symbols.sections.clear.items():
            healthy = s not in sym.sections.healthy or values[sym.sections.healthy[s]]
            self.state[names.IMAGE(s)] = int(not (valid and values[name] and healthy))

    def missing(self, equation: str) -> list[str]:
        """The terms of an equation that were false in the last scan, in words."""
        return missing(self.controller, equation, lambda n: self.last.get(n, 0))

    def possible(self) -> list[str]:
        """Events that could happen now."""
        values = dict(self.state) | dict.fromkeys(self.plant.choices, 1)
        values |= {t.name: self.last.get(t.name, 0) for t in self.controller.timers}
        values |= {i.name: self.last.get(i.name, i.restrictive) for i in self.controller.inputs}
        return [e for e, ok in self._events(values).items() if ok]

    def _run_timers(self, values: dict[str, int]) -> None:
        for group, inputs in self._timers:
            running = inputs(values)
            for t in group:
                before = self.elapsed[t.name]
                self.elapsed[t.name], over = on_delay(before, bool(running[t.name]), t.preset_ms, self.dt_ms)
                values[t.name] = int(over)


def missing(controller: Controller, equation: str, value: Callable[[str], int]) -> list[str]:
    """The terms of an equation that are false, in words; instead of one that is a wire of which every term must hold,
    those of its own terms, if they are told in words."""
    memo: dict[int, bool] = {}
    wires: dict[str, int] = {}
    leading = _leading_to(controller, equation)

    def meant(name: str) -> int:
        return wires[name] if name in wires else value(name)

    for e in leading.values():
        wires[e.name] = evaluate(e.expr, meant, memo)

    def those(e: Equation) -> Iterator[str]:
        for t in e.terms:
            if not evaluate(t.expr, meant, memo):
                under = leading.get(t.expr.name) if t.expr.op is VAR else None
                told = under is not None and under.join is Join.ALL and all(x.note for x in under.terms)
                yield from those(under) if under is not None and told else (t.note or t.kind,)

    return list(dict.fromkeys(those(leading[equation])))


def _leading_to(controller: Controller, equation: str) -> dict[str, Equation]:
    """The wires that an equation reads, those that these read, and itself: in order."""
    wires: dict[str, Equation] = {e.name: e for e in controller.equations}
    found: set[str] = set()
    todo = [equation]
    while todo:
        name = todo.pop()
        if name in wires and name not in found:
            found.add(name)
            todo += wires[name].reads
    return {name: e for name, e in wires.items() if name in found}


def independent(controller: Controller) -> list[list[Timer]]:
    """The timers in order, in groups of which no input reads a timer of the same group."""
    groups: list[list[Timer]] = []
    after: dict[str, int] = {}
    """The number of groups of which a step waits for a timer, and those before them."""
    for step in controller.steps:
        reads = step.reads if isinstance(step, Equation) else (step.input,)
        waits = max([after.get(n, 0) for n in reads], default=0)
        if isinstance(step, Timer):
            if waits == len(groups):
                groups.append([])
            groups[-1].append(step)
            waits = len(groups)
        after[step.name] = waits
    return groups
