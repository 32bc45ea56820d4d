"""A test bench: the emitted runtime, with everything outside it in a tester's hands, as in a test before delivery.

Sections are clear, lamps intact, conditions fulfilled and points where they are driven, unless the tester says
otherwise.
"""

from __future__ import annotations

import types
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from interlock.dataclass import dataclass
from interlock.logic.names import Name
from interlock.logic.symbols import RouteSymbols, Symbols
from interlock.model.elements import MachineId, Position, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.times import whole_ms

SCAN_MS = 200
"""Milliseconds between two scans while something is awaited."""

FEW = 5
"""Scans after which whatever needs no machine and no time has happened."""


@dataclass(frozen=True)
class Moment:
    """All that the bench remembers, to go on from once more."""

    state: Mapping[str, Any]
    elapsed: Mapping[str, Any]
    inputs: Mapping[str, int]
    lies: Mapping[MachineId, Position]
    outputs: Mapping[str, bool]


class Bench:
    """A running controller with its surroundings."""

    def __init__(self, runtime: str, layout: Layout, symbols: Symbols) -> None:
        """`runtime`: the text of the emitted runtime.py."""
        self._module = module = types.ModuleType("runtime")
        exec(compile(runtime, "runtime.py", "exec"), module.__dict__)
        self.layout, self.symbols = layout, symbols
        self._controller = module.Controller()
        self.inputs: dict[str, int] = {str(n): v for n, v in _at_rest(symbols).items() if str(n) in module.INPUTS}
        self.lies = dict.fromkeys(layout.machines, Position.NORMAL)
        """Where machines are, and are detected."""
        self._outputs: dict[str, bool] = dict(module.OUTPUTS)
        self.seconds = 0.0
        """How long it runs."""
        self._longest_ms = min(1000, int(self._controller.cycle_max_ms))

    def scan(self, inputs: Mapping[str, int] | None = None, dt_ms: int = SCAN_MS) -> None:
        """One scan, in which some inputs differ from what they are; driven machines arrive before the next."""
        said = {**self.inputs, **(inputs or {})}
        read = {**self._detected(), **said}
        self._outputs = self._controller.scan(read, dt_ms)
        self.seconds += dt_ms / 1000
        for (m, x), drive in self.symbols.machines.drive.items():
            if self._outputs.get(str(drive)) and not self._holds(m, said):
                self.lies[m] = x

    def scans(self, number: int, inputs: Mapping[str, int] | None = None) -> None:
        """Some scans."""
        for _ in range(number):
            self.scan(inputs)

    def wait(self, seconds: float, inputs: Mapping[str, int] | None = None) -> None:
        """Let time pass."""
        left = whole_ms(seconds)
        while left > 0:
            step = min(left, self._longest_ms)
            self.scan(inputs, step)
            left -= step

    def until(self, reached: Callable[[], bool], seconds: float, inputs: Mapping[str, int] | None = None) -> bool:
        """Scan until something is reached, no longer than some seconds; whether it is."""
        left = whole_ms(seconds)
        while not reached():
            if left <= 0:
                return False
            self.scan(inputs)
            left -= SCAN_MS
        return True

    def moment(self) -> Moment:
        """What is now."""
        c = self._controller
        return Moment(dict(c.state), dict(c.elapsed), dict(self.inputs), dict(self.lies), dict(self._outputs))

    def back(self, to: Moment) -> None:
        """Go on from a moment once more."""
        self._controller.state, self._controller.elapsed = dict(to.state), dict(to.elapsed)
        self.inputs, self.lies, self._outputs = dict(to.inputs), dict(to.lies), dict(to.outputs)

    def restart(self) -> None:
        """The power of the controller is cut and comes again; what is outside it stays as it is."""
        self._controller, self._outputs = self._module.Controller(), dict(self._module.OUTPUTS)

    def on(self, name: Name | None) -> bool:
        """Whether an output is 1, or a variable that is remembered is true."""
        if name is None:
            return False
        return bool(self._outputs.get(str(name)) or self._controller.state.get(str(name)))

    def why_not(self, r: RouteSymbols) -> str:
        """What the controller says of a route, in words."""
        said: str = self._controller.status(r.id)[1]
        return said

    def proceeds(self, signals: Iterable[SignalId] | None = None) -> list[SignalId]:
        """Those of some signals, or of all, that show more than stop."""
        aspects = self.symbols.aspects
        return [
            g
            for g in (aspects.stop if signals is None else signals)
            if any(self.on(n) for shunt in (False, True) for n in aspects.proceed_lamps(g, shunt))
        ]

    def _detected(self) -> dict[str, int]:
        return {str(n): int(self.lies[m] is x) for (m, x), n in self.symbols.machines.detected.items()}

    def _holds(self, m: MachineId, inputs: Mapping[str, int]) -> bool:
        """Whether the tester holds a machine's detection off in this scan."""
        return any(str(n) in inputs for (other, _), n in self.symbols.machines.detected.items() if other == m)


def locked(bench: Bench, s: SectionId) -> bool:
    """Whether a section is indicated as locked: one without an indication is always."""
    name = bench.symbols.indication.get(f"locked {s}")
    return name is None or bench.on(name)


def not_at_stop(bench: Bench) -> list[SignalId]:
    """The signals that show more than stop, or nothing."""
    stop = bench.symbols.aspects.stop
    return [g for g in stop if not bench.on(stop[g]) or bench.proceeds([g])]


def locked_up(bench: Bench) -> str:
    """What has to be when the controller has been switched on, whatever was before (R16)."""
    announced = ", every distant caution" if bench.symbols.aspects.distant_clear else ""
    return f"every signal shows stop{announced}, every section is indicated as locked, no points are driven"


def not_locked_up(bench: Bench) -> list[str]:
    """What is otherwise then."""
    y = bench.symbols
    came = [f"{g} does not show stop" for g in not_at_stop(bench)]
    came += [f"{s} is not locked" for s in y.sections.restart if not locked(bench, s)]
    points = [(m, x) for m, x in y.machines.drive if m not in bench.layout.machines.device]
    came += [f"{m} is driven" for m, x in points if bench.on(y.machines.drive[m, x])]
    return came + [f"{d} shows clear" for d, n in y.aspects.distant_clear.items() if bench.on(n)]


def occupied(y: Symbols, *sections: SectionId) -> dict[str, int]:
    """The inputs that report some sections occupied; none of one without detection."""
    return {str(y.sections.clear[s]): 0 for s in sections if s in y.sections.clear}


def undetected(y: Symbols, m: MachineId) -> dict[str, int]:
    """The inputs of a machine that has lost its detection."""
    return {str(n): 0 for (other, _), n in y.machines.detected.items() if other == m}


def _at_rest(y: Symbols) -> dict[Name, int]:
    """Inputs by which all is well, and nobody asks for anything."""
    lamps = y.lamp_proof
    well = [y.valid, *y.sections.clear.values(), *y.sections.healthy.values(), *y.condition.values()]
    for proofs in (lamps.stop, lamps.clear, lamps.caution, lamps.second, lamps.identifier, lamps.speed):
        well += proofs.values()
    well += [t.clear for t in y.token.values()]
    return dict.fromkeys(well, 1) | dict.fromkeys(y.sections.blocked.values(), 0)
