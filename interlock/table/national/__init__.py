"""National forms of the interlocking table: projections of the one table, one file a railway.

A form adds nothing that the table and the layout do not say; `SHEETS` names the forms of every profile.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from interlock.model.layout import Layout
from interlock.table.national.cn import chinese_table
from interlock.table.national.de import locking, shunt_routes, train_routes
from interlock.table.national.de_protection import flank, overlaps, two_way
from interlock.table.national.sheet import Heading, Sheet
from interlock.table.national.uk import points_table, route_table
from interlock.table.national.us import aspect_chart, locking_sheet, switch_table
from interlock.table.printed import Printed, unlisted
from interlock.table.rows import InterlockingTable

Form = Callable[[Layout, InterlockingTable], Sheet]

SHEETS: Mapping[str, tuple[Form, ...]] = {
    "generic": (locking_sheet, aspect_chart, switch_table),
    "cn": (chinese_table,),
    "uk": (route_table, points_table),
    "de": (train_routes, shunt_routes, overlaps, flank, two_way, locking),
}


def national_sheets(layout: Layout, table: InterlockingTable) -> tuple[Sheet, ...]:
    """The sheets that the layout's railway prints."""
    return tuple(_counted(form(layout, table), table) for form in SHEETS.get(layout.profile, ()))


_UNLISTED = {"zh": "另有 {} 条进路未列出", "de": "{} weitere nicht aufgeführt"}


def _counted(sheet: Sheet, table: InterlockingTable) -> Sheet:
    """The sheet, with a last row that tells how many routes are not listed, if any."""
    hidden = Printed(table).unlisted
    if not hidden or not sheet.of_routes:
        return sheet
    text = _UNLISTED[sheet.language].format(hidden) if sheet.language in _UNLISTED else unlisted(hidden)
    note = (text, *[""] * (len(sheet.headings) - 1))
    return replace(sheet, rows=(*sheet.rows, note))


__all__ = ["Heading", "Sheet", "national_sheets"]
