"""Routes that are not hostile used together: `python -m tests.campaigns.availability > proofs/availability.md`.

Every pair of every shipped layout in every profile, and of a yard of about 300 routes; then weakened tables and
controllers that these runs must find out.
"""

from __future__ import annotations

import argparse
import re
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

from interlock.app.init import yard
from interlock.derivation import derive
from interlock.diag import Severity, Sink
from interlock.frontend import load_text
from interlock.logic.controller import Controller, Equation, Join, Term
from interlock.logic.expr import FALSE
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.model.principles import PROFILES
from interlock.proof.system.loop import closed_loop
from interlock.proof.system.transition import System
from interlock.proof.witnesses.availability import Availability, Manner, Trial, availability, compatible
from interlock.table.cells import Because, Exclusion, ProviderKind, SpaceCell
from interlock.table.rows import InterlockingTable, RouteRow, TraversalRow
from tests.campaigns.origin import origin

LAYOUTS = (*sorted(Path("layouts").glob("*.yaml")), Path("tests/layouts_for_tests/parallel.yaml"))
TRACKS = 37  # a yard of 304 routes

EXPLAINED = """
Every two routes of a layout that its table does not call hostile are used together in runs of its controller and plant:
set, open at the same time, driven, released ([how](../interlock/docs/proof.md)).  *A train each*: three runs, either
train first and both at once.  *One for both*: one route begins where the other ends.  *One at a time*: the other signal
stays open meanwhile, and its route is given back.  *Zone*: a zone does not admit both trains, so nothing is run.
*Shown* and *failed* count pairs.  *Scans*: in which a signal opens after its route was asked for with every machine to
be moved, the shortest and the longest bound of the routes (3 where all lie as needed), machine times apart; *late*
counts routes that did not keep theirs.  Seconds are of processor time.
"""


def under(text: str, profile: str) -> str:
    """A layout's text under another profile."""
    text = re.sub(r"(?m)^profile:.*\n", "", text)
    return re.sub(r"(?m)^(name:.*\n)", rf"\1profile: {profile}\n", text, count=1)


def derived(text: str) -> tuple[Layout, InterlockingTable] | None:
    """Layout and table of a text, or None where it is refused."""
    made, _ = _checked(text)
    return made


def refusal(text: str) -> str:
    """The codes of the errors for which a text is refused."""
    _, sink = _checked(text)
    return ", ".join(dict.fromkeys(d.code for d in sink.diagnostics if d.severity is Severity.ERROR))


def _checked(text: str) -> tuple[tuple[Layout, InterlockingTable] | None, Sink]:
    sink = Sink()
    layout, _ = load_text("campaign.yaml", text, sink)
    table = None if layout is None else derive(layout, sink)
    return None if layout is None or table is None or sink.has_errors else (layout, table), sink


# --- weakenings ------------------------------------------------------------------------------------


def space_to_the_point(layout: Layout, table: InterlockingTable) -> InterlockingTable:
    """The section in which a protecting point lies counts as flank space (the rule until it was corrected)."""

    def of(row: TraversalRow) -> tuple[SpaceCell, ...]:
        machines = {p.name for c in row.flank for p in c.providers if p.kind is ProviderKind.POINT}
        sections = {layout.track.section_of(p.toe) for p in layout.pointwork.points if p.machine in machines} - {
            row.section
        }
        return (*row.space, *(SpaceCell(s, False, Because("R5", f"{s}, up to the point")) for s in sorted(sections)))

    return _with(table, lambda row: replace(row, space=of(row)))


def one_exclusion_too_many(layout: Layout, table: InterlockingTable) -> InterlockingTable:
    """The first way of the first route that can have a train beside another one excludes all of the other's first
    section."""
    system = System(layout, lower(layout, table))
    trial = Trial(system.loop)
    for a, b in compatible(system.loop, table):
        if trial.plan(a, b)[0] is Manner.BESIDE:
            extra = Exclusion(b.path.ways[0][0], True, (), Because("R6", "too much"))

            def more(row: TraversalRow, key: object = a.path.ways[0], extra: Exclusion = extra) -> TraversalRow:
                return replace(row, exclusions=(*row.exclusions, extra)) if row.key == key else row

            return _with(table, more)
    raise AssertionError("no two routes with a train each")


