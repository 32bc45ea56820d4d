"""What certificates cost: `python -m benchmarks.certificates`, for the shipped layouts, a yard and a line.

In one process, one after the other: the whole proof from YAML to verdicts with its texts; what a certificate needs
besides (facts, obligations with their hints, bytes); and its check by `interlock verify`.  Three times in turn; of each
the least is told.
"""

from __future__ import annotations

import gc
import subprocess
import tempfile
import time
from pathlib import Path

from interlock.app.certify import certify_file
from interlock.app.check import check_file
from interlock.app.compile import compile_file
from interlock.app.init import line, yard
from interlock.app.prove import prove_file
from interlock.logic.lower import lower
from interlock.proof.certificate.bundle import proof_bytes, system_text
from interlock.proof.certificate.engine import prove_locally
from interlock.proof.certificate.facts import FactBase
from interlock.proof.certificate.needed import needs, needs_text
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.verify import verify

TOP = Path(__file__).resolve().parent.parent
TIMES = 3


def measure(path: Path, folder: Path) -> tuple[float, float, float, int, int]:
    """Least seconds to prove, to certify besides, and to verify; obligations, and kilobytes of the proof."""
    runs = [_once(path, folder) for _ in range(TIMES)]
    prove, certify, check, *_ = map(min, zip(*runs, strict=True))
    return prove, certify, check, *runs[-1][3:]


def _once(path: Path, folder: Path) -> tuple[float, float, float, int, int]:
    began = time.perf_counter()
    assert prove_file(str(path)).green
    proving = time.perf_counter() - began
    checked = check_file(str(path))
    assert checked.layout is not None and checked.table is not None
    began = time.perf_counter()
    system = System(checked.layout, lower(checked.layout, checked.table))
    facts = Facts(system)
    base = FactBase(system, strengthening(facts), claims(facts), start_claim(system))
    system_text(base)
    proof = prove_locally(base)
    size = len(proof_bytes(proof)) // 1000
    needs_text(needs(proof, system.controller))
    certifying = time.perf_counter() - began
    compile_file(str(path), folder / "generated")
    assert certify_file(str(path), folder / "generated", folder / "proofs").ok
    began = time.perf_counter()
    verify(folder / "proofs" / checked.layout.name)
    verifying = time.perf_counter() - began
    return proving, certifying, verifying, len(proof.obligations), size


def main() -> None:
    """Print the page."""
    gc.disable()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=TOP, capture_output=True, text=True).stdout
    print(f"# Certificates\n\n`python -m benchmarks.certificates` at commit {commit.strip()}, x86_64, one process.\n")
    print("| layout | prove, s | certify besides, s | ratio | verify, s | ratio | obligations | kB |")
    print("|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        paths = sorted((TOP / "layouts").glob("*.yaml"))
        for kind, size in (("yard", 6), ("line", 12)):
            path = folder / f"{kind}{size}.yaml"
            path.write_text(line(size) if kind == "line" else yard(size))
            paths.append(path)
        sums = [0.0, 0.0, 0.0]
        for path in paths:
            prove, certify, check, obligations, size = measure(path, folder)
            print(
                f"| {path.stem} | {prove:.2f} | {certify:.2f} | {certify / prove:.1f} | {check:.2f} "
                f"| {check / prove:.1f} | {obligations} | {size} |",
                flush=True,
            )
            if path.parent == TOP / "layouts":
                sums = [a + b for a, b in zip(sums, (prove, certify, check), strict=True)]
        prove, certify, check = sums
        print(
            f"| all shipped | {prove:.2f} | {certify:.2f} | {certify / prove:.1f} | {check:.2f} | {check / prove:.1f} "
            "| | |"
        )


if __name__ == "__main__":
    main()
