"""The JSON Schema of table.json, made from the values that are written there."""

from __future__ import annotations

from typing import Any, Literal, get_type_hints

from pydantic import Field, create_model

from interlock.emit.tables.export import SCHEMA, TOPOLOGY
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable

DRAFT = "https://json-schema.org/draft/2020-12/schema"


def table_schema() -> dict[str, Any]:
    """The JSON Schema (2020-12) of table.json; every object has all of its keys, and no other."""
    kinds, parts = get_type_hints(Layout), get_type_hints(InterlockingTable)
    topology = create_model("Topology", __doc__=TOPOLOGY_TEXT, **_required({k: kinds[k] for k in TOPOLOGY}))
    named: Any = {"schema_": (Literal[SCHEMA], Field(alias="schema"))}
    table = create_model("Table", **named, **_required({**parts, "topology": topology}))
    made = _closed(table.model_json_schema(mode="serialization"))
    about = "An interlocking table as interlock writes it: routes, the locks of which they are made, and the track."
    return {"$schema": DRAFT, **made, "title": SCHEMA, "description": about}


TOPOLOGY_TEXT = "The track as a graph: edges, each within one section, meet at nodes; what stands at a node names it."


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
        out |= {"required": list(out["properties"]), "additionalProperties": False}
    return out
