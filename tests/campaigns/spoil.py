"""One-byte changes of the shipped certificates and of everything that they tie: `verify` must reject each.

python -m tests.campaigns.spoil --count 1000
"""

from __future__ import annotations

import argparse
import json
import random
import sys
import time
from pathlib import Path

from interlock.verify import Rejected, verify

ROOT = Path(__file__).resolve().parent.parent.parent


def main() -> int:
    """Spoil one byte after another, each undone before the next."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    rng = random.Random(args.seed)
    bundles = sorted(p.parent for p in (ROOT / "proofs").glob("*/manifest.json"))
    began = time.perf_counter()
    for b in bundles:
        verify(b)
    took = time.perf_counter() - began
    rejected: dict[str, int] = {}
    accepted = []
    for _ in range(args.count):
        folder = rng.choice(bundles)
        named = json.loads((folder / "manifest.json").read_text("utf-8"))["files"]
        path = rng.choice([folder / "manifest.json", *((folder / n).resolve() for n in named)])
        data = path.read_bytes()
        at = rng.randrange(len(data))
        spoiled = bytearray(data)
        spoiled[at] ^= rng.randrange(1, 256)
        try:
            path.write_bytes(spoiled)
            verify(folder)
            accepted.append(f"{path.relative_to(ROOT)} at byte {at}")
        except (Rejected, OSError, ValueError, KeyError, TypeError, AttributeError) as error:
            rejected[type(error).__name__] = rejected.get(type(error).__name__, 0) + 1
        finally:
            path.write_bytes(data)
    print(*accepted[:20], sep="\n")
    print(
        f"{len(bundles)} certificates accepted in {took:.1f} s; {sum(rejected.values())} of {args.count} one-byte "
        f"changes rejected ({', '.join(f'{n} {k}' for k, n in sorted(rejected.items()))})"
    )
    return 1 if accepted else 0


if __name__ == "__main__":
    sys.exit(main())
