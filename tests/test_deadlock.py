"""Never a deadlock, on the controller with its plant: every plan replayed; without the rule trains stand for ever."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from itertools import permutations
from pathlib import Path

import pytest

from interlock.app.dispatching import Coming
from interlock.app.replay import BadPlan, Plan, PlanTrain, Replay, from_text, to_text
from interlock.dispatch import Dispatcher
from interlock.dispatch.commands import BadOrder, errand
from interlock.dispatch.plan.errands import NoVoyage, Place
from interlock.dispatch.plan.explore import TooManyStates, explore
from interlock.dispatch.plan.problem import Draft, build
from interlock.dispatch.plan.search import Planner, Verdict
from interlock.dispatch.policy import Policy, yields
from interlock.dispatch.run import Run
from interlock.model.elements import RouteId, SectionId, SignalId
from interlock.proof.system.loop import closed_loop
from interlock.sim.trains import Spot, Train
from tests.campaigns.dispatch import (
    LOOPS,
    MINE,
    PIT,
    PIT_VOYAGES,
    UNANNOUNCED,
    WAYS,
    Case,
    Timed,
    orders,
    renamed,
    timings,
)


@lru_cache
def case(path: str) -> Case:
    return Case(Path(path).read_text("utf-8"))


FEW = timings("1:W>E", "2:E>W")[::6]
FOUR: list[list[Timed]] = orders(("E1", "E2", "W1", "W2"), 4, gaps=(3,))[::4]


@pytest.mark.parametrize(
    ("path", "runs", "grant"),
    [
        (MINE, timings("in", "out")[::6], 4),
        (MINE, FEW, 4),
        (MINE, timings("1:W>E", "2:E>W", 320.0)[::6], 4),  # only one track holds such a train, in one direction
        (MINE, orders(WAYS, 3, gaps=(3, 25)), 4),
        (LOOPS, FOUR, 4),
        # a train waits outside behind the one that goes in: its section is never seen clear between them, so that what
        # the first has left is held for the delay of approach locking (R9)
        (PIT, orders(PIT_VOYAGES, 3, gaps=(40,))[::4], 16),
    ],
)
def test_no_train_stands_for_ever_and_every_plan_holds_on_the_controller(
    path: str, runs: list[list[Timed]], grant: int
) -> None:
    """`grant`: within so many scans of two seconds each route of a plan is granted."""
    c = case(path)
    found = c.run(runs)
    assert [o.stuck for o in found.outcomes if o.stuck] == [] and not found.troubles
    assert found.ahead == 1, "no route is set ahead of a train that has not passed the one before"
    c.replay(runs, found)
    assert found.plans > 0 and found.wrong == [] and found.grant <= grant


def test_without_the_rule_trains_stand_for_ever() -> None:
    assert case(MINE).run(FEW, rule=False).stuck > 0


def test_who_comes_unannounced_is_served_or_it_is_said_who_is_caught() -> None:
    assert UNANNOUNCED
    for o in case(MINE).run(orders(WAYS, 3, gaps=(25, 40), ahead=False)).outcomes:
        said = [x for x in o.said if x.startswith("no plan exists: ")]
        assert not o.stuck or (said and all(t in said[-1] for t in o.stuck))


@pytest.mark.parametrize(("path", "runs"), [(MINE, FEW[::3]), (LOOPS, FOUR[:2])])
def test_results_do_not_depend_on_names(path: str, runs: list[list[Timed]]) -> None:
    text = Path(path).read_text("utf-8")
    first = case(path).run(runs)
    for seed in range(3):
        again, old = renamed(text, seed)
        assert again != text
        there = [[(_renamed(c, old), *x) for c, *x in r] for r in runs]
        for a, b in zip(first.outcomes, Case(again).run(there).outcomes, strict=True):  # type: ignore[arg-type]
            assert tuple((t, "-".join(old.get(x, x) for x in r.split("-"))) for t, r in b.asked) == a.asked


def _renamed(command: str, old: dict[str, str]) -> str:
    """A command in the new names."""
    new = {o: n for n, o in old.items()}
    train, _, way = command.partition(":")
    return command if not way else train + ":" + ">".join(new.get(x, x) for x in way.split(">"))


# --- the model ---------------------------------------------------------------------------------


def test_deadlocks_are_told_apart_by_where_trains_stand() -> None:
    """A train that came to one place by two routes makes two states, and one deadlock."""
    a, b = Draft("a", "west"), Draft("b", "east")
    by = [Place(0, frozenset(), RouteId(x), ((SectionId("m"), 1),)) for x in ("straight", "curved")]
    a.moves["west"] = [(str(k), place, frozenset(), {}) for k, place in enumerate(by)]
    for place in by:
        a.holds[place] = frozenset({"m"})
        a.moves[place] = [("0", "out", frozenset({"n"}), {})]
    b.holds["east"] = frozenset({"n"})
    b.moves["east"] = [("0", "gone", frozenset({"m"}), {})]
    a.home.add("out")
    b.home.add("gone")
    built = build([a, b])
    found = explore(built.problem, built.start)
    assert (len(found.deadlocks), found.standing, found.states) == (2, 1, 7)


@pytest.mark.parametrize(
    ("path", "commands", "deadlocks"),
    [
        (MINE, ("in", "out"), 0),
        (MINE, ("1:W>E", "2:E>W"), 2),
        (MINE, WAYS, 4),
        (LOOPS, ("E1", "E2", "W1", "W2"), 1),
        ("layouts/fig2_1.yaml", ("V1", "V2"), 1),
        (PIT, PIT_VOYAGES, 3),
    ],
)
def test_every_state_is_judged_as_exhaustive_search_judges_it(
    path: str, commands: tuple[str, ...], deadlocks: int
) -> None:
    railway = case(path).ground.railway
    journeys = [railway.draft(errand(railway, c, 60.0)[0]) for c in commands]
    same = [[k.errand.train for k in journeys[:i] if k.start.under == j.start.under] for i, j in enumerate(journeys)]
    built = build([j.nodes(s) for j, s in zip(journeys, same, strict=True)], railway.held.zones)
    p, planner = built.problem, Planner(built.problem)
    found = explore(p, built.start)
    assert len(found.deadlocks) == deadlocks and found.deadlocks <= found.unsafe
    for state in found.unsafe:
        assert planner.solve(state).verdict is Verdict.NONE
    todo, seen = [built.start], {built.start}
    while todo:
        state = todo.pop()
        assert (planner.solve(state).verdict is Verdict.PLAN) == (state not in found.unsafe)
        for b in p.at(state):
            for m in p.moves[b]:
                after = state & ~m.source | m.target
                if p.possible(state, m) and after not in seen:
                    seen.add(after)
                    todo.append(after)
    assert len(seen) == found.states
    with pytest.raises(TooManyStates):
        explore(p, built.start, most=3)


def test_the_order_of_commands_changes_no_verdict() -> None:
    railway = case(PIT).ground.railway
    verdicts = set()
    for order in permutations(PIT_VOYAGES[1:], 3):
        journeys = [railway.draft(errand(railway, c, 60.0)[0]) for c in order]
        built = build([j.nodes() for j in journeys], railway.held.zones)
        verdicts.add(len(explore(built.problem, built.start).unsafe))
    assert len(verdicts) == 1


def test_a_train_that_is_longer_than_its_track_keeps_the_points() -> None:
    railway = case(MINE).ground.railway
    short, long = (railway.draft(errand(railway, "1:W>E", m)[0]) for m in (60.0, 320.0))
    assert {str(p) for p in short.steps} >= {"q3", "q4"}
    assert {str(p) for p in long.steps} >= {"q2 q3", "q2 q4"} and "q3" not in {str(p) for p in long.steps}


@pytest.mark.parametrize(
    ("command", "says"),
    [
        ("nowhere", "neither a voyage nor a command"),
        ("1:X>E", "no train comes in at X"),
        ("1:W>Z", "there is no place Z"),
        ("1:W>E+q99", "there is no section q99"),
        ("1:q99/X1>E", "there is no section q99"),
        ("1:q1/X99>E", "there is no signal X99"),
        ("1:q1/X4>E", "does not stand at an end of q1"),
        ("1:W", "neither a voyage nor a command"),
        ("", "neither a voyage nor a command"),
    ],
)
def test_a_command_that_makes_no_sense_is_told(command: str, says: str) -> None:
    with pytest.raises(BadOrder, match=says) as told:
        errand(case(MINE).ground.railway, command, 60.0)
    assert told.value.code == "IL6004"


def test_a_place_to_which_no_chain_of_routes_leads() -> None:
    railway = case(MINE).ground.railway
    with pytest.raises(NoVoyage, match="1 leaves at E, and does not come back"):
        railway.draft(errand(railway, "1:W>E>W", 60.0)[0])
    with pytest.raises(NoVoyage, match="takes 1 from W to q7"):
        railway.draft(errand(railway, "1:W>q7", 60.0)[0])


# --- the replay --------------------------------------------------------------------------------


@lru_cache
def replay() -> Replay:
    ground = case(MINE).ground
    return Replay(ground.layout, ground.controller, closed_loop(ground.layout, ground.controller).plant)


def good() -> Plan:
    trains = (PlanTrain("a", 60.0, "W", "gone"), PlanTrain("b", 60.0, "E", "gone", 2))
    moves = (("a", "X7-X1"), ("a", "X1-X5"), ("b", "X4-X2"), ("a", "X5-E"), ("b", "X2-W"))
    return Plan(case(MINE).layout.digest, trains, moves)


def test_a_plan_is_replayed_and_read_back() -> None:
    plan = good()
    assert from_text(to_text(plan)) == plan
    (found,) = replay().check([plan])
    assert found.wrong is None and 0 < found.grant <= 4 and 0 < found.opened <= 6 and found.scans > 100


@pytest.mark.parametrize(
    ("moves", "says"),
    [
        ((0, 1, 2, 3), "at the end b is in q5, not in gone"),
        ((1, 2, 3, 4), "move 1: a does not stand before X1"),
        ((0, 2, 1, 3, 4, 4), "move 6: b has left"),
        ((0, 2, 4), "X2-W is not granted to b"),
        ((0, 0), "move 2: X7-X1 is not granted to a"),
    ],
)
def test_a_plan_that_does_not_work_is_refused(moves: tuple[int, ...], says: str) -> None:
    plan = good()
    trains = (plan.trains[0], replace(plan.trains[1], comes=1))
    (found,) = replay().check([replace(plan, trains=trains, moves=tuple(plan.moves[k] for k in moves))])
    assert found.wrong is not None and says in found.wrong


def test_a_plan_that_is_blocked_by_a_train_outside_is_refused() -> None:
    plan = good()
    (found,) = replay().check([replace(plan, moves=(*plan.moves[:2], *plan.moves[3:4]))])
    assert found.wrong is not None and "X5 does not open for a" in found.wrong


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"layout": "0" * 64}, "another layout"),
        ({"moves": (("c", "X7-X1"),)}, "c, which is no train"),
        ({"moves": (("a", "X7-X9"),)}, "X7-X9, which is no route"),
        ({"trains": (PlanTrain("a", 60.0, "Q", "gone"),), "moves": ()}, "no place"),
        ({"trains": (PlanTrain("a", 60.0, (("q1", 9),), "gone"),), "moves": ()}, "no place"),
    ],
)
def test_a_plan_of_another_layout_is_refused(change: dict[str, object], says: str) -> None:
    with pytest.raises(BadPlan, match=says):
        replay().check([replace(good(), **change)])  # type: ignore[arg-type]


@pytest.mark.parametrize("text", ["", "[]", "{}", "{", "null", '{"interlock_plan": 2}', to_text(good())[:200]])
def test_a_file_that_is_no_plan_is_refused(text: str) -> None:
    with pytest.raises(BadPlan):
        from_text(text)


def test_a_dispatcher_sets_at_least_one_route_ahead() -> None:
    ground = case(MINE).ground
    with pytest.raises(ValueError, match="at least one"):
        Dispatcher(ground.railway, ground.controller.symbols, look_ahead=0)
    far = case(MINE).run([[("1:W>E", 0, 0, 60.0)]], look_ahead=2)
    assert far.ahead == 2 and not far.stuck


def test_a_train_changes_ends_for_the_route_that_it_has_now() -> None:
    """One that was to turn for a route that was taken back turned for the next one, too, and stood with its signal
    behind it; one that had turned did not turn back."""
    ground = case("layouts/passing_loop.yaml").ground
    loop = SectionId("3G")
    way = next(t for t in ground.rails.topo.traversals[loop] if ground.rails.topo.beyond(loop, t.exit) == "2DG")
    train = Train("1", 60.0, 11.0)
    train.under.append(ground.rails.spot(way))
    for there in (False, True):  # not there yet it goes by what the plan says
        train.there = there
        ground.changes_ends(train, loop, True, SignalId("S3"))
        assert train.turns == {"3G"}
        ground.changes_ends(train, loop, False, SignalId("X3"))
        assert train.turns == set()
    train.under[0] = Spot(loop, way.exit, way.entry, way.length)
    ground.changes_ends(train, loop, False, SignalId("X3"))
    assert train.turns == {"3G"}


# --- figure 2-1 ----------------------------------------------------------------------------------


def first_on_the_line(policy: Policy | None, offsets: tuple[int, ...]) -> list[str]:
    """Voyages 1 and 2 of figure 2-1, the second so many scans later: which is set over the single line first."""
    c = case("layouts/fig2_1.yaml")
    ground = c.ground
    runs = []
    for x in offsets:
        times = {"V1": max(0, -x), "V2": max(0, x)}
        runs.append([Coming(errand(ground.railway, v, 60.0)[0], 0, t, voyage=v) for v, t in times.items()])
    found = ground.run(runs, lambda: Dispatcher(ground.railway, ground.controller.symbols, policy=policy))
    assert [o.stuck for o in found if o.stuck] == []
    return [next(t for t, r in o.asked if r.split("-")[0] in ("SV", "SE")) for o in found]


@pytest.mark.parametrize(
    ("policy", "first"),
    [
        (None, ["V2", "V2", "V1", "V1", "V1"]),
        (Policy.LITERAL, ["V2", "V2", "V2", "V1", "V1"]),
        (Policy.FIRST_TO_REACH, ["V2", "V2", "V1", "V1", "V1"]),
        (Policy.FIRST_TO_REQUEST, ["V2", "V2", "V1", "V1", "V1"]),
    ],
)
def test_the_readings_of_the_books_rule(policy: Policy | None, first: list[str]) -> None:
    assert first_on_the_line(policy, (-60, -10, 0, 10, 60)) == first


def test_a_policy_asks_who_started_reached_and_was_commanded() -> None:
    railway = case("layouts/fig2_1.yaml").ground.railway
    runs = [Run(v, railway.draft(errand(railway, v, 60.0)[0])) for v in ("V1", "V2")]
    for run, other in (runs, runs[::-1]):
        run.voyage, run.lines = run.name, {other.name: frozenset({SectionId("C"), SectionId("D")})}
    one, two = runs
    order = {"V1": 0, "V2": 1}
    assert yields(Policy.FIRST_TO_REQUEST, two, one, order) and not yields(Policy.FIRST_TO_REQUEST, one, two, order)
    one.started, two.started = 1, 2
    assert yields(Policy.LITERAL, one, two, order) and not yields(Policy.LITERAL, two, one, order)
    assert not yields(Policy.FIRST_TO_REACH, two, one, order), "neither stands before the line"
    one.place = one.journey.steps[one.place][0].after
    assert yields(Policy.FIRST_TO_REACH, two, one, order) and not yields(Policy.FIRST_TO_REACH, one, two, order)
