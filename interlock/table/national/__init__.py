"""National forms of the interlocking table: projections of the one table, one file a railway.

A form adds nothing that the table and the layout do not say; `SHEETS` names the forms of every profile.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from interlock.model.layout import Layout
from interlock.table.national.cn import chinese_table
from interlock.table.national.de import flank, overlaps, shunt_routes, train_routes, two_way
from interlock.table.national.sheet import Heading, Sheet
from interlock.table.national.uk import points_table, route_table
from interlock.table.national.us import locking_sheet
from interlock.table.rows import InterlockingTable

Form = Callable[[Layout, InterlockingTable], Sheet]

SHEETS: Mapping[str, tuple[Form, ...]] = {
    "generic": (locking_sheet,),
    "cn": (chinese_table,),
    "uk": (route_table, points_table),
    "de": (train_routes, shunt_routes, overlaps, flank, two_way),
}


def national_sheets(layout: Layout, table: InterlockingTable) -> tuple[Sheet, ...]:
    """The sheets that the layout's railway prints."""
    return tuple(form(layout, table) for form in SHEETS.get(layout.profile, ()))


__all__ = ["Heading", "Sheet", "national_sheets"]
