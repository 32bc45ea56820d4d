"""The order of the lowering, and the symbols through which claims read the result."""

from __future__ import annotations

from collections.abc import Sequence

from interlock.logic import names
from interlock.logic.controller import Controller, Timer
from interlock.logic.expr import TRUE
from interlock.logic.lower import (
    added,
    aspects,
    block,
    come_in,
    overlaps,
    points,
    requests,
    routes,
    sections,
    ways,
    zones,
)
from interlock.logic.lower.draft import Draft
from interlock.logic.lower.words import words
from interlock.logic.symbols import (
    CancelSymbols,
    LampProofSymbols,
    MachineSymbols,
    OverlapSymbols,
    RequestSymbols,
    RoutePath,
    Routes,
    RouteSymbols,
    SectionSymbols,
    StartSymbols,
    Symbols,
    WaySymbols,
)
from interlock.model.elements import MachineId, Position, SignalId
from interlock.model.foul import foul_joints
from interlock.model.layout import Layout
from interlock.model.needs import arrival
from interlock.model.principles import Local
from interlock.table.cells import RouteKind
from interlock.table.rows import InterlockingTable, RouteRow

PASSES = (
    routes.inputs,
    requests.inputs,
    sections.inputs,
    points.inputs,
    block.inputs,
    sections.restart_delay,
    sections.image,
    sections.clear_time,
    come_in.seen_alone,
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
    ways.unhindered,
    sections.three_point,
    routes.cancellation,
    sections.release,
    overlaps.standing,
    overlaps.swing,
    block.change,
    points.commands,
    points.supervision,
    points.trailing,
    points.keep_off,
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
    """The controller of a table; of lengths no more is looked at than which joints are foul, and how long a train runs
    on to a signal at the end of a berth.  Raises `MalformedController` only for a defect of this package."""
    d = Draft(layout.bare, table.bare, foul_joints(layout), arrival(layout))
    for add in PASSES:
        add(d)
    return Controller(
        layout.name,
        tuple(d.inputs),
        tuple(variable for variable, _ in d.memory),
        tuple(d.steps),
        tuple(equation for _, equation in d.memory),
        tuple(d.outputs),
        _symbols(d),
        words(d),
    )


def _indications(d: Draft) -> dict[str, names.Name]:
    """What tells an operator something: the output by what it is about (`locked S`, `late M`, ...)."""
    found = {f"locked {s}": names.LOCKED_SHOWN(s) for s in d.sections.all}
    found |= {f"faulty {s}": names.FAULT_SHOWN(s) for s in d.sections.healthy}
    found |= {f"late {m}": names.LATE_SHOWN(m) for m in d.machines.all}
    found |= {f"trailed {m}": names.TRAILED_SHOWN(m) for m in d.machines.powered}
    return found | {f"full {z.id}": names.ZONE_FULL_SHOWN(z.id) for z in d.layout.declared.zones}


def _route(d: Draft, r: RouteRow) -> RouteSymbols:
    return RouteSymbols(
        r.id,
        r.number,
        r.names,
        r.entry,
        r.kind is RouteKind.SHUNT,
        r.kind is RouteKind.CALL_ON,
        _path(d, r),
        names.ACTIVE(r.number),
        names.LOCKED(r.number),
        names.WANTED(r.number),
        names.SHOWING(r.number),
        names.SHOWN(r.number),
        names.PASSING(r.number) if r.signal.closing.whole is not None else None,
        added.holds(r),
    )


def _path(d: Draft, r: RouteRow) -> RoutePath:
    return RoutePath(
        r.path.locked,
        r.path.traversals[-1] if r.path.berth is not None else None,
        (r.locking.overlap.signal, r.locking.overlap.option) if r.locking.overlap is not None else None,
        r.kind is RouteKind.IDENTIFIER,
        None if r.path.onward is None else d.table.route[r.path.onward].number,
        tuple(x.number for x in d.routes.leading_past(r)),
        tuple(d.table.route[c.route].number for c in r.locking.barred),
        tuple((p.machine, p.position) for p in r.locking.added),
        added.hold_timer(r),
        added.hold_begun(r),
    )


def _requests(d: Draft) -> RequestSymbols:
    return RequestSymbols(
        requests.REQUEST,
        requests.LOCAL if d.layout.principles.local_requests is not Local.NONE else None,
        d.layout.principles.local_requests is Local.FIRST,
        {x: requests.FRESH[x] for x in requests.inputs_of(d)},
        {x: requests.SEEN[x] for x in requests.inputs_of(d)},
        {r.number: requests.switch(r) for r in d.routes.automatic},
    )


def _sections(d: Draft) -> SectionSymbols:
    return SectionSymbols(
        clear={s.id: names.CLEAR(s.id) for s in d.layout.track.sections if s.detected},
        healthy=d.sections.healthy,
        blocked={s: names.BLOCKED(s) for s in d.sections.blockable},
        release={s: names.RELEASE_BY_HAND(s) for s in d.sections.all},
        release_all=names.RELEASE_ALL,
        release_timer={s: names.LONG_CLEAR(s) for s in (*d.sections.all, *sections.detected(d))},
        restart={s: names.RESTART_LOCK(s) for s in d.sections.all},
        lock={t.key: names.LOCK(t.section, t.number) for t in d.table.locks},
        train={s: names.TRAIN_LOCK(s) for s in d.sections.all} if d.signals.shunting else {},
        firm={s: names.FIRM(s) for s in d.sections.all},
        used={s: names.USED(s) for s in d.sections.all},
        passed={s: names.PASSED(s) for s in d.sections.all},
        stale={s: names.STALE(s) for s in d.sections.all},
    )


def _ways(d: Draft) -> WaySymbols:
    return WaySymbols(
        {t.key: tuple((p.machine, p.position) for p in t.points) for t in d.table.locks},
        {t.key: tuple((e.section, e.whole, e.numbers) for e in t.exclusions) for t in d.table.locks},
        dict(d.topo.ends),
    )


def _machines(d: Draft) -> MachineSymbols:
    """What there is of each machine; of one that is not powered no more than its time-out."""

    def by_position(of: names.Family) -> dict[tuple[MachineId, Position], names.Name]:
        return {(m, x): of(m, x) for m in d.machines.all for x in Position}

    def powered(of: names.Family) -> dict[MachineId, names.Name]:
        return {m: of(m) for m in d.machines.powered}

    sequence = any(isinstance(s, Timer) and s.name == names.GAP_OVER for s in d.steps)
    return MachineSymbols(
        detected=by_position(names.CONTACT),
        command=by_position(names.COMMAND),
        by_hand=by_position(names.MOVE_BY_HAND),
        drive=by_position(names.DRIVE),
        trailed=powered(names.TRAILED),
        was_detected={(m, x): names.WAS_DETECTED(m, x) for m in d.machines.powered for x in Position},
        looked_at=powered(names.LOOKED_AT),
        late_timer={m: names.LATE(m) for m in d.machines.all},
        turn={m: names.MAY_RUN(m) for m in d.machines.all if d.machines.started(m) is not TRUE},
        kept_off=powered(names.KEPT_OFF),
        started=names.STARTED if sequence else None,
        start_timer=names.GAP_OVER if sequence else None,
    )


def _lamp_proof(d: Draft, signals: Sequence[SignalId]) -> LampProofSymbols:
    proved = d.layout.principles.lamp_proof
    lit = d.routes.open_for_trains if proved else {}
    return LampProofSymbols(
        stop={g.id: names.STOP_LAMP(g.id) for g in d.layout.signalling.signals} if proved else {},
        clear={g: names.CLEAR_LAMP(g) for g in lit},
        caution={g: names.CAUTION_LAMP(g) for g in lit if aspects.cautions(d)},
        identifier={g: names.IDENTIFIER_LAMP(g) for g in signals if lit and d.routes.identifies(g)},
        second={g: names.SECOND_LAMP(g) for g in (aspects.two_yellows(d) if lit else ())},
        speed={g: names.SPEED_LAMP(g) for g in lit if aspects.speeds(d, g)},
    )


def _overlaps(d: Draft) -> OverlapSymbols:
    owners = sorted({g for g, _ in d.overlaps.ways})
    return OverlapSymbols(
        held={o: names.OVERLAP(o[0], o[1]) for o in d.overlaps.ways},
        ways=dict(d.overlaps.ways),
        firm={g: names.OVERLAP_FIRM(g) for g in owners},
        timer={g: names.STANDING(g) for g in overlaps.timed(d)},
        swings={g: names.OVERLAP_SWINGS(g) for g in d.overlaps.swinging},
        swing_request={g: d.overlaps.swing_number(g) for g in d.overlaps.swinging},
    )


def _symbols(d: Draft) -> Symbols:
    signals = [g.id for g in d.layout.signalling.signals if d.routes.of_signal[g.id]]
    return Symbols(
        valid=names.VALID,
        start=StartSymbols(names.POWERED, sections.RESTART_DELAY),
        requests=_requests(d),
        routes=Routes(_route(d, r) for r in d.table.routes),
        sections=_sections(d),
        ways=_ways(d),
        machines=_machines(d),
        aspects=aspects.symbols(d),
        lamp_proof=_lamp_proof(d, signals),
        cancellation=CancelSymbols(
            {g: names.CANCEL(g) for g in signals},
            {g: names.CANCELLING(g) for g in signals},
            {g: names.APPROACH_OVER(g) for g in signals},
            {g: d.sections.rear(d.signals.first_section(g), d.layout.signalling.signal[g].node) for g in signals},
            {s: names.REAR_CLEARED(s) for s in d.sections.all if come_in.from_signals(d, s) or come_in.in_order(d, s)},
            {s: names.SEEN_ALONE(s) for s in d.sections.all if come_in.in_order(d, s)},
            {s: names.AT_ONCE(s) for s in d.sections.all if come_in.in_order(d, s)},
        ),
        overlaps=_overlaps(d),
        token=block.tokens(d),
        condition={c.id: names.CONDITION(c.id) for c in d.layout.signalling.conditions},
        zone_full={z.id: names.ZONE_FULL(z.id) for z in d.layout.declared.zones},
        indication=_indications(d),
    )
