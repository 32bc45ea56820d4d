"""Fuzz campaign: layouts mutated at random, as text and as structure.

    python -m tests.campaigns.fuzz --count 100000 -j 2

Every mutated layout must end in a table or in diagnostics: no exception, nothing over 2 s of the processor (a machine
that stands still for as long is no fault of ours), and no PLC text from a layout with an error.  The last line is the
result; the exit code is 1 when anything went wrong.
"""

from __future__ import annotations

import argparse
import os
import random
import re
import signal
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType

from interlock.app.check import check_file
from interlock.app.compile import build
from interlock.proof.engines.limits import Limits
from tests.grow import grow

LIMIT_S = 2.0
LAYOUTS = sorted(Path(__file__).resolve().parents[2].joinpath("layouts").rglob("*.yaml"))
ODD = ["\0", "\t", "\u202e", "&a ", "*a", "!!x ", "{", "}", "[", "]", ": ", "- ", "#", "'", '"', "|", ">", "%"]
ODD += ["\n---\n", "1e999", "-1", "0", "nan", "~", "null", "yes", "12:30", "010", "é", "王", "\ufeff", "a" * 300]


@dataclass
class Tally:
    """What happened to a batch."""

    count: int = 0
    valid: int = 0
    compiled: int = 0
    proved: int = 0
    slowest: float = 0.0
    codes: Counter[str] = field(default_factory=Counter)
    bad: list[str] = field(default_factory=list)


class _TooLong(Exception):
    pass


def _alarm(signum: int, frame: FrameType | None) -> None:
    raise _TooLong


def as_text(text: str, rng: random.Random) -> str:
    """A few edits of characters and lines."""
    for _ in range(rng.choice([1, 1, 2, 5])):
        at = rng.randrange(len(text) + 1)
        kind = rng.randrange(6)
        if kind == 0:
            text = text[:at] + text[at + rng.randint(1, 6) :]
        elif kind == 1:
            text = text[:at] + rng.choice(ODD) + text[at:]
        elif kind == 2:
            text = text[:at] + chr(rng.choice([0, 9, 27, 127, 0x85, 0x2028, rng.randrange(32, 127)])) + text[at + 1 :]
        else:
            lines = text.split("\n")
            i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
            if kind == 3:
                lines.insert(j, lines[i])
            elif kind == 4:
                lines[i], lines[j] = lines[j], lines[i]
            else:
                del lines[i]
            text = "\n".join(lines)
    return text


def as_structure(text: str, rng: random.Random) -> str:
    """A few words replaced by other words of the layout: wrong references, lengths, ends and directions."""
    words = list(re.finditer(r"[\w./]+", re.sub(r"#.*", lambda m: " " * len(m.group()), text)))
    if rng.random() < 0.8:  # values rather than keys
        words = [m for m in words if not text.startswith(":", m.end())] or words
    pool = [m.group() for m in words]
    pool += ["toe", "normal", "reverse", "start", "end", "in", "out", "forward", "5", "W.toe"]
    picked = rng.sample(words, min(len(words), rng.choice([1, 2, 3, 6])))
    for m in sorted(picked, key=lambda m: -m.start()):
        new = rng.choice(pool)
        if rng.random() < 0.3:
            new = m.group().split(".")[0] + "." + rng.choice(["toe", "normal", "reverse", "start", "end"])
        text = text[: m.start()] + new + text[m.end() :]
    return text


def one(seed: int, tally: Tally, folder: str) -> None:
    """One mutated layout."""
    rng = random.Random(seed)
    base = rng.choice(LAYOUTS).read_text("utf-8") if rng.random() < 0.5 else grow(rng.randrange(10_000))
    text = (as_text if rng.random() < 0.5 else as_structure)(base, rng)
    path = os.path.join(folder, "fuzz.yaml")
    Path(path).write_text(text, encoding="utf-8", errors="replace")
    began = time.process_time()
    signal.setitimer(signal.ITIMER_PROF, LIMIT_S)
    try:
        checked = check_file(path)
        tally.codes.update({d.code for d in checked.diagnostics if d.severity == "error"})
        if any(d.code == "IL4007" for d in checked.diagnostics):
            tally.bad.append(f"seed {seed}: audit and derivation disagree")
        tally.valid += checked.ok
        signal.setitimer(signal.ITIMER_PROF, 0)
        if not checked.ok and rng.random() < 0.02:
            _, files = build(path, unproved=True)
            if any(n.endswith((".st", ".py")) for n in files):
                tally.bad.append(f"seed {seed}: PLC text from a layout with an error")
            tally.compiled += 1
        if checked.ok and rng.random() < 0.05:
            proved, files = build(path, limits=Limits(search_depth=3, search_s=2))
            if not proved.green and any(n.endswith((".st", ".py")) for n in files):
                tally.bad.append(f"seed {seed}: PLC text without a proof")
            tally.proved += proved.green
            began = time.process_time()  # the limit of 2 s is for checking
    except _TooLong:
        tally.bad.append(f"seed {seed}: over {LIMIT_S} s of the processor")
    except Exception as error:  # the campaign is looking for exactly this
        tally.bad.append(f"seed {seed}: {type(error).__name__}: {error}")
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    tally.slowest = max(tally.slowest, time.process_time() - began)
    tally.count += 1


def batch(first: int, count: int) -> Tally:
    """A run of seeds."""
    signal.signal(signal.SIGPROF, _alarm)
    tally = Tally()
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + count):
            one(seed, tally, folder)
    return tally


def main() -> int:
    """Run the campaign."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    args = parser.parse_args()
    size = max(1, min(1000, args.count // args.jobs))
    starts = range(args.first, args.first + args.count, size)
    total = Tally()
    began = time.time()
    with ProcessPoolExecutor(args.jobs) as pool:
        ends = args.first + args.count
        for t in pool.map(batch, starts, [min(size, ends - s) for s in starts]):
            total.count += t.count
            total.valid += t.valid
            total.compiled += t.compiled
            total.proved += t.proved
            total.slowest = max(total.slowest, t.slowest)
            total.codes += t.codes
            total.bad += t.bad
            if sys.stderr.isatty():
                print(f"\r{total.count} of {args.count}, {len(total.bad)} bad", end="", file=sys.stderr, flush=True)
    print("errors by code:", ", ".join(f"{c} {n}" for c, n in sorted(total.codes.items())))
    for line in total.bad[:50]:
        print(line)
    print(
        f"{total.count} layouts in {time.time() - began:.0f} s: {total.valid} valid, slowest {total.slowest:.2f} s, "
        f"{total.compiled} with errors compiled without PLC text, {total.proved} of the valid ones proved, "
        f"{len(total.bad)} bad"
    )
    return 1 if total.bad else 0


if __name__ == "__main__":
    sys.exit(main())
