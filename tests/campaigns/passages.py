"""Every layout, from every boundary to every other: one, two and three trains, planned, replayed, and run.

    python -m tests.campaigns.passages [-o proofs/passages.md] [LAYOUT...]

Trains wait at their boundaries.  Each plan is replayed on the controller with its plant by `interlock.app.replay`,
which knows nothing of the planner; then the dispatcher is commanded the same and runs the trains by what lamps show.
Without layouts, all that are shipped and all of `tests/layouts_for_tests`.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import product
from pathlib import Path
from random import Random

from interlock.app.check import derive_file
from interlock.app.dispatch import Setting
from interlock.app.dispatching import Coming, Ground
from interlock.app.replay import Plan, Replay
from interlock.dispatch import Dispatcher
from interlock.dispatch.commands import errand
from interlock.dispatch.plan.errands import Errand, NoVoyage, TooManyPlaces
from interlock.dispatch.plan.railway import Railway
from interlock.dispatch.plan.search import Planner, Verdict
from interlock.model.elements import BoundaryKind
from interlock.proof.system.loop import closed_loop
from tests.campaigns.origin import processor

LENGTHS = (12.0, 60.0, 250.0)
GAPS = (0, 3, 25)
"""Scans between one train and the next."""
MOST = 400
"""Sets of two, and of three, trains of a layout that are planned; where there are more, they are drawn (our choice)."""
RUNS = 40
"""Sets of two, and of three, trains of a layout that are run by the dispatcher, each with every gap (our choice)."""

Set = tuple[Errand, ...]


@dataclass
class Found:
    """What was found on a layout.  sets, plans: by number of trains; wrong: what failed in replays; stuck: in runs."""

    ways: int = 0
    sets: dict[int, int] = field(default_factory=lambda: dict.fromkeys((1, 2, 3), 0))
    plans: dict[int, int] = field(default_factory=lambda: dict.fromkeys((1, 2, 3), 0))
    unknown: int = 0
    wrong: list[str] = field(default_factory=list)
    runs: int = 0
    stuck: list[str] = field(default_factory=list)
    troubles: set[str] = field(default_factory=set)


def ways(railway: Railway) -> list[tuple[str, str]]:
    """From boundary to boundary, wherever a chain of routes leads for some train."""
    layout, found = railway.layout, []
    for a, b in product(layout.track.boundaries, repeat=2):
        if a.kind is not BoundaryKind.OUT and b.kind is not BoundaryKind.IN:
            one = errand(railway, f"1:{a.node}>{b.node}", 1.0)[0]
            try:
                railway.draft(one)
            except (NoVoyage, TooManyPlaces):
                continue
            found.append((str(a.node), str(b.node)))
    return found


def sets(railway: Railway, lengths: Sequence[float], most: int = MOST) -> Iterator[Set]:
    """One train, two, three, each from somewhere to somewhere; their lengths are drawn."""
    rng, all_ways = Random(railway.layout.name), ways(railway)
    for trains in (1, 2, 3):
        chosen = list(product(all_ways, repeat=trains))
        rng.shuffle(chosen)
        for one in chosen[:most]:
            errands = [errand(railway, f"{k}:{a}>{b}", rng.choice(lengths))[0] for k, (a, b) in enumerate(one, 1)]
            try:
                for e in errands:
                    railway.draft(e)
            except NoVoyage:
                continue  # one of them is too long
            yield tuple(errands)


def tried(path: str, lengths: Sequence[float] = LENGTHS, most: int = MOST, runs: int = RUNS) -> Found:
    """Plans and runs on a layout."""
    checked, found = derive_file(path), Found()
    layout, table = checked.layout, checked.table
    assert checked.ok and layout is not None and table is not None, checked.diagnostics
    ground = Ground(layout, table)
    found.ways = len(ways(ground.railway))
    plans: list[tuple[Set, Plan]] = []
    for one in sets(ground.railway, lengths, most):
        setting = Setting(ground.railway, one)
        answer = Planner(setting.built.problem).solve(setting.built.start)
        found.sets[len(one)] += 1
        found.plans[len(one)] += answer.verdict is Verdict.PLAN
        found.unknown += answer.verdict is Verdict.UNKNOWN
        if answer.verdict is Verdict.PLAN:
            plans.append((one, setting.plan(layout.digest, answer.plan)))
    replay = Replay(layout, ground.controller, closed_loop(layout, ground.controller).plant)
    for k in range(0, len(plans), 128):
        part = plans[k : k + 128]
        done = replay.check([p for _, p in part])
        found.wrong += [f"{_said(one)}: {r.wrong}" for (one, _), r in zip(part, done, strict=True) if r.wrong]
    _run(ground, [one for one, _ in plans], runs, found)
    return found


def _run(ground: Ground, planned: Sequence[Set], runs: int, found: Found) -> None:
    chosen = [x for n in (1, 2, 3) for x in [s for s in planned if len(s) == n][:runs]]
    todo = [(one, gap) for one in chosen for gap in (GAPS if len(one) > 1 else GAPS[:1])]
    symbols = ground.controller.symbols
    for k in range(0, len(todo), 128):
        part = todo[k : k + 128]
        comings = [[Coming(e, 0, i * gap) for i, e in enumerate(one)] for one, gap in part]
        for (one, gap), o in zip(part, ground.run(comings, lambda: Dispatcher(ground.railway, symbols)), strict=True):
            found.runs += 1
            found.troubles |= set(o.troubles)
            if o.stuck:
                found.stuck.append(f"{_said(one)} every {gap} scans: {o.stuck}")


def _said(one: Set) -> str:
    return " ".join(f"{e.train}:{e.start[0][0]}>{e.legs[-1].to} ({e.length_m:g} m)" for e in one)


def row(path: str, found: Found) -> str:
    """A layout as a row of the table."""
    counts = " | ".join(f"{found.plans[n]} of {found.sets[n]}" for n in (1, 2, 3))
    hurt = ", ".join(sorted(found.troubles)) or "none"
    ends = f"{len(found.wrong)} | {found.runs} | {len(found.stuck)} | {hurt}"
    return f"| {Path(path).stem} | {found.ways} | {counts} | {found.unknown} | {ends} |"


def main() -> int:
    """Write the table; 1 when a plan fails on the controller or a train stands for ever."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("layouts", nargs="*")
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/passages.md"))
    options = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=False)
    here = [str(p) for folder in ("layouts", "tests/layouts_for_tests") for p in sorted(Path(folder).glob("*.yaml"))]
    began, rows, bad = time.process_time(), [], False
    for path in options.layouts or here:
        found = tried(path)
        bad |= bool(found.wrong or found.stuck or found.troubles)
        for text in (*found.wrong, *found.stuck):
            print(f"{path}: {text}", flush=True)
        if found.ways:
            rows.append(row(path, found))
    lines = [
        "# From every boundary to every other",
        "",
        f"`python -m tests.campaigns.passages` at commit {commit.stdout.strip()}, {platform.machine()}, {processor()}, "
        f"{os.cpu_count()} cores (one is used), Python {platform.python_version()}.",
        "",
        "Layouts on which a chain of routes leads from boundary to boundary; *ways*: how many such pairs.  One, two "
        f"and three trains of {', '.join(f'{x:g}' for x in LENGTHS)} m wait at their boundaries; *plans*: sets of "
        f"trains for which one exists, of all, or of {MOST} that were drawn.  Where none exists, every state was "
        "searched; *unknown*: where not.  *Fail*: plans that fail on the controller with its plant.  *Runs*: the "
        f"dispatcher carries out the same, each train {GAPS[0]}, {GAPS[1]} or {GAPS[2]} scans after the one before; "
        "*stuck*: runs in which a train stands for ever.  *Troubles*: hazards and broken assumptions of the plant.",
        "",
        "| layout | ways | plans, 1 train | 2 trains | 3 trains | unknown | fail | runs | stuck | troubles |",
        "|---|---|---|---|---|---|---|---|---|---|",
        *rows,
        "",
        f"All of it took {time.process_time() - began:.0f} s of processor time.",
        "",
    ]
    options.output.write_text("\n".join(lines), encoding="utf-8")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
