"""Ways that only lead back to where they began, while the way beside them leads on.  IL7017.

A point drawn with its toe and a leg exchanged makes a balloon loop of two tracks between points: whoever runs into the
one comes back over the other.  A balloon that is meant has no way on out of it but to tracks that end, so that both its
legs lead back and nowhere else; only those are warned of beside which a boundary lies.
"""

from __future__ import annotations

from collections.abc import Container, Mapping

from interlock.dataclass import dataclass
from interlock.diag import Element
from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.frontend.parts import ENDS, across, points_of
from interlock.model.elements import EdgeId, NodeId, Point, PointId, Position
from interlock.model.layout import Layout
from interlock.model.traversal import onward_edges

_Run = tuple[EdgeId, NodeId]
"""An edge, and the node from which one runs over it."""

_LEG = {Position.NORMAL: "normal", Position.REVERSE: "reverse"}


@dataclass(frozen=True)
class _Ways:
    """Where ways from a leg of a point lead: over which legs they come back, to which ends, and over which points they
    come by a leg."""

    back: frozenset[Position]
    boundaries: tuple[NodeId, ...]
    ends: bool
    trailing: tuple[tuple[PointId, Position], ...]


def check_loops(ctx: Context, layout: Layout) -> None:
    """Report legs that lead back to their point over its other leg and nowhere else, where that one leads on; of the
    points of a slip the first."""
    slips = {p: name for name, s in ctx.file.slips.items() for p in points_of(name, s)}
    ends, exits = {b.point: b for b in layout.pointwork.blades}, _Exits(layout)
    for p in layout.pointwork.points:
        slip, blades = slips.get(p.id), ends.get(p.id)
        about = Element("points", p.id) if slip is None else Element("slips", slip)
        for x in Position:
            if p.derailer or (slip is not None and ctx.sink.gave("IL7017", about)):
                continue
            if exits.leads_out(p, x):
                continue
            here = _ways(layout, p, x)
            if here.back != {x.other} or here.boundaries or here.ends:
                continue
            there = _ways(layout, p, x.other)
            exchanged = _exchanged(layout, here, there, slips)
            if not there.boundaries or exchanged is None:
                continue
            leg, other = (
                (f"{p.id}.{_LEG[y]}" if slip is None or blades is None else f"{slip}.{blades.to(y)}")
                for y in (x, x.other)
            )
            ctx.add(
                "IL7017",
                f"whoever runs over {leg} comes back to "
                f"{called('point', p.id) if slip is None else called('slip', slip)} over its other leg, and "
                f"nowhere else: a balloon loop, while {other} also leads to {', '.join(there.boundaries[:3])}",
                ctx.at_key(about.room, about.name),
                f"if no loop is meant, see whether {_fix(*exchanged, slips)} are exchanged",
                about=about,
            )
    _check_straight(ctx, layout, slips)


def _check_straight(ctx: Context, layout: Layout, slips: Mapping[str, str]) -> None:
    """Report slips over which a way leads straight back to the point from which it came, and nowhere else, while slip
    rails lead on: in the arms of such a slip ends are exchanged as they are of points, and no way is cut off."""
    straight = _straight(ctx, layout)
    for p in layout.pointwork.points if slips else ():
        told = p.id in slips or p.derailer or ctx.sink.gave("IL7017", Element("points", p.id))
        for x in () if told else Position:
            over = [slips[q] for q in _back(layout, p, x, straight) if q in slips]
            out = _ways(layout, p, x).boundaries if over else ()
            if not out or ctx.sink.gave("IL7017", Element("slips", over[0])):
                continue
            slip = called("slip", over[0])
            ctx.add(
                "IL7017",
                f"whoever runs over {p.id}.{_LEG[x]} and straight over {slip} comes back to {called('point', p.id)} "
                f"over its other leg: a balloon loop, while only slip rails lead to {', '.join(out[:3])}",
                ctx.at_key("slips", over[0]),
                f"if no loop is meant, see whether ends in the `arms` of {slip} are exchanged",
                about=Element("slips", over[0]),
            )


def _straight(ctx: Context, layout: Layout) -> dict[_Run, _Run]:
    """From the run onto a slip over one of its ends to the run that leaves it straight on, past its slip rails."""
    found: dict[_Run, _Run] = {}
    for name, s in ctx.file.slips.items():
        outward = {}
        for end in ENDS:
            e, own = layout.track.edge[EdgeId(f"{name}.{end}")], {name, *points_of(name, s)}
            outward[end] = (e.id, e.a if e.a in own else e.b)
        for end, (edge, node) in outward.items():
            found[edge, layout.track.far(edge, node)] = outward[across(end)]
    return found


