"""What is said of flanks: those that nothing protects (IL4001), those that cannot be protected without a contradiction
(IL4002), those with substitute protection (IL4010), and waivers that waive nothing (IL2008).

Each place is named once, with all routes over it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from math import floor

from interlock.derivation.flank import Allowed, Options, Requester, next_point, over_lane, point_demands, told
from interlock.derivation.routes import Path
from interlock.derivation.settle import Place, Settlement
from interlock.diag import Element, Sink
from interlock.model.bits import chosen
from interlock.model.elements import EdgeId, MachineId, NodeId, PointId, Position, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import onward_edges, runaways
from interlock.table.cells import Provider

NAMED = 8  # so many routes are named, of more the number is told


def report_flanks(
    layout: Layout, paths: Sequence[Path], places: Sequence[Place], settled: Settlement, options: Options, sink: Sink
) -> None:
    """Every diagnostic of the flanks of a layout."""
    bare: dict[str, tuple[Requester, int]] = {}
    for p in places:
        if p.requester.waiver is None and options.preferred(p.requester) is None:
            bare[p.requester.name] = p.requester, bare.get(p.requester.name, (p.requester, 0))[1] | p.routes
    for name, (r, over) in sorted(bare.items()):
        there = "pass there" if over.bit_count() > 1 else "passes there"
        sink.add(
            "IL4001",
            f"nothing keeps vehicles away from {name}; {_routes(paths, over)} {there}",
            None,
            _remedy(layout, options, r, lambda m, x: True),
            about=_element(layout, r),
        )
    _impossible(layout, paths, settled, options, sink)
    _substitutes(layout, paths, settled, options, sink)
    unprotected = {p.requester.name for p in places if options.preferred(p.requester) is None}
    unprotected |= {settled.places[at].requester.name for at in settled.impossible}
    for w in layout.declared.waivers:
        name = f"{w.point}.{'normal' if w.leg is Position.NORMAL else 'reverse'}"
        if name not in unprotected:
            sink.add(
                "IL2008",
                f"the waiver of {name} waives nothing: it is protected, or no route passes there",
                None,
                "remove the waiver",
                about=Element("waive", name),
            )


def _impossible(layout: Layout, paths: Sequence[Path], settled: Settlement, options: Options, sink: Sink) -> None:
    found: dict[str, tuple[Requester, list[int]]] = {}
    for at in settled.impossible:
        r = settled.places[at].requester
        if r.waiver is None and options.preferred(r) is not None:
            found.setdefault(r.name, (r, []))[1].append(at)
    for name, (r, those) in sorted(found.items()):
        over, why, held = _contradicted(settled, those, options.preferred(r) or ())

        def allowed(m: MachineId, x: Position, those: list[int] = those) -> bool:
            return not any(by_path or others for by_path, others in (settled.against(at, m, x) for at in those))

        sink.add(
            "IL4002",
            f"{name} cannot be protected in {_routes(paths, over)}: {'; '.join(why) or 'all that could contradicts'}",
            None,
            _remedy(layout, options, r, allowed, held),
            about=_element(layout, r),
        )


def _contradicted(
    settled: Settlement, those: Sequence[int], usual: Sequence[Provider]
) -> tuple[int, dict[str, None], dict[MachineId, None]]:
    """Over which routes what would be usual at some places cannot be, as bits, why, and which machines the path needs
    otherwise."""
    over, why, held = 0, dict[str, None](), dict[MachineId, None]()
    for at in those:
        for m, x in (point_demands(usual) or {}).items():
            by_path, others = settled.against(at, m, x)
            if by_path:
                why[f"{m} would have to lie {x}, and lies {x.other} on the path"] = None
                held[m] = None
            names = sorted({settled.places[q].requester.name for q in others})
            if names:
                why[f"{m} would have to lie {x}, and lies {x.other} for {', '.join(names)}"] = None
            for bits in (by_path, *others.values()):
                over |= bits
        over = over or settled.places[at].routes
    return over, why, held


def _element(layout: Layout, r: Requester) -> Element:
    """The point or crossing that asks for protection."""
    return Element("points" if r.node in layout.pointwork.point_at else "crossings", r.node)


def _substitutes(layout: Layout, paths: Sequence[Path], settled: Settlement, options: Options, sink: Sink) -> None:
    found: dict[tuple[str, tuple[Provider, ...]], tuple[int, dict[tuple[MachineId, Position], int]]] = {}
    asking = {settled.places[at].requester.name: settled.places[at].requester for at in settled.chosen}
    for at, option in settled.chosen.items():
        place = settled.places[at]
        usual = options.preferred(place.requester)
        if usual is None or option == usual or settled.partner_forbids(at, usual):
            continue
        over, why = found.get((place.requester.name, option), (0, {}))
        for m, x in (point_demands(usual) or {}).items():
            if (point_demands(option) or {}).get(m) is not x:
                why[m, x] = why.get((m, x), 0) | settled.wanting(at, m, x.other)
        found[place.requester.name, option] = over | place.routes, why
    for (name, option), (over, why) in sorted(found.items(), key=lambda f: (f[0][0], f[1][0])):
        said = [
            f"{m} {x}, which would be usual, is wanted {x.other} by {_routes(paths, those)}"
            for (m, x), those in why.items()
            if those
        ]
        because = "; ".join(said) or "another place needs what would be usual"
        text = f"{name} has substitute protection in {_routes(paths, over)}: {told(option)}; {because}"
        sink.add("IL4010", text, about=_element(layout, asking[name]))


def _routes(paths: Sequence[Path], over: int) -> str:
    names = sorted(p.id for p in chosen(over, paths))
    more = f" and {len(names) - NAMED} more" if len(names) > NAMED else ""
    return f"route{'s' if len(names) > 1 else ''} {', '.join(names[:NAMED])}{more}"


def _remedy(layout: Layout, options: Options, r: Requester, allowed: Allowed, held: Iterable[MachineId] = ()) -> str:
    """What would protect a place, each of it enough by itself.  `held`: machines that would, but for the path.

    No waiver is among it: what `derive` finds no protection for, T-FLANK and S-FLANK find a vehicle for."""
    said = [f"give {p} a machine of its own" for p in _worked_along(layout, r, frozenset(held))]
    lanes = _lanes(layout, r)
    said = [*_exchanged(layout, r), *said]
    if r.partner is not None and not lanes:
        return ", or ".join([*said, "exclude the routes over both: `exclude:`"])
    near = _too_near(layout, r)
    at = min(near.values(), default=0.0)
    if near and next(options.of(replace(r, clear_of=at), allowed), None) is not None:
        there = [
            f"{g} would do, but stands {gone:g} m away, and {r.clear_of:g} m are needed" for g, gone in near.items()
        ]
        said.append(f"{'; '.join(there)}: lengthen the track between")
        if (room := _room(layout, r, at)) is not None:
            point = PointId(r.name.partition(".")[0])
            slip = layout.pointwork.slip_of.get(point)
            key = f"points: {{{point}" if slip is None else f"slips: {{{slip}"
            said.append(f"state where the fouling point of {point} is, if no further: `{key}: {{fouling: {room:g}}}}}`")
    else:
        signal = f"a signal or stop board, {r.clear_of:g} m away or more, or "
        room = min(lanes.values(), default=r.clear_of) >= r.clear_of
        before = f", before the inclined lane{'s' * (len(lanes) > 1)} {' and '.join(lanes)}" if lanes else ""
        said.append(f"add {signal if room else ''}a derailer on each way that leads to {r.name}{before}")
    return ", or ".join(said)


def _room(layout: Layout, r: Requester, at: float) -> float | None:
    """How far from a point its fouling point may lie for a signal to stand clear of it, in whole centimetres; None of
    a diamond, and where the signal stands too near for any."""
    point = layout.pointwork.point.get(PointId(r.name.partition(".")[0]))
    if point is None or point.node != r.node:
        return None
    margin = layout.principles.clearance_m
    cm = floor((at - margin) * 100)
    room = cm / 100 if cm / 100 + margin <= at else (cm - 1) / 100
    return room if room > 0 else None


def _outward(layout: Layout, r: Requester) -> Iterator[tuple[EdgeId, NodeId, float]]:
    """The track outward from a requester, up to signals clear of it and the ends of inclined lanes: edges, their far
    ends, how far away those are."""
    todo: list[tuple[EdgeId, NodeId, float]] = [(r.edge, r.node, 0.0)]
    seen: set[tuple[EdgeId, NodeId]] = set()
    while todo:
        edge, node, gone = todo.pop()
        e, far = layout.track.edge[edge], layout.track.far(edge, node)
        if (edge, node) in seen or (e.nothing_comes_to(node) and (edge, node) not in runaways(layout)):
            continue
        seen.add((edge, node))
        gone += e.length
        yield edge, far, gone
        clear = (far, edge) in layout.signalling.facing and gone >= r.clear_of
        if far == r.node or far in layout.track.boundary_at or far in layout.track.buffer_at:
            continue
        lane = over_lane(layout, r, edge)
        onward = [x for x in onward_edges(layout, far, edge) if not lane or layout.track.section_of(x) == e.section]
        if lane or not clear:
            todo += [(x, far, gone) for x in onward]


def _too_near(layout: Layout, r: Requester) -> dict[SignalId, float]:
    """Signals that a vehicle towards a requester meets, none of them clear of the fouling point, in metres."""
    found: dict[SignalId, float] = {}
    for edge, far, gone in _outward(layout, r):
        facing = layout.signalling.facing.get((far, edge))
        if facing is not None and gone < r.clear_of and not over_lane(layout, r, edge):
            found[facing.id] = min(gone, found.get(facing.id, gone))
    return found


def _lanes(layout: Layout, r: Requester) -> dict[SectionId, float]:
    """The first inclined lanes outward from a requester, and how far away each begins."""
    found: dict[SectionId, float] = {}
    for edge, _, gone in _outward(layout, r):
        e = layout.track.edge[edge]
        if over_lane(layout, r, edge):
            found[e.section] = min(gone - e.length, found.get(e.section, gone))
    return found


def _exchanged(layout: Layout, r: Requester) -> Iterator[str]:
    """What is to be seen to first where the two ends of a crossover lie on different arms of a diamond, as of a
    scissors whose arms have been joined to other ends."""
    crossing = layout.pointwork.crossing_at.get(r.node)
    if crossing is None or r.partner is None:
        return
    arms = [[p for p, _ in (next_point(layout, r.node, e) for e in arm) if p is not None] for arm in crossing.arms]
    works = [{p.machine for p in arm} for arm in arms]
    if works[0] == works[1] and len(works[0]) == 2:
        one = arms[0][0]
        other = next(p for p in arms[1] if p.machine == one.machine)
        yield (
            f"see whether ends are exchanged in the `arms` of {crossing.id} (a crossover of a scissors lies on one "
            f"arm, from {one.id}.reverse to {other.id}.reverse)"
        )


def _worked_along(layout: Layout, r: Requester, held: frozenset[MachineId]) -> Iterator[PointId]:
    """Ends that would turn vehicles away from a requester, but that their machine works others on the path."""
    for edge, far, _ in _outward(layout, r):
        p = layout.pointwork.point_at.get(far)
        if p is None or p.machine not in held or p.position_of(edge) is None or p.node == r.node:
            continue
        if len(layout.machines.ends[p.machine]) > 1:
            yield p.id
