"""Sizes of all outputs of a large yard, and the time that its documents take.

python -m tests.campaigns.sizes [--yard N] [-o proofs/sizes.md]
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from interlock.app.check import derive_file
from interlock.app.compile import build_derived, finish
from interlock.app.init import yard
from tests.campaigns.deadlock import processor

WANTED_MB = 20.0  # of what is printed
HEAD = """# Sizes of all outputs of a large yard

`python -m tests.campaigns.sizes --yard {yard}` at commit {commit}, {machine}, one process.
All that `interlock compile` writes of `interlock init --yard {yard}`, {routes} routes, in MB (10^6 bytes).  {seconds}

| file | MB |
|---|---|
{rows}
| **together** | **{total:.2f}** |
| of these, what is printed: workbook and national forms | {printed:.2f} |

At commit 6e00d36 all files together had 508.93 MB; at ec6e9fb, when the workbook was compressed, 293.77 in 66 processor
seconds, 26 of them for documents and plan: every one of {pairs} entries of hostile routes told its own reason, in
table.json, table.csv, the railML names and the report.  Now each reason is said once, and rows tell its place.  At
513ecd0 they had 64.42, of which 25.94 of Structured Text, with the meaning of a variable at its declaration and again
where it is computed.  At cad6d975 they had 61.88, of which 23.83 of Structured Text: a quarter of it handed values from
block to block, which structures now do as a whole.  Of what was left of that text then, 17.74 MB, 8.10 were comments
and 2.28 declarations of members; structures of 500 members at most, so that compilers that copy them can do with it,
made it 19.00.  What remains is text of the controller, of which a PLC needs every line ({controller:.2f} MB), and
{rest:.2f} MB for everything else:
20 MB in all are not to be had while that text is plain.
"""


def measured(tracks: int) -> tuple[tuple[int, int], dict[str, int], str]:
    """Routes and entries of hostile routes, bytes of each output, and how long it took."""
    stages: list[tuple[str, float]] = []

    def progress(stage: str, _: int, __: int) -> None:
        if not stages or stages[-1][0] != stage:
            stages.append((stage, time.process_time()))

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "yard.yaml"
        path.write_text(yard(tracks), encoding="utf-8")
        began = time.process_time()
        derived = derive_file(str(path))
        proved, files = build_derived(derived, unproved=True, progress=progress)
        end = time.process_time()
    assert derived.table is not None
    files = finish(proved.checked, files)
    written = next(at for stage, at in stages if stage.startswith("writing tables"))
    told = f"{end - began:.0f} processor seconds in all, of which {end - written:.0f} for documents and plan."
    counted = len(derived.table.routes), sum(len(r.hostile) for r in derived.table.routes)
    return counted, {name: len(data) for name, data in files.items()}, told


def page(tracks: int) -> tuple[str, float]:
    """The page, and what is printed in MB."""
    (routes, entries), sizes, told = measured(tracks)
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    rows = "\n".join(f"| {name} | {size / 1e6:.2f} |" for name, size in sorted(sizes.items(), key=lambda x: -x[1]))
    total = sum(sizes.values()) / 1e6
    printed = sum(size for name, size in sizes.items() if name == "table.xlsx" or name.startswith("table_")) / 1e6
    printed -= sizes["table_railml.json"] / 1e6
    controller = sum(size for name, size in sizes.items() if name.endswith((".st", ".py"))) / 1e6
    facts = {
        "controller": controller,
        "rest": total - controller,
        "yard": tracks,
        "commit": commit.stdout.strip(),
        "machine": processor(),
        "routes": routes,
        "seconds": told,
    }
    return HEAD.format(**facts, rows=rows, total=total, printed=printed, pairs=f"{entries:,}"), printed


def main() -> None:
    """Write the page; fails where the printed forms of a yard of 1,000 routes are larger than is wanted."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--yard", type=int, default=124)
    parser.add_argument("-o", "--output", type=Path)
    given = parser.parse_args()
    text, printed = page(given.yard)
    print(text)
    if given.output is not None:
        given.output.write_text(text, encoding="utf-8")
    sys.exit(0 if printed < WANTED_MB or given.yard > 124 else 1)


if __name__ == "__main__":
    main()
