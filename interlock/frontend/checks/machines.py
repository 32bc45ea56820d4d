"""A machine works one end, two ends, or all blades of a slip; blades of a slip are placed where that says something.
IL3014, IL3026."""

from __future__ import annotations

from interlock.diag import Span
from interlock.frontend.context import Context
from interlock.frontend.parts import one_motor, points_of
from interlock.model.layout import Layout


def check_machines(ctx: Context, layout: Layout) -> None:
    """Report machines with more than two ends, and machines that bear another point's name."""
    named = {str(q) for q in layout.pointwork.point}
    of_slip = {p: name for name, s in ctx.file.slips.items() if one_motor(s) for p in points_of(name, s)}
    halves = {p: name for name, s in ctx.file.slips.items() if not one_motor(s) for p in points_of(name, s)}
    for name, slip in sorted(ctx.file.slips.items()):
        if "blades" in slip.model_fields_set and (slip.single is not None or one_motor(slip)):
            why = (
                "has one machine" if one_motor(slip) else "is single, and each machine works the blades at its own end"
            )
            text = f"slip {name} {why}: `blades` says nothing of it"
            ctx.add("IL3026", text, ctx.at("slips", name, "blades"), "remove `blades`")
    for machine, ends in sorted(layout.machines.ends.items()):
        if len(ends) > 2 and len({of_slip.get(p.id, p.id) for p in ends}) > 1:
            ctx.add(
                "IL3014",
                f"the machine {machine} works {len(ends)} ends: {', '.join(p.id for p in ends)}",
                _written(ctx, ends[-1].id),
                "a machine works one end, the two of a crossover, points with a derailer, or all blades of one slip",
            )
        for p in ends:
            if str(machine) in named and str(machine) != str(p.id):
                swapped = halves.get(str(p.id))
                if swapped is not None and swapped == halves.get(str(machine)):
                    where = ctx.at("slips", swapped, "machines")
                    fix = "`blades: near` names them the other way round, by the ends at which their blades lie"
                else:
                    where, fix = _written(ctx, p.id), "give the pair a name of its own, for instance 201"
                ctx.add("IL2002", f"the machine of {p.id} bears the name of the point {machine}", where, fix)


def _written(ctx: Context, point: str) -> Span:
    """Where the machine of a point or derailer is written."""
    return ctx.at("derailers" if point in ctx.file.derailers else "points", point, "machine")
