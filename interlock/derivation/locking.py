"""Approach locking (R8), sectional release (R9), block and external conditions (R3, R12 in part, R17)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from interlock.derivation.routes import Path
from interlock.model.approach import approach
from interlock.model.elements import BlockKind, Position, SignalId
from interlock.model.layout import Layout
from interlock.model.overlap import overlap_paths, route_speed
from interlock.model.principles import Caution, Closes
from interlock.model.times import approach_release_s
from interlock.model.traversal import path_speed, topology
from interlock.table.cells import (
    ApproachCell,
    AspectCell,
    Because,
    BlockCell,
    ClosingCell,
    ConditionCell,
    ExitKind,
    ReleaseStep,
    RouteKind,
    Shows,
    SpeedCell,
    TokenCell,
    ZoneCell,
)


def derive_approach(layout: Layout, path: Path) -> ApproachCell:
    """From where a train may come, and the delay of a cancellation while one may."""
    delay = approach_release_s(layout, path.entry)
    found = approach(layout, path.entry)
    if found.section is None:
        why = f"{path.entry} has no approach section: always approach locked"
    elif found.unseen:
        why = f"{found.section} in rear of {path.entry} is shorter than the braking distance: always approach locked"
    else:
        rest = ", ".join(dict.fromkeys(found.sections()))
        more = " within the braking distance, or told by a better aspect" if found.further else ""
        why = f"{rest} in rear of {path.entry}{more}"
    return ApproachCell(found, delay, Because("R8", why))


def derive_release(layout: Layout, path: Path) -> tuple[ReleaseStep, ...]:
    """Sections in the order in which they are released behind the train (three-point check)."""
    steps = []
    delay = layout.principles.release_delay_s
    for i, t in enumerate(path.ways):
        last = i == len(path.ways) - 1
        after = path.ways[i - 1].section if i else None
        proved: str
        if path.kind is RouteKind.CALL_ON:
            proved = "hand"
            why = f"{t.section} was locked for a call-on: detection is not relied on, the operator cancels or releases"
        elif t.section == path.berth:
            proved = "next movement"
            why = f"{t.section} stays locked while vehicles stand in it"
        elif not last:
            proved = path.ways[i + 1].section
            why = f"{t.section} was occupied, then {proved} with it, then {t.section} clear"
        elif path.exit_kind is ExitKind.BOUNDARY:
            proved = "clear"
            why = f"{t.section} was occupied and is clear: the train has left at {path.exit}"
        else:
            proved = "next movement"
            why = f"{t.section} stays locked until the train has left it under a further route"
        steps.append(ReleaseStep(t.section, after, proved, delay, Because("R9", why)))
    return tuple(steps)


def derive_block(layout: Layout, path: Path) -> tuple[BlockCell, ...]:
    """Where a section beyond the boundary is detected, it must be clear."""
    if path.exit_kind is not ExitKind.BOUNDARY:
        return ()
    boundary = layout.track.boundary_at[path.ways[-1].exit]
    if boundary.approach is None:
        return ()
    return (BlockCell(boundary.approach, Because("R12", f"{boundary.approach} beyond {path.exit} must be clear")),)


def derive_token(layout: Layout, path: Path) -> TokenCell | None:
    """The direction of the line beyond must be ours, where a token tells it."""
    if path.exit_kind is not ExitKind.BOUNDARY or path.kind is RouteKind.SHUNT:
        return None
    boundary = layout.track.boundary_at[path.ways[-1].exit]
    if boundary.block is not BlockKind.TOKEN:
        return None
    why = f"the direction of the line beyond {boundary.node} is ours"
    return TokenCell(boundary.node, Because("R12", why))


def derive_aspect(layout: Layout, path: Path) -> AspectCell:
    """What the signal shows while it is open for the path (R11)."""
    boundary = layout.track.boundary_at.get(path.parts[-1].ways[-1].exit)
    departs = path.kind is RouteKind.MAIN and boundary is not None and boundary.indicator
    return replace(_aspect(layout, path), indicator=departs or None)


def _aspect(layout: Layout, path: Path) -> AspectCell:
    """What the open signal shows: shunt, clear, or caution (R11)."""
    rule = layout.principles.caution
    if path.kind is RouteKind.CALL_ON:
        why = f"{path.entry} stays at stop and calls a train on; it runs on sight"
        return AspectCell(Shows.CALL_ON, None, Because("R2", why))
    if path.kind is RouteKind.IDENTIFIER:
        why = f"{path.entry} shows its identifier light: a train that runs past it disregards it"
        return AspectCell(Shows.IDENTIFIER, None, Because("R11", why))
    if path.kind is RouteKind.SHUNT:
        return AspectCell(Shows.SHUNT, None, Because("R11", f"{path.entry} calls a shunting movement"))
    if rule is Caution.NEVER:
        return AspectCell(Shows.CLEAR, None, Because("R11", "signals have two aspects"))
    if rule is Caution.TURNOUT and (over := _turned_into_a_track(layout, path)):
        return AspectCell(Shows.TWO_YELLOWS, None, Because("R11", over))
    speed = derive_speed(layout, path)
    if speed.kmh is not None and speed.kmh < layout.principles.slow_below_kmh:
        text = speed.because.text if speed.because.rule == "R4" else f"{speed.kmh} km/h along the path"
        return AspectCell(Shows.CAUTION, None, Because("R11", text))
    last = path.parts[-1]
    boundary = layout.track.boundary_at.get(last.ways[-1].exit)
    if boundary is not None and boundary.checked:
        return AspectCell(Shows.CLEAR, None, Because("R11", f"the line beyond {last.exit} is checked"))
    if last.exit_kind is not ExitKind.SIGNAL:
        return AspectCell(Shows.CAUTION, None, Because("R11", f"nothing is known beyond {last.exit}"))
    next_ = SignalId(last.exit)
    if not layout.signalling.opens(next_, False):
        return AspectCell(Shows.CAUTION, None, Because("R11", f"trains end at {next_}: it never opens for one"))
    return AspectCell(Shows.NEXT, next_, Because("R11", f"{next_} is the next main signal"))


def _turned_into_a_track(layout: Layout, path: Path) -> str:
    """Whether a train comes over a reversed point and not out onto a checked line, in words; the track before an
    identifier light is no line."""
    last = path.parts[-1]
    before = [p for q in path.parts[:-1] for t in q.ways for p, x in t.points if x is Position.REVERSE]
    if before:
        return f"over {', '.join(before)} reversed, before {last.entry}"
    turned = [p for t in last.ways for p, x in t.points if x is Position.REVERSE]
    boundary = layout.track.boundary_at.get(last.ways[-1].exit)
    out = boundary is not None and boundary.checked
    return f"into a track over {', '.join(turned)} reversed" if turned and not out else ""


def derive_speed(layout: Layout, path: Path) -> SpeedCell:
    """The lowest speed that the layout states along the path, or for its overlap (R11, R4)."""
    if path.onward is not None:
        cells = [derive_speed(layout, replace(path, onward=None)), derive_speed(layout, path.onward)]
        stated = [c for c in cells if c.kmh is not None]
        return min(stated, key=lambda c: c.kmh or 0, default=cells[0])
    kmh, along = route_speed(layout, path.ways, path.exit, path.overlap), path_speed(layout, path.ways)
    if kmh is not None and kmh != along:
        over = ", ".join(t.section for t in path.overlap)
        return SpeedCell(kmh, Because("R4", f"the overlap of {path.exit} over {over} is made for {kmh} km/h"))
    why = "the layout states no speed along the path" if kmh is None else f"{kmh} km/h is the lowest along the path"
    return SpeedCell(kmh, Because("R11", why))


def derive_closing(layout: Layout, path: Path) -> ClosingCell:
    """When the signal returns to stop behind a movement (R3).

    It stays open for the whole movement only where nothing can follow meanwhile: behind a signal inside the layout,
    before which one movement at most can stand.
    """
    rules, topo = layout.principles, topology(layout)
    if path.kind is RouteKind.CALL_ON:
        return ClosingCell(None, Because("R2", f"{path.entry} calls on once, to the first axle"))
    if path.kind is RouteKind.IDENTIFIER:
        return ClosingCell(None, Because("R3", f"{path.entry} returns to stop with the first axle that passes it"))
    wanted = rules.shunt_closes if path.kind is RouteKind.SHUNT else rules.main_closes
    if wanted is Closes.FIRST_AXLE:
        return ClosingCell(None, Because("R3", f"{path.entry} returns to stop with the first axle"))
    rear = topo.beyond(path.ways[0].section, path.entry_node)
    if rear is None:
        return ClosingCell(
            None, Because("R3", f"with the first axle: beyond {path.entry_node} another train may follow")
        )
    if rear in topo.standing:
        return ClosingCell(None, Because("R3", f"with the first axle: vehicles that stand in {rear} could follow"))
    why = f"{path.entry} returns to stop when the movement has left {rear}, or the first section beyond"
    return ClosingCell(rear, Because("R3", why))


def derive_zones(layout: Layout, path: Path) -> tuple[ZoneCell, ...]:
    """The zones into which the route leads from outside (R17)."""
    first = path.ways[0]
    behind = topology(layout).beyond(first.section, path.entry_node)
    over = [behind, *(t.section for t in path.run)]
    out = []
    for z in layout.declared.zones:
        entries = sum(b in z.sections and a not in z.sections for a, b in pairwise(over))
        if entries:
            most = "one train" if z.trains == 1 else f"{z.trains} trains"
            why = f"no more than {most} in {z.id}, counting the one for which this route is set"
            out.append(ZoneCell(z.id, entries, Because("R17", why)))
    return tuple(out)


def derive_conditions(layout: Layout, path: Path, swings: Sequence[int]) -> tuple[ConditionCell, ...]:
    """External inputs that the route requires, for its path and for each overlap (R4) that it holds or may swing to."""
    out = []
    sections = {t.section for t in path.ways}
    beyond = {t.section for t in path.overlap}
    if swings:
        options = overlap_paths(layout, SignalId(path.exit))
        beyond |= {t.section for k in swings for t in options[k - 1]}
    for c in layout.signalling.conditions:
        hit = sorted(sections & set(c.over))
        overrun = sorted(beyond & set(c.over))
        if hit:
            out.append(ConditionCell(c.id, Because("R17", f"required by every route over {', '.join(hit)}")))
        elif path.kind is not RouteKind.SHUNT and path.ways[-1].exit in c.exits:
            out.append(ConditionCell(c.id, Because("R12", f"a train leaves at {path.exit}: {c.text}")))
        elif path.entry in c.signals:
            out.append(ConditionCell(c.id, Because("R17", f"required by every route from {path.entry}")))
        elif overrun:
            why = f"a train that overruns {path.exit} may come to {', '.join(overrun)}"
            out.append(ConditionCell(c.id, Because("R17", why)))
    return tuple(out)
