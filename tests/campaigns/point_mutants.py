"""Every point mutation of the shipped controllers: `python -m tests.campaigns.point_mutants -j 2 --kept FILE`.

And every equation that reads what belongs to the next element, or all of a kind a scan late.  In full on a few layouts;
on the others, and on a generated yard, the first of every form in every family.  Verdicts are kept in FILE, so that a
campaign goes on where it was broken off; `--shard 2/3` does the second third.  Once all verdicts are there
proofs/point_mutants.md is written.  It fails where a survivor is not on the published list
(`interlock/proof/mutation/survivors.yaml`), where a listed change survives nowhere, and where more than one mutant in
a hundred survives.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from interlock.app.init import yard
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.claims import CLAIMS
from interlock.proof.functions import FUNCTIONS
from interlock.proof.mutation.campaign import Campaign
from interlock.proof.mutation.judge import Fate, Verdict
from interlock.proof.mutation.points import Mutation
from interlock.proof.mutation.survivors import listed, off_the_list
from interlock.table.rows import InterlockingTable
from tests.campaigns.origin import origin
from tests.layouts import SHIPPED, built, grown

FULL = ("mine11", "junction", "passing_loop", "fig2_3_split", "crossing_line")
YARD = "a yard of 4 tracks"
TABLE = Path("proofs/point_mutants.md")
ORDER = (Fate.CLAIM, Fate.FUNCTION, Fate.TRAIN, Fate.OPERATOR, Fate.EQUIVALENT, Fate.REFUSED, Fate.SURVIVES)
HEAD = "| mutants | claim | function | train | operator | equivalent | no controller | survives |"
PARTS = {
    "wires": lambda family: " " not in family,
    "next values": lambda family: family.startswith("next ") and not _misread(family),
    "outputs": lambda family: family.startswith("output ") and not _misread(family),
    "what is read of the next element, or a scan late": lambda family: _misread(family),
    "timers, inputs and presets": lambda family: family.startswith("timer "),
    "initial values": lambda family: family.startswith("initial "),
}

Verdicts = list[tuple[Mutation, Verdict]]


def _misread(family: str) -> bool:
    return family.endswith((" elsewhere", "read late"))


@cache
def made(name: str) -> tuple[Layout, InterlockingTable, Controller]:
    """Layout, table and controller, by name."""
    if name != YARD:
        return built(name)
    found = grown(yard(4))
    assert found is not None
    return found[0], found[1], lower(found[0], found[1])


def _row(name: str, those: Verdicts) -> str:
    count = Counter(v.fate for _, v in those)
    return f"| {name} | {len(those)} | {' | '.join(str(count[f]) for f in ORDER)} |"


def table(found: dict[str, Verdicts]) -> Iterator[str]:
    """The report."""
    every = [x for those in found.values() for x in those]
    yield "# Point mutations\n"
    yield (
        f"`python -m tests.campaigns.point_mutants -j 2 --kept FILE` {origin()}.  Every "
        "equation, operand, output, timer and initial value is changed, one change at a time: true, false, negated, an "
        "operand dropped or negated however deep, exchanged with its neighbour; of timers the input and the preset; "
        "or an equation reads what belongs to the next element, "
        "and all read a kind of input a scan late (`interlock.proof.mutation.elsewhere`).  "
        f"In full on {', '.join(FULL)}; elsewhere the first of every form in every family.\n"
    )
    yield (
        "*Claim*: a claim is no longer proved.  *Function*: what a rule orders does not happen any more, or happens "
        "without its reason (`interlock.proof.functions`, below); a mutant that fails both counts where it was seen "
        "first.  *Train*: a route that a train could use cannot be set, driven and released any more.  *Operator*: "
        "what an operator may do with a route does not work any more (`interlock.proof.witnesses.operations`).  "
        "*Equivalent*: a "
        "solver has shown that all outputs are the same in every run from power-up on.  *No controller*: it reads a "
        "value before it is computed.  *Survives*: none of these.\n"
    )
    yield f"| layout {HEAD}\n|---|---|---|---|---|---|---|---|---|"
    yield from (_row(name, those) for name, those in found.items())
    yield _row("all", every)
    yield "\n## By what is changed\n"
    yield f"| part {HEAD}\n|---|---|---|---|---|---|---|---|---|"
    for part, belongs in PARTS.items():
        yield _row(part, [(m, v) for m, v in every if belongs(m.family)])
    yield f"\n| family {HEAD}\n|---|---|---|---|---|---|---|---|---|"
    for family in sorted({m.family for m, _ in every}):
        yield _row(family, [(m, v) for m, v in every if m.family == family])
    yield "\n## What fails (the first that was found)\n"
    yield "| claim or function | mutants | in words |\n|---|---|---|"
    killed = Counter(v.why.split(" at ")[0] for _, v in every if v.fate in (Fate.CLAIM, Fate.FUNCTION))
    words = CLAIMS | FUNCTIONS
    for what, n in killed.most_common():
        yield f"| {what} | {n} | {words.get(what, '')} |"
    left = Counter(m.shape for m, v in every if v.fate is Fate.SURVIVES)
    yield "\n## Survivors\n"
    part = 100 * left.total() / len(every)
    yield (
        f"{left.total()} of {len(every)} ({part:.2f} %), alike but for the names of elements.  With each of them a "
        "solver has shown every claim and every function by induction, and that in every step after the restart delay, "
        "from one state, outputs and next states are the same as the controller's.\n"
    )
    yield "| change | mutants | why nobody needs to notice it |\n|---|---|---|"
    for change, n in left.most_common():
        yield f"| {change.replace('|', '/')} | {n} | {listed().get(change, 'NOT ON THE LIST')} |"


def main() -> int:
    """Judge what is not judged yet, then write the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("layouts", nargs="*", default=[*FULL, *(n for n in SHIPPED if n not in FULL), YARD])
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--kept", type=Path, required=True)
    parser.add_argument("--shard", default="1/1")
    args = parser.parse_args()
    part, of = map(int, args.shard.split("/"))

    def report(done: int, pieces: int) -> None:
        print(f"\r{done} of {pieces} pieces", end="", file=sys.stderr, flush=True)

    campaign = Campaign(made, {name: name in FULL for name in args.layouts})
    judged = campaign.run(args.kept, args.jobs, (part, of), report)
    print(file=sys.stderr)
    found = {name: [(m, v) for m, v in those if v is not None] for name, those in judged.items()}
    every = [x for those in found.values() for x in those]
    print(", ".join(f"{f.value} {n}" for f, n in Counter(v.fate for _, v in every).most_common()))
    wrong = [f"survives, and is not on the list: {name}" for name in off_the_list(every)]
    missing = [name for name, those in judged.items() if len(found[name]) < len(those)]
    if missing or set(args.layouts) != {*SHIPPED, YARD}:
        print(f"no table: {'verdicts are missing of ' + ', '.join(missing) if missing else 'not all layouts'}")
    else:
        alive = {m.shape for m, v in every if v.fate is Fate.SURVIVES}
        points = [change for change in listed() if not change.startswith("weakened: ")]
        wrong += [f"is on the list, and survives nowhere: {change}" for change in points if change not in alive]
        count = sum(v.fate is Fate.SURVIVES for _, v in every)
        if 100 * count > len(every):
            wrong.append(f"{count} of {len(every)} survive: more than one in a hundred")
        TABLE.write_text("\n".join(table(found)) + "\n", encoding="utf-8")
    print("\n".join(wrong), end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
