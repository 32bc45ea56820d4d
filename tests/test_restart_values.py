"""What a restart has to do: without A-INITIAL signals stand at proceed after it.  The test for it."""

from __future__ import annotations

from itertools import takewhile

import pytest

from interlock.commissioning.bench import FEW, Bench, not_locked_up
from interlock.commissioning.book import book
from interlock.commissioning.step import Sheet, Step
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.model.elements import SignalId
from tests.layouts import SHIPPED, built


def bench_of(name: str) -> Bench:
    layout, _, controller = built(name)
    return Bench(runtime_py(controller, []), layout, controller.symbols)


def at_proceed(bench: Bench) -> list[SignalId]:
    """All that opens after the restart delay, asked for route by route."""
    y = bench.symbols
    bench.wait(bench.layout.principles.restart_delay_s + FEW)
    bench.scans(FEW, {str(y.sections.release_all): 1})
    bench.wait(10)
    for number in y.routes.number:
        bench.scan({str(y.requests.request): number})
        bench.wait(3)
    return bench.proceeds()


@pytest.mark.parametrize("name", ["fig2_2", "flank_lab", "junction"])
def test_where_values_are_kept_over_a_power_cut_signals_stand_at_proceed(name: str) -> None:
    bench = bench_of(name)
    shown = at_proceed(bench)
    kept = bench.moment()
    bench.restart()
    bench.back(kept)
    bench.wait(3600)
    assert shown and bench.proceeds() == shown and not_locked_up(bench) != []
    bench.restart()
    bench.scans(FEW)
    assert not_locked_up(bench) == [] and bench.proceeds() == []


def test_where_everything_begins_as_false_nothing_is_locked_and_no_delay_runs() -> None:
    """So a tool does that passes over the initial values of members of structures."""
    bench = bench_of("fig2_2")
    row = built("fig2_2")[1].routes[0]
    bench.restart()
    c = bench.moment()
    kinds = {k: type(v) for k, v in c.state.items()}
    bench.back(type(c)({k: kinds[k](0) for k in c.state}, c.elapsed, c.inputs, c.lies, c.outputs))
    bench.wait(10)
    bench.scan({str(bench.symbols.requests.request): row.number})
    assert bench.until(lambda: bool(bench.proceeds()), 10)


def begun(name: str) -> list[Step]:
    layout, table, controller = built(name)
    steps = book(layout, table, controller, allocate(layout, controller), runtime_py(controller, []))
    return [s for s in takewhile(lambda s: s.sheet in (Sheet.WIRES, Sheet.START), steps) if s.sheet is Sheet.START]


@pytest.mark.parametrize("name", [n for n in SHIPPED if n != "cn6502"])
def test_a_power_cut_with_a_route_open_is_among_the_tests(name: str) -> None:
    steps = begun(name)
    cut, then = steps[-2:]
    assert "cut the power of the controller" in cut.do and "at proceed" in cut.do
    assert cut.expect == steps[0].expect
    assert "before the restart delay" in then.do and "every section stays locked" in then.expect
    assert [(s.number, s.came) for s in steps if s.came or not s.tried] == []


def test_a_controller_that_keeps_its_values_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Bench, "restart", lambda self: None)
    cut, then = begun("fig2_2")[-2:]
    assert cut.came == "X1 does not show stop; P1 is driven" and then.came == "route X1-A is set"
