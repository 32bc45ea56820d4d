"""The emitted STL with its mapping program in Awlsim, a simulator of S7 controllers, against the Python runtime.

python -m tests.campaigns.stl --python FILE [--scans N] [--seed N] [--write] [LAYOUT ...]

FILE: a Python with awlsim (`pip install awlsim`).  Without layouts: all that are shipped.  The restart delay passes in
cycles of a second with everything clear, then inputs change at random, mostly to what lets signals clear.  Then faults
are planted in one layout, which must be noticed.  Exit code 1: a difference, or a fault that is not noticed.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from random import Random

from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.proof.equivalence.cabinet import compare_delivery
from interlock.st.delivery import write_delivery
from interlock.st.dialects import BY_NAME
from tests.foreign.recording import Railway, Recorder, Recording
from tests.foreign.wiring import Wiring, changed, differences
from tests.layouts import SHIPPED, built

PAGE = Path(__file__).resolve().parents[2] / "proofs" / "stl.md"
HOST = Path(__file__).resolve().parents[1] / "foreign" / "host_awlsim.py"
DELAY = 700
"""Scans of a second after which no restart delay of a shipped layout runs any more."""
CLEAR = {"REL": 0.6, "DR_": 0.05, "HR_": 0.05, "BLK_": 0.02, "CAN_": 0.02, "MN_": 0.02, "MR_": 0.02, "TC_": 0.1}
"""How often an input is 1, by the beginning of its name; others nearly always."""
PLANTED = {
    "a condition is negated": ("      AN    ", "      A     "),
    "a condition of all is one of any": ("      A     ", "      O     "),
    "a branch leaps where it should not": ("      JCN   M002;", "      JCN   M001;"),
    "a block of equations is not called": ('CALL  "IL_mine11_B03";', "NOP   0;"),
    "a terminal is another's": ('=     "YN_', '=     "YR_'),
    "a timer is ten times as long": ("PT := T#", "PT := T#1"),
}
HEAD = """# STL in a simulator

`python -m tests.campaigns.stl --python FILE --write`: the statement list of each layout (`--dialect awl`), proved, with
its mapping program, OB1, OB100 and symbol table, run by Awlsim {version}, which shares nothing with us, against the
emitted Python runtime in its cabinet: the same inputs in each scan, the same clock; compared are the bits of %Q and
what the operator's place reads.  The restart delay passes in cycles of a second with everything clear, then inputs
change at random, mostly to what lets signals clear; cycles are stalled, heartbeats stand still.  Two things that the
simulator does not take are said otherwise to it (`tests/foreign/host_awlsim.py`).  STEP 7 itself was not at hand.

At commit {commit}, seed {seed}; {machine}, {cores} cores; Python {python}.

| layout | routes | scans | stalls | outputs that changed | scans that differ |
|---|---:|---:|---:|---:|---:|"""


def railway(name: str) -> tuple[int, Railway, dict[str, str]]:
    """A shipped layout's routes, what is recorded of it, and its files; raises ValueError where they are not proved."""
    layout, table, controller = built(name)
    allocation, dialect = allocate(layout, controller), BY_NAME["awl"]
    files = write_delivery(controller, allocation, dialect, [])
    if compare_delivery(controller, allocation, dialect, files):
        raise ValueError(f"{name}: the statement list is not proved")
    routes: dict[str, tuple[int, ...]] = {}
    for r in table.routes:
        routes[str(r.entry)] = (*routes.get(str(r.entry), ()), r.number)
    return len(table.routes), Railway(layout, controller, allocation, runtime_py(controller, []), routes), files


def settled(made: Railway, scans: int, seed: int) -> Recording:
    """So many scans, after those in which the restart delay passes."""
    rng, controller = Random(f"settled {seed}"), made.controller
    recorder = Recorder(made, rng)
    cabinet, longest = recorder(), recorder.cycle_max_ms
    often = {i.name: next((c for p, c in CLEAR.items() if i.name.startswith(p)), 0.97) for i in controller.inputs}
    values = {i.name: 0 if i.size else int(often[i.name] > 0.5) for i in controller.inputs}
    for k in range(DELAY + scans):
        for i in controller.inputs if k >= DELAY else ():
            if i.size:
                values[i.name] = rng.randrange(i.size) if k % 3 == 0 else 0
            elif rng.random() < 0.02:
                values[i.name] = int(rng.random() < often[i.name])
        values[controller.symbols.valid] = int(k < DELAY or rng.random() < 0.998)
        stalled = k >= DELAY and rng.random() < 0.002
        cabinet.scan(values, longest + 1 if stalled else longest if k < DELAY else rng.choice((100, 400, longest)))
    return Recording(recorder.wiring, tuple(recorder.segments), 0, 0, recorder.stalls, 0, recorder.invalid)


