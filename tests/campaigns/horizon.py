"""Two hours at heishan with fleets of 2 to 8: trains tipped by each way of giving orders, beside the best plan.

    python -m tests.campaigns.horizon [--hours H] [--seconds N] [--workers N] [-o proofs/horizon.md]

Work takes exactly the minutes of the dispatch file.  What the plan leaves out, and why its bound holds for every
dispatcher, is told in `interlock/app/horizon.py`.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import tempfile
from pathlib import Path

from interlock.app.horizon import Compared, compared
from interlock.app.setting import prepared
from interlock.app.shifts import one
from interlock.app.worked import Options, summary
from interlock.dispatch.assign import Assigning
from tests.campaigns.deadlock import processor
from tests.campaigns.shift import FLEETS, HEISHAN, fleet_of

WAYS = {Assigning.IN_TURN: "in turn", Assigning.NEAREST: "the nearest first", Assigning.FIXED: "fixed cross-cuts"}


def row(trains: int, best: Compared, found: dict[Assigning, int]) -> str:
    """A line of the table."""
    cells = [f"{n} | {n / best.planned:.2f} | {n / best.most:.2f}" for n in found.values()]
    most = f"**{best.most}**" if best.most == best.planned else str(best.most)
    return f"| {trains} | {best.planned} | {most} | {best.by} | {best.seconds:.0f} | {' | '.join(cells)} |"


def main() -> int:
    """Write the table; 1 when a shift brings out more than the bound, or something else is wrong with it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hours", type=float, default=2)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--fleets", type=int, nargs="*", default=list(FLEETS))
    parser.add_argument("--note", default="", help="sentences on how it was measured, for the page")
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/horizon.md"))
    options = parser.parse_args()
    told = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    rows, bad = [], False
    with tempfile.TemporaryDirectory() as folder:
        for trains in options.fleets:
            file = fleet_of(Path(folder), trains)
            best = compared(prepared(HEISHAN, file), options.hours, options.seconds, options.workers)
            found = {}
            for how in WAYS:
                done = one(HEISHAN, file, 0, Options(options.hours, how, keep=False, steady=True))
                found[how] = done.trains
                bad |= any(summary(done).values()) or done.trains > best.most
            rows.append(row(trains, best, found))
            print(rows[-1], flush=True)
    page = [
        "# Two hours, and the best that could be done",
        "",
        f"`python -m tests.campaigns.horizon --hours {options.hours:g} --seconds {options.seconds:g} --workers "
        f"{options.workers}` at commit {told.stdout.strip()}, {processor()}, {os.cpu_count()} cores, "
        f"Python {platform.python_version()}.",
        "",
        f"Heishan from an empty adit, {options.hours:g} h, work of exactly 20 minutes to load, 6 to tip, 10 outside.  "
        "*Plan*: trains tipped by the best plan that was found (`interlock/app/horizon.py`: full speed at once, no "
        "signals, points or rule, sections free behind the tail).  *Most*: no dispatcher brings out more; bold where "
        "the plan does.  With five trains and more the zone's limit of four trains inside is in the plan, not in the "
        "bound.  For each way of giving orders: trains tipped in the simulated shift on the emitted runtime, divided "
        "by the plan, divided by the bound.  *Seconds*: of planning, by the clock on the wall.  "
        f"{options.note}",
        "",
        f"| fleet | plan | most | found by | seconds | {' | '.join(f'{w} | /plan | /most' for w in WAYS.values())} |",
        f"|---:|---:|---:|---|---:|{'---:|' * 9}",
        *rows,
        "",
    ]
    options.output.write_text("\n".join(page), encoding="utf-8")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
