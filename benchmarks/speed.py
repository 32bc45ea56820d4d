"""Times of the commands that people wait for: `python -m benchmarks.speed`.

Prints a table: `--help`, `check` on a line of 500 elements, and `compile` of each shipped layout, each in a process
of its own, the best of three runs.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent


def line_of_stations(stations: int) -> str:
    """A single line with crossing loops: 13 elements a station (6 sections, 2 points, 5 or 6 signals)."""
    out = [
        "interlock: 1",
        "name: line",
        "boundaries:",
        "  W: {approach: ap_W 500}",
        "  E: {approach: ap_E 500}",
        "tracks:",
    ]
    points = ["points:"]
    signals = ["signals:", "  X: {from: W, into: a0}"]
    out.append("  line0: [W, a0 800]")
    for k in range(1, stations + 1):
        last = k == stations
        out += [f"  main{k}: [m{k} 600]", f"  loop{k}: [l{k} 600]"]
        out.append(f"  line{k}: [a{k} 800{', E' if last else ''}]")
        points += [
            f"  P{k}: {{section: p{k}, toe: line{k - 1}.end, normal: main{k}.start, reverse: loop{k}.start}}",
            f"  Q{k}: {{section: q{k}, toe: line{k}.start, normal: main{k}.end, reverse: loop{k}.end}}",
        ]
        signals += [
            f"  A{k}: {{from: a{k - 1}, into: p{k}}}",
            f"  B{k}: {{from: a{k}, into: q{k}}}",
            f"  C{k}: {{from: m{k}, into: q{k}}}",
            f"  D{k}: {{from: l{k}, into: q{k}}}",
            f"  F{k}: {{from: m{k}, into: p{k}}}",
            f"  G{k}: {{from: l{k}, into: p{k}}}",
        ]
    signals.append(f"  S: {{from: E, into: a{stations}}}")
    return "\n".join([*out, *points, *signals]) + "\n"


def best(args: list[str], times: int = 3) -> tuple[float, str]:
    """Seconds of the quickest of some runs, and what it printed."""
    found = []
    for _ in range(times):
        began = time.perf_counter()
        done = subprocess.run(
            [sys.executable, "-m", "interlock.cli.main", *args], cwd=TOP, capture_output=True, text=True
        )
        found.append((time.perf_counter() - began, done.stdout))
    return min(found)


def main() -> None:
    """Print the table."""
    print("| what | seconds |\n|---|---|")
    print(f"| `interlock --help` | {best(['--help'])[0]:.2f} |")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "line.yaml"
        path.write_text(line_of_stations(42))
        seconds, text = best(["check", str(path), "--format", "json"])
        body = json.loads(text)[0]
        count = 42 * 13 + 5
        assert body["ok"], body
        print(f"| `check`, {count} elements, {body['routes']} routes | {seconds:.2f} |")
        for layout in sorted(TOP.joinpath("layouts").glob("*.yaml")):
            seconds, text = best(["compile", str(layout), "-o", folder, "--format", "json"])
            body = json.loads(text)[0]
            claims = {c["verdict"] for c in body["claims"]}
            print(f"| `compile {layout.stem}`: {', '.join(claims)} | {seconds:.2f} |")


if __name__ == "__main__":
    main()
