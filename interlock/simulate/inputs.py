"""The inputs of a controller in a shift, as the railway and people write them; sections report what stands in them."""

from __future__ import annotations

from collections.abc import Iterable

from interlock.model.portable import portable
from interlock.simulate.agenda import Agenda
from interlock.simulate.track import Track


class Inputs:
    """Inputs by name, and since when one is other than the controller has read it."""

    def __init__(self, track: Track, values: dict[str, int], agenda: Agenda) -> None:
        self._values, self._agenda = values, agenda
        self.changed_ms: int | None = None
        """Since when an input is other than the controller has read it."""
        for name in values:  # nothing is pressed, blocked or out of order
            values[name] = int(
                name.startswith(("RL_", "GL_", "CL_", "NL_", "UL_", "VL_", "E_", "SH_", "VALID", "CLR_"))
            )
        self._clear = [f"CLR_{portable(s)}" for s in track.sections]
        self._count = [0] * len(track.sections)
        self._held: dict[int, int] = {}
        """Sections that report occupied whatever stands there, and how many things make them."""

    def write(self, name: str, value: int) -> None:
        """An input of the controller."""
        if self._values.get(name, value) != value:
            self._values[name] = value
            if self.changed_ms is None:
                self.changed_ms = self._agenda.now_ms

    def hold(self, section: int, more: int) -> None:
        """One thing more (or less) makes a section report occupied."""
        self._held[section] = self._held.get(section, 0) + more
        self._report(section)

    def occupy(self, sections: Iterable[int], more: int) -> None:
        """One train more (or less) stands in some sections."""
        for s in sections:
            self._count[s] += more
            self._report(s)

    def _report(self, section: int) -> None:
        occupied = bool(self._count[section] or self._held.get(section))
        self.write(self._clear[section], int(not occupied))
