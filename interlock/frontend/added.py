"""What the author adds to the derivation: hostile routes, points that routes demand, routes that are not printed.

Input: the file and its wiring.  Output: elements of the layout; IL2001 and the codes of unknown signals, ends and
sections.  Whether an addition fits any route, and whether it contradicts one, is known after derivation.
"""

from __future__ import annotations

from collections.abc import Mapping

from interlock.diag.suggest import did_you_mean
from interlock.frontend.context import Context
from interlock.frontend.ports import Wiring
from interlock.frontend.resolve import resolve_choice
from interlock.model.elements import Barred, Demanded, MachineId, Position


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


def resolve_demanded(ctx: Context, wiring: Wiring) -> tuple[Demanded, ...]:
    """Points that routes demand, in the order in which they are written."""
    devices = {n: MachineId(n) for n in (*ctx.file.level_crossings, *ctx.file.interlocks)}
    halves = {b.point for b in wiring.blades}  # of slips: named by what lays them, which may lay all of it
    machines: Mapping[str, MachineId] = {
        p.machine if p.id in halves else p.id: p.machine for p in wiring.points
    } | devices
    out = []
    for i, x in enumerate(ctx.file.demand):
        if not machines and ctx.sink.has_errors:
            continue  # there is no graph yet
        if x.point not in machines:
            text = f"a demand names {x.point}, which is no point, half of a slip, level crossing or other interlock"
            ctx.add("IL2001", text, ctx.at("demand", i, "point"), did_you_mean(x.point, machines))
            continue
        routes = resolve_choice(ctx, wiring, x.routes, ("demand", i, "routes"), "a demand")
        position = Position.NORMAL if x.lies == "normal" else Position.REVERSE
        out.append(Demanded(machines[x.point], position, routes, x.reason))
    return tuple(out)


def unlisted(ctx: Context) -> tuple[str, ...]:
    """Names of routes that are not printed."""
    return tuple(sorted(name for name, x in ctx.file.routes.items() if not x.listed))


def named_kinds(ctx: Context) -> tuple[tuple[str, bool | None], ...]:
    """Names of routes of which the kind is stated: whether it is a shunt route; None: a call-on route."""
    shunt = {"main": False, "shunt": True, "call-on": None}
    return tuple((name, shunt[x.kind]) for name, x in sorted(ctx.file.routes.items()) if x.kind is not None)
