"""Reference interpreter, Python runtime and Structured Text give equal outputs on the same inputs."""

from __future__ import annotations

import random
import types
from dataclasses import replace

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.logic.eval import Machine
from interlock.logic.expr import conj, neg, var
from interlock.logic.on_delay import CYCLE_MAX_MS
from interlock.proof.claims import Facts, claims
from interlock.proof.induction.search import search
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.system.loop import closed_loop
from interlock.proof.system.transition import System
from interlock.sim.run import Simulator
from interlock.st.ast import Unit
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from interlock.st.meaning import Execution, Numbers
from tests.layouts import SHIPPED, built

READ: dict[int, tuple[Controller, types.ModuleType, Unit]] = {}
"""Controllers by their identity, with their runtime and their text as they are read back: written once."""


def texts(controller: Controller) -> tuple[types.ModuleType, Unit]:
    """The Python runtime of a controller as a module, and its Structured Text as it is read back."""
    if id(controller) not in READ:
        module, iec = types.ModuleType("runtime"), BY_NAME["iec"]
        exec(compile(runtime_py(controller, []), "runtime.py", "exec"), module.__dict__)
        READ[id(controller)] = controller, module, iec.read(write_st(controller, iec, []))
    return READ[id(controller)][1:]


class Three:
    """One controller in its three forms."""

    def __init__(self, controller: Controller) -> None:
        self.controller = controller
        self.reference = Machine(controller)
        runtime, unit = texts(controller)
        self.runtime = runtime.Controller()
        self.numbers = Numbers()
        self.text: Execution[int] = Execution(unit, self.numbers)

    def over(self, timers: dict[str, bool]) -> None:
        """Set timers to have run for their whole preset, or not yet to run."""
        presets = {t.name: t.preset_ms for t in self.controller.timers}
        for name, over in timers.items():
            value = presets[name] if over else None
            self.reference.elapsed[name] = self.runtime.elapsed[name] = value
            path = next((p for p in self.numbers.elapsed if p.endswith(f"TON_{name}")), None)
            if path is not None:
                self.numbers.elapsed[path] = value
            else:
                assert value is None

    def past_restart(self) -> None:
        """The restart delay is over, what is clear has been clear all the while, and nothing was blocked."""
        symbols = self.controller.symbols
        for _ in range(2):
            self.scan(dict.fromkeys(symbols.sections.blocked.values(), 0), 100)
        self.over(dict.fromkeys([symbols.start.restart_timer, *symbols.sections.release_timer.values()], True))

    def scan(self, inputs: dict[str, int], dt_ms: int) -> dict[str, bool]:
        """One scan of each; they must agree."""
        full = {i.name: inputs.get(i.name, i.restrictive) for i in self.controller.inputs}
        if dt_ms > CYCLE_MAX_MS:  # the mapping program says so to the text
            full["VALID"] = 0
        a = self.reference.scan(inputs, dt_ms)
        b = self.runtime.scan(inputs, dt_ms)
        self.numbers.dt_ms = dt_ms
        c = {k: bool(v) for k, v in self.text.scan(full).items() if k in a}  # its words: tests/test_words.py
        assert a == b == c
        assert {k: bool(v) for k, v in self.runtime.state.items()} == {
            k: bool(v) for k, v in self.reference.state.items()
        }
        return a


def random_inputs(controller: Controller, rng: random.Random) -> dict[str, int]:
    """Inputs that are neither always true nor always false, so that much happens."""
    bias = {"CLR": 0.9, "VAL": 0.97, "DN_": 0.7, "DR_": 0.3, "BLK": 0.02, "CAN": 0.05, "REL": 0.4}
    out: dict[str, int] = {}
    for i in controller.inputs:
        out[i.name] = rng.randrange(i.size) if i.size else int(rng.random() < bias.get(i.name[:3], 0.5))
    return out


@pytest.mark.parametrize("name", SHIPPED)
@settings(max_examples=3, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True, database=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_random_traces(name: str, seed: int) -> None:
    _, _, controller = built(name)
    three, rng = Three(controller), random.Random(seed)
    for _ in range(25):
        three.scan(random_inputs(controller, rng), rng.choice([20, 100, 1000, 70_000]))


@pytest.mark.parametrize("name", ["mine11", "terminus", "junction"])
def test_traces_with_trains(name: str) -> None:
    """Random train movements and requests; the image that the trains make is fed to all three."""
    layout, _, controller = built(name)
    sim = Simulator(controller, closed_loop(layout, controller).plant)
    rng = random.Random(11)
    shown = 0
    for _ in range(3):
        three = Three(controller)
        three.past_restart()
        sim.reset({})
        for step in range(90):
            events = [e for e in sim.possible() if rng.random() < 0.6 and not e.startswith("refuse")]
            inputs = {"RELALL": int(step < 3), "REQ": rng.randrange(len(controller.symbols.routes) + 1)}
            sim.step(events, inputs)
            seen = {i.name: sim.last[i.name] for i in controller.inputs}
            outputs = three.scan(seen, sim.dt_ms)
            shown += sum(v for k, v in outputs.items() if k.startswith(("YP_", "YY_")))
            assert all(three.reference.state[s.name] == sim.state[s.name] for s in controller.state)
        assert not sim.hazards
    assert shown > 20


def test_a_missing_or_impossible_input_takes_its_restrictive_value() -> None:
    _, _, controller = built("fig2_2")
    three = Three(controller)
    three.past_restart()
    clear = {"VALID": 1, "CLR_DP": 1, "CLR_SA": 1, "CLR_SB": 1, "CLR_SC": 1, "BLK_DP": 0, "DN_P1": 1}
    three.scan({**clear, "REL_DP": 1}, 100)
    three.scan({**clear, "REQ": 1}, 100)
    for _ in range(3):
        out = three.scan(clear, 100)
    assert out["YP_X1"] and not out["YS_X1"]
    missing = {k: v for k, v in clear.items() if k != "CLR_DP"}
    out = Three.scan(three, missing, 100)
    assert not out["YP_X1"] and out["YS_X1"]
    three.scan({**clear, "REQ": 99}, 100)  # no such route: nothing is granted
    assert not any(three.reference.state[r.active] for r in controller.symbols.routes if r.number != 1)


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("refuted/wrong_waiver", ""),
        ("fig2_2", "point-missing"),
        ("fig2_2", "point-wrong"),
        ("fig2_2", "two-grants"),
    ],
)
def test_counterexamples_replay_on_interpreter_runtime_and_text(name: str, kind: str) -> None:
    """What the search found is what all three forms of that controller do, scan by scan."""
    layout, table, controller = built(name)
    if kind:
        _, controller = next(next(k for k in KINDS if k.name == kind).make(layout, table))
    system = System(layout, controller)
    three = Three(controller)
    three.past_restart()
    here = conj(var(n) if v else neg(var(n)) for n, v in three.reference.state.items())
    system.initial = replace(system.initial, parts=(*system.initial.parts, here))
    run = search(system, [c for c in claims(Facts(system)) if c.id.startswith("T-")], 14, 60)
    assert run is not None and len(run.frames) > 3
    for frame, following in zip(run.frames, run.frames[1:], strict=False):
        three.over({t.name: bool(frame.inputs[t.name]) for t in controller.timers})
        three.scan({i.name: frame.inputs[i.name] for i in controller.inputs}, 0)
        assert all(three.reference.state[s.name] == following.state[s.name] for s in controller.state)
