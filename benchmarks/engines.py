"""Engines side by side on lines and yards of growing size: `python -m benchmarks.engines [--limit 60]`.

Every engine decides the same system in a process of its own, one after the other, under one time limit:

    induction   this package's proof: invariants per element, whole formula, MiniSat
    with z3     the same with Z3
    hints       small obligations, each shown by unit propagation (what `certify` writes)
    verify      `interlock verify` on that certificate
    k-induction Z3, the claims alone as invariant, k up to 4
    spacer      Z3's Spacer on the whole system
    pdr         ABC's property-directed reachability on the exported circuit (where installed)

Writes a table and a plot in SVG.
"""

from __future__ import annotations

import argparse
import multiprocessing
import platform
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from interlock.app.init import line, yard
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.expr import Expr, Op, conj, neg, var, walk
from interlock.logic.lower import lower
from interlock.proof.certificate.aiger import aiger
from interlock.proof.certificate.bundle import manifest_text, proof_bytes, system_text
from interlock.proof.certificate.engine import prove_locally
from interlock.proof.certificate.facts import FactBase
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.engines import Answer
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.tseitin import Cnf
from interlock.proof.engines.z3_sat import Z3Sat
from interlock.proof.induction.inductive import inductive, open_claims
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.verify import verify

SIZES = (("line", 1), ("line", 2), ("line", 4), ("line", 8), ("yard", 4), ("yard", 6), ("yard", 8))


def system_of(kind: str, size: int) -> tuple[System, int]:
    """A generated layout's system, and its number of routes."""
    sink = Sink()
    layout, _ = load_text("bench.yaml", line(size) if kind == "line" else yard(size), sink)
    assert layout is not None, sink.diagnostics
    table = derive(layout, sink)
    return System(layout, lower(layout, table)), len(table.routes)


def by_induction(system: System) -> str:
    """The package's own proof."""
    kept, dropped, _ = inductive(system, Limits())
    open_ = open_claims(system, kept, claims(Facts(system)), Limits())
    return "proved" if not open_ and not dropped else "open"


def by_induction_with_z3(system: System) -> str:
    """The same, every obligation decided by Z3."""
    limits = Limits(engine="z3")
    kept, dropped, _ = inductive(system, limits)
    open_ = open_claims(system, kept, claims(Facts(system)), limits)
    return "proved" if not open_ and not dropped else "open"


def _base(system: System) -> FactBase:
    facts = Facts(system)
    return FactBase(system.relation, system.initial, strengthening(facts), claims(facts), start_claim(system.loop))


def by_hints(system: System) -> str:
    """Small obligations, each with the clauses that show it."""
    proof = prove_locally(_base(system))
    return "open" if proof.open else f"proved, {len(proof.obligations)}"


def certificate(system: System, folder: Path) -> None:
    """A bundle without other files."""
    base = _base(system)
    files = {"system.txt": system_text(base).encode(), "proof.txt.xz": proof_bytes(prove_locally(base))}
    for name, data in files.items():
        (folder / name).write_bytes(data)
    (folder / "manifest.json").write_text(manifest_text("bench", files), encoding="utf-8")


def by_k_induction(system: System) -> str:
    """The claims alone, assumed in k steps, in the step after them."""
    wanted = conj(c.expr for c in claims(Facts(system)))
    step = Cnf()
    for name, x in system.relation.definitions.items():
        step.define(name, x)
    for a in system.relation.assumptions:
        step.require(a.expr)
    good = step.literal(wanted)
    now = {n: step.literal(var(n)) for n in system.relation.state}
    then = {n: step.literal(var(n.next)) for n in system.relation.state}
    for k in range(1, 5):
        cnf = Cnf()
        cnf.clauses, cnf.count = [], step.count * (k + 1)

        def at(lit: int, i: int) -> int:
            return lit + i * step.count if lit > 0 else lit - i * step.count

        for i in range(k + 1):
            cnf.clauses += [tuple(at(x, i) for x in c) for c in step.clauses]
            cnf.clauses.append((at(good, i) if i < k else -at(good, i),))
            if i:
                for n, lit in now.items():
                    here, came = at(lit, i), at(then[n], i - 1)
                    cnf.clauses += [(-here, came), (here, -came)]
        if Z3Sat(cnf, 600_000).ask() is Answer.UNSAT:
            return f"inductive at k = {k} (base not asked)"
    return "not inductive up to k = 4"


