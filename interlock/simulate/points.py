"""Points and devices that are driven, take their time, and report where they lie."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from random import Random
from typing import TYPE_CHECKING

from interlock.model.portable import portable
from interlock.simulate.track import NONE

if TYPE_CHECKING:
    from interlock.simulate.yard import Yard


class Points:
    """All machines of a yard: 0 and 1 are their positions, NONE while they move."""

    def __init__(self, yard: Yard, rng: Random) -> None:
        self.yard, self._rng = yard, rng
        n = len(yard.track.machines)
        self.position = [0] * n
        self.lies = [0] * n
        self.target = [0] * n
        self.version = 0
        self.lost: dict[int, int] = {}
        """Machines whose contacts report nothing, and how many faults make them."""
        self.run_s = yard.track.layout.principles.point_run_s
        names = [portable(m) for m in yard.track.machines]
        self._drives = [(f"YN_{m}", f"YR_{m}") for m in names]
        self._contacts = [(f"DN_{m}", f"DR_{m}") for m in names]
        for m in range(n):
            self._report(m)

    def drive(self, outputs: Mapping[str, int]) -> None:
        """What the controller drives begins to move."""
        for m, (normal, reverse) in enumerate(self._drives):
            both = outputs.get(normal) and outputs.get(reverse)
            if both:
                self.yard.watch.both_ways(self.yard, m)
            to = 0 if outputs.get(normal) else 1 if outputs.get(reverse) else NONE
            if to in (NONE, self.target[m]):
                continue
            self.target[m] = to
            self._lay(m, NONE)
            self.yard.watch.machine_moves(self.yard, m)
            seconds = self.run_s * self._rng.uniform(0.6, 1.0)
            self.yard.agenda.after(seconds, partial(self._arrives, m), f"machine {m}")

    def fault(self, m: int, more: int) -> None:
        """One thing more (or less) keeps a machine from being detected."""
        self.lost[m] = self.lost.get(m, 0) + more
        self._report(m)

    def _arrives(self, m: int) -> None:
        self._lay(m, self.target[m])

    def _lay(self, m: int, position: int) -> None:
        self.position[m] = self.lies[m] = position
        self.version += 1
        self._report(m)
        if position != NONE:
            self.yard.say("lies", machine=self.yard.track.machines[m], position=position)

    def _report(self, m: int) -> None:
        for p, name in enumerate(self._contacts[m]):
            self.yard.inputs.write(name, int(self.position[m] == p and not self.lost.get(m)))