def _back(layout: Layout, p: Point, x: Position, straight: Mapping[_Run, _Run]) -> list[PointId]:
    """The points over which all ways from a leg of a point come back to it over the other leg, where they lead straight
    over slips; empty where one leads anywhere else."""
    todo, seen, passed = [(p.leg(x), p.node)], set[_Run](), dict[PointId, None]()
    comes_back = False
    while todo:
        run = todo.pop()
        edge, node = run
        e = layout.track.edge[edge]
        if run in seen or (e.one_way and e.a != node):
            continue
        seen.add(run)
        far = layout.track.far(edge, node)
        if far == p.node:
            if edge != p.leg(x.other):
                return []
            comes_back = True
            continue
        if far in layout.track.boundary_at or far in layout.track.buffer_at:
            return []
        point = layout.pointwork.point_at.get(far)
        if point is not None:
            passed[point.id] = None
        on = straight.get(run)
        todo += [on] if on is not None else [(onward, far) for onward in onward_edges(layout, far, edge)]
    return [*passed] if comes_back else []


def _fix(point: PointId, leg: Position, slips: Mapping[str, str]) -> str:
    """What may be exchanged: of a slip ends of its arms, since its points stand nowhere in the text."""
    slip = slips.get(point)
    return f"`toe` and `{_LEG[leg]}` of {point}" if slip is None else f"ends in the `arms` of {called('slip', slip)}"


class _Exits:
    """From every edge in each direction one shortest way to an end of the track, if any leads there: a forest, whose
    roots are the ends.  Made once, since the way from each point of a line to its end is as long as the line."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        before: dict[_Run, list[_Run]] = {}
        roots: list[_Run] = []
        for e in layout.track.edges:
            for node in (e.a,) if e.one_way else (e.a, e.b):
                far, run = layout.track.far(e.id, node), (e.id, node)
                if far in layout.track.boundary_at or far in layout.track.buffer_at:
                    roots.append(run)
                for onward in onward_edges(layout, far, e.id):
                    before.setdefault((onward, far), []).append(run)
        following: dict[_Run, list[_Run]] = {}
        found, reached = list(roots), set(roots)
        for run in found:
            for last in before.get(run, ()):
                if last not in reached:
                    reached.add(last)
                    found.append(last)
                    following.setdefault(run, []).append(last)
        self._span: dict[_Run, tuple[int, int]] = {}
        """The numbers of an edge and of all whose ways lead over it, in one piece."""
        todo, number, open_ = [(r, False) for r in reversed(roots)], 0, dict[_Run, int]()
        while todo:
            run, left = todo.pop()
            if left:
                self._span[run] = open_[run], number
                continue
            open_[run], number = number, number + 1
            todo += [(run, True), *((x, False) for x in following.get(run, ()))]

    def leads_out(self, p: Point, x: Position) -> bool:
        """Whether the way from a leg of a point leads to an end, and does not come back to the point.  (Where it comes
        back, another may lead out.)"""
        begins = self._span.get((p.leg(x), p.node))
        if begins is None:
            return False
        track = self._layout.track
        back = (self._span.get((e, track.far(e, p.node))) for e in (p.toe, p.leg(x), p.leg(x.other)))
        return not any(b is not None and b[0] <= begins[0] < b[1] for b in back)


def _ways(layout: Layout, p: Point, x: Position) -> _Ways:
    """Where one comes over a leg."""
    todo, seen = [(p.leg(x), p.node)], set[tuple[EdgeId, NodeId]]()
    back, boundaries = set[Position](), dict[NodeId, None]()
    trailing, ends = dict[tuple[PointId, Position], None](), False
    while todo:
        edge, node = todo.pop()
        e = layout.track.edge[edge]
        if (edge, node) in seen or (e.one_way and e.a != node):
            continue
        seen.add((edge, node))
        far = layout.track.far(edge, node)
        point = layout.pointwork.point_at.get(far)
        over = None if point is None else point.position_of(edge)
        if far == p.node:  # over its toe one is past it, as if one had never come
            back, ends = back | ({over} if over is not None else set()), ends or over is None
            continue
        if point is not None and over is not None:
            trailing[point.id, over] = None
        if far in layout.track.boundary_at:
            boundaries[far] = None
        ends = ends or far in layout.track.buffer_at
        todo += [(onward, far) for onward in onward_edges(layout, far, edge)]
    return _Ways(frozenset(back), tuple(boundaries), ends, tuple(trailing))


def _exchanged(layout: Layout, here: _Ways, there: _Ways, slips: Container[str]) -> tuple[PointId, Position] | None:
    """The first point that the loop comes to over one leg, and over whose other leg one leaves it for a boundary; one
    of a slip where there is no other."""
    for point, over in sorted(here.trailing, key=lambda x: x[0] in slips):
        p = layout.pointwork.point[point]
        if set(_ways(layout, p, over.other).boundaries) & {*there.boundaries}:
            return point, over.other
    return None
