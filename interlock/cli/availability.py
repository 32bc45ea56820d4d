"""`interlock availability`: routes that are not hostile are used together; each opens soon."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

import click

from interlock.app.availability import try_file, write_stories
from interlock.cli.common import FINDINGS, OK, format_option, number_of, progress, put_json, show
from interlock.proof.witnesses.availability import Availability


@click.command("availability")
@click.argument("layout")
@click.option(
    "--traces",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("counterexamples"),
    show_default=True,
    help="Folder for each pair that fails: its trace, and a page that replays it.",
)
@format_option
def command(layout: str, traces: Path, form: str) -> None:
    """Use every two routes of LAYOUT together that are not hostile, in runs of its controller; tell how soon each route
    opens."""
    with progress(layout) as report:
        report("running every two routes", 0, 0)
        tried = try_file(layout)
    if tried.found is None:
        show(tried.checked.diagnostics, tried.checked.source.texts, form)
        sys.exit(FINDINGS)
    found = tried.found
    failed = [p for p in found.pairs if p.failure is not None]
    late = [r for r in found.routes if r.failure is not None]
    pages: list[str] = []
    try:
        pages = [str(page) for page in write_stories(tried, traces)]
    except OSError as error:
        click.echo(f"{traces}: {error.strerror}", err=True)
    if form == "json":
        put_json(_as_json(layout, found) | {"pages": pages})
        sys.exit(OK if found.shown else FINDINGS)
    if form == "full":
        for r in found.routes:
            click.echo(f"  {r.bound.route}: opens within {r.bound.text}")
    for r in late:
        click.echo(f"  {click.style('FAILED', fg='red')} {r.bound.route}: {r.failure}")
    for p in failed:
        click.echo(f"  {click.style('FAILED', fg='red')} {p.first} and {p.second}, {p.manner}: {p.failure}")
    manners = ", ".join(
        f"{n} {m}" if m.startswith("kept") else f"{n} with {m}"
        for m, n in Counter(p.manner for p in found.pairs).items()
    )
    verdict = click.style("SHOWN", fg="green") if found.shown else click.style("NOT AVAILABLE", fg="red")
    click.echo(
        f"{layout}: {verdict}  {number_of(len(found.routes), 'route')}; of {len(found.pairs) + found.hostile} pairs "
        f"{found.hostile} hostile, {len(found.pairs)} used together in {found.runs} runs ({manners or 'none'}), "
        f"{len(failed)} failed"
    )
    for page in pages:
        click.echo(f"  to play it: {page}")
    sys.exit(OK if found.shown else FINDINGS)


def _as_json(layout: str, found: Availability) -> dict[str, object]:
    """What `--format json` prints: each route with its bound in scans and seconds, and each pair with what failed."""
    return {
        "file": layout,
        "ok": found.shown,
        "routes": [
            {
                "route": r.bound.route,
                "scans": r.bound.scans,
                "scans_with_machines": r.bound.at_most_scans,
                "seconds_of_machines": r.bound.seconds,
                "failure": r.failure,
            }
            for r in found.routes
        ],
        "hostile_pairs": found.hostile,
        "runs": found.runs,
        "pairs": [
            {"first": p.first, "second": p.second, "manner": str(p.manner), "apart": p.apart, "failure": p.failure}
            for p in found.pairs
        ],
    }
