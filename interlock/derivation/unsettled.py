"""What is said of flanks: those that nothing protects (IL4001), those that cannot be protected without a contradiction
(IL4002), those with substitute protection (IL4010), and waivers that waive nothing (IL2008).

Each place is named once, with all routes over it.
"""

from __future__ import annotations

from collections.abc import Sequence

from interlock.derivation.flank import Options, Requester, point_demands, told
from interlock.derivation.routes import Path
from interlock.derivation.settle import Place, Settlement
from interlock.diag import Element, Sink
from interlock.model.bits import chosen
from interlock.model.elements import EdgeId, MachineId, NodeId, Position, SignalId
from interlock.model.layout import Layout
from interlock.model.traversal import onward_edges
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
        sink.add(
            "IL4001",
            f"nothing keeps vehicles away from {name}; {_routes(paths, over)} pass there",
            None,
            _remedy(layout, r),
            about=_element(layout, r),
        )
    _impossible(layout, paths, settled, options, sink)
    _substitutes(layout, paths, settled, options, sink)
    unprotected = {p.requester.name for p in places if options.preferred(p.requester) is None}
    unprotected |= {settled.places[at].requester.name for at in settled.impossible}
    for w in layout.declared.waivers:
        name = f"{w.point}.{'normal' if w.leg is Position.NORMAL else 'reverse'}"
        if name not in unprotected or all(p.requester.name != name for p in places):
            sink.add(
                "IL2008",
                f"the waiver of {name} waives nothing: it is protected, or no route passes there",
                None,
                "remove the waiver",
                about=Element("waive", name),
            )


def _impossible(layout: Layout, paths: Sequence[Path], settled: Settlement, options: Options, sink: Sink) -> None:
    found: dict[str, tuple[Requester, int, dict[str, None]]] = {}
    for at in settled.impossible:
        place = settled.places[at]
        usual = options.preferred(place.requester)
        if place.requester.waiver is not None or usual is None:
            continue
        _, over, why = found.setdefault(place.requester.name, (place.requester, 0, {}))
        for m, x in (point_demands(usual) or {}).items():
            by_path, others = settled.against(at, m, x)
            if by_path:
                why[f"{m} would have to lie {x}, and lies {x.other} on the path"] = None
            names = sorted({settled.places[q].requester.name for q in others})
            if names:
                why[f"{m} would have to lie {x}, and lies {x.other} for {', '.join(names)}"] = None
            for bits in (by_path, *others.values()):
                over |= bits
        found[place.requester.name] = place.requester, over or place.routes, why
    for name, (r, over, why) in sorted(found.items()):
        sink.add(
            "IL4002",
            f"{name} cannot be protected in {_routes(paths, over)}: {'; '.join(why) or 'all that could contradicts'}",
            None,
            _remedy(layout, r),
            about=_element(layout, r),
        )


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


def _remedy(layout: Layout, r: Requester) -> str:
    """Which signals would do if they stood further away, and the keys to write; legs of points may be waived."""
    near = _too_near(layout, r)
    said = [f"{g} would do, but stands {gone:g} m away, and {r.clear_of:g} m are needed" for g, gone in near.items()]
    advice = f"{'; '.join(said)}: lengthen the track between" if said else "add a signal or a protecting point"
    point, _, leg = r.name.partition(".")
    if leg not in ("normal", "reverse"):
        return advice
    if said:
        advice += f", or state where the fouling point is: `points: {{{point}: {{fouling: ...}}}}`"
    return f"{advice}, or waive it: `waive: [{{flank: {r.name}, reason: ...}}]`"


def _too_near(layout: Layout, r: Requester) -> dict[SignalId, float]:
    """Signals that a vehicle towards a requester meets, none of them clear of the fouling point, in metres."""
    found: dict[SignalId, float] = {}
    todo: list[tuple[EdgeId, NodeId, float]] = [(r.edge, r.node, 0.0)]
    seen: set[tuple[EdgeId, NodeId]] = set()
    while todo:
        edge, node, gone = todo.pop()
        e, far = layout.track.edge[edge], layout.track.far(edge, node)
        if (edge, node) in seen or e.nothing_comes_to(node):
            continue
        seen.add((edge, node))
        gone += e.length
        facing = layout.signalling.facing.get((far, edge))
        if facing is not None and gone >= r.clear_of:
            continue
        if facing is not None:
            found[facing.id] = min(gone, found.get(facing.id, gone))
        if far != r.node and far not in layout.track.boundary_at and far not in layout.track.buffer_at:
            todo += [(x, far, gone) for x in onward_edges(layout, far, edge)]
    return found
