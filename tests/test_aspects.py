"""What a signal shows, and what of it has to be proved to light (R11)."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.checker.specification import shipped
from interlock.commissioning.book import book
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.mutation import forgotten
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.verify import Rejected
from tests.layouts import grown
from tests.test_requests import TWO, number, on, simulator, steps
from tests.written import told

CN = TWO.replace("name: two", "name: two\nprofile: cn")
LIT = {"CLR_wa": 1}
FORK = Path("tests/layouts_for_tests/indicator.yaml").read_text("utf-8")


@pytest.mark.parametrize(("route", "yellows"), [("X2-X4", {"YY_X2", "YU_X2"}), ("X2-X3", {"YY_X2"})])
def test_two_yellows_lead_over_reversed_points_and_one_straight_on(route: str, yellows: set[str]) -> None:
    """The signal at the end is at stop either way: by the second yellow lamp alone the driver knows."""
    sim = simulator(CN)
    steps(sim, 1, REQ=number(sim, route))
    steps(sim, 8, **LIT)
    assert {x for x in ("YP_X2", "YY_X2", "YU_X2") if on(sim, x)} == yellows


def test_a_departure_over_reversed_points_onto_a_checked_line_shows_green() -> None:
    sim = simulator(CN)
    steps(sim, 1, REQ=number(sim, "X4-E"))
    steps(sim, 8, **LIT)
    assert on(sim, "YP_X4") and not any(str(o.name) == "YU_X4" for o in sim.controller.outputs)


@pytest.mark.parametrize("dark", ["CL_X2", "UL_X2"])
def test_with_one_of_two_yellows_dark_the_signal_shows_stop(dark: str) -> None:
    """One yellow would let the train run over the turnout as fast as straight on."""
    sim = simulator(CN)
    steps(sim, 1, REQ=number(sim, "X2-X4"))
    steps(sim, 8, **LIT)
    assert on(sim, "YU_X2")
    assert "YS_X2" in steps(sim, 1, **{dark: 0})[-1]
    assert "YS_X2" in steps(sim, 3)[-1], "it does not open again by itself"


def test_with_its_second_yellow_dark_a_signal_opens_straight_on() -> None:
    sim = simulator(CN)
    steps(sim, 1, REQ=number(sim, "X2-X3"), UL_X2=0)
    steps(sim, 8, **LIT, UL_X2=0)
    assert on(sim, "YY_X2")


@pytest.mark.parametrize(("route", "shown"), [("X2-X4", False), ("X2-X3", True)])
def test_with_its_speed_indicator_dark_a_signal_opens_only_where_it_has_no_speed_to_show(
    route: str, shown: bool
) -> None:
    """A dark indicator permits any speed."""
    slow = TWO.replace("name: two", "name: two\nprinciples: {lamp_proof: yes}").replace(
        "reverse: even.start}", "reverse: even.start, speed: 40}"
    )
    sim = simulator(slow)
    steps(sim, 1, REQ=number(sim, route), VL_X2=0)
    steps(sim, 8, **LIT, VL_X2=0)
    assert on(sim, "YS_X2") is not shown
    sim = simulator(slow)
    steps(sim, 1, REQ=number(sim, route))
    steps(sim, 8, **LIT)
    assert on(sim, "YV40_X2") is not shown and not on(sim, "YS_X2")


def test_without_proof_of_lamps_there_is_no_input_for_them() -> None:
    bare = grown(CN.replace("profile: cn", "profile: cn\nprinciples: {lamp_proof: no}"))
    assert bare is not None
    names = {str(i.name) for i in lower(bare[0], bare[1]).inputs}
    assert not {n for n in names if n.startswith(("UL_", "VL_", "RL_"))}


def test_a_controller_that_never_lights_the_second_yellow_is_refuted_by_both() -> None:
    made = grown(CN)
    assert made is not None
    layout, table, _ = made
    dark = [c for where, c in forgotten.second_dark(layout, table) if where == "X2"]
    found = prove(System(layout, dark[0]), Limits(search_depth=0))
    assert [c.id for c in found.claims if c.verdict is not Verdict.PROVED and c.id.startswith("S-")] == ["S-ASPECT"]


def test_the_second_checker_asks_for_the_second_yellow_by_itself() -> None:
    assert agree(*told(CN), shipped()).left == ()
    one_yellow = CN.replace("profile: cn", "profile: cn\nprinciples: {caution: next}")
    with pytest.raises(Rejected, match="S-ASPECT"):
        agree(loaded(CN), *told(one_yellow)[1:], shipped())


def test_filaments_and_indicator_are_tried_when_it_is_commissioned() -> None:
    made = grown(CN.replace("reverse: even.start}", "reverse: even.start, speed: 40}"))
    assert made is not None
    layout, table, _ = made
    controller = lower(layout, table)
    steps_ = list(book(layout, table, controller, allocate(layout, controller), runtime_py(controller, [])))
    tried = {s.do for s in steps_ if not s.came and "X2" in s.do}
    for lamp in ("the caution lamp of X2 out", "the second yellow lamp of X2 out", "the speed indicator of X2 out"):
        assert any(lamp in do for do in tried), lamp
    assert any("two yellows and 40 km/h (YY_X2, YU_X2, YV40_X2)" in s.expect for s in steps_)
    assert [(s.number, s.do, s.came) for s in steps_ if s.came] == []


def test_a_route_indicator_tells_departures_in_the_branching_direction_and_no_others() -> None:
    """The Chinese form printed B, and there was no lamp for it."""
    sim = simulator(FORK)
    for route, lit in (("X2-E", {"YP_X2"}), ("X2-F", {"YP_X2", "YB_X2"})):
        steps(sim, 1, REQ=number(sim, route))
        steps(sim, 8, **LIT)
        assert {x for x in ("YP_X2", "YY_X2", "YB_X2") if on(sim, x)} == lit, route
        steps(sim, 1, CAN_X2=1, **LIT)
        steps(sim, 6, **LIT)
    made = grown(FORK)
    assert made is not None and made[1].route[RouteId("X2-F")].signal.aspect.indicator
    assert audit(made[0], made[1]) == () and agree(*told(FORK), shipped()).left == ()
    with pytest.raises(Rejected, match="S-ASPECT"):
        agree(loaded(FORK), *told(FORK.replace(", indicator: yes", ""))[1:], shipped())
    dark = next(c for _, c in forgotten.indicator_dark(made[0], made[1]))
    found = prove(System(made[0], dark), Limits(search_depth=0))
    assert {c.id for c in found.claims if c.verdict is not Verdict.PROVED and c.id.startswith("S-")} == {"S-ASPECT"}
