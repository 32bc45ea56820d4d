"""Who works the panel: somebody who plays at random, and somebody who wants an accident.

Every input for the operator is in their hands: requests from the centre and on the spot, automatic working,
cancelling, releasing, blocking, point keys, the confirmation after trailing.  The hand of the special manual change of
direction alone is held only as agreed by telephone (A-AGREED).
"""

from __future__ import annotations

from collections.abc import Mapping
from random import Random
from typing import TYPE_CHECKING

from interlock.model.portable import portable
from interlock.simulate.track import NONE

if TYPE_CHECKING:
    from interlock.simulate.world import World

NUMBERS = ("REQ", "LREQ")


class Operator:
    """Sets the operator's inputs before every scan.  `routes`: numbers of requests by entry signal, as a hint."""

    def __init__(
        self,
        world: World,
        inputs: Mapping[str, tuple[int, int]],
        rng: Random,
        routes: Mapping[str, tuple[int, ...]],
        hostile: bool,
    ) -> None:
        self.world, self._rng, self._hostile = world, rng, hostile
        self._sizes = {n: size for n, (_, size) in inputs.items()}
        self._numbers = [n for n in NUMBERS if n in inputs]
        self._cancels = [f"CAN_{portable(s)}" for s in world.track.signals]
        self._cancels = [n if n in inputs else "" for n in self._cancels]
        self._stops = [f"YS_{portable(s)}" for s in world.track.signals]
        self._routes = [routes.get(s, ()) for s in world.track.signals]
        self._releases = [n for n in inputs if n.startswith("REL_")]
        self._blocks = [n for n in inputs if n.startswith("BLK_")]
        self._keys = [n for n in inputs if n.startswith(("MN_", "MR_"))]
        self._looked = [n for n in inputs if n.startswith("TC_")]
        self._automatic = [n for n in inputs if n.startswith("AUTO_")]
        self._prey, self._caught, self._reach = NONE, False, 50.0
        self._bait, self._age, self._ripe, self._sprung, self._near = NONE, 0, 0, 0, 0.6
        self._held: dict[str, int] = {}
        for n in self._blocks:
            world.reports.inputs[n] = 0

    def hold(self, name: str, value: int, scans: int) -> None:
        """Hold a button for some scans."""
        if name:
            self.world.reports.inputs[name] = value
            self._held[name] = scans

    def act(self, outputs: Mapping[str, int]) -> None:
        """Once before every scan; `outputs`: those of the last one, as lamps on the panel."""
        rng, inputs = self._rng, self.world.reports.inputs
        for name, left in tuple(self._held.items()):
            if left <= 0:
                del self._held[name]
                if name not in NUMBERS:
                    inputs[name] = 0
            else:
                self._held[name] = left - 1
        for name in self._numbers:
            if name in self._held:
                continue
            if inputs[name]:
                inputs[name] = 0  # let go: a request that is held is taken once
            elif rng.random() < (0.5 if name == "REQ" else 0.05):
                inputs[name] = self._wish(name)
                self._held[name] = rng.choice((0, 0, 1, 3)) if rng.random() < 0.998 else 400
        if self._hostile:
            self._takes_back(outputs)
            self._harm()
        else:
            self._play()
        if not self._hostile or rng.random() < 0.5:
            self._works(outputs)
        for line in self.world.neighbours.values():
            inputs[line.hand] = int(line.agreed() and (inputs[line.hand] or rng.random() < 0.05))

    def _wish(self, name: str) -> int:
        """A number to ask for: mostly a route before which a train waits."""
        rng = self._rng
        if self._hostile and name == "REQ" and rng.random() < 0.6:
            number = self._baits() or self._lures()
            if number:
                return number
        if rng.random() < 0.95:
            waiting = [t.view.signals for t in self.world.trains if t.view.signals and not t.driver.stuck]
            if waiting:
                signals = rng.choice(waiting)
                numbers = self._routes[signals[0] if rng.random() < 0.6 else rng.choice(signals)]
                if numbers:
                    return rng.choice(numbers)
        return rng.randrange(self._sizes[name])

    def _lures(self) -> int:
        """A train is called on past signal after signal, so that the last can be closed before it has come near."""
        rng, trains = self._rng, self.world.trains
        prey = next((t for t in trains if t.number == self._prey), None)
        if prey is None or prey.driver.stuck or len(prey.view.signals) < 2 or self._caught:
            fast = [t for t in trains if t.driver.called and t.speed > 1.0 and t.number != self._prey]
            run = [t for t in fast if len(t.view.signals) > 1]
            self._prey, self._caught = (rng.choice(run).number if run else NONE), False
            return 0
        numbers = self._routes[prey.view.signals[1] if rng.random() < 0.5 else prey.view.signals[0]]
        return rng.choice(numbers) if numbers else 0

    def _baits(self) -> int:
        """A route is set long before a train comes to it; once it is taken back under one, others are asked for."""
        rng = self._rng
        if self._bait == NONE and rng.random() < 0.2:
            met = {g for t in self.world.trains for g in t.view.signals}
            free = [g for g, numbers in enumerate(self._routes) if numbers and self._cancels[g] and g not in met]
            if free:
                self._bait, self._age, self._sprung = rng.choice(free), 0, 0
                self._ripe = rng.choice((20, 200, 400, 600))
                return rng.choice(self._routes[self._bait])
        if self._sprung:
            others = [n for g, numbers in enumerate(self._routes) if g != self._bait for n in numbers]
            return rng.choice(others) if others else 0
        return 0

    def _takes_back(self, outputs: Mapping[str, int]) -> None:
        """The route that was set long ago is cancelled under a train that was told that its signal is open, when it
        cannot stop any more."""
        if self._bait == NONE:
            return
        self._age += 1
        late = (
            t.view.target == self._bait
            and t.driver.accepted
            and t.view.gap < self._near * t.speed**2 / (2 * t.handling.brakes)
            for t in self.world.trains
        )
        if self._sprung:
            self._sprung -= 1
            self._bait = self._bait if self._sprung else NONE
        elif self._age > self._ripe + 400 or (self._age == 20 and outputs.get(self._stops[self._bait])):
            self._bait = NONE
        elif self._age > self._ripe and any(late):
            self.hold(self._cancels[self._bait], 1, 2)
            self._sprung, self._near = 40, self._rng.choice((0.3, 0.6, 0.9))

    def _springs(self) -> None:
        """The signal after the next is cancelled under a train that was told that it is open."""
        for t in self.world.trains:
            if (
                t.number == self._prey
                and t.driver.announced
                and len(t.view.signals) > 1
                and not self._caught
                and t.view.gap < self._reach
            ):
                self.hold(self._cancels[t.view.signals[1]], 1, 2)
                self._caught, self._reach = True, self._rng.choice((5.0, 50.0, 200.0, 400.0))

    def _some(self, names: list[str], chance: float, longest: int) -> None:
        if names and self._rng.random() < chance:
            self.hold(self._rng.choice(names), 1, self._rng.randrange(1, longest))

    def _works(self, outputs: Mapping[str, int]) -> None:
        """What a dispatcher does to keep traffic running: confirm, release, take back what nobody needs."""
        rng = self._rng
        what = rng.random()
        if what < 0.03:
            locked = [
                n
                for n in self._releases
                if outputs.get("YL_" + n[4:]) and self.world.reports.inputs.get("CLR_" + n[4:])
            ]
            if locked:
                self.hold(rng.choice(locked), 1, rng.choice((5, 100, 600)))
        elif what < 0.05:
            for name in self._looked:
                if outputs.get("YT_" + name[3:]):
                    self.hold(name, 1, 2)
        elif what < 0.08:
            wanted = {g for t in self.world.trains if t.driver.called or t.view.gap < 300.0 for g in t.view.signals}
            idle = [g for g in range(len(self._cancels)) if g not in wanted and g != self._bait and self._cancels[g]]
            for g in rng.sample(idle, min(3, len(idle))):
                self.hold(self._cancels[g], 1, 1)

    def _play(self) -> None:
        self._some([n for n in self._cancels if n], 0.005, 4)
        self._some(["RELALL"], 0.01, 20)
        self._some(self._releases, 0.005, 400)
        self._some(self._blocks, 0.0005, 200)
        self._some(self._keys, 0.01, 6)
        self._some(self._looked, 0.02, 3)
        self._some(self._automatic, 0.002, 400)

    def _harm(self) -> None:
        rng = self._rng
        self._springs()
        for t in self.world.trains:
            if t.view.target == NONE:
                continue
            close = t.driver.accepted and t.view.gap < 300.0
            if rng.random() < (0.01 if close else 0.002):
                g = rng.choice(t.view.signals)
                if g != self._bait:
                    self.hold(self._cancels[g], 1, rng.choice((1, 1, 2, 20, 400)))
        self._some([n for g, n in enumerate(self._cancels) if n and g != self._bait], 0.002, 4)
        self.world.reports.inputs["RELALL"] = 1
        self._some(self._releases, 0.1, 1000)
        self._some(self._blocks, 0.0005, 20)
        for _ in range(3):
            self._some(self._keys, 0.3, 8)
        self._some(self._looked, 0.3, 3)
        self._some(self._automatic, 0.002, 100)
