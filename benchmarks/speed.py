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

from interlock.app.init import line

TOP = Path(__file__).resolve().parent.parent


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
        path.write_text(line(42))
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
