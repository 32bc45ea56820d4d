"""What a planned route asks of other trains, against the row of the table: a plan must not count on what the controller
refuses."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from interlock.dispatch.plan.errands import OUTSIDE, Errand, Leg, Place
from interlock.dispatch.plan.held import Held
from interlock.dispatch.plan.railway import Railway
from interlock.model.elements import RouteId, SectionId
from interlock.model.layout import Layout
from interlock.model.traversal import topology
from interlock.table.rows import InterlockingTable, RouteRow
from tests.layouts import SHIPPED, built, grown


def with_more(name: str, more: str) -> tuple[Layout, InterlockingTable]:
    """A shipped layout with more lines before its signals."""
    text = Path(f"layouts/{name}.yaml").read_text("utf-8")
    made = grown(text.replace("signals:", f"{more}signals:", 1))
    assert made is not None
    return made[0], made[1]


def asked_clear(r: RouteRow) -> Iterator[SectionId]:
    """The sections that must be clear, wherever points lie that the route does not lock: path, overlap, foul sections,
    flank space, the line beyond, what is added."""
    yield from (c.section for c in r.clear.sections if c.section != r.path.berth)
    yield from (s for s, _ in (r.locking.overlap.ways if r.locking.overlap is not None else ()))
    lies = {(p.machine, p.position) for p in r.locking.points}
    yield from (f.section for f in r.clear.foul if f.when is None or (f.when[0], f.when[1].other) not in lies)
    yield from (SectionId(c.name) for c in r.clear.space if not c.lamp)
    yield from (b.section for b in r.conditions.block)
    yield from (c.section for c in r.clear.demanded or ())


MORE = {
    "passing_loop": "demand:\n  - {clear: 3G, routes: {from: S1}, reason: oversize loads}\n",
}


@pytest.mark.parametrize("name", SHIPPED)
def test_no_route_is_planned_while_somebody_stands_where_it_must_be_clear(name: str) -> None:
    layout, table = with_more(name, MORE[name]) if MORE.get(name) else built(name)[:2]
    held, topo = Held(table, layout), topology(layout)
    outside = {b.approach for b in layout.track.boundaries}
    for r in table.routes:
        needs = held.needs(r)
        for s in asked_clear(r):
            if s in outside:
                assert ("section", s) in needs, (r.id, s)
            for t in topo.traversals.get(s, ()):
                assert needs & held.holds([t.key]), (r.id, s)


def test_what_the_author_declares_hostile_is_not_planned_together() -> None:
    """From when one of them is set until its train is wholly in the last section."""
    hostile = "hostile:\n  - {one: {from: S1}, other: {from: S3}, reason: one crew works both}\n"
    one, other = RouteId("S1-W"), RouteId("S3-W")
    for more, apart in (("", False), (hostile, True)):
        layout, table = with_more("passing_loop", more)
        under_way = Place(0, frozenset(), one, ((SectionId("IAG"), 1),), frozenset({one} if more else ()))
        held = Held(table, layout)
        things = held.under_way(under_way) - held.holds(under_way.under)
        assert bool(things & held.needs(table.route[other])) is apart


def test_a_train_keeps_its_overlap_until_all_of_it_stands_before_the_signal() -> None:
    layout, table, _ = built("flank_lab")
    held, r = Held(table, layout), table.route[RouteId("S1-N2")]
    assert r.locking.overlap is not None
    overlap = {("locked", s) for s, _ in r.locking.overlap.ways}
    last, before = r.path.traversals[-1], r.path.traversals[-2]
    long, short = (Place(0, frozenset(), r.id, under) for under in ((before, last), (last,)))
    assert overlap <= held.kept(long) and not held.kept(short)


def test_a_train_turns_where_all_of_it_stands_in_one_section() -> None:
    """One whose rear is in the section behind stands past the signal that it would turn to."""
    layout, table, _ = built("passing_loop")
    railway, r = Railway(table, layout), table.route[RouteId("X-X1")]
    before, last = r.path.traversals[-2:]
    for under, turned in (((last,), {"S1-W"}), ((before, last), set())):
        found = railway.routes_on(Place(1, frozenset(), r.id, under), True)
        assert {x.id for x, turns in found if turns} == turned
        assert "X1-E" in {x.id for x, turns in found if not turns}


def test_of_two_trains_outside_the_one_that_came_first_is_in_the_way_of_the_other() -> None:
    layout, table, _ = built("passing_loop")
    railway = Railway(table, layout)
    first, second = (Errand(name, 100.0, ((SectionId("W"), OUTSIDE),), (Leg("E"),)) for name in ("1", "2"))
    a, b = railway.draft(first).nodes(), railway.draft(second).nodes(["1"])
    queue = ("queue", "1")
    assert queue in a.holds[a.start] and all(queue in needs for _, _, needs, _ in b.moves[b.start])
    assert not any(("queue", "2") in needs for _, _, needs, _ in a.moves[a.start])
    assert all(queue not in a.holds[place] for place in a.holds if place != a.start)
