"""The public deadlock instances of `luteberget/deadlockrail`, read, decided, and each plan replayed.

    python -m tests.campaigns.deadlock FOLDER [-o proofs/deadlock.md]

FOLDER is a checkout of that repository; nothing of it is kept here.  Three formats: `benchmark_sasso` (2021),
`benchmark_sasso_2023`, `benchmark_twotrainscaling`.  A train holds the route in which its head is, and those behind it
until the routes ahead of them are as long as the train.  A route is taken by one train at a time; another may not hold
a route that excludes it, and may not take one while a train that is longer than its stopping place lies over the
switch.  A plan is replayed by `replayed`, which reads the instance again and shares nothing with model and search.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from interlock.dispatch.plan.problem import Built, Draft, build
from interlock.dispatch.plan.search import Answer, Planner, Verdict
from tests.campaigns.origin import processor


@dataclass(frozen=True)
class Leg:
    """A route as one train uses it; lengths in the instance's unit; `onward`: None where the train is out."""

    length: int
    train: int
    stopping: int
    excludes: frozenset[str]
    over_switch: frozenset[str]
    onward: tuple[str, ...] | None


@dataclass(frozen=True)
class Instance:
    """Trains with the routes that they hold at first, from the rear, and all that they may use."""

    starts: Mapping[str, tuple[str, ...]]
    legs: Mapping[str, Mapping[str, Leg]]


def read(path: Path) -> Instance:
    """An instance in any of the three formats."""
    data = json.loads(path.read_text("utf-8"))
    if "conflicts" not in data:
        return _series(data)
    return _recent(data) if "safeplace_alt_path_set" in data else _first(data)


def _series(data: Any) -> Instance:
    legs = {
        t["name"]: {
            r: Leg(
                x["route_length"],
                x["train_length"],
                x["route_length_without_switch"],
                frozenset(x["unconditional_conflicts"]),
                frozenset(x["allocation_conflicts"]),
                None if x["next_routes"] is None else tuple(x["next_routes"]),
            )
            for r, x in t["routes"].items()
        }
        for t in data["trains"]
    }
    return _ordered({t["name"]: tuple(t["initial_routes"]) for t in data["trains"]}, legs)


def _conflicts(data: Any) -> dict[str, list[tuple[int, frozenset[str]]]]:
    found: dict[str, list[tuple[int, frozenset[str]]]] = {}
    for c in data["conflicts"]:
        found.setdefault(c["route"], []).append((c["length"], frozenset(c["conflicts"]) - {c["route"]}))
    return found


def _leg(x: Any, sets: list[tuple[int, frozenset[str]]], last: bool) -> Leg:
    if len(sets) == 1:
        sets = [*sets, (sets[0][0] + 1, frozenset())]
    if not sets:
        sets = [(1, frozenset()), (2, frozenset())]
    (short, first), (whole, second) = sets
    over = second if x["length"] > short else frozenset()
    return Leg(whole, x["length"], short, first, over, None if last else tuple(x["next_routes"]))


def _first(data: Any) -> Instance:
    sets = _conflicts(data)
    trains = [t for t in data["trains"] if not t["is_dummy"]]
    legs: dict[str, dict[str, Leg]] = {t["id"]: {} for t in trains}
    for x in data["train_routes"]:
        if x["train"] in legs:
            legs[x["train"]][x["route"]] = _leg(x, sets.get(x["route"], []), x["is_black_hole"])
    return _ordered({t["id"]: tuple(t["initial_routes"]) for t in trains}, legs)


def _recent(data: Any) -> Instance:
    """2023: several trains may begin on one route, in a known order; then each has a place of its own there, from
    which it goes on through the places of those in front of it."""
    sets = _conflicts(data)
    holders: dict[str, list[str]] = {}
    for t in data["trains"]:
        for r in t["initial_routes"]:
            holders.setdefault(r, []).append(t["id"])
    shared = {t for ts in holders.values() if len(ts) > 1 for t in ts}
    ahead = {t["id"]: (t["initial_multitrain_prev_trainid"] or [None])[0] for t in data["trains"]}
    starts: dict[str, tuple[str, ...]] = {}
    legs: dict[str, dict[str, Leg]] = {}
    for t in data["trains"]:
        own = {x["route"]: x for x in data["train_routes"] if x["train"] == t["id"]}
        made = legs[t["id"]] = {
            r: _leg(x, sets.get(r, []), x["is_black_hole"] or not x["next_routes"]) for r, x in own.items()
        }
        starts[t["id"]] = tuple(t["initial_routes"])
        if t["id"] in shared:
            begin = [own[r] for r in t["initial_routes"] if r in own]
            front = [x for x in begin if not set(x["next_routes"]) & set(t["initial_routes"])]
            out = tuple(n for x in front[:1] for n in x["next_routes"])
            row, who = [t["id"]], ahead[t["id"]]
            while who is not None:
                row.append(who)
                who = ahead[who]
            over: frozenset[str] = frozenset(y for x in begin for y in sets[x["route"]][0][1] | {x["route"]})
            for k, w in enumerate(row):
                onward = (f"init_{row[k + 1]}",) if k + 1 < len(row) else out
                first = k == 0
                made[f"init_{w}"] = Leg(0, max(x["length"] for x in begin) if first else 0, 0,
                                        over if first else frozenset(), frozenset(), onward)  # fmt: skip
            starts[t["id"]] = (f"init_{t['id']}",)
    return _ordered(starts, legs)


