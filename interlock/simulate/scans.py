"""The emitted runtime in its cycle, of which only those scans are run that can change something.

The controller reads its inputs once a cycle.  A scan that leaves its state as it was, with the same inputs as the scan
before, changes nothing but the times of its timers; so do all that follow it, until an input changes or a timer comes
to its end.  These are not run: the timers are moved on by their time.  A test compares this with every scan run.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


class Scans:
    """A runtime, its inputs, and when its next scan is due (milliseconds).  `inputs` are written by the world."""

    def __init__(self, names: Mapping[str, Any], cycle_ms: int) -> None:
        if not 0 < cycle_ms <= names["Controller"].cycle_max_ms:
            raise ValueError("a cycle that the controller does not accept")
        self.cycle_ms = cycle_ms
        self.controller = names["Controller"]()
        self.presets: Mapping[str, int] = names["TIMERS"]
        self.inputs: dict[str, int] = {n: restrictive for n, (restrictive, _) in names["INPUTS"].items()}
        self.outputs: dict[str, int] = {n: int(v) for n, v in names["OUTPUTS"].items()}
        self.seen: dict[str, int] = {**self.inputs, **self.outputs}
        """Inputs as sampled and outputs as shown."""
        self.last_ms = -cycle_ms
        self.runs = 0
        self._read: dict[str, int] = {}
        self._quiet: int | None = 0
        """How many scans from the last one on change nothing; None: all, until an input changes."""

    def due(self, changed_ms: int | None) -> int | None:
        """When the next scan is to be run, if an input changed then, or none did since the last scan."""
        quiet = self._quiet
        own = None if quiet is None else self.last_ms + (quiet + 1) * self.cycle_ms
        if changed_ms is None:
            return own
        k = -((self.last_ms - changed_ms) // self.cycle_ms)
        read = self.last_ms + max(1, k) * self.cycle_ms
        return read if own is None else min(own, read)

    def scan(self, at_ms: int) -> bool:
        """Run the scan at a time that is due; whether anything that is seen has changed."""
        left_out = (at_ms - self.last_ms) // self.cycle_ms - 1
        elapsed = self.controller.elapsed
        if left_out > 0:
            for name, ms in elapsed.items():
                if ms is not None:
                    elapsed[name] = min(ms + left_out * self.cycle_ms, self.presets[name])
        before = self.controller.state
        self.outputs = self.controller.scan(self.inputs, self.cycle_ms)
        self.last_ms = at_ms
        self.runs += 1
        same = self.inputs == self._read and before == self.controller.state
        self._read = dict(self.inputs)
        self._quiet = self._steps(elapsed) if same else 0
        now = {**self._read, **self.outputs}
        changed, self.seen = now != self.seen, now
        return changed

    def _steps(self, elapsed: Mapping[str, int | None]) -> int | None:
        """Scans until a timer comes to its end, less that one."""
        left = [self.presets[n] - ms for n, ms in elapsed.items() if ms is not None and ms < self.presets[n]]
        return (min(left) + self.cycle_ms - 1) // self.cycle_ms - 1 if left else None
