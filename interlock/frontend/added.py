"""What the author adds to the derivation: hostile routes, points and clear sections that routes demand, routes that are
not printed.

Input: the file and its wiring.  Output: elements of the layout; IL2001, IL3034 and the codes of unknown signals, ends
and sections.  Whether an addition fits any route, and whether it contradicts one, is known after derivation.
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.diag.suggest import did_you_mean
from interlock.frontend.context import Context
from interlock.frontend.doors import demands_of_air_locks
from interlock.frontend.ports import Wiring
from interlock.frontend.resolve import no_section, resolve_choice
from interlock.frontend.schema import DemandSpec
from interlock.model.elements import Barred, Demanded, DemandedClear, MachineId, Position, SectionId


def resolve_barred(ctx: Context, wiring: Wiring) -> tuple[Barred, ...]:
    """Routes declared hostile, in the order in which they are written."""
    return tuple(
        Barred(
            resolve_choice(ctx, wiring, x.one, ("hostile", i, "one"), "a hostile route"),
            resolve_choice(ctx, wiring, x.other, ("hostile", i, "other"), "a hostile route"),
            x.reason,
        )
        for i, x in enumerate(ctx.file.hostile)
    )


def resolve_demanded(ctx: Context, wiring: Wiring) -> tuple[Demanded | DemandedClear, ...]:
    """Points and clear sections that routes demand, in the order in which they are written."""
    machines = _machines(ctx, wiring)
    out: list[Demanded | DemandedClear] = []
    for i, x in enumerate(ctx.file.demand):
        whole = (x.point is None) == (x.lies is None) and (x.point is None) != (x.clear is None)
        idle = x.clear is not None and x.hold > 0
        if not whole:
            text = f"a demand of {_named(x) or 'nothing'}: it takes a point and how it lies, or a section that is clear"
            fix = "write `point: 3, lies: normal`, or `clear: s7`; for both write two demands"
            ctx.add("IL3034", text, ctx.at("demand", i), fix)
        elif idle:
            text = (
                f"a demand of {x.clear} clear, held {x.hold:g} s longer: a section that is demanded clear is never held"
            )
            fix = "remove `hold`; where no other movement shall run over it meanwhile, demand a point, too"
            ctx.add("IL3034", text, ctx.at("demand", i, "hold"), fix)
        elif x.clear is not None and x.clear not in wiring.sections:
            no_section(ctx, wiring, x.clear, ctx.at("demand", i, "clear"), "a demand")
        elif x.clear is not None:
            routes = resolve_choice(ctx, wiring, x.routes, ("demand", i, "routes"), "a demand")
            out.append(DemandedClear(SectionId(x.clear), routes, x.reason))
        elif x.point is None or (not machines and ctx.sink.has_errors):
            continue  # there is no graph yet
        elif x.point not in machines:
            text = f"a demand names {x.point}, which is no point, half of a slip, level crossing or other interlock"
            ctx.add("IL2001", text, ctx.at("demand", i, "point"), did_you_mean(x.point, machines))
        else:
            routes = resolve_choice(ctx, wiring, x.routes, ("demand", i, "routes"), "a demand")
            position = Position.NORMAL if x.lies == "normal" else Position.REVERSE
            out.append(Demanded(machines[x.point], position, routes, x.reason, x.hold))
    return (*out, *demands_of_air_locks(ctx))


def _machines(ctx: Context, wiring: Wiring) -> Mapping[str, MachineId]:
    """What can be demanded, by the names of points and devices."""
    devices = {n: MachineId(n) for n in (*ctx.file.level_crossings, *ctx.file.interlocks)}
    halves = {b.point for b in wiring.blades}  # of slips: named by what lays them, which may lay all of it
    return {p.machine if p.id in halves else p.id: p.machine for p in wiring.points} | devices


def _named(x: DemandSpec) -> str:
    """What a demand names, in words."""
    return " and ".join(f"`{k}`" for k in ("point", "lies", "clear") if getattr(x, k) is not None)


def unlisted(ctx: Context) -> tuple[str, ...]:
    """Names of routes that are not printed."""
    return tuple(sorted(name for name, x in ctx.file.routes.items() if not x.listed))


def named_kinds(ctx: Context) -> tuple[tuple[str, bool | None], ...]:
    """Names of routes of which the kind is stated: whether it is a shunt route; None: a call-on route."""
    shunt = {"main": False, "shunt": True, "call-on": None}
    return tuple((name, shunt[x.kind]) for name, x in sorted(ctx.file.routes.items()) if x.kind is not None)
