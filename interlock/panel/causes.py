"""What is wrong at the moment, for alarms."""

from __future__ import annotations

from collections.abc import Iterator

from interlock.app.run import Ready
from interlock.diag.called import called
from interlock.field.plc import Cycle
from interlock.model.elements import Position
from interlock.panel.reasons import Moment, Reason, Reasons

Causes = dict[str, tuple[str, tuple[str, ...]]]


def causes(ready: Ready, cycle: Cycle) -> Causes:
    """By key: what is wrong, and the elements that it is about."""
    assert ready.controller is not None and ready.allocation is not None
    y = ready.controller.symbols
    out: Causes = {}
    for text in cycle.lost:
        station = text.partition(":")[0]
        out[f"lost {station}"] = (f"{'substation ' if station in ready.allocation.stations else ''}{text}", ())
    for m in dict.fromkeys(str(m) for m, _ in y.machines.detected):
        late = y.indication.get(f"late {m}")
        if late is not None and cycle.outputs.get(late):
            out[f"late {m}"] = (f"{m} is not detected where it is commanded", (f"m:{m}",))
        trailed = y.machines.trailed.get(m)  # type: ignore[call-overload]
        if trailed is not None and cycle.memory.state.get(trailed):
            out[f"trailed {m}"] = (f"{m} was trailed: look at it", (f"m:{m}",))
    lamp_inputs = (
        (y.lamp_proof.stop, "stop"),
        (y.lamp_proof.clear, "clear"),
        (y.lamp_proof.caution, "caution"),
    )
    for lamps, what in (*lamp_inputs, (y.lamp_proof.identifier, "identifier")):
        for g, name in lamps.items():
            if cycle.valid and not cycle.inputs.get(name, 0):
                out[f"{what} lamp {g}"] = (f"the {what} lamp of {g} is out", (f"g:{g}",))
    for s, name in y.sections.healthy.items():
        if cycle.valid and not cycle.inputs.get(name, 0):
            out[f"detector {s}"] = (f"the detector of {called('section', s)} is out of order", (f"s:{s}",))
    return out


class Idle:
    """Machines that nobody has commanded since the restart and that are not detected: the controller supervises what it
    commands, and the panel supervises these for as long (R10)."""

    def __init__(self, ready: Ready) -> None:
        assert ready.layout is not None and ready.controller is not None
        y = ready.controller.symbols.machines
        self._machines = [
            (
                str(m),
                round(1000 * ready.layout.supervision_s(m)),
                tuple(y.detected[m, x] for x in Position if (m, x) in y.detected),
                tuple(y.command[m, x] for x in Position if (m, x) in y.command),
            )
            for m in ready.layout.machines
        ]
        self._lost_ms: dict[str, int] = {}
        self.causes: Causes = {}
        """By key: what is not detected for longer than the supervision time."""

    def after(self, cycle: Cycle, dt_ms: int) -> None:
        """A cycle has ended, `dt_ms` milliseconds after the one before."""
        self.causes = {}
        for m, allowed_ms, contacts, commands in self._machines:
            lies = sum(bool(cycle.inputs.get(n)) for n in contacts) == 1
            if not cycle.valid or lies or any(cycle.memory.state.get(n) for n in commands):
                self._lost_ms.pop(m, None)
                continue
            self._lost_ms[m] = lost_ms = self._lost_ms.get(m, -dt_ms) + dt_ms
            if lost_ms >= allowed_ms:
                self.causes[f"idle {m}"] = (f"{m} is not detected, and was not commanded", (f"m:{m}",))


def fallen_back(
    ready: Ready, reasons: Reasons, before: Cycle, cycle: Cycle, moment: Moment
) -> Iterator[tuple[str, tuple[str, ...], tuple[Reason, ...]]]:
    """Signals that have closed before their train came, without being cancelled, and why."""
    assert ready.controller is not None
    y = ready.controller.symbols
    was, now = before.memory.state, cycle.memory.state
    for r in y.routes:
        if (
            was.get(r.proceed)
            and not now.get(r.proceed)
            and now.get(r.active)
            and not now.get(y.cancellation.cancelling[r.entry])
        ):
            yield (
                f"{called('signal', r.entry)} has returned to stop",
                (f"g:{r.entry}",),
                tuple(reasons.of_loss(r.number, moment)),
            )