def _ordered(starts: Mapping[str, tuple[str, ...]], legs: Mapping[str, Mapping[str, Leg]]) -> Instance:
    """The routes held at first, from the rear to the head; one that is not the train's holds nobody up."""
    out = {}
    for t, at in starts.items():
        held = [r for r in at if r in legs[t]]
        rest, row = set(held), []
        while rest:
            heads = [r for r in held if r in rest and not any(r in (legs[t][x].onward or ()) for x in rest - {r})]
            row.append(heads[0])
            rest.discard(heads[0])
        out[t] = tuple(row)
    return Instance(out, legs)


def freed(legs: Mapping[str, Leg], held: tuple[str, ...]) -> tuple[str, ...]:
    """What a train still holds when it has moved up as far as its head goes; nothing where it is out."""
    if legs[held[-1]].onward is None:
        return ()
    while len(held) > 1 and sum(legs[r].length for r in held[1:]) >= legs[held[0]].train:
        held = held[1:]
    return held


def modelled(instance: Instance) -> Built:
    """The instance as trains, nodes and moves."""
    drafts = []
    for t, start in instance.starts.items():
        legs = instance.legs[t]
        start = freed(legs, start)
        d = Draft(t, start)
        todo, known = [start], {start}
        while todo:
            held = todo.pop()
            if not held:
                d.gone.add(held)
                continue
            d.holds[held] = _held(legs, held)
            for r in legs[held[-1]].onward or ():
                if r not in legs:
                    continue
                after = freed(legs, (*held, r))
                needs = {("route", r), ("excluded", r), ("switch", r), *(("route", c) for c in legs[r].excludes)}
                d.moves.setdefault(held, []).append((r, after, frozenset(needs), {}))
                if after not in known:
                    known.add(after)
                    todo.append(after)
        drafts.append(d)
    return build(drafts)


def _held(legs: Mapping[str, Leg], held: tuple[str, ...]) -> frozenset[object]:
    things: set[object] = set()
    for k, r in enumerate(held):
        things |= {("route", r), *(("excluded", c) for c in legs[r].excludes)}
        over = legs[r].train - legs[r].stopping
        if sum(legs[x].length for x in held[k + 1 :]) < over or k == len(held) - 1:
            things |= {("switch", c) for c in legs[r].over_switch}
    return frozenset(things)


def replayed(instance: Instance, plan: Sequence[tuple[str, str]]) -> str | None:
    """What is wrong with a plan, given as train and route in order; None if all trains are out at its end."""
    held = dict(instance.starts)
    for t, r in plan:
        legs = instance.legs[t]
        if not held[t] or r not in (legs[held[t][-1]].onward or ()):
            return f"{t} cannot go on to {r}"
        for u, theirs in held.items():
            if u == t:
                continue
            for k, x in enumerate(theirs):
                leg = instance.legs[u][x]
                if x == r or r in leg.excludes or x in legs[r].excludes:
                    return f"{r} for {t} excludes {x}, which {u} holds"
                onward = sum(instance.legs[u][y].length for y in theirs[k + 1 :])
                lies = x == theirs[-1] or onward < leg.train - leg.stopping
                if r in leg.over_switch and lies:
                    return f"{u} lies over the switch of {r}"
        now = (*held[t], r)
        if legs[r].onward is None:
            now = ()
        while len(now) > 1 and sum(legs[y].length for y in now[1:]) >= legs[now[0]].train:
            now = now[1:]
        held[t] = now
    left = [t for t, theirs in held.items() if theirs]
    return f"{', '.join(left)} did not get out" if left else None


