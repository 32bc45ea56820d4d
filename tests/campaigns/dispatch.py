"""Commands on the controller with its plant: how many trains stand for ever, with the rule and without it.

    python -m tests.campaigns.dispatch [--renamings N] [-j N] [-o proofs/dispatch.md]

Every plan that the dispatcher held is replayed on the controller by `interlock.app.replay`, which knows nothing of the
planner.  A renaming gives every signal, section, point, track and boundary another name; the requests must be the same
ones, under the other names.
"""

from __future__ import annotations

import argparse
import os
import platform
import re
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import permutations
from pathlib import Path
from random import Random

import yaml

from interlock.app.dispatching import Coming, Ground, Outcome
from interlock.app.replay import GONE, Plan, PlanTrain, Replay
from interlock.dispatch import Dispatcher
from interlock.dispatch.commands import errand
from interlock.dispatch.plan.errands import OUTSIDE, Errand
from interlock.proof.system.loop import closed_loop
from tests.campaigns.origin import processor
from tests.layouts import grown

MINE, LOOPS, PIT = "layouts/mine11.yaml", "tests/layouts_for_tests/two_loops.yaml", "layouts/pit_bottom.yaml"
HEISHAN = "layouts/heishan.yaml"
GAPS = (0, 3, 10, 25, 40, 60, 80, 120)
"""Scans between one train and the next."""

Timed = tuple[str, int, int, float]
"""A command, the scan in which it is given, that in which its train comes, and the train's length."""


def timings(first: str, second: str, length: float = 60.0, ahead: bool = False) -> list[list[Timed]]:
    """Two trains, 72 times: each before the other by up to 180 scans; commanded when they come, or both at once."""
    found = []
    for k in range(-36, 36):
        a, b = max(0, -5 * k), max(0, 5 * k)
        found.append([(first, 0 if ahead else a, a, length), (second, 0 if ahead else b, b, length)])
    return found


def orders(
    commands: Sequence[str], number: int, length: float = 60.0, gaps: Sequence[int] = GAPS, ahead: bool = True
) -> list[list[Timed]]:
    """So many of the commands, in all orders, one train after the other; all commanded at first, or when they come."""
    return [
        [(c, 0 if ahead else k * gap, k * gap, length) for k, c in enumerate(order)]
        for order in permutations(commands, number)
        for gap in gaps
    ]


PIT_VOYAGES = ("1:W>E+q4_tippler", "2:W>q13_man>W", "3:W>q11_material>W", "4:E>W")
ADIT = ("1:W>s4_xc1>OUT", "2:W>s10_xc4>OUT", "3:W>s11_xc5>OUT", "4:W>s8_xc3>OUT", "5:W>s5_xc2>OUT", "6:W>s5_xc2>OUT")

WAYS = ("1:W>E", "2:E>W", "3:W>E")
UNANNOUNCED = "the same, of which nobody is told before they come"
"""Trains that come unannounced where others are to leave can be caught: the dispatcher says so, and whom."""

CASES: list[tuple[str, str, Callable[[], list[list[Timed]]]]] = [
    ("mine11: the two voyages, 72 timings", MINE, lambda: timings("in", "out")),
    ("the same, commanded before they come", MINE, lambda: timings("in", "out", ahead=True)),
    ("mine11: any way, 72 timings", MINE, lambda: timings("1:W>E", "2:E>W")),
    ("the same, trains of 320 m", MINE, lambda: timings("1:W>E", "2:E>W", 320.0)),
    ("the same, commanded before they come", MINE, lambda: timings("1:W>E", "2:E>W", 320.0, ahead=True)),
    ("mine11: any way, three trains in all orders", MINE, lambda: orders(WAYS, 3)),
    (UNANNOUNCED, MINE, lambda: orders(WAYS, 3, ahead=False)),
    ("two_loops: three trains in all orders", LOOPS, lambda: orders(("E1", "E2", "W1", "W2"), 3)),
    ("two_loops: four trains in all orders", LOOPS, lambda: orders(("E1", "E2", "W1", "W2"), 4)),
    ("pit_bottom: three trains in all orders", PIT, lambda: orders(PIT_VOYAGES, 3)),
    ("pit_bottom: four trains in all orders", PIT, lambda: orders(PIT_VOYAGES, 4, gaps=GAPS[::2])),
    ("heishan: six trains, loading and out again", HEISHAN, lambda: orders(ADIT, 6, gaps=(10,))[::60]),
]


