"""The emitted STL with its mapping program in Awlsim, a simulator of S7 controllers, against the Python runtime.

python -m tests.campaigns.stl --python FILE [--scans N] [--seed N] [-j N] [--write] [LAYOUT ...]

FILE: a Python with awlsim (`pip install awlsim`); PyPy is several times as fast.  Without layouts: all that are
shipped.  Trains run on the runtime in its cabinet as for the compilers of Structured Text (tests/campaigns/foreign.py),
with stalled cycles, lost heartbeats and power cuts; then come inputs at random.  Then faults are planted in one layout,
which must be noticed.  Exit code 1: a difference, a fault that is not noticed, or a layout with too few movements.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.proof.equivalence.cabinet import compare_delivery
from interlock.st.delivery import write_delivery
from interlock.st.dialects import BY_NAME
from tests.campaigns.foreign import MOVEMENTS, recordings
from tests.campaigns.origin import processor
from tests.foreign.recording import Railway
from tests.foreign.wiring import Segment, Wiring, changed, differences
from tests.layouts import SHIPPED, built

PAGE = Path(__file__).resolve().parents[2] / "proofs" / "stl.md"
HOST = Path(__file__).resolve().parents[1] / "foreign" / "host_awlsim.py"
PLANTED = {
    "a condition is negated": ("      AN    ", "      A     "),
    "a condition of all is one of any": (".VALID;\n      A     ", ".VALID;\n      O     "),
    "a branch leaps where it should not": ("      JCN   M002;", "      JCN   M001;"),
    "a block of equations is not called": ('CALL  "IL_mine11_B03";', "NOP   0;"),
    "a terminal is another's": ('=     "YN_', '=     "YR_'),
    "a timer is ten times as long": ("PT := T#", "PT := T#1"),
}
HEAD = """# STL in a simulator

`python -m tests.campaigns.stl --python FILE --write`: the statement list of each layout (`--dialect awl`), proved, with
its mapping program, OB1, OB100 and symbol table, run by Awlsim {version} under {python}, which shares nothing with us,
against the emitted Python runtime in its cabinet: the same inputs in each scan, the same clock; compared are the bits
of %Q, what the operator's place reads, and the word of each route, in every scan.  Trains run in metres, as they do for
[the compilers of Structured Text](foreign.md); *scans* has those with inputs at random, too.  Two things that the
simulator does not take are said otherwise to it (`tests/foreign/host_awlsim.py`).  STEP 7 itself was not at hand.

At commit {commit}, `--scans {scans} --seed {seed}`; {machine}, {cores} cores; Python {own}.

