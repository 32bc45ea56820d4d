"""The public train dispatching problems of `displib/displib.github.io`, planned, against the best plans that are known.

    python -m tests.campaigns.displib --problems DIR [--solutions DIR] [--verifier FILE] [--seconds N] [--workers N]
        [--only smi,nor1_critical] [--kept FILE] [--page] [-o proofs/displib.md]

DIR: the folders of that checkout with problems and with published solutions (beside it, by default); FILE: its
verifier, `displib_verify.py`.  Nothing of them is kept here.  The best known cost is that of the published solution, as
`interlock.planning.verify` computes it.  Instances that stand in --kept are not planned again, so that a campaign that
was broken off goes on.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median

from interlock.planning.displib import read, write
from interlock.planning.planner import schedule
from interlock.planning.verify import verified
from tests.campaigns.origin import processor

GROUPS = ("smi_close", "smi_headway", "nor1_critical", "nor2", "nor3", "swi_1")
"""What is planned unless other groups are asked for: beginnings of names, or whole names."""


@dataclass(frozen=True)
class Row:
    """An instance with what was found.  cost: None without a plan; wrong: what a verifier has against it."""

    name: str
    trains: int
    operations: int
    cost: int | None
    known: int | None
    bound: int
    rules: int | None
    by: str
    verified_by: str
    wrong: str
    seconds: float
    processor_s: float
    limit: float
    workers: int
    commit: str

    @property
    def gap(self) -> float | None:
        """Per cent above the best known cost; 0 where both are 0."""
        if self.cost is None or self.known is None:
            return None
        if self.cost == self.known:
            return 0.0
        return 100 * (self.cost - self.known) / self.known if self.known else float("inf")


def known(solutions: Path, name: str, problem: object) -> int | None:
    """The least cost of the published solutions of an instance that hold."""
    found = []
    for path in solutions.glob(f"{name}_*.json"):
        if path.stem.rpartition("_")[0] == name:
            cost, wrong = verified(problem, json.loads(path.read_text("utf-8")))
            found += [] if wrong else [cost]
    return min(found, default=None)


def theirs(verifier: Path, problem: Path, solution: str, cost: int) -> str:
    """What the library's own verifier has against a solution, in a process of its own; nothing: it agrees."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "solution.json"
        file.write_text(solution, "utf-8")
        done = subprocess.run(
            [sys.executable, str(verifier), str(problem), str(file)], capture_output=True, text=True, check=False
        )
    said = f"feasible with objective value {cost}."
    return "" if done.returncode == 0 and said in done.stdout else (done.stdout + done.stderr)[-300:]


def measured(path: Path, options: argparse.Namespace, commit: str) -> Row:
    """An instance planned and verified."""
    raw, problem = json.loads(path.read_text("utf-8")), read(path)
    first: list[int] = []
    before = _processor_s()
    found = schedule(
        problem, options.seconds, options.workers, note=lambda p, by: first.append(p.cost) if by == "rules" else None
    )
    spent = _processor_s() - before
    cost, wrong, by = None, "no plan", ""
    if found.plan is not None:
        text, cost = write(found.plan), found.plan.cost
        value, faults = verified(raw, json.loads(text))
        wrong, by = "; ".join(faults[:3]) or ("" if value == cost else f"it costs {value}"), "own"
        if options.verifier is not None and not wrong:
            wrong, by = theirs(options.verifier, path, text, cost), "own, DISPLIB"
    best = known(options.solutions or path.parent.parent / "solutions", path.stem, raw)
    size = len(problem.trains), problem.operations
    return Row(path.stem, *size, cost, best, found.bound, first[0] if first else None, found.by, by, wrong,
               found.seconds, spent, options.seconds, options.workers, commit)  # fmt: skip


def _processor_s() -> float:
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def chosen(folder: Path, groups: Sequence[str]) -> list[Path]:
    """The instances of some groups, in the order of groups and of their numbers."""
    paths: list[Path] = []
    for g in groups:
        found = [p for p in folder.glob("*.json") if p.stem == g or p.stem.startswith(f"{g}_")]
        paths += sorted(found, key=lambda p: (len(p.stem), p.stem))
    return list(dict.fromkeys(paths))


