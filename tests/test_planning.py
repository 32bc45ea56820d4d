"""Schedules of trains: small problems with known answers, against brute force, bad files, the screen, the campaign."""

from __future__ import annotations

import json
from pathlib import Path
from random import Random
from time import monotonic
from typing import Any

import pytest
from click.testing import CliRunner

from interlock.cli.schedule import command
from interlock.planning.displib import BadFile, parse, read, read_solution, write
from interlock.planning.insertion import diary_of, without_waste
from interlock.planning.planner import Planned, schedule
from interlock.planning.recreate import Recreation
from interlock.planning.rules import by_rules
from interlock.planning.solver import Solver
from interlock.planning.verify import verified
from tests.campaigns import displib as campaign

SWAP = Path("tests/schedules/swap.json")


def operation(*resources: str, to: tuple[int, ...] = (), **fields: int) -> dict[str, Any]:
    release = fields.pop("release", 0)
    uses = [{"resource": r, "release_time": release} for r in resources]
    return {"resources": uses, "successors": list(to), **fields}


def line(*rows: dict[str, Any]) -> list[dict[str, Any]]:
    """Operations one after the other."""
    for k, row in enumerate(rows[:-1]):
        row["successors"] = [k + 1]
    return list(rows)


def delays(*ends: tuple[int, int], rate: int = 1, due: int = 0) -> list[dict[str, Any]]:
    return [{"type": "op_delay", "train": t, "operation": o, "coeff": rate, "threshold": due} for t, o in ends]


def best(problem: Any) -> int | None:
    """The least cost by trying every order of events, each as early as it can be; None: there is no plan."""
    trains, found = problem["trains"], list[int]()

    def costs(train: int, o: int, time: int) -> int:
        due = [c for c in problem["objective"] if (c["train"], c["operation"]) == (train, o)]
        return sum(
            c.get("coeff", 0) * max(0, time - c.get("threshold", 0))
            + (c.get("increment", 0) if time >= c.get("threshold", 0) else 0)
            for c in due
        )

    def go(at: dict[int, tuple[int, int]], free: dict[tuple[str, int], int], now: int, cost: int) -> None:
        if found and cost >= min(found):
            return
        if all(t in at and not trains[t][at[t][0]]["successors"] for t in range(len(trains))):
            found.append(cost)
            return
        for t, train in enumerate(trains):
            for o in (0,) if t not in at else train[at[t][0]]["successors"]:
                time = max(now, train[o].get("start_lb", 0))
                after = dict(free)
                if t in at:
                    before, begun = at[t]
                    time = max(time, begun + train[before].get("min_duration", 0))
                needs = {r["resource"] for r in train[o]["resources"]}
                held = {r["resource"] for u, (k, _) in at.items() if u != t for r in trains[u][k]["resources"]}
                if needs & held:
                    continue
                time = max([time, *(v for (r, u), v in free.items() if r in needs and u != t)])
                if time > train[o].get("start_ub", time):
                    continue
                if t in at:
                    for r in train[at[t][0]]["resources"]:
                        key = r["resource"], t
                        after[key] = max(after.get(key, 0), time + r["release_time"])
                go({**at, t: (o, time)}, after, time, cost + costs(t, o, time))

    go({}, {}, 0, 0)
    return min(found, default=None)


def told(problem: Any, seconds: float = 20) -> Planned:
    """A plan, verified."""
    found = schedule(parse(problem), seconds)
    if found.plan is not None:
        assert verified(problem, json.loads(write(found.plan))) == (found.plan.cost, [])
    return found


def small(seed: int) -> dict[str, Any]:
    """Two or three trains over a few resources, with alternatives, zero durations, releases and bounds."""
    r = Random(seed)
    names = [f"r{k}" for k in range(r.randint(2, 4))]
    trains, objective = [], []
    for t in range(r.choice((2, 2, 3))):
        size = r.randint(3, 5) if len(trains) < 2 else 3
        train = []
        for k in range(size):
            uses = r.sample(names, r.choice((0, 1, 1, 1, 2))) if 0 < k < size - 1 or r.random() < 0.2 else []
            row = operation(*uses, release=r.choice((0, 0, 1, 3)), min_duration=r.choice((0, 0, 1, 2, 5)))
            if k < size - 1:
                row["successors"] = [k + 1]
                if k + 2 < size and r.random() < 0.4:
                    row["successors"].append(k + 2)
            if r.random() < 0.15:
                row["start_lb"] = r.randint(0, 6)
            if r.random() < 0.08:
                row["start_ub"] = row.get("start_lb", 0) + r.randint(0, 8)
            train.append(row)
        train[-1]["resources"] = []
        trains.append(train)
        for _ in range(r.randint(1, 2)):
            o = r.choice((size - 1, r.randrange(size)))
            objective.append(
                {"type": "op_delay", "train": t, "operation": o, "threshold": r.randint(0, 8),
                 "coeff": r.randint(0, 3), "increment": r.choice((0, 0, 4))}
            )  # fmt: skip
    return {"trains": trains, "objective": objective}


