"""An overlap may not lead into a zone: an overrunning train would come in uncounted.  IL3022."""

from __future__ import annotations

from itertools import pairwise

from interlock.frontend.context import Context
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths
from interlock.model.traversal import topology


def check_zones(ctx: Context, layout: Layout) -> None:
    """Report overlaps that lead into a zone from outside (R17)."""
    topo = topology(layout)
    for z in layout.zones:
        for g in layout.signals:
            paths = overlap_paths(layout, g.id)
            before = topo.beyond(layout.section_of(g.into), g.node)
            runs = [[before, *(t.section for t in path)] for path in paths]
            if any(b in z.sections and a not in z.sections for run in runs for a, b in pairwise(run)):
                ctx.add(
                    "IL3022",
                    f"the overlap of {g.id} leads into zone {z.id}: a train that overruns the signal is not counted",
                    ctx.at_key("zones", z.id),
                    f"let the zone begin before {g.id}, or give the signal no overlap: "
                    f"`overlaps: {{{g.id}: {{length: 0}}}}`",
                )
