"""Zones in plans: counted as the controller counts them (R17), which knows sections and no trains."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise

from interlock.model.layout import Layout
from interlock.table.cells import TraversalKey
from interlock.table.rows import RouteRow


class Zones:
    """The zones of a layout.  `limits`: names, and how many trains there may be."""

    def __init__(self, layout: Layout) -> None:
        self.limits = [(z.id, z.trains) for z in layout.declared.zones]
        self._of = {s: z.id for z in layout.declared.zones for s in z.sections}

    def inside(self, under: Iterable[TraversalKey]) -> Mapping[str, int]:
        """How often a train on ways counts in zones: with each section."""
        return Counter(self._of[s] for s, _ in under if s in self._of)

    def entering(self, chain: Sequence[RouteRow]) -> Mapping[str, int]:
        """The room that routes in the order of travel ask for in zones, the last of them set first: a section of a zone
        counts from when it is locked, until what leads to it inside the zone is locked, too."""
        room: dict[str, int] = {}
        ahead: Counter[str] = Counter()
        for r in reversed(chain):
            for c in r.conditions.zones:
                room[c.zone] = max(room.get(c.zone, 0), ahead[c.zone] + c.entries)
            for before, s in pairwise((None, *r.path.section_ids)):
                zone = self._of.get(s) if s is not None else None
                if zone is not None and (before is None or self._of.get(before) != zone):
                    ahead[zone] += 1
        return room

    def room(self, under: Iterable[TraversalKey], chain: Sequence[RouteRow]) -> bool:
        """There is room for a train itself, wherever others are."""
        full, own = dict(self.limits), self.inside(under)
        return all(own.get(z, 0) + n <= full[z] for z, n in self.entering(chain).items())
