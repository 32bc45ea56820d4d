"""`berth: no`: a road into which shunting movements come only when it is clear, as many tables have every road."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.proof.engines.limits import Limits
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.proof.witnesses.routes import witnesses
from interlock.verify import Rejected
from tests.layouts import built, grown
from tests.test_release_behind import Bench
from tests.written import told

YARD = Path("tests/layouts_for_tests/shunt_yard.yaml").read_text("utf-8")
TURN = """
interlock: 1
name: turn
boundaries:
  W: {trains: in, approach: wa 600}
  E: {trains: TRAINS}
tracks:
  one: [W, g1 250, 1.normal]
  two: [B, g2 250, 1.reverse]
  out: [1.toe, line 200, E]
buffers: [B]
points:
  1: {section: t1}
signals:
  A: {from: W, into: g1}
  N: {from: g1, into: t1, kind: combined}
  D: {from: line, into: t1, kind: shunt}
  M: {from: g2, into: t1, kind: shunt}
sections:
  line: {berth: no}
"""
"""Shunting movements turn on the running line, before the boundary, once it is clear."""
DENIED = YARD + "sections:\n  g1: {berth: no}\n  l2: {berth: no}\n"


def clear(text: str, route: str) -> list[str]:
    """The sections that must be clear for a route."""
    made = grown(text)
    assert made is not None
    layout, table, _ = made
    assert audit(layout, table) == ()
    return [str(c.section) for c in table.route[RouteId(route)].clear.sections]


def test_shunting_movements_need_a_road_clear_that_is_no_berth() -> None:
    assert clear(YARD, "D2-E1") == ["p1"] and clear(DENIED, "D2-E1") == ["p1", "g1"]
    assert clear(YARD, "S2-D3.s") == ["p1"] and clear(DENIED, "S2-D3.s") == ["p1", "l2"]
    assert clear(DENIED, "D2-E2") == clear(YARD, "D2-E2") == ["p1"], "g2 stays a berth"


@pytest.mark.parametrize("trains", ["out", "in", "both, block: token"])
def test_shunting_movements_end_before_a_boundary_in_clear_track(trains: str) -> None:
    text = TURN.replace("TRAINS", trains)
    if trains != "out":
        text = text.replace("  D:", "  Z: {from: E, into: line}\n  D:")
    made = grown(text)
    assert made is not None and not any("a shunting movement" in d.message for d in made[2].diagnostics)
    layout, table, _ = made
    assert audit(layout, table) == ()
    route = table.route[RouteId("N-line.s")]
    assert [c.section for c in route.clear.sections] == ["t1", "line"] == list(
        route.path.section_ids
    ) and route.path.berth is None
    assert {"M-line", "N-line.s"} <= {str(r.id) for r in table.routes}
    assert prove(System(layout, lower(layout, table)), limits=Limits(search_s=0)).proved
    assert agree(*told(text), specification.shipped()).left == ()


@pytest.mark.parametrize("approach", ["", ", approach: ea 600"])
def test_vehicles_come_in_over_a_boundary_at_a_shunt_signal(approach: str) -> None:
    """Trains leave there; no train comes in.  Outside nothing is locked that its use could be asked of (R9)."""
    text = TURN.replace("TRAINS", f"both{approach}").replace(
        "  D: {from: line, into: t1, ", "  D: {from: E, into: line, stops_trains: yes, "
    )
    text = text.replace("sections:\n  line: {berth: no}\n", "")
    made = grown(text)
    assert made is not None
    layout, table, _ = made
    assert audit(layout, table) == ()
    assert {"A-N", "D-B.s", "D-g1.s", "N-E"} == {str(r.id) for r in table.routes}
    system = System(layout, lower(layout, table))
    assert prove(system, limits=Limits(search_s=0)).proved
    assert all(w.ok for w in witnesses(system.loop))
    assert agree(*told(text), specification.shipped()).left == ()


def test_it_is_proved_and_the_second_checker_agrees() -> None:
    made = grown(DENIED)
    assert made is not None
    layout, table, _ = made
    assert prove(System(layout, lower(layout, table)), limits=Limits(search_s=0)).proved
    assert agree(*told(DENIED), specification.shipped()).left == ()


@pytest.mark.parametrize(("one", "other"), [(YARD, DENIED), (DENIED, YARD)])
def test_a_controller_that_has_another_berth_is_not_accepted(one: str, other: str) -> None:
    _, system, text = told(one)
    with pytest.raises(Rejected):
        agree(loaded(other), system, text, specification.shipped())


def test_where_no_berth_is_none_is_denied() -> None:
    made = grown(YARD + "sections:\n  p1: {berth: no}\n")
    assert made is not None
    assert [d.message for d in made[2].diagnostics if d.code == "IL3031"] == ["p1 is no berth anyway: points lie in it"]
    assert "IL3031" not in {d.code for d in grown(DENIED)[2].diagnostics}  # type: ignore[index]


def test_a_layout_that_denies_none_has_the_digest_that_it_had() -> None:
    one, other = grown(YARD), grown(YARD + "sections:\n  g1: {berth: yes}\n")
    assert one is not None and other is not None and one[0].digest == other[0].digest


def test_another_movement_is_set_into_a_berth_when_the_section_in_rear_is_steadily_clear() -> None:
    """Vehicles shunted from l1 stand or run across the joint of l1 and l2, into which others are to be shunted from the
    far end.  A moment in which l1 reads clear is none in which they have come in (R15)."""
    b = Bench(built("../tests/layouts_for_tests/shunt_yard")[2])
    b.go(5, CLR_l1=0, **{n: 1 for n in b.inputs if n.startswith("RL_")})
    b.ask("D1-D2")
    assert b.outputs["YW_D1"]
    b.go(5, CLR_l2=0)
    b.go(0.2, CLR_l1=1, REQ=b.routes["S1-D3.s"])
    assert b.controller.why_not("S1-D3.s") is not None
    b.go(2, CLR_l1=0, REQ=0)
    assert not b.outputs["YW_S1"]
    b.go(4, CLR_l1=1)
    b.ask("S1-D3.s")
    assert b.outputs["YW_S1"]


HALVES = """interlock: 1
name: halves
boundaries:
  W: {approach: wa 800}
  E: {approach: ea 800}
