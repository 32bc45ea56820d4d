"""`interlock compile`: table, proof, Structured Text and runtime."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path

import click

from interlock.app.compile import compile_file, names_twice
from interlock.app.proved import Proved
from interlock.app.texts import C99
from interlock.cli.common import (
    FINDINGS,
    each,
    exit_code,
    format_option,
    jobs_option,
    layouts_argument,
    number_of,
    proof_body,
    put_json,
    show,
    show_proof,
)
from interlock.diag.extras import install
from interlock.proof.engines.limits import Limits
from interlock.st.dialects import BY_NAME


@click.command("compile")
@layouts_argument
@click.option(
    "-o",
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("generated"),
    show_default=True,
    help="Folder for the outputs; each layout gets a folder of its own in it.",
)
@jobs_option
@click.option(
    "--dialect",
    "dialects",
    multiple=True,
    type=click.Choice([*BY_NAME, "all", C99]),
    help="Write the PLC text for this tool as well (several times, or `all` PLC texts); iec is always written.  "
    "c99 is the C runtime, which `all` leaves out.",
)
@click.option("--check", is_flag=True, help="Write nothing; tell whether the outputs are current.")
@click.option("--unproved", is_flag=True, help="Write PLC text even if something is not proved, marked as such.")
@click.option("-v", "--verbose", is_flag=True, help="Show every claim.")
@format_option
def command(
    layouts: tuple[str, ...],
    out: Path,
    jobs: int,
    dialects: tuple[str, ...],
    check: bool,
    unproved: bool,
    verbose: bool,
    form: str,
) -> None:
    """Derive the tables, prove the controller, and write all outputs."""
    asked = (*dialects, *BY_NAME) if "all" in dialects else dialects
    tools = tuple(dict.fromkeys(d for d in asked if d != "all"))
    if C99 in dialects and find_spec("pycparser") is None:
        raise click.UsageError(f"c99 needs the extra `c99`: {install('c99')}")
    clashes = names_twice(layouts) if len(layouts) > 1 else ()
    if clashes:
        show(clashes, {}, form)
        sys.exit(FINDINGS)
    limits = Limits(jobs=jobs if len(layouts) == 1 else 1)
    results = each(compile_file, [(p, out, check, unproved, limits, tools) for p in layouts], jobs)
    if form == "json":
        put_json([proof_body(r) | {"folder": str(_folder(r, out)) if r.files else None} for r in results])
    else:
        for r in results:
            show_proof(r, form, verbose)
            if r.green and r.checked.layout is not None:
                where = _folder(r, out)
                click.echo(f"  {'current' if check else 'written'}: {where} ({number_of(len(r.files), 'file')})")
                if not check:
                    click.echo(f"  open in a browser: {where / 'index.html'}")
    sys.exit(exit_code(results))


def _folder(result: Proved, out: Path) -> Path:
    """Where the outputs of a layout are."""
    assert result.checked.layout is not None  # it has outputs
    return out / result.checked.layout.name
