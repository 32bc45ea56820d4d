"""Estimate what each shipped layout and a yard of 37 tracks take of S7-300 and S7-1500, and write proofs/targets.md.

python -m tests.campaigns.targets [--write]
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

from interlock.app.init import yard
from interlock.app.target import DIALECT, TIA_DIALECT, estimated, too_large
from interlock.logic.lower import lower
from interlock.model.target import CPUS
from interlock.st.sizes import CAVEAT, RULE, SOURCE, TIA_RULE, TIA_SOURCE
from tests.layouts import SHIPPED, built, grown

PAGE = Path(__file__).resolve().parents[2] / "proofs" / "targets.md"
TRACKS = 37


def head() -> list[str]:
    """What the figures are."""
    lines = [
        "# Targets",
        "",
        "`python -m tests.campaigns.targets --write`: what the text for an S7-300 or S7-1500 takes, by layout: **"
        f"{CAVEAT}.**",
        f"The rule: {RULE}.  Its source: {SOURCE}.  Text: `{DIALECT}` with its mapping program; blocks, code and data "
        "below are of this one.",
        "",
        f"For an S7-1500: {TIA_RULE}.  Its source: {TIA_SOURCE}.  Text: `{TIA_DIALECT}`.",
        "",
        "| target | blocks | bytes of a block | bytes of memory | of data apart | source |",
        "|---|---:|---:|---:|---:|---|",
    ]
    for t in CPUS.values():
        limits = (x or "-" for x in (t.blocks, t.block_bytes, t.memory_bytes, t.data_bytes))
        lines.append(f"| {t.name} | {' | '.join(map(str, limits))} | {t.source} |")
    names = " | ".join(CPUS)
    marks = "---|" * len(CPUS)
    return [
        *lines,
        "",
        f"| layout | routes | blocks | largest block | its bytes | the next one | its bytes | code | data | {names} |",
        f"|---|---:|---:|---|---:|---|---:|---:|---:|{marks}",
    ]


def row(name: str) -> str:
    """The figures of a layout, and what each target lacks for it."""
    if name == f"yard{TRACKS}":
        made = grown(yard(TRACKS))
        assert made is not None
        layout, table, _ = made
        controller = lower(layout, table)
    else:
        layout, table, controller = built(name)
    size, tia = estimated(layout, controller), estimated(layout, controller, True)
    first, second = sorted(size.code.items(), key=lambda x: -x[1])[:2]
    wrong = [too_large(tia if t.tia else size, t) for t in CPUS.values()]
    fits = ["; ".join(x.partition(",")[0] for x in found) or "fits" for found in wrong]
    code, data = sum(size.code.values()), sum(size.data.values())
    cells = [name, len(table.routes), len(size.code), *first, *second, code, data, *fits]
    return f"| {' | '.join(map(str, cells))} |"


def page() -> Iterator[str]:
    """The whole page, line by line."""
    yield from head()
    for name in (*SHIPPED, f"yard{TRACKS}"):
        yield row(name)


def main() -> None:
    """Print the page, or write it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true")
    text = "\n".join(page()) + "\n"
    if parser.parse_args().write:
        PAGE.write_text(text, "utf-8")
    else:
        print(text, end="")


if __name__ == "__main__":
    main()
