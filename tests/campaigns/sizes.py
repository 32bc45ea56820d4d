"""Sizes of all outputs of a large yard, and the time that its documents take.

python -m tests.campaigns.sizes [--yard N] [-o proofs/sizes.md]
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from interlock.app.check import derive_file
from interlock.app.compile import build_derived, finish
from interlock.app.init import yard
from tests.campaigns.origin import processor

WANTED_MB = 20.0  # of what is printed
HEAD = """# Sizes of all outputs of a large yard

`python -m tests.campaigns.sizes --yard {yard}` at commit {commit}, {machine}, one process.
All that `interlock compile` writes of `interlock init --yard {yard}`, {routes} routes, in MB (10^6 bytes).
{seconds}

| file | MB |
|---|---|
{rows}
| **together** | **{total:.2f}** |
| of these, what is printed: workbook and national forms | {printed:.2f} |

At commit 6e00d36 all files together had 508.93 MB, at ec6e9fb 293.77, at 513ecd0 64.42, at cad6d975 61.88, at 8bebbc3
55.80: reasons once, compressed workbooks, structures that are handed on as a whole (of 500
members at most, so that compilers that copy them can do with them).  Since then a meaning is
told once in the text, names in a row and groups of hostile routes once in tables and page, the matrices without
what is 0 or told before.

20 MB were wanted, and are not had.  What the rest is:

- {text:.2f} MB are Structured Text.  {code:.2f} of them are code, of which a PLC needs every line: {words:.2f} are the
  words that say why a route is refused, an arm for each condition of each route, and {named:.2f} the names of
  structures before their members.  {comments:.2f} are comments:
  what each input, output, bit of state and equation means, once; an operand that is more than a variable; the
  index of places.
- {runtime:.2f} MB are the Python runtime: the same equations once more, one a line, so that they can be read, compared
  and proved line by line.  Templates of equations that are expanded when the module is loaded would make it
  smaller, and no program that one reads.
- {page:.2f} MB are the report page, with the plan in it, every cell of the table as text for print, and each
  reason once.
- {tables:.2f} MB are tables for people and machines, each with every route.
- {other:.2f} MB are the mapping program, lists of wires and words, the plan and the proof.
"""


def _of_text(text: str) -> tuple[float, float, float, float]:
    """MB of comments, of all else, of that of the blocks of words, and of names of structures before members."""
    comments = sum(len(x) for x in re.findall(r"\(\*.*?\*\)", text))
    words = sum(len(re.sub(r"\(\*.*?\*\)", "", x)) for x in re.findall(r"\n  IF .*?\n  END_IF;", text, re.DOTALL))
    named = sum(map(len, re.findall(r"\b(?:D\d*|INP|OUTP)\.", text)))
    return comments / 1e6, (len(text) - comments) / 1e6, words / 1e6, named / 1e6


def measured(tracks: int) -> tuple[int, dict[str, bytes], str]:
    """How many routes, the outputs, and how long it took."""
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
    return len(derived.table.routes), files, told


def page(tracks: int) -> tuple[str, float]:
    """The page, and what is printed in MB."""
    routes, files, told = measured(tracks)
    sizes = {name: len(data) for name, data in files.items()}
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    rows = "\n".join(f"| {name} | {size / 1e6:.2f} |" for name, size in sorted(sizes.items(), key=lambda x: -x[1]))
    total = sum(sizes.values()) / 1e6
    printed = sum(size for name, size in sizes.items() if name == "table.xlsx" or name.startswith("table_")) / 1e6
    printed -= sizes["table_railml.json"] / 1e6
    name = f"st/iec/yard{tracks}.st"
    comments, code, words, named = _of_text(files[name].decode())
    tables = sum(size for name, size in sizes.items() if name.startswith(("table", "matrix"))) / 1e6
    known = sizes[name] + sizes["runtime.py"] + sizes["index.html"]
    facts = {
        "text": sizes[name] / 1e6,
        "code": code,
        "words": words,
        "named": named,
        "comments": comments,
        "runtime": sizes["runtime.py"] / 1e6,
        "page": sizes["index.html"] / 1e6,
        "tables": tables,
        "other": total - known / 1e6 - tables,
        "yard": tracks,
        "commit": commit.stdout.strip(),
        "machine": processor(),
        "routes": routes,
        "seconds": told,
    }
    return HEAD.format(**facts, rows=rows, total=total, printed=printed), printed


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
