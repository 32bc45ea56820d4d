"""The book of tests for commissioning a proved layout."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from interlock.app.check import Checked
from interlock.app.run import Ready, prepare
from interlock.commissioning.book import book
from interlock.commissioning.step import Sheet, Step
from interlock.dataclass import dataclass
from interlock.diag.suggest import did_you_mean
from interlock.logic.expr import interning
from interlock.model.elements import RouteId
from interlock.proof.induction.verdict import Progress, quiet


class NoRoute(Exception):
    """A route that the layout does not have; the message names it, and one that may be meant."""


@dataclass(frozen=True)
class Commissioning:
    """A layout, proved if it can be, and the tests of its book in order; None where it is not proved."""

    ready: Ready
    steps: tuple[Step, ...] | None = None

    @property
    def failed(self) -> tuple[Step, ...]:
        """Those in which something else came on the bench."""
        return tuple(s for s in self.steps or () if s.came)


def commission(path: str, routes: Sequence[str] = (), progress: Progress = quiet) -> Commissioning:
    """Prove a layout, and try its tests on the bench; of some routes alone, by a name of the author's or the table's.
    Raises `NoRoute`."""
    only: list[RouteId] = []

    def checked(found: Checked) -> None:
        assert found.table is not None
        known = {name: r.id for r in found.table.routes for name in (str(r.id), *r.names)}
        for name in routes:
            if name not in known:
                raise NoRoute(f"{path} has no route {name}: {did_you_mean(name, known, 'known: ' + ', '.join(known))}")
            only.append(known[name])

    def done(n: int, total: int) -> None:
        progress("trying the tests on the bench", n, total)

    ready = prepare(path, None, progress, checked)
    if ready.layout is None or ready.table is None or ready.controller is None or ready.allocation is None:
        return Commissioning(ready)
    made = ready.layout, ready.table, ready.controller, ready.allocation, ready.runtime
    with interning():
        return Commissioning(ready, tuple(book(*made, only or None, done)))


def not_in(steps: Sequence[Step], old: Sequence[Step]) -> tuple[Step, ...]:
    """The tests that another book does not have in the same words."""
    known = {s.words for s in old}
    return tuple(s for s in steps if s.words not in known)


def gone(steps: Sequence[Step], old: Sequence[Step], routes: Sequence[str] = ()) -> dict[str, int]:
    """How many tests of an old book a new one does not have in the same words, by route, and by sheet for the others.
    `routes`: those of which the new book is, if it is not of all."""
    lost = Counter(s.of if s.sheet is Sheet.ROUTES else str(s.sheet) for s in not_in(old, steps))
    return {what: n for what, n in lost.items() if not routes or what in routes}
