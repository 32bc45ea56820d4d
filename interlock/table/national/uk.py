"""British control tables in the columns of examination papers: routes, and points in two halves."""

from __future__ import annotations

from interlock.model.elements import MachineId, Position
from interlock.model.layout import Layout
from interlock.table.national.reading import ON_PATH, Reading
from interlock.table.national.sheet import Cell, Heading, Sheet, route_rows
from interlock.table.printed import Printed, PrintedRoute
from interlock.table.rows import InterlockingTable, Role, RouteKind, RouteRow

ROUTES = (
    Heading("Route", "进路", "Fahrstraße"),
    Heading("Exit", "终端", "Ziel"),
    Heading("Class", "类别", "Art"),
    Heading("Points N", "道岔定位", "Weichen +"),
    Heading("Points R", "道岔反位", "Weichen −"),
    Heading("Flank N", "防护道岔定位", "Flankenschutz +"),
    Heading("Flank R", "防护道岔反位", "Flankenschutz −"),
    Heading("Conflicting routes", "敌对进路", "Feindliche Fahrstraßen"),
    Heading("Tracks clear (route, foul, overlap)", "轨道区段", "Freimeldung"),
    Heading("Overlap", "保护区段", "Durchrutschweg"),
    Heading("Overlap released after", "保护区段解锁", "Auflösung D-Weg"),
    Heading("Approach locked", "接近锁闭", "Annäherungsverschluss"),
    Heading("Approach release", "接近解锁", "Auflösung"),
    Heading("Remarks", "备注", "Bemerkung"),
)
POINTS = (
    Heading("Points", "道岔", "Weiche"),
    Heading("N to R: called by routes", "定位到反位：进路", "+ nach −: durch Fahrstraßen"),
    Heading("N to R: locked by routes", "定位到反位：锁闭", "+ nach −: verschlossen durch"),
    Heading("R to N: called by routes", "反位到定位：进路", "− nach +: durch Fahrstraßen"),
    Heading("R to N: locked by routes", "反位到定位：锁闭", "− nach +: verschlossen durch"),
    Heading("Tracks that lock both ways", "锁闭区段", "verschließende Abschnitte"),
)


def uk_names(printed: Printed) -> dict[str, str]:
    """Names of routes, by that of their way: signal, letter from the left, class: 1A(M)."""
    letters: dict[str, int] = {}
    out = {}
    for way in printed.all:
        r = way.rows[0]
        k = letters.get(r.entry, 0)
        letters[r.entry] = k + 1
        out[way.id] = f"{r.entry}{_letter(k)}({_class(r)})"
    return out


def _letter(k: int) -> str:
    return (_letter(k // 26 - 1) if k >= 26 else "") + chr(ord("A") + k % 26)


def _class(r: RouteRow) -> str:
    return {RouteKind.MAIN: "M", RouteKind.SHUNT: "S", RouteKind.CALL_ON: "C"}[r.kind]


def route_table(layout: Layout, table: InterlockingTable) -> Sheet:
    """One line per route, with its overlaps."""
    reading = Reading(layout, table)
    names = uk_names(reading.printed)
    return Sheet(
        "uk_routes",
        "en",
        Heading("Control table: routes", "控制表：进路", "Kontrolltabelle: Fahrstraßen"),
        ROUTES,
        route_rows(reading.printed.listed, lambda way, r: _route(reading, names, way, r)),
        True,
    )


def _route(x: Reading, names: dict[str, str], way: PrintedRoute, r: RouteRow) -> tuple[Cell, ...]:
    seconds = x.layout.overlap_release_s(r.overlap.signal) if r.overlap else 0.0
    rear = ", ".join(r.approach.sections)
    remarks = [f"{p.machine} closed" for p in r.points if p.machine in x.layout.device]
    remarks += [f"{p.machine} {x.layout.word(p.machine, p.position)}" for p in r.points if x.is_derailer(p.machine)]
    remarks += [*r.requirements] + [f"{b.section} clear (line)" for b in r.block]
    if r.closing.whole is not None:
        remarks.append(f"replaced by last wheel: {r.closing.whole} clear")
    if r.berth is not None:
        remarks.append(f"{r.berth} may be occupied")
    if r.overlap is not None and r.overlap.swings:
        remarks.append(f"overlap may swing to {', '.join(f'o{k}' for k in r.overlap.swings)}")
    flank = [c for c in r.flank if any(p.kind.value == "signal" for p in c.providers)]
    stops = sorted({p.name for c in flank for p in c.providers if p.kind.value == "signal"})
    if stops:
        remarks.append(f"{', '.join(stops)} at stop")
    return (
        names[way.id],
        r.exit,
        _class(r),
        x.points(r, Position.NORMAL, *ON_PATH),
        x.points(r, Position.REVERSE, *ON_PATH),
        x.points(r, Position.NORMAL, Role.FLANK, Role.ADDED),
        x.points(r, Position.REVERSE, Role.FLANK, Role.ADDED),
        x.named((h.route for h in r.hostile), lambda w: names[w.id], r),
        tuple(x.sections(r)),
        ", ".join(s for s, _ in r.overlap.ways) if r.overlap else "",
        f"{r.traversals[-1][0]} occupied {seconds:g} s" if r.overlap else "",
        f"when cleared, {rear} occupied" if rear else "when cleared",
        f"{rear} clear, or {r.approach.delay_s:g} s" if rear else f"{r.approach.delay_s:g} s",
        "; ".join(remarks),
    )


def points_table(layout: Layout, table: InterlockingTable) -> Sheet:
    """One line per set of points: a route that needs a position locks against leaving it."""
    reading = Reading(layout, table)
    names = uk_names(reading.printed)
    rows = []
    for m in sorted(layout.ends_of_machine):
        by = {
            x: ", ".join(reading.named((r.id for r in table.routes if _needs(r, m, x)), lambda w: names[w.id]))
            for x in Position
        }
        tracks = ", ".join(layout.sections_of_machine[m])
        rows.append((m, by[Position.REVERSE], by[Position.NORMAL], by[Position.NORMAL], by[Position.REVERSE], tracks))
    title = Heading("Control table: points", "控制表：道岔", "Kontrolltabelle: Weichen")
    return Sheet("uk_points", "en", title, POINTS, tuple(rows))


def _needs(r: RouteRow, m: MachineId, x: Position) -> bool:
    return any(p.machine == m and p.position is x for p in r.points)
