"""Which protection is taken where, settled for all routes together (R5).

A demand belongs to a way through a section, and many routes share a way.  So what is chosen for one place counts when
the next one is searched: no route may want a machine both ways, for its path or for any of its flanks (Zwieschutz,
eigen), and two routes that can be set together should not want one differently either (echt).  Where the preferred
protection would, substitute protection further outward is taken; where the next place has none, a place that was
settled before gives way if it has; and two routes become hostile only where neither has.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from itertools import islice
from operator import or_

from interlock.dataclass import dataclass
from interlock.derivation.flank import Options, Requester, point_demands
from interlock.model.bits import bits_of
from interlock.model.elements import MachineId, Position
from interlock.table.cells import Provider, TraversalKey

Demand = tuple[MachineId, Position]
Providers = tuple[Provider, ...]

TRIED = 16  # sets of providers for which others would have to give way
DEPTH = 3  # places that give way one after the other


@dataclass(frozen=True)
class Place:
    """A requester of one way, with the routes over it, as bits."""

    key: TraversalKey
    requester: Requester
    routes: int
    beside: int
    """These and all routes that can be set together with one of them."""


class Settlement:
    """What protects each place."""

    def __init__(
        self, places: Sequence[Place], paths: Sequence[Mapping[MachineId, Position]], options: Options
    ) -> None:
        """`paths`: by number of the route how its path and overlap need machines to lie."""
        self.places = places
        self.chosen: dict[int, Providers] = {}
        self.impossible: list[int] = []
        """Places without protection that agrees with the rest of the routes over them."""
        self._options = options
        self._fixed: dict[Demand, int] = {}
        for i, needs in enumerate(paths):
            for need in needs.items():
                self._fixed[need] = self._fixed.get(need, 0) | 1 << i
        self._holders: dict[Demand, dict[int, int]] = {}
        for at in self._order():
            if not any(self._place(at, mild) or self._displace(at, mild, DEPTH, {at}) for mild in (True, False)):
                self.impossible.append(at)

    def _order(self) -> list[int]:
        """Where there is no choice first, what may be waived last."""

        def rank(at: int) -> tuple[bool, bool]:
            r = self.places[at].requester
            return r.partner is None, r.waiver is not None

        return sorted(range(len(self.places)), key=rank)

    def against(self, at: int, m: MachineId, x: Position) -> tuple[int, dict[int, int]]:
        """The routes over a place whose path needs a machine otherwise, and by other places, whose protection does,
        those over both."""
        routes, need = self.places[at].routes, (m, x.other)
        others = {q: both for q, bits in self._holders.get(need, {}).items() if (both := bits & routes)}
        return self._fixed.get(need, 0) & routes, others

    def wanting(self, at: int, m: MachineId, x: Position) -> int:
        """The routes beside a place, or over it, that hold a machine in a position."""
        held = reduce(or_, self._holders.get((m, x), {}).values(), self._fixed.get((m, x), 0))
        return held & self.places[at].beside

    def partner_forbids(self, at: int, option: Providers) -> bool:
        """Whether a set would turn the partner of a scissors that lies normal for a route over the place."""
        routes = self.places[at].routes
        return any(
            bits & routes and self.places[q].requester.partner is not None
            for m, x in _demands(option)
            for q, bits in self._holders.get((m, x.other), {}).items()
        )

    def _scope(self, at: int, mild: bool) -> int:
        return self.places[at].beside if mild else self.places[at].routes

    def _place(self, at: int, mild: bool) -> bool:
        """Protects a place as best can be without contradicting a route over it, nor (`mild`) one beside it."""
        scope = self._scope(at, mild)

        def allowed(m: MachineId, x: Position) -> bool:
            need = m, x.other
            if self._fixed.get(need, 0) & scope:
                return False
            return not any(bits & scope for bits in self._holders.get(need, {}).values())

        first = self._options.preferred(self.places[at].requester)
        if first is None or not all(allowed(*d) for d in _demands(first)):
            first = next(self._options.of(self.places[at].requester, allowed), None)
        if first is None:
            return False
        self._take(at, first)
        return True

    def _displace(self, at: int, mild: bool, depth: int, settled: set[int]) -> bool:
        """Protects a place by what others hold otherwise, if they can be protected otherwise, too."""
        scope = self._scope(at, mild)

        def allowed(m: MachineId, x: Position) -> bool:
            need = m, x.other
            if self._fixed.get(need, 0) & scope:
                return False
            holders = self._holders.get(need, {})
            return not any(
                bits & scope and (q in settled or self.places[q].requester.partner is not None)
                for q, bits in holders.items()
            )

        before = dict(self.chosen)
        for option in islice(self._options.of(self.places[at].requester, allowed), TRIED):
            way = [
                q
                for m, x in _demands(option)
                for q, bits in self._holders.get((m, x.other), {}).items()
                if bits & scope
            ]
            giving = list(dict.fromkeys(way))
            for q in giving:
                self._leave(q)
            self._take(at, option)
            if all(
                self._place(q, mild) or (depth > 1 and self._displace(q, mild, depth - 1, settled | {q, *giving}))
                for q in giving
            ):
                return True
            self._restore(before)
        return False

    def _take(self, at: int, option: Providers) -> None:
        self.chosen[at] = option
        for need in _demands(option):
            self._holders.setdefault(need, {})[at] = self.places[at].routes

    def _leave(self, at: int) -> None:
        for need in _demands(self.chosen.pop(at)):
            del self._holders[need][at]

    def _restore(self, before: Mapping[int, Providers]) -> None:
        for at in [q for q, option in self.chosen.items() if before.get(q) is not option]:
            self._leave(at)
        for at, option in before.items():
            if at not in self.chosen:
                self._take(at, option)


def _demands(option: Providers) -> Iterable[Demand]:
    return (point_demands(option) or {}).items()


def beside(routes: int, hostile: Sequence[int], every: int) -> int:
    """Routes, as bits, and all that are not hostile to one of them."""
    return reduce(or_, (every & ~hostile[i] for i in bits_of(routes)), routes)
