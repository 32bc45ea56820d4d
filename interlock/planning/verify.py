"""A second opinion on plans: reads problem and solution as their files have them, imports nothing of the planner.

Input: JSON values of a DISPLIB problem and of a solution.  Output: the cost, and what is wrong, in words.
"""

from __future__ import annotations

from typing import Any


def verified(problem: Any, solution: Any) -> tuple[int, list[str]]:
    """The cost of a solution, and its faults; none: it keeps every rule of the problem."""
    trains, wrong = problem["trains"], list[str]()
    at: list[int | None] = [None] * len(trains)
    begun = [0] * len(trains)
    kept: dict[str, dict[int, int]] = {}
    """By resource: until when each train that has left it keeps it from others."""
    held: dict[str, set[int]] = {}
    starts: dict[tuple[int, int], int] = {}
    now = None
    for k, event in enumerate(solution["events"]):
        time, t, o = event["time"], event["train"], event["operation"]
        if now is not None and time < now:
            wrong.append(f"event {k} comes before the one in front of it")
        now = time
        if not (0 <= t < len(trains) and 0 <= o < len(trains[t])):
            wrong.append(f"event {k}: there is no operation {o} of train {t}")
            continue
        wrong += [f"event {k}: {text}" for text in _step(trains[t], at[t], begun[t], o, time)]
        before = at[t]
        if before is not None:
            for name, release in _uses(trains[t][before]):
                held[name].discard(t)
                kept.setdefault(name, {})[t] = max(time + release, kept.get(name, {}).get(t, time))
        for name, _ in _uses(trains[t][o]):
            late = {other for other, until in kept.get(name, {}).items() if time < until}
            keep = (held.setdefault(name, set()) | late) - {t}
            wrong += [f"event {k}: train {other} keeps {name} from train {t}" for other in sorted(keep)]
            held[name].add(t)
        at[t], begun[t] = o, time
        starts[t, o] = time
    wrong += [
        f"train {t} does not come to its end" for t, o in enumerate(at) if o is None or trains[t][o]["successors"]
    ]
    return sum(_cost(c, starts) for c in problem["objective"]), wrong


def _uses(operation: Any) -> list[tuple[str, int]]:
    return [(r["resource"], r.get("release_time", 0)) for r in operation.get("resources", [])]


def _step(train: Any, before: int | None, begun: int, o: int, time: int) -> list[str]:
    """What is wrong with a train's next operation."""
    wrong = []
    if before is None:
        if any(o in x["successors"] for x in train):
            wrong.append(f"operation {o} is not the train's first one")
    elif o not in train[before]["successors"]:
        wrong.append(f"operation {o} does not follow {before}")
    elif time < begun + train[before].get("min_duration", 0):
        wrong.append(f"operation {before} has not lasted long enough")
    if time < train[o].get("start_lb", 0):
        wrong.append(f"operation {o} begins too early")
    if time > train[o].get("start_ub", time):
        wrong.append(f"operation {o} begins too late")
    return wrong


def _cost(c: Any, starts: dict[tuple[int, int], int]) -> int:
    time = starts.get((c["train"], c["operation"]))
    if time is None:
        return 0
    due = c.get("threshold", 0)
    once = c.get("increment", 0) if time >= due else 0
    return int(c.get("coeff", 0) * max(0, time - due) + once)
