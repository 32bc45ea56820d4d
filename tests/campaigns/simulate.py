"""Trains in metres on the emitted runtimes: movements and hazards, with a random and a hostile operator.

python -m tests.campaigns.simulate [--scans N] [-j N] [--seed N] [LAYOUT ...]

Without layouts: all of layouts/ (other cases are given by path).  Writes proofs/simulation.md; its exit code is 1 when
there was a hazard on a layout as shipped, or a weakened class of controllers came to no harm.
"""

from __future__ import annotations

import argparse
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from interlock.app.check import derive_file
from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import MalformedController
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.simulate import Outcome, simulate
from tests.weakened import WEAKENED

SLICE = 50_000
"""Scans of one piece of work."""


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


def drive(case: Case, scans: int, seed: int, hostile: bool) -> Outcome:
    """So many scans, or until a hazard."""
    return simulate(
        case.layout,
        case.runtime,
        scans=scans,
        seed=seed,
        hostile=hostile,
        routes=case.routes,
    )


@lru_cache(maxsize=64)
def _case(path: str, weakening: str) -> Case:
    return Case.of(path, weakening)


Work = tuple[str, str, int, int, bool]


def _work(work: Work) -> Outcome:
    path, weakening, scans, seed, hostile = work
    return drive(_case(path, weakening), scans, seed, hostile)


def _pieces(path: str, scans: int, seed: int) -> list[Work]:
    found: list[Work] = []
    for hostile in (False, True):
        for n, begin in enumerate(range(0, scans, SLICE)):
            found.append((path, "", min(SLICE, scans - begin), 1000 * seed + n, hostile))
    return found


def _sum(outcomes: list[Outcome]) -> Outcome:
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


def main() -> int:
    """Run the campaign."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layouts", nargs="*", metavar="LAYOUT")
    parser.add_argument("--scans", type=int, default=1_000_000, help="with each operator, over all layouts together")
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
        except (ValueError, MalformedController) as error:
            refused.append(f"{Path(path).stem}: {error}")
    each = -(-args.scans // max(1, len(paths)))
    work = [w for path in paths for w in _pieces(path, each, args.seed)]
    weak: list[Work] = []
    for kind in WEAKENED:
        for path in paths[:6]:
            weak += [(path, kind, 20_000, args.seed + n, bool(n)) for n in (0, 1)]
    with ProcessPoolExecutor(args.jobs) as pool:
        outcomes = list(pool.map(_work, work))
        harmed = list(pool.map(_harmed, weak))
    lines = _table(paths, work, outcomes)
    for reason in refused:
        lines.append(f"Not driven: {reason}.\n")
    lines += _weakenings(weak, harmed)
    text = "\n".join(lines) + "\n"
    if args.out:
        Path(args.out).write_text(text, encoding="utf-8")
    print(text)
    bad = sum(len(o.hazards) + len(o.passed_at_stop) for o in outcomes)
    missed = [k for k in WEAKENED if not any(h for w, h in zip(weak, harmed, strict=True) if w[1] == k)]
    for w, o in zip(work, outcomes, strict=True):
        for h in o.hazards:
            print(f"{w}: {h}")
    total = _sum(outcomes)
    print(
        f"{total.scans} scans, {total.movements} movements, {total.trains} trains, {len(total.hazards)} hazards; "
        f"weakened classes without harm: {', '.join(missed) or 'none'}; {time.time() - began:.0f} s"
    )
    return 1 if bad or missed else 0


def _harmed(work: Work) -> str:
    try:
        found = _work(work)
    except ValueError:
        return ""
    return f"{found.hazards[0]} (scan {found.scans})" if found.hazards else ""


def _table(paths: list[str], work: list[Work], outcomes: list[Outcome]) -> list[str]:
    lines = [
        "# Trains in metres on the emitted runtimes\n",
        "`python -m tests.campaigns.simulate`: each layout's runtime, as it is written, in a world of trains with "
        "lengths, speeds and brakes, with faults, power cuts and two kinds of operators.  A movement is a signal "
        "passed at proceed; a hazard is harm seen from positions alone (`interlock/simulate/hazards.py`).\n",
        "| layout | operator | scans | hours | trains | movements | power cuts | hazards |",
        "|---|---|---:|---:|---:|---:|---:|---:|",
    ]
    for path in paths:
        for hostile in (False, True):
            o = _sum([o for w, o in zip(work, outcomes, strict=True) if w[0] == path and w[4] is hostile])
            lines.append(
                f"| {Path(path).stem} | {'hostile' if hostile else 'random'} | {o.scans} | {o.world_s / 3600:.1f} | "
                f"{o.trains} | {o.movements} | {o.power_cuts} | {len(o.hazards)} |"
            )
    o = _sum(outcomes)
    hours = f"{o.world_s / 3600:.1f}"
    lines.append(f"| all | | {o.scans} | {hours} | {o.trains} | {o.movements} | {o.power_cuts} | {len(o.hazards)} |\n")
    return lines


def _weakenings(weak: list[Work], harmed: list[str]) -> list[str]:
    lines = ["| controllers that are wrong as a class | harm on | first harm |", "|---|---:|---|"]
    for kind, (text, _) in WEAKENED.items():
        mine = [(w, h) for w, h in zip(weak, harmed, strict=True) if w[1] == kind and h]
        first = f"{Path(mine[0][0][0]).stem}, {mine[0][1]}" if mine else "none"
        lines.append(f"| {kind}: {text} | {len({w[0] for w, _ in mine})} layouts | {first} |")
    return lines


if __name__ == "__main__":
    sys.exit(main())
