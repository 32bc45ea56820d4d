"""Diamonds whose arms lie in two sections: what stands across, on a route or on none, keeps a signal at stop (R6)."""

from __future__ import annotations

from dataclasses import replace

import pytest

from interlock.audit import audit
from interlock.logic.lower import lower
from interlock.model.elements import RouteId
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable
from tests.layouts import built, grown
from tests.test_runtime import module_of

SCISSORS = "../tests/layouts_for_tests/scissors_two"


def across(table: InterlockingTable, route: str) -> list[str]:
    """What is to be clear across a route on its diamonds, as the table has it."""
    cells = [c for c in table.route[RouteId(route)].clear.foul if c.crossing is not None]
    return [f"{c.section}{f' if {c.when[0]} {c.when[1]}' if c.when else ''}" for c in cells]


def test_the_section_of_the_other_arm_is_to_be_clear() -> None:
    _, scissors, _ = built(SCISSORS)
    assert across(scissors, "P1-E2") == across(scissors, "Q2-W1") == ["XB"]
    assert across(scissors, "P2-E1") == ["XA"] and across(scissors, "P1-E1") == []


def test_it_need_not_be_clear_while_its_point_leads_away() -> None:
    """Another train may run through BC over 102 in normal meanwhile."""
    _, junction, _ = built("junction")
    assert across(junction, "S1J-S5") == ["BC if 102 N"]
    assert across(junction, "S2J-S6") == [], "it holds 101 N, for its flank"
    assert "S4J-S6" not in junction.route[RouteId("S1J-S5")].locking.hostile.routes


def test_it_is_not_asked_where_the_route_runs_through_it_or_holds_the_point_that_leads_away() -> None:
    """In a scissors crossover of this station the points of the other crossover lie in the route's own way."""
    _, station, _ = built("cn6502")
    assert all(c.crossing is None for r in station.routes for c in r.clear.foul)


