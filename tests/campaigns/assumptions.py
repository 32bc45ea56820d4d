"""What happens without each assumption: a train movement to harm, told step by step.

python -m tests.campaigns.assumptions > proofs/assumptions.md
"""

from __future__ import annotations

import sys

from interlock.logic.plant import ASSUMPTIONS, OF_PLC
from interlock.proof.claims import Facts, claims
from interlock.proof.induction.search import search
from interlock.proof.induction.story import Story, tell
from interlock.proof.system.transition import System
from tests.campaigns.origin import origin
from tests.layouts import built

OVERRUN = "../tests/layouts_for_tests/overrun"
TOKEN = "../tests/layouts_for_tests/token"
SWING = "../tests/layouts_for_tests/swing"
YARD = "../tests/layouts_for_tests/shunt_yard"
INSIDE = "../tests/layouts_for_tests/overlap_inside"
# assumption, layout, claim that fails without it
CASES = (
    ("A-OBEY", "fig2_3_split", "T-COLLISION"),
    ("A-SCAN", "fig2_2", "T-COLLISION"),
    ("A-HEADWAY", "fig2_2", "T-COLLISION"),
    ("A-HEADWAY", YARD, "T-COLLISION"),
    ("A-DETECT", "fig2_2", "T-COLLISION"),
    ("A-ONE-FALSE", "depot", "T-POINT-MOVES"),
    ("A-CONTACT", "fig2_2", "T-DERAIL"),
    ("A-POINT", "fig2_2", "T-DERAIL"),
    ("A-TIMER", "fig2_2", "T-COLLISION"),
    ("A-PARTED", "fig2_3_split", "T-COLLISION"),
    ("A-TRAILED", "junction", "T-FLANK"),
    ("A-BUFFER", "terminus", "T-DERAIL"),
    ("A-RESTART", "fig2_3_split", "T-COLLISION"),
    ("A-REVERSE", "fig2_3_split", "T-COLLISION"),
    ("A-LATE-OUTPUT", "fig2_2", "T-POINT-MOVES"),
    ("A-STAND", OVERRUN, "T-COLLISION"),
    ("A-SLOW", INSIDE, "T-COLLISION"),
    ("A-SWING", SWING, "T-POINT-MOVES"),
    ("A-NEIGHBOUR", TOKEN, "T-LINE"),
    ("A-AGREED", TOKEN, "T-LINE"),
    ("A-LINE", TOKEN, "T-LINE"),
    ("A-TON", "fig2_2", "T-COLLISION"),
    ("A-CLOCK", "fig2_2", "T-COLLISION"),
)
# assumptions that nothing in the physics can drop
OTHERS = {
    "A-OVERRUN": "It widens what trains do; without it no train passes a signal at stop at all.  "
    "Where there is no overlap, a train that passes a signal at stop does what A-OBEY excludes.",
    "A-SIGHT": "It says where the physics ends: shunting movements stop before vehicles in a berth.",
    "A-BEYOND": "It says where the physics ends: the neighbour's side of a boundary.",
    "A-STANDS": "It says where the physics ends: vehicles that stand do not roll away.",
    "A-INITIAL": "The proof begins in the declared values.  Where a restart keeps what was, a signal that stood at "
    "proceed stands there still, after any length of time; where members of structures begin as FALSE, no section is "
    "locked and no restart delay runs (`tests/test_restart_values.py`).",
}


SENTENCES = ASSUMPTIONS | OF_PLC


def harm(assumption: str, name: str, claim: str) -> Story | None:
    """The shortest run to a violation of the claim when the assumption is dropped."""
    layout, _, controller = built(name)
    system = System(layout, controller, frozenset({assumption}))
    run = search(system, [c for c in claims(Facts(system)) if c.id == claim], 16, 120)
    return tell(system.loop, run) if run is not None else None


def main() -> int:
    """Print the ledger as Markdown."""
    print("# The assumptions, and what happens without them\n")
    print(f"`python -m tests.campaigns.assumptions` {origin()}.\n")
    print(
        "Each that can be dropped is dropped alone; the bounded search then finds the shortest run from a restart to a "
        "violated claim.\n"
    )
    bad, told = 0, set[str]()
    for assumption, name, claim in CASES:
        story = harm(assumption, name, claim)
        if assumption not in told:
            print(f"## {assumption}\n\n{SENTENCES[assumption]}\n")
        told.add(assumption)
        if story is None:
            bad += 1
            print(f"Without it no violation of {claim} was found.\n")
            continue
        print(f"Without it, on `{name.split('/')[-1]}`:\n")
        print("\n".join(f"{n}. {step}" for n, step in enumerate(story.steps, 1)) + "\n")
    for assumption, text in OTHERS.items():
        print(f"## {assumption}\n\n{SENTENCES[assumption]}\n\n{text}\n")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
