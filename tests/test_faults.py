"""Trains, requests and faults at random: what the proof excludes does not happen in simulation either."""

from __future__ import annotations

import random

import pytest

from interlock.logic.expr import evaluate
from interlock.proof.claims import Facts, claims
from interlock.proof.system.loop import ClosedLoop, closed_loop
from interlock.proof.system.transition import System
from interlock.sim.run import Simulator
from tests.layouts import built

LIKELY = {"refuse": 0.03, "turn": 0.03, "appear": 0.03}


def faulty_inputs(loop: ClosedLoop, rng: random.Random) -> dict[str, int]:
    """Operator inputs at random; now and then one false occupation, a lost detection, or lost inputs."""
    out: dict[str, int] = {}
    symbols = loop.controller.symbols
    for i in loop.controller.inputs:
        if i.note.startswith("operator:") and not i.size and not i.name.startswith("BLK_"):
            out[i.name] = int(rng.random() < (0.3 if i.name.startswith("REL") else 0.01))
    if rng.random() < 0.5:  # and 0 between: a number counts on a change
        out[symbols.requests.request] = 1 + rng.randrange(len(symbols.routes))
    if rng.random() < 0.05:
        out[rng.choice(sorted(symbols.sections.clear.values()))] = 0
    if rng.random() < 0.02:
        out[rng.choice(sorted(symbols.machines.detected.values()))] = 0
    if rng.random() < 0.03 and symbols.sections.healthy:
        out[rng.choice(sorted(symbols.sections.healthy.values()))] = 0
    if rng.random() < 0.003:
        out[symbols.valid] = 0
    return out


@pytest.mark.parametrize("name", ["fig2_3_split", "passing_loop", "junction", "mine11", "pit_bottom"])
def test_no_hazard_and_no_violated_claim(name: str) -> None:
    layout, _, controller = built(name)
    loop = closed_loop(layout, controller)
    state_claims = [
        c for c in claims(Facts(System(layout, controller))) if c.id in ("T-FLANK", "L-HELD", "S-HOSTILE", "S-OPPOSING")
    ]
    sim = Simulator(controller, loop.plant, dt_ms=500)
    entered = 0
    for seed in range(6):
        rng = random.Random(seed)
        sim.reset({})
        for _ in range(300):
            events = [e for e in sim.possible() if rng.random() < LIKELY.get(e.split(".")[0], 0.6)]
            sim.step(events, faulty_inputs(loop, rng))
            if sim.broken:
                break  # the run left what is assumed (a delay ran out before a waiting train): nothing is claimed
            entered += sum(e.startswith("head.") for e in events)
            assert not sim.hazards, (seed, sim.hazards)
            memo: dict[int, bool] = {}
            for c in state_claims:
                assert evaluate(c.expr, lambda n: sim.state.get(n, 0), memo), (seed, c.id, c.place)
    assert entered >= 8
