"""Schedules of trains: small problems with known answers, against brute force, bad files, the screen, the campaign."""

from __future__ import annotations

import json
from pathlib import Path
from random import Random
from typing import Any

import pytest

from interlock.planning.displib import parse, write
from interlock.planning.planner import Planned, schedule
from interlock.planning.verify import verified

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


@pytest.mark.parametrize("seed", range(40))
def test_small_problems_against_brute_force(seed: int) -> None:
    problem = small(seed)
    right, found = best(problem), told(problem)
    if right is None:
        assert found.none and found.plan is None
    else:
        assert found.plan is not None and found.plan.cost == right == found.bound
