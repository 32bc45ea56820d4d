"""`interlock schedule`: a train dispatching problem in a file of DISPLIB, planned."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import click

from interlock.app.own import write_whole
from interlock.cli.common import (
    FINDINGS,
    NOT_PROVED,
    OK,
    Amount,
    failed,
    force_option,
    format_option,
    progress,
    put_json,
)
from interlock.diag.extras import install
from interlock.planning.displib import BadFile, decoded, write
from interlock.planning.planner import Planned, schedule
from interlock.planning.solver import installed
from interlock.planning.verify import verified

KEYS = {"objective_value", "events"}
"""The keys of a solution."""


@click.command("schedule")
@click.argument("problem", type=click.Path(path_type=Path, dir_okay=False))
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="Write the solution here.")
@click.option("--seconds", type=Amount(0, 86400), default=60, show_default=True, help="Stop after this many seconds.")
@click.option("--workers", type=click.IntRange(1, 64), default=1, show_default=True, help="Threads of the solver.")
@click.option(
    "--seed", type=click.IntRange(0), default=0, show_default=True, help="Seed of everything that is drawn at random."
)
@force_option
@format_option
def command(
    problem: Path, output: Path | None, seconds: float, workers: int, seed: int, force: bool, form: str
) -> None:
    """Plan the trains of PROBLEM, a DISPLIB file: by rules at once, then better as time allows."""
    if output is not None and output.exists() and not force and not _solution(output):
        failed(f"{output} exists and is no solution; --force overwrites it", form)
        sys.exit(FINDINGS)
    try:
        data = problem.read_bytes()
        asked = decoded(data)
        with progress(str(problem)) as report:
            report("planning", 0, 0)
            found = schedule(asked, seconds, workers, seed)
        wrong = _wrong(data, found)
        if output is not None and found.plan is not None and not wrong:
            write_whole(output, write(found.plan).encode())
    except OSError as error:
        failed(f"{error.filename}: {error.strerror}", form)
        sys.exit(FINDINGS)
    except BadFile as error:
        failed(f"{problem}: {error}", form)
        sys.exit(FINDINGS)
    if wrong:
        raise AssertionError(f"a plan that does not hold: {wrong[0]}")
    _told(problem, found, form)
    sys.exit(OK if found.plan is not None else FINDINGS if found.none else NOT_PROVED)


def _solution(path: Path) -> bool:
    try:
        data = json.loads(path.read_bytes())
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(data, dict) and data.keys() == KEYS


def _wrong(problem: bytes, found: Planned) -> list[str]:
    """What the second opinion has against a plan; it reads the problem with code of its own."""
    if found.plan is None:
        return []
    cost, wrong = verified(json.loads(problem), json.loads(write(found.plan)))
    return wrong if cost == found.plan.cost else [*wrong, f"it costs {cost}"]


def _told(problem: Path, found: Planned, form: str) -> None:
    plan = found.plan
    if form == "json":
        body = {"problem": str(problem), "ok": plan is not None, "cost": None if plan is None else plan.cost}
        put_json({**body, "bound": found.bound, "best": found.best, "none": found.none, "by": found.by,
                  "seconds": round(found.seconds, 2)})  # fmt: skip
    elif plan is None:
        said = "there is no plan" if found.none else f"UNKNOWN: no plan was found in {found.seconds:.1f} s"
        click.echo(f"{problem}: {said}")
    else:
        if not installed():
            click.echo(f"without the extra `plan` ({install('plan')}) nothing is shown of better plans", err=True)
        said = "no plan costs less" if found.best else f"no plan costs less than {found.bound}"
        click.echo(f"{problem}: a plan that costs {plan.cost} ({found.by}); {said}; {found.seconds:.1f} s")
