"""Every point mutation of the shipped controllers: `python -m tests.campaigns.point_mutants -j 2 --kept FILE`.

In full on a few layouts; on the others the first of every form in every family.  Verdicts are kept in FILE, one a line,
by a digest of all that is said of the system: a campaign goes on where it was broken off, and asks again only what has
changed.  `--shard 2/3` does the second third.  Writes proofs/point_mutants.md once all verdicts are there.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import platform
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

from interlock.app.init import yard
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.mutation.judge import Fate, Verdict, judged
from interlock.proof.mutation.lines import Lines
from interlock.proof.mutation.points import Mutation, mutations
from interlock.proof.system import System
from tests.layouts import SHIPPED, built, grown

FULL = ("mine11", "junction", "passing_loop", "fig2_3_split", "crossing_line")
YARD = "a yard of 4 tracks"
TABLE = Path("proofs/point_mutants.md")
HEAD = "| claim | train | operator | equivalent | no controller | survives |\n|---|---|---|---|---|---|---|---|"
PIECE = 400  # mutants judged by one task


@cache
def made(name: str) -> tuple[Layout, Controller]:
    """Layout and controller, by name."""
    if name != YARD:
        layout, _, controller = built(name)
        return layout, controller
    found = grown(yard(4))
    assert found is not None
    return found[0], lower(found[0], found[1])


@cache
def chosen(name: str) -> tuple[Mutation, ...]:
    """The mutations that are judged on a layout."""
    every = tuple(mutations(made(name)[1]))
    if name in FULL:
        return every
    first: dict[tuple[str, str], Mutation] = {}
    for m in every:
        first.setdefault((m.family, m.form), m)
    return tuple(first.values())


def digest(name: str) -> str:
    """Of all that is said of a system."""
    return hashlib.sha256(repr(Lines.of(System(*made(name)))).encode()).hexdigest()[:16]


def piece(name: str, numbers: list[int]) -> list[Verdict]:
    """Some verdicts."""
    return judged(*made(name), [chosen(name)[n] for n in numbers])


def shape(name: str) -> str:
    """A mutation without the names of elements: what many mutants have in common."""
    return re.sub(r"\b([A-Z]+)[0-9]*_[A-Za-z0-9_.]+", r"\1", re.sub(r"= [0-9]+", "= n", name))


def read(path: Path) -> dict[tuple[str, str], Verdict]:
    """The verdicts that are kept."""
    lines = path.read_text("utf-8").splitlines() if path.exists() else ()
    rows = (json.loads(x) for x in lines)
    return {(r["of"], r["mutation"]): Verdict(Fate(r["fate"]), r["why"]) for r in rows}


def table(found: dict[str, list[tuple[Mutation, Verdict]]], least: int) -> Iterator[str]:
    """The report; shapes with fewer survivors than `least` are counted together."""
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=False)
    yield "# Point mutations\n"
    yield (
        f"`python -m tests.campaigns.point_mutants` at commit {commit.stdout.strip()}, {platform.machine()}.  Every "
        "equation, operand, output, timer and initial value is changed, one change at a time: true, false, negated, an "
        "operand dropped or negated however deep, exchanged with its neighbour; of timers the input and the preset.  "
        f"In full on {', '.join(FULL)}; elsewhere the first of every form in every family.\n"
    )
    yield (
        "*Claim*: a claim is no longer proved.  *Train*: a route that a train could use cannot be set, driven and "
        "released any more.  *Operator*: a route cannot be refused, cancelled, opened again, or given back by hand as "
        "the rules promise (`interlock.proof.operations`).  *Equivalent*: a solver has shown that next states and "
        "outputs are the same in all states that the invariants allow.  *No controller*: it reads a value before it "
        "is computed.  *Survives*: none of these: what was changed is asked of the controller by no claim and no run.\n"
    )
    yield f"| layout | mutants {HEAD}"
    order = (Fate.CLAIM, Fate.TRAIN, Fate.OPERATOR, Fate.EQUIVALENT, Fate.REFUSED, Fate.SURVIVES)
    every = [x for those in found.values() for x in those]
    for name, those in [*found.items(), ("all", every)]:
        count = Counter(v.fate for _, v in those)
        yield f"| {name} | {len(those)} | {' | '.join(str(count[f]) for f in order)} |"
    yield "\n## By what is changed\n"
    yield f"| family | mutants {HEAD}"
    families: dict[str, Counter[Fate]] = {}
    for m, v in every:
        families.setdefault(m.family, Counter())[v.fate] += 1
    for f, count in sorted(families.items()):
        yield f"| {f} | {count.total()} | {' | '.join(str(count[x]) for x in order)} |"
    yield "\n## Claims that fail (the first that was found)\n"
    killed = Counter(v.why.split(" at ")[0] for _, v in every if v.fate is Fate.CLAIM)
    yield ", ".join(f"{c} {n}" for c, n in killed.most_common())
    yield "\n## Survivors\n"
    yield f"Alike but for the names of elements; shapes with fewer than {least} are counted together.\n"
    yield "| change | survivors |\n|---|---|"
    left = Counter(shape(m.name) for m, v in every if v.fate is Fate.SURVIVES)
    for words, n in left.most_common():
        if n >= least:
            yield f"| {words.replace('|', '/')} | {n} |"
    few = [n for n in left.values() if n < least]
    yield f"| {len(few)} other shapes | {sum(few)} |"


def main() -> int:
    """Judge what is not judged yet, then write the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("layouts", nargs="*", default=[*SHIPPED, YARD])
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--kept", type=Path, required=True)
    parser.add_argument("--shard", default="1/1")
    parser.add_argument("--least", type=int, default=10)
    args = parser.parse_args()
    part, of = map(int, args.shard.split("/"))
    kept = read(args.kept)
    digests = {name: digest(name) for name in args.layouts}
    tasks: list[tuple[str, list[int]]] = []
    for name in args.layouts:
        todo = [n for n, m in enumerate(chosen(name)) if (digests[name], m.name) not in kept]
        tasks += [(name, todo[k : k + PIECE]) for k in range(0, len(todo), PIECE)]
    tasks = tasks[part - 1 :: of]
    with ProcessPoolExecutor(args.jobs) as pool, args.kept.open("a", encoding="utf-8") as out:
        running = [(name, numbers, pool.submit(piece, name, numbers)) for name, numbers in tasks]
        for done, (name, numbers, answer) in enumerate(running, 1):
            for n, v in zip(numbers, answer.result(), strict=True):
                m = chosen(name)[n]
                kept[digests[name], m.name] = v
                row = {"of": digests[name], "mutation": m.name, "fate": v.fate.value, "why": v.why}
                out.write(json.dumps(row) + "\n")
            out.flush()
            print(f"\r{done} of {len(running)} pieces", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    missing = [name for name in args.layouts if any((digests[name], m.name) not in kept for m in chosen(name))]
    if missing or set(args.layouts) != {*SHIPPED, YARD}:
        print(f"no table: {'verdicts are missing of ' + ', '.join(missing) if missing else 'not all layouts'}")
        return 0
    found = {name: [(m, kept[digests[name], m.name]) for m in chosen(name)] for name in args.layouts}
    TABLE.write_text("\n".join(table(found, args.least)) + "\n", encoding="utf-8")
    count = Counter(v.fate for those in found.values() for _, v in those)
    print(", ".join(f"{f.value} {n}" for f, n in count.most_common()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
