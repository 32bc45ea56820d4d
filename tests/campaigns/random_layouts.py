"""Random layouts in a long run: derivation against audit, and (with --prove) every claim and the emitted text.

python -m tests.campaigns.random_layouts --count 2000 [--prove 200]
"""

from __future__ import annotations

import argparse
import sys
import time

from interlock.audit import audit
from interlock.logic.lower import lower
from interlock.proof.engines.limits import Limits
from interlock.proof.equivalence.structured_text import compare_st
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.st.lower import lower_st
from interlock.st.printer import print_unit
from tests.grow import grow
from tests.layouts import grown


def main() -> int:
    """Run the campaign."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=2000, help="valid layouts to compare")
    parser.add_argument("--prove", type=int, default=0, help="how many of them to prove as well")
    args = parser.parse_args()
    began = time.time()
    compared = proved = routes = seed = undrivable = 0
    bad: list[str] = []
    while compared < args.count:
        made = grown(grow(seed))
        seed += 1
        if made is None or made[2].has_errors:
            continue
        layout, table, _ = made
        compared += 1
        routes += len(table.routes)
        bad += [f"seed {seed - 1}: {f}" for f in audit(layout, table)]
        if proved < args.prove:
            controller = lower(layout, table)
            result = prove(System(layout, controller), Limits(search_s=10))
            text = compare_st(controller, print_unit(lower_st(controller, [])))
            if {c.verdict for c in result.claims} != {Verdict.PROVED} or not text.proved or result.dropped:
                bad.append(f"seed {seed - 1}: not proved")
            undrivable += sum(not w.ok for w in result.witnesses)
            proved += 1
    print(*bad[:50], sep="\n")
    print(
        f"{compared} random layouts ({seed} grown), {routes} routes: {len(bad)} disagreements; {proved} proved with "
        f"their text, in them {undrivable} routes reported as undrivable; {time.time() - began:.0f} s"
    )
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
