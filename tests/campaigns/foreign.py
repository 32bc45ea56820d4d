"""The emitted Structured Text with its mapping program under foreign compilers, against the emitted Python runtime.

python -m tests.campaigns.foreign --matiec FOLDER --strucpp FOLDER [--xsd FILE] [--scans N] [--seed N] [LAYOUT ...]

FOLDER: the repository sm1820/matiec or Autonomy-Logic/STruCpp of GitHub, built by yourself as it tells; gcc and g++
build what they make.  FILE: plcopen/tc6_xml_v201.xsd of beremiz/beremiz, the schema for the PLCopen files.  Without
layouts: all of layouts/ and a yard of 37 tracks (`interlock init --yard 37`).

Each layout is proved, and what is then written is compiled.  Its trains run on the runtime in its cabinet, with stalled
cycles, lost heartbeats and power cuts; then come inputs at random.  Inputs and outputs of every scan are laid down as
they stand on the wires, and each compiled program has to answer the same inputs with the same outputs (see
tests/foreign).  The C runtime is compiled by gcc and driven for a quarter of the scans.  A recording with too few
movements of trains, or without a power cut, goes on with other trains.  Then faults are planted in one layout, which
must be noticed.  Writes proofs/foreign.md.  Exit code 1: a difference, a text that is refused, a file against the
schema, a fault that is not noticed, a layout with too few movements or without a power cut; 2: a compiler that does not
pass the probe, or one given as --unfit (such as beremiz/matiec since 2024) that does.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from interlock.app.check import derive_file
from interlock.app.init import yard
from interlock.emit.c99.runtime import runtime_c
from interlock.logic.lower import lower
from interlock.proof.equivalence.c_text import compare_c
from tests.c_driver import answers as c_answers
from tests.c_driver import built_by_gcc, driven
from tests.campaigns.origin import processor
from tests.foreign.bundle import Bundle, bundle
from tests.foreign.compilers import UNOPTIMIZED, Compiler, Matiec, Refused, StrucPp, answers
from tests.foreign.planted import TEXTS, early_timer
from tests.foreign.probe import unfit
from tests.foreign.recording import Railway, Recording, record, scramble
from tests.foreign.wiring import Segment, Wiring, changed, differences, digest

MOVEMENTS = 20
"""A recording goes on until there were so many; one that has fewer in the end is told as bad."""
POWER_CUTS = 1
"""The same."""
IN_C = 5
"""The same of the C runtime's."""


@dataclass(frozen=True)
class Verdict:
    """What a compiled program did: the number of scans that differ and the first of them, or why there is none."""

    differing: int
    first: str = ""

    @property
    def equal(self) -> bool:
        """It ran, and no scan differs."""
        return not self.differing and not self.first


@dataclass(frozen=True)
class Row:
    """A layout's line of the table."""

    name: str
    routes: int
    told: tuple[int, ...]
    outputs: str
    compared: int
    digest: str
    verdicts: tuple[Verdict, ...]
    schema: tuple[tuple[str, str], ...]


def compiled(compiler: Compiler, source: str, wiring: Wiring, segments: Sequence[Segment]) -> Verdict:
    """Build a text's program, let it answer, compare."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            program = compiler.build(source, wiring, Path(folder))
            found = differences(wiring, segments, answers(program, segments))
        except Refused as error:
            return Verdict(0, str(error))
    return Verdict(len(found), str(found[0]) if found else "")


def against_schema(xsd: str, text: str) -> str:
    """Why a PLCopen file does not fit the schema of TC6 2.01; nothing when it does.

    The file for CODESYS says version 2.00, whose elements are those of 2.01: it is read with the other's name space.
    """
    from lxml import etree

    schema = etree.XMLSchema(etree.parse(xsd))
    tree = etree.fromstring(
        text.replace("http://www.plcopen.org/xml/tc6_0200", "http://www.plcopen.org/xml/tc6_0201").encode()
    )
    return "" if schema.validate(tree) else str(schema.error_log.last_error)


def recordings(railway: Railway, scans: int, seed: int) -> tuple[Recording, Recording]:
    """With trains, and a quarter of the scans more with inputs at random."""
    return record(railway, scans, seed, movements=MOVEMENTS, power_cuts=POWER_CUTS), scramble(railway, scans // 4, seed)


def _row(path: str, compilers: Sequence[Compiler], xsd: str, scans: int, seed: int) -> Row:
    made = bundle(path)
    trains, random = recordings(made.railway, scans, seed)
    r = trains
    told = (r.scans, r.trains, r.movements, random.scans, r.stalls + random.stalls, r.power_cuts)
    wiring, segments = r.wiring, (*r.segments, *random.segments)
    outputs = f"{changed(wiring, segments)} of {wiring.outputs}"
    verdicts = tuple(compiled(c, made.source, wiring, segments) for c in compilers)
    schema = tuple((name, against_schema(xsd, text)) for name, text in made.xml.items()) if xsd else ()
    print(f"{made.name}: {told}, {outputs}:", *map(_told, verdicts), flush=True)
    compared = (r.scans + random.scans) * wiring.outputs
    return Row(made.name, made.routes, told, outputs, compared, digest(segments), verdicts, schema)


@dataclass(frozen=True)
class CRow:
    """A layout's line of the table of the C runtime."""

    name: str
    told: tuple[int, ...]
    verdict: Verdict


