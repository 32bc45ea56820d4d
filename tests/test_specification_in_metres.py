"""Every step of trains in metres is one that the specification allows; a specification that allows less is found out.

A proof says nothing of what the specified world cannot do.  So each change below, which takes something away from that
world, must be contradicted by some step of a train that has a length, a speed and a driver.
"""

from __future__ import annotations

from functools import cache

import pytest

from interlock.checker import specification
from interlock.checker.specification import FOLDER, Specification
from tests.campaigns.simulate import Case
from tests.in_metres import Specified, Step, steps

CLAIMS = (FOLDER / "claims.yaml").read_text("utf-8")
PLANT = (FOLDER / "plant.yaml").read_text("utf-8")
TOLD = (FOLDER / "told.yaml").read_text("utf-8")

LAYOUTS = {"pit_bottom": (0, 4), "terminus": (0, 1)}
"""With seeds of their runs."""
SCANS = 3000


@cache
def runs(name: str) -> list[list[Step]]:
    """Runs of a layout, with either operator, from when the restart delay was over."""
    words, case = shipped(name).words, Case.of(f"layouts/{name}.yaml")
    return [steps(case, words, seed, SCANS, hostile) for seed in LAYOUTS[name] for hostile in (False, True)]


@cache
def shipped(name: str) -> Specified:
    return Specified(name, specification.shipped())


def first_broken(name: str, specified: Specified) -> str:
    """The first thing that a specification does not allow, or nothing."""
    for run in runs(name):
        if not specified.begin(run[0]):
            return "a run begins otherwise than specified"
        for step in run:
            for what in specified.broken(step):
                return what
    return ""


def contradicted(name: str, spec: Specification) -> bool:
    """Whether a step is made on a layout that this specification does not allow, but the shipped one does."""
    specified = Specified(name, spec)
    specified.other_than(shipped(name))
    return first_broken(name, specified) != ""


@pytest.mark.parametrize("name", LAYOUTS)
def test_every_step_in_metres_is_allowed(name: str) -> None:
    assert first_broken(name, shipped(name)) == ""
    made = [s for run in runs(name) for s in run]
    assert len(made) > 5000
    assert sum(len(s.heads) for s in made) > 20 and sum(len(s.tails) for s in made) > 20
    assert any(s.arrived for s in made) and any(s.appeared for s in made)


HEAD = "occupied(s) and not across(j, s) and scanned(s)"
ACCEPT = "occupied(before(c)) and not across(joint_of(c), before(c)) and seen(c)"
TAIL = "and (each b in beyond_end(s, j): scanned(b))"
START = "lies(m, x) and (driven(m, other(x)) or was_driven(m, other(x)))"
REPORTED = "occupied(s) and occupied'(s) and valid -> not clear(s)"

SHORTER = (
    ("machines obey at once", START, "lies(m, x) and driven(m, other(x))"),
    ("points never move", START, "lies(m, x) and not lies(m, x)"),
    ("no head moves while inputs are lost", HEAD, HEAD + " and valid"),
    ("heads are seen at once", HEAD, HEAD + " and (each b in beyond_end(s, j): not clear(b))"),
    ("trains are shorter than sections", HEAD, HEAD + " and (each k in other_ends(s, j): not coming(s, k))"),
    ("no tail moves while inputs are lost", TAIL, TAIL + " and valid"),
    ("tails leave nothing behind them", TAIL, TAIL + " and clear(s)"),
    ("nobody comes over a boundary", "(not occupied(outside(b)) or leaves(node(b), outside(b)))", "not valid"),
    (
        "a section in which a head comes stays free",
        "occupied(s) and not gone(s) or comes_into(s)",
        "occupied(s) and not gone(s)",
    ),
    (
        "nobody lies across a joint",
        '    says: "across(j, s) and not leaves(j, s) or goes(j, s)"\n  - name: o.',
        '    says: "across(j, s) and not leaves(j, s)"\n  - name: o.',
    ),
    ("who stood at a restart is not called", ACCEPT, ACCEPT + " and (each s in inside_before(c): not standing(s))"),
    ("who stood at a restart does not move", HEAD, HEAD + " and not standing(s)"),
    ("drivers never stop after all", '    says: "true"\n  - name: turn.', '    says: "not true"\n  - name: turn.'),
    (
        "drivers stop at once when a signal closes",
        "(accepted(c) or accepts(c)) and not refuses(c)",
        "(accepted(c) or accepts(c)) and shows(c) and not refuses(c)",
    ),
    (
        "no train turns round",
        "occupied(section(t)) and came(section(t), entry(t))",
        "not occupied(section(t)) and came(section(t), entry(t))",
    ),
    (
        "whoever stood is called when the signal opens",
        "standing(s) and not gone(s) or berth(s)",
        "standing(s) and not called_now(s) or berth(s)",
    ),
    ("a head is reported at once", REPORTED, "occupied'(s) and valid -> not clear(s)"),
    ("a tail is reported for one scan more", REPORTED, "occupied(s) and valid -> not clear(s)"),
    (
        "nothing is falsely reported occupied",
        "not (falsely(rear(n)) and falsely(front(n)))",
        "not falsely(rear(n)) and not falsely(front(n))",
    ),
    ("contacts never fail", "valid and detected(m, x) -> lies'(m, x)", "valid -> (detected(m, x) <-> lies'(m, x))"),
    (
        "whoever sees stop has stopped",
        "stop_long(g) -> not accepted(c) and not accepted'(c)",
        "shown_stop(g) -> not accepted(c) and not accepted'(c)",
    ),
    ("nobody stands anywhere at a restart", "(standing(s) <-> occupied(s))", "not occupied(s)"),
    ("every point lies normal at a restart", "one_at_most(x in positions: lies(m, x))", "lies(m, N)"),
)


@pytest.mark.parametrize(("old", "new"), [x[1:] for x in SHORTER], ids=[x[0] for x in SHORTER])
def test_a_world_that_can_do_less_is_contradicted(old: str, new: str) -> None:
    assert (PLANT.count(old), CLAIMS.count(old)) in ((1, 0), (0, 1))
    shorter = specification.read(CLAIMS.replace(old, new), PLANT.replace(old, new), TOLD)
    assert any(contradicted(name, shorter) for name in LAYOUTS)
