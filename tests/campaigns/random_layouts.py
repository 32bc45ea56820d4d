"""Random layouts in a long run: derivation against audit; and the first of them with every claim and the emitted text
(`--prove`), with a certificate that the second checker verifies (`--verify`), with every pair of routes that are not
hostile driven (`--drive`).

python -m tests.campaigns.random_layouts --count 2000 --prove 250 --verify 250 --drive 500 > proofs/random_layouts.md
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from interlock.app.certify import certify_file
from interlock.app.compile import compile_file
from interlock.audit import audit
from interlock.checker.check import agree, check
from interlock.checker.specification import shipped
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.engines.limits import Limits
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.loop import closed_loop
from interlock.proof.system.transition import System
from interlock.proof.witnesses.availability import Manner, availability
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from interlock.table.rows import InterlockingTable
from tests.campaigns.origin import origin
from tests.grow_all import grow_all, words
from tests.layouts import grown
from tests.written import told

EXPLAINED = """
Layouts with every kind of element (`tests/grow_all.py`): points, diamonds, single and double slips, with one machine or
two, derailers, traps, hand-worked points, level crossings and other interlocks, air locks, sidings without
detection, tracks joined end to end; main, shunt and combined signals, call-on, stop boards, limit-of-shunt boards,
shunt signals at which
trains end, signals that are passed at identifier light, signals that close behind the first axle or the whole movement;
overlaps of several lengths and entry
speeds, successive, swinging; flank space, zones, conditions, detectors that report faults, blocks and direction tokens,
speeds, single directions; what the author adds, has held longer, excludes, waives and
names; substations and their health; four profiles
with knobs of their own, names of several scripts.

