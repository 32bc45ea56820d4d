"""American sheets: route locking, route and aspect chart, switch table.

The columns are those that railroads usually print; no worked example was at hand, and the AREMA manual was not read.
"""

from __future__ import annotations

from interlock.model.elements import MachineId, Position, RouteId, Work
from interlock.model.layout import Layout
from interlock.model.times import supervision_s
from interlock.table.cells import ExitKind, Role, RouteKind, Shows
from interlock.table.national.reading import DERAILER, NOT_CHECKED, Reading
from interlock.table.national.sheet import Field, Heading, Sheet, by_way, filled
from interlock.table.printed import Said, grouped
from interlock.table.rows import InterlockingTable, RouteRow, leads_to
from interlock.table.runs import in_runs, legend, natural

SOURCE = "after usual American practice; no worked example was at hand, and no standard was read"
_KINDS = {RouteKind.MAIN: "train", RouteKind.SHUNT: "shunt", RouteKind.CALL_ON: "call-on", RouteKind.IDENTIFIER: "part"}


def _remarks(x: Reading, r: RouteRow) -> tuple[str, ...]:
    said = x.machines.devices_lie(r)
    said += [*r.requirements, *(f"{m} held {r.locking.hold:g} s longer" for m in r.locking.held_longer)]
    if r.locking.overlap is not None:
        said.append("overlap " + ", ".join(s for s, _ in r.locking.overlap.ways))
    if r.path.berth is not None:
        said.append(f"{r.path.berth} may be occupied")
    return tuple(said)


def _conflicting(x: Reading, r: RouteRow) -> tuple[list[str], list[str]]:
    """Signals whose routes conflict; of one whose routes conflict with some of their overlaps alone, these routes."""
    found: dict[str, list[Said[None]]] = {}
    for s in grouped(((h, None) for h in r.locking.hostile.routes), x.printed.ways):
        found.setdefault(s.way.rows[0].entry, []).append(s)
    found.pop(r.entry, None)
    signals = [g for g, those in found.items() if any(s.whole for s in those)]
    routes = [s.name() for g, those in found.items() if g not in signals for s in those]
    return in_runs(sorted(signals, key=natural)), sorted(routes, key=natural)


def locking_sheet(layout: Layout, table: InterlockingTable) -> Sheet:
    """Route locking: one line per route."""
    x = Reading(layout, table)
    fields: tuple[Field[RouteRow], ...] = (
        Field(Heading("Route", "进路", "Fahrstraße"), lambda r: x.printed.ways[r.id].id),
        Field(Heading("Entering signal", "始端", "Start"), lambda r: r.entry),
        Field(Heading("Exit", "终端", "Ziel"), leads_to),
        Field(Heading("Movement", "性质", "Art"), lambda r: _KINDS[r.kind]),
        Field(Heading("Switches normal", "道岔定位", "Weichen +"), lambda r: x.machines.points(r, Position.NORMAL)),
        Field(Heading("Switches reverse", "道岔反位", "Weichen −"), lambda r: x.machines.points(r, Position.REVERSE)),
        Field(Heading("Derails", "脱轨器", "Gleissperren"), lambda r: ", ".join(x.machines.derailers_lie(r))),
        Field(
            Heading("Opposing and conflicting signals locked", "敌对信号", "Gesperrte Signale"),
            lambda r: tuple(name for names in _conflicting(x, r) for name in names),
        ),
        Field(Heading("Track circuits (OS)", "轨道区段", "Freimeldung"), lambda r: tuple(x.sections(r))),
        Field(
            Heading("Approach circuit", "接近区段", "Anrückabschnitt"), lambda r: ", ".join(r.locking.approach.sections)
        ),
        Field(Heading("Time locking (s)", "延时", "Zeitverschluss"), lambda r: f"{r.locking.approach.delay_s:g}"),
        Field(
            Heading("Traffic locking", "方向闭锁", "Streckenblock"),
            lambda r: ", ".join(b.section for b in r.conditions.block) if r.path.exit_kind is ExitKind.BOUNDARY else "",
        ),
        Field(Heading("Remarks", "备注", "Bemerkung"), lambda r: _remarks(x, r)),
    )
    headings, rows = by_way(fields, x.printed.listed)
    title = Heading("Route locking sheet", "进路锁闭表", "Verschlussblatt")
    by_overlap = sorted({name for way in x.printed.listed for r in way.rows for name in _conflicting(x, r)[1]})
    meaning = "the route with this overlap (o2 in its row); with another one it does not conflict"
    signs = (*legend(rows), *((name, meaning) for name in by_overlap[:1]), *([NOT_CHECKED] if x.drives else []))
    return Sheet("us_locking", "en", title, headings, rows, True, SOURCE, legend=signs)


def _over(x: Reading, r: RouteRow) -> str:
    """The switches along the way, in order: 1 N, 3 R; derails are on or off."""
    ends = [(p, position) for key in r.path.traversals for p, position in x.way(key).points]
    point = x.layout.pointwork.point
    told = ((p, DERAILER[position] if point[p].derailer else position) for p, position in ends)
    return ", ".join(f"{p} {lies}" for p, lies in told)


_ALWAYS = {
    Shows.CLEAR: "clear",
    Shows.CAUTION: "caution",
    Shows.TWO_YELLOWS: "two yellows",
    Shows.SHUNT: "shunt",
    Shows.CALL_ON: "call-on",
}
_ALWAYS |= {Shows.IDENTIFIER: "identifier"}


