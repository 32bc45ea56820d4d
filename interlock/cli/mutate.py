"""`interlock mutate`: weaken table, controller and text on purpose and see which claim fails."""

from __future__ import annotations

import sys

import click

from interlock.app.check import check_file
from interlock.cli.common import FINDINGS, OK, format_option, put_json, show
from interlock.logic.lower import lower
from interlock.proof.limits import Limits
from interlock.proof.mutate import KINDS, Fate, Outcome, run_mutants
from interlock.proof.text_mutants import TEXT_KINDS, run_text_mutants


@click.command("mutate")
@click.argument("layout")
@click.option(
    "--sample",
    type=click.IntRange(0, 100_000),
    default=2,
    show_default=True,
    help="Mutants of each kind, evenly spread; 0 for all.",
)
@click.option(
    "--kind", "kinds", multiple=True, type=click.Choice([*(k.name for k in KINDS), *TEXT_KINDS]), help="Only this kind."
)
@click.option("--search-seconds", type=float, default=30.0, show_default=True)
@click.option("--stories", is_flag=True, help="Tell the train movement of each killed mutant.")
@format_option
def command(layout: str, sample: int, kinds: tuple[str, ...], search_seconds: float, stories: bool, form: str) -> None:
    """Seed single weakenings; each must fail a claim or be shown redundant, and no changed text may pass as equal."""
    checked = check_file(layout)
    if not checked.ok or checked.layout is None or checked.table is None:
        show(checked.diagnostics, {checked.source.file: checked.source.text}, form)
        sys.exit(FINDINGS)

    def report(o: Outcome) -> None:
        if form == "json":
            return
        click.echo(f"{o.kind:26} {o.fate:26} {' '.join(o.claims[:3]):42} {o.place}")
        if stories:
            for n, step in enumerate(o.story, 1):
                click.echo(f"    {n}. {step}")

    limits = Limits(search_depth=20, search_s=search_seconds)
    outcomes: list[Outcome] = []
    if not kinds or set(kinds) - set(TEXT_KINDS):
        outcomes += run_mutants(checked.layout, checked.table, sample, limits, report, kinds)
    if not kinds or set(kinds) & set(TEXT_KINDS):
        outcomes += run_text_mutants(lower(checked.layout, checked.table), sample, report, kinds)
    if form == "json":
        put_json(
            [
                {
                    "kind": o.kind,
                    "place": o.place,
                    "fate": str(o.fate),
                    "claims": list(o.claims),
                    "story": list(o.story),
                }
                for o in outcomes
            ]
        )
    else:
        counts = {f: sum(o.fate is f for o in outcomes) for f in Fate}
        click.echo(", ".join(f"{n} {f}" for f, n in counts.items()))
    sys.exit(OK)
