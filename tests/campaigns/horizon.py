"""Two hours at heishan with fleets of 2 to 8: trains tipped by each way of giving orders, beside the best plan.

    python -m tests.campaigns.horizon [--hours H] [--seconds N] [--workers N] [-o proofs/horizon.md]

Work takes exactly the minutes of the dispatch file.  What the plan leaves out, and why its bound holds for every
dispatcher, is told in `interlock/app/horizon.py`.  The second table tells what of it costs trains, by plans that know
of what the controller and the drivers demand (`interlock/app/movement.py`): of nothing, of one thing at a time, of all
but the setting of routes, and of all.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from interlock.app.guided import demanded
from interlock.app.horizon import WIDTHS, Compared, compared
from interlock.app.movement import Demands
from interlock.app.setting import Setting, prepared
from interlock.app.shifts import one
from interlock.app.worked import Options
from interlock.dispatch.assign import Assigning
from tests.campaigns.origin import processor
from tests.campaigns.shift import FLEETS, HEISHAN, fleet_of

AIM = 0.95
"""Of the best plan that is known."""

WAYS = {
    "in turn": Options(),
    "the nearest first": Options(how=Assigning.NEAREST),
    "fixed cross-cuts": Options(how=Assigning.FIXED),
    "fixed, from the far end": Options(how=Assigning.FIXED_FAR),
    "by a plan": Options(planned=True),
    "without the rule": Options(rule=False),
}
"""By name: how orders are given, whether a plan orders the requests, whether the rule holds them back."""

NOTHING = Demands(rides=False, release=False, setting=False, routes=False)
DEMANDS = {
    "nothing": NOTHING,
    "rides": Demands(rides=True, release=False, setting=False, routes=False),
    "release": Demands(rides=False, release=True, setting=False, routes=False),
    "setting": Demands(rides=False, release=False, setting=True, routes=False),
    "routes": Demands(rides=False, release=False, setting=False, routes=True),
    "all but setting": Demands(setting=False),
    "all": Demands(),
}

AFTER_H = (0.0, 0.05, 0.15, 0.25)
"""Hours beyond the end up to which plans are made, to see when a train that comes too late is tipped."""


@dataclass(frozen=True)
class Cost:
    """Of a plan with demands: trains tipped in time, and seconds from the end until as many are as without (negative:
    before it; None: not even soon after it)."""

    trains: int
    late: int | None

    def __str__(self) -> str:
        return f"{self.trains} ()" if self.late is None else f"{self.trains} ({self.late:+d})"


def cost(setting: Setting, hours: float, demands: Demands, as_many: int) -> Cost:
    """What the demands cost, by the best plan that is found."""
    end = round(3600 * hours)
    trains = len(demanded(setting, hours, demands, WIDTHS[:2]).tipped)
    ends = [hours + h for h in AFTER_H]
    longer = [demanded(setting, h, demands, WIDTHS[:2]).tipped for h in ends]
    at = [sorted(t)[as_many - 1] for t in longer if len(t) >= as_many > 0]
    return Cost(trains, min(at) - end if at else None)


def row(trains: int, best: Compared, demands: int, found: Mapping[str, int]) -> str:
    """A line of the table."""
    cells = [f"{n} | {n / best.planned:.2f} | {n / best.most:.2f}" for n in found.values()]
    most = f"**{best.most}**" if best.most == best.planned else str(best.most)
    return f"| {trains} | {best.planned} | {most} | {best.by} | {best.seconds:.0f} | {demands} | {' | '.join(cells)} |"


def close(planned: Mapping[int, tuple[int, Compared, Mapping[str, Cost]]]) -> list[str]:
    """How near the shifts by a plan come to the aim.  By fleet: trains tipped, the best plan, what demands cost."""
    near = [n for n, (done, best, _) in planned.items() if done >= AIM * best.planned]
    told = f"By a plan a shift brings out at least {AIM:g} of the best plan that is known with fleets of "
    lines = [told + (", ".join(map(str, near)) or "none") + "."]
    for n, (done, best, costs) in planned.items():
        if n in near:
            continue
        every, but = costs["all"], costs["all but setting"]
        line = f"With {n} it is {done} of {best.planned}, {done / best.planned:.2f}; with demands the best plan found "
        line += f"brings out {every.trains}, not proved best"
        if every.late is not None and but.late is not None:
            line += f", and the last of {best.planned} comes {every.late} s after the end"
            line += f", {every.late - but.late} s of it by the setting of routes"
        lines.append(f"{line}.")
    return lines


TOLD = (
    "*Plan*: trains tipped by the best plan that was found (`interlock/app/horizon.py`: full speed at once, no "
    "signals, points or rule, sections free behind the tail).  *Most*: no dispatcher brings out more; bold where "
    "the plan does.  With five trains and more the zone's limit of four trains inside is in the plan, not in the "
    "bound.  *With demands*: trains of the best plan that was found when movements are counted as the dispatcher "
    "who plans counts them; it is not proved best.  For each way of giving orders: trains tipped in the simulated "
    "shift (seed 0) on the emitted runtime, divided by the plan, divided by the bound.  *Without the rule*: orders in "
    "turn, routes asked for whether or not a completion plan exists after them.  *Seconds*: of planning, by the "
    "clock on the wall."
)

COSTS = (
    "Trains of the best plan found, and in brackets how many seconds after the end (negative: before it) as many are "
    "tipped as *plan* says; empty: not within a quarter of an hour.  None of it is proved best.  *Rides*: trains "
    "gather speed and brake.  *Release*: a section is free some seconds after the tail has left it.  *Setting*: points "
    "run and drivers react before a train moves.  *Routes*: all sections of a route are taken at once.  Even with "
    "nothing movements are counted a little longer than in *plan*: to the end of the loading place, and rounded up."
)


def main() -> int:
    """Write the tables; 1 when a shift brings out more than the bound, or something else is wrong with it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hours", type=float, default=2)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--fleets", type=int, nargs="*", default=list(FLEETS))
    parser.add_argument("--note", default="", help="sentences on how it was measured, for the page")
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/horizon.md"))
    options = parser.parse_args()
    told = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    rows, costs, bad = [], [], False
    planned: dict[int, tuple[int, Compared, Mapping[str, Cost]]] = {}
    with tempfile.TemporaryDirectory() as folder:
        for trains in options.fleets:
            file = fleet_of(Path(folder), trains)
            setting = prepared(HEISHAN, file)
            best = compared(setting, options.hours, options.seconds, options.workers)
            each = {k: cost(setting, options.hours, d, best.planned) for k, d in DEMANDS.items()}
            found = {}
            for name, way in WAYS.items():
                done = one(HEISHAN, file, 0, replace(way, hours=options.hours, keep=False, steady=True))
                found[name] = done.trains
                bad |= (way.rule and any(done.wrong.counts().values())) or done.trains > best.most
            planned[trains] = found["by a plan"], best, each
            rows.append(row(trains, best, each["all"].trains, found))
            costs.append(f"| {trains} | {' | '.join(map(str, each.values()))} |")
            print(rows[-1], costs[-1], flush=True)
    options.output.write_text(page(options, told.stdout.strip(), rows, costs, close(planned)), encoding="utf-8")
    return 1 if bad else 0


def page(options: argparse.Namespace, commit: str, rows: list[str], costs: list[str], closing: list[str]) -> str:
    """Both tables, with what is in them."""
    lines = [
        "# Two hours, and the best that could be done",
        "",
        f"`python -m tests.campaigns.horizon --hours {options.hours:g} --seconds {options.seconds:g} --workers "
        f"{options.workers}` at commit {commit}, {processor()}, {os.cpu_count()} cores, "
        f"Python {platform.python_version()}.",
        "",
        f"Heishan from an empty adit, {options.hours:g} h, work of exactly 20 minutes to load, 6 to tip, 10 outside.  "
        f"{TOLD}  {options.note}".rstrip(),
        "",
        f"| fleet | plan | most | found by | seconds | with demands | "
        f"{' | '.join(f'{w} | /plan | /most' for w in WAYS)} |",
        f"|---:|---:|---:|---|---:|---:|{'---:|' * 3 * len(WAYS)}",
        *rows,
        "",
        *closing,
        "",
        "## What the demands cost",
        "",
        COSTS,
        "",
        f"| fleet | {' | '.join(DEMANDS)} |",
        f"|---:|{'---:|' * len(DEMANDS)}",
        *costs,
        "",
    ]
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
