"""The order of the lowering, and the symbols through which claims read the result."""

from __future__ import annotations

from typing import Any

from interlock.logic import names
from interlock.logic.controller import Controller, RouteSymbols, Symbols, Timer
from interlock.logic.expr import TRUE
from interlock.logic.lower import added, aspects, block, overlaps, points, requests, routes, sections, ways, zones
from interlock.logic.lower.draft import Draft
from interlock.logic.lower.words import words
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.model.principles import Local
from interlock.table.rows import InterlockingTable, RouteKind, RouteRow

PASSES = (
    routes.inputs,
    requests.inputs,
    sections.inputs,
    points.inputs,
    block.inputs,
    sections.restart_delay,
    sections.image,
    sections.clear_time,
    routes.approaches,
    points.detection,
    points.movable,
    ways.availability,
    ways.detection,
    ways.swung,
    zones.count,
    routes.grants,
    ways.granted,
    routes.locking,
    sections.three_point,
    routes.cancellation,
    sections.release,
    overlaps.standing,
    overlaps.swing,
    block.change,
    points.commands,
    points.supervision,
    points.trailing,
    points.starting,
    routes.keep,
    added.keep,
    requests.keep,
    sections.keep,
    sections.alarms,
    overlaps.keep,
    block.keep,
    aspects.keep,
    aspects.outputs,
    zones.outputs,
)


def lower(layout: Layout, table: InterlockingTable) -> Controller:
    """The controller of a table; lengths are not looked at.  Raises `MalformedController` only for a defect of this
    package."""
    layout = layout.bare
    d = Draft(layout, table.bare)
    for add in PASSES:
        add(d)
    return Controller(
        layout.name,
        tuple(d.inputs),
        tuple(d.state),
        tuple(d.steps),
        tuple(d.next),
        tuple(d.outputs),
        _symbols(d),
        words(d),
    )


def _indications(d: Draft) -> dict[str, names.Name]:
    """What tells an operator something: the output by what it is about (`locked S`, `late M`, ...)."""
    found = {f"locked {s}": names.LOCKED_SHOWN(s) for s in d.sections}
    found |= {f"faulty {s}": names.FAULT_SHOWN(s) for s in d.healthy}
    found |= {f"late {m}": names.LATE_SHOWN(m) for m in d.machines}
    found |= {f"trailed {m}": names.TRAILED_SHOWN(m) for m in d.powered}
    return found | {f"full {z.id}": names.ZONE_FULL_SHOWN(z.id) for z in d.layout.zones}


def _route(d: Draft, r: RouteRow) -> RouteSymbols:
    return RouteSymbols(
        r.id,
        r.number,
        r.entry,
        r.kind is RouteKind.SHUNT,
        r.kind is RouteKind.CALL_ON,
        r.locked,
        r.traversals[-1] if r.berth is not None else None,
        (r.overlap.signal, r.overlap.option) if r.overlap is not None else None,
        names.ACTIVE(r.number),
        names.LOCKED(r.number),
        names.WANTED(r.number),
        names.SHOWING(r.number),
        names.SHOWN(r.number),
        names.PASSING(r.number) if r.closing.whole is not None else None,
        r.names,
        r.kind is RouteKind.IDENTIFIER,
        None if r.onward is None else d.table.route[r.onward].number,
        tuple(x.number for x in d.leading_past(r)),
        added.holds(r),
        tuple(d.table.route[c.route].number for c in r.barred),
        tuple((p.machine, p.position) for p in r.added),
    )


def _of_machines(d: Draft) -> dict[str, Any]:
    """What there is of each machine, as `Symbols` names it; of one that is not powered no more than its time-out."""
    by_position = {
        "detected": names.CONTACT,
        "command": names.COMMAND,
        "by_hand": names.MOVE_BY_HAND,
        "drive": names.DRIVE,
    }
    powered = {"trailed": names.TRAILED, "seen_right": names.WAS_RIGHT, "looked_at": names.LOOKED_AT}
    found: dict[str, Any] = {
        k: {(m, x): of(m, x) for m in d.machines for x in Position} for k, of in by_position.items()
    }
    found |= {k: {m: of(m) for m in d.powered} for k, of in powered.items()}
    return found | {"late_timer": {m: names.LATE(m) for m in d.machines}}


