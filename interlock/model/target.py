"""The controller for which a text is meant: its limits, and where they are published."""

from __future__ import annotations

from interlock.dataclass import dataclass

KB = 1024


@dataclass(frozen=True)
class Target:
    """Limits of a controller: how many function blocks, bytes of one block, bytes of work memory; None: not looked at.

    source: where the limits are published, or that they are the author's own.  data_bytes: work memory for data, where
    it is apart from that of the program, which is then `memory_bytes`.  tia: an S7-1500.
    """

    name: str
    blocks: int | None = None
    block_bytes: int | None = None
    memory_bytes: int | None = None
    source: str = "limits of the layout's author"
    data_bytes: int | None = None
    tia: bool = False


CPUS: dict[str, Target] = {
    t.name: t
    for t in (
        Target(
            "s7-313",
            128,
            8 * KB,
            12 * KB,
            "CPU 313, 6ES7 313-1AD03: CPU Specifications CPU 312 IFM to CPU 318-2 DP, A5E00111190-01, 1.4.2",
        ),
        Target("s7-315t-2dp", 1024, 64 * KB, 256 * KB, "CPU 315T-2 DP, 6ES7 315-6TH13: data sheet"),
        Target("s7-315t-3pndp", 1024, 64 * KB, 384 * KB, "CPU 315T-3 PN/DP, 6ES7 315-7TJ10: data sheet"),
        Target(
            "s7-1510sp-1pn",
            None,
            None,
            100 * KB,
            "CPU 1510SP-1 PN, 6ES7 510-1DJ01, firmware 2.9: data sheet, work memory",
            750 * KB,
            True,
        ),
    )
}
"""CPUs whose limits were looked up; of others the author states the limits."""
