"""What must become of the table when the layout is changed: an opinion that needs no second derivation.

The same layout in other words has the same table: under other names, in another order, written from the other ends of
its tracks, with points called the other way round, with sections in pieces; so has each of two layouts that lie beside
each other.  A section in two halves keeps what is hostile and what protects; a stricter rule never sets free.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.model.principles import Caution
from interlock.model.traversal import topology
from tests.grow_all import grow_all
from tests.relations import (
    HALF,
    NEW,
    Form,
    Made,
    beside,
    differences,
    divided,
    from_the_other_end,
    in_two_pieces,
    ruled,
    shuffled,
    stated_once_more,
    tree,
    turned,
    under_other_names,
    whole,
    with_points_for_slips,
    written,
)

SHIPPED = tuple(sorted(str(p) for p in Path("layouts").glob("*.yaml")))
SMALL = tuple(sorted(str(p) for p in Path("tests/layouts_for_tests").glob("*.yaml")))
STATIONS = tuple(f"tests/stations/{n}.yaml" for n in ("komano", "railml", "shinnozaki"))
SEEDS = tuple(map(str, range(45)))
EVERY = (*SHIPPED, *SMALL, *STATIONS, *SEEDS)


@cache
def before(what: str) -> Made | None:
    """A layout of a file, or one that grew from a seed, as it is; None where it is no layout."""
    made = Made(tree(grow_all(int(what)) if what.isdecimal() else Path(what).read_text("utf-8")))
    return made if made.layout is not None else None


def every(kinds: Sequence[str] = EVERY) -> Iterator[tuple[str, Made, Form]]:
    """Each layout with its table."""
    for what in kinds:
        made = before(what)
        if made is not None:
            yield what, made, made.form()


OF_FLANK = ("flank", "points", "driven", "hostile", "foul", "exclusions", "space")
"""Columns that follow from what protects flanks."""


def reverse(names: list[str]) -> Sequence[str]:
    return names[::-1]


def by_chance(names: list[str]) -> Sequence[str]:
    return random.Random(len(names)).sample(names, len(names))


@pytest.mark.parametrize(("order", "form"), [(reverse, "Ж{:04d}я"), (by_chance, "Q{:04d}x")], ids=["script", "chance"])
def test_other_names_change_nothing_but_which_of_two_places_has_a_point(
    order: Callable[[list[str]], Sequence[str]], form: str
) -> None:
    """The places that are protected are the same, and where all are protected alike, so is the table."""
    same = 0
    for what, made, was in every():
        t, back = under_other_names(made.tree, order, form)
        again = Made(t)
        now = again.form(back)
        but = ["names"] if any(r["overlap"] for r in was.routes.values()) else []  # they name the first of its overlaps
        flanks = [{k: lock["flank"] for k, lock in f.locks.items()} for f in (was, now)]
        if flanks[0] == flanks[1]:
            assert differences(was, now, but) == [], what
            assert again.told == made.told, what
            same += 1
        else:
            assert what not in SHIPPED, what
            assert differences(was, now, [*but, *OF_FLANK]) == [], what
            protected = [{k: {requester for requester, _, _ in v} for k, v in x.items()} for x in flanks]
            assert protected[0] == protected[1], what
        assert len(again.errors) == len(made.errors), (what, again.errors)
    assert same > 110


def same_table(change: Callable[[dict[str, Any]], dict[str, Any]], kinds: Sequence[str] = EVERY) -> None:
    """The change leaves every table, and all that is said, as it was."""
    for what, made, was in every(kinds):
        t = change(made.tree)
        if t == made.tree and written(t) == written(made.tree):
            continue
        now = Made(t)
        assert now.layout is not None, (what, now.errors)
        assert differences(was, now.form()) == [], what
        assert now.told == made.told, (what, now.told - made.told, made.told - now.told)


def test_the_order_in_a_file_changes_nothing() -> None:
    """Of named elements not even the digest."""
    same_table(lambda t: shuffled(t, 1, lists=True))
    for what, made, _ in every():
        now, _ = load_text("layout.yaml", written(shuffled(made.tree, 2, lists=False)), Sink())
        assert now is not None and made.layout is not None and now.digest == made.layout.digest, what


def test_tracks_are_the_same_from_either_end() -> None:
    same_table(from_the_other_end)


def test_a_joint_is_the_same_wherever_it_is_stated() -> None:
    same_table(stated_once_more)


def test_a_section_in_two_pieces_is_the_same() -> None:
    same_table(in_two_pieces)


def test_what_is_normal_may_be_called_reverse() -> None:
    """But where that means something: the speed, the yellow lamps and the overlap of the straight way, a key, a
    derailer, a diamond whose crossovers lie reversed, what routes drive along."""
    tried = 0
    asymmetric = ("derailers", "slips", "crossings", "demand", "waive", "overlaps")
    for what, made, was in every():
        assert made.layout is not None
        rules, points = made.layout.principles, (made.tree.get("points") or {}).values()
        if any(k in made.tree for k in asymmetric) or rules.caution is Caution.TURNOUT or rules.drive_points:
            continue
        if rules.overlap_m or any({"work", "hand", "speed"} & p.keys() for p in points) or not points:
            continue
        now = Made(turned(made.tree))
        assert now.layout is not None, (what, now.errors)
        assert differences(was, now.form(turned=True)) == [], what
        assert now.told == made.told, what
        tried += 1
    assert tried > 30


def test_two_layouts_beside_each_other_are_two_tables() -> None:
    """The same layout under other names is the second one: nothing ties the two together."""
    for what, made, was in every():
        if "substations" in made.tree:  # of which one alone may be empty
            continue
        t, _ = under_other_names(made.tree)
        both = Made(beside(made.tree, t))
        assert both.layout is not None and both.table is not None and made.table is not None, (what, both.errors)
        now = both.form()
        here = {k: r for k, r in now.routes.items() if not NEW.search(str(k))}
        assert len(now.routes) == 2 * len(here) and here == was.routes, what
        assert {k: x for k, x in now.locks.items() if not NEW.search(str(k))} == was.locks, what
        assert {p for p in now.hostile if not NEW.search(str(p))} == was.hostile, what
        assert len(now.hostile) == 2 * len(was.hostile) and len(both.table.locks) == 2 * len(was.locks), what


def test_a_section_in_two_halves_keeps_what_is_hostile_and_what_protects() -> None:
    tried = 0
    for what, made, was in every((*SHIPPED, *SMALL[::2], *SEEDS)):
        assert made.layout is not None
        if made.layout.principles.overlap_m or "overlaps" in made.tree or made.sink.has_errors:
            continue
        topo = topology(made.layout)
        said = str([made.tree.get(k) for k in ("exclude", "hostile", "demand", "routes", "voyages", "substations")])
        for section in topo.sections:
            ways = topo.traversals[section]
            plain = not any(w.points or w.crossings for w in ways) and min((w.length for w in ways), default=0) >= 80
            if not plain or section in topo.standing | topo.turning or section in said:
                continue
            t = divided(made, section)
            if t is None:
                continue
            half = Made(t)
            assert half.layout is not None, (what, section, half.errors)
            now = half.form()
            assert {frozenset(map(whole, p)) for p in now.hostile} == {frozenset(map(whole, p)) for p in was.hostile}
            cells = {whole(k): r for k, r in now.routes.items()}
            assert cells.keys() == {whole(k) for k in was.routes}, (what, section)
            for k, r in was.routes.items():
                for column in ("points", "driven", "flank", "foul", "aspect", "conditions", "zones", "length", "speed"):
                    assert whole(cells[whole(k)][column]) == r[column], (what, section, column, k)
                clear = whole(cells[whole(k)]["clear"])
                assert clear == r["clear"], (what, section, k)
            tried += 1
    assert tried > 60 and HALF


def test_a_double_slip_is_two_points_toe_to_toe() -> None:
    """But for the metres between the two, and so for how far overlaps and approaches reach."""
    tried = 0
    for what, made, _ in every((*SHIPPED, *SMALL, "88")):
        t = {k: v for k, v in ruled(made.tree, overlap_m="0").items() if k != "overlaps"}
        points = with_points_for_slips(t)
        if points is None:
            continue
        slip, now = Made(t), Made(points)
        assert slip.layout is not None and now.layout is not None, (what, now.errors)
        assert differences(slip.form(), now.form(), ("length", "foul", "approach")) == [], what
        assert len(slip.errors) == len(now.errors), (what, now.errors)
        tried += 1
    assert tried >= 4


def test_no_signal_protects_nearer_than_its_clearance() -> None:
    """Where a signal must stand farther away than any does, what protects is a point, or that nothing comes."""
    for what, made, was in every((*SHIPPED, *SMALL)):
        now = Made(ruled(made.tree, clearance_m="80000"))
        assert now.layout is not None and now.table is not None, (what, now.errors)
        kinds = {str(p.kind) for lock in now.table.locks for c in lock.flank for p in c.providers}
        assert "signal" not in kinds, what
        assert now.form().locks.keys() == was.locks.keys(), what


STRICTER = ({"clearance_m": "9"}, {"fouling_m": "25"}, {"flank_space": "yes"}, {"overlap_m": "90"})


@pytest.mark.parametrize("rule", STRICTER, ids=lambda r: next(iter(r)))
def test_a_stricter_rule_never_sets_free(rule: dict[str, str]) -> None:
    """What was hostile is, and what had to be clear has to be: with whatever overlap, and but for what is refused."""
    tried = 0

    def way(key: Any) -> Any:
        return key[:3]

    for what, made, was in every((*SHIPPED, *SMALL, *SEEDS)):
        assert made.layout is not None
        if made.sink.has_errors or made.layout.principles.overlap_m:
            continue
        then = Made(ruled(made.tree, **rule))
        if then.layout is None or then.sink.has_errors:
            continue
        now = then.form()
        assert {way(k) for k in was.routes} == {way(k) for k in now.routes}, what
        pairs = [{frozenset(map(way, p)) for p in f.hostile} for f in (was, now)]
        assert pairs[0] <= pairs[1], (what, list(pairs[0] - pairs[1])[:1])
        for k, r in was.routes.items():
            others = [x for y, x in now.routes.items() if way(y) == way(k)]
            asked = [now.routes[k]] if k in now.routes else others
            foul = {(section, when) for section, _, when, _ in r["foul"]}
            for x in asked:
                assert r["clear"] <= x["clear"] and r["conditions"] <= x["conditions"], (what, k)
                still = {(section, when) for section, _, when, _ in x["foul"]}
                assert all((s, w) in still or (s, None) in still for s, w in foul), (what, k)
        tried += 1
    assert tried > 20