def by_spacer(system: System) -> str:
    """Z3's Horn solver on the whole system."""
    import z3

    known: dict[int, z3.BoolRef] = {}
    defined = dict(system.relation.definitions)
    values: dict[str, z3.BoolRef] = {}

    def of(root: Expr) -> z3.BoolRef:
        for node in walk((root,)):
            if id(node) in known:
                continue
            if node.op is Op.VAR:
                term = values.get(node.name)
                if term is None:
                    term = values[node.name] = of(defined[node.name]) if node.name in defined else z3.Bool(node.name)
            elif node.op is Op.EQ:
                term = z3.Int(node.name) == node.value
            elif node.op is Op.NOT:
                term = z3.Not(known[id(node.args[0])])
            elif node.op in (Op.AND, Op.OR):
                term = (z3.And if node.op is Op.AND else z3.Or)([known[id(a)] for a in node.args])
            else:
                term = z3.BoolVal(node.op is Op.TRUE)
            known[id(node)] = term
        return known[id(root)]

    state = [z3.Bool(n) for n in system.relation.state]
    reach = z3.Function("reach", *(z3.BoolSort() for _ in state), z3.BoolSort())
    solver = z3.Fixedpoint()
    solver.set(engine="spacer")
    solver.register_relation(reach)
    free = [z3.Int(n) if n in system.relation.sizes else z3.Bool(n) for n in system.relation.inputs]
    solver.declare_var(*state, *free)
    bad = z3.Function("bad", z3.BoolSort())
    solver.register_relation(bad)
    fair = z3.And([of(a.expr) for a in system.relation.assumptions])
    solver.rule(reach(*state), of(system.initial.whole))
    solver.rule(reach(*(of(var(n.next)) for n in system.relation.state)), [reach(*state), fair])
    solver.rule(bad(), [reach(*state), fair, of(neg(conj(c.expr for c in claims(Facts(system)))))])
    answer = solver.query(bad())
    return "proved" if answer == z3.unsat else "refuted" if answer == z3.sat else "open"


@dataclass(frozen=True)
class Row:
    """One engine on one layout: seconds (None: over the limit), peak memory in MB, verdict."""

    engine: str
    seconds: float | None
    megabytes: float
    verdict: str


def timed(name: str, work: Callable[[System], str], kind: str, size: int, limit: float) -> Row:
    """One engine in a process of its own."""
    ours, theirs = multiprocessing.Pipe()

    def child() -> None:
        sys.setrecursionlimit(100_000)
        system, _ = system_of(kind, size)
        began = time.perf_counter()
        verdict = work(system)
        took = time.perf_counter() - began
        theirs.send((took, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024, verdict))

    process = multiprocessing.get_context("fork").Process(target=child)
    process.start()
    found = ours.recv() if ours.poll(limit + 30) else None
    process.kill()
    process.join()
    if found is None or found[0] > limit:
        return Row(name, None, 0.0, f"not in {limit:g} s")
    return Row(name, *found)


def rows(kind: str, size: int, limit: float) -> list[Row]:
    """All engines on one layout."""
    out = [timed("induction", by_induction, kind, size, limit)]
    out.append(timed("with z3", by_induction_with_z3, kind, size, limit))
    out.append(timed("hints", by_hints, kind, size, limit * 4))
    with tempfile.TemporaryDirectory() as folder:
        system, _ = system_of(kind, size)
        certificate(system, Path(folder))
        out.append(timed("verify", lambda _: verify(Path(folder)).split(",")[0], kind, size, limit))
        out.append(timed("k-induction", by_k_induction, kind, size, limit))
        out.append(timed("spacer", by_spacer, kind, size, limit))
        abc = shutil.which("berkeley-abc") or shutil.which("abc")
        if abc:
            path = Path(folder) / "system.aig"
            path.write_bytes(aiger(system, claims(Facts(system))))

            def pdr(_: System) -> str:
                command = [abc, "-q", f"read_aiger {path}; pdr -T {limit:g}"]
                done = subprocess.run(command, capture_output=True, text=True, check=False).stdout
                return "proved" if "Property proved" in done else "open"

            found = timed("pdr", pdr, kind, size, limit)
            out.append(Row("pdr", None, 0.0, f"not in {limit:g} s") if found.verdict == "open" else found)
    return out


