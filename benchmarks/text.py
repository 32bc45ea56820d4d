"""The emitted texts in figures: `python -m benchmarks.text > proofs/texts.md`.

Lines, blocks and the largest block of every shipped layout in every dialect, each read back and proved; the time of a
scan of the Python runtime at some 300 routes; the time to emit, read back and prove the text of some 1,000 routes.
"""

from __future__ import annotations

import gc
import random
import resource
import statistics
import subprocess
import time
from pathlib import Path

from interlock.app.check import check_file
from interlock.app.init import yard
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.python.runtime import runtime_py
from interlock.field.plc import runtime_scan
from interlock.frontend import load_text
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.st.delivery import core, write_st
from interlock.st.dialects import BY_NAME
from interlock.st.lint import lint, rows_of
from interlock.st.lower import lower_st

TOP = Path(__file__).resolve().parent.parent


def large(tracks: int) -> tuple[int, Controller]:
    """Number of routes and controller of a yard."""
    sink = Sink()
    layout, _ = load_text("yard.yaml", yard(tracks), sink)
    assert layout is not None
    table = derive(layout, sink)
    return len(table.routes), lower(layout, table)


def dialects() -> None:
    """A row for each layout and dialect."""
    print("| layout | routes | dialect | files | lines | blocks | largest block | calling block | text = controller |")
    print("|---|---|---|---|---|---|---|---|---|")
    for path in sorted(TOP.joinpath("layouts").glob("*.yaml")):
        checked = check_file(str(path))
        assert checked.layout is not None and checked.table is not None
        controller = lower(checked.layout, checked.table)
        for d in BY_NAME.values():
            files = write_st(controller, d, ["interlock"])
            unit = core(controller, d, ["interlock"])
            *blocks, main = [b for b in d.form(unit).blocks if b.body]
            verdict = (
                "PROVED"
                if compare_dialect(controller, d, files).proved and not lint(lower_st(controller, [], d.rows))
                else "NO"
            )
            lines = sum(t.count("\n") for t in files.values())
            largest = max(map(rows_of, blocks))
            print(
                f"| {path.stem} | {len(checked.table.routes)} | {d.name} | {len(files)} | {lines} | {len(blocks) + 1} "
                f"| {largest} rows | {rows_of(main)} rows | {verdict} |"
            )


def scans(tracks: int = 36, count: int = 400) -> None:
    """The time of a scan of the runtime."""
    routes, controller = large(tracks)
    scan = runtime_scan(runtime_py(controller, [])).scan
    rng = random.Random(1)
    times = []
    for _ in range(count):
        inputs = {i.name: rng.randrange(i.size) if i.size else int(rng.random() < 0.8) for i in controller.inputs}
        began = time.process_time()
        scan(inputs, 100)
        times.append((time.process_time() - began) * 1000)
    times.sort()
    print(
        f"A scan of the Python runtime at {routes} routes ({len(controller.state)} state variables): median "
        f"{statistics.median(times):.2f} ms, 99 of 100 under {times[int(count * 0.99)]:.2f} ms, of {count} scans on "
        "inputs at random."
    )


def whole(tracks: int = 124) -> None:
    """Emit, read back and prove."""
    gc.disable()  # as the command does
    routes, controller = large(tracks)
    iec = BY_NAME["iec"]
    began = time.process_time()
    files = write_st(controller, iec, ["interlock"])
    emitted = time.process_time()
    found = compare_dialect(controller, iec, files)
    proved = time.process_time()
    runtime = compare_runtime(controller, runtime_py(controller, []))
    done = time.process_time()
    assert found.proved and runtime.proved
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024 / 1024
    print(
        f"At {routes} routes, one process, processor time: {sum(map(len, files.values())) / 1e6:.1f} MB of text "
        f"emitted in {emitted - began:.1f} s, read back and proved in {proved - emitted:.1f} s "
        f"({found.compared} functions); the Python runtime emitted, read and proved in {done - proved:.1f} s; "
        f"{memory:.2f} GiB."
    )


def main() -> None:
    """Print the page."""
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=TOP, capture_output=True, text=True).stdout
    print(f"# Texts\n\n`python -m benchmarks.text` at commit {commit.strip()}, x86_64, 2 cores.\n")
    scans()
    print()
    whole()
    print()
    dialects()


if __name__ == "__main__":
    main()