@dataclass
class Found:
    """What a case showed."""

    runs: int = 0
    stuck: int = 0
    ahead: int = 0
    refused: int = 0
    moves: int = 0
    troubles: set[str] = field(default_factory=set)
    plans: int = 0
    wrong: list[str] = field(default_factory=list)
    grant: int = 0
    outcomes: list[Outcome] = field(default_factory=list)


class Case:
    """A layout, ready to run commands."""

    def __init__(self, text: str) -> None:
        made = grown(text)
        assert made is not None
        self.layout, self.table, _ = made
        self.ground = Ground(self.layout, self.table)

    def coming(self, run: Sequence[Timed]) -> list[Coming]:
        """The commands of a run."""
        railway = self.ground.railway
        return [Coming(errand(railway, c, length)[0], at, due) for c, at, due, length in run]

    def run(self, runs: Sequence[Sequence[Timed]], rule: bool = True, **how: int) -> Found:
        """All runs of a case."""
        found = Found(len(runs))
        symbols = self.ground.controller.symbols

        def make() -> Dispatcher:
            return Dispatcher(self.ground.railway, symbols, rule=rule, **how)

        for k in range(0, len(runs), 96):
            part = [self.coming(r) for r in runs[k : k + 96]]
            for o in self.ground.run(part, make):
                found.stuck += bool(o.stuck)
                found.ahead = max(found.ahead, o.ahead)
                found.refused += o.refused
                found.moves += len(o.asked)
                found.troubles |= set(o.troubles)
                found.outcomes.append(o)
        return found

    def replay(self, runs: Sequence[Sequence[Timed]], found: Found) -> None:
        """Every plan that was held in these runs, each once."""
        plans: dict[Plan, None] = {}
        for run, o in zip(runs, found.outcomes, strict=True):
            errands = [c.errand for c in self.coming(run)]
            for asked, held in o.plans:
                plans[self.plan(errands, asked, held)] = None
        controller = self.ground.controller
        replay = Replay(self.layout, controller, closed_loop(self.layout, controller).plant)
        todo = list(plans)
        found.plans = len(todo)
        for k in range(0, len(todo), 96):
            for r in replay.check(todo[k : k + 96]):
                found.grant = max(found.grant, r.grant)
                if r.wrong:
                    found.wrong.append(r.wrong)

    def plan(
        self, errands: Sequence[Errand], asked: tuple[tuple[str, str], ...], held: tuple[tuple[str, str], ...]
    ) -> Plan:
        """What had been granted, and the plan that was held then; trains that were not yet in come after the first."""
        moves = (*asked, *held)
        trains = []
        for e in errands:
            own = [r for t, r in moves if t == e.train]
            if not own:
                continue
            last = self.table.route[own[-1]]  # type: ignore[index]
            ends = GONE if last.path.exit_kind == "boundary" else str(last.path.section_ids[-1])
            outside = e.start[0][1] == OUTSIDE
            start = str(e.start[0][0]) if outside else tuple((str(s), n) for s, n in e.start)
            first = next(k for k, (t, _) in enumerate(moves) if t == e.train)
            trains.append(PlanTrain(e.train, e.length_m, start, ends, min(first, len(asked) + 1) if outside else 0))
        return Plan(self.layout.digest, tuple(trains), moves)


def renamed(text: str, seed: int) -> tuple[str, dict[str, str]]:
    """The layout with other names for everything but voyages, and the old name of each."""
    rng = Random(seed)
    data = yaml.safe_load(text)
    names = {*data["boundaries"], *data["tracks"], *data.get("points", {}), *data["signals"]}
    names |= {b["approach"].split()[0] for b in data["boundaries"].values() if isinstance(b, dict) and "approach" in b}
    names |= {p["section"] for p in data.get("points", {}).values()}
    names |= {x.split()[0] for items in data["tracks"].values() for x in items}
    old = sorted(str(n) for n in names)
    new = [
        f"{rng.choice('ABCDEFGHKLMNPQSTUVXYZabcdefghkmnpqstuvxyz')}{k}x" for k in rng.sample(range(100, 999), len(old))
    ]
    to = dict(zip(old, new, strict=True))
    body = "\n".join(line.split("#")[0].rstrip() for line in text.splitlines())
    head, _, rest = body.partition("boundaries:")
    rest = re.sub(r"[A-Za-z0-9_]+(?![A-Za-z0-9_]*\s*:\s*\S*\s*\S*label)", lambda m: to.get(m[0], m[0]), rest)
    return head + "boundaries:" + rest, {n: o for o, n in to.items()}


