"""One scan, by definition: the reference interpreter of a controller.

`Machine` follows the five steps of `logic.controller` literally.  Timers count the time that is given to each
scan.  The Python runtime and the Structured Text are compared with it.
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.logic.controller import Controller, Equation
from interlock.logic.expr import evaluate


class Machine:
    """A running controller."""

    def __init__(self, controller: Controller) -> None:
        self.controller = controller
        self.state: dict[str, int] = {s.name: int(s.initial) for s in controller.state}
        self.elapsed: dict[str, int] = {t.name: 0 for t in controller.timers}
        self.wires: dict[str, int] = {}

    def scan(self, inputs: Mapping[str, int], dt_ms: int) -> dict[str, bool]:
        """One scan after `dt_ms` milliseconds; a missing input takes its restrictive value."""
        c = self.controller
        values: dict[str, int] = dict(self.state)
        for i in c.inputs:
            given = int(inputs.get(i.name, i.restrictive))
            values[i.name] = given if 0 <= given < max(i.size, 2) else i.restrictive
        for step in c.steps:
            if isinstance(step, Equation):
                values[step.name] = int(evaluate(step.expr, values.__getitem__, {}))
            elif values[step.input]:
                self.elapsed[step.name] = min(self.elapsed[step.name] + dt_ms, step.preset_ms)
                values[step.name] = int(self.elapsed[step.name] >= step.preset_ms)
            else:
                self.elapsed[step.name] = 0
                values[step.name] = 0
        memo: dict[int, bool] = {}
        new = {e.name: int(evaluate(e.expr, values.__getitem__, memo)) for e in c.next}
        self.wires = values
        self.state = new
        outputs: dict[int, bool] = {}
        return {o.name: evaluate(o.expr, new.__getitem__, outputs) for o in c.outputs}
