"""Whether a process that goes on and on grows: `python -m benchmarks.memory`.

A hundred thousand small layouts are loaded, derived (with the audit) and lowered, and a thousand proved, in one
process; no two have a name in common, so that whatever is remembered by name, node or layout would pile up.  Resident
memory is read after each hundredth, after a full collection.
"""

from __future__ import annotations

import argparse
import gc
import os
import platform
import random
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import interlock

ALLOWED = 1.05
"""Memory at the end, as a share of that after the first hundredth."""


def resident_mib() -> float:
    """Resident memory of this process in MiB (Linux)."""
    pages = int(Path("/proc/self/statm").read_text("ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def small(n: int) -> str:
    """The n-th layout: a junction of one point, or a passing loop; lengths, principles and every name are its own."""
    rng = random.Random(n)
    k = f"{n:x}"

    def metres() -> int:
        return rng.choice([40, 90, 250, 600])

    points = [f"  P{k}: {{section: p{k}, toe: w{k}.end, normal: m{k}.start, reverse: l{k}.start}}"]
    tracks = [f"  w{k}: [W{k}, a{k} {metres()}]"]
    signals = [f"  XA{k}: {{from: W{k}, into: a{k}}}", f"  XB{k}: {{from: a{k}, into: p{k}}}"]
    signals += [f"  Y{t}{k}: {{from: {t}{k}, into: p{k}}}" for t in "ml"]
    if n % 4:  # a loop costs several times as much as a junction
        tracks += [f"  m{k}: [m{k} {metres()}, E{k}]", f"  l{k}: [l{k} {metres()}, B{k}]"]
        signals.append(f"  YE{k}: {{from: E{k}, into: m{k}}}")
        buffers = f"buffers: [B{k}]\n"
    else:
        tracks += [f"  m{k}: [m{k} {metres()}]", f"  l{k}: [l{k} {metres()}]", f"  e{k}: [b{k} {metres()}, E{k}]"]
        points.append(f"  Q{k}: {{section: q{k}, toe: e{k}.start, normal: m{k}.end, reverse: l{k}.end}}")
        signals += [f"  X{t}{k}: {{from: {t}{k}, into: q{k}}}" for t in "ml"]
        signals += [f"  YE{k}: {{from: E{k}, into: b{k}}}", f"  YB{k}: {{from: b{k}, into: q{k}}}"]
        buffers = ""
    rows = "\n".join(["tracks:", *tracks, "points:", *points, "signals:", *signals])
    return (
        f"interlock: 1\nname: n{k}\nprofile: {rng.choice(['generic', 'mine', 'cn'])}\n"
        f"boundaries:\n  W{k}: {{approach: aw{k} 500}}\n  E{k}: {{approach: ae{k} 500}}\n{buffers}{rows}\n"
    )


def lowered(n: int) -> None:
    """Load, derive and lower the n-th layout."""
    layout = interlock.loads(small(n))
    interlock.lower(layout, interlock.derive(layout))


def proved(n: int) -> None:
    """The same, and prove it."""
    layout = interlock.loads(small(n))
    assert interlock.prove(layout, interlock.lower(layout, interlock.derive(layout))).proved


def grow(task: Callable[[int], None], count: int) -> Iterator[tuple[int, float, float]]:
    """Carry out a task so many times; after each hundredth: how many, MiB, seconds."""
    began = time.monotonic()
    part = count // 100
    for n in range(1, count + 1):
        task(n)
        if n % part == 0:
            gc.collect()
            yield n, resident_mib(), time.monotonic() - began


def main() -> None:
    """Print the table; the exit code tells whether memory stayed within what is allowed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--layouts", type=int, default=100_000, help="to be loaded, derived and lowered")
    parser.add_argument("--proofs", type=int, default=1_000)
    given = parser.parse_args()
    kind = f"{platform.machine()}, {platform.python_implementation()} {platform.python_version()}"
    print(f"# Memory of a process that goes on\n\n`python -m benchmarks.memory`, {kind}; resident MiB.\n")
    print("| done | after the first hundredth | a tenth | half | at the end | end : first | most | seconds |")
    print("|---|---|---|---|---|---|---|---|")
    good = True
    for name, task, count in (
        ("loaded, derived, audited, lowered", lowered, given.layouts),
        ("the same, and proved", proved, given.proofs),
    ):
        task(0)  # what is loaded once
        seen = list(grow(task, count))
        first, tenth, half, last = (seen[k][1] for k in (0, 9, 49, 99))
        most = max(m for _, m, _ in seen)
        good &= last <= ALLOWED * first
        print(
            f"| {count:,} {name} | {first:.1f} | {tenth:.1f} | {half:.1f} | {last:.1f} | {last / first:.3f} "
            f"| {most:.1f} | {seen[-1][2]:.0f} |",
            flush=True,
        )
    raise SystemExit(0 if good else 1)


if __name__ == "__main__":
    main()