def _at_stop(r: RouteRow) -> str:
    return "caution" if r.signal.aspect.shows is Shows.NEXT else _ALWAYS[r.signal.aspect.shows]


def _at_proceed(r: RouteRow) -> str:
    return "clear" if r.signal.aspect.shows is Shows.NEXT else _ALWAYS[r.signal.aspect.shows]


def aspect_chart(layout: Layout, table: InterlockingTable) -> Sheet:
    """Route and aspect chart: what the entering signal shows for each route, by the next signal."""
    x = Reading(layout, table)
    fields: tuple[Field[RouteRow], ...] = (
        Field(Heading("Entering signal", "始端", "Start"), lambda r: r.entry),
        Field(Heading("Exit", "终端", "Ziel"), lambda r: r.exit),
        Field(Heading("Movement", "性质", "Art"), lambda r: _KINDS[r.kind]),
        Field(Heading("Switches in order", "道岔", "Weichen"), lambda r: _over(x, r)),
        Field(Heading("Track circuits", "轨道区段", "Abschnitte"), lambda r: ", ".join(r.path.section_ids)),
        Field(
            Heading("Speed (km/h)", "速度 (km/h)", "Geschwindigkeit (km/h)"),
            lambda r: "" if r.signal.speed.kmh is None else str(r.signal.speed.kmh),
        ),
        Field(Heading("Next signal", "次架信号", "Nächstes Signal"), lambda r: r.signal.aspect.next or ""),
        Field(Heading("Aspect, next at stop", "次架停车时", "Begriff, nächstes Halt"), _at_stop),
        Field(Heading("Aspect, next at proceed", "次架开放时", "Begriff, nächstes Fahrt"), _at_proceed),
        Field(
            Heading("Returns to stop", "关闭", "Haltfall"),
            lambda r: "first axle" if r.signal.closing.whole is None else f"{r.signal.closing.whole} clear",
        ),
        Field(Heading("Route", "进路", "Fahrstraße"), lambda r: x.printed.ways[r.id].id),
    )
    headings, rows = by_way(fields, x.printed.listed)
    title = Heading("Route and aspect chart", "进路与显示表", "Fahrstraßen und Signalbegriffe")
    return Sheet(
        "us_aspects",
        "en",
        title,
        headings,
        rows,
        True,
        SOURCE,
        ("heads and lamps of each aspect", "rule numbers"),
        legend=(
            ("clear, caution", "by meaning; their names and lamps are the railroad's"),
            ("1 N, 1 R", "switch 1 normal, reverse"),
        ),
    )


def switch_table(layout: Layout, table: InterlockingTable) -> Sheet:
    """Switch table: what works each machine, and which routes hold it in either position."""
    x = Reading(layout, table)
    users: dict[tuple[MachineId, Position, bool], dict[RouteId, None]] = {}
    for r in (r for way in x.printed.listed for r in way.rows):
        for p in r.locking.points:
            flank = p.role in (Role.FLANK, Role.ADDED)
            users.setdefault((p.machine, p.position, flank), {})[r.id] = None

    def by(m: MachineId, position: Position, flank: bool = False) -> tuple[str, ...]:
        return x.named(users.get((m, position, flank), ()))

    def hand(m: MachineId) -> str:
        side = x.machines.machine_side(m, Position.REVERSE)
        return "" if side is None else f"{side} hand"

    def speed(m: MachineId) -> str:
        return ", ".join(dict.fromkeys(str(p.speed) for p in layout.machines.ends[m] if p.speed is not None))

    normal, reverse = Position.NORMAL, Position.REVERSE
    fields: tuple[Field[MachineId], ...] = (
        Field(Heading("Switch", "道岔", "Weiche"), lambda m: m),
        Field(Heading("Ends", "岔尖", "Enden"), lambda m: ", ".join(p.id for p in layout.machines.ends[m])),
        Field(Heading("Kind", "种类", "Art"), lambda m: _kind_of(layout, m)),
        Field(Heading("Turnout", "开向", "Abzweig"), hand),
        Field(Heading("Reverse (km/h)", "反位速度 (km/h)", "− (km/h)"), speed),
        Field(
            Heading("Detector locking (track circuits)", "区段锁闭", "Abschnitte"),
            lambda m: ", ".join(layout.machines.sections[m]),
        ),
        Field(Heading("Normal for routes", "定位进路", "+ für"), lambda m: by(m, normal)),
        Field(Heading("Reverse for routes", "反位进路", "− für"), lambda m: by(m, reverse)),
        Field(Heading("Normal, protecting", "定位防护", "+ Flankenschutz"), lambda m: by(m, normal, True)),
        Field(Heading("Reverse, protecting", "反位防护", "− Flankenschutz"), lambda m: by(m, reverse, True)),
        Field(Heading("Supervision (s)", "监视 (s)", "Überwachung (s)"), lambda m: f"{supervision_s(layout, m):g}"),
    )
    headings, rows = filled(fields, sorted(layout.machines.ends, key=natural))
    title = Heading("Switch table", "道岔表", "Weichentabelle")
    return Sheet("us_switches", "en", title, headings, rows, False, SOURCE, ("type of machine", "lock rods"))


def _kind_of(layout: Layout, m: MachineId) -> str:
    ends = layout.machines.ends[m]
    if layout.machines.is_derailer(m):
        return "derail"
    worked = "hand-worked, keyed" if any(p.work is Work.HAND for p in ends) else "switch"
    return f"{worked}, with derail" if any(p.derailer for p in ends) else worked