@pytest.mark.parametrize("seed", range(2, 42))
def test_small_problems_against_brute_force(seed: int) -> None:
    problem = small(seed)
    right, found = best(problem), told(problem)
    if right is None:
        assert found.none and found.plan is None
    else:
        assert found.plan is not None and found.plan.cost == right == found.bound


def test_trains_never_change_places_at_one_time() -> None:
    """Each stands where the other one wants to go, and there is nothing beside them."""
    ring = [
        line(operation(a, start_ub=0), operation(b, min_duration=1), operation())
        for a, b in (("r1", "r2"), ("r2", "r3"), ("r3", "r1"))
    ]
    for trains in (ring, [ring[0], line(operation("r2", start_ub=0), operation("r1", min_duration=1), operation())]):
        found = told({"trains": trains, "objective": delays((0, 2), (1, 2))})
        assert found.none and found.plan is None, "CP-SAT's times alone allow it"
    bad = {"objective_value": 0, "events": [{"time": 0, "train": t, "operation": o} for o in (0, 1) for t in (0, 1, 2)]}
    _, wrong = verified({"trains": ring, "objective": []}, bad)
    assert "event 3: train 1 keeps r2 from train 0" in wrong


def test_a_train_steps_aside_where_places_cannot_be_changed_at_once() -> None:
    """What excludes that they are changed at once leaves the other paths as they were, with the same orders."""
    over = [operation(to=(1,)), operation("d", to=(2, 3)), operation(to=(3,)), operation("b")]
    back = [operation("b", to=(1, 2)), operation(to=(2,), start_lb=1), operation("d")]
    beside = {"trains": [over, line(operation(), operation(), operation()), back], "objective": []}
    assert told(beside).plan is not None and best(beside) == 0, "it was told that there is no plan"
    late = {
        "trains": [
            [operation(to=(1,), min_duration=1), operation("a", to=(2, 3)), operation(to=(3,)), operation("b")],
            [operation("d", to=(1, 2)), operation("b", to=(2,)), operation("a")],
            line(operation("a", release=1, min_duration=1), operation("d"), operation()),
        ],
        "objective": [{"type": "op_delay", "train": 1, "operation": 0, "coeff": 3, "increment": 4, "threshold": 0}],
    }
    found = told(late)
    assert found.plan is not None and found.plan.cost == best(late) == found.bound == 4, "7 was told to be the least"


def test_a_section_is_taken_over_at_once_and_in_order() -> None:
    follow = [line(operation(start_ub=0), operation("r", min_duration=5), operation()) for _ in range(2)]
    problem = {"trains": follow, "objective": delays((0, 2), (1, 2))}
    found = told(problem)
    assert found.plan is not None and found.plan.cost == 15 == found.bound
    events = json.loads(write(found.plan))["events"]
    a, b = (k for k, e in enumerate(events) if e["time"] == 5 and e["operation"] in (1, 2))
    assert events[a]["operation"] == 2 and events[b]["operation"] == 1, "who leaves comes before who enters"
    events[a], events[b] = events[b], events[a]
    assert verified(problem, {"events": events})[1], "the other order at the same time is refused"


def test_release_times_bind_between_trains_only() -> None:
    """One train uses a section twice without waiting; another one waits for its release."""
    twice = line(
        operation(start_ub=0),
        operation("r", min_duration=2, release=10),
        operation("q", min_duration=1),
        operation("r", min_duration=2, release=10),
        operation(),
    )
    alone = told({"trains": [twice], "objective": delays((0, 4))})
    assert alone.plan is not None and alone.plan.cost == 5
    other = line(operation(start_ub=0), operation("r", min_duration=1), operation())
    both = told({"trains": [twice, other], "objective": [*delays((0, 4), rate=100), *delays((1, 2))]})
    assert both.plan is not None and both.plan.cost == 500 + 16 == both.bound


