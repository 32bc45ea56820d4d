"""Usual practice that only routes show: starting signals, places without a way in or out, waiting on points, vehicles
beside points that nothing holds.

Warnings IL7002, IL7003, IL7004, IL7007, IL7013, IL4017.  A layout may depart from practice: `allow`, with a reason.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from interlock.derivation.flank import reached, requesters
from interlock.derivation.locks import Locks
from interlock.derivation.routes import Path
from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import BoundaryKind, BufferKind, EdgeId, NodeId, SectionId, SignalId
from interlock.model.layout import Layout
from interlock.model.plain import Plain, Plains, plains
from interlock.model.traversal import onward_edges, topology
from interlock.table.cells import ExitKind, ProviderKind, RouteKind

STATION_TRACK_M = 100.0
"""Shorter plain track between the legs of points is no track of a station (our choice)."""
TRAIN_M = 100.0
"""A train that waits so far beyond points stands clear of them (our choice)."""


def check_practice(layout: Layout, paths: Sequence[Path], locks: Locks, sink: Sink) -> None:
    """Report what departs from usual practice, where no error hides routes."""
    if sink.has_errors:
        return
    found = plains(layout)
    _check_starting(found, paths, sink)
    _check_places(found, paths, sink)
    _check_ends(found, paths, sink)
    _check_waiting(found, paths, sink)
    _check_spurs(layout, paths, locks, sink)
    _check_marked(layout, paths, sink)


def _passed(found: Plains, path: Path) -> Iterator[tuple[Plain, bool]]:
    """The stretches of plain track between points that a path runs over from end to end, and whether forward."""
    at: dict[EdgeId, int] = {}
    for t in path.ways:
        for e in t.edges:
            at.setdefault(e, len(at))
    for p in dict.fromkeys(id(found.of[e]) for e in at):
        stretch = found.by_id[p]
        first, last = (at.get(stretch.edges[k].id) for k in (0, -1))
        if first is not None and last is not None and first != last and _between_points(found, stretch):
            yield stretch, first < last


def _between_points(found: Plains, stretch: Plain) -> bool:
    return found.pointed(stretch.nodes[0]) and found.pointed(stretch.nodes[-1])


def _check_starting(found: Plains, paths: Sequence[Path], sink: Sink) -> None:
    """Tracks with a main signal at one end and none at the other, over which trains leave too; tracks with none."""
    past: dict[tuple[int, bool], list[Path]] = {}
    for path in paths:
        if path.kind is RouteKind.MAIN and path.option <= 1:
            for stretch, forward in _passed(found, path):
                if stretch.sections and not found.looking(stretch, forward):
                    past.setdefault((id(stretch), forward), []).append(path)
    for (key, forward), those in past.items():
        stretch = found.by_id[key]
        name, end, back = stretch.name, stretch.end(forward), found.looking(stretch, not forward)
        if any(found.turned(g) for g in back):
            continue  # that one is missing here
        if any(g.main for g in back):
            routes = _listed(p.id for p in those)
            shut_in = ""
            if any(p.exit_kind is ExitKind.BUFFER for p in those):
                shut_in = f"; an engine that leaves its coaches in {name} cannot come back: {end} stays locked as long"
            sink.add(
                "IL7002",
                f"the {called('track', str(name))} has no starting signal towards {end}: trains leave it there "
                f"and pass on into the points ({routes}){shut_in}",
                None,
                f"add a signal `from: {name}` into the section before {end}",
                about=Element("sections", str(name)),
                cause="starting",
                note=f"{name} towards {end}",
            )
        elif not back and stretch.metres >= STATION_TRACK_M and _beside(found, stretch):
            for path in those:
                ahead = found.layout.signalling.signal.get(SignalId(path.exit))
                serves = ahead is not None and found.behind_points(ahead) is not None
                shunt = f"; or, if {path.exit} serves several tracks, a shunt signal at the end of each: "
                fix = f"add starting signals at both ends of {name}"
                sink.add(
                    "IL7003",
                    f"route {path.id} runs through a whole station: past the {called('track', str(name))}, "
                    "where no signal stands",
                    None,
                    fix + (f"{shunt}`kind: shunt, stops_trains: yes`" if serves else ""),
                    about=Element("signals", path.entry),
                    cause="whole station",
                    note=f"{path.id} past {name}",
                )


def _beside(found: Plains, stretch: Plain) -> bool:
    """Whether a stretch is one of several ways between two points: it lies between a leg of each (from a toe on it is a
    line, or part of a ladder), and another way joins their other legs.  Where none does, it joins two lines."""
    first, last = (found.layout.pointwork.point_at.get(stretch.nodes[k]) for k in (0, -1))
    if first is None or last is None:
        return False
    other = {p.node: {p.normal, p.reverse} - {e.id for e in stretch.edges} for p in (first, last)}
    if first.toe == stretch.edges[0].id or last.toe == stretch.edges[-1].id:
        return False
    todo, seen = [(e, first.node) for e in other[first.node]], set[tuple[EdgeId, NodeId]]()
    while todo:
        edge, node = todo.pop()
        ahead = found.layout.track.far(edge, node)
        if (edge, node) in seen:
            continue
        seen.add((edge, node))
        if ahead == last.node and edge in other[last.node]:
            return True
        todo += [(e, ahead) for e in onward_edges(found.layout, ahead, edge)]
    return False


def _check_places(found: Plains, paths: Sequence[Path], sink: Sink) -> None:
    """Places before signals and at ends of routes to which no train comes, or from which none leaves the layout."""
    layout = found.layout
    onward: dict[str | int, set[str | int]] = {}
    backward: dict[str | int, set[str | int]] = {}
    for path in paths:
        g = layout.signalling.signal[path.entry]
        start = _place(found, g.node, g.into)
        last: str | int = id(found.of[path.ways[-1].edges[-1]])
        steps = [(start, last)] + ([(last, str(path.exit))] if path.exit_kind is ExitKind.BOUNDARY else [])
        for here, there in steps:
            onward.setdefault(here, set()).add(there)
            backward.setdefault(there, set()).add(here)
    begins = {str(b.node) for b in layout.track.boundaries if b.kind is not BoundaryKind.OUT}
    leaves = {str(b.node) for b in layout.track.boundaries if b.kind is not BoundaryKind.IN}
    reached, left = _closed(begins, onward), _closed(leaves, backward)
    for b in layout.track.boundaries:
        if b.kind is not BoundaryKind.IN and str(b.node) not in backward and len(layout.track.boundaries) > 1:
            sink.add(
                "IL7004",
                f"no route leads out at {b.node}, though trains may leave there",
                None,
                "add a signal that leads there, or say `trains: in`"
                + (", without a direction token" if b.block == "token" else ""),
                about=Element("boundaries", str(b.node)),
            )
    for place in [*dict.fromkeys([*onward, *backward])]:
        if isinstance(place, str) or any(found.turned(g) for g, _ in found.signals.get(place, ())):
            continue
        name = found.by_id[place].name or found.by_id[place].edges[0].section
        words = _called(found, place)
        if begins and place not in reached:
            said = f"no train comes to stand in {words}: no route, or chain of routes, from a boundary ends there"
            fix = "add a signal that leads there, or a board at its end, or check the directions of those near it"
            sink.add("IL7004", said, None, fix, about=Element("sections", str(name)), cause="reach", note=str(name))
        elif leaves and place in backward and place not in left:
            said = f"no train can leave {words}: no route leads on from there to a boundary"
            fix = "add a signal out of it, or check the directions of those near it"
            sink.add("IL7004", said, None, fix, about=Element("sections", str(name)), cause="leave", note=str(name))


def _check_marked(layout: Layout, paths: Sequence[Path], sink: Sink) -> None:
    """Berths in which shunting movements end before a line with a direction token, where no board or signal tells them
    so: elsewhere station limits without one are usual."""
    tokens = {b.node for b in layout.track.boundaries if b.block == "token"}
    for path in paths:
        last = path.ways[-1]
        if path.kind is RouteKind.SHUNT and last.exit in tokens and last.section in topology(layout).berths:
            sink.add(
                "IL7013",
                f"shunting movements end in {last.section} before the single line beyond {last.exit}, and no board or "
                "signal tells them where",
                None,
                f"give the last metres before {last.exit} a section of their own and set a limit-of-shunt board before "
                f"it (`kind: limit`), or say `sections: {{{last.section}: {{berth: no}}}}`",
                about=Element("boundaries", str(last.exit)),
                cause=f"{last.section} {last.exit}",
            )


def _check_ends(found: Plains, paths: Sequence[Path], sink: Sink) -> None:
    """Signals on a track towards its buffer past which a train comes, and where none leads back: what turns there meets
    the next one only further out, where another movement may be."""
    for g in {
        p.entry: found.layout.signalling.signal[p.entry] for p in paths if p.exit_kind is ExitKind.BUFFER
    }.values():
        stretch = found.of[g.into]
        end = next((n for n in (stretch.nodes[0], stretch.nodes[-1]) if n in found.layout.track.buffer_at), None)
        if end is None or g.node in found.layout.track.boundary_at or found.behind_points(g) is not None:
            continue
        forward, at = end == stretch.nodes[-1], stretch.nodes.index(g.node)
        beyond = stretch.nodes[at:] if forward else stretch.nodes[: at + 1]
        if not any(h.node in beyond for h in found.looking(stretch, not forward)):
            section = str(found.layout.track.section_of(g.into))
            said = f"no train can leave {section}: past {g.id} no signal leads back out before the next section"
            fix = f"add a signal `from: {section}` at the joint of {g.id}"
            sink.add("IL7004", said, None, fix, about=Element("sections", section), cause="leave", note=section)


def _called(found: Plains, place: int) -> str:
    """A stretch by the section of its own, or, where it is only the leg of a point, by the end to which it leads."""
    stretch = found.by_id[place]
    section = str(stretch.name or stretch.edges[0].section)
    ends = [str(n) for n in stretch.nodes if n in found.layout.track.buffer_at]
    return section if stretch.name or not ends else f"{' and '.join(ends)}, in {section}"


def _place(found: Plains, node: NodeId, edge: EdgeId) -> str | int:
    """Where a train stands: before a boundary, or on a stretch of plain track."""
    return str(node) if node in found.layout.track.boundary_at else id(found.of[edge])


def _closed(first: Iterable[str | int], further: dict[str | int, set[str | int]]) -> set[str | int]:
    """Everything to which one comes."""
    found: set[str | int] = set(first)
    todo = list(found)
    while todo:
        for x in further.get(todo.pop(), ()):
            if x not in found:
                found.add(x)
                todo.append(x)
    return found


def _check_waiting(found: Plains, paths: Sequence[Path], sink: Sink) -> None:
    """Main signals before which trains wait on points that they have just passed."""
    ends = {p.exit for p in paths if p.exit_kind is ExitKind.SIGNAL and p.kind is RouteKind.MAIN and not p.onward}
    for g in found.layout.signalling.signals:
        behind = found.behind_points(g)
        if g.id not in ends or not g.main or behind is None or behind[1] >= TRAIN_M or found.turned(g):
            continue
        points, metres = behind
        sink.add(
            "IL7007",
            f"{called('signal', g.id)} stands {metres:g} m behind {points}: "
            "a train that waits before it stands on the points",
            None,
            "move it further on by a section as long as a train, or before the points",
            about=Element("signals", g.id),
            cause="behind points",
            note=f"{g.id}, {metres:g} m behind {points}",
        )


def _check_spurs(layout: Layout, paths: Sequence[Path], locks: Locks, sink: Sink) -> None:
    """Tracks into which vehicles are brought, and which nothing but their own end keeps from a place that others pass
    (R5), or the ring in which it closes: not where they must be clear, as flank space or at a foul joint."""
    brought: dict[SectionId, list[str]] = {}
    for p in paths:
        brought.setdefault(p.berth or p.ways[-1].section, []).append(p.id)
    by_hand = _by_hand(layout)
    open_: dict[Element, dict[SectionId, dict[str, None]]] = {}
    for row in locks.values():
        clear = {row.section, *(c.section for c in row.foul if c.when is None)}
        clear |= {SectionId(c.name) for c in row.space if not c.lamp}
        cells = {c.requester: c.providers for c in row.flank}
        for r in requesters(layout, topology(layout).traversals[row.section][row.number - 1]):
            if r.name not in cells or r.waiver is not None:
                continue
            ends = [NodeId(p.name) for p in cells[r.name] if p.kind is ProviderKind.BUFFER]
            holds = [Element("buffers", n) for n in ends if layout.track.buffer_at[n].kind is BufferKind.STOP]
            between, _, ring = reached(layout, r, cells[r.name])
            if ring and not holds:
                holds.append(Element("points" if r.node in layout.pointwork.point_at else "crossings", r.node))
            for s in between if holds else ():
                if s not in clear and (s in brought or s in by_hand):
                    for x in holds:
                        open_.setdefault(x, {}).setdefault(s, {})[r.name] = None
    for held, sections in sorted(open_.items(), key=lambda x: (x[0].room, str(x[0].name))):
        come = list(dict.fromkeys(p for s in sections for p in brought.get(s, ())))
        places = dict.fromkeys(p for those in sections.values() for p in those)
        end = f"the end of the track, {held.name}," if held.room == "buffers" else "the ring in which the track closes"
        by = f"by {_listed(come)}" if come else by_hand[next(iter(sections))]
        sink.add(
            "IL4017",
            f"vehicles are brought into {' and '.join(sections)} ({by}), and nothing but {end} "
            f"protects {_listed(places)} from them",
            None,
            "add a signal or a derailer that stands clear of the points"
            + ("" if layout.principles.flank_space else f", or have the track clear: {_SPACE}"),
            about=held,
        )


_SPACE = "`principles: {flank_space: yes}`"


def _by_hand(layout: Layout) -> dict[SectionId, str]:
    """Sections into which hand-worked points lead, one after the other, and through which."""
    found: dict[SectionId, str] = {}
    for p in layout.pointwork.points:
        if p.machine in layout.machines.by_hand:
            todo, seen = [(p.reverse, p.node)], set[EdgeId]()
            while todo:
                edge, node = todo.pop()
                far = layout.track.far(edge, node)
                beyond = layout.pointwork.point_at.get(far)
                if edge in seen or (beyond is not None and beyond.machine not in layout.machines.by_hand):
                    continue
                seen.add(edge)
                found.setdefault(layout.track.section_of(edge), f"through {p.id}, by hand")
                todo += [(x, far) for x in onward_edges(layout, far, edge)]
    return found


def _listed(names: Iterable[str]) -> str:
    """The first of some names, and how many there are beside them."""
    own = list(names)
    return ", ".join(own[:3]) + (f" and {len(own) - 3} more" if len(own) > 3 else "")
