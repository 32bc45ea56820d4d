"""The shipped layouts, and a shortcut from a layout to its system."""

from __future__ import annotations

from functools import cache, lru_cache
from pathlib import Path

from interlock.app.check import check_file
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.logic.controller import Controller
from interlock.logic.expr import UniqueTable, current_table
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable

SHIPPED = tuple(sorted(p.stem for p in Path(__file__).resolve().parent.parent.joinpath("layouts").glob("*.yaml")))


def built(name: str) -> tuple[Layout, InterlockingTable, Controller]:
    """Layout, table and controller of a shipped layout: values that nobody changes, made once in a process."""
    return _built(name, current_table())


@cache
def _built(name: str, _: UniqueTable) -> tuple[Layout, InterlockingTable, Controller]:
    """For each table of equal expressions its own: nodes of two tables are never the same."""
    checked = check_file(f"layouts/{name}.yaml")
    assert checked.ok and checked.layout is not None and checked.table is not None, checked.diagnostics
    return checked.layout, checked.table, lower(checked.layout, checked.table)


def grown(text: str) -> tuple[Layout, InterlockingTable, Sink] | None:
    """Layout and table of a text, or None when the front end refuses it: values that nobody changes, the last ones made
    once (a layout that grows at random is read to see which routes it must exclude, most of them none)."""
    return _grown(text, current_table())


@lru_cache(4)
def _grown(text: str, table: UniqueTable) -> tuple[Layout, InterlockingTable, Sink] | None:
    sink = Sink()
    layout, _ = load_text("grown.yaml", text, sink)
    if layout is None:
        return None
    return layout, derive(layout, sink), sink


SLIPS = """interlock: 1
name: slips
boundaries: {A: {approach: aa 300}, B: {approach: bb 300}, C: {approach: cc 300}, D: {approach: dd 300}}
tracks: {a: [A, a1 200], b: [b1 200, B], c: [C, c1 200], d: [d1 200, D]}
slips:
  7: {section: T, arms: [[a.end, b.start], [c.end, d.start]]%s}
signals:
  SA: {from: A, into: a1}
  SB: {from: B, into: b1}
  SC: {from: C, into: c1}
  SD: {from: D, into: d1}
"""
"""Four tracks at a slip, which gets further keys at `%s`."""