def test_an_earlier_release_still_binds_when_the_train_has_come_back() -> None:
    long = line(operation("r", start_ub=0, min_duration=1, release=50), operation("r", min_duration=1), operation())
    other = line(operation(start_ub=0), operation("r", min_duration=1), operation())
    problem = {"trains": [long, other], "objective": [*delays((0, 2), rate=100), *delays((1, 2))]}
    found = told(problem)
    assert found.plan is not None and found.plan.cost == 200 + 52 == best(problem)


def test_two_trains_pass_in_a_loop() -> None:
    found = told(json.loads(SWAP.read_text("utf-8")))
    assert found.plan is not None and found.plan.cost == 30 and found.by == "rules" and found.best


RIGHT = 43
"""The least cost of the next problem."""


def deadlock() -> dict[str, Any]:
    """Two short trains and a long one, which fits into one of the two loops only: if the short ones take both, they
    stand before the long one for ever."""
    short = [
        [
            operation(to=(1,), start_ub=0),
            operation("west", to=(2, 3), min_duration=5),
            operation("loop 1", to=(4,), min_duration=1),
            operation("loop 2", to=(4,), min_duration=1),
            operation("east", to=(5,), min_duration=5),
            operation(),
        ]
        for _ in range(2)
    ]
    long = line(
        operation(start_ub=0),
        operation("east", min_duration=6),
        operation("loop 2", min_duration=1),
        operation("west", min_duration=6),
        operation(),
    )
    return {"trains": [*short, long], "objective": delays((0, 5), (1, 5), (2, 4))}


def test_a_greedy_dispatcher_would_stand_for_ever() -> None:
    problem = deadlock()
    at, held = [0, 0, 0], dict[str, int]()
    for train, o in ((2, 1), (0, 1), (0, 2), (1, 1), (1, 3)):  # each takes what is free and next
        held = {r: t for r, t in held.items() if t != train}
        needs = [r["resource"] for r in problem["trains"][train][o]["resources"]]
        assert not held.keys() & set(needs)
        held.update(dict.fromkeys(needs, train))
        at[train] = o
    for train, o in enumerate(at):
        for p in problem["trains"][train][o]["successors"]:
            wanted = {r["resource"] for r in problem["trains"][train][p]["resources"]}
            assert any(held.get(r, train) != train for r in wanted), "nobody can go on"
    rules, found = by_rules(parse(problem)), told(problem)
    assert rules is not None and not verified(problem, json.loads(write(rules)))[1]
    assert found.plan is not None and found.plan.cost == best(problem) == RIGHT == found.bound


def test_the_rules_are_there_when_time_is_not() -> None:
    found = told(deadlock(), seconds=0)
    assert found.plan is not None and found.by == "rules" and found.bound <= found.plan.cost


