"""`interlock certify`: the proof as files that can be checked again."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.certify import certify_file
from interlock.cli.common import FINDINGS, OK, jobs_option, layouts_argument, progress, show, show_proof
from interlock.proof.pool import apart


@click.command("certify")
@layouts_argument
@click.option(
    "--outputs",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("generated"),
    show_default=True,
    help="Where `interlock compile` wrote the outputs.",
)
@click.option(
    "-o",
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("proofs"),
    show_default=True,
    help="Folder for the certificates; each layout gets a folder of its own in it.",
)
@jobs_option
@click.option("--check", is_flag=True, help="Write nothing; verify the certificates and tell whether they are current.")
def command(layouts: tuple[str, ...], outputs: Path, out: Path, jobs: int, check: bool) -> None:
    """Write a certificate of each layout's proof, tied to its outputs, for `interlock verify`."""
    calls = [(p, outputs, out, check) for p in layouts]
    if jobs > 1 and len(calls) > 1:
        results = apart(certify_file, calls, jobs)
    else:
        results = []
        for c in calls:
            with progress(c[0]) as report:
                results.append(certify_file(*c, progress=report))
    for r in results:
        if not r.proved.green:
            show_proof(r.proved, "text", False)
            continue
        source = r.proved.checked.source
        show(r.notes, {source.file: source.text}, "text")
        if r.ok:
            click.echo(f"{r.proved.checked.path}: {'CURRENT' if check else 'CERTIFIED'}  {r.summary}")
    sys.exit(OK if all(r.ok for r in results) else FINDINGS)