def answered(python: str, files: Mapping[str, str], wiring: Wiring, told: Recording) -> tuple[int, str]:
    """The number of scans in which the simulator answers otherwise, and the first of them, or why there is none."""
    segments = told.segments
    shape = json.dumps(
        {"image_i": wiring.image_i, "image_q": wiring.image_q, "written": wiring.written, "read": wiring.read}
    )
    (name,) = [n.removesuffix(".sdf") for n in files if n.endswith(".sdf")]
    answers = []
    with tempfile.TemporaryDirectory() as folder:
        for n, text in files.items():
            (Path(folder) / n).write_text(text, "ascii")
        for s in segments:
            command = [python, str(HOST), folder, name, shape]
            asked = s.start_ms.to_bytes(8, "little") + bytes(s.given)
            done = subprocess.run(command, input=asked, capture_output=True, check=False)
            if done.returncode:
                return 0, done.stderr.decode().strip().splitlines()[-1]
            answers.append(done.stdout)
    found = differences(wiring, segments, answers)
    return len(found), str(found[0]) if found else ""


def row(python: str, scans: int, seed: int, name: str) -> tuple[str, bool]:
    """A layout's line, and whether nothing differs."""
    routes, made, files = railway(name)
    told = settled(made, scans, seed)
    count, first = answered(python, files, told.wiring, told)
    moved = f"{changed(told.wiring, told.segments)} of {told.wiring.outputs}"
    cells = [name, routes, told.scans, told.stalls, moved]
    cells += [f"{count}: {first}" if first else 0]
    return f"| {' | '.join(map(str, cells))} |", not first


def planted(python: str, scans: int, seed: int) -> list[tuple[str, int, str]]:
    """Each planted fault with the scans in which it is noticed, and the first."""
    _, made, files = railway("mine11")
    told = settled(made, scans, seed)
    found = []
    for what, (old, new) in PLANTED.items():
        (name,) = [n for n in sorted(files) if n.endswith("mine11_io.awl" if "terminal" in what else "mine11.awl")]
        assert old in files[name], what
        wrong = {**files, name: files[name].replace(old, new, 1)}
        found.append((what, *answered(python, wrong, told.wiring, told)))
    return found


def main() -> None:
    """Run the campaign."""
    args = argparse.ArgumentParser(description=__doc__)
    args.add_argument("--python", required=True)
    args.add_argument("--scans", type=int, default=800)
    args.add_argument("--seed", type=int, default=1)
    args.add_argument("--write", action="store_true")
    args.add_argument("layouts", nargs="*")
    given = args.parse_args()
    ask = "import importlib.metadata as m; print(m.version('awlsim'))"
    version = subprocess.run([given.python, "-c", ask], capture_output=True, text=True, check=True).stdout.strip()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True).stdout
    with open("/proc/cpuinfo") as info:
        machine = next((x.partition(":")[2].strip() for x in info if x.startswith("model name")), platform.machine())
    facts = {"commit": commit.strip(), "seed": given.seed, "machine": machine, "cores": os.cpu_count()}
    lines = [HEAD.format(version=version, python=platform.python_version(), **facts)]
    equal = True
    with ProcessPoolExecutor(2) as pool:
        for line, same in pool.map(partial(row, given.python, given.scans, given.seed), given.layouts or SHIPPED):
            print(line, flush=True)
            lines.append(line)
            equal = equal and same
    faults = planted(given.python, given.scans, given.seed)
    lines += [
        "",
        "Faults planted in mine11, and in how many scans each shows (0: these scans do not notice it):",
        "",
        "| fault | scans that differ | first |",
        "|---|---:|---|",
    ]
    lines += [f"| {what} | {count} | {first} |" for what, count, first in faults]
    print("\n".join(lines[-len(faults) :]))
    if given.write:
        PAGE.write_text("\n".join(lines) + "\n", "utf-8")
    sys.exit(0 if equal and all(count for _, count, _ in faults) else 1)


if __name__ == "__main__":
    main()
