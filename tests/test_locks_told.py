"""What is told of locks and holds is told of the routes that are set, and of no others."""

from __future__ import annotations

import pytest

from interlock.app.reasons import Moment, Reasons
from interlock.field.plc import Memory
from interlock.table.cells import Role
from tests.layouts import built


@pytest.mark.parametrize("name", ["heishan", "depot", "flank_lab"])
def test_a_section_is_locked_for_the_route_that_is_set_over_it(name: str) -> None:
    layout, _, controller = built(name)
    reasons, y = Reasons(layout, controller), controller.symbols
    several = {way: routes for way, routes in y.routes.over.items() if len(routes) > 1}
    assert several
    for (s, k), routes in several.items():
        for r in routes:
            assert reasons.holders(s, k, {str(r.active): True}) == (str(r.id),)
        assert reasons.holders(s, k, {}) == ()


@pytest.mark.parametrize("name", ["flank_lab", "depot"])
def test_what_holds_points_as_flank_protection_is_told(name: str) -> None:
    """With the lock of a way that demands them for its flank, and with nothing else."""
    layout, table, controller = built(name)
    reasons, y = Reasons(layout, controller), controller.symbols
    clear = {str(n): 1 for n in (*y.sections.clear.values(), y.valid)}
    found = 0
    for t in table.locks:
        for p in t.points:
            if p.role is not Role.FLANK or t.section in layout.machines.sections[p.machine]:
                continue
            state = {str(y.sections.lock[t.section, t.number]): True}
            lies = {str(n): int(x is p.position) for (m, x), n in y.machines.detected.items() if m == p.machine}
            told = reasons.of_hold(p.machine, Moment({**clear, **lies}, Memory(state, {}), 100))
            assert any("flank protection" in r.text and str(t.section) in r.text for r in told), (p.machine, told)
            found += 1
    assert found


def test_what_is_gone_past_the_second_signal_is_told_too() -> None:
    layout, _, controller = built("../tests/layouts_for_tests/identifiers")
    reasons, y = Reasons(layout, controller), controller.symbols
    long = next(
        r for r in y.routes if r.path.onward is not None and y.routes.number[r.path.onward].path.onward is not None
    )
    second = y.routes.number[long.path.onward]
    third = y.routes.number[second.path.onward]
    state = {str(long.active): True, str(second.active): True}
    (told,) = reasons.of_stop(long.number, Moment({}, Memory(state, {}), 100))
    assert told.text.startswith(f"what lies past {third.entry} is no longer set: cancel {long.entry}")


def test_a_route_that_is_being_cancelled_is_waited_for_and_one_that_is_set_is_cancelled_first() -> None:
    layout, _, controller = built("heishan")
    reasons, y = Reasons(layout, controller), controller.symbols
    r = y.routes.number[1]
    cancelling = {str(y.cancellation.cancelling[r.entry]): True}
    assert reasons._cancel_first(r, Moment({}, Memory({}, {}), 0)).text == f"route {r.id} is set: cancel it first"
    assert reasons._cancel_first(r, Moment({}, Memory(cancelling, {}), 0)).text.endswith(
        "being cancelled: wait for that"
    )
