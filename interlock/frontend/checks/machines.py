"""A machine works one or two ends.  IL3014."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.layout import Layout


def check_machines(ctx: Context, layout: Layout) -> None:
    """Report machines with more than two ends, and machines that bear another point's name."""
    named = {str(q) for q in layout.point}
    for machine, ends in sorted(layout.ends_of_machine.items()):
        if len(ends) > 2:
            ctx.add(
                "IL3014",
                f"the machine {machine} works {len(ends)} ends: {', '.join(p.id for p in ends)}",
                ctx.at("points", ends[2].id, "machine"),
                "a machine works one end, or the two of a crossover",
            )
        for p in ends:
            if str(machine) in named and str(machine) != str(p.id):
                ctx.add(
                    "IL2002",
                    f"the machine of {p.id} bears the name of the point {machine}",
                    ctx.at("points", p.id, "machine"),
                    "give the pair a name of its own, for instance 201",
                )
