"""What supervises trains above the interlocking, each against what it must notice: describer, arbiter, moving block.

python -m tests.campaigns.supervision [--trials N] [--hours N] [-o proofs/supervision.md]
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
from pathlib import Path
from random import Random

from interlock.dispatch.moving_block import Margins, MovingTrain, Position, free, gap_m, too_close
from interlock.model.elements import SectionId
from tests.campaigns.origin import processor
from tests.test_arbiter import DT_MS, hour
from tests.test_describer import IN, OUT, Yard

KINDS = ("swapped", "lost", "doubled", "unknown", "none")


def described(kind: str, seed: int) -> tuple[bool, bool]:
    """Two trains on two tracks of mine11, of which readers tell something else from a random moment on: whether a train
    that is concerned was named with the first thing that did not fit, and whether anybody was named before."""
    rng, y = Random(f"{kind} {seed}"), Yard()
    ways = {"7": list(IN[1:]), "9": list(OUT[1:])}
    for n, s in (("7", "ap_W"), ("9", "ap_E")):
        y.drive(n, s)
    moment, step, named, early = rng.randrange(1, 7), 0, False, False
    while any(ways.values()):
        n = rng.choice([k for k, w in ways.items() if w])
        y.drive(n, ways[n].pop(0))
        step += 1
        here = SectionId(y.at[n][-1])
        if step < moment or kind == "none":
            y.d.read(here, n)
            early |= bool(y.d.alarms)
        elif kind == "lost":
            y.at[n] = []
            y.see()
            return n in y.d.alarms, early
        else:
            told = {"swapped": {"7": "9", "9": "7"}[n], "doubled": "7", "unknown": "66"}[kind]
            if told == n:
                y.d.read(here, n)
                continue
            y.d.read(here, told)
            return {n, told} <= set(y.d.alarms), early
    return not named and not y.d.alarms, early


def wagons(seed: int) -> tuple[bool, bool, bool]:
    """A train of 12 wagons over five sections between two counters: whether it lost some, whether that was told
    with its number, and whether just the sections between stayed blocked."""
    rng, y = Random(f"wagons {seed}"), Yard()
    y.drive("7", "ap_W", "q1")
    y.d.counted(SectionId("q1"), 12)
    y.drive("7", "q2", "q4", "q6", "q8")
    lost = rng.choice((0, 0, 1, 2, 5, 11))
    y.d.counted(SectionId("q8"), 12 - lost)
    between = {"BLK_q1": 1, "BLK_q2": 1, "BLK_q4": 1, "BLK_q6": 1}
    return bool(lost), "7" in y.d.alarms, y.d.writes() == (between if lost else {})


def moved(seed: int) -> tuple[int, int, int, int]:
    """A train between beacons, another before it, for 200 s: sections looked at that were clear, of these told free;
    sections told free with the train in them; pairs nearer than their margin that were not told."""
    rng = Random(f"moving {seed}")
    real, believed, age = 0.0, 0.0, 0.0
    length, drift, ahead = rng.uniform(20, 120), rng.uniform(-1, 1), rng.uniform(150, 400)
    clear = told = wrong = missed = 0
    margins = Margins(disjoint=rng.random() < 0.5)
    for _ in range(200):
        v = rng.uniform(0, 5)
        real, believed, age = real + v, believed + v + drift * 0.05, age + 1.0
        ahead += rng.uniform(0, 4)
        if rng.random() < 0.05:
            believed, age = real + rng.uniform(-0.5, 0.5), 0.0
        a = MovingTrain("1", Position(believed, age), length, 1, v)
        b = MovingTrain("2", Position(ahead), 60.0, 1, 2.0, loaded=True)
        for low in range(0, 800, 100):
            inside = real > low and real - length < low + 100
            is_free = free((low, low + 100), [a])
            clear, told, wrong = clear + (not inside), told + (is_free and not inside), wrong + (is_free and inside)
        gap, need = ahead - 60.0 - real, 130.0 if margins.disjoint else 70.0
        missed += gap < need and not too_close((a, b), margins) and gap_m(a, b) >= need
    return clear, told, wrong, missed


def main() -> int:
    """Write the tables; 1 when something was not noticed, a section told free too early, or a bound not kept."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trials", type=int, default=1000)
    parser.add_argument("--hours", type=int, default=10)
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/supervision.md"))
    options = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    lines = [
        "# Describer, arbiter, moving block",
        "",
        f"`python -m tests.campaigns.supervision --trials {options.trials} --hours {options.hours}` at commit "
        f"{commit.stdout.strip()}, {processor()}, {os.cpu_count()} cores, Python {platform.python_version()}.",
        "",
        "**Describer.**  Two trains on two tracks of mine11, with a reader in each section, of which one tells "
        "something else, or one train vanishes, at a random moment.  *Named*: every train concerned has an alarm with "
        "the first reading that does not fit, and nothing is asked for it any more.  *Too early*: somebody was named "
        "before.",
        "",
        "| numbers | trials | named | too early |",
        "|---|---:|---:|---:|",
    ]
    bad = False
    for kind in KINDS:
        found = [described(kind, k) for k in range(options.trials)]
        named, early = sum(a for a, _ in found), sum(b for _, b in found)
        lines.append(f"| {kind} | {options.trials} | {named if kind != 'none' else '-'} | {early} |")
        bad |= named < options.trials or early > 0
    counted = [wagons(k) for k in range(options.trials)]
    lost = [c for c in counted if c[0]]
    lines += [
        "",
        "**Wagons.**  12 are counted in; as many or fewer are counted out five sections on.",
        "",
        "| wagons | trials | told with the train's number | just the sections between blocked |",
        "|---|---:|---:|---:|",
        f"| lost | {len(lost)} | {sum(c[1] for c in lost)} | {sum(c[2] for c in lost)} |",
        f"| all there | {len(counted) - len(lost)} | {sum(c[1] for c in counted) - sum(c[1] for c in lost)} | "
        f"{sum(c[2] for c in counted if not c[0])} (none) |",
    ]
    bad |= any(c[0] != c[1] or not c[2] for c in counted)
    lines += [
        "",
        "**Arbiter.**  An hour of requests by hand, on the spot, from afar and planned, 30 waiting at all times, the "
        "favoured kinds in excess; scans of 300 ms.  *Wait*: the longest of a request that nothing kept back; *bound*: "
        "the one computed for it.  Without ageing there is no bound.",
        "",
        "| seed | ageing after | longest wait | bound | without ageing |",
        "|---:|---:|---:|---:|---:|",
    ]
    for seed in range(options.hours):
        _, longest, bound = hour(seed, 30_000)
        lines.append(
            f"| {seed} | 30 s | {longest / 1000:.1f} s | {bound / 1000:.1f} s | {hour(seed, 0)[1] / 1000:.1f} s |"
        )
        bad |= longest > bound + DT_MS
    found4 = [moved(k) for k in range(options.trials)]
    clear, told, wrong, missed = (sum(x[k] for x in found4) for k in range(4))
    lines += [
        "",
        "**Moving block.**  A train whose position comes from inertia between beacons, 0.5 m wrong at a beacon and up "
        "to 0.05 m/s between, behind a loaded train; sections of 100 m, runs of 200 s.  *Told free*: of those that "
        "were clear.  *Wrong*: told free with the train in them.  *Missed*: pairs too near that were not told.",
        "",
        "| runs | sections clear | told free | wrong | missed |",
        "|---:|---:|---:|---:|---:|",
        f"| {options.trials} | {clear:,} | {100 * told / clear:.2f} % | **{wrong}** | **{missed}** |",
        "",
    ]
    bad |= bool(wrong or missed)
    options.output.write_text("\n".join(lines), encoding="utf-8")
    print("\n".join(lines))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
