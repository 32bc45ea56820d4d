"""The JSON Schema of table.json, made from the values that are written there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import is_dataclass
from functools import reduce
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from pydantic import BaseModel, Field, create_model

from interlock.emit.tables.document import CELLS, ONLY_STATED, ROUTE, SCHEMA, TOPOLOGY
from interlock.model.layout import Layout
from interlock.model.places import Approach
from interlock.table.cells import Because, HostileRoutes, Hostility
from interlock.table.rows import InterlockingTable, RouteRow

DRAFT = "https://json-schema.org/draft/2020-12/schema"


def table_schema() -> dict[str, Any]:
    """The JSON Schema (2020-12) of table.json; every object has all of its keys, and no other."""
    models = _Models()
    parts = get_type_hints(InterlockingTable)
    topology = create_model("Topology", __doc__=TOPOLOGY_TEXT, **_required(_hints(Layout, TOPOLOGY)))
    cells = create_model("Cells", __doc__=CELLS_TEXT, **_required({c.__name__: list[models.of(c)] for c in CELLS}))  # type: ignore[misc]
    shared = {
        "hostilities": Annotated[list[models.of(Hostility)], Field(description=HOSTILITIES_TEXT)],  # type: ignore[misc]
        "hostile_groups": Annotated[list[HostileGroup], Field(description=GROUPS_TEXT)],
        "reasons": Annotated[list[models.of(Because)], Field(description=REASONS_TEXT)],  # type: ignore[misc]
        "cells": cells,
        "topology": topology,
    }
    named: Any = {"schema_": (Literal[SCHEMA], Field(alias="schema"))}
    rows = {name: models.written(kind) for name, kind in parts.items()}
    table = create_model("Table", **named, **_required(rows | shared))
    made = _closed(table.model_json_schema(mode="serialization"))
    about = "An interlocking table as interlock writes it: routes, the locks of which they are made, and the track."
    return {"$schema": DRAFT, **made, "title": SCHEMA, "description": about}


ROUTE_TEXT = """One route: entry, exit, alternative, and every derived column.

`berth`: the shunt route ends in a plain section in which vehicles may stand; it is the last traversal, and the
only one that need not be clear.  `driven` points are moved along and never checked.  `barred`: those of the hostile
routes that the author declares so.  `listed`: whether the route is printed.
`onward`: past the signal at its exit, which shows its identifier light, the train runs on over this route, of kind
identifier, which may run on over another in the same way; they are set together.  `destination`: where the last
ends.  `passed`: the signals that the train passes at identifier light, in order.
`demanded_clear`: sections beside or beyond the path that the author has it find clear; None where there are none."""
TOPOLOGY_TEXT = "The track as a graph: edges, each within one section, meet at nodes; what stands at a node names it."
CELLS_TEXT = "The cells of the table by kind, each once; rows tell the place of theirs, counted from 0."
HOSTILITIES_TEXT = "The ways in which routes are hostile, each once; `hostile_groups` tell places, counted from 0."
GROUPS_TEXT = "Routes that are hostile in one way, each group once; `hostile` of a route tells places, counted from 0."
REASONS_TEXT = "Rules and reasons, each once; whatever has a reason tells its place, counted from 0, as `because`."


class HostileGroup(BaseModel):
    """Routes, by number, that are hostile in one way: `how` is its place in `hostilities`, counted from 0."""

    how: Annotated[int, Field(ge=0)]
    routes: list[Annotated[int, Field(ge=1, description="number of a route (`number`), counted from 1: no place")]]


class _Models:
    """Rows and cells as they are written: places for cells and reasons, and numbers for hostile routes."""

    def __init__(self) -> None:
        self._made: dict[type, type[BaseModel]] = {}

    def of(self, kind: type) -> type[BaseModel]:
        """The written form of a row or cell."""
        if kind not in self._made:
            said = _hints(RouteRow, ROUTE) if kind is RouteRow else get_type_hints(kind)
            hints = {name: self.written(hint) for name, hint in said.items()}
            text = ROUTE_TEXT if kind is RouteRow else kind.__doc__
            self._made[kind] = create_model(kind.__name__, __doc__=text, **_required(hints))
        return self._made[kind]

    def written(self, hint: Any) -> Any:
        """The written form of a type."""
        if hint is HostileRoutes:
            return list[Annotated[int, Field(ge=0, description="place in `hostile_groups`")]]
        if hint is Because or hint in CELLS:
            text = "place in `reasons`" if hint is Because else f"place in `{hint.__name__}` of `cells`"
            return Annotated[int, Field(ge=0, description=text)]
        if get_origin(hint) is tuple and get_args(hint)[-1] is ...:
            return list[self.written(get_args(hint)[0])]  # type: ignore[misc]
        if hint is Approach:  # holds others of its kind, and neither cells nor reasons
            return hint
        if get_origin(hint) in (Union, UnionType):
            return Union[tuple(map(self.written, get_args(hint)))]  # noqa: UP007
        return self.of(hint) if is_dataclass(hint) and isinstance(hint, type) else hint


def _hints(kind: type, places: Mapping[str, str]) -> dict[str, Any]:
    """The types of what stands at some places in a value, by key."""
    return {
        key: reduce(lambda t, name: get_type_hints(t)[name], place.split("."), kind) for key, place in places.items()
    }


def _required(kinds: dict[str, Any]) -> dict[str, Any]:
    return {name: (kind, ...) for name, kind in kinds.items()}


def _closed(value: Any) -> Any:
    """Objects with exactly their keys; without titles, which only repeat these."""
    if isinstance(value, list):
        return [_closed(v) for v in value]
    if not isinstance(value, dict):
        return value
    out = {k: _closed(v) for k, v in value.items() if k not in ("title", "default") or isinstance(v, dict)}
    if out.get("type") == "object" and "properties" in out:
        required = [key for key in out["properties"] if key not in ONLY_STATED]
        out |= {"required": required, "additionalProperties": False}
    return out
