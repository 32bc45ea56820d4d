"""Which order an idle train takes next.

An order of tonnes needs trains until those that were sent carry as much.

    in_turn    the order that has the largest part of its trains still to go, the one that is due first before others
    nearest    the nearest loading place that has room (document D, rule 2b), by metres from the waiting place
    fixed      each train always the same order, the first for the first train and so on (a yardstick, not a proposal)
    fixed_far  the same from the last order on: at heishan the trains work in the cross-cuts that lie farthest

A loading place takes no more trains than it has room for, counting those that are on their way.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import field
from enum import StrEnum

from interlock.dataclass import dataclass
from interlock.dispatch.language import DispatchFile
from interlock.dispatch.orders import Derived, metres_to


class Assigning(StrEnum):
    """How orders are given to trains."""

    IN_TURN = "in_turn"
    NEAREST = "nearest"
    FIXED = "fixed"
    FIXED_FAR = "fixed_far"


@dataclass
class Assigner:
    """Orders that are left, and who has which.  `given`: trains sent for each order so far."""

    file: DispatchFile
    orders: Sequence[Derived]
    how: Assigning = Assigning.IN_TURN
    given: dict[str, int] = field(default_factory=dict)
    sent: dict[str, float] = field(default_factory=dict)
    """By order: the tonnes that these carry."""
    busy: dict[str, str] = field(default_factory=dict)
    """By train: the loading place to which it is on its way, or in which it is."""
    near: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for o in self.orders:
            at = self.file.places[o.order.from_].at
            self.near[o.name] = min(metres_to(j, at) for j in o.journeys.values())

    def left(self, order: Derived) -> int:
        """Trains that an order still needs; of tonnes so many of those that carry least."""
        tonnes = order.order.tonnes
        if tonnes is None:
            return order.trains - self.given.get(order.name, 0)
        return max(0, math.ceil((tonnes - self.sent.get(order.name, 0.0)) / order.carried - 1e-9))

    def short(self, order: Derived, tonnes: float) -> None:
        """A train has brought less than it carries."""
        self.sent[order.name] = self.sent.get(order.name, 0.0) - tonnes

    def next(self, train: str) -> Derived | None:
        """The order for an idle train, which has it then; None where there is none now."""
        taken = list(self.busy.values())
        may = [o for o in self.orders if train in o.journeys]
        free = [o for o in may if self.left(o) > 0 and taken.count(o.order.from_) < self._room(o)]
        if self.how in (Assigning.FIXED, Assigning.FIXED_FAR):
            row = self.orders if self.how is Assigning.FIXED else self.orders[::-1]
            own = row[list(self.file.fleet).index(train) % len(row)]
            free = [o for o in free if o is own]
        if not free:
            return None
        best = min(free, key=self._rank)
        self._gives(train, best)
        return best

    def takes(self, train: str, order: Derived) -> bool:
        """An idle train takes an order that somebody has chosen for it, if its loading place has room."""
        room = list(self.busy.values()).count(order.order.from_) < self._room(order)
        if room and self.left(order) > 0:
            self._gives(train, order)
            return True
        return False

    def _gives(self, train: str, order: Derived) -> None:
        self.given[order.name] = self.given.get(order.name, 0) + 1
        self.sent[order.name] = self.sent.get(order.name, 0.0) + self.file.fleet[train].tonnes
        self.busy[train] = order.order.from_

    def leaves(self, *trains: str) -> None:
        """Trains leave their loading places for certain: a route is set for them."""
        for train in trains:
            self.busy.pop(train, None)

    def why(self, train: str) -> str:
        """Why an idle train has no order."""
        return (
            "no place to load is free"
            if any(self.left(o) > 0 and train in o.journeys for o in self.orders)
            else "no order is left"
        )

    def _room(self, o: Derived) -> int:
        return self.file.places[o.order.from_].capacity

    def _rank(self, o: Derived) -> tuple[float, float, float]:
        if self.how is Assigning.NEAREST:
            return self.near[o.name], 0.0, 0.0
        return -self.left(o) / o.trains, o.order.by or float("inf"), self.near[o.name]
