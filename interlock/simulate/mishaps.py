"""What goes wrong in a shift, and how often; each is mended after a while.

false: a section reports occupied though nobody is there.  contact: a machine is not detected.  link: all inputs are
lost, as with a broken line to a substation.  wagon: a train leaves a wagon behind, which keeps its section occupied
until it is taken away.
"""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import TYPE_CHECKING

from interlock.dataclass import dataclass

if TYPE_CHECKING:
    from interlock.simulate.yard import Yard


@dataclass(frozen=True)
class Rates:
    """Times each hour, and minutes until it is mended, on the average (exponential both)."""

    false: float = 0.0
    contact: float = 0.0
    link: float = 0.0
    wagon: float = 0.0
    minutes: float = 5.0

    @property
    def any(self) -> bool:
        """Something goes wrong."""
        return bool(self.false or self.contact or self.link or self.wagon)


TRIAL = Rates(0.5, 0.5, 0.25, 0.25)
"""Far more than a railway has, so that faults meet (our choice)."""


class Mishaps:
    """Faults of a yard; `lost`: told of a train and the section in which a wagon of it stays."""

    def __init__(self, yard: Yard, rng: Random, rates: Rates, lost: Callable[[str, str], None]) -> None:
        self.yard, self.rng, self.rates, self.lost = yard, rng, rates, lost
        self._links = 0

    def begin(self) -> None:
        """From now on things go wrong."""
        for rate, what in (
            (self.rates.false, self._false),
            (self.rates.contact, self._contact),
            (self.rates.link, self._link),
            (self.rates.wagon, self._wagon),
        ):
            if rate:
                self._next(rate, what)

    def _next(self, rate: float, what: Callable[[], None]) -> None:
        def happens() -> None:
            what()
            self._next(rate, what)

        self.yard.agenda.after(self.rng.expovariate(rate / 3600), happens)

    def _mends(self, text: str, undo: Callable[[], None], minutes: float) -> None:
        def mended() -> None:
            undo()
            self.yard.say("mended", text=text)

        self.yard.say("fault", text=text)
        self.yard.agenda.after(60 * self.rng.expovariate(1 / minutes), mended)

    def _false(self) -> None:
        x = self.rng.randrange(len(self.yard.track.sections))
        self.yard.inputs.hold(x, 1)
        name = self.yard.track.sections[x]
        self._mends(f"{name} is falsely reported occupied", lambda: self.yard.inputs.hold(x, -1), self.rates.minutes)

    def _contact(self) -> None:
        if not self.yard.track.machines:
            return
        m = self.rng.randrange(len(self.yard.track.machines))
        self.yard.machines.fault(m, 1)
        name = self.yard.track.machines[m]
        self._mends(f"{name} is not detected", lambda: self.yard.machines.fault(m, -1), self.rates.minutes)

    def _link(self) -> None:
        self._links += 1
        self.yard.inputs.write("VALID", 0)

        def again() -> None:
            self._links -= 1
            self.yard.inputs.write("VALID", int(not self._links))

        self._mends("inputs are lost", again, self.rates.minutes / 10)

    def _wagon(self) -> None:
        """The next train that leaves a section inside leaves a wagon there."""
        inside = [r for r in self.yard.rolling.values() if r.sections and r.motion.at(self.yard.clock)[1] > 0]
        if not inside:
            return
        r = self.rng.choice(sorted(inside, key=lambda r: r.name))
        x = r.sections[0]
        name = self.yard.track.sections[x]
        self.yard.inputs.hold(x, 1)
        self.lost(r.name, name)
        text = f"{r.name} has left a wagon in {name}"
        self._mends(text, lambda: self.yard.inputs.hold(x, -1), 2 * self.rates.minutes)
