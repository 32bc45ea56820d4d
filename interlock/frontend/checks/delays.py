"""Delays that are shorter than the world needs, overlaps that cannot swing in time (R4, R8, R16).  IL3023, IL3024,
IL3035, IL3044."""

from __future__ import annotations

from math import ceil, floor

from interlock.diag import Element
from interlock.frontend.context import Context
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.model.needs import before, needs, standing_s, told_at, turning_s
from interlock.model.overlap import overlap_length
from interlock.model.times import overlap_release_s, tenths, whole_ms

OTHERWISE = {
    "restart_delay_s": "",
    "point_supervision_s": ", or a shorter `point_run_s` if the machines run so fast",
    "token_delay_s": ", or a shorter `token_agreed_s` if that was agreed",
}
"""What else may be changed, where that is no speed."""


def check_delays(ctx: Context, layout: Layout) -> None:
    """Compare what the principles order with what speeds, braking and reaction need; the claim D-PRESET does it too."""
    rules, least = layout.principles, needs(layout)
    why = f"{rules.output_delay_s:g} s until stop is seen, {rules.reaction_s:g} s of reaction, and braking"
    halt = "until whatever ran at a power cut stands at a signal at stop: the longest way to one"
    halt += f", at half of {rules.line_speed_kmh:g} km/h"
    _signals(ctx, layout)
    _released_early(ctx, layout)
    _made_for_less(ctx, layout)
    timed = dict(layout.signalling.releases)
    trains = [least.stop[g.id] for g in layout.signalling.signals if g.main and g.id not in timed]
    shunts = [least.shunt for g in layout.signalling.signals if g.shunt and g.id not in timed][:1]
    own_times = dict(layout.overlaps.releases)
    overlapped = [least.stand[o.signal] for o in layout.overlaps.all if o.length and o.signal not in own_times]
    tokens = [least.agreed for b in layout.track.boundaries if b.block == "token"]
    ordered = (
        ("approach_release_s", trains, f"until a train that saw proceed stands or has passed: {why}"),
        ("shunt_release_s", shunts, f"until a shunting movement that saw proceed stands or has passed: {why}"),
        ("overlap_release_s", overlapped, f"until a train before the signal stands: {why}"),
        ("restart_delay_s", [least.restart], f"{halt}, {why}"),
        ("point_supervision_s", [least.run] if layout.pointwork.points else [], "for a machine to run"),
        ("token_delay_s", tokens, "as agreed with the neighbour"),
    )
    for name, found, words in ordered:
        own = float(getattr(rules, name))
        need = max(found, default=0)
        if whole_ms(own) < need:
            spoken = "principles" in ctx.file.model_fields_set
            wanted = f"{name}: {-(-need // 1000)}"
            slower = OTHERWISE.get(name, ", or the lower speeds that are run there")
            ctx.add(
                "IL3023",
                f"{name} is {own:g} s, and {tenths(need)} s are needed {words}",
                ctx.at_key(*ctx.stated(name)),
                f"state {f'`{wanted}` under `principles`' if spoken else f'`principles: {{{wanted}}}`'}{slower}",
            )
    for g, own in layout.overlaps.releases:
        if whole_ms(own) < least.stand[g]:
            needed = f"{tenths(least.stand[g])} s are needed until a train before it stands: {why}"
            at_least = f"state at least {-(-least.stand[g] // 1000)} s, or the lower speed that is run before {g}"
            ctx.add(
                "IL3023",
                f"the overlap of {g} is released after {own:g} s, and {needed}",
                ctx.at_key("overlaps", g),
                at_least,
            )
    for m, own in layout.pointwork.supervision:
        if whole_ms(own) < least.run:
            text = f"the supervision of {m} is {own:g} s, and {tenths(least.run)} s are needed for a machine to run"
            room = "level_crossings" if m in ctx.file.level_crossings else "interlocks"
            where = Element("points", layout.machines.ends[m][0].id) if m in layout.machines.ends else Element(room, m)
            ctx.sink.add("IL3023", text, None, f"state at least {-(-least.run // 1000)} s", about=where)
    for o in layout.overlaps.all:
        if o.swing and o.signal not in least.swings:
            why, fix = _not_in_time(layout, o.signal)
            text = f"the overlap of {o.signal} cannot swing: {why}"
            ctx.add("IL3024", text, ctx.at_key("overlaps", o.signal), f"give up `swing`, {fix}")


