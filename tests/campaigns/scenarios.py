"""What may happen on the railway that is proved safe: each scenario with the shortest run in which it happens.

python -m tests.campaigns.scenarios > proofs/scenarios.md
"""

from __future__ import annotations

import sys

from tests.campaigns.origin import origin
from tests.scenarios import SCENARIOS, run_to, told


def main() -> int:
    """Print the scenarios as Markdown."""
    print("# Scenarios\n")
    print(
        "What the proof claims, it claims whatever of this happens, as often and in whatever order: each scenario is "
        "reached, under all assumptions, in a run of the layout's controller and plant.  Here is the shortest one, "
        "found by bounded search and thinned to what it needs.  What is excluded, and the accident that it excludes, "
        "is in [assumptions.md](assumptions.md).\n"
    )
    print(f"`python -m tests.campaigns.scenarios` {origin()}; `tests/test_scenarios.py` looks for each run.\n")
    missing = 0
    for number, scenario in enumerate(SCENARIOS, 1):
        found = run_to(scenario)
        print(f"## {number}. {scenario.says}\n")
        if found is None:
            missing += 1
            print("No run was found.\n")
            continue
        print(f"On `{scenario.layout.split('/')[-1]}`, where {' and '.join(f'`{n}`' for n in scenario.holds)}:\n")
        story = told(*found, scenario)
        print("\n".join(f"{n}. {step}" for n, step in enumerate(story.steps, 1)) + "\n")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
