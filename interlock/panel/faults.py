"""What fails of the simulated railway: as a person at the panel says so, until he puts it right."""

from __future__ import annotations

from collections.abc import Collection
from math import inf

from interlock.logic import names
from interlock.model.portable import portable
from interlock.panel.stock import Impossible
from interlock.simulate.world import World

_LAMPS = {
    "stop": ("RL_", "stop lamp"),
    "clear": ("GL_", "clear lamp"),
    "caution": ("CL_", "caution lamp"),
    "second yellow": ("UL_", "second yellow lamp"),
    "identifier": ("NL_", "identifier lamp"),
    "speed": ("VL_", "speed indicator"),
}
"""What is lit at a signal: how the input begins that reports it, and its name."""


class Faults:
    """What somebody lets fail on a railway with these substations, and puts right again."""

    def __init__(self, world: World, stations: Collection[str]) -> None:
        self._world, self._stations = world, stations
        self.failed: set[tuple[str, str]] = set()
        """Kind and name."""
        self.cut: set[str] = set()
        """Substations whose cable is cut."""

    def fail(self, kind: str, name: str, on: bool) -> None:
        """Let a section read occupied, a machine lose detection, a lamp go out, a condition fail, a substation fall
        silent; or put it right again.  Raises `Impossible`."""
        act = {
            "section": self._fail_section,
            "machine": self._fail_machine,
            "lamp": self._fail_input,
            "condition": self._fail_input,
            "station": self._fail_station,
        }.get(kind)
        if act is None:
            raise Impossible(f"nothing of the kind {kind} can fail")
        act(name, on)
        (self.failed.add if on else self.failed.discard)((kind, name))

    def _fail_section(self, name: str, on: bool) -> None:
        w = self._world
        if name not in w.track.sections or not w.reports.wired[w.track.sections.index(name)]:
            raise Impossible(f"{name} has no detector")
        w.reports.false[w.track.sections.index(name)] = inf if on else 0.0

    def _fail_machine(self, name: str, on: bool) -> None:
        w = self._world
        if name not in w.track.machines:
            raise Impossible(f"there is no machine {name}")
        w.machines.contacts.lost[w.track.machines.index(name)] = (inf if on else 0.0, 0)

    def _fail_input(self, variable: str, on: bool) -> None:
        w = self._world
        if variable not in (*w.reports.lamps, *w.reports.conditions):
            raise Impossible("no such lamp or condition is reported here")
        w.reports.out[variable] = inf if on else 0.0

    def _fail_station(self, name: str, on: bool) -> None:
        if name not in self._stations:
            raise Impossible(f"there is no substation {name}")
        (self.cut.add if on else self.cut.discard)(name)

    def called(self, kind: str, name: str) -> str:
        """What fails, in words: a lamp by its signal, not by its input."""
        if kind == "lamp":
            for signal, lamps in self.lamp_inputs().items():
                for what, proof in lamps.items():
                    if proof == name:
                        return f"the {_LAMPS[what][1]} of {signal}"
        found = next((c.id for c in self._world.layout.signalling.conditions if names.CONDITION(c.id) == name), name)
        return f"{'substation' if kind == 'station' else kind} {found}"

    def lamp_inputs(self) -> dict[str, dict[str, str]]:
        """By signal: the inputs that report its lamps."""
        out: dict[str, dict[str, str]] = {}
        for g in self._world.layout.signalling.signals:
            for what, (prefix, _) in _LAMPS.items():
                if (name := f"{prefix}{portable(g.id)}") in self._world.reports.inputs:
                    out.setdefault(str(g.id), {})[what] = name
        return out
