"""An American route locking sheet: one line per route.

The columns follow what is usual; no worked example was at hand.
"""

from __future__ import annotations

from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.table.national.reading import Reading
from interlock.table.national.sheet import Heading, Sheet
from interlock.table.rows import ExitKind, InterlockingTable, RouteKind

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
    rows = []
    for r in table.listed:
        signals = sorted({table.route[h.route].entry for h in r.hostile if table.route[h.route].entry != r.entry})
        remarks = [f"{p.machine} closed" for p in r.points if p.machine in layout.device]
        remarks += [*r.requirements]
        if r.overlap is not None:
            remarks.append("overlap " + ", ".join(s for s, _ in r.overlap.ways))
        if r.berth is not None:
            remarks.append(f"{r.berth} may be occupied")
        rows.append(
            (
                r.entry,
                r.exit,
                _KINDS[r.kind],
                x.points(r, Position.NORMAL),
                x.points(r, Position.REVERSE),
                x.derailers(r),
                ", ".join(signals),
                ", ".join(x.sections(r)),
                ", ".join(r.approach.sections),
                f"{r.approach.delay_s:g}",
                ", ".join(b.section for b in r.block) if r.exit_kind is ExitKind.BOUNDARY else "",
                "; ".join(remarks),
            )
        )
    return Sheet(
        "us_locking", "en", Heading("Route locking sheet", "进路锁闭表", "Verschlussblatt"), COLUMNS, tuple(rows), True
    )