def clash(instance: Instance) -> str | None:
    """Two trains that hold at the start what excludes each other: no state with both of them follows."""
    held = {t: freed(instance.legs[t], x) for t, x in instance.starts.items()}
    for t, ours in held.items():
        for u, theirs in held.items():
            for a in ours if t != u else ():
                for b in theirs:
                    if b == a or b in instance.legs[t][a].excludes:
                        return f"{t} in {a} and {u} in {b} exclude each other at the start"
    return None


def decide(instance: Instance, budget: int = 2_000_000) -> tuple[Answer, tuple[tuple[str, str], ...]]:
    """The verdict, and the plan as train and route."""
    if clash(instance):
        return Answer(Verdict.NONE), ()
    built = modelled(instance)
    answer = Planner(built.problem, budget).solve(built.start)
    return answer, tuple((built.problem.trains[m.train], m.label) for m in answer.plan)


def published(folder: Path) -> dict[str, str]:
    """The verdicts in the repository's own logs, by file."""
    found: dict[str, str] = {}
    for log in sorted((folder / "docs").glob("*.txt")):
        name = ""
        for line in log.read_text("utf-8", errors="replace").splitlines():
            if line.startswith("instance "):
                name = line.split()[1].rsplit("/", 1)[-1]
                name = name if name.endswith(".json") else f"instance{name}.json"
            elif name and ("LIVE:" in line or "DEADLOCKED:" in line):
                said = "LIVE" if "LIVE:" in line else "DEADLOCKED"
                if found.setdefault(name, said) != said:
                    found[name] = "contradicting"
    return found


FOLDERS = ("benchmark_sasso", "benchmark_sasso_2023", "benchmark_twotrainscaling")
SAID = {Verdict.PLAN: "LIVE", Verdict.NONE: "DEADLOCKED", Verdict.UNKNOWN: "UNKNOWN"}


def rows(folder: Path) -> list[list[str]]:
    """A row for each instance; the time is that of model and search in this process, the best of three."""
    told = published(folder)
    found = []
    for group in FOLDERS:
        for path in sorted((folder / group).glob("*.json"), key=lambda p: (len(p.name), p.name)):
            instance = read(path)
            times = []
            for _ in range(3):
                began = time.perf_counter()
                answer, plan = decide(instance)
                times.append(time.perf_counter() - began)
            said = SAID[answer.verdict]
            wrong = replayed(instance, plan) if said == "LIVE" else clash(instance)
            proof = (
                ("replayed" if wrong is None else f"**{wrong}**") if said == "LIVE" else wrong or "exhaustive search"
            )
            theirs = told.get(path.name, "none published")
            same = theirs if theirs in (said, "none published") else f"**{theirs}**"
            count = str(len(plan)) if said == "LIVE" else ""
            name = path.stem.removeprefix("twotrack_multi_")
            found.append(
                [name, str(len(instance.starts)), said, same, count, proof, str(answer.states), f"{min(times):.3f}"]
            )
    return found


def main() -> int:
    """Write the table; 1 when a verdict differs, a plan fails, or one takes a second."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("-o", "--output", type=Path)
    parser.add_argument("--instances", default="", help="what to call the instances' version, for instance a commit")
    options = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=False)
    body = rows(options.folder)
    worst = max(body, key=lambda r: float(r[-1]))
    agree = sum(r[3] == r[2] for r in body)
    silent = sum(r[3] == "none published" for r in body)
    at = f" at {options.instances}" if options.instances else ""
    head = [
        "# Deadlock instances",
        "",
        f"`python -m tests.campaigns.deadlock FOLDER` at commit {commit.stdout.strip()}, {platform.machine()}, "
        f"{processor()}, {os.cpu_count()} cores (one is used), Python {platform.python_version()}, on the instances "
        f"of `luteberget/deadlockrail`{at}, none of which is kept here.",
        "",
        f"{len(body)} instances: {agree} verdicts as published, {silent} published nowhere, "
        f"{len(body) - agree - silent} otherwise.  Each plan was replayed by a reader of the instance that shares "
        f"nothing with model and search.  Worst: {worst[0]}, {worst[-1]} s.",
        "",
        "| instance | trains | verdict | published | moves | shown by | states | seconds |",
        "|---|---|---|---|---|---|---|---|",
    ]
    text = "\n".join([*head, *(f"| {' | '.join(r)} |" for r in body), ""])
    if options.output:
        options.output.write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)
    bad = [r for r in body if "**" in r[3] + r[5] or r[2] == "UNKNOWN" or float(r[-1]) >= 1]
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