def test_proceed_is_taken_back_and_not_given_when_something_is_reported_across() -> None:
    """By the emitted runtime, with inputs as they come from the field."""
    _, table, controller = built(SCISSORS)
    one, sym = module_of(SCISSORS).Controller(), controller.symbols
    (route,) = [r for r in sym.routes if r.id == "P1-E2"]
    lying = [sym.machines.detected[d.machine, d.position] for d in table.route[route.id].locking.points]
    quiet = dict.fromkeys([sym.valid, *sym.sections.clear.values(), *lying], 1)
    quiet = {name: quiet.get(name, 0) for name in (i.name for i in controller.inputs)}
    restart = max(t.preset_ms for t in controller.timers)
    for _ in range(restart // 1000 + 5):
        one.scan(quiet, 1000)
    one.scan({**quiet, sym.sections.release_all: 1}, 1000)
    one.scan(quiet, 1000)
    one.scan({**quiet, **one.request("P1-E2")}, 100)
    for _ in range(5):
        shown = one.scan(quiet, 100)
    lamps = sym.aspects.main_lamps(route.entry)
    assert any(shown[name] for name in lamps), one.status("P1-E2")
    there = {**quiet, sym.sections.clear["XB"]: 0}
    for _ in range(100):
        shown = one.scan(there, 100)
        assert not any(shown[name] for name in lamps)
    for _ in range(200):  # the locks are given back, and it is asked for anew
        one.scan({**there, sym.cancellation.cancel[route.entry]: 1}, 1000)
    one.scan({**there, **one.request("P1-E2")}, 100)
    for _ in range(50):
        shown = one.scan(there, 100)
        assert not any(shown[name] for name in lamps)


def test_a_table_without_it_is_found_out_by_the_audit_and_by_the_proof() -> None:
    layout, table, _ = built(SCISSORS)

    def bare(those: tuple) -> tuple:  # type: ignore[type-arg]
        return tuple(c for c in those if c.crossing is None)

    locks = tuple(replace(t, foul=bare(t.foul)) for t in table.locks)
    routes = tuple(replace(r, clear=replace(r.clear, foul=bare(r.clear.foul))) for r in table.routes)
    weak = replace(table, locks=locks, routes=routes)
    assert {f.column for f in audit(layout, weak)} == {"foul"}
    proved = prove(System(layout, lower(layout, weak)))
    assert {c.id for c in proved.claims if c.verdict is not Verdict.PROVED} == {"S-CONDITION", "S-OVERLAP"}


@pytest.mark.parametrize(("legs", "told"), [(3, ["diamond X lies only 6 m from point 1"]), (20, [])])
def test_a_diamond_on_the_leg_of_a_point_is_not_nearer_than_vehicles_stand_clear(legs: int, told: list[str]) -> None:
    """Whatever passes over its other arm is on no section of the point, nor of a way over it."""
    made = grown(f"""interlock: 1
name: near
profile: uk
principles: {{overlap_m: 0}}
boundaries:
  W: {{approach: wa 800, trains: in}}
  E: {{trains: out}}
  F: {{trains: out}}
  N: {{approach: na 800, trains: in}}
  S: {{trains: out}}
tracks: {{west: [W, w1 300], main: [m1 300, E], branch: [b1 300, F], north: [N, n1 300], south: [s1 300, S]}}
points:
  1: {{section: AC, toe: west.end, normal: main.start, reverse: X.1a, legs: {legs}}}
crossings:
  X:
    legs: {legs}
    arms: [{{section: AC, ends: [1.reverse, branch.start]}}, {{section: BC, ends: [north.end, south.start]}}]
signals:
  A1: {{from: W, into: w1}}
  A2: {{from: w1, into: AC}}
  B1: {{from: N, into: n1}}
  B2: {{from: n1, into: BC}}
""")
    assert made is not None
    near = [d.message.split(",")[0] for d in made[2].diagnostics if d.code == "IL3042"]
    assert [x for x in near if x.startswith("diamond")] == told
    assert ("1 leads to the diamond X" in near) is bool(told)


SQUARE = """interlock: 1
name: square
boundaries:
  N1: {trains: in, approach: n1a 800}
  N2: {trains: in, approach: n2a 800}
  S1: {trains: out}
  S2: {trains: out}
  W1: {trains: in, approach: w1a 800}
  W2: {trains: in, approach: w2a 800}
  E1: {trains: out}
  E2: {trains: out}
tracks:
  n1: [N1, nn1 200, V1 15]
  s1: [V1 15, ss1 200, S1]
  n2: [N2, nn2 200, V2 15]
  s2: [V2 15, ss2 200, S2]
  w1: [W1, ww1 200, H1 15]
  e1: [H1 15, ee1 200, E1]
  w2: [W2, ww2 200, H2 15]
  e2: [H2 15, ee2 200, E2]
crossings:
  X11: {legs: 3, FOULING arms: [{section: V1, ends: [n1.end, X12.1a]}, {section: H1, ends: [w1.end, X21.2a]}]}
  X12: {legs: 3, FOULING arms: [{section: V1, ends: [X11.1b, s1.start]}, {section: H2, ends: [w2.end, X22.2a]}]}
  X21: {legs: 3, FOULING arms: [{section: V2, ends: [n2.end, X22.1a]}, {section: H1, ends: [X11.2b, e1.start]}]}
  X22: {legs: 3, FOULING arms: [{section: V2, ends: [X21.1b, s2.start]}, {section: H2, ends: [X12.2b, e2.start]}]}
signals:
  A1: {from: N1, into: nn1}
  A2: {from: nn1, into: V1}
  B1: {from: N2, into: nn2}
  B2: {from: nn2, into: V2}
  C1: {from: W1, into: ww1}
  C2: {from: ww1, into: H1}
  D1: {from: W2, into: ww2}
  D2: {from: ww2, into: H2}
"""
"""Two double tracks that cross at a right angle, 6 m from centre to centre."""


@pytest.mark.parametrize(
    ("stated", "across_a2", "hostile"),
    [
        ("", ["H1", "H2", "V2"], {"B2-S2", "C2-E1", "D2-E2"}),  # 12 m and 3.5 m along an arm, as at an acute angle
        ("fouling: 2,", ["H1", "H2"], {"C2-E1", "D2-E2"}),
        ("fouling: 2.5,", ["H1", "H2"], {"C2-E1", "D2-E2"}),  # with the clearance just the 6 m
        ("fouling: 2.51,", ["H1", "H2", "V2"], {"B2-S2", "C2-E1", "D2-E2"}),
    ],
)
def test_where_tracks_cross_at_a_right_angle_both_of_a_double_track_are_used(
    stated: str, across_a2: list[str], hostile: set[str]
) -> None:
    """A vehicle on the next diamond stands clear where the author says how far it must be away."""
    made = grown(SQUARE.replace("FOULING", stated))
    assert made is not None
    layout, table, sink = made
    assert sorted({c.section for c in table.route[RouteId("A2-S1")].clear.foul}) == across_a2
    assert set(table.route[RouteId("A2-S1")].locking.hostile.routes) == hostile
    assert not audit(layout, table)
    assert {c.verdict for c in prove(System(layout, lower(layout, table))).claims} == {Verdict.PROVED}
    assert any(d.code == "IL3042" for d in sink.diagnostics) is ("V2" in across_a2)
