"""`interlock mutate`: change table, controller and text on purpose, one change at a time, and see what notices."""

from __future__ import annotations

import sys
import time
from collections import Counter
from collections.abc import Iterable
from difflib import get_close_matches
from functools import lru_cache
from pathlib import Path

import click

from interlock.app.check import check_file
from interlock.cli.common import FINDINGS, NOT_PROVED, OK, Amount, format_option, jobs_option, progress, put_json, show
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.engines.limits import Limits
from interlock.proof.mutation.campaign import Campaign, Judged
from interlock.proof.mutation.judge import Fate, Verdict
from interlock.proof.mutation.movements import judge as searched
from interlock.proof.mutation.points import Mutation
from interlock.proof.mutation.survivors import listed, off_the_list
from interlock.proof.mutation.texts import TEXT_FAMILIES, text_mutants
from interlock.table.rows import InterlockingTable

DEPTH = 20
"""Scans of a run in which a movement to harm is looked for (our choice)."""


def _shard(ctx: click.Context, param: click.Parameter, value: str) -> tuple[int, int]:
    """`2/3`: the second of three."""
    k, _, n = value.partition("/")
    if not (k.isdecimal() and n.isdecimal() and 1 <= int(k) <= int(n)):
        raise click.BadParameter(f"{value!r} is not K/N with 1 <= K <= N", ctx, param)
    return int(k), int(n)


@click.command("mutate")
@click.argument("layout")
@click.option("--all", "every", is_flag=True, help="Every mutant; otherwise the first of every form in every family.")
@click.option("--family", "families", multiple=True, help="Only this family, as the table names it.")
@click.option(
    "--kept", type=click.Path(dir_okay=False, path_type=Path), help="Keep verdicts in this file, and resume from it."
)
@click.option("--shard", callback=_shard, default="1/1", metavar="K/N", help="Judge only the K-th of N parts.")
@click.option("--stories", is_flag=True, help="Search for a movement to harm for one mutant of each family.")
@click.option(
    "--search-seconds",
    type=Amount(0.1, 3600),
    default=30.0,
    show_default=True,
    help="Seconds to search for one movement to harm.",
)
@click.option(
    "--stories-seconds",
    type=Amount(0.1, 36000),
    default=300.0,
    show_default=True,
    help="Seconds after which no search is begun any more; the families left are UNKNOWN, exit code 3.",
)
@jobs_option
@format_option
def command(
    layout: str,
    every: bool,
    families: tuple[str, ...],
    kept: Path | None,
    shard: tuple[int, int],
    stories: bool,
    search_seconds: float,
    stories_seconds: float,
    jobs: int,
    form: str,
) -> None:
    """Change one thing at a time: equations, operands, outputs, timers, presets, initial values of the controller, the
    table by named weakenings, and the emitted texts.  Claims, functions, trains or operators must notice, or a solver
    show that nothing has changed; what survives otherwise must be on the published list."""
    checked = check_file(layout)
    if not checked.ok or checked.layout is None or checked.table is None:
        show(checked.diagnostics, checked.source.texts, form)
        sys.exit(FINDINGS)
    _known(layout, families)
    campaign = Campaign(_made, {layout: every}, frozenset(families), weakened=True)
    with progress(layout) as report:
        report("judging mutants", 0, 0)
        found = campaign.run(kept, jobs, shard, lambda done, total: report("judging mutants", done, total))[layout]
        if shard[0] == 1:
            report("editing the texts", 0, 0)
            found += [(m, v) for m, v in text_mutants(_made(layout)[2], 0 if every else 1) if _wanted(m, families)]
        if stories:
            report("searching for movements to harm", 0, 0)
        told, left = _stories(layout, found, search_seconds, stories_seconds) if stories else ({}, 0)
    if form == "json":
        put_json([_row(m, v) | ({"story": told[m.family]} if m.family in told else {}) for m, v in found])
    else:
        _print(found, told)
    whole = all(v for _, v in found) and not left
    sys.exit(FINDINGS if off_the_list(found) else OK if whole else NOT_PROVED)


@lru_cache(1)
def _made(path: str) -> tuple[Layout, InterlockingTable, Controller]:
    checked = check_file(path)
    assert checked.layout is not None and checked.table is not None
    return checked.layout, checked.table, lower(checked.layout, checked.table)


def _known(layout: str, families: tuple[str, ...]) -> None:
    """Raises `click.UsageError` for a family of which this layout has no mutant."""
    if not families:
        return
    there = {m.family for m in Campaign(_made, {layout: True}, weakened=True).chosen(layout)} | TEXT_FAMILIES
    for family in families:
        if family not in there:
            near = get_close_matches(family, sorted(there), 3) or sorted(there)
            raise click.UsageError(f"there is no mutant of the family {family!r} here; there is {', '.join(near)}")


def _wanted(m: Mutation, families: tuple[str, ...]) -> bool:
    return not families or m.family in families


def _row(m: Mutation, v: Verdict | None) -> dict[str, object]:
    """A mutant and its fate, None while it is not judged yet; if it survives, the reason why it may, or None."""
    row: dict[str, object] = {"family": m.family, "form": m.form, "mutation": m.name}
    if v is None:
        return {**row, "fate": None, "why": None}
    listing = {"listed": listed().get(m.shape)} if v.fate is Fate.SURVIVES else {}
    return {**row, "fate": str(v.fate), "why": v.why, **listing}


def _stories(layout: str, found: Iterable[Judged], seconds: float, in_all: float) -> tuple[dict[str, list[str]], int]:
    """For each family what a search for a movement to harm has found, with the first mutant that fails a claim; and for
    how many families none was begun, since the time was over."""
    told: dict[str, list[str]] = {}
    left = 0
    ends = time.monotonic() + in_all
    for m, v in found:
        if not v or v.fate is not Fate.CLAIM or m.family in told:
            continue
        rest = ends - time.monotonic()
        if rest <= 0:
            told[m.family] = [f"{m.name}: UNKNOWN: no movement to harm was looked for, since {in_all:g} s were over"]
            left += 1
            continue
        limits = Limits(search_depth=DEPTH, search_s=min(seconds, rest))
        outcome = searched(_made(layout)[0], m.family, m.name, m.make(), limits)
        none = f"no movement to harm was found in runs of {DEPTH} scans within {limits.search_s:.3g} s"
        first = ", ".join(outcome.claims[:3]) if outcome.story else none
        told[m.family] = [f"{m.name}: {first}", *outcome.story]
    return told, left


def _print(found: list[Judged], told: dict[str, list[str]]) -> None:
    fates: dict[str, Counter[Fate | None]] = {}
    for m, v in found:
        fates.setdefault(m.family, Counter())[v.fate if v else None] += 1
    for family, count in fates.items():
        words = ", ".join(f"{n} {fate or 'not judged yet'}" for fate, n in count.most_common())
        click.echo(f"{family:34} {count.total():6}  {words}")
        for n, step in enumerate(told.get(family, ())):
            click.echo(f"    {n}. {step}" if n else f"    {step}")
    for m, v in found:
        if v and v.fate is Fate.SURVIVES:
            click.echo(f"survives: {m.name}: {listed().get(m.shape, 'NOT ON THE LIST')}  ({v.why or 'no equivalence'})")
    total: Counter[Fate | None] = sum(fates.values(), Counter())
    words = ", ".join(f"{n} {fate or 'not judged yet'}" for fate, n in total.most_common())
    kinds = "1 family" if len(fates) == 1 else f"{len(fates)} families"
    click.echo(f"{total.total()} mutants in {kinds}: {words}")
