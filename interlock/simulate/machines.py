"""Machines of a world: how they move, how their rails lie, and what their contacts report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random

from interlock.model.elements import Work
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.simulate.track import NONE, Track


class Contacts:
    """What machines report; names: of their variables.  Contacts may be lost, and points that were run through have
    none for a while."""

    def __init__(self, names: Sequence[str]) -> None:
        self.names = [(f"DN_{n}", f"DR_{n}") for n in names]
        self.lost: dict[int, tuple[float, int]] = {}
        """Machines that report neither position (0) or both (1), and for how long."""

    def report(self, inputs: dict[str, int], position: Sequence[int], damaged: Mapping[int, float]) -> None:
        """Contacts as sampled."""
        for p, (normal, reverse) in zip(position, self.names, strict=True):
            inputs[normal], inputs[reverse] = int(p == 0), int(p == 1)
        for m, left in damaged.items():
            if left > 0.0:
                inputs[self.names[m][0]] = inputs[self.names[m][1]] = 0
        for m, (_, both) in self.lost.items():
            inputs[self.names[m][0]] = inputs[self.names[m][1]] = both


class Machines:
    """Points, devices and keys: position 0 or 1, or moving with seconds left; contacts may be lost."""

    def __init__(self, layout: Layout, track: Track, rng: Random) -> None:
        n = len(track.machines)
        self._track, self._rng = track, rng
        self._run_s = layout.principles.point_run_s
        self.position = [rng.randrange(2) for _ in range(n)]
        self.target = list(self.position)
        self.left = [0.0] * n
        self.names = [portable(m) for m in track.machines]
        self.hand = [
            m in {str(p.machine) for p in layout.pointwork.points if p.work is Work.HAND} for m in track.machines
        ]
        self._device = [m in {str(d.id) for d in layout.signalling.devices} for m in track.machines]
        self._drives = [(f"YN_{n}", f"YR_{n}") for n in self.names]
        self._confirms = [f"TC_{n}" for n in self.names]
        self._alarms = [f"YT_{n}" for n in self.names]
        self.contacts = Contacts(self.names)
        self.driven: set[int] = set()
        """Machines that the controller has driven since its last restart: it knows where they belong."""
        self.damaged: dict[int, float] = {}
        """Points that were run through, with the seconds until their contacts meet again; their rails lie nowhere."""
        self.lies = list(self.position)
        """How the rails lie, NONE while they move; of a hand-worked point its key tells only whether it may move."""
        self.version = 0

    def lay(self, m: int, position: int) -> None:
        """The rails lie otherwise, or nowhere."""
        if m in self.damaged:
            position = NONE
        if self.lies[m] != position:
            self.lies[m] = position
            self.version += 1

    def run(self, dt: float, shown: Mapping[str, int], both: list[int]) -> list[int]:
        """Move for a while; the machines whose rails began to move, and in `both` those that are driven both ways."""
        started = []
        for m, (normal, reverse) in enumerate(self._drives):
            if shown[normal] and shown[reverse]:
                both.append(m)
            to = 0 if shown[normal] else 1 if shown[reverse] else NONE
            if to == NONE and not self.left[m]:
                continue
            if to != NONE:
                self.driven.add(m)
            if to not in (NONE, self.target[m]):
                self.target[m] = to
                self.left[m] = self._run_s * self._rng.uniform(0.3, 1.0)
                self.position[m] = NONE
                if not self.hand[m]:
                    started.append(m)
                    self.lay(m, NONE)
            elif self.left[m] and to != NONE:
                self.left[m] = max(0.0, self.left[m] - dt)
                if not self.left[m]:
                    self.damaged.pop(m, None)  # a full throw puts them right, too
                    self.position[m] = self.target[m]
                    self.lay(m, 0 if self.hand[m] and not self.position[m] else self._final(m))
            if self.hand[m] and self.position[m] == 1 and self._rng.random() < 0.02:
                started.append(m)
                self.lay(m, self._rng.choice((0, 1, NONE)))
            elif self.hand[m] and self.position[m] == NONE and self.target[m] == 0 and self.lies[m] != 0:
                started.append(m)
                self.lay(m, 0)  # turned back by hand before the key is locked
        return started

    def _final(self, m: int) -> int:
        return self.lies[m] if self.hand[m] else self.position[m]

    def damage(self, m: int, seconds: float) -> None:
        """Points are run through: their rails are not to be trusted, their contacts open and meet again by and by."""
        self.damaged[m] = seconds
        self.lay(m, NONE)

    def mend(self, inputs: Mapping[str, int], shown: Mapping[str, int]) -> None:
        """Whoever is told of trailed points, and confirms that they were looked at, has put them right."""
        for m in tuple(self.damaged):
            if inputs.get(self._confirms[m]) and shown.get(self._alarms[m]):
                self.put_right(m)

    def put_right(self, m: int) -> None:
        """Somebody has looked at trailed points, and laid their rails as their machine has them."""
        del self.damaged[m]
        self.lay(m, self.position[m])
