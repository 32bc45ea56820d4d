"""Routes that are not hostile can be used together; what stands in the way is found, told and played."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app.check import check_file
from interlock.app.init import yard
from interlock.audit import audit
from interlock.cli.availability import command
from interlock.logic.lower import lower
from interlock.model.elements import Position
from interlock.model.principles import PROFILES
from interlock.proof.prover import prove
from interlock.proof.system.loop import closed_loop
from interlock.proof.system.transition import System
from interlock.proof.witnesses.availability import Manner, Trial, availability, compatible
from interlock.proof.witnesses.opening import OPEN, steps
from interlock.proof.witnesses.routes import witnesses
from interlock.proof.witnesses.together import How
from interlock.table.cells import Because, Exclusion, HostileRoutes
from interlock.table.rows import RouteRow, TraversalRow
from tests.campaigns.availability import derived, space_to_the_point, under, weakened
from tests.layouts import SHIPPED, built, grown

CASES = ("bare_signal", "both_ways", "door", "parallel", "scissors_apart", "through", "triangle")


@pytest.mark.parametrize("name", SHIPPED)
def test_every_pair_that_is_not_hostile_can_be_used_together(name: str) -> None:
    layout, table, controller = built(name)
    found = availability(closed_loop(layout, controller), table)
    assert [(p.first, p.second, p.failure) for p in found.pairs if p.failure] == []
    assert [(r.bound.route, r.failure) for r in found.routes if r.failure] == []
    listed = {(a, b) for r in table.routes for a, b in [(r.id, h) for h in r.locking.hostile.routes]}
    count = len(table.routes)
    assert found.hostile * 2 == len(listed) and found.hostile + len(found.pairs) == count * (count - 1) // 2


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("name", CASES)
def test_small_layouts_are_proved_and_available_in_every_profile(name: str, profile: str) -> None:
    made = derived(under(Path(f"tests/layouts_for_tests/{name}.yaml").read_text("utf-8"), profile))
    assert made is not None
    layout, table = made
    system = System(layout, lower(layout, table))
    assert prove(system).proved
    assert availability(system.loop, table).shown


def test_two_parallel_trains_run_at_once_where_each_is_in_the_section_of_the_point_that_protects_the_other() -> None:
    layout, _, controller = built("../tests/layouts_for_tests/parallel")
    trial = Trial(closed_loop(layout, controller))
    n, p = (r for r in controller.symbols.routes if r.id in ("N-E1", "P-W2"))
    manner, runs = trial.plan(n, p)
    assert manner is Manner.BESIDE and {x.how for x in runs} == {How.THEN, How.TOGETHER}


def test_a_point_that_the_author_has_a_route_demand_lies_so_before_the_route_is_tried_with_others() -> None:
    text = Path("tests/layouts_for_tests/added.yaml").read_text("utf-8")
    made = derived(text.replace("{point: 3, lies: normal,", "{point: 3, lies: reverse,"))
    assert made is not None
    layout, table = made
    system = System(layout, lower(layout, table))
    found = availability(system.loop, table)
    assert [(r.bound.route, r.failure) for r in found.routes if r.failure] == []
    assert found.shown and {r.bound.route: r.bound.machines for r in found.routes}["S1-W"] == 2


@pytest.mark.parametrize("case", list(weakened()), ids=lambda c: f"{c[0]} {c[1]}")
def test_weakenings_are_found_out(case: tuple) -> None:  # type: ignore[type-arg]
    _, _, layout, table, controller = case
    assert any(p.failure for p in availability(closed_loop(layout, controller), table).pairs)


def test_a_signal_that_falls_because_of_the_other_train_is_told_and_played(tmp_path: Path) -> None:
    layout, table, _ = built("../tests/layouts_for_tests/parallel")
    system = System(layout, lower(layout, space_to_the_point(layout, table)))
    found = availability(system.loop, table)
    (bad,) = [p for p in found.pairs if p.failure]
    assert {bad.first, bad.second} == {"N-E1", "P-W2"} and "falls to stop before its train" in (bad.failure or "")
    story = Trial(system.loop).story(bad, system.relation)
    assert story is not None
    text = "\n".join(story.steps).replace("Signal ", "signal ")
    assert "signal N shows proceed for route N-E1" in text and "signal P returns to stop" in text
    assert text.endswith(f"{bad.failure}.") and len(story.after) == len(story.steps)

    from interlock.emit.drawing import plan_svg
    from interlock.emit.report import player_html
    from interlock.proof.induction.trace import itf

    trace = itf(system.loop, system.relation.state, story, layout.digest, plan_svg(layout))
    assert json.loads(trace)["#meta"]["claim"].startswith("AVAILABILITY") and "<svg" in player_html(trace)


@pytest.mark.parametrize(("name", "scans"), [("mine11", 4), ("cn6502", 20), ("flank_lab", 5)])
def test_a_route_opens_within_the_scans_that_were_computed_and_some_need_them_all(name: str, scans: int) -> None:
    layout, table, controller = built(name)
    system = System(layout, controller)
    found = availability(system.loop, table)
    seen = [r for r in found.routes if r.seen is not None]
    assert all(r.seen is not None and r.seen[0] >= OPEN and r.failure is None for r in seen)
    bound = {r.id: steps(system.loop, r, 1000) for r in controller.symbols.routes}
    assert all(r.seen is not None and r.seen[1] <= bound[r.bound.route] for r in seen)  # type: ignore[index]
    assert max(max(r.seen) for r in seen if r.seen is not None) == scans


def test_pairs_that_are_tried_are_those_that_the_table_does_not_call_hostile() -> None:
    layout, table, controller = built("terminus")
    tried = {(a.id, b.id) for a, b in compatible(closed_loop(layout, controller), table)}
    assert all(b not in table.route[a].locking.hostile.routes for a, b in tried) and len(tried) == 8


def test_points_that_a_train_has_left_otherwise_on_its_way_are_no_fault_of_a_table() -> None:
    """A point is worked with a derailer, which lies in a section of an overlap."""
    checked = check_file("tests/layouts_for_tests/left_otherwise.yaml")
    layout, table = checked.layout, checked.table
    assert layout is not None and table is not None
    found = availability(closed_loop(layout, lower(layout, table)), table)
    assert [(p.first, p.second, p.failure) for p in found.pairs if p.failure and p.manner is not Manner.NONE] == []
    (pair,) = [p for p in found.pairs if (p.first, p.second) == ("22X#-36G#", "32G#-26G#")]
    assert pair.apart is not None and pair.apart.startswith("22X#-36G#: the request is refused: not 17P#/18R# R")


def test_a_yard_is_available() -> None:
    made = derived(yard(6))
    assert made is not None
    found = availability(closed_loop(made[0], lower(*made)), made[1])
    assert found.shown and len(found.pairs) > 500


def test_the_verb_tells_each_route_and_the_sum(tmp_path: Path) -> None:
    done = CliRunner().invoke(command, ["layouts/mine11.yaml", "--traces", str(tmp_path)], catch_exceptions=False)
    assert done.exit_code == 0 and "X1-X3: opens within 3 scans; its machine moved, 4 scans and 6 s" in done.output
    assert re.search(r"SHOWN  9 routes; of 36 pairs 15 hostile, 21 used together in \d+ runs", done.output)
    data = json.loads(CliRunner().invoke(command, ["layouts/mine11.yaml", "--format", "json"]).stdout)
    assert data["ok"] and len(data["routes"]) == 9 and len(data["pairs"]) == 21
    assert CliRunner().invoke(command, ["layouts/rejected/no_provider.yaml"]).exit_code == 1
    assert not list(tmp_path.iterdir())


def test_a_signal_from_which_nothing_starts_ends_routes_with_an_overlap() -> None:
    checked = check_file("tests/layouts_for_tests/bare_signal.yaml")
    assert checked.ok and checked.table is not None
    assert {r.id for r in checked.table.routes} == {"A-M", "B-W"}
    assert checked.table.route["A-M"].locking.overlap is not None  # type: ignore[index]


def test_a_road_under_a_door_closes_its_signal_with_the_first_axle() -> None:
    checked = check_file("tests/layouts_for_tests/door.yaml")
    assert checked.ok and checked.table is not None
    assert {d.code for d in checked.diagnostics} == {"IL3025"}
    assert all(r.signal.closing.whole is None for r in checked.table.routes if r.entry == "S3")


def test_a_point_that_the_author_has_a_route_lock_is_moved_like_its_own() -> None:
    text = Path("tests/layouts_for_tests/added.yaml").read_text("utf-8").replace("lies: normal", "lies: reverse")
    found = grown(text)
    assert found is not None and not found[2].has_errors
    layout, table, _ = found
    routes = {r.bound.route: r for r in availability(closed_loop(layout, lower(layout, table)), table).routes}
    assert routes["S1-W"].bound.machines == 2, "its own, and point 3"
    assert [r.failure for r in routes.values()] == [None] * len(routes)


def test_a_train_that_stands_foul_of_the_other_route_is_told_and_the_pair_is_driven_without_it() -> None:
    layout, table, controller = built("../tests/layouts_for_tests/foul_berth")
    found = availability(closed_loop(layout, controller), table)
    (pair,) = [p for p in found.pairs if p.apart]
    assert found.shown and (pair.first, pair.second, pair.manner, pair.runs) == ("G-W", "H-N", Manner.ALONE, 1)
    assert pair.apart == "H-N: the request is refused: not s4: the joint s4|s6 is foul of point P"


def test_a_point_held_for_a_flank_that_decides_whether_a_joint_is_foul_makes_a_pair_hostile() -> None:
    """The train of S1-A in s10 would take the signal of S2-B back, since P11 lies R for the flank of S1-A."""
    layout, table, controller = built("../tests/layouts_for_tests/foul_flank")
    (hostile,) = table.route["S2-B"].locking.hostile  # type: ignore[index]
    assert (hostile.route, str(hostile.kind), hostile.how.rule) == ("S1-A", "foul", "R6.10")
    assert hostile.witness.endswith("the joint s17|s10 is foul of point P16, unless P11 lies N")
    system = System(layout, controller)
    assert availability(system.loop, table).shown and prove(system).proved

    def without(t: TraversalRow) -> TraversalRow:
        return replace(t, exclusions=tuple(x for x in t.exclusions if "P16" not in x.because.text))

    weak = replace(table, locks=tuple(map(without, table.locks)))
    bare = tuple(
        replace(r, locking=replace(r.locking, hostile=HostileRoutes((), 0, {}.__getitem__))) for r in table.routes
    )
    told = {(f.route, f.column) for f in audit(layout, replace(table, routes=bare))}
    assert {("S1-A", "hostile"), ("S2-B", "hostile")} <= told
    found = availability(closed_loop(layout, lower(layout, weak)), replace(weak, routes=bare))
    assert [(p.first, p.second) for p in found.pairs if p.failure] == [("S1-A", "S2-B")]


def test_a_point_beside_the_path_is_driven_away_from_a_joint_that_is_foul_of_a_route_beside() -> None:
    """In normal the train of A-E would take the signal of D-U back, in front of its train."""
    layout, table, controller = built("../tests/layouts_for_tests/foul_driven")
    assert [f"{d.machine} {d.position}" for d in table.route["A-E"].locking.driven] == ["2 R"]  # type: ignore[index]
    assert "A-E" not in table.route["D-U"].locking.hostile.routes  # type: ignore[index]
    assert not audit(layout, table) and availability(closed_loop(layout, controller), table).shown

    def to_normal(r: RouteRow) -> RouteRow:
        driven = tuple(replace(d, position=Position.NORMAL) for d in r.locking.driven)
        return replace(r, locking=replace(r.locking, driven=driven))

    weak = replace(table, routes=tuple(map(to_normal, table.routes)))
    assert {(f.route, f.column) for f in audit(layout, weak)} == {("A-E", "driven")}
    found = availability(closed_loop(layout, lower(layout, weak)), weak)
    assert [(p.first, p.second) for p in found.pairs if p.failure] == [("A-E", "D-U")]


def test_a_point_that_nobody_drives_away_from_a_foul_joint_is_told_and_the_advice_helps() -> None:
    text = Path("tests/layouts_for_tests/foul_driven.yaml").read_text("utf-8")
    text = text.replace("profile: cn", "profile: cn\nprinciples: {drive_points: no}")
    layout, table, sink = grown(text) or pytest.fail("refused")
    (told,) = [d for d in sink.diagnostics if d.code == "IL7011"]
    assert told.message.startswith("2 lies in s2, and cannot move once A-E has locked it: a train there closes the ")
    assert told.message.endswith("signal of D-U (R), of which it may be foul unless 2 lies so")
    assert told.fix == "give 2 a section of its own, or have A-E lock it so: `demand`"
    assert availability(closed_loop(layout, lower(layout, table)), table).shown  # while 2 lies so
    helped = grown(f"{text}demand: [{{point: 2, lies: reverse, routes: {{from: A, to: E}}, reason: D-U stays open}}]\n")
    assert helped is not None and "IL7011" not in {d.code for d in helped[2].diagnostics}


def test_a_point_in_an_overlap_cannot_move_either() -> None:
    """The overlap of X1 lies over P1 in normal and locks s1, in which P2 lies, as a route over P1 does."""
    text = Path("tests/diagnostics/IL7011.yaml").read_text("utf-8")
    text += "overlaps: {X1: {length: 3, not_over: [P1.reverse]}}\n"
    layout, table, sink = grown(text) or pytest.fail("refused")
    (told,) = [d for d in sink.diagnostics if d.code == "IL7011"]
    assert told.message.startswith("P2 lies in s1, and cannot move once X-X1 or X1-A has locked it: then Y1-C (N) or")
    assert audit(layout, table) == () and availability(closed_loop(layout, lower(layout, table)), table).shown


def test_a_pair_of_which_one_refuses_the_other_fails_though_a_train_stands_in_the_way_as_well() -> None:
    layout, table, _ = built("../tests/layouts_for_tests/foul_berth")
    (a, b) = (table.route[r].path.locked[0] for r in ("G-W", "H-N"))  # type: ignore[index]
    extra = Exclusion(a[0], True, (), Because("R6", "too much"))
    locks = tuple(replace(t, exclusions=(*t.exclusions, extra)) if t.key == b else t for t in table.locks)
    found = availability(closed_loop(layout, lower(layout, replace(table, locks=locks))), table)
    failed = {(p.first, p.second): p.failure for p in found.pairs if p.failure}
    assert failed["G-W", "H-N"] == "H-N: the request is refused: not s2: too much"


def test_a_train_that_came_over_another_route_is_called_on_when_its_overlap_is_given_up() -> None:
    layout, table, controller = built("../tests/layouts_for_tests/called_on_over_overlap")
    system = System(layout, controller)
    came = {w.route: w for w in witnesses(system.loop)}["G-E.c"]
    assert came.ok and came.text == "set, driven and released, coming over F-G"
    assert availability(system.loop, table).shown


def test_the_sections_of_a_train_that_is_called_on_fill_a_zone() -> None:
    layout, table, controller = built("../tests/layouts_for_tests/zone_of_called")
    found = availability(closed_loop(layout, controller), table)
    manners = {(p.first, p.second): p.manner for p in found.pairs}
    assert found.shown and manners["G-E.c", "Y-S"] is Manner.ZONE and manners["G-E", "Y-S"] is Manner.BESIDE


def test_a_route_drives_a_point_along_to_where_a_parallel_route_needs_it() -> None:
    layout, table, controller = built("../tests/layouts_for_tests/driven_reverse")
    assert audit(layout, table) == ()
    assert {
        r.id: [f"{p.machine} {p.position}" for p in r.locking.driven] for r in table.routes if r.locking.driven
    } == {"A-A3": ["M R"]}
    assert availability(closed_loop(layout, controller), table).shown
    otherwise = replace(table.route["A-A3"], locking=replace(table.route["A-A3"].locking, driven=()))
    rows = tuple(otherwise if r.id == "A-A3" else r for r in table.routes)
    assert [f.column for f in audit(layout, replace(table, routes=rows))] == ["driven"]


def test_points_that_are_driven_along_are_waited_for() -> None:
    layout, table, controller = built("../tests/layouts_for_tests/driven_reverse")
    system = System(layout, controller)
    bounds = {r.bound.route: (r.bound.machines, r.bound.at_most_scans) for r in availability(system.loop, table).routes}
    assert bounds["A-A3"] == (1, 7) and bounds["B-B2"] == (1, 5), "the second of two machines waits for its turn"


def test_points_that_two_routes_want_both_ways_are_not_driven_along() -> None:
    text = Path("tests/diagnostics/IL7011.yaml").read_text("utf-8").replace("name: demo", "name: demo\nprofile: cn")
    made = derived(text)
    assert made is not None
    layout, table = made
    assert not any(r.locking.driven for r in table.routes if r.id == "X1-A") and audit(layout, table) == ()
    assert availability(closed_loop(layout, lower(layout, table)), table).shown


def test_a_route_over_a_section_that_another_one_is_to_find_clear_is_kept_apart() -> None:
    layout, table, controller = built("../tests/layouts_for_tests/clear_beyond")
    found = availability(closed_loop(layout, controller), table)
    apart = [{p.first, p.second} for p in found.pairs if p.manner is Manner.CLEAR]
    assert found.shown and {"A-N2.c", "B-S1"} in apart and all("A-N2.c" in pair for pair in apart)


def test_trains_that_are_called_on_face_to_face_are_run_with_one_false_detection() -> None:
    """Both routes end where sections adjoin that may not both be reported occupied by mistake (A-ONE-FALSE)."""
    layout, table, controller = built("../tests/layouts_for_tests/called_on_face_to_face")
    found = availability(System(layout, controller).loop, table)
    pair = next(p for p in found.pairs if {p.first, p.second} == {"S1-S2.c", "S3-S4.c"})
    assert pair.manner is Manner.BESIDE and pair.runs == 3 and found.shown


def test_a_berth_in_which_a_movement_ends_may_be_demanded_clear_too() -> None:
    """The train of the one stands then where the other one is to find nothing: its signal falls to stop, as it must."""
    text = Path("tests/layouts_for_tests/clear_beyond.yaml").read_text("utf-8")
    text += "  - {clear: y1, routes: {from: B0}, reason: wagons there would be hit}\n"
    made = grown(text)
    assert made is not None
    layout, table, sink = made
    assert not sink.has_errors and table.route["N1-Y.s"].path.berth == "y1"
    found = availability(closed_loop(layout, lower(layout, table)), table)
    assert found.shown
    assert {"B0-B", "N1-Y.s"} in [{p.first, p.second} for p in found.pairs if p.manner is Manner.CLEAR]
