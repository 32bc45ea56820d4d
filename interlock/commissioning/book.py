"""The book of tests of an installation: every sheet, each test tried where a bench can."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import replace
from itertools import count

from interlock.commissioning.bench import FEW, Bench, locked, locked_up, not_locked_up, occupied
from interlock.commissioning.machines import machines
from interlock.commissioning.place import places
from interlock.commissioning.routes import RouteTests
from interlock.commissioning.step import Sheet, Step, started
from interlock.commissioning.wires import wires
from interlock.logic.cabinet import Allocation
from interlock.logic.controller import Controller
from interlock.model.elements import RouteId
from interlock.model.figures import exact
from interlock.model.layout import Layout
from interlock.table.cells import RouteKind
from interlock.table.rows import InterlockingTable

SETTLED_S = 10
"""Seconds after the restart delay, and after a release, in which the bench is left alone (our choice)."""


def book(
    layout: Layout,
    table: InterlockingTable,
    controller: Controller,
    allocation: Allocation,
    runtime: str,
    only: Collection[RouteId] | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Iterator[Step]:
    """All tests, numbered; of some routes alone, where they are named.

    `runtime`: the emitted text.  `progress`: routes that are done, and all.
    """
    bench = Bench(runtime, layout, controller.symbols)
    start = list(_start(bench))
    rest = bench.moment()
    asked = [r for r in table.routes if r.kind is not RouteKind.IDENTIFIER and (only is None or r.id in only)]
    if only is None:
        start += next(filter(None, (list(RouteTests(bench, table, r, rest).power_cut()) for r in asked)), [])
        yield from _numbered("W", wires(allocation, places(layout, controller.symbols)))
        yield from _numbered("S", start)
        yield from _numbered("M", machines(bench, rest))
    for done, row in enumerate(asked):
        progress(done, len(asked))
        yield from _numbered(f"R{row.number}.", RouteTests(bench, table, row, rest).steps())
    if only is None:
        yield from _numbered("T", _times(controller))


def _numbered(sign: str, steps: Iterable[Step]) -> Iterator[Step]:
    return (replace(step, number=f"{sign}{k}") for k, step in zip(count(1), steps, strict=False))


def _start(bench: Bench) -> Iterator[Step]:
    """From power-up to the release of all sections."""
    y, rules = bench.symbols, bench.layout.principles
    bench.scans(FEW)
    yield started("switch the controller on, all clear", locked_up(bench), not_locked_up(bench))
    bench.wait(rules.restart_delay_s + SETTLED_S)
    clear = bench.moment()
    bench.inputs |= occupied(y, *y.sections.restart)
    bench.scans(FEW, {str(y.sections.release_all): 1})
    bench.wait(SETTLED_S)
    later = f"after the restart delay of {exact(rules.restart_delay_s)} s"
    came = [f"{s} is released" for s in y.sections.restart if not locked(bench, s)]
    yield started(f"{later}, every section occupied: release all clear sections", "every section stays locked", came)
    bench.back(clear)
    for _ in range(2):  # a level crossing closes at the first, and the sections under it are released at the second
        bench.scans(FEW, {str(y.sections.release_all): 1})
        bench.wait(SETTLED_S)
    kept = [s for s in y.sections.restart if locked(bench, s) and s not in bench.layout.track.undetected]
    do = f"{later}, every section clear: release all clear sections"
    yield started(do, "no section with detection is locked", [f"{s} is locked" for s in kept])


def _times(controller: Controller) -> Iterator[Step]:
    """Every delay, for a stopwatch."""
    for t in controller.timers:
        yield Step(Sheet.TIMES, str(t.name), f"time it: {t.note}", f"no less than {exact(t.preset_ms / 1000)} s")
