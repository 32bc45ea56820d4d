"""Where an element stands in the source, for the phases that know elements and no text."""

from __future__ import annotations

from collections.abc import Mapping

from interlock.diag import Element, Span
from interlock.frontend.context import Context
from interlock.frontend.parts import points_of


class Places:
    """Finds the place at which an element is defined; the place of the layout's name for what stands nowhere."""

    def __init__(self, ctx: Context, sections: Mapping[str, Span]) -> None:
        self._ctx = ctx
        self._sections = sections

    def __call__(self, element: Element) -> Span:
        """The place of an element."""
        room, name = element.room, element.name
        f = self._ctx.file
        if room == "sections" and name in self._sections:
            return self._sections[str(name)]
        if room == "waive":
            for i, w in enumerate(f.waive):
                if w.flank == name:
                    return self._ctx.at("waive", i, "flank")
        for lists in ("buffers", "traps") if room == "buffers" else ():
            if name in getattr(f, lists):
                return self._ctx.at(lists, getattr(f, lists).index(name))
        if room == "principles":
            return self._ctx.at_key(*self._ctx.stated(str(name)))
        if room in ("points", "crossings"):
            return self._ctx.at_key(*self._moved(str(name)))
        if isinstance(name, int) or name in getattr(f, room, ()):
            return self._ctx.at_key(room, name)
        return self._ctx.at_key("name")

    def _moved(self, name: str) -> tuple[str, str]:
        """The key under which a point or diamond is written: also of one that belongs to a slip or is a derailer."""
        f = self._ctx.file
        for room in ("points", "crossings", "derailers", "slips"):
            if name in getattr(f, room):
                return room, name
        for slip, spec in f.slips.items():
            if name in points_of(slip, spec):
                return "slips", slip
        return "name", ""
