"""Published interlocking tables of nineteen stations and lines, row by row; each proved, verified, driven in metres.

python -m tests.campaigns.published [-o proofs/stations.md] [--scans N]

1 when a difference is not explained, an explanation explains nothing, a station is not proved and verified, or a train
comes to harm.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.checker.check import check
from tests.campaigns.origin import processor
from tests.campaigns.simulate import BOTH, OPERATOR, Case, drive
from tests.published import COLUMNS, HERE, STATIONS, Comparison, additions, compare, station


def proved(name: str) -> tuple[str, bool]:
    """A row of what compiling, certifying and verifying a station says, and whether all is well."""
    path = str(HERE / f"{name}.yaml")
    with TemporaryDirectory() as top:
        compiled = compile_file(path, Path(top) / "generated")
        done = certify_file(path, Path(top) / "generated", Path(top) / "proofs")
        if compiled.proof is None or not compiled.green or not done.ok:
            return f"| {name} | **NOT PROVED** | | | | | |", False
        began = time.monotonic()
        said = check(HERE / f"{name}.yaml", Path(top) / "proofs" / name)
        seconds = time.monotonic() - began
    claims = [c for c in compiled.proof.claims if c.places]
    routes = len(compiled.checked.table.routes) if compiled.checked.table else 0
    verdict = "VERIFIED" if not said.left else f"**left: {', '.join(said.left)}**"
    places = sum(c.places for c in claims)
    took = f"{compiled.seconds:.1f} | {done.seconds:.0f} | {verdict}, {seconds:.1f} s"
    return f"| {name} | {routes} | PROVED | {len(claims)} at {places:,} places | {took} |", not said.left


SEEDS = (1, 2, 3)
"""Each drives a station for a third of the scans."""

METRES = "Trains in metres on the emitted runtimes, with a random and a hostile operator ([how](simulation.md)):"

DRIVEN = "| station | operator | scans | trains | movements | hazards |\n|---|---|---:|---:|---:|---:|"


def driven(name: str, scans: int) -> tuple[list[str], bool]:
    """A row for each operator of trains in metres on the emitted runtime, and whether nothing came to harm."""
    case, lines, harm = Case.of(str(HERE / f"{name}.yaml")), [], 0
    for hostile in BOTH:
        found = [drive(case, scans // len(SEEDS), seed, hostile) for seed in SEEDS]
        hazards = sum(len(o.hazards) + len(o.passed_at_stop) for o in found)
        told = (sum(o.scans for o in found), sum(o.trains for o in found), sum(o.movements for o in found), hazards)
        lines.append(f"| {name} | {OPERATOR[hostile]} | {' | '.join(f'{n:,}' for n in told)} |")
        harm += hazards
    return lines, not harm


def table_lines(c: Comparison) -> list[str]:
    """One row for each published row: `=`, or who has what besides."""
    columns = [k for k in c.station.columns if k != "route"]
    lines = [f"| row | derived | {' | '.join(columns)} |", "|---" * (2 + len(columns)) + "|"]
    for name in c.station.published:
        cells = []
        for k in columns:
            found = [f"{'+' if d.side == 'derived' else '−'}{d.item} {mark}" for d, mark in c.in_cell(name, k)]
            cells.append(", ".join(found) or "=")
        lines.append(f"| {name} | {c.station.derived[name].id} | {' | '.join(cells)} |")
    return lines


def why_lines(c: Comparison) -> list[str]:
    """The explanations, each once, with the number of its differences."""
    lines = ["| mark | column | differences | why |", "|---|---|---:|---|"]
    for mark in dict.fromkeys(w.mark for w in c.why):
        those = [w for w in c.why if w.mark == mark]
        n = sum(any(w.covers(d) for w in those) for d in c.differences)
        lines.append(f"| {mark} | {those[0].column} | {n} | {those[0].text.strip()} |")
    return lines


def of_station(c: Comparison) -> list[str]:
    """The part of the page on a station."""
    s = c.station
    lines = [f"## {s.layout.printed.title}", "", f"**Source.** {s.about['source'].strip()}", ""]
    lines += [f"**What was read.** {s.about['read'].strip()}  {s.about['drawn'].strip()}", ""]
    same = sum(not any(d.route == n for d in c.differences) for n in s.published)
    have = "row has" if same == 1 else "rows have"
    lines += [
        f"{len(s.rows)} published rows, {len(s.table.routes)} derived routes; {same} {have} no difference.",
        "",
    ]
    added = additions(s.name)
    if added:
        bare = compare(station(s.name, bare=True))
        by = [f"{sum(d.column == k for d in bare.differences)} of {k}" for k in COLUMNS]
        lines += [
            f"**What the layout says beyond its track**, so that its table is the published one: "
            f"{', '.join(f'{n} under `{k}`' for k, n in added.items())}.  Without them there are "
            f"{len(bare.differences)} differences: {', '.join(x for x in by if not x.startswith('0'))}.",
            "",
        ]
    lines += ["**Why they differ.**", "", *why_lines(c), ""]
    lines += [
        "**Row by row.**  `+`: derived and not published; `−`: published and not derived.",
        "",
        *table_lines(c),
        "",
    ]
    extra = [d.item for d in c.differences if d.column == "route"]
    if extra:
        lines += [f"Derived and not published: {', '.join(extra)}.", ""]
    return lines


def main() -> int:
    """Write the page."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/stations.md"))
    parser.add_argument("--scans", type=int, default=54_000, help="of each station with each operator")
    options = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    compared = [compare(station(n)) for n in STATIONS]
    results = [proved(n) for n in STATIONS]
    drives = [driven(n, options.scans) for n in STATIONS]
    lines = [
        "# Stations whose interlocking tables others have published",
        "",
        f"`python -m tests.campaigns.published` at commit {commit.stdout.strip()}, {processor()}, {os.cpu_count()} "
        f"cores, Python {platform.python_version()}.  Layouts, published rows and explanations: `tests/stations/`; a "
        "difference that nothing explains fails `tests/test_published.py`.",
        "",
        "| station | routes | verdict | claims | seconds to compile with proof | to certify | `interlock verify` |",
        "|---|---:|---|---|---:|---:|---|",
        *(r for r, _ in results),
        "",
        "| station | rows | differences | " + " | ".join(COLUMNS) + " | not explained |",
        "|---|---:|---:|" + "---:|" * len(COLUMNS) + "---:|",
    ]
    for c in compared:
        by = [sum(d.column == k for d in c.differences) if k in c.station.columns else "" for k in COLUMNS]
        lines.append(
            f"| {c.station.name} | {len(c.station.rows)} | {len(c.differences)} | {' | '.join(map(str, by))} | "
            f"**{len(c.unexplained)}** |"
        )
    lines += ["", "An empty cell: the source has no such column.", "", METRES, "", DRIVEN]
    lines += [*(x for rows, _ in drives for x in rows), ""]
    for c in compared:
        lines += of_station(c)
    options.output.write_text("\n".join(lines), encoding="utf-8")
    well = all(ok for _, ok in (*results, *drives))
    return 0 if well and not any(c.unexplained or c.idle for c in compared) else 1


if __name__ == "__main__":
    sys.exit(main())
