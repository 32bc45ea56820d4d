"""Overlaps (R4): how long each is, for which speed it is made, over which ways it differs, and when it is released."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial

from pydantic_core import PydanticCustomError

from interlock.diag import Span
from interlock.diag.suggest import did_you_mean
from interlock.frontend.context import Context
from interlock.frontend.mistaken import for_a_section, for_an_end_or_section
from interlock.frontend.ports import Wiring
from interlock.frontend.schema import OverlapSpec, OverlapWaySpec
from interlock.model.elements import EdgeId, Overlap, OverlapWay, SectionId, Signal, SignalId
from interlock.model.layout import Layout
from interlock.model.needs import exact_m, needs
from interlock.model.overlap import stand_s
from interlock.model.principles import Principles
from interlock.model.signalling import Overlaps
from interlock.model.traversal import topology

ENDS = frozenset({"toe", "normal", "reverse", "1a", "1b", "2a", "2b", "outer", "inner"})
"""Ends of points, slips, crossings and derailers: each is that of an edge."""
LONGEST_M = 2000
"""Metres of an overlap at most."""


def resolve_overlaps(ctx: Context, principles: Principles, signals: tuple[Signal, ...], wiring: Wiring) -> Overlaps:
    """The overlap of each main signal inside the layout: stated, or as the principle says."""
    inside = {g.id for g in signals if g.main and g.node not in {b.node for b in wiring.boundaries}}
    stated: dict[str, float] = {}
    ways: list[OverlapWay] = []
    for name, spec in ctx.file.overlaps.items():
        if name not in inside:
            what, fix = "does not exist", str(did_you_mean(name, inside))
            if name in ctx.file.signals:
                what, fix = (
                    "stands at a boundary, or is no main signal",
                    "remove it: no main route leads to this signal",
                )
            text = f"an overlap lies beyond a main signal inside the layout: {name} {what}"
            ctx.add("IL2006", text, ctx.at_key("overlaps", name), fix)
            continue
        metres = _metres(ctx, name, spec)
        if metres is not None:
            stated[name] = metres
            ways += _ways(ctx, name, spec, wiring)
    lengths = {g: stated.get(g, principles.overlap_m) for g in sorted(inside)}
    swing = {g for g in stated if ctx.file.overlaps[g].swing}
    entry = ((SignalId(g), v) for g in sorted(stated) if (v := ctx.file.overlaps[g].entry_speed) is not None)
    ways.sort(key=lambda w: w.signal)  # of one signal they stay in the order in which they are stated
    overlaps = tuple(Overlap(SignalId(g), x, g in swing) for g, x in lengths.items() if x > 0)
    bars = {b for g in stated for b in _bars(ctx, SignalId(g), wiring)}
    return Overlaps(overlaps, tuple(ways), tuple(sorted(bars)), tuple(entry))


def _bars(ctx: Context, g: SignalId, wiring: Wiring) -> Iterator[tuple[SignalId, SectionId | EdgeId]]:
    """The sections, and the ends of points, slips, crossings and derailers, over which no alternative shall lead."""
    ends = {str(e.id) for e in wiring.edges if e.id.rpartition(".")[2] in ENDS}
    for i, x in enumerate(ctx.file.overlaps[g].not_over):
        if x in ends:
            yield g, EdgeId(x)
        elif x in wiring.sections:
            yield g, SectionId(x)
        else:
            known = {*ends, *wiring.sections}
            what = f"{x} is no section, and no end of a point, slip, crossing or derailer"
            hint = did_you_mean(x, known, of_another_kind=partial(for_an_end_or_section, ctx.file))
            ctx.add("IL2003" if "." in x else "IL2004", what, ctx.at("overlaps", g, "not_over", i), hint)


def _metres(ctx: Context, name: str, spec: OverlapSpec) -> float | None:
    """The length of an overlap, or None where something is wrong."""
    at = ctx.at_key("overlaps", name)
    try:
        metres = spec.metres()
    except PydanticCustomError as error:
        _no_number(ctx, ("overlaps", name, "length"), error)
        return None
    said = [spec.length is not None, spec.speed is not None, spec.successive]
    follows = spec.entry_speed is not None and not any(said)
    if sum(said) > 1:
        those = " and ".join(f"`{k}`" for k, x in zip(("length", "speed", "successive"), said, strict=True) if x)
        text = f"overlaps.{name}: {those} each say how far the overlap goes"
        ctx.add("IL1014", text, at, "leave one of them, and remove the rest")
        return None
    if metres > LONGEST_M and not spec.successive and spec.length is None:
        _too_long(ctx, f"overlaps.{name}", spec, metres, at)
        return None
    if (sum(said) != 1 and not follows) or not (spec.successive or 0 <= metres <= LONGEST_M):
        ctx.add(
            "IL1014",
            f"overlaps.{name}: give a length of 0 to 2000 m, or a speed, or `successive: yes`",
            at,
            "for instance `{length: 180}`, `{speed: 60, falling: 5}` or `{successive: yes}`",
        )
        return None
    if metres == 0 and spec.length is None:
        rise = f"overlaps.{name}: for a rise of {-spec.falling:g} permille nothing is left of the length"
        ctx.add("IL1014", rise, at, "state the `length`; for no overlap at all: `length: 0`")
        return None
    if metres == 0 and (spec.swing or spec.ways or spec.entry_speed or spec.release or spec.release_by_length):
        empty = [k for k in ("swing", "ways", "entry_speed", "release", "release_by_length") if getattr(spec, k)]
        text = f"overlaps.{name}: there is no overlap of 0 m that could have `{empty[0]}`"
        ctx.add("IL1014", text, at, f"state its length, or remove `{'`, `'.join(empty)}`")
        return None
    if spec.falling and (spec.length is not None or spec.successive):
        _falls_beside(ctx, f"overlaps.{name}", at)
        return None
    shown = spec.entry_speed or 0
    if spec.speed is not None and shown > spec.speed:
        ctx.add(
            "IL1014",
            f"overlaps.{name}: the length follows from {spec.speed:g} km/h, and trains are shown up to {shown}",
            at,
            "remove `speed`: the length then follows from `entry_speed`; or state an `entry_speed` of no more",
        )
        return None
    if spec.swing and (spec.ways or spec.entry_speed):
        ctx.add(
            "IL1014",
            f"overlaps.{name}: an overlap with a speed, or with `ways` of its own, does not swing: the signal in rear "
            "would have to show another speed",
            at,
            "remove `swing: yes`, or the speeds",
        )
        return None
    if spec.release is not None and spec.release_by_length:
        ctx.add("IL1014", f"overlaps.{name}: `release` and `release_by_length` are two times", at, "remove one of them")
        return None
    return metres


def _too_long(ctx: Context, what: str, spec: OverlapSpec | OverlapWaySpec, metres: float, at: Span) -> None:
    """Report a speed and a gradient from which no length of an overlap follows."""
    stated = getattr(spec, "speed", None)
    name, kmh = ("entry_speed", spec.entry_speed) if stated is None else ("speed", stated)
    made = f"from `{name}: {kmh:g}` and `falling: {spec.falling:g}` {metres:.0f} m follow, and an overlap has at most"
    fix = "correct the two: `falling` is in permille; or state the `length` in place of them"
    ctx.add("IL1014", f"{what}: {made} {LONGEST_M} m", at, fix)


def _falls_beside(ctx: Context, what: str, at: Span) -> None:
    """Report a gradient beside a length that does not follow from it."""
    ctx.add(
        "IL1014",
        f"{what}: `falling` counts only where the length follows from a speed",
        at,
        "remove it, or state the speed in place of the length: `speed`, or `entry_speed` alone",
    )


def _no_number(ctx: Context, path: tuple[str | int, ...], error: PydanticCustomError) -> None:
    """Report a length that cannot be read, with what was meant where that is plain."""
    said = error.context or {}
    fix = said.get("fix", "write metres as a plain decimal number, for instance 180")
    where = ".".join(map(str, path))
    ctx.add("IL1013", f"{where}: {error.message()}", ctx.at(*path), fix, cause=said.get("cause", ""), note=where)


def _ways(ctx: Context, name: str, spec: OverlapSpec, wiring: Wiring) -> list[OverlapWay]:
    out = []
    for i, way in enumerate(spec.ways):
        for k, s in enumerate(way.over):
            if s not in wiring.sections:
                at = ctx.at("overlaps", name, "ways", i, "over", k)
                hint = did_you_mean(s, wiring.sections, of_another_kind=partial(for_a_section, ctx.file))
                ctx.add("IL2004", f"there is no section {s}", at, hint)
        metres = _way_metres(ctx, name, i, way)
        if metres is not None:
            over = tuple(sorted(map(SectionId, way.over)))
            out.append(OverlapWay(SignalId(name), over, metres, way.entry_speed))
    return out


def _way_metres(ctx: Context, name: str, i: int, way: OverlapWaySpec) -> float | None:
    at = ctx.at("overlaps", name, "ways", i)
    try:
        metres = way.metres()
    except PydanticCustomError as error:
        _no_number(ctx, ("overlaps", name, "ways", i, "length"), error)
        return None
    if metres > LONGEST_M and way.length is None:
        _too_long(ctx, f"overlaps.{name}.ways", way, metres, at)
        return None
    if (way.length is None and way.entry_speed is None) or not 0 < metres <= LONGEST_M:
        ctx.add(
            "IL1014",
            f"overlaps.{name}.ways: give a length above 0, to 2000 m, or an `entry_speed`",
            at,
            "for instance `{over: [q7], length: 50, entry_speed: 40}`",
        )
        return None
    if way.falling and way.length is not None:
        _falls_beside(ctx, f"overlaps.{name}.ways", at)
        return None
    return metres


def with_releases(ctx: Context, layout: Layout) -> Layout:
    """The layout with the times of its own after which overlaps are released (R4)."""
    found = []
    for o in layout.overlaps.all:
        spec = ctx.file.overlaps.get(o.signal)
        if spec is not None and spec.release is not None:
            found.append((o.signal, spec.release))
        elif spec is not None and spec.release_by_length:
            found.append((o.signal, _by_length(layout, o.signal)))
    return replace(layout, overlaps=replace(layout.overlaps, releases=tuple(found))) if found else layout


def _by_length(layout: Layout, g: SignalId) -> float:
    """Seconds; a train that was shown an entry speed takes longer through the section before the signal."""
    signal, topo = layout.signalling.signal[g], topology(layout)
    before = topo.beyond(layout.track.section_of(signal.into), signal.node)
    assert before is not None  # the signal stands inside the layout
    ways = [t for t in topo.traversals[before] if t.exit == signal.node]
    metres = max((exact_m(layout, t) for t in ways), default=Fraction(0))
    there = layout.track.section[before].speed or layout.principles.line_speed_kmh
    shown = [v for h, v in layout.overlaps.entry_speeds if h == g]
    shown += [w.entry for w in layout.overlaps.ways if w.signal == g and w.entry is not None]
    kmh = min([there, *shown])
    return stand_s(metres, kmh, needs(layout).stand[g])
