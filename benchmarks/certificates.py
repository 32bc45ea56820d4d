"""What certificates cost: `python -m benchmarks.certificates`, for the shipped layouts, and for yards and lines.

In one process, one after the other: the whole proof from YAML to verdicts with its texts; what a certificate needs
besides (facts, obligations with their hints, bytes, and which terms each claim rests on); and its check by
`interlock.verify`.  Processor time, three times in turn; of each the least is told.
"""

from __future__ import annotations

import gc
import os
import platform
import subprocess
import tempfile
from pathlib import Path
from time import process_time

from interlock.app.check import check_file
from interlock.app.init import line, yard
from interlock.app.prove import prove_file
from interlock.logic.expr import interning
from interlock.logic.lower import lower
from interlock.proof.certificate.bundle import PROOF, SYSTEM, proof_bytes, system_text
from interlock.proof.certificate.engine import prove_locally
from interlock.proof.certificate.facts import FactBase
from interlock.proof.certificate.needed import needs, needs_text
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.verify import verify

TOP = Path(__file__).resolve().parent.parent
TIMES = 3
UNSEEN = (*(("yard", n) for n in (4, 5, 6, 8, 10)), *(("line", n) for n in (1, 2, 3, 6, 12)))
"""Layouts that nobody has looked at: kind and size."""


def measure(path: Path) -> tuple[float, float, float, int, int]:
    """Least seconds to prove, to certify besides, and to verify; obligations, and kilobytes of the proof."""
    runs = [_once(path) for _ in range(TIMES)]
    prove, certify, check, *_ = map(min, zip(*runs, strict=True))
    return prove, certify, check, *runs[-1][3:]


@interning()
def _once(path: Path) -> tuple[float, float, float, int, int]:
    began = process_time()
    assert prove_file(str(path)).green
    proving = process_time() - began
    checked = check_file(str(path))
    assert checked.layout is not None and checked.table is not None
    began = process_time()
    system = System(checked.layout, lower(checked.layout, checked.table))
    facts = Facts(system)
    base = FactBase(system.relation, system.initial, strengthening(facts), claims(facts), start_claim(system.loop))
    files = {SYSTEM: system_text(base).encode()}
    proof = prove_locally(base)
    files[PROOF] = proof_bytes(proof)
    needs_text(needs(proof, system.loop.controller))
    certifying = process_time() - began
    began = process_time()
    verify(path, files)
    return proving, certifying, process_time() - began, len(proof.obligations), len(files[PROOF]) // 1000


def _row(name: str, prove: float, certify: float, check: float, *rest: int) -> str:
    figures = [f"{prove:.2f}", f"{certify:.2f}", f"{certify / prove:.1f}", f"{check:.2f}", f"{check / prove:.1f}"]
    return f"| {' | '.join([name, *figures, *(map(str, rest) if rest else ('', ''))])} |"


def _measured(paths: list[Path], name: str) -> None:
    sums = [0.0, 0.0, 0.0]
    for path in paths:
        found = measure(path)
        print(_row(path.stem, *found), flush=True)
        sums = [a + b for a, b in zip(sums, found[:3], strict=True)]
    print(_row(name, *sums), flush=True)


def main() -> None:
    """Print the table."""
    gc.disable()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=TOP, capture_output=True, text=True).stdout
    machine = f"{platform.machine()}, {os.cpu_count()} cores, CPython {platform.python_version()}"
    print(f"`python -m benchmarks.certificates` at commit {commit.strip()}; {machine}; processor time.\n")
    print("| layout | prove, s | certify besides, s | ratio | verify, s | ratio | obligations | kB |")
    print("|---|---|---|---|---|---|---|---|")
    _measured(sorted((TOP / "layouts").glob("*.yaml")), "all shipped")
    with tempfile.TemporaryDirectory() as name:
        paths = [Path(name) / f"{kind}{size}.yaml" for kind, size in UNSEEN]
        for path, (kind, size) in zip(paths, UNSEEN, strict=True):
            path.write_text(line(size) if kind == "line" else yard(size))
        _measured(paths, "all unseen")


if __name__ == "__main__":
    main()
