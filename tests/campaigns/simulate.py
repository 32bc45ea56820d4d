"""Trains in metres on the emitted runtimes: movements and hazards, with a random and a hostile operator.

python -m tests.campaigns.simulate [--scans N] [--movements N] [-j N] [--seed N] [LAYOUT ...]

Without layouts: all of layouts/ (other cases are given by path).  Writes proofs/simulation.md; its exit code is 1 when
there was a hazard on a layout as shipped, or a weakened class of controllers came to no harm.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import time
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from itertools import count
from pathlib import Path

from interlock.app.check import derive_file
from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import MalformedController
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.simulate import Outcome, simulate
from interlock.simulate.faults import Faults
from tests.campaigns.origin import processor
from tests.weakened import WEAKENED

SLICE = 20_000
"""Scans of one piece of work: one railway, from one restart and from those in between."""

BOTH = (False, True)
OPERATOR = {False: "random", True: "hostile"}

WRONG_ON = (
    "mine11",
    "junction",
    "flank_lab",
    "depot",
    "passing_loop",
    "incline_hoist",
    "pit_bottom",
    "heishan",
    "terminus_slip",
)
"""The layouts on which wrong controllers are driven, each class on the first three to which it applies, and on more
until one comes to harm."""

WRONG_SCANS = 12_000
"""Scans for each of six seeds (24 where the class has done no harm before), or until harm is done."""


@dataclass(frozen=True)
class Case:
    """A layout, the runtime that was emitted for it (weakened or not), and what an operator knows of its routes."""

    layout: Layout
    runtime: str
    routes: dict[str, tuple[int, ...]]

    @staticmethod
    def of(path: str, weakening: str = "") -> Case:
        """From a layout's file."""
        found = derive_file(path)
        if not found.ok or found.layout is None or found.table is None:
            raise ValueError("; ".join(d.message for d in found.diagnostics[:2]))
        controller = lower(found.layout, found.table)
        text = runtime_py(controller, [])
        if weakening:
            other = runtime_py(WEAKENED[weakening][1](controller), [])
            if other == text:
                raise ValueError(f"nothing to weaken: {weakening}")
            text = other
        routes: dict[str, tuple[int, ...]] = {}
        for r in found.table.routes:
            routes[str(r.entry)] = (*routes.get(str(r.entry), ()), r.number)
        return Case(found.layout, text, routes)


def drive(case: Case, scans: int, seed: int, hostile: bool, faults: Faults | None = None) -> Outcome:
    """So many scans, or until a hazard; with other `faults` than usual."""
    return simulate(
        case.layout,
        case.runtime,
        scans=scans,
        seed=seed,
        hostile=hostile,
        routes=case.routes,
        faults=faults,
    )


@lru_cache(maxsize=40)
def _case(path: str, weakening: str) -> Case:
    return Case.of(path, weakening)


Work = tuple[str, str, int, int, bool]


def _work(work: Work) -> Outcome:
    path, weakening, scans, seed, hostile = work
    return drive(_case(path, weakening), scans, seed, hostile)


def _sum(outcomes: Iterable[Outcome]) -> Outcome:
    total = Outcome()
    for o in outcomes:
        total.scans += o.scans
        total.movements += o.movements
        total.trains += o.trains
        total.power_cuts += o.power_cuts
        total.world_s += o.world_s
        total.hazards += o.hazards
        total.passed_at_stop += o.passed_at_stop
    return total


def _harmed(kind: str) -> list[tuple[str, str]]:
    """The layouts on which a class of wrong controllers was driven, each with its first harm, if any: three, and
    more until one comes to harm."""
    found: list[tuple[str, str]] = []
    for name in WRONG_ON:
        if len(found) >= 3 and any(h for _, h in found):
            break
        try:
            case = _case(f"layouts/{name}.yaml", kind)
        except ValueError:
            continue
        harm = ""
        for seed in range(6 if any(h for _, h in found) else 24):
            outcome = drive(case, WRONG_SCANS, seed, seed % 2 == 0)
            if outcome.hazards:
                harm = f"{outcome.hazards[0]} (seed {seed}, scan {outcome.scans})"
                break
        found.append((name, harm))
    return found


