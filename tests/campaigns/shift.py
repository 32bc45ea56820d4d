"""Shifts at heishan with fleets of 2 to 8: standstills, trains in a wrong cross-cut, trains a shift with their spread.

    python -m tests.campaigns.shift [--shifts N] [--few N] [--way WAY] [--fleet N] [-j N] [--kept FILE] [-o FILE]
                                    [--older FOLDER]

Every train has more to do than it can.  Beside the dispatcher as it is stand two other ways of giving orders, requests
ordered by a plan (`simulate --planned`), the same without the rule (a route only if a completion plan exists after it),
and the same with faults far more often than on a railway.  With `--older`, the folder that an older version of this
project wrote for the layout, its runtime is driven, too, with the rule and without it.  Rows that are kept in a file
are not made again: a campaign that was broken off goes on.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from textwrap import wrap

from interlock.app.setting import prepared
from interlock.app.shift import Shift
from interlock.app.shifts import mean
from interlock.app.worked import Options, Worked
from interlock.dispatch.assign import Assigning
from interlock.simulate.mishaps import TRIAL
from tests.campaigns.older import older
from tests.campaigns.origin import processor

HEISHAN = "layouts/heishan.yaml"
FLEETS = range(2, 9)


def fleet_of(folder: Path, trains: int) -> str:
    """The shipped dispatch file with another fleet, and more to do than it can: 16 trains from each cross-cut."""
    text = Path("layouts/heishan.dispatch").read_text("utf-8")
    head, _, rest = text.partition("fleet:\n")
    line = rest.splitlines()[0].split(":", 1)[1]
    places = rest.partition("\nplaces:\n")[2].partition("\norders:")[0]
    fleet = "".join(f"  {k}:{line}\n" for k in range(1, trains + 1))
    orders = "".join(f"  o{k}: {{from: c{k}, to: crush, trains: 16}}\n" for k in range(1, 6))
    target = folder / f"heishan{trains}.dispatch"
    target.write_text(f"{head}fleet:\n{fleet}\nplaces:\n{places}\norders:\n{orders}", "utf-8")
    return str(target)


@dataclass(frozen=True)
class Way:
    """A way of running shifts; `often`: as many shifts as are asked for, else few; `clean`: nothing may go wrong;
    `then`: on the runtime of an older version."""

    name: str
    options: Options
    often: bool = True
    clean: bool = True
    then: bool = False


WAYS = (
    Way("orders in turn", Options(keep=False)),
    Way("the nearest first", Options(how=Assigning.NEAREST, keep=False), often=False),
    Way("fixed cross-cuts", Options(how=Assigning.FIXED, keep=False), often=False),
    Way("fixed, from the far end", Options(how=Assigning.FIXED_FAR, keep=False), often=False),
    Way("by a plan", Options(planned=True, keep=False), often=False),
    Way("in turn, with faults", Options(faults=TRIAL, keep=False)),
    Way("in turn, without the rule", Options(rule=False, keep=False), clean=False),
    Way("in turn, older runtime", Options(keep=False), often=False, clean=False, then=True),
    Way("older runtime, without the rule", Options(rule=False, keep=False), often=False, clean=False, then=True),
)


def row(way: Way, trains: int, done: list[Worked], seconds: float) -> tuple[str, bool]:
    """A line of the table, and whether something is wrong with it."""
    found = {k: sum(w.wrong.counts()[k] for w in done) for k in done[0].wrong.counts()}
    m = mean([w.trains for w in done])
    wait = max(w.delays.longest_wait_s for w in done) / 60
    text = (
        f"| {way.name} | {trains} | {len(done)} | {m.value:.2f} ± {m.half:.2f} | **{found['standstills']}** | "
        f"{found['wrong places']} | {found['hazards'] + found['passed at stop']} | "
        f"{sum(len(w.alarms) for w in done)} | {sum(w.delays.refused for w in done):,} | "
        f"{sum(w.movements for w in done):,} | {wait:.0f} | {seconds / len(done):.2f} |"
    )
    return text, way.clean and any(found.values())


def _timed(file: str, seed: int, options: Options, before: Path | None) -> tuple[Worked, float]:
    began = time.process_time()
    setting = prepared(HEISHAN, file)
    if before is not None:
        setting = replace(setting, names=older(before, setting.names))
    done = Shift(setting, seed, options).run()
    return done, time.process_time() - began


def _kept(file: Path | None) -> list[tuple[str, str]]:
    """Commit and text of each row that is done."""
    if file is None or not file.exists():
        return []
    found = [line.partition("\t") for line in file.read_text("utf-8").splitlines()]
    return [(commit, text) for commit, _, text in found]


TOLD = (
    "Heishan, eight hours on the emitted runtime, 20 minutes to load, 6 to tip, 10 outside, 60 m trains at 10 km/h "
    "(all of it ours: document D gives no lengths and no times, and nothing is fitted to its 30 and 38 trains a "
    "shift).  *Trains*: tipped in a shift, mean with its 95 % confidence interval.  *Standstills*: shifts in which "
    "all trains with orders stood for ever.  *Wrong place*: trains in a cross-cut that is not theirs, or out over "
    "another boundary.  *Harm*: hazards and signals passed at stop.  *Alarms*: of the train describer and of the "
    "dispatcher; empty: not counted then.  *Held back*: requests that the rule did not "
    "make.  *Wait*: the longest of a train for one cause, in minutes.  *s*: processor seconds a shift.  "
    "*Older runtime*: as version 13d8eb7 emitted it for this layout, under the dispatcher of today."
)


def page(kept: list[tuple[str, str]]) -> str:
    """The page: of each way, fleet and number of shifts the latest row."""
    rows = []
    for way in WAYS:
        for trains in FLEETS:
            found = [(c, r) for c, r in kept if r.startswith(f"| {way.name} | {trains} |")]
            latest = {int(r.split("|")[3]): f"{r} {c} |" for c, r in found}
            rows += [latest[n] for n in sorted(latest)]
    made = (
        f"`python -m tests.campaigns.shift`, each row with as many shifts as it says, from seed 0 on, at the "
        f"commit that it names, {processor()}, {os.cpu_count()} cores, Python {platform.python_version()}."
    )
    head = (
        "| orders | fleet | shifts | trains | standstills | wrong place | harm | alarms | held back | passed | wait "
        "| s | commit |",
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|",
    )
    texts = (*_wrapped(made), "", *_wrapped(TOLD), "", *head, *rows, "")
    return "\n".join(["# Shifts", "", *texts])


def _wrapped(text: str) -> list[str]:
    return wrap(text, 120, break_long_words=False, break_on_hyphens=False)


def main() -> int:
    """Write the table; 1 when a train stood for ever with the rule, came to a wrong place, or came to harm."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shifts", type=int, default=100)
    parser.add_argument("--few", type=int, default=20, help="for the ways that are only compared")
    parser.add_argument("--way", action="append", choices=[w.name for w in WAYS], help="only this one")
    parser.add_argument("--fleet", action="append", type=int, choices=FLEETS, help="only so many trains")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/shift.md"))
    parser.add_argument("--older", type=Path, help="what an older version wrote for the layout")
    parser.add_argument("--kept", type=Path, help="rows that are done")
    parser.add_argument("--page", action="store_true", help="write the page from the rows that are kept, and no more")
    options = parser.parse_args()
    told = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    commit, bad = told.stdout.strip(), False
    kept = _kept(options.kept)
    ways = [w for w in WAYS if not options.page and w.name in (options.way or [w.name])]
    ways = [w for w in ways if options.older is not None or not w.then]
    with tempfile.TemporaryDirectory() as folder, ProcessPoolExecutor(options.jobs) as pool:
        for way in ways:
            for trains in options.fleet or FLEETS:
                shifts = options.shifts if way.often else options.few
                if any(text.startswith(f"| {way.name} | {trains} | {shifts} |") for _, text in kept):
                    continue
                file = fleet_of(Path(folder), trains)
                before = options.older if way.then else None
                done = list(pool.map(_timed, [file] * shifts, range(shifts), [way.options] * shifts, [before] * shifts))
                text, wrong = row(way, trains, [w for w, _ in done], sum(s for _, s in done))
                print(text, flush=True)
                kept.append((commit, text))
                if options.kept is not None:
                    options.kept.write_text("".join(f"{c}\t{r}\n" for c, r in kept), encoding="utf-8")
                bad |= wrong
    options.output.write_text(page(kept), encoding="utf-8")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