tracks: {line: [W, w1 250, pA 200, pB 200, e1 250, E]}
signals:
  X0: {from: W, into: w1}
  X1: {from: w1, into: pA, kind: combined}
  MA: {from: pA, into: pB, kind: combined}
  MB: {from: pB, into: pA, kind: combined}
  X3: {from: pB, into: e1, kind: combined}
  Y0: {from: E, into: e1}
  Y1: {from: e1, into: pB, kind: combined}
  Y3: {from: pA, into: w1, kind: combined}
"""


def test_a_shunt_route_over_a_berth_alone_asks_for_it_clear_and_one_over_a_section_before_it_does_not() -> None:
    """R2 said of every berth that it need not be clear.  Nothing but ways before the berth is locked for the route."""
    drawn = HALVES.replace("pA 200, pB", "pA 180, pc 20, pB").replace("from: pA, into: pB", "from: pA, into: pc")
    drawn = drawn.replace("from: pB, into: pA", "from: pB, into: pc")
    for text, over, clear, berth in ((HALVES, ("pB",), ["pB"], None), (drawn, ("pc", "pB"), ["pc"], "pB")):
        made = grown(text)
        assert made is not None and not made[2].has_errors and audit(made[0], made[1]) == ()
        route = made[1].route[RouteId("MA-X3.s")]
        assert (route.path.section_ids, [c.section for c in route.clear.sections]) == (over, clear)
        assert route.path.berth == berth and len(route.path.locked) == 1
        assert prove(System(made[0], lower(made[0], made[1])), Limits(search_depth=0)).proved