def _released_early(ctx: Context, layout: Layout) -> None:
    """Overlaps that are given up while the fastest train still runs to the signal: it is in the section before it for
    longer than their release takes."""
    for o in layout.overlaps.all:
        g = o.signal
        own, need = overlap_release_s(layout, g), standing_s(layout, g) if o.length else 0.0
        if own < need:
            way = before(layout, g)
            assert way is not None  # a train runs there
            text = f"the overlap of {g} is released after {own:g} s, while even the fastest train still runs to {g}: "
            text += f"at {way.kmh:g} km/h it takes {tenths(whole_ms(need))} s from coming into {way.section} "
            text += f"to standing before {g}"
            at = ("overlaps", g) if g in ctx.file.overlaps else ctx.stated("overlap_release_s")
            fix = f"state `overlaps: {{{g}: {{release_by_length: yes}}}}`, or a `release` of at least {ceil(need)} s"
            ctx.add("IL3035", text, ctx.at_key(*at), fix)


def _made_for_less(ctx: Context, layout: Layout) -> None:
    """Overlaps whose length follows from a lower speed than trains come at: it limits nothing of what is shown."""
    for g, spec in ctx.file.overlaps.items():
        way = (
            before(layout, SignalId(g)) if spec.speed is not None and layout.overlaps.length.get(SignalId(g)) else None
        )
        kmh = spec.speed or 0
        if way is None or way.kmh <= kmh or spec.length is not None or spec.successive:
            continue
        metres = overlap_length(way.kmh, spec.falling)
        ctx.add(
            "IL3044",
            f"the overlap of {g} has the length for {kmh:g} km/h, and trains may come to {g} at {way.kmh:g} km/h, "
            f"for which {metres:g} m would be asked",
            ctx.at("overlaps", g, "speed"),
            f"state `speed: {way.kmh:g}`, the speed that is run in {way.section} (`sections`), or `entry_speed`, which "
            "no train is shown more than",
        )


def _not_in_time(layout: Layout, g: SignalId) -> tuple[str, str]:
    """Why a train could meet points of an overlap that swings while they turn, and what else helps."""
    rules = layout.principles
    if rules.point_start_gap_s > 0:
        return (
            f"machines start one after the other, {rules.point_start_gap_s:g} s apart, so that its points may begin to "
            "turn when a train has come into the section before the signal",
            "or state `point_start_gap_s: 0` in `principles`, where the supply bears that all machines start at once",
        )
    way, turning = before(layout, g), turning_s(layout, g)
    assert way is not None  # an overlap lies beyond a signal inside the layout
    kmh, metres = floor(way.metres / turning * 3.6), ceil(way.kmh / 3.6 * turning)
    slower = f"state {kmh} km/h or less for {way.section} (`sections`), " if kmh >= 5 else ""
    return (
        f"a train runs through the {way.metres:g} m of {way.section} before it at {way.kmh:g} km/h in "
        f"{floor(10 * way.seconds) / 10:g} s, and its machines may turn for {turning:g} s",
        f"{slower}let it be {metres} m or longer, or shorten their supervision (`point_supervision_s`, or their own)",
    )


def _signals(ctx: Context, layout: Layout) -> None:
    """Times of single signals, each against what whoever obeys it needs; no train obeys one where trains only end."""
    least, rules = needs(layout), layout.principles
    for g, own in layout.signalling.releases:
        signal = layout.signalling.signal[g]
        trains = least.stop[g] if signal.main and g not in layout.signalling.stops else 0
        need = max(trains, least.shunt if signal.shunt else 0)
        if whole_ms(own) < need:
            until = f"{tenths(need)} s are needed until whoever saw proceed stands or has passed"
            why = f"{rules.output_delay_s:g} s until stop is seen, {rules.reaction_s:g} s of reaction, and braking"
            why += f" from {told_at(layout, g):g} km/h, the highest speed in its approach" if need == trains else ""
            text = f"the routes of {g} are held for {own:g} s, and {until}: {why}"
            fix = f"state at least {-(-need // 1000)} s, or the lower speed that is run on the way to {g}"
            ctx.add("IL3023", text, ctx.at("signals", g, "release"), fix)
