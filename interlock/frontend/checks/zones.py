"""Trains in a zone must be countable: no overlap leads into it, and nothing is shunted in it.  IL3022."""

from __future__ import annotations

from itertools import pairwise

from interlock.frontend.context import Context
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths
from interlock.model.traversal import topology


def check_zones(ctx: Context, layout: Layout) -> None:
    """Report overlaps that lead into a zone from outside, and sections in which vehicles are shunted (R17)."""
    topo = topology(layout)
    for z in layout.declared.zones:
        for s in z.sections:
            if s in topo.berths:
                ctx.add(
                    "IL3022",
                    f"vehicles may be shunted in {s}: nobody can tell how many trains are in zone {z.id}",
                    ctx.at_key("zones", z.id),
                    f"leave {s} out of the zone, or the shunt signals out of it",
                )
        for g in layout.signalling.signals:
            paths = overlap_paths(layout, g.id)
            before = topo.beyond(layout.track.section_of(g.into), g.node)
            runs = [[before, *(t.section for t in path)] for path in paths]
            if any(b in z.sections and a not in z.sections for run in runs for a, b in pairwise(run)):
                ctx.add(
                    "IL3022",
                    f"the overlap of {g.id} leads into zone {z.id}: a train that overruns the signal is not counted",
                    ctx.at_key("zones", z.id),
                    f"let the zone begin before {g.id}, or give the signal no overlap: "
                    f"`overlaps: {{{g.id}: {{length: 0}}}}`",
                )