def test_local_search_finds_better_plans_and_the_solver_the_best(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = deadlock()
    asked = parse(problem)
    rules = by_rules(asked)
    assert rules is not None
    assert diary_of(asked, without_waste(asked, rules)).plan() == without_waste(asked, rules)
    whole = Solver(asked, 1, Random(0)).whole(rules, monotonic() + 20)
    assert whole.plan is not None and whole.plan.cost == RIGHT == whole.bound
    better = Recreation(asked, rules, Random(1), lambda p: None).run(monotonic() + 5)
    assert RIGHT <= better.cost < rules.cost and not verified(problem, json.loads(write(better)))[1]
    monkeypatch.setattr("interlock.planning.planner.installed", lambda: False)
    found = told(problem)
    assert found.plan is not None and RIGHT <= found.plan.cost < rules.cost and not found.none


BAD: tuple[tuple[str, str], ...] = (
    ("[1", "line 1, column 3: this is no JSON"),
    ("[]", "the file: an object is expected"),
    ("{}", "the file: the key 'trains' is missing"),
    ('{"trains": [], "objective": [], "more": 1}', "the file: there is no key 'more'"),
    ('{"trains": [[]], "objective": []}', "trains[0]: one operation must begin the train; no operation does"),
    ('{"trains": [[{"successors": [0]}]], "objective": []}', "trains[0][0].successors[0]: 0 is no later operation"),
    (
        '{"trains": [[{"successors": [1]}, {"successors": []}, {"successors": []}]], "objective": []}',
        "trains[0]: one operation must begin the train; operations 0, 2 do",
    ),
    ('{"trains": [[{"successors": [], "min_duration": -1}]], "objective": []}', "trains[0][0].min_duration: -1 is not"),
    ('{"trains": [[{"successors": [], "start_lb": 1.5}]], "objective": []}', "trains[0][0].start_lb: a whole number"),
    ('{"trains": [[{"successors": [], "start_lb": NaN}]], "objective": []}', "NaN is no number of JSON"),
    ('{"trains": [[{"successors": [], "start_lb": 3, "start_ub": 2}]], "objective": []}', "start_ub: 2 comes before"),
    ('{"trains": [[{"successors": [], "resources": [{"name": "r"}]}]], "objective": []}', "there is no key 'name'"),
    (
        '{"trains": [[{"successors": []}]], "objective": [{"type": "op_delay", "train": 1, "operation": 0}]}',
        "objective[0].train: there is no train 1",
    ),
    (
        '{"trains": [[{"successors": []}]], "objective": [{"type": "op_delay", "train": 0}]}',
        "objective[0]: the key 'operation' is missing",
    ),
    ("[" * 100_000, "this is nested too deeply"),
    (f'{{"trains": [], "objective": {"9" * 5000}}}', "this has a number in it of more digits than are read"),
)


@pytest.mark.parametrize(("text", "said"), BAD, ids=[said for _, said in BAD])
def test_a_bad_file_is_told_with_its_place(text: str, said: str, tmp_path: Path) -> None:
    file = tmp_path / "bad.json"
    file.write_text(text, "utf-8")
    with pytest.raises(BadFile) as caught:
        read(file)
    assert said in str(caught.value)
    done = CliRunner().invoke(command, [str(file)])
    assert done.exit_code == 1 and said in done.output and "Traceback" not in done.output


def test_the_screen_and_the_file(tmp_path: Path) -> None:
    target = tmp_path / "plan.json"
    done = CliRunner().invoke(command, [str(SWAP), "-o", str(target), "--seconds", "5"])
    assert done.exit_code == 0 and "a plan that costs 30 (rules); no plan costs less" in done.output
    assert read_solution(target, read(SWAP)).cost == 30
    assert verified(json.loads(SWAP.read_text("utf-8")), json.loads(target.read_text("utf-8"))) == (30, [])
    again = CliRunner().invoke(command, [str(SWAP), "-o", str(target), "--format", "json"])
    assert again.exit_code == 0 and json.loads(again.stdout)["best"]
    other = tmp_path / "mine.txt"
    other.write_text("mine", "utf-8")
    done = CliRunner().invoke(command, [str(SWAP), "-o", str(other)])
    assert done.exit_code == 1 and "--force" in done.output and other.read_text("utf-8") == "mine"
    none = tmp_path / "none.json"
    late = {"trains": [line(operation(min_duration=3), operation(start_ub=1))], "objective": []}
    none.write_text(json.dumps(late), "utf-8")
    done = CliRunner().invoke(command, [str(none)])
    assert done.exit_code == 1 and "there is no plan" in done.output


def test_the_campaign_goes_on_where_it_was_broken_off(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    problems, solutions = tmp_path / "problems", tmp_path / "solutions"
    problems.mkdir()
    solutions.mkdir()
    for k in (1, 2):
        (problems / f"loop_{k}.json").write_bytes(SWAP.read_bytes())
    plan = schedule(read(SWAP), 1).plan
    assert plan is not None
    (solutions / "loop_1_somebody.json").write_text(write(plan), "utf-8")
    kept, out = tmp_path / "kept", tmp_path / "page.md"
    for only in ("loop_1", "loop"):
        args = ["displib", "--problems", str(problems), "--seconds", "1", "--kept", str(kept), "-o", str(out)]
        monkeypatch.setattr("sys.argv", [*args, "--only", only])
        assert campaign.main() == 0
    assert capsys.readouterr().out.count("loop_1 30") == 1
    page = out.read_text("utf-8")
    assert "| loop_1 | 2 | 12 | 30 | 30 | 30 | 0.0 | **30** | rules | own |" in page
    assert "2 of 2 instances have a plan that holds" in page
