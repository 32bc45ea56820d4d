"""The shipped layouts, and a shortcut from a layout to its system."""

from __future__ import annotations

from pathlib import Path

from interlock.app.check import check_file
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable

SHIPPED = tuple(sorted(p.stem for p in Path(__file__).resolve().parent.parent.joinpath("layouts").glob("*.yaml")))


def built(name: str) -> tuple[Layout, InterlockingTable, Controller]:
    """Layout, table and controller of a shipped layout."""
    checked = check_file(f"layouts/{name}.yaml")
    assert checked.ok and checked.layout is not None and checked.table is not None, checked.diagnostics
    return checked.layout, checked.table, lower(checked.layout, checked.table)


def grown(text: str) -> tuple[Layout, InterlockingTable, Sink] | None:
    """Layout and table of a text, or None when the front end refuses it."""
    sink = Sink()
    layout, _ = load_text("grown.yaml", text, sink)
    if layout is None:
        return None
    return layout, derive(layout, sink), sink
