"""Time of placing a plan against its number of points: `python -m benchmarks.drawing > proofs/drawing.md`."""

from __future__ import annotations

import os
import platform
import subprocess
import time
from pathlib import Path

from interlock.app.init import line, yard
from interlock.diag import Sink
from interlock.emit.drawing import place, plan_svg
from interlock.frontend import load, load_text

TOP = Path(__file__).resolve().parent.parent


def row(name: str, text: str | None = None) -> None:
    """One line of the table."""
    layout, _ = load(str(TOP / "layouts" / f"{name}.yaml"), Sink()) if text is None else load_text(name, text, Sink())
    assert layout is not None
    began = time.process_time()
    drawing = place(layout)
    placed = time.process_time()
    svg = plan_svg(layout, drawing)
    notes = sum("runs of track" not in n for n in drawing.notes) or "none"
    size = f"{drawing.width:.0f} x {drawing.height:.0f}"
    print(
        f"| {name} | {len(layout.pointwork.points)} | {placed - began:.2f} | {size} | {len(svg) // 1000} kB | {notes} |"
    )


def main() -> None:
    """Print the page."""
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=TOP, capture_output=True, text=True).stdout
    machine = f"{platform.machine()}, {os.cpu_count()} cores, CPython {platform.python_version()}"
    print(f"# Plans\n\n`python -m benchmarks.drawing` at commit {commit.strip()}, {machine}.")
    print("Seconds are of the processor; one process, on one core.\n")
    print(
        "| layout | points | seconds to place | pixels | SVG | names or lines without room |\n|---|---|---|---|---|---|"
    )
    for path in sorted(TOP.joinpath("layouts").glob("*.yaml")):
        row(path.stem)
    for stations in (20, 50, 100):
        row(f"line {stations}", line(stations))
    for tracks in (10, 20, 50, 120, 240):
        row(f"yard {tracks}", yard(tracks))


if __name__ == "__main__":
    main()
