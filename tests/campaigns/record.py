"""A writer of a log killed at random moments: every event that it had said to be written is there.

    python -m tests.campaigns.record [--kills N] [--seed N] [-o proofs/record.md]

A process writes events as fast as it can, and tells after each how many it has written.  It is killed with a signal
that it cannot catch; then the log is read, and goes on.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from random import Random

from interlock.record import Log, read_file
from tests.campaigns.origin import processor

MOMENTS = 0.05
"""Seconds after its first event within which a writer is killed."""

WRITER = """
import os, sys
from pathlib import Path
from interlock.record.log import Log
log = Log.create(Path(sys.argv[1]))
for k in range(10**9):
    log.add(k, 'section', section='s%d' % (k % 7), occupied=k & 1, text='x' * (k * 7919 % 3000))
    os.pwrite(1, b'%12d' % (k + 1), 0)
"""


def killed(file: Path, after: float) -> tuple[int, int]:
    """Events lost that the writer had said to be written, and bytes of an event that was not whole."""
    with tempfile.TemporaryFile() as said:
        writer = subprocess.Popen([sys.executable, "-c", WRITER, str(file)], stdout=said)
        try:
            while not os.pread(said.fileno(), 12, 0):
                if writer.poll() is not None:
                    raise RuntimeError("the writer has not begun")
                time.sleep(0.001)
            time.sleep(after)
        finally:
            writer.kill()
            writer.wait()
        told = int(os.pread(said.fileno(), 12, 0))
    found = read_file(file)
    if found.problem is not None:
        raise RuntimeError(f"line {found.problem.line}: {found.problem.text}")
    log, _ = Log.resume(file)
    with log:
        log.add(0, "end")
    again = read_file(file)
    if not again.ended or len(again.events) != len(found.events) + 1:
        raise RuntimeError("the log does not go on")
    return max(0, told - len(found.events)), found.torn


def main() -> int:
    """Write the table; 1 when an event was lost."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/record.md"))
    options = parser.parse_args()
    rng, lost, torn, events = Random(options.seed), 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for k in range(options.kills):
            file = Path(folder) / f"{k}.log"
            gone, rest = killed(file, rng.random() * MOMENTS)
            lost, torn, events = lost + gone, torn + bool(rest), events + len(read_file(file).events) - 1
            file.unlink()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    text = (
        "# The record\n\n"
        f"`python -m tests.campaigns.record --kills {options.kills} --seed {options.seed}` at commit "
        f"{commit.stdout.strip()}, {processor()}, {os.cpu_count()} cores, Python {platform.python_version()}.\n\n"
        "A process that writes events as fast as it can is killed (`SIGKILL`) at a random moment; its log is read, and "
        "gone on with.\n\n"
        "| kills | events written | said to be written and lost | ended within an event | gone on with |\n"
        "|---:|---:|---:|---:|---:|\n"
        f"| {options.kills} | {events:,} | **{lost}** | {torn} | {options.kills} |\n"
    )
    options.output.write_text(text, encoding="utf-8")
    print(text)
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