RENAMED = {
    "mine11, the two voyages": (MINE, lambda: timings("in", "out")),
    "two_loops, four trains in all orders": (LOOPS, lambda: orders(("E1", "E2", "W1", "W2"), 4, gaps=(10,))),
}


def renaming(what: str, seed: int) -> tuple[int, int, int]:
    """Under one renaming: runs, runs in which a train stands for ever, runs with other requests than before."""
    path, make = RENAMED[what]
    text, runs = Path(path).read_text("utf-8"), make()
    again, old = renamed(text, seed)
    first, found = before(path), Case(again).run(runs)
    other = 0
    for a, b in zip(first.outcomes, found.outcomes, strict=True):
        back = tuple((t, "-".join(old.get(x, x) for x in r.split("-"))) for t, r in b.asked)
        other += back != a.asked
    return len(runs), found.stuck, other


@lru_cache
def before(path: str) -> Found:
    """The same runs under the first names."""
    make = next(m for p, m in RENAMED.values() if p == path)
    return Case(Path(path).read_text("utf-8")).run(make())


def row(k: int) -> tuple[str, bool]:
    """A case as a row of the table, and whether something is wrong with it."""
    name, path, make = CASES[k]
    runs, case = make(), Case(Path(path).read_text("utf-8"))
    found, without = case.run(runs), case.run(runs, rule=False)
    case.replay(runs, found)
    hurt = ", ".join(sorted(found.troubles)) or "none"
    text = (
        f"| {name} | {found.runs} | {found.moves} | **{found.stuck}** | {without.stuck} | {found.refused} | "
        f"{found.ahead} | {found.plans} | {len(found.wrong)} | {found.grant} | {hurt} |"
    )
    untold = [o for o in found.outcomes if o.stuck and not any("no plan exists" in x for x in o.said)]
    return text, bool(found.wrong or found.troubles or untold or (found.stuck and name != UNANNOUNCED))


def main() -> int:
    """Write the table; 1 when a train stands for ever with the rule, or a plan fails on the controller."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--renamings", type=int, default=100)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/dispatch.md"))
    options = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=False)
    began = time.monotonic()
    seeds = [(what, k) for what in RENAMED for k in range(options.renamings)]
    with ProcessPoolExecutor(options.jobs) as pool:
        cases = [pool.submit(row, k) for k in range(len(CASES))]
        others = [pool.submit(renaming, what, k) for what, k in seeds]
        done = [x.result() for x in cases]
        counted = [x.result() for x in others]
    body, bad = [text for text, _ in done], any(wrong for _, wrong in done)
    lines = [
        "# Dispatch",
        "",
        f"`python -m tests.campaigns.dispatch --renamings {options.renamings} -j {options.jobs}` "
        f"at commit {commit.stdout.strip()}, {platform.machine()}, {processor()}, {os.cpu_count()} cores, "
        f"{options.jobs} processes, Python {platform.python_version()}.",
        "",
        "Trains run on the controller with its plant, by what lamps show, a scan every two seconds.  *Stuck*: runs in "
        "which a train stands for ever, with the rule (a route is asked for only if a completion plan exists after it) "
        "and without it.  *Held back*: requests that the rule did not make.  *Ahead*: the most routes set ahead of a "
        "train.  *Plans*: the different plans that were held, all replayed on the controller; *scans*: the most until "
        "a route of one was granted.  *Troubles*: hazards and broken assumptions of the plant.",
        "",
        "| case | runs | routes granted | stuck | without the rule | held back | ahead | plans | that fail | scans | "
        "troubles |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
        *body,
        "",
    ]
    for what in RENAMED:
        of = [c for (w, _), c in zip(seeds, counted, strict=True) if w == what]
        total, stuck, other = (sum(c[i] for c in of) for i in range(3))
        lines.append(
            f"{what}, under {options.renamings} random renamings of all signals, sections, points, tracks and "
            f"boundaries: {total} runs, {stuck} stuck, {other} with other requests than under the first names.\n"
        )
        bad |= bool(stuck or other)
    lines.append(f"All of it took {time.monotonic() - began:.0f} s.\n")
    options.output.write_text("\n".join(lines), encoding="utf-8")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
