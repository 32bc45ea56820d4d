"""The on-delay timer TON of IEC 61131-3, defined once for the controller, its runtime, the interpreter of its text, the
watch of the field link and the simulations.

In the scan in which IN becomes true, ET is 0; in each scan after it ET grows by the time since the scan before, up to
PT; Q is IN and ET >= PT; when IN is false, ET is 0 and Q false.  So the time that passed *before* the scan in which IN
rose never counts.  (As the standard's function block TON, by the bodies that open IEC compilers give it.)

A scan that comes later than `CYCLE_MAX_MS` after the one before it has missed what happened meanwhile: two readings
that are equal say nothing of the time between.  Its inputs count as lost.  The bound is what `output_delay_s` allows
for.
"""

from __future__ import annotations

CYCLE_MAX_MS = 1000


def on_delay(elapsed: int | None, on: bool, preset_ms: int, dt_ms: int) -> tuple[int | None, bool]:
    """One scan of a timer: its new elapsed time in milliseconds (None: IN is false) and Q."""
    if not on:
        return None, False
    now = 0 if elapsed is None else min(elapsed + dt_ms, preset_ms)
    return now, now >= preset_ms
