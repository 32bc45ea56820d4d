"""`interlock prove`: one verdict per claim."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path

import click

from interlock.app.prove import prove_file
from interlock.app.proved import Proved
from interlock.cli.common import (
    Amount,
    each,
    exit_code,
    format_option,
    jobs_option,
    layouts_argument,
    proof_body,
    put_json,
    show_proof,
)
from interlock.diag.extras import install
from interlock.proof.engines import ENGINES
from interlock.proof.engines.cache import Cache
from interlock.proof.engines.limits import Limits


@click.command("prove")
@layouts_argument
@jobs_option
@click.option(
    "--search-depth",
    type=click.IntRange(1, 60),
    default=16,
    show_default=True,
    help="Length in scans up to which a counterexample is searched for.",
)
@click.option(
    "--search-seconds",
    type=Amount(0.1, 36000),
    default=60.0,
    show_default=True,
    help="Seconds to search for a counterexample to one claim.",
)
@click.option(
    "--engine",
    type=click.Choice(ENGINES),
    default=ENGINES[0],
    show_default=True,
    help="What decides the obligations; Z3 and cvc5 (extra `recheck`) are slower second opinions.",
)
@click.option(
    "--traces",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("counterexamples"),
    show_default=True,
    help="Folder for each counterexample: its trace, and a page that replays it.",
)
@click.option(
    "--cache",
    type=click.Path(path_type=Path, file_okay=False, writable=True),
    help="Folder in which answered questions are kept for the next run; remove it whenever you like.  An answer is "
    "believed if it is sealed with this user's own key (cache.key in the user's configuration folder for interlock), "
    "made at first use: so it trusts you and whoever can read that file, nobody who can only write to the folder.",
)
@format_option
def command(
    layouts: tuple[str, ...],
    jobs: int,
    search_depth: int,
    search_seconds: float,
    engine: str,
    traces: Path,
    cache: Path | None,
    form: str,
) -> None:
    """Prove every safety claim about a layout, its controller and the text that would be emitted, for every train
    movement that the named assumptions allow.
    """
    if engine == "cvc5" and find_spec("cvc5") is None:
        raise click.UsageError(f"cvc5 needs the extra `recheck`: {install('recheck')}")
    limits = Limits(
        search_depth=search_depth,
        search_s=search_seconds,
        engine=engine,
        jobs=jobs if len(layouts) == 1 else 1,
        cache=Cache(cache),
    )
    if useless := limits.cache.useless():
        click.echo(f"{cache}: nothing is kept: {useless}", err=True)
    foreign = limits.cache.foreign()
    if foreign:
        told = "answer is" if foreign == 1 else "answers are"
        click.echo(f"{cache}: {foreign} {told} not sealed with your key, and not believed: asked again", err=True)
    results = each(prove_file, [(p, limits) for p in layouts], jobs)
    if form == "json":
        put_json([proof_body(r) | {"pages": _write_traces(r, traces)} for r in results])
    else:
        for r in results:
            show_proof(r, form, verbose=True)
            for page in _write_traces(r, traces):
                click.echo(f"  to play it: {page}")
    sys.exit(exit_code(results))


def _write_traces(result: Proved, folder: Path) -> list[str]:
    """The pages that play the counterexamples; that they cannot be written changes no verdict."""
    if not result.traces:
        return []
    from interlock.app.draw import write_traces  # pictures are for counterexamples alone

    try:
        return [str(page) for page in write_traces(result, folder)]
    except OSError as error:
        click.echo(f"{folder}: {error.strerror}", err=True)
        return []
