"""What a request has come to, cycle by cycle: a route is refused, or is set and its signal stays at stop, and why."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from interlock.app.reasons import Moment, Reasons
from interlock.app.run import Ready
from interlock.field.plc import Cycle
from interlock.logic.words import REFUSED, SET, UNKNOWN

AT_STOP = 5
"""In so many cycles one after the other a route is set and locked, and its signal at stop, before it is said: a signal
opens a cycle after its route is locked."""


class Answers:
    """The answers for one controller that is run."""

    def __init__(self, ready: Ready) -> None:
        assert ready.layout is not None and ready.controller is not None
        self._controller = ready.controller
        self._reasons = Reasons(ready.layout, ready.controller)
        self._before: Cycle | None = None
        self._at_stop: dict[int, int] = {}

    def after(self, cycle: Cycle, dt_ms: int) -> Iterator[dict[str, Any]]:
        """What is to be said after a cycle, `dt_ms` milliseconds after the one before."""
        before, self._before = self._before, cycle
        said = cycle.words()
        asked = self._asked(before, cycle)
        stays = {n: self._at_stop.get(n, 0) + 1 for n, code in said.items() if code == SET}
        self._at_stop = stays
        if before is None:
            return
        code = said.get(asked, UNKNOWN)
        swings = self._reasons.swing(asked, before.memory, cycle.memory)
        moment = Moment(cycle.inputs, before.memory, dt_ms)
        if code > REFUSED:
            reason = self._reasons.of_request(asked, moment, code)[0]
            yield {"route": self._name(asked), "refused": reason.text, "rule": reason.rule}
        if swings is not None and cycle.valid and not swings[1]:
            yield {"swing": str(swings[0]), "refused": self._reasons.of_request(asked, moment, UNKNOWN)[0].text}
        for number, cycles in stays.items():
            if cycles == AT_STOP or (number == asked and cycles > 1):
                waits = [reason.text for reason in self._reasons.of_stop(number, moment)]
                if waits:
                    yield {"route": self._name(number), "at_stop": waits}

    def _asked(self, before: Cycle | None, cycle: Cycle) -> int:
        """The number that is asked for in this cycle, if none was in the one before; else 0."""
        request = self._controller.symbols.requests.request
        if before is not None and before.inputs.get(request, 0):
            return 0
        return cycle.inputs.get(request, 0)

    def _name(self, number: int) -> str:
        return str(next(r.id for r in self._controller.symbols.routes if r.number == number))
