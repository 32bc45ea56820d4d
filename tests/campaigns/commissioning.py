"""What tests for commissioning notice, and what only the proof does: `python -m tests.campaigns.commissioning --write`.

Every weakening of controllers (`proof/mutation`) is tried by the book of tests that the right table makes.  A weakening
that the proof kills and no test notices is why one proves: a test looks at one route from rest, a proof at everything.
"""

from __future__ import annotations

import argparse
from collections import Counter
from pathlib import Path

from interlock.app.check import check_file
from interlock.commissioning.book import book
from interlock.emit.python.runtime import runtime_py
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.mutation.weakenings import KINDS
from interlock.table.rows import InterlockingTable
from tests.campaigns.mutants import LAYOUTS, MORE
from tests.campaigns.origin import origin

PAGE = Path(__file__).resolve().parent.parent.parent / "proofs/commissioning.md"


def noticed(layout: Layout, table: InterlockingTable, controller: Controller) -> str:
    """The first test of the book that comes out otherwise with this controller; empty if none does."""
    right = lower(layout, table)
    steps = book(layout, table, right, allocate(layout, right), runtime_py(controller, []))
    return next((f"{s.number} {s.do}: {s.came}" for s in steps if s.came), "")


def run(sample: int, show: bool) -> dict[str, Counter[bool]]:
    """By kind: how many weakenings are noticed, and how many are not."""
    found: dict[str, Counter[bool]] = {k.name: Counter() for k in KINDS}
    jobs = [(path, [k.name for k in KINDS]) for path in LAYOUTS] + [(p, list(ks)) for p, ks in MORE.items()]
    for path, kinds in jobs:
        checked = check_file(path)
        assert checked.layout is not None and checked.table is not None
        for kind in (k for k in KINDS if k.name in kinds):
            mutants = list(kind.make(checked.layout, checked.table))
            for place, controller in mutants[:: max(1, -(-len(mutants) // sample))]:
                first = noticed(checked.layout, checked.table, controller)
                found[kind.name][bool(first)] += 1
                if show:
                    print(f"{Path(path).stem} {kind.name} {place}: {first or 'NOT NOTICED'}", flush=True)
    return found


def main() -> None:
    """Run the campaign, and print or write its page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sample", type=int, default=1, help="weakenings of each kind on each layout")
    parser.add_argument("--show", action="store_true")
    parser.add_argument("--write", action="store_true", help=f"write {PAGE.name}")
    args = parser.parse_args()
    found = run(args.sample, args.show)
    seen, all_ = sum(c[True] for c in found.values()), sum(c.total() for c in found.values())
    lines = [
        "# What tests for commissioning notice",
        "",
        f"`python -m tests.campaigns.commissioning --sample {args.sample} --write`, {origin()}.",
        "",
        "The weakenings of [mutants.md](mutants.md), each tried by the book of tests (`interlock commission`) that the",
        f"right table makes.  Of {all_} the tests notice {seen}.  The proof kills every one that is not redundant: a",
        "test tries one route from rest, a proof everything that can happen.",
        "",
        "| weakening | what it does | noticed | not |",
        "|---|---|---|---|",
        *(f"| {k.name} | {k.text} | {found[k.name][True]} | {found[k.name][False]} |" for k in KINDS),
    ]
    text = "\n".join(lines) + "\n"
    if args.write:
        PAGE.write_text(text, "utf-8")
    else:
        print(text)


if __name__ == "__main__":
    main()