| layout | routes | scans | trains | movements | stalls | power cuts | outputs that changed | scans that differ |
|---|---:|---:|---:|---:|---:|---:|---:|---:|"""


@dataclass(frozen=True)
class Recorded:
    """A shipped layout with its statement list and what was recorded of its runtime: what ran, and the scans."""

    name: str
    routes: int
    files: dict[str, str]
    wiring: Wiring
    segments: tuple[Segment, ...]
    trains: int
    movements: int
    stalls: int
    power_cuts: int


def recorded(scans: int, seed: int, name: str) -> Recorded:
    """Raises ValueError where the statement list is not proved."""
    layout, table, controller = built(name)
    allocation, dialect = allocate(layout, controller), BY_NAME["awl"]
    files = write_delivery(controller, allocation, dialect, [])
    if compare_delivery(controller, allocation, dialect, files):
        raise ValueError(f"{name}: the statement list is not proved")
    routes: dict[str, tuple[int, ...]] = {}
    for r in table.routes:
        routes[str(r.entry)] = (*routes.get(str(r.entry), ()), r.number)
    railway = Railway(layout, controller, allocation, runtime_py(controller, []), routes, controller.words.routes)
    run, random = recordings(railway, scans, seed)
    told = (*run.segments, *random.segments)
    counts = (run.trains, run.movements, run.stalls + random.stalls, run.power_cuts)
    return Recorded(name, len(table.routes), files, run.wiring, told, *counts)


def answered(python: str, files: Mapping[str, str], of: Recorded) -> tuple[int, str]:
    """The number of scans in which the simulator answers otherwise, and the first of them, or why there is none."""
    w = of.wiring
    shape = {"image_i": w.image_i, "image_q": w.image_q, "written": w.written, "read": w.read, "words": w.words}
    (name,) = [n.removesuffix(".sdf") for n in files if n.endswith(".sdf")]
    answers = []
    with tempfile.TemporaryDirectory() as folder:
        for n, text in files.items():
            (Path(folder) / n).write_text(text, "ascii")
        for s in of.segments:
            command = [python, str(HOST), folder, name, json.dumps(shape)]
            asked = s.start_ms.to_bytes(8, "little") + bytes(s.given)
            done = subprocess.run(command, input=asked, capture_output=True, check=False)
            if done.returncode:
                return 0, done.stderr.decode().strip().splitlines()[-1]
            answers.append(done.stdout)
    found = differences(w, of.segments, answers)
    return len(found), str(found[0]) if found else ""


def row(python: str, scans: int, seed: int, name: str) -> tuple[str, bool]:
    """A layout's line, and whether nothing differs although trains moved."""
    began = time.monotonic()
    of = recorded(scans, seed, name)
    count, first = answered(python, of.files, of)
    moved = f"{changed(of.wiring, of.segments)} of {of.wiring.outputs}"
    total = sum(s.scans for s in of.segments)
    cells = [name, of.routes, total, of.trains, of.movements, of.stalls, of.power_cuts, moved]
    cells += [f"{count}: {first}" if first else 0]
    print(f"{name}: {time.monotonic() - began:.0f} s", file=sys.stderr, flush=True)
    return f"| {' | '.join(map(str, cells))} |", not first and of.movements >= MOVEMENTS


def planted(python: str, of: Recorded, what: str) -> tuple[str, int, str]:
    """A planted fault with the scans in which it is noticed, and the first."""
    old, new = PLANTED[what]
    (name,) = [n for n in sorted(of.files) if n.endswith("mine11_io.awl" if "terminal" in what else "mine11.awl")]
    assert old in of.files[name], what
    wrong = {**of.files, name: of.files[name].replace(old, new, 1)}
    return what, *answered(python, wrong, of)


def main() -> None:
    """Run the campaign."""
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--python", required=True)
    args.add_argument("--scans", type=int, default=6000, help="for each layout; more where little moves")
    args.add_argument("--seed", type=int, default=1)
    args.add_argument("-j", "--jobs", type=int, default=2)
    args.add_argument("--write", action="store_true")
    args.add_argument("layouts", nargs="*")
    given = args.parse_args()
    equal, lines = True, [_head(given)]
    with ProcessPoolExecutor(given.jobs) as pool:
        for line, same in pool.map(partial(row, given.python, given.scans, given.seed), given.layouts or SHIPPED):
            print(line, flush=True)
            lines.append(line)
            equal = equal and same
        of = recorded(given.scans, given.seed, "mine11")
        faults = list(pool.map(partial(planted, given.python, of), PLANTED))
    lines += _planted(faults)
    print("\n".join(lines[-len(faults) :]))
    if given.write:
        PAGE.write_text("\n".join(lines) + "\n", "utf-8")
    sys.exit(0 if equal and all(count for _, count, _ in faults) else 1)


def _head(given: argparse.Namespace) -> str:
    ask = "import importlib.metadata as m, platform as p; print(m.version('awlsim'), p.python_implementation())"
    told = subprocess.run([given.python, "-c", ask], capture_output=True, text=True, check=True).stdout.split()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True).stdout
    facts = {"commit": commit.strip(), "scans": given.scans, "seed": given.seed, "machine": processor()}
    facts |= {"cores": os.cpu_count(), "own": platform.python_version()}
    return HEAD.format(version=told[0], python=told[1], **facts)


def _planted(faults: Sequence[tuple[str, int, str]]) -> list[str]:
    """The table of planted faults."""
    return [
        "",
        "Faults planted in mine11, and in how many scans each shows (0: these scans do not notice it):",
        "",
        "| fault | scans that differ | first |",
        "|---|---:|---|",
        *(f"| {what} | {count} | {first} |" for what, count, first in faults),
    ]


if __name__ == "__main__":
    main()
