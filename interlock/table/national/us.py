"""An American route locking sheet: one line for each way, with its overlaps.

The columns follow what is usual; no worked example was at hand.
"""

from __future__ import annotations

from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.table.national.reading import Reading
from interlock.table.national.sheet import Cell, Heading, Sheet, route_rows
from interlock.table.rows import ExitKind, InterlockingTable, RouteKind, RouteRow

COLUMNS = (
    Heading("Entering signal", "始端", "Start"),
    Heading("Exit", "终端", "Ziel"),
    Heading("Movement", "性质", "Art"),
    Heading("Switches normal", "道岔定位", "Weichen +"),
    Heading("Switches reverse", "道岔反位", "Weichen −"),
    Heading("Derails", "脱轨器", "Gleissperren"),
    Heading("Opposing and conflicting signals locked", "敌对信号", "Gesperrte Signale"),
    Heading("Track circuits (OS)", "轨道区段", "Freimeldung"),
    Heading("Approach circuit", "接近区段", "Annäherung"),
    Heading("Time locking (s)", "延时", "Zeitverschluss"),
    Heading("Traffic locking", "方向闭锁", "Streckenblock"),
    Heading("Remarks", "备注", "Bemerkung"),
)


_KINDS = {RouteKind.MAIN: "train", RouteKind.SHUNT: "shunt", RouteKind.CALL_ON: "call-on"}


def locking_sheet(layout: Layout, table: InterlockingTable) -> Sheet:
    """The sheet of a layout."""
    x = Reading(layout, table)
    title = Heading("Route locking sheet", "进路锁闭表", "Verschlussblatt")
    rows = route_rows(x.printed.listed, lambda _, r: _route(x, r))
    return Sheet("us_locking", "en", title, COLUMNS, rows, True)


def _route(x: Reading, r: RouteRow) -> tuple[Cell, ...]:
    signals = sorted({x.table.route[h.route].entry for h in r.hostile if x.table.route[h.route].entry != r.entry})
    remarks = [f"{p.machine} closed" for p in r.points if p.machine in x.layout.device]
    remarks += [*r.requirements]
    if r.overlap is not None:
        remarks.append("overlap " + ", ".join(s for s, _ in r.overlap.ways))
    if r.berth is not None:
        remarks.append(f"{r.berth} may be occupied")
    return (
        r.entry,
        r.exit,
        _KINDS[r.kind],
        x.points(r, Position.NORMAL),
        x.points(r, Position.REVERSE),
        x.derailers(r),
        tuple(signals),
        tuple(x.sections(r)),
        ", ".join(r.approach.sections),
        f"{r.approach.delay_s:g}",
        ", ".join(b.section for b in r.block) if r.exit_kind is ExitKind.BOUNDARY else "",
        "; ".join(remarks),
    )
