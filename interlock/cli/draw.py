"""`interlock draw`: the track plan."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from interlock.app.draw import Paper, draw_file
from interlock.app.own import NotOurs, write_own
from interlock.cli.common import FINDINGS, OK, failed, force_option, format_option, progress, put_json, show, told


@click.command("draw")
@click.argument("layout", type=click.Path())
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path, dir_okay=False),
    help="The file to write; by default NAME.svg here.",
)
@click.option(
    "--sheets",
    is_flag=True,
    help="Draw on A3 sheets with match lines: NAME-1.svg, NAME-2.svg and so on.",
)
@click.option("--fold", is_flag=True, help="Fold the plan into rows, one below the other, for lines.")
@force_option
@format_option
def command(layout: str, output: Path | None, sheets: bool, fold: bool, force: bool, form: str) -> None:
    """Draw the track plan of LAYOUT as SVG, from its topology alone."""
    target = output or Path(Path(layout).stem + ".svg")
    if target.suffix.lower() != ".svg" and target.resolve() != Path(layout).resolve():
        raise click.UsageError(f"{target}: a plan is drawn as SVG: call it {target.with_suffix('.svg').name}")
    if sheets and fold:
        raise click.UsageError("--sheets and --fold are two ways to put a long plan on paper: choose one")
    paper = Paper.SHEETS if sheets else Paper.FOLDED if fold else Paper.WHOLE
    with progress(layout) as report:
        report("drawing", 0, 0)
        drawn = draw_file(layout, paper)
    if not drawn.pages:
        show(drawn.diagnostics, drawn.source.texts, form)
        sys.exit(FINDINGS)
    files = [target]
    if sheets:
        files = [target.with_stem(f"{target.stem}-{k}") for k in range(1, len(drawn.pages) + 1)]
    sizes = []
    for file, page in zip(files, drawn.pages, strict=True):
        try:
            sizes.append(write_own(file, page.encode(), Path(layout), force))
        except (NotOurs, OSError) as error:
            failed(told(error, file), form)
            sys.exit(FINDINGS)
    if form == "json":
        written = [{"file": str(f), "bytes": n} for f, n in zip(files, sizes, strict=True)]
        put_json(
            {"ok": True, **written[0], "notes": list(drawn.notes), **({"sheets": written} if sheets or fold else {})}
        )
    else:
        for note in drawn.notes:
            click.echo(f"note: {note}")
        for file, size in zip(files, sizes, strict=True):
            click.echo(f"{file}: {size} bytes")
    sys.exit(OK)
