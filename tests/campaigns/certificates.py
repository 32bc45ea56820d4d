"""Make the certificates of all shipped layouts in proofs/ and compare them with the committed digests.

python -m tests.campaigns.certificates [-j N] [--write]

The outputs must be there and current (`interlock compile layouts/*.yaml`).  Each certificate is then verified with its
layout (`interlock verify LAYOUT FOLDER`).  proofs/digests.txt has one line for the written system and one for the proof
of each layout: SHA-256 of their text.  The certificates of three layouts are
committed whole; those of the others are made when they are wanted.
"""

from __future__ import annotations

import argparse
import hashlib
import lzma
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from interlock.app.certify import certify_file
from interlock.checker.check import check
from tests.layouts import SHIPPED

DIGESTS = Path("proofs/digests.txt")
COMMITTED = ("fig2_2", "junction", "mine11")


def made(name: str) -> tuple[str, str]:
    """The lines of one layout, and the verdict of both checkers on its certificate."""
    found = certify_file(f"layouts/{name}.yaml", Path("generated"), Path("proofs"))
    if not found.ok:
        return "", f"{name}: {[n.message for n in found.notes]}"
    folder = Path("proofs") / name
    system = hashlib.sha256((folder / "system.txt").read_bytes()).hexdigest()
    proof = hashlib.sha256(lzma.decompress((folder / "proof.txt.xz").read_bytes())).hexdigest()
    said = check(Path(f"layouts/{name}.yaml"), folder)
    if said.left:
        return "", f"{name}: not compared: {', '.join(said.left)}"
    return f"{name} system.txt {system}\n{name} proof.txt {proof}\n", f"{name}: VERIFIED, {', '.join(said.compared)}"


def main() -> int:
    """Make, verify, and compare or write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-j", "--jobs", type=int, default=1)
    parser.add_argument("--write", action="store_true", help="write the digests instead of comparing them")
    args = parser.parse_args()
    with ProcessPoolExecutor(args.jobs) as pool:
        results = list(pool.map(made, SHIPPED))
    for _, verdict in results:
        print(verdict)
    text = "".join(lines for lines, _ in results)
    if not all(lines for lines, _ in results):
        return 1
    if args.write:
        DIGESTS.write_text(text, "utf-8")
        return 0
    if DIGESTS.read_text("utf-8") != text:
        stale = set(DIGESTS.read_text("utf-8").splitlines()) ^ set(text.splitlines())
        print(f"{DIGESTS} is not current: {', '.join(sorted({x.split()[0] for x in stale}))}")
        return 1
    print(f"{len(results)} certificates VERIFIED, digests as committed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
