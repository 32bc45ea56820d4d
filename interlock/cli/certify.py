"""`interlock certify`: the proof as files that can be checked again."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.certify import Certified, certify_file
from interlock.cli.common import (
    FINDINGS,
    OK,
    each,
    exit_code,
    format_option,
    jobs_option,
    layouts_argument,
    proof_body,
    put_json,
    show,
    show_proof,
)
from interlock.diag.render import as_json


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
@format_option
def command(layouts: tuple[str, ...], outputs: Path, out: Path, jobs: int, check: bool, form: str) -> None:
    """Write a certificate of each layout's proof, tied to its outputs, for `interlock verify`."""
    results = each(certify_file, [(p, outputs, out, check) for p in layouts], jobs)
    done = "CURRENT" if check else "CERTIFIED"
    if form == "json":
        put_json([_body(r, out, done) for r in results])
    for r in results if form != "json" else ():
        if not r.proved.green:
            show_proof(r.proved, form, False)
        show(r.notes, r.proved.checked.source.texts, form)
        if r.ok:
            click.echo(f"{r.proved.checked.path}: {click.style(done, fg='green')}  {r.summary}, {r.seconds:.1f} s")
            click.echo(f"  {'current' if check else 'written'}: {_folder(r, out)}")
    open_or_wrong = exit_code([r.proved for r in results])
    sys.exit(open_or_wrong or (OK if all(r.ok for r in results) else FINDINGS))


def _folder(r: Certified, out: Path) -> Path | None:
    """Where the certificate of a layout is."""
    return out / r.proved.checked.layout.name if r.ok and r.proved.checked.layout is not None else None


def _body(r: Certified, out: Path, done: str) -> dict[str, object]:
    """With the proof, if that is why there is no certificate."""
    found = [*r.proved.checked.diagnostics, *r.proved.notes, *r.notes]
    folder = _folder(r, out)
    return {
        **({} if r.proved.green else proof_body(r.proved)),
        "file": r.proved.checked.path,
        "ok": r.ok,
        "verdict": done if r.ok else None,
        "folder": None if folder is None else str(folder),
        "text": r.summary,
        "wall_seconds": round(r.seconds, 3),
        "diagnostics": as_json(found, r.proved.checked.source.texts),
    }