def c_row(path: str, scans: int, seed: int) -> CRow:
    """The C runtime, proved and compiled by gcc without a warning, against the Python runtime: so many scans with
    trains, as many with inputs at random; outputs, state and the words of routes."""
    derived = derive_file(path)
    layout, table = derived.layout, derived.table
    assert layout is not None and table is not None
    controller = lower(layout, table)
    pair, movements = driven(layout, table, controller, scans, seed, IN_C)
    told = (pair.scans - scans, movements, scans, pair.stalls, pair.restarts)
    files = runtime_c(controller, [])
    with tempfile.TemporaryDirectory() as folder:
        try:
            if not compare_c(controller, files).proved:
                raise Refused("not proved")
            answer = c_answers(built_by_gcc(controller, files, Path(folder)), bytes(pair.given))
        except (Refused, subprocess.SubprocessError) as error:
            return CRow(Path(path).stem, told, Verdict(0, str(error)))
    size = len(pair.told) // pair.scans
    parts = (slice(k * size, (k + 1) * size) for k in range(pair.scans))
    wrong = [k for k, part in enumerate(parts) if answer[part] != pair.told[part]]
    first = f"scan {wrong[0] + 1}" if wrong else ("" if answer == pair.told else "another number of answers")
    row = CRow(Path(path).stem, told, Verdict(len(wrong), first))
    print(f"{row.name}, C runtime: {told}: {_told(row.verdict)}", flush=True)
    return row


def plant(made: Bundle, compilers: Sequence[Compiler], scans: int, seed: int) -> list[tuple[str, tuple[Verdict, ...]]]:
    """Each planted fault and what the comparison says of it, by compiler."""
    other = replace(made.railway, runtime=early_timer(made.railway.runtime))
    early = "a timer of the runtime counts in the scan in which its input rises"
    cases = [(early, made.source, other), *((what, edit(made.source), made.railway) for what, edit in TEXTS.items())]
    found = []
    made_of = {r.runtime: recordings(r, scans, seed) for r in (made.railway, other)}
    for what, source, railway in cases:
        both = made_of[railway.runtime]
        segments = [s for r in both for s in r.segments]
        found.append((what, tuple(compiled(c, source, both[0].wiring, segments) for c in compilers)))
    return found


def _told(v: Verdict) -> str:
    if v.differing:
        return f"{v.differing}: {v.first}"
    return "0" if v.equal else f"REFUSED: {v.first.splitlines()[0]}"


def _table(rows: Sequence[Row], compilers: Sequence[Compiler]) -> list[str]:
    names = [f"{c.name}: scans that differ" for c in compilers]
    head = ["layout", "routes", "scans with trains", "trains", "movements", "scans at random", "stalls", "power cuts"]
    head += ["outputs that changed", "outputs compared", *names, "SHA-256 of the trace"]
    lines = [f"| {' | '.join(head)} |", f"|---|{'---:|' * (len(head) - 2)}---|"]
    for r in rows:
        cells = [r.name, r.routes, *r.told, r.outputs, r.compared, *map(_told, r.verdicts), f"`{r.digest}`"]
        lines.append(f"| {' | '.join(map(str, cells))} |")
    sums = [sum(r.told[k] for r in rows) for k in range(6)]
    differing = [sum(r.verdicts[k].differing for r in rows) for k in range(len(compilers))]
    cells = ["all", sum(r.routes for r in rows), *sums, "", sum(r.compared for r in rows), *differing, ""]
    return [*lines, f"| {' | '.join(map(str, cells))} |", ""]


