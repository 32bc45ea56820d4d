"""A runtime that an older version emitted, in the place of today's: for comparisons in one world.

Its inputs and lamps have the names of today.  What it lacks keeps its restrictive value; a request has the number that
the route of this name has there, and is acknowledged in the scan in which it is read, as the older runtime knows no
acknowledgement.  Its timers count in the scan in which they are switched on: nothing of that is mended.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from interlock.simulate.run import load


def older(folder: Path, today: Mapping[str, Any]) -> dict[str, Any]:
    """The names of a runtime module, from the outputs that an older version wrote for the layout.

    today: the names of today's runtime for it.
    """
    was = load((folder / "runtime.py").read_text("utf-8"))
    with (folder / "table.csv").open(encoding="utf-8-sig", newline="") as table:
        number = {r["Route"]: int(r["No."]) for r in csv.DictReader(table) if r["No."].isdecimal()}
    there = {k: number.get(route, 0) for route, k in today["ROUTES"].items()}

    class Controller:
        """The older controller behind today's calls."""

        cycle_max_ms = today["Controller"].cycle_max_ms

        def __init__(self) -> None:
            self._inner = was["Controller"]()
            self.elapsed: dict[str, int | None] = dict.fromkeys(was["TIMERS"])

        @property
        def state(self) -> dict[str, int]:
            """What it remembers."""
            return dict(self._inner.state)

        def scan(self, inputs: Mapping[str, int], dt_ms: int) -> dict[str, int]:
            """One scan; the outputs of today, as far as it has them."""
            asked = {n: there.get(inputs.get(n, 0), 0) for n in ("REQ", "LREQ")}
            self._inner.elapsed = {n: ms or 0 for n, ms in self.elapsed.items()}
            found = self._inner.scan({n: v for n, v in {**inputs, **asked}.items() if n in was["INPUTS"]}, dt_ms)
            self.elapsed = {n: ms or None for n, ms in self._inner.elapsed.items()}
            shown = {n: int(v) for n, v in today["OUTPUTS"].items()} | {n: int(v) for n, v in found.items()}
            return {**shown, "YRQ": inputs.get("REQ", 0), "YLRQ": inputs.get("LREQ", 0)}

        @staticmethod
        def status(route: str) -> tuple[int, str]:
            """It says nothing of its routes."""
            return 0, ""

    return {**today, "Controller": Controller, "TIMERS": was["TIMERS"]}