COLOURS = {
    "induction": "#0b6e4f",
    "with z3": "#6fae3b",
    "hints": "#1f5fbf",
    "verify": "#7a3fb0",
    "k-induction": "#8a8a8a",
    "spacer": "#b0460b",
    "pdr": "#c81d4e",
}


def plot(points: dict[str, list[tuple[int, float]]], limit: float) -> str:
    """Seconds against routes, both logarithmic; only what was decided within the limit."""
    import math

    wide, high, left, low = 720, 420, 70, 50
    most = max(n for ps in points.values() for n, _ in ps)

    def x(n: float) -> float:
        return left + (wide - left - 120) * math.log(n / 5) / math.log(most / 5)

    def y(s: float) -> float:
        return high - low - (high - low - 20) * math.log(max(s, 0.01) / 0.01) / math.log(limit * 4 / 0.01)

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" font-family="sans-serif" font-size="12">',
        f'<rect width="{wide}" height="{high}" fill="#fff"/>',
    ]
    for s in (0.01, 0.1, 1, 10, 100):
        out.append(f'<line x1="{left}" x2="{wide - 120}" y1="{y(s):.0f}" y2="{y(s):.0f}" stroke="#ddd"/>')
        out.append(f'<text x="{left - 8}" y="{y(s) + 4:.0f}" text-anchor="end">{s:g} s</text>')
    for n in (10, 20, 40, 80):
        out.append(f'<line x1="{x(n):.0f}" x2="{x(n):.0f}" y1="20" y2="{high - low}" stroke="#eee"/>')
        out.append(f'<text x="{x(n):.0f}" y="{high - low + 18}" text-anchor="middle">{n}</text>')
    out.append(f'<text x="{(wide - 120 + left) / 2:.0f}" y="{high - 10}" text-anchor="middle">routes</text>')
    for name, ps in points.items():
        if not ps:
            continue
        places = [(x(n), y(s)) for n, s in sorted(ps)]
        line_ = " ".join(f"{a:.1f},{b:.1f}" for a, b in places)
        out.append(f'<polyline points="{line_}" fill="none" stroke="{COLOURS[name]}" stroke-width="2"/>')
        out += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3.5" fill="{COLOURS[name]}"/>' for a, b in places]
    written: list[tuple[float, float]] = []
    ends = [(y(s) + 4, x(n) + 8, name) for name, ps in points.items() for n, s in sorted(ps)[-1:]]
    for b, a, name in sorted(ends, reverse=True):  # from below: no name lies over another
        b = min([b, *(d - 13 for c, d in written if abs(a - c) < 60 and b > d - 13)])
        written.append((a, b))
        out.append(f'<text x="{a:.0f}" y="{b:.0f}" fill="{COLOURS[name]}">{name}</text>')
    return "\n".join([*out, "</svg>"]) + "\n"


def main() -> int:
    """Print the table; write it and the plots to a folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--limit", type=float, default=60, help="seconds for each engine and layout")
    parser.add_argument("--out", type=Path, help="folder for engines.md, engines_line.svg and engines_yard.svg")
    args = parser.parse_args()
    lines = ["| layout | routes | engine | seconds | MB | verdict |", "|---|---|---|---|---|---|"]
    points: dict[str, dict[str, list[tuple[int, float]]]] = {}
    for kind, size in SIZES:
        _, routes = system_of(kind, size)
        for row in rows(kind, size, args.limit):
            took = f"{row.seconds:.2f}" if row.seconds is not None else ""
            memory = f"{row.megabytes:.0f}" if row.seconds is not None else ""
            lines.append(f"| {kind} {size} | {routes} | {row.engine} | {took} | {memory} | {row.verdict} |")
            print(lines[-1], flush=True)
            if row.seconds is not None and not row.verdict.startswith(("not", "open")):
                points.setdefault(kind, {n: [] for n in COLOURS})[row.engine].append((routes, row.seconds))
    if args.out:
        head = f"Python {platform.python_version()}, {platform.machine()}, limit {args.limit:g} s."
        (args.out / "engines.md").write_text(f"# Engines side by side\n\n{head}\n\n" + "\n".join(lines) + "\n")
        for kind, found in points.items():
            (args.out / f"engines_{kind}.svg").write_text(plot(found, args.limit))
    return 0


if __name__ == "__main__":
    sys.exit(main())
