"""False crossings and names on lines, counted from the SVG: `python -m tests.campaigns.plans > proofs/plans.md`."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from pathlib import Path

from interlock.app.init import line, yard
from interlock.diag import Sink
from interlock.emit.drawing import place, plan_svg
from interlock.frontend import load, load_text
from interlock.model.layout import Layout
from tests.campaigns.origin import origin
from tests.grow import grow
from tests.plans import examine

TOP = Path(__file__).resolve().parents[2]
YARDS, STATIONS = (20, 30, 50, 60, 120, 240), (20, 100)

EXPLAINED = """
A checker that shares no code with the drawing reads the SVG of each plan ([`tests/plans.py`](../tests/plans.py)) and
counts lines that cross, touch or overprint others without being joined on the ground, names that lie on lines,
names that lie on names, and names and lengths of sections that stand nearer to another section.  Seconds are of
processor time.
"""


def fixed() -> Iterator[tuple[str, Layout]]:
    """Every shipped layout, those of the tests, yards and lines."""
    for path in (*sorted(TOP.glob("layouts/*.yaml")), *sorted(TOP.glob("tests/layouts_for_tests/*.yaml"))):
        layout, _ = load(str(path), Sink())
        if layout is not None:
            yield path.stem, layout
    for name, text in (
        *((f"yard of {n} tracks", yard(n)) for n in YARDS),
        *((f"line of {n} stations", line(n)) for n in STATIONS),
    ):
        layout, _ = load_text("large.yaml", text, Sink())
        assert layout is not None
        yield name, layout


def random_layouts(count: int) -> Iterator[tuple[int, Layout]]:
    """So many layouts that grow at random and are valid, with their seeds."""
    seed = 0
    while count:
        layout, _ = load_text("grown.yaml", grow(seed), Sink())
        if layout is not None:
            count -= 1
            yield seed, layout
        seed += 1


def measured(layout: Layout) -> tuple[tuple[int, int, int, int], str, float, tuple[str, ...]]:
    """What is counted in a plan, its size, the seconds that it took, and what the drawing says of itself."""
    began = time.process_time()
    drawing = place(layout)
    svg = plan_svg(layout, drawing)
    seconds = time.process_time() - began
    found = examine(svg, layout)
    counts = (len(found.crossings), len(found.on_lines), len(found.on_names), len(found.astray))
    return counts, f"{drawing.width:.0f} x {drawing.height:.0f}", seconds, tuple(drawing.notes)


def main() -> None:
    """Print the page."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=200, help="random layouts")
    count = parser.parse_args().count
    print(
        f"# Plans: what crosses that does not cross\n\n`python -m tests.campaigns.plans --count {count}` {origin()}.\n"
        f"{EXPLAINED}"
    )
    print(
        "| layout | false crossings | names on lines | names on names | names at other sections | pixels | seconds |\n"
        "|---|---|---|---|---|---|---|"
    )
    for name, layout in fixed():
        counts, size, seconds, _ = measured(layout)
        print(f"| {name} | {' | '.join(map(str, counts))} | {size} | {seconds:.2f} |", flush=True)
    total, told, longest = [0, 0, 0, 0], [], 0.0
    for seed, layout in random_layouts(count):
        counts, _, seconds, notes = measured(layout)
        total = [a + b for a, b in zip(total, counts, strict=True)]
        longest = max(longest, seconds)
        if any(counts):
            told.append(f"seed {seed}: {counts[0]} false crossings; `draw` says: {'; '.join(notes) or 'nothing'}")
    print(f"| {count} random layouts | {' | '.join(map(str, total))} | | at most {longest:.2f} |")
    if told:
        print("\nRandom layouts whose tracks cannot lie in a plane without bridges:\n")
        print("\n".join(f"- {x}" for x in told))


if __name__ == "__main__":
    main()
