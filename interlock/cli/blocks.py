"""`interlock blocks`: lengths of block sections from the traffic."""

from __future__ import annotations

import sys
from dataclasses import asdict

import click

from interlock.app.blocks import Blocks, block_lengths
from interlock.cli.common import FINDINGS, OK, format_option, put_json, show
from interlock.diag import render

_COLOURS = {"fine": "green", "no reserve": "yellow", "too long": "red", "too short": "red"}


@click.command("blocks")
@click.argument("layout")
@click.option("--dispatch", type=click.Path(), help="The dispatch file; by default LAYOUT with the ending .dispatch.")
@click.option(
    "--rounding", type=click.Choice(["up", "none"]), help="Whether loaded trains are rounded up, on every line."
)
@format_option
def command(layout: str, dispatch: str | None, rounding: str | None, form: str) -> None:
    """Compute block section lengths (formulas 3-1 to 3-9 of document B), and compare the layout's own sections."""
    found = block_lengths(layout, dispatch, rounding)
    if form == "json":
        put_json(_body(found))
    elif not found.ok:
        show(found.diagnostics, dict(found.sources), form)
    else:
        _print(found)
    sys.exit(FINDINGS if not found.ok or found.findings else OK)


def _body(found: Blocks) -> dict[str, object]:
    return {
        "file": found.checked.path,
        "ok": found.ok and not found.findings,
        "diagnostics": render.as_json(list(found.diagnostics), dict(found.sources)),
        "lines": [asdict(b) for b in found.blocks],
        "sections": [asdict(x) for x in found.lengths],
        "braking": None if found.braking is None else asdict(found.braking),
        "advice": list(found.advice),
    }


def _print(found: Blocks) -> None:
    for b in found.blocks:
        place, a, c, d = ("tippler", "3-1", "3-2", "3-4") if b.main else ("loading", "3-1", "3-3", "3-5")
        e, f = ("3-6", "3-7") if b.main else ("3-8", "3-9")
        click.echo(click.style(b.name, bold=True))
        click.echo(f"  {a}  loaded trains       {b.loaded:10.3f} a shift")
        click.echo(f"  {c}  trains              {b.trains:10.3f} a shift")
        click.echo(f"  {d}  {place} works       {b.hours:10.3f} h a shift")
        click.echo(f"  {e}  between trains      {b.headway_min:10.3f} min")
        click.echo(f"  {f}  longest section     {b.longest_m:10.1f} m")
        click.echo(f"       two thirds of it    {b.built_m:10.1f} m")
    if found.braking is not None:
        stop = found.braking
        click.echo(
            f"at {stop.kmh:g} km/h braking takes {stop.braking_m:.1f} m, stopping {stop.stopping_m:.1f} m; "
            f"least section {stop.least_m:.1f} m"
        )
    for x in found.lengths:
        grade = click.style(f"{x.grade:10}", fg=_COLOURS[x.grade])
        click.echo(f"  {x.section:14} {x.line:8} {x.metres:7.1f} m  {grade}  {x.advice}")
    for said in found.advice:
        click.echo(f"  {said}")
