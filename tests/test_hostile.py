"""Which routes are hostile is found for all pairs at once; what makes a pair hostile, pair by pair: they agree."""

from __future__ import annotations

import random
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import pytest

from interlock.app.init import line, yard
from interlock.audit import audit
from interlock.derivation import pipeline
from interlock.derivation.conflicts import Conflicts, classify
from interlock.model.bits import bits
from interlock.model.elements import RouteId
from interlock.table.cells import Hostile, HostileRoutes
from tests import layouts
from tests.grow import grow
from tests.layouts import SHIPPED, built, grown

TEXTS = {
    **{name: Path(f"layouts/{name}.yaml").read_text(encoding="utf-8") for name in SHIPPED},
    **{
        name: Path(f"tests/layouts_for_tests/{name}.yaml").read_text(encoding="utf-8")
        for name in ("overlap_past_signals", "overlap_past_both_ways", "overlaps_join")
    },
    "yard": yard(9),
    "line": line(3),
    **{f"seed {n}": grow(n) for n in range(40)},
}


@pytest.mark.parametrize("name", TEXTS)
def test_a_pair_is_hostile_if_something_makes_it_so(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[Conflicts] = []

    class Kept(Conflicts):
        def __init__(self, *given: object) -> None:
            super().__init__(*given)  # type: ignore[arg-type]
            self.given = given
            made.append(self)

    monkeypatch.setattr(pipeline, "Conflicts", Kept)
    layouts._grown.cache_clear()  # derived here, whatever was before
    found = grown(TEXTS[name])
    if found is None:
        return  # refused by the front end
    conflicts, table = made[0], found[1]
    layout, paths, locks, _, _ = conflicts.given  # type: ignore[attr-defined]
    needs = conflicts._needs
    pairs = [(a.id, b.id) for a, b in combinations(paths, 2) if classify(layout, a, b, locks, needs) is not None]
    listed = {r.id: r.locking.hostile.routes for r in table.routes}
    assert [(a.id, b.id) for a, b in combinations(paths, 2) if b.id in listed[a.id]] == pairs
    assert all(a in listed[b] for a, b in pairs) and sum(map(len, listed.values())) == 2 * len(pairs)


def test_hostile_routes_stand_in_order_and_tell_what_they_share() -> None:
    found = grown(TEXTS["passing_loop"])
    assert found is not None
    table = found[1]
    for r in table.routes:
        assert [h.route for h in r.locking.hostile] == list(r.locking.hostile.routes)
        assert [table.route[x].number for x in r.locking.hostile.routes] == sorted(
            table.route[x].number for x in r.locking.hostile.routes
        )
        assert all(h.witness and h.because.text.startswith(f"{r.id} and {h.route}: ") for h in r.locking.hostile)


@pytest.mark.parametrize("name", ["cn6502", "pit_bottom"])
def test_the_audit_finds_each_pair_that_is_missing_or_too_much(name: str) -> None:
    layout, table, _ = built(name)
    ids = [r.id for r in table.routes]
    chance = random.Random(name)
    for r, other in chance.sample([(r, x) for r in table.routes for x in ids if x != r.id], 40):
        hostile = set(r.locking.hostile.routes) ^ {other}
        wrong = replace(
            r,
            locking=replace(
                r.locking, hostile=HostileRoutes(ids, bits(n for n, x in enumerate(ids) if x in hostile), told)
            ),
        )
        findings = audit(layout, replace(table, routes=tuple(wrong if x is r else x for x in table.routes)))
        (found,) = [x for x in findings if x.column == "hostile"]
        assert found.route == r.id
        assert found.text.startswith(f"{other} is {'not ' if other in hostile else ''}hostile")


def told(other: RouteId) -> Hostile:
    raise AssertionError(f"the audit does not ask what makes {other} hostile")
