"""The derivation as a visible order of steps.

Input: a `Layout`.  Output: an `InterlockingTable`; diagnostics
IL4001-IL4005, IL4010-IL4012, IL4016-IL4018, IL2007, IL2008, IL2019, IL2024, IL3012, IL3023, IL3049;
warnings IL7011, IL7014-IL7016, IL7019-IL7022.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from math import isinf

from interlock.derivation.added import demanded_clear, derive_barred, idle_barred, with_added
from interlock.derivation.beside import Beside
from interlock.derivation.conflicts import Conflicts
from interlock.derivation.idle import check_idle
from interlock.derivation.locking import (
    derive_approach,
    derive_aspect,
    derive_block,
    derive_closing,
    derive_conditions,
    derive_release,
    derive_speed,
    derive_token,
    derive_zones,
)
from interlock.derivation.locks import derive_locks, route_demands
from interlock.derivation.named import derive_automatic, derive_names
from interlock.derivation.own_train import check_own_train
from interlock.derivation.practice import check_practice
from interlock.derivation.protecting import check_protecting
from interlock.derivation.reached import check_reached
from interlock.derivation.routes import Path, find_routes
from interlock.derivation.runaways import check_runaways, check_signals_alone
from interlock.derivation.shown import check_shown
from interlock.derivation.starts import check_starts
from interlock.derivation.through import check_through
from interlock.derivation.voyages import derive_voyages
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import BufferKind, RouteId, SectionId, SignalId
from interlock.model.foul import foul_joints
from interlock.model.layout import Layout
from interlock.model.overlap import ends_short, entry_speed, wanted_m
from interlock.model.traversal import topology
from interlock.table.cells import Because, ClearCell, FoulCell, OverlapCell, PointDemand, RouteKind, TraversalKey
from interlock.table.rows import (
    InterlockingTable,
    RouteClear,
    RouteConditions,
    RouteLocking,
    RoutePath,
    RouteRow,
    RouteSignal,
    TraversalRow,
)

LONG_ROUTE = 3  # sections; document B 2.2


def _cannot_swing(layout: Layout, swinging: Collection[SignalId], sink: Sink) -> None:
    """IL4009, for overlaps that shall swing, but have no second way."""
    for o in layout.overlaps.all:
        if o.swing and o.signal not in swinging:
            text = f"the overlap of {o.signal} cannot swing: not every way to {o.signal} permits two alternatives of it"
            sink.add(
                "IL4009",
                text,
                None,
                f"remove `swing: yes` of {o.signal}, or give its overlap a second way",
                about=Element("overlaps", o.signal),
            )


_Way = tuple[SignalId, RouteKind, str, int, RouteId | None]


def derive(layout: Layout, sink: Sink) -> InterlockingTable:
    """The interlocking table of a layout."""
    paths = find_routes(layout, sink)
    if sink.has("IL3049"):
        return InterlockingTable(layout.name, layout.digest, (), ())
    locks = derive_locks(layout, paths, sink)
    by_key = {t.key: t for t in locks}
    demands = with_added(layout, paths, {p.id: route_demands(p, by_key) for p in paths}, sink)
    barred, asked_clear = derive_barred(layout, paths, sink), demanded_clear(layout, paths, sink)
    swinging = _swinging(layout, paths, sink)
    hostile = Conflicts(layout, paths, by_key, demands, barred)
    _apart(paths, hostile, sink)
    idle_barred(layout, paths, hostile.derived, sink)
    fouls = {p.id: _foul(p, by_key, demands[p.id]) for p in paths}
    beside = Beside(layout, paths, demands, fouls, hostile.bits)
    names, hidden = _named(layout, paths, sink)
    _notes(layout, paths, sink)
    rows = tuple(
        RouteRow(
            id=p.id,
            number=p.number,
            kind=p.kind,
            names=names.get(p.id, ()),
            entry=p.entry,
            exit=p.exit,
            path=_path(p),
            locking=RouteLocking(
                points=demands[p.id],
                driven=beside.driven[p.id],
                flank=tuple(dict.fromkeys(c for t in (*p.ways, *p.overlap) for c in by_key[t.key].flank)),
                hostile=hostile.of(p),
                barred=barred.get(p.id, ()),
                overlap=_overlap(layout, p, swinging),
                approach=derive_approach(layout, p),
                release=derive_release(layout, p),
            ),
            clear=RouteClear(
                sections=_clear(layout, p),
                foul=fouls[p.id],
                space=tuple(dict.fromkeys(c for t in (*p.ways, *p.overlap) for c in by_key[t.key].space)),
                demanded=asked_clear.get(p.id),
            ),
            conditions=_conditions(layout, p, swinging),
            signal=_signal(layout, p),
            listed=_way(p) not in hidden,
            because=Because("R1", _found(layout, p)),
        )
        for p in paths
    )
    _never_set(layout, paths, rows, by_key, sink)
    voyages, automatic = derive_voyages(layout, rows, by_key, sink), derive_automatic(layout, paths, sink)
    check_practice(layout, paths, by_key, sink)
    check_protecting(layout, demands, by_key, sink)
    check_runaways(layout, paths, demands, sink)
    check_signals_alone(layout, rows, sink)
    check_through(layout, paths, hostile, voyages, sink)
    _check_rows(layout, rows, sink)
    beside.report(sink)
    return InterlockingTable(layout.name, layout.digest, rows, locks, voyages, automatic)


def _check_rows(layout: Layout, rows: Sequence[RouteRow], sink: Sink) -> None:
    check_shown(layout, rows, sink)
    check_starts(layout, rows, sink)
    check_idle(layout, rows, sink)


def _path(p: Path) -> RoutePath:
    onward = p.onward
    return RoutePath(
        entry_node=p.entry_node,
        exit_kind=p.exit_kind,
        variant=p.variant,
        traversals=tuple(t.key for t in p.ways),
        berth=p.berth,
        length=sum(t.length for t in p.run),
        onward=None if onward is None else onward.id,
        destination=None if onward is None else p.parts[-1].exit,
        passed=None if onward is None else tuple(q.entry for q in p.parts[1:]),
    )


def _conditions(layout: Layout, p: Path, swinging: Mapping[SignalId, tuple[int, ...]]) -> RouteConditions:
    swings = swinging.get(SignalId(p.exit), ()) if p.overlap else ()
    return RouteConditions(
        external=derive_conditions(layout, p, swings),
        zones=derive_zones(layout, p),
        block=derive_block(layout, p),
        token=derive_token(layout, p),
    )


def _signal(layout: Layout, p: Path) -> RouteSignal:
    return RouteSignal(
        aspect=derive_aspect(layout, p), closing=derive_closing(layout, p), speed=derive_speed(layout, p)
    )


def _named(layout: Layout, paths: Sequence[Path], sink: Sink) -> tuple[Mapping[RouteId, tuple[str, ...]], set[_Way]]:
    """The names of routes, and what the author does not have printed."""
    names = derive_names(layout, paths, sink)
    return names, {_way(p) for p in paths if set(names.get(p.id, ())) & set(layout.declared.unlisted)}


def _way(p: Path) -> _Way:
    """What the routes have in common that differ in their overlaps alone."""
    return p.entry, p.kind, p.exit, p.variant, None if p.onward is None else p.onward.id


def _found(layout: Layout, p: Path) -> str:
    if p.onward is None:
        return f"found from {p.entry} to {_end(layout, p)}"
    past = " and ".join(q.entry for q in p.parts[1:])
    return f"found from {p.entry} past {past} to {_end(layout, p.parts[-1])}"


def _apart(paths: Sequence[Path], hostile: Conflicts, sink: Sink) -> None:
    """IL4015: parts of one route that exclude each other."""
    for p in paths:
        whys = [(q.entry, why) for q in p.parts[1:] if (why := hostile.between_parts(p, q)) is not None]
        for past, why in whys[:1]:
            text = f"route {p.id} cannot be set: before and past {past} it is hostile to itself: {why}"
            last = p.parts[-1]
            barred = f"{{from: {p.entry}, to: {last.exit}, via: [{last.ways[-1].section}], reason: ...}}"
            fix = f"exclude it: `exclude: [{barred}]`"
            sink.add("IL4015", text, None, fix, about=Element("signals", past))


def _clear(layout: Layout, path: Path) -> tuple[ClearCell, ...]:
    """The sections that must be reported clear; a call-on passes over those in which nothing can stand unlocked."""
    out = []
    for i, t in enumerate(path.ways):
        why = f"{t.section} lies on the path"
        if path.kind is RouteKind.CALL_ON:
            if i == 0:
                why = f"{t.section} is the first section: the train that is called on closes the signal there"
            elif t.section in topology(layout).berths:
                why = f"vehicles may stand in {t.section}"
            else:
                continue
        if t.section != path.berth:
            out.append(ClearCell(t.section, Because("R2" if path.kind is RouteKind.CALL_ON else "R3", why)))
    return tuple(out)


def _swinging(layout: Layout, paths: tuple[Path, ...], sink: Sink) -> dict[SignalId, tuple[int, ...]]:
    """The alternatives of each overlap that may swing: those that every path to its signal permits (R4)."""
    common: dict[SignalId, dict[tuple[object, ...], set[int]]] = {}
    swing = {o.signal for o in layout.overlaps.all if o.swing}
    for p in paths:
        g = SignalId(p.exit)
        if p.overlap and g in swing:
            way = (p.entry, p.kind, tuple(t.key for t in p.ways))
            common.setdefault(g, {}).setdefault(way, set()).add(p.option)
    found = {g: tuple(sorted(set.intersection(*ways.values()))) for g, ways in common.items()}
    swinging = {g: options for g, options in found.items() if len(options) > 1}
    _cannot_swing(layout, swinging, sink)
    return swinging


def _overlap(layout: Layout, path: Path, swinging: Mapping[SignalId, tuple[int, ...]]) -> OverlapCell | None:
    if not path.overlap:
        return None
    metres = sum(t.length for t in path.overlap)
    over = ", ".join(t.section for t in path.overlap)
    kmh = entry_speed(layout, SignalId(path.exit), path.overlap)
    made = "" if kmh is None else f", made for {kmh} km/h"
    short = ends_short(layout, SignalId(path.exit), path.overlap)
    wanted = wanted_m(layout, SignalId(path.exit), path.overlap)
    to = "the next joint" if short is None else f"{short}, where the layout ends, of {wanted:g} m that are stated"
    why = Because("R4", f"a train may overrun {path.exit} over {over}: {metres:g} m to {to}{made}")
    if isinf(layout.overlaps.length[SignalId(path.exit)]):
        why = Because("R2", f"successive route: a train that does not stop before {path.exit} runs on over {over}")
    swings = tuple(k for k in swinging.get(SignalId(path.exit), ()) if k != path.option)
    return OverlapCell(SignalId(path.exit), path.option, swings, tuple(t.key for t in path.overlap), metres, why)


def _foul(
    path: Path, locks: Mapping[TraversalKey, TraversalRow], demands: Sequence[PointDemand]
) -> tuple[FoulCell, ...]:
    """What must be clear of the route beside it.  What lies across it on a diamond, or beside a point that is not on
    the way, is left out where the route runs through that section, too, or holds the point that leads away."""
    ways = (*path.ways, *path.overlap)
    own, held = {t.section for t in ways}, {(d.machine, d.position) for d in demands}
    cells = dict.fromkeys(c for t in ways for c in locks[t.key].foul)

    def settled(c: FoulCell) -> bool:
        return c.section in own or (c.when is not None and (c.when[0], c.when[1].other) in held)

    left = [c for c in cells if c.crossing is None or not settled(c)]
    asked = {(c.section, c.when) for c in left if c.crossing is None}
    beside = {(c.section, c.when): c for c in reversed(left) if (c.section, c.when) not in asked}  # the first of each
    return tuple(c for c in left if c.crossing is None or beside.get((c.section, c.when)) is c)


def _end(layout: Layout, p: Path) -> str:
    """What stands where a route ends, with its name."""
    if p.exit not in layout.signalling.boards:
        return called(str(p.exit_kind), p.exit)
    return called("stop board" if p.exit in layout.signalling.stops else "limit-of-shunt board", p.exit)


def _never_set(
    layout: Layout,
    paths: Sequence[Path],
    rows: Sequence[RouteRow],
    locks: Mapping[TraversalKey, TraversalRow],
    sink: Sink,
) -> None:
    """Routes that something of their own keeps from being set, a joint or their train, and those without a train."""
    check_reached(layout, paths, sink)
    _foul_themselves(rows, sink)
    _foul_of_unseen(layout, rows, sink)
    check_own_train(layout, rows, locks, sink)


def _foul_themselves(rows: Sequence[RouteRow], sink: Sink) -> None:
    """Joints that are foul of a route and begin a section of the very same."""
    found: dict[tuple[str, str], list[RouteRow]] = {}
    for r in rows:
        for c in r.clear.foul:
            if c.section in r.path.section_ids:
                found.setdefault((c.because.text, c.section), []).append(r)
    for (why, section), those in found.items():
        many = "s" if len(those) > 1 else ""
        text = f"{why}, and {section} is on the path of route{many} {', '.join(r.id for r in those)}"
        barred = dict.fromkeys(
            f"{{from: {r.entry}, to: {r.exit}, via: [{', '.join(r.path.section_ids)}], reason: ...}}" for r in those
        )
        fix = f"move the joint out of the fouling point, or exclude the route{many}: `exclude: [{', '.join(barred)}]`"
        sink.add("IL4002", text, None, fix, about=Element("sections", section))


def _foul_of_unseen(layout: Layout, rows: Sequence[RouteRow], sink: Sink) -> None:
    """Joints that are foul of a route and begin a section without detection, which is never reported clear."""
    found: dict[tuple[str, SectionId], list[str]] = {}
    for r in rows:
        for c in r.clear.foul:
            if c.when is None and c.section in layout.track.undetected and c.section not in r.path.section_ids:
                found.setdefault((c.because.text, c.section), []).append(r.id)
    for (why, section), ids in found.items():
        joint = next((f for f in foul_joints(layout) if f.neighbour == section and why.endswith(f.name)), None)
        far = "" if joint is None else f", {joint.distance:g} m from it, where {joint.needed:g} m are needed"
        fix = f"move the joint out of the fouling point{'' if joint is None else f', to {joint.needed:g} m'}, or have "
        text = (
            f"{why}{far}, and {section} has no detection, so that it always counts as occupied: route"
            f"{'s' if len(ids) > 1 else ''} {', '.join(ids)} can never be set"
        )
        sink.add("IL4002", text, None, f"{fix}{section} detected", about=Element("sections", section))


def _notes(layout: Layout, paths: tuple[Path, ...], sink: Sink) -> None:
    topo = topology(layout)
    used = {t.section for p in paths for t in (*p.ways, *p.overlap)}
    used |= {b for p in paths if (b := topo.beyond(p.ways[0].section, p.entry_node)) is not None}
    traps = [b.node for b in layout.track.buffers if b.kind is BufferKind.TRAP]
    used |= {layout.track.section_of(e.id) for n in traps for e in layout.track.edges_at[n]}
    by_hand = [
        layout.track.far(p.reverse, p.node) for p in layout.pointwork.points if p.machine in layout.machines.by_hand
    ]
    used |= {layout.track.section_of(e.id) for n in by_hand for e in layout.track.edges_at[n]}
    for s in layout.track.sections:
        if not s.approach and s.id not in used:
            fix = "add a signal, or check the directions; where vehicles are moved by hand: `allow`, with a reason"
            text, at = f"no route uses {called('section', s.id)}", Element("sections", s.id)
            sink.add("IL3012", text, None, fix, about=at, cause="unused", note=str(s.id))
    for p in paths:
        if layout.profile == "mine" and len(p.ways) > LONG_ROUTE:
            sink.add(
                "IL4004",
                f"route {p.id} has {len(p.ways)} sections; document B finds three usual",
                None,
                "an intermediate signal would let trains follow more closely",
                about=Element("signals", p.entry),
                cause="long",
                note=f"{p.id}: {len(p.ways)}",
            )
