"""The order of the lowering, and the symbols through which claims read the result."""

from __future__ import annotations

from interlock.logic.controller import Controller, RouteSymbols, Symbols, Timer
from interlock.logic.expr import TRUE
from interlock.logic.lower import added, aspects, block, overlaps, points, requests, routes, sections, ways, zones
from interlock.logic.lower.draft import Draft
from interlock.model.elements import Position, SectionId
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.model.principles import Local
from interlock.table.rows import InterlockingTable, RouteKind

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
        layout.name, tuple(d.inputs), tuple(d.state), tuple(d.steps), tuple(d.next), tuple(d.outputs), _symbols(d)
    )


def _indications(d: Draft) -> dict[str, str]:
    """What tells an operator something: the output by what it is about (`locked S`, `late M`, ...)."""
    found = {f"locked {s}": f"YL_{portable(s)}" for s in d.sections}
    found |= {f"faulty {s}": f"YF_{portable(s)}" for s in d.healthy}
    found |= {f"late {m}": f"YA_{portable(m)}" for m in d.machines}
    found |= {f"trailed {m}": f"YT_{portable(m)}" for m in d.powered}
    return found | {f"full {z.id}": f"YZ_{portable(z.id)}" for z in d.layout.zones}


def _symbols(d: Draft) -> Symbols:
    signals = [g.id for g in d.layout.signals if d.routes_from[g.id]]
    lit = d.open_for_trains if d.layout.principles.lamp_proof else []

    def each(prefix: str) -> dict[SectionId, str]:
        return {s: f"{prefix}_{portable(s)}" for s in d.sections}

    return Symbols(
        valid="VALID",
        request=requests.REQUEST,
        local_request=requests.LOCAL if d.layout.principles.local_requests is not Local.NONE else None,
        local_first=d.layout.principles.local_requests is Local.FIRST,
        fresh={x: requests.FRESH[x] for x in requests.inputs_of(d)},
        seen={x: requests.SEEN[x] for x in requests.inputs_of(d)},
        automatic={r.number: requests.switch(r) for r in d.automatic},
        clear={s.id: f"CLR_{portable(s.id)}" for s in d.layout.sections if s.detected},
        healthy=d.healthy,
        blocked={s: f"BLK_{portable(s)}" for s in d.lockable},
        detected={(m, x): f"D{x}_{portable(m)}" for m in d.machines for x in Position},
        command={(m, x): f"C{x}_{portable(m)}" for m in d.machines for x in Position},
        by_hand={(m, x): f"M{x}_{portable(m)}" for m in d.machines for x in Position},
        trailed={m: f"TR_{portable(m)}" for m in d.powered},
        seen_right={m: f"TH_{portable(m)}" for m in d.powered},
        looked_at={m: f"TC_{portable(m)}" for m in d.powered},
        condition={c.id: f"E_{portable(c.id)}" for c in d.layout.conditions},
        stop_lamp={g.id: f"RL_{portable(g.id)}" for g in d.layout.signals} if d.layout.principles.lamp_proof else {},
        clear_lamp={g: f"GL_{portable(g)}" for g in lit},
        caution_lamp={g: f"CL_{portable(g)}" for g in lit if aspects.cautions(d)},
        drive={(m, x): f"Y{x}_{portable(m)}" for m in d.machines for x in Position},
        turn={m: f"Z_{portable(m)}" for m in d.machines if d.started(m) is not TRUE},
        started="SG" if any(isinstance(s, Timer) and s.name == "SGT" for s in d.steps) else None,
        late_timer={m: f"ST_{portable(m)}" for m in d.machines},
        release_timer=each("RT"),
        running="PWR",
        restart_timer=sections.RESTART_DELAY,
        start_timer="SGT" if any(isinstance(s, Timer) and s.name == "SGT" for s in d.steps) else None,
        **aspects.lamps(d),
        speed_shown={(g, kmh): name for g in d.open_for_trains for kmh, name in aspects.speeds(d, g).items()},
        distant_clear={x.id: f"YD_{portable(x.id)}" for x in d.layout.distants},
        distant_caution={x.id: f"YC_{portable(x.id)}" for x in d.layout.distants},
        indication=_indications(d),
        zone_full={z.id: f"ZF_{portable(z.id)}" for z in d.layout.zones},
        restart=each("K"),
        train=each("M") if d.shunting else {},
        lock={t.key: f"L_{portable(t.section)}_{t.number}" for t in d.table.locks},
        firm=each("F"),
        used=each("U"),
        passed=each("P"),
        release={s: f"REL_{portable(s)}" for s in d.sections},
        release_all="RELALL",
        stale=each("D"),
        cancel={g: f"CAN_{portable(g)}" for g in signals},
        cancelling={g: f"X_{portable(g)}" for g in signals},
        approach_timer={g: f"AT_{portable(g)}" for g in signals},
        approach_of={g: d.rear(d.first_section(g), d.layout.signal[g].node) for g in signals},
        overlap={o: f"V_{portable(o[0])}_{o[1]}" for o in d.overlaps},
        overlap_ways=dict(d.overlaps),
        overlap_firm={g: f"VF_{portable(g)}" for g in sorted({g for g, _ in d.overlaps})},
        token=block.tokens(d),
        swings={g: f"VS_{portable(g)}" for g in d.swinging},
        swing_request={g: d.swing_number(g) for g in d.swinging},
        overlap_timer={g: f"OT_{portable(g)}" for g in sorted({g for g, _ in d.overlaps})},
        routes=tuple(
            RouteSymbols(
                r.id,
                r.number,
                r.entry,
                r.kind is RouteKind.SHUNT,
                r.kind is RouteKind.CALL_ON,
                r.locked,
                r.traversals[-1] if r.berth is not None else None,
                (r.overlap.signal, r.overlap.option) if r.overlap is not None else None,
                f"A_R{r.number}",
                f"B_R{r.number}",
                f"W_R{r.number}",
                f"S_R{r.number}",
                f"H_R{r.number}",
                f"PA_R{r.number}" if r.closing.whole is not None else None,
                r.names,
                added.holds(r),
                tuple(d.table.route[c.route].number for c in r.barred),
                tuple((p.machine, p.position) for p in r.added),
            )
            for r in d.table.routes
        ),
        demands={t.key: tuple((p.machine, p.position) for p in t.points) for t in d.table.locks},
        excluded={t.key: tuple((e.section, e.whole, e.numbers) for e in t.exclusions) for t in d.table.locks},
        ends=dict(d.topo.ends),
    )
