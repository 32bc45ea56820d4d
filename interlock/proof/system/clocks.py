"""How the controller's timers and the clocks of the world go together.

A clock of the world tells that something has held without a break for a time that the world needs (`Plant.clocks`).
What is assumed of the world speaks of clocks, never of timers.  A timer says something of a clock only if, whenever its
input was true, what the clock looks at held too (`cov.TIMER`, a history variable, proved to stay true), and if its
preset is no shorter than the time that the world needs: two durations over the same scans.  Neither is assumed: a timer
that is started by something else, or is too short, says nothing of the world, and what rests on it is not proved.

**Theorem.**  If a timer has run out, its input was true without a break for its preset at least; if what a clock looks
at held in all of these scans, and the preset is no shorter than the world needs, then that has held without a break for
as long as the world needs.  (One interval within another; counted in the same time: A-CLOCK.)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from interlock.dataclass import dataclass
from interlock.logic.controller import Controller, Timer
from interlock.logic.expr import conj, implies, var
from interlock.logic.names import AGREED_LONG, STAND_LONG, STOP_LONG, Name, covered
from interlock.logic.plant import OF_PLC, Assumption
from interlock.model.elements import SignalId
from interlock.model.needs import Needs
from interlock.proof.system.loop import ClosedLoop


@dataclass(frozen=True, slots=True)
class Tie:
    """A timer, the world clock for which it stands, and the time that the world needs, in milliseconds."""

    timer: Timer
    clock: Name
    need: int

    @property
    def covered(self) -> Name:
        """The history variable: since the timer's input rose, what the clock looks at has held."""
        return covered(self.timer.name)

    @property
    def enough(self) -> bool:
        """The timer is no shorter than the world's need."""
        return self.timer.preset_ms >= self.need


def ties(loop: ClosedLoop) -> tuple[Tie, ...]:
    """The timers that stand for a clock of the world."""
    controller, needs, clocks = loop.controller, loop.measured.needs, loop.plant.clocks
    sym, timers = controller.symbols, {t.name: t for t in controller.timers}
    found = []
    for g, name in sym.cancellation.approach_timer.items():
        found.append((name, STOP_LONG(g), approach_need(controller, needs, g)))
    found += [(name, STAND_LONG(g), needs.stand[g]) for g, name in sym.overlaps.timer.items()]
    found += [(x.timer, AGREED_LONG(b), needs.agreed) for b, x in sym.token.items()]
    return tuple(Tie(timers[name], clock, need) for name, clock, need in found if name in timers and clock in clocks)


def approach_need(controller: Controller, needs: Needs, g: SignalId) -> int:
    """How long stop must be shown at a signal until nobody passes it any more: trains, if any are sent from there."""
    kinds = {r.shunt for r in controller.symbols.routes.of_signal.get(g, ())}
    return max([*([needs.stop[g]] if False in kinds else []), *([needs.shunt] if True in kinds else [])], default=0)


def assumed(timers: Iterable[Timer], those: Iterable[Tie]) -> Iterator[Assumption]:
    """What is assumed of time: an on-delay with a positive preset is true only while its input is true, and a timer
    that has run out, and was covered all the while, has lasted as long as the world needs."""
    for timer in timers:
        yield Assumption("A-TON", OF_PLC["A-TON"], implies(var(timer.name), var(timer.input)))
    for t in those:
        if t.enough:
            yield Assumption(
                "A-CLOCK",
                OF_PLC["A-CLOCK"],
                implies(conj((var(t.timer.name), var(t.covered.next))), var(t.clock.next)),
            )
