"""The circuit of a system: it runs as the system does, and ABC comes to the same verdicts where it is installed."""

from __future__ import annotations

import random
import shutil
import subprocess
from pathlib import Path

import pytest

from interlock.logic.expr import NOT, conj, evaluate, neg
from interlock.proof.certificate.aiger import aiger
from interlock.proof.claims import Facts, claims
from interlock.proof.mutation.weakenings import KINDS
from interlock.proof.system.transition import System
from tests.layouts import built


class Read:
    """A binary AIGER file, run step by step."""

    def __init__(self, data: bytes) -> None:
        head, rest = data.split(b"\n", 1)
        _, top, inputs, latches, outputs, gates = head.split()
        self.top, self.inputs, self.latches = int(top), int(inputs), int(latches)
        assert outputs == b"1" and self.top == self.inputs + self.latches + int(gates)
        *lines, rest = rest.split(b"\n", self.latches + 1)
        self.next, self.bad = [int(x) for x in lines[: self.latches]], int(lines[-1])
        self.gates, at = [], 0
        for n in range(int(gates)):
            lhs = 2 * (self.inputs + self.latches + n + 1)
            deltas = []
            for _ in range(2):
                value = shift = 0
                while True:
                    byte = rest[at]
                    at += 1
                    value |= (byte & 127) << shift
                    shift += 7
                    if byte < 128:
                        break
                deltas.append(value)
            self.gates.append((lhs - deltas[0], lhs - deltas[0] - deltas[1]))
        names = rest[at:].decode().split("\nc\n")[0].splitlines()
        self.names = {x.split(" ", 1)[0]: x.split(" ", 1)[1] for x in names}
        self.state = [0] * self.latches

    def step(self, values: dict[str, int]) -> bool:
        """One step with inputs by name; returns whether bad was on."""
        v = [0] * (self.top + 1)
        for i in range(self.inputs):
            v[i + 1] = values[self.names[f"i{i}"]]
        v[self.inputs + 1 : self.inputs + self.latches + 1] = self.state

        def of(lit: int) -> int:
            return v[lit >> 1] ^ (lit & 1)

        for n, (a, b) in enumerate(self.gates, self.inputs + self.latches + 1):
            v[n] = of(a) & of(b)
        self.state = [of(x) for x in self.next]
        return bool(of(self.bad))


def test_the_circuit_runs_as_the_system_does() -> None:
    layout, _, controller = built("fig2_2")
    system = System(layout, controller)
    wanted = claims(Facts(system))
    read, relation = Read(aiger(system, wanted)), system.relation
    rng = random.Random(3)
    state = {v.name: int(v.initial) for v in controller.state}
    free = {x.split(" ", 1)[1] for x in read.names.values() if x.startswith("first ")}
    start = {n: rng.randrange(2) for n in relation.state if n in free}
    state |= {o.name: int(o.restrictive) for o in controller.outputs}
    state |= {n: 1 for n in relation.state if n not in state} | start  # what is fixed besides: history that is true
    state |= {n: 0 for x in system.initial.parts if x.op is NOT and (n := x.args[0].name) in state and n not in start}
    fair = True
    for k in range(60):
        inputs = {n: rng.randrange(relation.sizes.get(n, 2)) for n in relation.inputs}
        env = state | inputs
        for name, x in relation.definitions.items():
            env[name] = int(evaluate(x, env.__getitem__, {}))
        fair = fair and all(evaluate(a.expr, env.__getitem__, {}) for a in relation.assumptions)
        fair = fair and (k > 0 or evaluate(system.initial.whole, env.__getitem__, {}))
        bad = fair and evaluate(neg(conj(c.expr for c in wanted)), env.__getitem__, {})
        given = {f"first {n}": v for n, v in start.items()}
        for n, value in inputs.items():
            given |= {f"{n}[{i}]": value >> i & 1 for i in range(8)} if n in relation.sizes else {n: value}
        assert read.step(given) == bad
        state = {n: env[n.next] for n in relation.state}
        latches = dict(zip((read.names[f"l{i}"] for i in range(read.latches)), read.state, strict=True))
        assert {n: latches[n] for n in state} == state


ABC = shutil.which("berkeley-abc") or shutil.which("abc")


def verdict(data: bytes, folder: Path) -> str:
    """What ABC's property-directed reachability says."""
    path = folder / "system.aig"
    path.write_bytes(data)
    done = subprocess.run(
        [str(ABC), "-q", f"read_aiger {path}; pdr -T 60"], capture_output=True, text=True, timeout=120, check=False
    )
    return "proved" if "Property proved" in done.stdout else "refuted" if "was asserted" in done.stdout else "open"


@pytest.mark.parametrize("name", ["fig2_2", "fig2_3_whole", "fig2_3_split"])
@pytest.mark.external
def test_another_engine_proves_the_small_layouts(name: str, tmp_path: Path) -> None:
    layout, _, controller = built(name)
    system = System(layout, controller)
    assert verdict(aiger(system, claims(Facts(system))), tmp_path) == "proved"


@pytest.mark.parametrize("kind", ["point-missing", "release-occupied", "hostile-not-excluded"])
@pytest.mark.external
def test_another_engine_refutes_mutants(kind: str, tmp_path: Path) -> None:
    layout, table, _ = built("fig2_2")
    _, controller = next(next(k for k in KINDS if k.name == kind).make(layout, table))
    system = System(layout, controller)
    assert verdict(aiger(system, claims(Facts(system))), tmp_path) == "refuted"
