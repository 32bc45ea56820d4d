"""One scan, by definition: the reference interpreter of a controller.

`Machine` follows the five steps of `logic.controller` literally.  Timers are those of
`logic.on_delay`, which also tells after how long a cycle the inputs count as lost.  The Python runtime and the
Structured Text are compared with it.
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.logic.controller import Controller, Equation
from interlock.logic.expr import evaluate, truths
from interlock.logic.names import Name, computed
from interlock.logic.on_delay import CYCLE_MAX_MS, on_delay
from interlock.logic.words import UNKNOWN


class Machine:
    """A running controller."""

    def __init__(self, controller: Controller) -> None:
        self.controller = controller
        self.state: dict[str, int] = {s.name: int(s.initial) for s in controller.state}
        self.elapsed: dict[str, int | None] = {t.name: None for t in controller.timers}
        self.wires: dict[str, int] = {}
        following = truths(e.expr for e in controller.equations)
        self._steps = dict(zip((e.name for e in controller.equations), following, strict=True))
        self._next = truths(e.expr for e in controller.next)
        self._outputs = truths(o.expr for o in controller.outputs)

    def words(self) -> dict[Name, int]:
        """What the words say of the last scan; UNKNOWN before the first."""
        told = self.controller.words
        if not self.wires:
            return {w.name: UNKNOWN for w in told.words}
        values = self.wires | {computed(s.name): self.state[s.name] for s in self.controller.state}
        memo: dict[int, bool] = {}
        return told.told(lambda x: evaluate(x, values.__getitem__, memo))

    def scan(self, inputs: Mapping[str, int], dt_ms: int) -> dict[str, bool]:
        """One scan after `dt_ms` milliseconds; a missing input takes its restrictive value."""
        c = self.controller
        values: dict[str, int] = dict(self.state)
        for i in c.inputs:
            values[i.name] = i.read(int(inputs.get(i.name, i.restrictive)))
        if dt_ms > CYCLE_MAX_MS:
            values[c.symbols.valid] = 0
        for step in c.steps:
            if isinstance(step, Equation):
                values[step.name] = int(self._steps[step.name](values))
            else:
                elapsed, over = on_delay(self.elapsed[step.name], bool(values[step.input]), step.preset_ms, dt_ms)
                self.elapsed[step.name], values[step.name] = elapsed, int(over)
        new: dict[str, int] = {e.name: int(x(values)) for e, x in zip(c.next, self._next, strict=True)}
        self.wires = values
        self.state = new
        return {o.name: x(new) for o, x in zip(c.outputs, self._outputs, strict=True)}
