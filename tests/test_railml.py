"""The table with the element names of railML: nothing of what a route locks or asks for is left out."""

from __future__ import annotations

import json
from typing import Any

import pytest

from interlock.emit.tables.railml import railml_json
from interlock.table.cells import Role
from interlock.table.rows import RouteRow
from tests.layouts import SHIPPED, built

OTHERS = ("added", "air_lock_doors", "clear_beyond", "devices", "driven", "spaces", "swing", "swing_condition", "token")


def named(x: Any) -> set[str]:
    """Every element that something refers to."""
    if isinstance(x, list):
        return set().union(*map(named, x))
    if not isinstance(x, dict):
        return set()
    found = {str(x["refersTo"])} if isinstance(x.get("refersTo"), str) else set()
    return found.union(map(str, x.get("hasTvdSection", ())), *map(named, x.values()))


def asked(r: RouteRow) -> set[str]:
    """Sections, conditions, zones and lines of which a route asks something."""
    sections = [*r.clear.sections, *r.clear.foul, *(r.clear.demanded or ()), *r.conditions.block]
    found = {str(c.section) for c in sections} | {str(c.name) for c in r.clear.space}
    found |= {str(c.condition) for c in r.conditions.external} | {str(z.zone) for z in r.conditions.zones}
    found |= {str(p.machine) for p in r.locking.driven}
    if r.conditions.token is not None:
        found.add(str(r.conditions.token.boundary))
    if r.locking.overlap is not None:
        found |= {str(s) for s, _ in r.locking.overlap.ways}
    return found


@pytest.mark.parametrize("name", [*SHIPPED, *(f"../tests/layouts_for_tests/{x}" for x in OTHERS)])
def test_everything_that_a_route_locks_and_asks_for_is_there(name: str) -> None:
    layout, table, _ = built(name)
    body = json.loads(railml_json(layout, table))
    routes = {r["id"]: r for r in body["routes"]}
    relations = {r["refersToRoute"]: r for r in body["routeRelations"]}
    ends = layout.machines.ends
    for r in table.routes:
        there = named(routes[r.id]) | named(relations[r.id])
        assert asked(r) <= there, r.id
        for p in r.locking.points:
            told = {str(p.machine), *(str(e.id) for e in ends.get(p.machine, ()) if e.derailer)}
            assert told & there, (r.id, p)


def test_points_of_an_overlap_stand_with_it() -> None:
    layout, table, _ = built("../tests/layouts_for_tests/swing")
    routes = {r["id"]: r for r in json.loads(railml_json(layout, table))["routes"]}
    found = 0
    for r in table.routes:
        if r.locking.overlap is not None:
            own = [(p.machine, p.position) for p in r.locking.points if p.role is Role.OVERLAP]
            said = routes[r.id]["routeExit"]["hasOverlap"]["switchInPosition"]
            assert [(x["refersTo"], x["inPosition"][0].upper()) for x in said] == [(m, str(at)) for m, at in own]
            found += len(own)
    assert found > 2
