"""What a train is to do, where it stands between two routes, and the step from there to the next place."""

from __future__ import annotations

from interlock.dataclass import dataclass
from interlock.exceptions import Whole
from interlock.model.elements import RouteId, SectionId
from interlock.model.portable import beside
from interlock.table.cells import TraversalKey
from interlock.table.rows import RouteRow

OUTSIDE = 0
"""The number of the way of a train that stands outside a boundary, whose name is then its section."""

GONE = "gone"


class TooManyPlaces(Exception):
    """An errand leads to more places than can be looked at."""


class NoVoyage(Whole):
    """No chain of routes makes an errand; says which leg, and in `fix` what could be done."""

    def __init__(self, text: str, fix: str) -> None:
        super().__init__(text)
        self.fix = fix


@dataclass(frozen=True)
class Leg:
    """A part of an errand: to a boundary, a signal or a section, over sections; `shunt`: on shunt routes.

    far_first: all its routes are asked for at once, from the far end.  wholly: it ends where the whole train stands in
    the section that is its end.
    """

    to: str
    via: frozenset[SectionId] = frozenset()
    shunt: bool = False
    far_first: bool = False
    wholly: bool = False


@dataclass(frozen=True)
class Errand:
    """What one train is to do.  `start`: the ways under it from the rear, or (boundary, OUTSIDE)."""

    train: str
    length_m: float
    start: tuple[TraversalKey, ...]
    legs: tuple[Leg, ...]


@dataclass(frozen=True)
class Place:
    """Where a train stands between two routes: leg, what it passed of `via`, the route it came on, ways under it.

    under_way: routes by which it came that hold what the author has added to them (hostile routes, points).
    inside: earlier routes by which it came, in whose overlaps it stands now: none is given up before all of it
        stands in the last section.
    """

    leg: int
    passed: frozenset[SectionId]
    route: RouteId | None
    under: tuple[TraversalKey, ...]
    under_way: frozenset[RouteId] = frozenset()
    inside: frozenset[RouteId] = frozenset()

    def __str__(self) -> str:
        return beside(s for s, _ in self.under) or GONE


@dataclass(frozen=True)
class Step:
    """A route, or routes in the order of travel, that take a train from one place to the next.

    besides: what nobody else may hold, beside what the routes need.
    """

    routes: tuple[RouteRow, ...]
    after: Place
    turned: bool
    besides: frozenset[object] = frozenset()
