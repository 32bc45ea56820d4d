"""What a dispatcher has done, for whoever watches it: sentences, routes granted, trains that change ends."""

from __future__ import annotations

from dataclasses import field

from interlock.dataclass import dataclass
from interlock.model.elements import RouteId, SectionId


@dataclass(eq=False)
class Journal:
    """In the order in which it happened."""

    said: list[str] = field(default_factory=list)
    """What is told to people."""
    asked: list[tuple[str, str]] = field(default_factory=list)
    """Train and route of every request that was granted."""
    steps: list[tuple[str, SectionId, bool]] = field(default_factory=list)
    """Trains for which all routes of a step were granted, where each stands, and whether it turns for it."""

    def taken_back(self, train: str, routes: list[RouteId]) -> None:
        """Routes granted to a train were cancelled before it came: they count as not asked for."""
        back = [(train, r) for r in routes]
        self.asked = [x for k, x in enumerate(self.asked) if x not in back or x in self.asked[k + 1 :]]