def _with(table: InterlockingTable, change: Callable[[TraversalRow], TraversalRow]) -> InterlockingTable:
    locks = tuple(map(change, table.locks))
    by_key = {t.key: t for t in locks}

    def space(r: RouteRow) -> tuple[SpaceCell, ...]:
        over = [s.key for s in map(by_key.__getitem__, r.path.locked)]
        return tuple(dict.fromkeys(c for key in over for c in by_key[key].space))

    return replace(
        table, locks=locks, routes=tuple(replace(r, clear=replace(r.clear, space=space(r))) for r in table.routes)
    )


def never_given_back(controller: Controller) -> Controller:
    """No route is given back when it is cancelled."""
    steps = tuple(
        replace(s, join=Join.ALL, terms=(Term(FALSE, "changed"),))
        if isinstance(s, Equation) and s.name.startswith("CD_")
        else s
        for s in controller.steps
    )
    return replace(controller, steps=steps)


def weakened() -> Iterator[tuple[str, str, Layout, InterlockingTable, Controller]]:
    """Weakenings, each with the layout on which it is tried."""
    for path in (Path("tests/layouts_for_tests/parallel.yaml"), Path("layouts/cn6502.yaml")):
        made = derived(under(path.read_text("utf-8"), "de"))
        assert made is not None
        layout, table = made
        weak = space_to_the_point(layout, table)
        yield "the section of a protecting point is flank space", path.stem, layout, table, lower(layout, weak)
    for path in (Path("layouts/junction.yaml"), Path("layouts/mine11.yaml")):
        made = derived(path.read_text("utf-8"))
        assert made is not None
        layout, table = made
        weak = one_exclusion_too_many(layout, table)
        yield "one exclusion too many", path.stem, layout, table, lower(layout, weak)
        yield "a cancelled route is not given back", path.stem, layout, table, never_given_back(lower(layout, table))


# --- the page --------------------------------------------------------------------------------------


def row(name: str, profile: str, found: Availability, seconds: float) -> str:
    """One line of the table."""
    count = {m: sum(p.manner is m for p in found.pairs) for m in Manner}
    failed = sum(p.failure is not None for p in found.pairs)
    scans = [r.bound.at_most_scans for r in found.routes]
    late = sum(r.failure is not None for r in found.routes)
    cells = [name, profile, len(found.routes), found.hostile, len(found.pairs)]
    cells += [count[m] for m in (Manner.BESIDE, Manner.AFTER, Manner.ALONE, Manner.ZONE)]
    cells += [found.runs, len(found.pairs) - failed, failed, f"{min(scans)} to {max(scans)}", late, f"{seconds:.1f}"]
    return "| " + " | ".join(map(str, cells)) + " |"


def main() -> int:
    """Carry out all runs and print the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tracks", type=int, default=TRACKS, help="tracks of the yard; 0 for none")
    args = parser.parse_args()
    print("# Availability\n")
    print(f"`python -m tests.campaigns.availability` {origin()}.")
    print(EXPLAINED)
    print(
        "| layout | profile | routes | hostile pairs | pairs tried | a train each | one for both | one at a time "
        "| zone | runs | shown | failed | scans | late | s |"
    )
    print("|" + "---|" * 15)
    refused, total, bad = [], 0, 0
    texts = [(p.stem, profile, under(p.read_text("utf-8"), profile)) for p in LAYOUTS for profile in PROFILES]
    if args.tracks:
        texts.append((f"yard of {args.tracks} tracks", "generic", yard(args.tracks)))
    for name, profile, text in texts:
        made = derived(text)
        if made is None:
            refused.append(f"{name} in {profile} ({refusal(text)})")
            continue
        began = time.process_time()
        found = availability(closed_loop(made[0], lower(*made)), made[1])
        print(row(name, profile, found, time.process_time() - began), flush=True)
        total += len(found.pairs)
        bad += sum(p.failure is not None for p in found.pairs)
    print(f"\n{total} pairs tried, {total - bad} shown, {bad} failed.")
    told = ", ".join(refused) or "none"
    print(f"Refused by `check` in a profile that is not theirs, with the code that says why: {told}.\n")
    print("## Weakenings\n\nEach must be found out by a pair that fails.\n")
    print("| weakening | layout | pairs that fail | the first of them |\n|---|---|---|---|")
    survived = 0
    for what, name, layout, table, controller in weakened():
        failed = [p for p in availability(closed_loop(layout, controller), table).pairs if p.failure is not None]
        survived += not failed
        first = f"{failed[0].first} and {failed[0].second}: {failed[0].failure}" if failed else "*survived*"
        print(f"| {what} | {name} | {len(failed)} | {first.replace('|', '/')} |", flush=True)
    return 1 if bad or survived else 0


if __name__ == "__main__":
    sys.exit(main())
