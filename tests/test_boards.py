"""Where routes end without a main signal: stop boards, limit-of-shunt boards, shunt signals at which trains end."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.emit.drawing.svg import plan_svg
from interlock.emit.io import equipment_csv
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.table.columns import COLUMNS
from interlock.verify import Rejected
from tests.campaigns.simulate import Case, drive
from tests.test_stations import proved, said
from tests.written import told

PATH = Path("tests/layouts_for_tests/boards.yaml")
TEXT = PATH.read_text("utf-8")
ENDS = {"H": "kind: board", "D2": "kind: shunt, stops_trains: yes"}


def test_trains_end_at_a_stop_board_and_at_a_shunt_signal_and_movements_at_a_limit_of_shunt() -> None:
    layout, table, codes = said(TEXT)
    routes = set(table.route)
    assert codes == set() and proved(layout, table)
    assert {"A2-H", "A2-D2"} <= routes, "trains end there"
    assert {"N1-LS.s", "N2-LS.s"} <= routes and {"N1-W", "N2-W"} <= routes, "movements end there, trains run past"
    assert {r.entry for r in table.routes} & {"H", "LS"} == set(), "nothing begins at a board"
    assert {r.kind for r in table.routes if r.entry == "D2"} == {"shunt"}
    ends = [table.route[RouteId(r)].because.text for r in ("A2-H", "N1-LS.s", "A2-D2")]
    assert ends == [
        "found from A2 to stop board H",
        "found from N1 to limit-of-shunt board LS",
        "found from A2 to signal D2",
    ]
    aspect = {c.key: c for c in COLUMNS}["aspect"]
    assert [aspect.text(table.route[RouteId(r)]) for r in ("A2-H", "A2-D2")] == ["caution", "caution"]


def test_a_board_has_neither_wire_nor_lamp_and_is_counted_and_drawn() -> None:
    layout, table, _ = said(TEXT)
    controller = lower(layout, table)
    names = {o.name for o in controller.outputs}
    assert {n for n in names if n.endswith(("_H", "_LS"))} == set()
    assert {n for n in names if n.endswith("_D2")} == {"YS_D2", "YW_D2"}, "no lamp for trains"
    items = dict(line.rsplit(",", 1) for line in equipment_csv(layout, allocate(layout, controller)).splitlines())
    assert (items["stop board"], items["limit-of-shunt board"], items['"signal, shunt"']) == ("1", "1", "3")
    plan = plan_svg(layout)
    for board in ("H", "LS"):
        drawn = plan[plan.index(f'id="signal-{board}"') :].split("</g>")[0]
        assert "lamp" not in drawn


def test_a_berth_may_lie_between_a_signal_and_a_board() -> None:
    """Shunting movements end before the board among vehicles that stand there; a train needs the berth clear."""
    _, table, _ = said(TEXT)
    ends = {r: table.route[RouteId(r)] for r in ("N1-LS.s", "N1-W", "A2-H.s", "A2-H")}
    assert {r: x.path.berth for r, x in ends.items()} == {"N1-LS.s": "w2", "N1-W": None, "A2-H.s": "k1", "A2-H": None}
    clear = {r: {s.section for s in x.clear.sections} for r, x in ends.items()}
    assert "w2" in clear["N1-W"] and "w2" not in clear["N1-LS.s"]
    assert "k1" in clear["A2-H"] and "k1" not in clear["A2-H.s"]


@pytest.mark.parametrize("name", ENDS)
def test_a_controller_that_knows_nothing_of_the_board_is_not_accepted(name: str) -> None:
    """The same place as a shunt signal, past which trains run: other routes, other claims."""
    assert agree(*told(TEXT), specification.shipped()).left == ()
    other = TEXT.replace(ENDS[name], "kind: shunt")
    assert other != TEXT
    layout, _, _ = said(TEXT)
    _, table, _ = said(other)
    assert audit(layout, replace(table, layout_digest=layout.digest)) != ()
    _, system, text = told(other)
    with pytest.raises(Rejected):
        agree(loaded(TEXT), system, text, specification.shipped())


@pytest.mark.parametrize("hostile", [False, True])
def test_drivers_stop_at_boards(hostile: bool) -> None:
    outcome = drive(Case.of(str(PATH)), 2500, 7, hostile)
    assert outcome.hazards == [] and outcome.passed_at_stop == [] and outcome.movements > 2