def page(rows: Sequence[Row], verifier: bool, note: str = "") -> str:
    """The table.  note: sentences on how it was measured."""
    commits = ", ".join(dict.fromkeys(r.commit for r in rows))
    gaps = [r.gap for r in rows if r.gap is not None]
    limits = "; ".join(sorted({f"{r.limit:g} s, {r.workers} thread{'s' if r.workers > 1 else ''}" for r in rows}))
    good = sum(r.cost is not None and not r.wrong for r in rows)
    lines = [
        "# Train dispatching problems",
        "",
        f"`python -m tests.campaigns.displib --problems DIR`, at commit {commits}, {processor()}, {os.cpu_count()} "
        f"cores, Python {platform.python_version()}, on problems of the public library DISPLIB "
        "(`displib/displib.github.io`), none of which is kept here.",
        "",
        f"Limit by the clock on the wall: {limits}.  {note}"
        "*Processor*: seconds that the planner had.  The aim is ten minutes on two cores.  *Rules*: the first plan, "
        "without search.  *Bound*: no plan costs less; bold: the plan is shown to be best.  *Known*: the published "
        "solution of least cost.  *Gap*: per cent above that."
        + ("  Plans are verified by `planning/verify.py` and by the library's own verifier." if verifier else ""),
        "",
        f"{good} of {len(rows)} instances have a plan that holds; median gap {median(gaps):.1f} %, mean "
        f"{sum(gaps) / len(gaps):.1f} %, worst {max(gaps):.1f} %; {sum(g <= 0 for g in gaps)} as cheap as the best "
        "known.",
        "",
        "| instance | trains | operations | rules | cost | known | gap | bound | found by | verified by | seconds "
        "| processor |",
        "|---|---:|---:|---:|---:|---:|---:|---:|---|---|---:|---:|",
    ]
    for r in rows:
        gap = "" if r.gap is None else f"{r.gap:.1f}"
        bound = f"**{r.bound:,}**" if r.bound == r.cost else f"{r.bound:,}"
        lines.append(
            f"| {r.name} | {r.trains} | {r.operations:,} | {_count(r.rules)} | {_count(r.cost)} | {_count(r.known)} "
            f"| {gap} | {bound} | {r.by} | {f'**{r.wrong}**' if r.wrong else r.verified_by} | {r.seconds:.0f} | "
            f"{r.processor_s:.0f} |"
        )
    return "\n".join([*lines, ""])


def _count(value: int | None) -> str:
    return "" if value is None else f"{value:,}"


def main() -> int:
    """Write the table; 1 when an instance has no plan, or a verifier refuses one."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--problems", type=Path, required=True)
    parser.add_argument("--solutions", type=Path)
    parser.add_argument("--verifier", type=Path)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--only", default=",".join(GROUPS), help="groups or instances, separated by commas")
    parser.add_argument("--kept", type=Path, help="instances that are done")
    parser.add_argument("--note", default="", help="sentences on how it was measured, for the page")
    parser.add_argument("-o", "--output", type=Path, default=Path("proofs/displib.md"))
    parser.add_argument(
        "--page", action="store_true", help="write the page from the instances that are done, and no more"
    )
    options = parser.parse_args()
    told = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    rows: dict[str, Row] = {}
    if options.kept is not None and options.kept.exists():
        for line in options.kept.read_text("utf-8").splitlines():
            row = Row(**json.loads(line))
            rows[row.name] = row
    paths = chosen(options.problems, options.only.split(","))
    if not paths:
        parser.error(f"{options.problems} has no such problems")
    for path in paths:
        if path.stem not in rows and not options.page:
            began = time.monotonic()
            row = rows[path.stem] = measured(path, options, told.stdout.strip())
            print(row.name, row.cost, row.known, row.gap, row.wrong, f"{time.monotonic() - began:.0f} s", flush=True)
            if options.kept is not None:
                with options.kept.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(asdict(row)) + "\n")
    done = [rows[p.stem] for p in paths if p.stem in rows]
    options.output.write_text(page(done, all("DISPLIB" in r.verified_by for r in done), options.note), encoding="utf-8")
    return 1 if any(r.wrong or r.cost is None for r in done) else 0


if __name__ == "__main__":
    sys.exit(main())
