"""Tables in which a cell was changed by hand, and the audit that notices."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.model.layout import Layout
from interlock.table.cells import FlankCell, Provider, ProviderKind
from interlock.table.rows import InterlockingTable, RouteRow
from tests.layouts import grown


@cache
def made(name: str) -> tuple[Layout, InterlockingTable]:
    """A layout for tests and its table, in which the audit sees the same."""
    found = grown(Path(f"tests/layouts_for_tests/{name}.yaml").read_text("utf-8"))
    assert found is not None
    layout, table, sink = found
    assert not sink.has_errors and audit(layout, table) == ()
    return layout, table


def longer(r: RouteRow) -> RouteRow:
    return replace(r, path=replace(r.path, length=r.path.length + 1))


def overlap_longer(r: RouteRow) -> RouteRow:
    assert r.locking.overlap is not None
    return replace(r, locking=replace(r.locking, overlap=replace(r.locking.overlap, metres=150.0)))


def with_flank(r: RouteRow, *cells: FlankCell) -> RouteRow:
    return replace(r, locking=replace(r.locking, flank=cells))


def told_twice(r: RouteRow) -> RouteRow:
    return with_flank(r, *r.locking.flank, *r.locking.flank)


def by(r: RouteRow, kind: ProviderKind, name: str) -> RouteRow:
    (cell,) = r.locking.flank
    return with_flank(r, replace(cell, providers=(Provider(kind, name),)))


@pytest.mark.parametrize(
    ("column", "edit"),
    [
        ("length", longer),
        ("length", overlap_longer),
        ("flank", with_flank),
        ("flank", told_twice),
        ("flank", lambda r: by(r, ProviderKind.SIGNAL, "X")),
        ("flank", lambda r: by(r, ProviderKind.BUFFER, "E")),
        ("flank", lambda r: by(r, ProviderKind.POINT, "1")),
        ("flank", lambda r: by(r, ProviderKind.WAIVED, "it is level there")),
    ],
)
def test_a_wrong_length_and_wrong_flank_protection_are_found(column: str, edit) -> None:  # type: ignore[no-untyped-def]
    layout, table = made("overlap_inside")
    r = next(r for r in table.routes if r.id == "A-X.o2")
    wrong = replace(table, routes=tuple(edit(x) if x is r else x for x in table.routes))
    assert {(f.route, f.column) for f in audit(layout, wrong)} == {("A-X.o2", column)}


def test_a_level_crossing_that_is_open_for_a_train_is_found() -> None:
    layout, table = made("devices")

    def opened(r: RouteRow) -> RouteRow:
        points = (replace(p, position=p.position.other) if p.role == "device" else p for p in r.locking.points)
        return replace(r, locking=replace(r.locking, points=tuple(points)))

    over = {r.id for r in table.routes if any(p.role == "device" for p in r.locking.points)}
    wrong = replace(table, routes=tuple(map(opened, table.routes)))
    found = {(f.route, f.column) for f in audit(layout, wrong)}
    assert over and {(r, "devices") for r in over} <= found


def test_a_place_that_needs_no_protection_has_none() -> None:
    layout, table = made("overlap_inside")
    short, long = (next(r for r in table.routes if r.id == i) for i in ("A-X", "A-X.o2"))
    wrong = replace(table, routes=tuple(with_flank(x, *long.locking.flank) if x is short else x for x in table.routes))
    assert [(f.route, f.column) for f in audit(layout, wrong)] == [("A-X", "flank")]


def test_round_a_balloon_loop_a_vehicle_comes_back_the_other_way() -> None:
    """From W18 over P9 into the loop, round it, and back over P9 to the end of P15 that the route does not use."""
    _, table = made("balloon")
    (cell,) = next(r for r in table.routes if r.id == "X22-B23").locking.flank
    assert {p.name for p in cell.providers} == {"G24", "W17", "X20"}