def main() -> int:
    """Run the campaign."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layouts", nargs="*", metavar="LAYOUT")
    parser.add_argument("--scans", type=int, default=1_000_000, help="at least, with each operator, over all layouts")
    parser.add_argument("--movements", type=int, default=20_000, help="at least, with each operator, over all layouts")
    parser.add_argument("-j", "--jobs", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", default="proofs/simulation.md")
    args = parser.parse_args()
    began = time.time()
    paths, refused = [], []
    for path in args.layouts or sorted(map(str, Path("layouts").glob("*.yaml"))):
        try:
            _case(path, "")
            paths.append(path)
        except (ValueError, LookupError, MalformedController) as error:
            refused.append(f"{Path(path).stem}: {error}")
    done: list[tuple[Work, Outcome]] = []
    text = ""
    with ProcessPoolExecutor(args.jobs) as pool:
        harmed: dict[str, list[tuple[str, str]]] = {}
        seeds = count(1000 * args.seed)
        while not _enough(done, args.scans, args.movements):
            seed = next(seeds)
            work: list[Work] = [(path, "", SLICE, seed, hostile) for path in paths for hostile in BOTH]
            for w, o in zip(work, pool.map(_work, work), strict=True):
                done.append((w, o))
                for h in (*o.hazards, *o.passed_at_stop):
                    print(f"{Path(w[0]).stem}, seed {w[3]}, {OPERATOR[w[4]]}, scan {o.scans}: {h}", flush=True)
            text = _write(args.out, time.time() - began, paths, done, refused, harmed)
            if not harmed:
                harmed |= zip(WEAKENED, pool.map(_harmed, WEAKENED), strict=True)
                text = _write(args.out, time.time() - began, paths, done, refused, harmed)
    print(text)
    missed = [k for k, found in harmed.items() if not any(h for _, h in found)]
    print(f"classes without harm: {', '.join(missed) or 'none'}; {time.time() - began:.0f} s")
    return 1 if missed or any(o.hazards or o.passed_at_stop for _, o in done) else 0


def _write(
    out: str,
    seconds: float,
    paths: list[str],
    done: list[tuple[Work, Outcome]],
    refused: list[str],
    harmed: dict[str, list[tuple[str, str]]],
) -> str:
    """The page as far as the campaign has come."""
    lines = [*_head(done, seconds), *_table(paths, done)]
    lines += [f"Not driven: {reason}.\n" for reason in refused]
    text = "\n".join(lines + _weakenings(harmed)) + "\n"
    if out:
        Path(out).write_text(text, encoding="utf-8")
    return text


def _enough(done: list[tuple[Work, Outcome]], scans: int, movements: int) -> bool:
    """Whether each operator has had so many scans, and seen so many movements."""
    totals = [_sum(o for w, o in done if w[4] is hostile) for hostile in BOTH]
    return all(t.scans >= scans and t.movements >= movements for t in totals)


def _head(done: list[tuple[Work, Outcome]], seconds: float) -> list[str]:
    seeds = sorted({w[3] for w, _ in done})
    dirty = " with changes" if _git("status", "--porcelain", "--", "interlock", "layouts", "tests") else ""
    return [
        "# Trains in metres on the emitted runtimes\n",
        f"Commit {_git('log', '-1', '--format=%h')}{dirty}, seeds {seeds[0]} to {seeds[-1]}, Python "
        f"{platform.python_version()}, {processor()}, {os.cpu_count()} cores, {seconds / 60:.0f} minutes.\n",
        "`python -m tests.campaigns.simulate`: each layout's runtime, as it is written, in a world of trains with "
        "lengths, speeds and brakes, with faults, power cuts and two kinds of operators.  A movement is a signal "
        "passed at proceed; a hazard is harm seen from positions in metres (`interlock/simulate/hazards.py`), or a "
        "driver called over what is occupied, blocked, open or not detected (`interlock/simulate/called.py`).\n",
    ]


def _git(*words: str) -> str:
    return subprocess.run(["git", *words], capture_output=True, text=True, check=True).stdout.strip()


def _table(paths: list[str], done: list[tuple[Work, Outcome]]) -> list[str]:
    lines = [
        "| layout | operator | scans | hours | trains | movements | power cuts | hazards |",
        "|---|---|---:|---:|---:|---:|---:|---:|",
    ]

    def line(name: str, hostile: bool, o: Outcome) -> str:
        return (
            f"| {name} | {OPERATOR[hostile]} | {o.scans:,} | {o.world_s / 3600:.0f} | {o.trains:,} | {o.movements:,} | "
            f"{o.power_cuts} | {len(o.hazards)} |"
        )

    for path in paths:
        for hostile in (False, True):
            total = _sum(o for w, o in done if w[0] == path and w[4] is hostile)
            lines.append(line(Path(path).stem, hostile, total))
    for hostile in (False, True):
        lines.append(line("**all**", hostile, _sum(o for w, o in done if w[4] is hostile)))
    return [*lines, ""]


def _weakenings(harmed: dict[str, list[tuple[str, str]]]) -> list[str]:
    lines = ["| controllers that are wrong as a class | harm on | first harm |", "|---|---:|---|"]
    for kind, found in harmed.items():
        hits = [(n, h) for n, h in found if h]
        first = f"{hits[0][0]}, {hits[0][1]}" if hits else "none"
        lines.append(f"| {kind}: {WEAKENED[kind][0]} | {len(hits)} of {len(found)} | {first} |")
    return lines


if __name__ == "__main__":
    sys.exit(main())
