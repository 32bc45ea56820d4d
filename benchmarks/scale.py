"""The whole of `interlock prove`, from YAML to verdicts, on growing yards and lines: `python -m benchmarks.scale`.

Each run is a process of its own with two processes for the induction (`-j 2`), witnesses and comparison of the texts
included; the growth exponent is that of the seconds between two sizes of one kind.  How quick the machine is at that
time, a loop tells that is the same before each run.

`python -m benchmarks.scale --older FOLDER` times `prove` in turn with an older version that is unpacked in a folder.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from interlock.app.init import line, yard

TOP = Path(__file__).resolve().parent.parent
SIZES = (
    ("yard", 30),
    ("yard", 60),
    ("yard", 124),
    ("yard", 372),
    ("line", 62),
    ("line", 125),
    ("line", 250),
    ("line", 1250),
)


LOOPS: list[float] = []
"""Seconds of the loop, before each run."""


def loop() -> float:
    """Seconds that five million additions take."""
    began, x = time.perf_counter(), 0
    for i in range(5_000_000):
        x += i
    return time.perf_counter() - began


def run(path: Path, *more: str) -> tuple[float, float, dict[str, object]]:
    """Seconds, GiB at most, and what `prove` said."""
    args = [sys.executable, "-m", "interlock.cli.main", "prove", str(path), "-j", "2", "--format", "json", *more]
    LOOPS.append(loop())
    began = time.perf_counter()
    with tempfile.TemporaryFile() as out:
        child = subprocess.Popen(args, cwd=TOP, stdout=out)
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.perf_counter() - began
        out.seek(0)
        body = json.loads(out.read())[0]
    return seconds, used.ru_maxrss / 1024 / 1024, body


PAIRED = (("cn6502", 7), ("yard 124", 5), ("yard 372", 3), ("line 250", 3))
"""What is timed in turn with an older version, and how often."""


def timed(version: Path, path: Path) -> tuple[float, float]:
    """Seconds on the clock and of processor time of `prove` of a version."""
    args = [sys.executable, "-m", "interlock.cli.main", "prove", str(path), "-j", "2"]
    own = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"} | {"PYTHONPATH": str(version)}
    began = time.perf_counter()
    child = subprocess.Popen(args, cwd=version, env=own, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f"{version} does not prove {path}")
    return time.perf_counter() - began, used.ru_utime + used.ru_stime


def compare(older: Path) -> None:
    """Both versions in turn, each on its own cn6502 and on the same yards and lines; each once beforehand, so that
    Python has its compiled modules."""
    print("| layout | older, s | now, s | ratio, median (processor) | pairs |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, count in PAIRED:
            paths = [version / "layouts" / f"{name}.yaml" for version in (older, TOP)]
            if " " in name:
                kind, size = name.split()
                paths = [Path(folder) / f"{kind}{size}.yaml"] * 2
                paths[0].write_text(line(int(size)) if kind == "line" else yard(int(size)))
            else:
                timed(older, paths[0]), timed(TOP, paths[1])
            pairs = [(timed(older, paths[0]), timed(TOP, paths[1])) for _ in range(count)]
            clock, processor = (median(new[k] / old[k] for old, new in pairs) for k in (0, 1))
            before, now = (median(pair[k][0] for pair in pairs) for k in (0, 1))
            print(f"| {name} | {before:.2f} | {now:.2f} | {clock:.2f} ({processor:.2f}) | {count} |", flush=True)


def main() -> None:
    """Print the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--older", type=Path, help="the folder of an older version, to be timed in turn with this one")
    parser.add_argument("--most", type=int, default=20_000, help="leave out layouts of more routes than this, about")
    given = parser.parse_args()
    if given.older is not None:
        if not (given.older / "interlock").is_dir():
            parser.error(f"no version is unpacked in {given.older}")
        compare(given.older.resolve())
        return
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=TOP, capture_output=True, text=True).stdout
    kind = (
        f"{platform.machine()}, {os.cpu_count()} cores, {platform.python_implementation()} {platform.python_version()}"
    )
    print(f"# Scale\n\n`python -m benchmarks.scale` at commit {commit.strip()}, {kind}.\n")
    print(
        "| layout | routes | seconds | GiB, largest process | claims | places | text = controller | growth exponent |"
    )
    print("|---|---|---|---|---|---|---|---|")
    before: dict[str, tuple[int, float]] = {}
    with tempfile.TemporaryDirectory() as folder:
        for kind, size in SIZES:
            if size * 8 > given.most:  # eight routes for each track or station
                continue
            path = Path(folder) / f"{kind}{size}.yaml"
            path.write_text(line(size) if kind == "line" else yard(size))
            seconds, memory, body = run(path)
            claims, witnesses = body["claims"], body["witnesses"]
            assert isinstance(claims, list) and isinstance(witnesses, list)
            proved = sum(c["verdict"] == "PROVED" for c in claims)
            places = sum(c["places"] for c in claims)
            routes = len(witnesses)
            exponent = ""
            if kind in before:
                old = before[kind]
                exponent = f"{math.log(seconds / old[1]) / math.log(routes / old[0]):.2f}"
            before[kind] = (routes, seconds)
            print(
                f"| {kind} {size} | {routes} | {seconds:.1f} | {memory:.2f} | {proved} of {len(claims)} PROVED "
                f"| {places} | {body['text_equals_controller']} | {exponent} |",
                flush=True,
            )
        second_run(Path(folder), min(124, given.most // 8))
    middle = sorted(LOOPS)[len(LOOPS) // 2]
    print(f"\nA loop of five million additions before each run: {min(LOOPS):.2f} to {max(LOOPS):.2f} s, half of them")
    print(f"under {middle:.2f} s.")


CHANGES = (
    ("the signal HW1 was moved by 10 m (the proof is the same)", "[W1, Wa1 300]", "[W1, Wa1 310]"),
    ("overlaps are released 5 s later (texts and witnesses are new)", "_release_s: 45", "_release_s: 50"),
    ("HW2 can call on (more routes, and a new proof around them)", "into: Ws2}", "into: Ws2, call_on: yes}"),
)


def second_run(folder: Path, tracks: int) -> None:
    """Answers kept: a yard is proved, changed, and proved again; one change after the other."""
    path, kept = folder / "moved.yaml", str(folder / "kept")
    text = yard(tracks)
    path.write_text(text)
    first, _, _ = run(path, "--cache", kept)
    print(f"\n`prove --cache` on yard {tracks}: {first:.1f} s.  Again, after")
    for what, before, after in CHANGES:
        assert text.count(before) == 1, before
        path.write_text(text.replace(before, after))
        again, _, body = run(path, "--cache", kept)
        claims = body["claims"]
        assert isinstance(claims, list) and all(c["verdict"] == "PROVED" for c in claims)
        print(f"- {what}: {again:.1f} s ({again / first:.2f} of the first run)", flush=True)


if __name__ == "__main__":
    main()
