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
from interlock.verify import Rejected
from tests.layouts import grown
from tests.written import told

YARD = Path("tests/layouts_for_tests/shunt_yard.yaml").read_text("utf-8")
DENIED = YARD + "sections:\n  g1: {berth: no}\n  l2: {berth: no}\n"


def clear(text: str, route: str) -> list[str]:
    """The sections that must be clear for a route."""
    made = grown(text)
    assert made is not None
    layout, table, _ = made
    assert audit(layout, table) == ()
    return [str(c.section) for c in table.route[RouteId(route)].sections]


def test_shunting_movements_need_a_road_clear_that_is_no_berth() -> None:
    assert clear(YARD, "D2-E1") == ["p1"] and clear(DENIED, "D2-E1") == ["p1", "g1"]
    assert clear(YARD, "S2-D3.s") == ["p1"] and clear(DENIED, "S2-D3.s") == ["p1", "l2"]
    assert clear(DENIED, "D2-E2") == clear(YARD, "D2-E2") == ["p1"], "g2 stays a berth"


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
