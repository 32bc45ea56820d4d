"""A random hostile hour: trains, failures, an operator who asks at random; each refusal is looked into.

The condition that a refused route names is false in that scan.  It is made true, in what the controller remembers, in
its timers and inputs, and the scan is run again; so until the route is granted: what is named after it is another.
"""

from __future__ import annotations

import types
from collections import Counter
from dataclasses import dataclass, field
from random import Random
from typing import Any

from interlock.emit.python.runtime import runtime_py
from interlock.logic import names
from interlock.logic.controller import Controller, Equation, Timer
from interlock.logic.expr import AND, EQ, NOT, VAR, Expr, Substitution, evaluate, var
from interlock.logic.words import FREE, REFUSED, UNKNOWN
from interlock.proof.system.loop import closed_loop
from interlock.sim.run import Simulator
from tests.layouts import built

HOUR = 3600


def module_of(controller: Controller) -> Any:
    module = types.ModuleType("runtime")
    exec(compile(runtime_py(controller, []), "runtime.py", "exec"), module.__dict__)
    return module


@dataclass
class Moment:
    """What a scan starts from, and what it reads."""

    controller: Controller
    state: dict[str, bool]
    elapsed: dict[str, int | None]
    inputs: dict[str, int]
    steps: dict[str, Any] = field(init=False)

    def __post_init__(self) -> None:
        self.steps = {s.name: s for s in self.controller.steps}

    def scanned(self, module: Any) -> Any:
        """A runtime after the scan."""
        one = module.Controller()
        one.state, one.elapsed = dict(self.state), dict(self.elapsed)
        one.scan(self.inputs, 1000)
        return one

    def make(self, x: Expr, wanted: bool) -> None:
        """Change state, timers and inputs so that an expression is as wanted: of several ways the first."""
        if x.op is NOT:
            self.make(x.args[0], not wanted)
        elif x.op is VAR:
            self._make(x.name, wanted)
        elif (x.op is AND) is wanted:
            for a in x.args:
                self.make(a, wanted)
        elif x.args:
            self.make(x.args[0], wanted)
        else:
            assert x.op is not EQ, "a condition asks for a number"

    def _make(self, name: str, wanted: bool) -> None:
        step = self.steps.get(name)
        if isinstance(step, Equation):
            self.make(step.expr, wanted)
        elif isinstance(step, Timer):
            self.make(self.steps[step.input].expr, wanted)
            self.elapsed[name] = step.preset_ms if wanted else None
        elif name in self.state:
            self.state[name] = wanted
        else:
            assert name in self.inputs
            self.inputs[name] = int(wanted)


@dataclass
class Hour:
    """What happened in an hour."""

    granted: int = 0
    refused: Counter[str] = field(default_factory=Counter)
    at_once: int = 0
    """Refusals after which it was enough to make the named condition true."""
    standing: Counter[str] = field(default_factory=Counter)
    """Requests for routes that are set already, by what their word says."""


def hostile_hour(name: str, seed: int, seconds: int = HOUR) -> Hour:
    """Trains, failures and an operator who asks at random; each request is answered and each refusal looked into."""
    layout, _, controller = built(name)
    sim, chance = Simulator(controller, closed_loop(layout, controller).plant), Random(seed)
    module = module_of(controller)
    sym, found = controller.symbols, Hour()
    blocked: set[str] = set()
    numbers = {r.number: r for r in sym.routes}
    for second in range(seconds):
        asked = chance.choice(list(numbers)) if second % 2 and chance.random() < 0.7 else 0
        given = {sym.requests.request: asked, sym.sections.release_all: int(chance.random() < 0.3)}
        given |= {n: int(chance.random() < 0.2) for n in sym.sections.release.values()}
        given |= {n: int(chance.random() < 0.05) for n in sym.cancellation.cancel.values()}
        for n in sym.sections.blocked.values():
            if chance.random() < 0.01:
                blocked ^= {n}
        given |= dict.fromkeys(blocked, 1)
        given |= {n: 0 for n in (*sym.condition.values(), *sym.lamp_proof.stop.values()) if chance.random() < 0.02}
        given |= {n: 0 for n in sym.sections.clear.values() if chance.random() < 0.01}
        given |= {sym.valid: 0} if chance.random() < 0.01 else {}
        possible = sim.possible()
        events = chance.sample(possible, min(len(possible), chance.randrange(3)))
        before = {s.name: bool(sim.state[s.name]) for s in controller.state}, dict(sim.elapsed)
        sim.step(events, given)
        fresh = before[0][sym.requests.fresh[sym.requests.request]]
        if not asked or not fresh or not sim.last[sym.valid]:
            continue
        inputs = {i.name: int(sim.last[i.name]) for i in controller.inputs}
        moment = Moment(controller, before[0], before[1], inputs)
        _answered(moment, module, numbers[asked], found)
    return found


def _answered(moment: Moment, module: Any, route: Any, found: Hour) -> None:
    """A request is granted, or its refusal is explained."""
    one = moment.scanned(module)
    code, text = one.status(route.id)
    if moment.state[route.active]:
        assert code not in (UNKNOWN, FREE)
        found.standing[text] += 1
        return
    if _holds(moment, one, var(names.GRANTED(route.number))):
        assert one.state[route.active]
        assert code < REFUSED and one.why_not(route.id) is None, text
        found.granted += 1
        return
    assert code > REFUSED and one.why_not(route.id)[:2] == (code, text), (route.id, text)
    found.refused[text] += 1
    named: list[int] = []
    while not _holds(moment, one, var(names.GRANTED(route.number))):
        code = one.status(route.id)[0]
        assert code > REFUSED and code not in named, (route.id, named, code)
        named.append(code)
        condition = moment.controller.words.reasons[code].condition
        assert condition is not None and not _holds(moment, one, condition), module.SAID[code]
        moment.make(condition, True)
        one = moment.scanned(module)
    found.at_once += len(named) == 1


def _holds(moment: Moment, one: Any, x: Expr) -> bool:
    """Whether a condition holds in the scan, by the controller's own equations alone."""
    values = {**moment.state, **moment.inputs}
    values |= {n: t is not None and t >= one_preset for n, t, one_preset in _timers(moment, one)}
    whole = Substitution(moment.controller.expanded)(x)
    return evaluate(whole, values.__getitem__, {})


def _timers(moment: Moment, one: Any) -> list[tuple[str, int | None, int]]:
    return [(t.name, one.elapsed[t.name], t.preset_ms) for t in moment.controller.timers]