def _symbols(d: Draft) -> Symbols:
    signals = [g.id for g in d.layout.signals if d.routes_from[g.id]]
    lit = d.open_for_trains if d.layout.principles.lamp_proof else []

    return Symbols(
        valid=names.VALID,
        request=requests.REQUEST,
        local_request=requests.LOCAL if d.layout.principles.local_requests is not Local.NONE else None,
        local_first=d.layout.principles.local_requests is Local.FIRST,
        fresh={x: requests.FRESH[x] for x in requests.inputs_of(d)},
        seen={x: requests.SEEN[x] for x in requests.inputs_of(d)},
        automatic={r.number: requests.switch(r) for r in d.automatic},
        clear={s.id: names.CLEAR(s.id) for s in d.layout.sections if s.detected},
        healthy=d.healthy,
        blocked={s: names.BLOCKED(s) for s in d.lockable},
        **_of_machines(d),
        condition={c.id: names.CONDITION(c.id) for c in d.layout.conditions},
        stop_lamp={g.id: names.STOP_LAMP(g.id) for g in d.layout.signals} if d.layout.principles.lamp_proof else {},
        clear_lamp={g: names.CLEAR_LAMP(g) for g in lit},
        identifier_lamp={g: names.IDENTIFIER_LAMP(g) for g in signals if lit and d.identifies(g)},
        caution_lamp={g: names.CAUTION_LAMP(g) for g in lit if aspects.cautions(d)},
        turn={m: names.MAY_RUN(m) for m in d.machines if d.started(m) is not TRUE},
        started=names.STARTED if any(isinstance(s, Timer) and s.name == names.GAP_OVER for s in d.steps) else None,
        release_timer={s: names.LONG_CLEAR(s) for s in (*d.sections, *sections.detected(d))},
        running=names.POWERED,
        restart_timer=sections.RESTART_DELAY,
        start_timer=names.GAP_OVER if any(isinstance(s, Timer) and s.name == names.GAP_OVER for s in d.steps) else None,
        **aspects.lamps(d),
        speed_shown={(g, kmh): name for g in d.open_for_trains for kmh, name in aspects.speeds(d, g).items()},
        distant_clear={x.id: names.DISTANT_CLEAR(x.id) for x in d.layout.distants},
        distant_caution={x.id: names.DISTANT_CAUTION(x.id) for x in d.layout.distants},
        indication=_indications(d),
        zone_full={z.id: names.ZONE_FULL(z.id) for z in d.layout.zones},
        restart={s: names.RESTART_LOCK(s) for s in d.sections},
        train={s: names.TRAIN_LOCK(s) for s in d.sections} if d.shunting else {},
        lock={t.key: names.LOCK(t.section, t.number) for t in d.table.locks},
        firm={s: names.FIRM(s) for s in d.sections},
        used={s: names.USED(s) for s in d.sections},
        passed={s: names.PASSED(s) for s in d.sections},
        release={s: names.RELEASE_BY_HAND(s) for s in d.sections},
        release_all=names.RELEASE_ALL,
        stale={s: names.STALE(s) for s in d.sections},
        cancel={g: names.CANCEL(g) for g in signals},
        cancelling={g: names.CANCELLING(g) for g in signals},
        approach_timer={g: names.APPROACH_OVER(g) for g in signals},
        approach_of={g: d.rear(d.first_section(g), d.layout.signal[g].node) for g in signals},
        overlap={o: names.OVERLAP(o[0], o[1]) for o in d.overlaps},
        overlap_ways=dict(d.overlaps),
        overlap_firm={g: names.OVERLAP_FIRM(g) for g in sorted({g for g, _ in d.overlaps})},
        token=block.tokens(d),
        swings={g: names.OVERLAP_SWINGS(g) for g in d.swinging},
        swing_request={g: d.swing_number(g) for g in d.swinging},
        overlap_timer={g: names.STANDING(g) for g in sorted({g for g, _ in d.overlaps})},
        routes=tuple(_route(d, r) for r in d.table.routes),
        demands={t.key: tuple((p.machine, p.position) for p in t.points) for t in d.table.locks},
        excluded={t.key: tuple((e.section, e.whole, e.numbers) for e in t.exclusions) for t in d.table.locks},
        ends=dict(d.topo.ends),
    )
