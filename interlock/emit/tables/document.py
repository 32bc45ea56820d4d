"""table.json: every row of the table, and each thing that many rows share said once.

Reasons, cells, the ways in which routes are hostile, and the groups of routes that are so in one way stand in lists of
their own (`reasons`, `cells`, `hostilities`, `hostile_groups`), and rows tell the place in the list, counted from 0.
Routes are named by id, in `hostile_groups` by number.  A line is an item of a list, so that two tables can be compared
line by line.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, field, fields
from operator import attrgetter
from typing import Any

from interlock.dataclass import dataclass
from interlock.model.elements import RouteId
from interlock.model.layout import Layout
from interlock.table.cells import (
    ApproachCell,
    AspectCell,
    BarredCell,
    Because,
    BlockCell,
    ClearCell,
    ClosingCell,
    ConditionCell,
    Exclusion,
    FlankCell,
    FoulCell,
    Hostile,
    HostileRoutes,
    Hostility,
    OverlapCell,
    PointDemand,
    ReleaseStep,
    SpaceCell,
    SpeedCell,
    TokenCell,
    ZoneCell,
)
from interlock.table.rows import SCHEMA_VERSION, InterlockingTable, RouteRow

SCHEMA = f"interlock-table/{SCHEMA_VERSION}"


@dataclass(frozen=True)
class HostileGroup:
    """Routes, by number, that are hostile in one way: `how` is its place in `hostilities`, counted from 0."""

    how: int
    routes: tuple[int, ...]


ONLY_STATED = frozenset({"onward", "destination", "passed", "demanded_clear", "hold", "indicator"})
"""Keys that are written only where they say something."""

ROUTE = {
    **{key: key for key in ("id", "number", "kind", "names", "entry")},
    "entry_node": "path.entry_node",
    "exit": "exit",
    **{key: f"path.{key}" for key in ("exit_kind", "variant", "traversals", "berth", "length")},
    **{key: f"locking.{key}" for key in ("points", "driven")},
    **{key: f"clear.{key}" for key in ("sections", "foul")},
    "flank": "locking.flank",
    "space": "clear.space",
    **{key: f"locking.{key}" for key in ("hostile", "barred", "overlap")},
    **{key: f"signal.{key}" for key in ("aspect", "closing", "speed")},
    "conditions": "conditions.external",
    **{key: f"conditions.{key}" for key in ("zones", "block", "token")},
    **{key: f"locking.{key}" for key in ("approach", "release")},
    **{key: key for key in ("listed", "because")},
    **{key: f"path.{key}" for key in ("onward", "destination", "passed")},
    "demanded_clear": "clear.demanded",
}
"""The keys of a route as it is written, in their order, and where each stands in the row."""

TOPOLOGY = {
    "sections": "track.sections",
    "edges": "track.edges",
    "points": "pointwork.points",
    "crossings": "pointwork.crossings",
    "signals": "signalling.signals",
    "boundaries": "track.boundaries",
    "buffers": "track.buffers",
    "devices": "signalling.devices",
}
"""What a reader of the table needs of the layout: the graph in which its nodes, edges and sections are found.

The keys, and where each stands in the layout."""

CELLS: tuple[type, ...] = (
    PointDemand,
    ClearCell,
    FoulCell,
    FlankCell,
    SpaceCell,
    Exclusion,
    BarredCell,
    ConditionCell,
    ZoneCell,
    BlockCell,
    TokenCell,
    OverlapCell,
    AspectCell,
    ApproachCell,
    SpeedCell,
    ClosingCell,
    ReleaseStep,
)
"""What stands in `cells`, under these names; each tells rule and text of its reason."""


def table_json(layout: Layout, table: InterlockingTable) -> str:
    """Canonical JSON with a versioned schema (`schema.py`)."""
    writer = _Writer({r.id: r.number for r in table.routes})
    rows = {f.name: [writer.value(x) for x in getattr(table, f.name)] for f in fields(table) if f.name not in _HEAD}
    head = {"schema": SCHEMA, **{name: getattr(table, name) for name in _HEAD}}
    cells = {c.__name__: writer.cells[c] for c in CELLS}
    topology = {key: [asdict(x) for x in attrgetter(place)(layout)] for key, place in TOPOLOGY.items()}
    told = {"hostilities": writer.hostilities, "hostile_groups": [*map(asdict, writer.groups)]}
    shared = {**told, "reasons": writer.reasons, "cells": cells, "topology": topology}
    return document(head, rows | shared)


_HEAD = ("layout", "layout_digest")


def document(head: Mapping[str, str], lists: Mapping[str, Any]) -> str:
    """A JSON object of texts, and of lists and mappings of lists: a line is an item of a list."""
    parts = [*((name, _text(x)) for name, x in head.items()), *((name, _lines(x)) for name, x in lists.items())]
    return "{" + ",\n".join(f'"{name}": {text}' for name, text in parts) + "}\n"


def _lines(value: Mapping[str, Any] | Sequence[Any]) -> str:
    if isinstance(value, Mapping):
        return "{\n" + ",\n".join(f'"{name}": {_lines(x)}' for name, x in value.items()) + "}"
    return "[\n" + ",\n".join(map(_text, value)) + "]" if value else "[]"


def _text(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))


_ROUTE = {key: attrgetter(place) for key, place in ROUTE.items()}


@dataclass
class _Writer:
    """The lists of what rows share, as they are met."""

    number: Mapping[RouteId, int]
    reasons: list[Any] = field(default_factory=list)
    hostilities: list[Any] = field(default_factory=list)
    groups: dict[HostileGroup, int] = field(default_factory=dict)
    cells: dict[type, list[Any]] = field(default_factory=lambda: {c: [] for c in CELLS})
    _place: dict[Any, int] = field(default_factory=dict)

    def value(self, x: Any) -> Any:
        """A value as it is written in a row."""
        kind = type(x)
        if kind is tuple:
            return [self.value(v) for v in x]
        if kind is HostileRoutes:
            return self._hostile(x)
        if kind is Because:
            return self._in(self.reasons, x)
        if kind in self.cells:
            return self._in(self.cells[kind], x)
        return self._fields(x) if hasattr(kind, "__dataclass_fields__") else x

    def _fields(self, x: Any) -> dict[str, Any]:
        places = _ROUTE if type(x) is RouteRow else {f: attrgetter(f) for f in x.__dataclass_fields__}
        said = ((f, place(x)) for f, place in places.items())
        return {f: self.value(v) for f, v in said if v is not None or f not in ONLY_STATED}

    def _in(self, shared: list[Any], x: Any) -> int:
        """The place of a value in the list of its kind."""
        if x not in self._place:
            written = self._fields(x)
            self._place[x] = len(shared)
            shared.append(written)
        return self._place[x]

    def _hostile(self, routes: HostileRoutes) -> list[int]:
        """The groups of hostile routes."""
        found: dict[Hostility, list[Hostile]] = {}
        for h in routes:
            found.setdefault(h.how, []).append(h)
        groups = (
            HostileGroup(self._in(self.hostilities, how), tuple(self.number[h.route] for h in those))
            for how, those in found.items()
        )
        return [self.groups.setdefault(g, len(self.groups)) for g in groups]