*Waivers found out*: of a flank from which something can roll after all; T-FLANK and S-FLANK are refuted there and
nowhere else, which is what a waiver without a good reason comes to.  *Undrivable* routes are those for which the
witness run fails, mostly since the author has the route demand points otherwise that lie under its train; `compile`
reports them as IL4006 (routes that their own train is in the way of, and those to whose signal no train comes, are
refused by `check`, IL4016 and IL4018).  A layout with
one, or with a waiver found out, has no certificate: of these the second checker compares layout, text and written
system, and no refutation.  Undrivable routes are left out of the pairs that are driven.
*Apart*: the train of one route, standing before its signal, keeps
the other one from being set: it stands foul of it, across a diamond, or on points that one machine works with points of
the other (such a request is refused as well while the first route is not set); or on its way there it has left points
otherwise that the other one needs, in a section that it locks; or one train cannot come past the other, or both begin
in one place, which is told from the track alone.  These pairs are set and open together, and driven as
far as that train permits; that its lock is needed is not shown.
"""

FLANKS = {"T-FLANK", "S-FLANK"}


@dataclass
class Tally:
    """What was seen."""

    counts: Counter[str] = field(default_factory=Counter)
    words: Counter[str] = field(default_factory=Counter)
    bad: list[str] = field(default_factory=list)
    driven: list[str] = field(default_factory=list)
    """Pairs of routes, or routes, that a run did not show as it should."""


@dataclass(frozen=True)
class Case:
    """One layout that `check` accepts."""

    seed: int
    text: str
    layout: Layout
    table: InterlockingTable

    @property
    def controller(self) -> Controller:
        return lower(self.layout, self.table)


def valid(seed: int) -> Iterator[tuple[int, Case | None]]:
    """Every seed from one on, and the layout that grows from it where `check` accepts it."""
    while True:
        text = grow_all(seed)
        made = grown(text)
        yield seed, None if made is None or made[2].has_errors else Case(seed, text, made[0], made[1])
        seed += 1


def proved(x: Case, t: Tally) -> None:
    """Every claim, no invariant lost, and the text equal to the controller."""
    controller = x.controller
    result = prove(System(x.layout, controller), Limits(search_s=120))
    waived = {f"{w.point}.{w.leg}" for w in x.layout.declared.waivers}
    for c in result.claims:
        if c.verdict is Verdict.PROVED:
            continue
        legs = {p.split(":")[2].split(" ")[0] for p in c.open if c.id in FLANKS}
        if c.verdict is Verdict.REFUTED and legs and legs <= waived:
            t.counts["found out"] += c.id == "T-FLANK"
        else:
            t.bad.append(f"seed {x.seed}: {c.id} {c.verdict} at {', '.join(c.open[:3])}")
    if result.dropped:
        t.bad.append(f"seed {x.seed}: {len(result.dropped)} invariants dropped")
    if not compare_dialect(controller, BY_NAME["iec"], write_st(controller, BY_NAME["iec"], [])).proved:
        t.bad.append(f"seed {x.seed}: another text")
    t.counts["proved"] += 1
    t.counts["undrivable"] += sum(not w.ok for w in result.witnesses)


def verified(x: Case, t: Tally) -> None:
    """A certificate, and the second checker on layout, text and certificate; where there is none, on what it would be
    of."""
    with tempfile.TemporaryDirectory() as folder:
        top, path = Path(folder), Path(folder) / "grown.yaml"
        path.write_text(x.text, "utf-8")
        done = compile_file(str(path), top / "generated")
        made = done.green and certify_file(str(path), top / "generated", top / "proofs").ok
        try:
            left = check(path, top / "proofs" / "grown").left if made else agree(*told(x.text), shipped()).left
        except Exception as e:
            left = (f"{type(e).__name__}: {e}",)
    told.cache_clear()
    t.counts["verified" if made else "compared"] += not left
    t.bad += [f"seed {x.seed}: {y}" for y in left]


def driven(x: Case, t: Tally) -> None:
    """Every two routes that are not hostile, used together."""
    found = availability(closed_loop(x.layout, x.controller), x.table)
    pairs = [p for p in found.pairs if p.manner is not Manner.NONE]
    t.counts["driven"] += 1
    t.counts["pairs"] += len(pairs)
    t.counts["runs"] += sum(p.runs for p in pairs)
    failed = [p for p in pairs if p.failure is not None]
    t.counts["pairs failed"] += len(failed)
    t.counts["pairs apart"] += sum(p.apart is not None for p in pairs)
    t.driven += [f"seed {x.seed}: {p.first} and {p.second}, {p.manner.value}: {p.failure}" for p in failed]


def count(wanted: dict[str, int], much: int, first: int) -> tuple[Tally, int]:
    """The campaign over so many layouts; of the first of them so many further things."""
    t, grew, told_of = Tally(), 0, 0
    does: dict[str, Any] = {"prove": proved, "verify": verified, "drive": driven}
    for seed, x in valid(first):
        grew = seed + 1 - first
        if x is None:
            continue
        t.counts["layouts"] += 1
        t.counts["routes"] += len(x.table.routes)
        t.words.update(words(x.text))
        t.bad += [f"seed {seed}: {f}" for f in audit(x.layout, x.table)]
        for what, do in does.items():
            if t.counts["layouts"] <= wanted[what]:
                do(x, t)
        for found in t.bad[told_of:]:
            print(found, file=sys.stderr, flush=True)
        told_of = len(t.bad)
        if t.counts["layouts"] == much:
            return t, grew
    return t, grew


def main() -> int:
    """Run the campaign and print its page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=2000, help="valid layouts whose audit is compared")
    parser.add_argument("--prove", type=int, default=0, help="how many of them to prove, with their text")
    parser.add_argument("--verify", type=int, default=0, help="how many of them to certify, and to verify")
    parser.add_argument("--first", type=int, default=0, help="the seed of the first layout")
    parser.add_argument("--drive", type=int, default=0, help="how many of them to drive in pairs of routes")
    args = parser.parse_args()
    began = time.process_time()
    t, grew = count({k: getattr(args, k) for k in ("prove", "verify", "drive")}, args.count, args.first)
    n = t.counts
    print("# Random layouts\n")
    print(f"`python -m tests.campaigns.random_layouts {' '.join(sys.argv[1:])}`")
    print(f"{origin()}, one of them used.")
    print(EXPLAINED)
    rows = {
        "derivation against the second opinion": f"{n['layouts']} layouts ({grew} grown), {n['routes']} routes",
        "proved with their text": f"{n['proved']} layouts, in them {n['undrivable']} undrivable routes, "
        f"{n['found out']} waivers found out",
        "certified, and VERIFIED by the second checker": f"{n['verified']} layouts",
        "compared by the second checker, without a certificate": f"{n['compared']} layouts",
        "driven in pairs of routes": f"{n['driven']} layouts, {n['pairs']} pairs, {n['runs']} runs, "
        f"{n['pairs failed']} pairs failed",
        "of these pairs apart": f"{n['pairs apart']}",
        "disagreements": f"{len(t.bad)}",
        "processor time": f"{time.process_time() - began:.0f} s",
    }
    print("| | |\n|---|---|")
    print(*(f"| {what} | {found} |" for what, found in rows.items()), sep="\n")
    print("\nHow many of the layouts have what this growth brought in:\n\n| element | layouts |\n|---|---|")
    print(*(f"| {w} | {k} |" for w, k in sorted(t.words.items())), sep="\n")
    print(*(f"\n- {x}" for x in t.bad[:50]), sep="")
    if t.driven:
        said = "a request is refused, or a signal late, and not because of where a train stands:"
        print(f"\nThe first pairs of routes that failed in their runs: {said}")
        print(*(f"\n- {x}" for x in t.driven[:40]), sep="")
    return 1 if t.bad else 0


if __name__ == "__main__":
    sys.exit(main())
