"""A run: the emitted runtime, a world in metres, an operator, faults; told are movements and hazards."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from random import Random
from typing import Any

from interlock.dataclass import dataclass
from interlock.model.layout import Layout
from interlock.simulate.faults import Faults
from interlock.simulate.local_rules import cranked, power_cut
from interlock.simulate.operator import Operator
from interlock.simulate.track import Track
from interlock.simulate.world import World

LIFE = 20_000
"""Scans after which a new railway is begun, with other trains, points and drivers."""


@dataclass
class Outcome:
    """What a run showed: scans, movements (signals passed at proceed), hazards with their times, world seconds."""

    scans: int = 0
    movements: int = 0
    trains: int = 0
    power_cuts: int = 0
    world_s: float = 0.0
    hazards: list[str] = field(default_factory=list)
    passed_at_stop: list[str] = field(default_factory=list)


def load(runtime: str) -> dict[str, Any]:
    """The emitted runtime as a module's names."""
    names: dict[str, Any] = {}
    exec(compile(runtime, "runtime.py", "exec"), names)
    return names


def simulate(
    layout: Layout,
    runtime: str,
    *,
    scans: int,
    seed: int,
    hostile: bool,
    routes: Mapping[str, tuple[int, ...]] | None = None,
    faults: Faults | None = None,
    life: int = LIFE,
    until: Callable[[Outcome], bool] = lambda o: bool(o.hazards),
    watch: Callable[[World, Mapping[str, int]], None] | None = None,
) -> Outcome:
    """Drive trains on a runtime for a number of scans, or until something is found."""
    track = Track.of(layout)
    names = load(runtime)
    total = Outcome()
    lives = 0
    while total.scans < scans and not until(total):
        lives += 1
        one = Life(layout, track, names, Random(f"{seed} {lives}"), hostile, routes or {}, faults or Faults())
        one.run(min(life, scans - total.scans), total, until, watch)
    return total


class Life:
    """One railway from its restart on."""

    def __init__(
        self,
        layout: Layout,
        track: Track,
        names: Mapping[str, Any],
        rng: Random,
        hostile: bool,
        routes: Mapping[str, tuple[int, ...]],
        faults: Faults,
    ) -> None:
        self.names, self.rng, self.faults = names, rng, faults
        self.restrictive: dict[str, int] = {n: int(v) for n, v in names["OUTPUTS"].items()}
        self.world = World(layout, track, names["INPUTS"], names["OUTPUTS"], rng, faults)
        self.operator = Operator(self.world, names["INPUTS"], rng, routes, hostile)
        self.cycle = rng.choice((0.2, 0.4, 0.6, 0.8))
        self.world.drivers.scan_s = 1.1 * self.cycle
        self.controller = names["Controller"]()
        self.longest_s = float(names["Controller"].cycle_max_ms) / 1000

    def run(
        self,
        scans: int,
        total: Outcome,
        until: Callable[[Outcome], bool],
        watch: Callable[[World, Mapping[str, int]], None] | None,
    ) -> None:
        """So many scans."""
        world, rng = self.world, self.rng
        world.watch.found = total.hazards
        new = old = shown = self.restrictive
        stopped = 1.0
        for _ in range(scans):
            if rng.random() < self.faults.power * self.cycle:
                self._without_power(total)
                new = old = shown = self.restrictive
            dt = self._cycle(stopped)
            stopped = 0.0 if any(t.speed for t in world.trains) else stopped + dt
            shown = new if shown is new or rng.random() < 0.7 else old
            inputs = world.step(dt, shown)
            self.operator.act(new)
            if world.machines.damaged:
                world.machines.mend(inputs, new)
            world.reports.read()
            old, new = new, self.controller.scan(inputs, round(1000 * dt))
            total.scans += 1
            if watch is not None:
                watch(world, new)
            if total.hazards and until(total):
                break
        total.movements += world.drivers.movements
        total.trains += world.traffic.numbers
        total.world_s += world.clock
        total.passed_at_stop += world.drivers.passed_at_stop

    def _cycle(self, stopped: float) -> float:
        """Seconds until the next scan: about the same each time, longer while nothing moves, too long in a fault."""
        if self.rng.random() < self.faults.stall * self.cycle:
            return self.rng.uniform(0.5, 4.0) * self.longest_s
        if stopped > 5.0:
            return 0.9 * self.longest_s
        return self.cycle * self.rng.uniform(0.7, 1.1)

    def _without_power(self, total: Outcome) -> None:
        """The controller goes dark, the railway runs on; then it starts with nothing in its memory."""
        total.power_cuts += 1
        world = self.world
        power_cut(world)
        for _ in range(self.rng.choice((2, 20, 400))):
            world.step(0.4, self.restrictive)
        if not any(t.speed for t in world.trains):
            cranked(world)
        world.reports.past.clear()
        self.controller = self.names["Controller"]()