def _c_table(rows: Sequence[CRow]) -> list[str]:
    lines = [
        "The C runtime (`--dialect c99`), proved, and compiled by gcc -O1 without a warning, against the Python "
        "runtime: outputs,\nstate and words of routes in every scan, without wires, as there is no mapping program in "
        "C.  Where there were\nfewer than 5 movements the railway is begun anew, without power cuts.  Faults in it are "
        "noticed:\n`pytest --external tests/test_c99.py`.",
        "",
        "| layout | scans with trains | movements | scans at random | stalls | power-ons | scans that differ |",
        f"|---|{'---:|' * 6}",
    ]
    return [*lines, *(f"| {r.name} | {' | '.join(map(str, r.told))} | {_told(r.verdict)} |" for r in rows), ""]


def _schema(rows: Sequence[Row]) -> list[str]:
    files = [(r.name, name, why) for r in rows for name, why in r.schema]
    fit = sum(not why for *_, why in files)
    lines = [
        f"{fit} of {len(files)} PLCopen files fit the schema of TC6 2.01.  Those for CODESYS say version 2.00; they "
        "are read under\nthe name space of 2.01, whose elements they use.",
        "",
    ]
    lines += ["| layout | file | against the schema |", "|---|---|---|"]
    return [*lines, *(f"| {n} | {f} | {w or 'fits'} |" for n, f, w in files), ""]


def still(rows: Sequence[Row], in_c: Sequence[CRow]) -> list[str]:
    """The layouts in which too little happened for the comparison to say much, with what did."""
    found = [f"{r.name} ({r.told[2]})" for r in rows if r.told[2] < MOVEMENTS]
    found += [f"{r.name} ({r.told[5]} power cuts)" for r in rows if r.told[5] < POWER_CUTS]
    return [*found, *(f"{r.name} in C ({r.told[1]})" for r in in_c if r.told[1] < IN_C)]


def _first_line(*command: str) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0]


@dataclass(frozen=True)
class Probed:
    """A compiler, why it is not fit (nothing: it passed), and whether it must not be."""

    compiler: Compiler
    why: str
    wrong: bool = False


def _passed(p: Probed) -> str:
    return f"fails, as it must, so nothing of it would count: {p.why}" if p.why else "passed"


def _probes(compilers: Sequence[Compiler], wrong: Path | None) -> list[Probed]:
    found = [Probed(c, unfit(c)) for c in compilers]
    if wrong is not None:
        found.append(Probed(Matiec(wrong.resolve()), unfit(Matiec(wrong.resolve())), True))
    for p in found:
        if p.why and not p.wrong:
            print(f"{p.compiler.name} at {p.compiler.commit} does not pass the probe, nothing of it counts: {p.why}")
        elif p.wrong and not p.why:
            print(f"{p.compiler.name} at {p.compiler.commit} passes the probe, but must not")
    return found


def _tools(probes: Sequence[Probed], scans: int, seed: int) -> list[str]:
    commit = _first_line("git", "rev-parse", "--short", "HEAD")
    lines = [
        f"At commit {commit}, `--scans {scans} --seed {seed}`; {processor()}, {os.cpu_count()} cores; "
        f"{_first_line('gcc', '--version')}, {UNOPTIMIZED}; Python {platform.python_version()}.",
        "",
        "| compiler | commit | probe: `FOR K := N TO N` runs once, TON, wires |",
        "|---|---|---|",
    ]
    return [
        *lines,
        *(f"| {p.compiler.name} | {p.compiler.commit} | {_passed(p)} |" for p in probes),
        "",
    ]


def _planted(
    made: Bundle, found: Sequence[tuple[str, tuple[Verdict, ...]]], compilers: Sequence[Compiler]
) -> list[str]:
    lines = [f"Planted on purpose in {made.name}; each must be noticed:", ""]
    lines += [f"| fault | {' | '.join(f'{c.name}: scans that differ, the first' for c in compilers)} |"]
    lines += [f"|---|{'---|' * len(compilers)}"]
    return [*lines, *(f"| {what} | {' | '.join(map(_told, verdicts))} |" for what, verdicts in found), ""]


