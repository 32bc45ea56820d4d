"""The layout language as others read it: a JSON Schema for editors, and the page of the language.

Both are made from `schema`, where each key has its type, its meaning and its default.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from interlock.frontend.scalars import PATTERNS
from interlock.frontend.schema import LayoutFile

WITHOUT = "; without it, "
HEAD = ("| key | value | without it | meaning |", "|---|---|---|---|")
DRAFT = "http://json-schema.org/draft-07/schema#"


class _Plain(GenerateJsonSchema):
    """What is not given is left out: no key may be null."""

    def nullable_schema(self, schema: core_schema.NullableSchema) -> JsonSchemaValue:
        return self.generate_inner(schema["schema"])

    def encode_default(self, dft: Any) -> Any:
        return {} if isinstance(dft, BaseModel) else super().encode_default(dft)


def json_schema(model: type[BaseModel] = LayoutFile, title: str = "interlock layout") -> dict[str, Any]:
    """The JSON Schema (draft-07) of the layout language, or of another file, for completion in editors."""
    schema = _draft_07(model.model_json_schema(by_alias=True, schema_generator=_Plain))
    assert isinstance(schema, dict)
    return {"$schema": DRAFT, **schema, "title": title}


def _draft_07(value: Any) -> Any:
    """draft-07 keeps shared parts under `definitions`, ignores what stands beside a reference, and an empty default
    says nothing; titles only repeat the keys."""
    if isinstance(value, list):
        return [_draft_07(v) for v in value]
    if isinstance(value, str):
        return value.replace("#/$defs/", "#/definitions/")
    if not isinstance(value, dict):
        return value
    out = {("definitions" if k == "$defs" else k): _draft_07(v) for k, v in value.items()}
    if isinstance(out.get("title"), str):
        del out["title"]
    if "default" in out and out["default"] is None:
        del out["default"]
    if "$ref" in out and len(out) > 1:
        out["allOf"] = [{"$ref": out.pop("$ref")}]
    return out


def language_keys() -> str:
    """Every key of the language in Markdown, part by part: what it is, what it is without it, what it means."""
    schema = json_schema()
    out = []
    for title, part in _parts(schema):
        out += [
            f"### {title}",
            "",
            str(part["description"]),
            "",
            "| key | value | without it | meaning |",
            "|---|---|---|---|",
        ]
        required = part.get("required", ())
        for name, said in part["properties"].items():
            meaning, _, without = said["description"].partition(WITHOUT)
            without = "must be given" if name in required else without or _default(said)
            out.append(f"| `{name}` | {_value(said, schema)} | {without} | {meaning} |")
        out.append("")
    return "\n".join(out)


def _parts(schema: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Every mapping of the language with its heading, in the order of the keys; what two keys share comes once."""
    users: dict[str, list[str]] = {}
    todo = [("", schema)]
    yield "The layout", schema
    while todo:
        where, part = todo.pop(0)
        for name, said in part["properties"].items():
            body = _body(said, schema)
            if body is not None and "properties" in body[1]:
                users.setdefault(body[0], []).append(f"`{where}{name}`")
                if len(users[body[0]]) == 1:
                    todo.append((f"{where}{name}.", body[1]))
    for kind, names in users.items():
        yield " and ".join(names), schema["definitions"][kind]


def _body(said: dict[str, Any], schema: dict[str, Any]) -> tuple[str, dict[str, Any]] | None:
    """The definition that a key, its entries, or the values under its names refer to."""
    inner = said
    for step in ("allOf", "items", "additionalProperties"):
        inner = inner.get(step, inner) if isinstance(inner.get(step), (dict, list)) else inner
        inner = inner[0] if isinstance(inner, list) else inner
    ref = inner.get("$ref") or next((v.get("$ref") for v in said.get("patternProperties", {}).values()), None)
    if not isinstance(ref, str):
        return None
    name = ref.rsplit("/", 1)[1]
    return name, schema["definitions"][name]


def _value(said: dict[str, Any], schema: dict[str, Any]) -> str:
    """What kind of value a key has, in words."""
    body = _body(said, schema)
    kind = said.get("type")
    if "enum" in said or (body and "enum" in body[1]):
        words = [w for w in (said.get("enum") or (body[1]["enum"] if body else ())) if isinstance(w, str)]
        return ", ".join(f"`{w}`" for w in words if w not in ("true", "false"))
    if "const" in said:
        return f"`{said['const']}`"
    if kind == "array":
        count = f"list of {said['maxItems']}" if "maxItems" in said else "list"
        return f"{count}: {_value(said['items'], schema)}"
    if kind == "object":
        inner = next(iter(said.get("patternProperties", {}).values()), None) or said["additionalProperties"]
        return f"each name: {_value(inner, schema)}"
    if body is not None:
        return "mapping, see below"
    if "pattern" in said:
        return PATTERNS[said["pattern"]]
    if kind in ("number", "integer"):
        return _number(said)
    return "text"


def _number(said: dict[str, Any]) -> str:
    word = "whole number" if said["type"] == "integer" else "number"
    if "exclusiveMinimum" in said:
        return f"{word} above {said['exclusiveMinimum']:g}, to {said['maximum']:g}"
    return f"{word}, {said['minimum']:g} to {said['maximum']:g}" if "minimum" in said else word


def _default(said: dict[str, Any]) -> str:
    value = said["default"]
    if value in ("", [], {}):
        return "none"
    if isinstance(value, bool):
        return "`yes`" if value else "`no`"
    return f"`{value:g}`" if isinstance(value, float) else f"`{value}`"
