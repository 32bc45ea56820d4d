"""Alternatives of overlaps that are stated and do not exist, or lie inside others, and overlaps of which none is left.

IL1014, IL2026, IL2027.  Those that a boundary or the end of a track cuts short: IL7012;
that take off a derailer beyond their length: IL3043.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import isfinite

from interlock.diag import Element
from interlock.frontend.context import Context
from interlock.model.elements import BufferKind, NodeId, OverlapWay, PointId, Position, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.overlap import (
    covered,
    ends_short,
    entry_speed,
    inside_others,
    overlap_paths,
    own_way,
    two_ways,
    wanted_m,
)
from interlock.model.too_many import TooManyWays
from interlock.model.traversal import Traversal, topology


def check_overlaps(ctx: Context, layout: Layout) -> None:
    """Report entries of `ways` that fit no alternative of their overlap, and of `not_over` that bar none, or all."""
    used = [own_way(layout, o.signal, ways) for o in layout.overlaps.all for ways in overlap_paths(layout, o.signal)]
    for g in ctx.file.overlaps:
        own = [w for w in layout.overlaps.ways if w.signal == g]
        inside = _inside(ctx, layout, SignalId(g), own)
        if own:
            _covered(ctx, layout, SignalId(g))
        for i, way in enumerate(own):
            if not any(way is x for x in used) and i not in inside:
                _unused(ctx, layout, own, i)
    for g in ctx.file.overlaps:
        _bars(ctx, layout, SignalId(g))
    for o in layout.overlaps.all:
        if _is_led_to(layout, o.signal):
            _ends_short(ctx, layout, o.signal)
        _takes_off(ctx, layout, o.signal)


def _is_led_to(layout: Layout, g: SignalId) -> bool:
    """Whether trains come to a signal, from a main signal in rear or over a boundary: not to one at which they start,
    on a track that ends behind them."""
    topo, signal = topology(layout), layout.signalling.signal[g]
    todo, seen = [(layout.track.section_of(signal.into), signal.node)], set[tuple[SectionId, NodeId]]()
    while todo:
        section, node = todo.pop()
        rear = topo.beyond(section, node)
        if rear is None:
            if node in layout.track.boundary_at:
                return True
            continue
        for t in topo.traversals[rear]:
            if t.exit == node and (rear, t.entry) not in seen:
                if (t.entry, rear) in topo.main_into:
                    return True
                seen.add((rear, t.entry))
                todo.append((rear, t.entry))
    return False


def _ends_short(ctx: Context, layout: Layout, g: SignalId) -> None:
    """Report a signal with alternatives that are held for fewer metres than stated, since the layout ends (IL7012)."""
    held: dict[str, tuple[float, float]] = {}  # by the end: metres, of those that are stated
    for ways in overlap_paths(layout, g):
        end = ends_short(layout, g, ways)
        if end is None or (end in layout.track.buffer_at and layout.track.buffer_at[end].kind is not BufferKind.STOP):
            continue
        found = (sum(t.length for t in ways), wanted_m(layout, g, ways))
        held[str(end)] = min(found, held.get(str(end), found))
    if held:
        kinds = {end: "buffer" if end in layout.track.buffer_at else "boundary" for end in held}
        told = (f"{x:g} of {wanted:g} m, as far as the {kinds[end]} {end}" for end, (x, wanted) in sorted(held.items()))
        said = g in ctx.file.overlaps
        stated = f"state the length that is there{'' if said else f': `overlaps: {{{g}: {{length: ...}}}}`'}"
        ctx.add(
            "IL7012",
            f"the overlap of {g} is held for {'; '.join(told)}: the layout ends there, and nothing is held beyond",
            ctx.at_key("overlaps" if said else "signals", g),
            f"let the layout go on as far as the overlap does, or {stated}",
            about=Element("signals", g),
        )


def _takes_off(ctx: Context, layout: Layout, g: SignalId) -> None:
    """Report derailers that are taken off for an overlap, beyond its length, since sections are held whole."""
    told = set[PointId]()
    for ways in overlap_paths(layout, g):
        wanted, run, at = wanted_m(layout, g, ways), 0.0, layout.signalling.signal[g].node
        for t in ways:
            off = {p for p, x in t.points if x is Position.REVERSE and layout.pointwork.point[p].derailer}
            for e in t.edges:
                run, at = run + layout.track.edge[e].length, layout.track.far(e, at)
                end = layout.pointwork.point_at.get(at)
                if end is None or end.id not in off - told or run < wanted:
                    continue
                told.add(end.id)
                ctx.add(
                    "IL3043",
                    f"the overlap of {g} is {wanted:g} m long, and the derailer {end.id} lies {run:g} m beyond {g}: it "
                    f"is taken off for the overlap, since {t.section} is held whole",
                    ctx.at_key("overlaps" if g in ctx.file.overlaps else "signals", g),
                    f"begin a new section between {wanted:g} and {run:g} m beyond {g}, so that the overlap ends there "
                    f"and {end.id} stays on",
                    about=Element("signals", g),
                )


def _inside(ctx: Context, layout: Layout, g: SignalId, own: Sequence[OverlapWay]) -> set[int]:
    """Report what is stated of alternatives all of which lie inside longer ones (IL2026); its places in `ways`."""
    left = [own_way(layout, g, ways) for ways in overlap_paths(layout, g)]
    found = set[int]()
    for short, long in inside_others(layout, g):
        way, longer = own_way(layout, g, short), own_way(layout, g, long)
        if any(way is x for x in left):
            continue
        left.append(way)
        places = [i for i, w in enumerate(own) if w is way]
        found.update(places)
        metres, onward = way.length if way is not None else layout.overlaps.length[g], long[len(short)].section
        only = f"bar the longer one: `not_over: [{onward}]`"
        if longer is not None:
            only = f"remove the longer one, over {', '.join(longer.over)}, from `ways`"
        ctx.add(
            "IL2026",
            f"the overlap of {g} of {metres:g} m over {', '.join(dict.fromkeys(t.section for t in short))} lies inside "
            f"a longer one of the same signal, which goes on over {onward}, and is not told apart from it: "
            f"{_not_apart(layout, g, short)}",
            ctx.at("overlaps", g, "ways", places[0]) if places else ctx.at_key("overlaps", g),
            f"to have both, {_to_have_both(layout, g, short)}; to have the longer one alone, give {g} its length and "
            f"speed; to have the short one alone, {only}",
        )
    return found


def _unused(ctx: Context, layout: Layout, own: Sequence[OverlapWay], i: int) -> None:
    """Report an entry of `ways` that counts for no alternative: an earlier one fits all of them, or there is none."""
    way = own[i]
    at = ctx.at("overlaps", way.signal, "ways", i)
    said = f"no overlap of {way.signal} of {way.length:g} m, to the next joint, leads over {', '.join(way.over)}"
    before = next((x for x in own[:i] if set(x.over) <= set(way.over)), None)
    if before is None:
        fix = "name sections that tell this way from the others, as near to the signal as possible"
    else:
        said = f"{said} alone: the entry over {', '.join(before.over)} stands before it and fits, too"
        fix = "of several entries that fit the first counts: state this one first, or leave one of them"
    ctx.add("IL1014", said, at, fix)


def _covered(ctx: Context, layout: Layout, g: SignalId) -> None:
    """Report a length of an overlap, or a speed, for which nothing is left, since entries of `ways` count (IL2027)."""
    own, kmh = layout.overlaps.length[g], dict(layout.overlaps.entry_speeds).get(g)
    what = f"the overlap of {g} of {own:g} m" if isfinite(own) else f"the successive overlap of {g}"
    for long, short in covered(layout, g)[:1]:
        way = own_way(layout, g, short)
        assert way is not None
        onward = long[len(short)].section if isfinite(own) else long[-1].section
        metres = min(own, sum(t.length for t in long), 2000.0) if not isfinite(own) else own
        ctx.add(
            "IL2027",
            f"{what} would never be held: {way.length:g} m count wherever it leads over {', '.join(way.over)}",
            ctx.at_key("overlaps", g),
            "to have a short one inside a long one, state the long one in `ways`, over the section into which it goes "
            f"on, `ways: [{{over: [{onward}], length: {metres:g}}}]`, and the short one as length and "
            f"`entry_speed` of {g}",
        )
        return
    if kmh is not None:
        _own_speed(ctx, layout, g, kmh, f"{what} for up to {kmh} km/h")


def _own_speed(ctx: Context, layout: Layout, g: SignalId, kmh: int, what: str) -> None:
    """Report an `entry_speed` of an overlap that counts for no alternative, since entries of `ways` fit all of them."""
    paths = overlap_paths(layout, g)
    counts = [w for p in paths if (w := own_way(layout, g, p)) is not None]
    if not paths or len(counts) < len(paths) or any(w.entry == kmh for w in counts):
        return
    last = max(i for i, t in enumerate(paths[0]) if t.section in counts[0].over)
    ends = f"to have a short one inside, give {g} a `length` that ends with {paths[0][last - 1].section}, before "
    ends = f"{ends}{paths[0][last].section}; otherwise " if last else ""
    ctx.add(
        "IL2027",
        f"{what} would never be held: every way of it leads over sections of which `ways` says something else",
        ctx.at_key("overlaps", g),
        f"{ends}remove its `entry_speed`",
    )


def _longer(layout: Layout, g: SignalId, short: tuple[Traversal, ...]) -> list[int]:
    """The speeds (km/h) for which the alternatives are made inside which one lies, as far as they are for any."""
    speeds = (entry_speed(layout, g, b) for a, b in inside_others(layout, g) if a == short)
    return [v for v in speeds if v is not None]


def _not_apart(layout: Layout, g: SignalId, short: tuple[Traversal, ...]) -> str:
    """Why nobody knows, of a train that overruns the signal, for which of the two it was called."""
    kmh = entry_speed(layout, g, short)
    if kmh is None:
        return "it has no `entry_speed`, by which drivers are told of it"
    if any(v <= kmh for v in _longer(layout, g, short)):
        return f"it is made for {kmh} km/h, the longer one for no more"
    if through := two_ways(layout, short):
        return f"two ways lead through {through[0]}, one of which may have fewer metres"
    return "another overlap of the signal comes to its sections on another way, which may have fewer metres"


def _to_have_both(layout: Layout, g: SignalId, short: tuple[Traversal, ...]) -> str:
    speeds = _longer(layout, g, short)
    kmh = entry_speed(layout, g, short)
    if kmh is None or any(v <= kmh for v in speeds):
        below = f" below {min(speeds)}" if speeds else ""
        return f"give the short one an `entry_speed`{below}"
    if through := two_ways(layout, short):
        return f"cut {through[0]} so that each way has a section of its own"
    return "bar the other one (`not_over`)"


def _bars(ctx: Context, layout: Layout, g: SignalId) -> None:
    for i, s in enumerate(ctx.file.overlaps[g].not_over):
        others = tuple(x for x in layout.overlaps.bars if x != (g, s))
        try:
            free = overlap_paths(replace(layout, overlaps=replace(layout.overlaps, bars=others)), g)
        except TooManyWays:
            continue  # with it there are no more than can be listed
        if not any(s in (t.section, *t.edges) for ways in free for t in ways):
            ctx.add(
                "IL1014",
                f"no overlap of {g} would lead over {s}: `not_over` bars nothing there",
                ctx.at("overlaps", g, "not_over", i),
                "remove it, or name what the unwanted way alone leads over",
            )
    if ctx.file.overlaps[g].not_over and g in layout.overlaps.length and not overlap_paths(layout, g):
        ctx.add(
            "IL1014",
            f"`not_over` leaves {g} no overlap: every way of that length leads over {_listed(layout, g)}",
            ctx.at("overlaps", g, "not_over"),
            "leave one way; for no overlap at all: `length: 0`",
        )


def _listed(layout: Layout, g: SignalId) -> str:
    return " or ".join(s for h, s in layout.overlaps.bars if h == g)