INTRODUCTION = """\
# Foreign compilers

`python -m tests.campaigns.foreign`: the Structured Text of each layout with its mapping program, as `interlock
compile` writes it, compiled by compilers that are not ours, against the emitted Python runtime in its cabinet.  Both
get the same inputs in each scan: the bits of %I, what the operator's place writes, and the time since the scan before;
compared are the bits of %Q, what the operator's place reads, and the word of each route, in every scan.  Trains run in
metres on the runtime (`interlock/simulate`), with a random and a hostile operator; cycles are stalled up to four times
the bound, exactly the bound and a millisecond more; heartbeats stand still; power is cut, and the PLC's clock then says
something else.  Then come scans with inputs at random, as no railway gives them.

A *movement* is a signal passed at proceed, a *stall* a cycle longer than the bound; *outputs that changed* have been
seen with both values.  Where there were fewer than 20 movements, or no power cut, the railway is begun anew with other
trains, so some layouts have several times the scans.  Point telegrams are compiled, not driven.
"""


def _beside(given: Sequence[str], folder: str) -> list[str]:
    if given:
        return list(given)
    path = Path(folder) / "yard37.yaml"
    path.write_text(yard(37), encoding="utf-8")
    return [*sorted(map(str, Path("layouts").glob("*.yaml"))), str(path)]


def main() -> int:
    """Run the campaign."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layouts", nargs="*", metavar="LAYOUT")
    parser.add_argument("--matiec", type=Path)
    parser.add_argument("--strucpp", type=Path)
    parser.add_argument("--unfit", type=Path, help="a MATIEC that must not pass the probe")
    parser.add_argument("--xsd", default="")
    parser.add_argument("--scans", type=int, default=24_000, help="for each layout; more where little moves")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--planted", default="layouts/mine11.yaml", help="the layout in which faults are planted")
    parser.add_argument("-j", "--jobs", type=int, default=1)
    parser.add_argument("--out", default="proofs/foreign.md")
    args = parser.parse_args()
    began = time.time()
    compilers: list[Compiler] = [Matiec(args.matiec.resolve())] if args.matiec else []
    compilers += [StrucPp(args.strucpp.resolve())] if args.strucpp else []
    if not compilers:
        parser.error("give --matiec or --strucpp")
    try:
        probes = _probes(compilers, args.unfit)
    except Refused as error:
        print(f"the probe is refused: {error}")
        return 2
    if any(bool(p.why) is not p.wrong for p in probes):
        return 2
    with tempfile.TemporaryDirectory() as folder, ProcessPoolExecutor(args.jobs) as pool:
        work = partial(_row, compilers=compilers, xsd=args.xsd, scans=args.scans, seed=args.seed)
        paths = _beside(args.layouts, folder)
        rows = list(pool.map(work, reversed(paths)))[::-1]  # the largest first
        in_c = list(pool.map(partial(c_row, scans=max(args.scans // 4, 1), seed=args.seed), reversed(paths)))[::-1]
    made = bundle(args.planted)
    planted = plant(made, compilers, args.scans, args.seed)
    lines = [INTRODUCTION, *_tools(probes, args.scans, args.seed), *_table(rows, compilers)]
    lines += _planted(made, planted, compilers) + _c_table(in_c) + (_schema(rows) if args.xsd else [])
    text = "\n".join(lines)
    if args.out:
        Path(args.out).write_text(text, encoding="utf-8")
    print(text)
    print(f"{time.time() - began:.0f} s")
    bad = [r.name for r in rows if not all(v.equal for v in r.verdicts) or any(why for _, why in r.schema)]
    bad += [f"{r.name} in C" for r in in_c if not r.verdict.equal]
    idle = still(rows, in_c)
    missed = [what for what, verdicts in planted if not all(v.differing for v in verdicts)]
    print(f"differences: {', '.join(bad) or 'none'}; planted faults not noticed: {', '.join(missed) or 'none'}")
    print(f"too little happened: {', '.join(idle) or 'none'}")
    return 1 if bad or missed or idle else 0


if __name__ == "__main__":
    sys.exit(main())
