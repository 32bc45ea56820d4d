"""What is published of the layout language and of table.json: every key described, every shipped file accepted."""

from __future__ import annotations

import copy
import json
import re
import sys
import unicodedata
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from operator import attrgetter
from pathlib import Path
from types import UnionType
from typing import Any, get_args, get_origin, get_type_hints

import jsonschema
import pytest
import yaml
from click.testing import CliRunner

from interlock.app.check import check_file
from interlock.app.init import yard
from interlock.cli.main import cli
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.tables.document import CELLS, ONLY_STATED, ROUTE, table_json
from interlock.emit.tables.schema import table_schema
from interlock.frontend import load_text
from interlock.frontend.published import WITHOUT, json_schema, language_keys
from interlock.frontend.scalars import NAME, PATTERNS
from interlock.frontend.schema import LayoutFile
from interlock.model.principles import KNOBS, MEANING
from interlock.table.cells import Because, HostileClass, HostileRoutes
from interlock.table.rows import InterlockingTable, RouteRow, TraversalRow, VoyageRow
from tests.layouts import SHIPPED

LANGUAGE = json_schema()
TABLE = table_schema()
ACCEPTED = [
    *(Path("layouts") / f"{n}.yaml" for n in SHIPPED),
    *sorted(Path("layouts/refuted").glob("*.yaml")),
    *sorted(p for p in Path("tests/layouts_for_tests").glob("*.yaml") if check_file(str(p)).ok),
]


class Core(yaml.SafeLoader):
    """YAML 1.2, as editors read it: `yes` and `12:30` are texts, and keys are texts."""


Core.yaml_implicit_resolvers = {}
for tag, form, first in (
    ("bool", r"true|false", "tf"),
    ("null", r"null|~|", ["n", "~", ""]),
    ("int", r"[-+]?[0-9]+", "-+0123456789"),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+.0123456789"),
):
    Core.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(rf"^(?:{form})$"), list(first))


def text_keys(value: Any) -> Any:
    """JSON has no other."""
    if isinstance(value, dict):
        return {str(k): text_keys(v) for k, v in value.items()}
    return [text_keys(v) for v in value] if isinstance(value, list) else value


def keys(schema: dict[str, Any]) -> Iterator[tuple[str, str, dict[str, Any]]]:
    """Every key: the part in which it stands ("" for the top), its name, and what is said of it."""
    for part, body in (("", schema), *schema["definitions"].items()):
        for name, said in body.get("properties", {}).items():
            yield part, name, said


def problems(value: Any, schema: dict[str, Any]) -> list[str]:
    found = jsonschema.validators.validator_for(schema)(schema).iter_errors(text_keys(value))
    return [f"{'/'.join(map(str, e.absolute_path))}: {e.message}" for e in found]


def test_both_schemas_are_schemas() -> None:
    jsonschema.Draft7Validator.check_schema(LANGUAGE)
    jsonschema.Draft202012Validator.check_schema(TABLE)
    for what, schema in (("layout", LANGUAGE), ("table", TABLE)):
        assert json.loads(CliRunner().invoke(cli, ["schema", "--of", what]).output) == schema


@pytest.mark.parametrize("path", ACCEPTED, ids=str)
@pytest.mark.parametrize("reader", [yaml.SafeLoader, Core])
def test_every_layout_that_is_shipped_is_accepted(path: Path, reader: type[yaml.SafeLoader]) -> None:
    assert problems(yaml.load(path.read_text("utf-8"), reader), LANGUAGE) == []


def test_parts_of_the_schemas_have_names_of_the_field() -> None:
    """No name of a module stands in what is published."""
    for name in (*LANGUAGE["definitions"], *TABLE["$defs"]):
        assert re.fullmatch(r"[A-Z][A-Za-z]+", name), name


def test_what_the_language_refuses_the_schema_refuses() -> None:
    good = yaml.load(Path("layouts/passing_loop.yaml").read_text("utf-8"), Core)
    for change in (
        {"interlock": 2},
        {"colour": "red"},
        {"profile": "fr"},
        {"points": {"1": {"section": "1DG", "toes": "west.end"}}},
        {"points": {"1": {"toe": "west.end"}}},
        {"points": {"1": {"section": "1DG", "toe": "west.middle"}}},
        {"points": {"1": {"section": "1DG", "legs": -4}}},
        {"tracks": {"west": ["W", "IAG  long"]}},
        {"signals": {"X": {"from": "W", "into": "IAG", "kind": "home"}}},
        {"zones": {"Z": {"sections": ["IG"], "trains": 0}}},
        {"principles": {"flank_space": "perhaps"}},
        {"exclude": [{"from": "X", "reason": ""}]},
        {"boundaries": {"W": {"approach": "XJG"}}},
    ):
        sink = Sink()
        load_text("changed.yaml", yaml.safe_dump({**good, **change}, allow_unicode=True), sink)
        assert sink.has_errors and problems({**good, **change}, LANGUAGE), change


def test_every_key_is_described_and_says_what_is_without_it() -> None:
    found = list(keys(LANGUAGE))
    assert len(found) >= 120 and len({(part, name) for part, name, _ in found}) == len(found)
    for part, name, said in found:
        where = LANGUAGE["definitions"].get(part, LANGUAGE)
        given = name in where.get("required", ()) or "default" in said or WITHOUT in said["description"]
        assert len(said["description"]) > 5 and given, (part, name)
        assert (
            "default" not in said or problems(said["default"], {**said, "definitions": LANGUAGE["definitions"]}) == []
        )
    assert set(MEANING) == set(KNOBS)


def given(part: dict[str, Any], value: dict[str, Any]) -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
    """Every mapping of a layout with what the schema says of its keys."""
    yield part, value
    for name, said in part["properties"].items():
        inner: Any = said
        for step in ("allOf", "items", "additionalProperties"):
            inner = inner[step] if isinstance(inner.get(step), (dict, list)) else inner
            inner = inner[0] if isinstance(inner, list) else inner
        of = inner.get("$ref") or next((v.get("$ref") for v in said.get("patternProperties", {}).values()), "")
        body = LANGUAGE["definitions"].get((of or "").rpartition("/")[2], {})
        if name in value and "properties" in body:
            found = value[name]
            each = [found] if "allOf" in said else list(found.values()) if isinstance(found, dict) else found
            for x in each:
                if isinstance(x, dict):
                    yield from given(body, x)


def derived_from(layout: dict[str, Any]) -> bytes | list[str]:
    sink = Sink()
    found, _ = load_text("x.yaml", yaml.safe_dump(layout, allow_unicode=True, sort_keys=False), sink)
    table = None if found is None else derive(found, sink)
    return [str(d) for d in sink.diagnostics] if found is None or table is None else table_json(found, table)


def test_a_default_that_is_written_changes_nothing() -> None:
    """Of every key, in a layout of every profile: an editor writes the default that the schema states.

    `blades` is of double slips alone, and refused of a single one.
    """
    tried: set[tuple[str, str, str]] = set()
    for path in ACCEPTED:
        layout = yaml.load(path.read_text("utf-8"), yaml.SafeLoader)
        profile = layout.get("profile", "generic")
        fresh = {
            (part["description"], name): {
                (profile if "release_delay_s" in part["properties"] else "", part["description"], name)
            }
            for part, value in given(LANGUAGE, {"principles": {}, **layout})
            for name, said in part["properties"].items()
            if name not in value and "default" in said
        }
        fresh = {where: names for where, names in fresh.items() if not names <= tried}
        base = derived_from(layout) if fresh else b""
        for where, names in fresh.items():
            tried |= names
            new = copy.deepcopy({"principles": {}, **layout})
            for part, value in given(LANGUAGE, new):
                if part["description"] == where[0] and where[1] not in value and "single" not in value:
                    value[where[1]] = copy.deepcopy(part["properties"][where[1]]["default"])
            assert derived_from(new) == base, (path, where)
    assert len({names[2] for names in tried}) > 60


def test_the_language_page_has_a_line_for_every_key_as_it_is_defined() -> None:
    page = Path("interlock/docs/language.md").read_text("utf-8")
    assert page.endswith("`interlock schema --of keys`.\n\n" + language_keys())
    for _, name, said in keys(LANGUAGE):
        assert any(
            line.startswith(f"| `{name}` |") and said["description"].partition(WITHOUT)[0] in line
            for line in page.splitlines()
        ), name


def test_the_examples_of_the_language_page_are_of_the_language() -> None:
    page = Path("interlock/docs/language.md").read_text("utf-8").split("## Every key")[0]
    rows = dict(re.findall(r"^\| `(\w+)` \| `(.*)` \|$", page, re.MULTILINE))
    assert list(rows) == [f.alias or n for n, f in LayoutFile.model_fields.items()]
    for key, text in rows.items():
        mapping = LANGUAGE["properties"][key].get("type") == "object" and not text.startswith("{")
        value = yaml.load(f"{{{text}}}" if mapping else text, Core)
        assert problems({"interlock": 1, "name": "x", key: value}, LANGUAGE) == [], key


@pytest.mark.parametrize("name", SHIPPED)
def test_every_table_is_as_its_schema_says(name: str) -> None:
    checked = check_file(f"layouts/{name}.yaml")
    assert checked.layout is not None and checked.table is not None
    body = json.loads(table_json(checked.layout, checked.table))
    assert problems(body, TABLE) == []
    nodes = {n for e in body["topology"]["edges"] for n in (e["a"], e["b"])}
    sections = {s["id"] for s in body["topology"]["sections"]}
    for route in body["routes"]:  # whatever a row names, a reader finds
        assert route["entry_node"] in nodes and {s for s, _ in route["traversals"]} <= sections
        assert len(set(route["hostile"])) == len(route["hostile"]) and all(
            body["hostile_groups"][k] for k in route["hostile"]
        )
    groups = body["hostile_groups"]
    assert all(h["routes"] == sorted(set(h["routes"])) for h in groups)
    assert len({json.dumps(h) for h in groups}) == len(groups)
    for how in body["hostilities"]:
        assert how["kind"] == how["kinds"][0] and len(set(how["kinds"])) == len(how["kinds"])


def places(kind: Any) -> dict[str, str]:
    """The keys of a value as it is written, and where each stands in it."""
    return ROUTE if kind is RouteRow else {f.name: f.name for f in fields(kind)}


def hint(kind: Any, place: str) -> Any:
    """The type of what stands there."""
    for name in place.split("."):
        kind = get_type_hints(kind)[name]
    return kind


def expanded(body: dict[str, Any], value: Any, kind: Any) -> Any:
    """A written value with everything that it tells the place of, as a reader of table.json would fill it in."""
    if kind is Because:
        rule, text = body["reasons"][value].values()
        return {"rule": rule, "text": text}
    if kind is HostileRoutes:
        groups = [body["hostile_groups"][k] for k in value]
        told = {n: body["hostilities"][h["how"]] for h in groups for n in h["routes"]}
        return [{"number": n, **told[n]} for n in sorted(told)]
    if get_origin(kind) is UnionType:
        return None if value is None else expanded(body, value, get_args(kind)[0])
    if get_origin(kind) is tuple and get_args(kind)[-1] is ...:
        return [expanded(body, v, get_args(kind)[0]) for v in value]
    if is_dataclass(kind):
        told = body["cells"][kind.__name__][value] if kind in CELLS else value
        hints = {key: hint(kind, place) for key, place in places(kind).items()}
        told = {
            name: told.get(name) if name in ONLY_STATED else told[name]
            for name in hints
            if name in told or name in ONLY_STATED
        }
        assert list(told) == list(hints)
        return {name: expanded(body, told[name], hint) for name, hint in hints.items()}
    return value


def whole(table: InterlockingTable, value: Any) -> Any:
    """The same of the table itself."""
    if isinstance(value, HostileRoutes):
        return [{"number": table.route[h.route].number, **whole(table, h.how)} for h in value]
    if isinstance(value, tuple):
        return [whole(table, v) for v in value]
    if is_dataclass(value):
        return {key: whole(table, attrgetter(place)(value)) for key, place in places(type(value)).items()}
    return value


def test_nothing_of_a_route_is_left_out() -> None:
    """Every cell that a route has in one of its parts is written, under a key of its own."""
    there = []
    for f in fields(RouteRow):
        kind = hint(RouteRow, f.name)
        part = is_dataclass(kind) and kind is not Because
        there += [f"{f.name}.{x.name}" for x in fields(kind)] if part else [f.name]
    assert sorted(there) == sorted(ROUTE.values())


@pytest.mark.parametrize("name", ["cn6502", "junction", "pit_bottom", "tests/layouts_for_tests/entry_speeds.yaml"])
def test_what_is_said_once_is_all_there(name: str) -> None:
    checked = check_file(name if "/" in name else f"layouts/{name}.yaml")
    assert checked.layout is not None and checked.table is not None
    body = json.loads(table_json(checked.layout, checked.table))
    for part, kind in (("routes", RouteRow), ("locks", TraversalRow), ("voyages", VoyageRow)):
        rows = [expanded(body, row, kind) for row in body[part]]
        assert rows == whole(checked.table, getattr(checked.table, part))
    for shared in (*body["cells"].values(), body["reasons"], body["hostilities"]):
        told = [json.dumps(x) for x in shared]
        assert len(set(told)) == len(told)


def test_a_large_table_is_small() -> None:
    """A yard of 328 routes and 48,020 entries of hostile routes: 22 MB when each of them told its own reason."""
    sink = Sink()
    layout, _ = load_text("yard.yaml", yard(40), sink)
    assert layout is not None
    assert len(table_json(layout, derive(layout, sink)).encode()) < 1_100_000


def test_a_table_that_says_something_else_is_refused() -> None:
    checked = check_file("layouts/fig2_2.yaml")
    assert checked.layout is not None and checked.table is not None
    body = json.loads(table_json(checked.layout, checked.table))
    kinds = TABLE["$defs"]["HostileClass"]["enum"]
    assert kinds == [k.value for k in HostileClass]
    for spoil in (
        lambda b: b.update(schema="interlock-table/1"),
        lambda b: b.pop("topology"),
        lambda b: b["routes"][0].update(colour="red"),
        lambda b: b["routes"][0].pop("overlap"),
        lambda b: b["hostilities"][0]["kinds"].append("unfriendly"),
        lambda b: b["routes"][0]["hostile"].append("X"),
        lambda b: b["hostile_groups"][0]["routes"].append("X"),
        lambda b: b["routes"][0]["points"].append(-1),
        lambda b: b["cells"]["ClearCell"][0].pop("because"),
        lambda b: b["topology"]["edges"][0].update(length="long"),
    ):
        other = copy.deepcopy(body)
        spoil(other)
        assert problems(other, TABLE)


def test_the_schema_takes_every_name_that_the_language_takes_and_few_others() -> None:
    """Of every sign of Unicode in a name.  What it takes for a letter, and is none, are marks and rare symbols."""
    (pattern,) = {p for p, called in PATTERNS.items() if called == "name"}
    name = re.compile(pattern)
    wrong = []
    for number in range(sys.maxunicode + 1):
        text = f"a{chr(number)}1"
        tool, schema = (x.fullmatch(text) is not None for x in (NAME, name))
        assert schema or not tool, ascii(text)
        if schema and not tool and unicodedata.category(text[1]) not in ("Cn", "Co", "Cs"):
            wrong.append(text[1])
    common = [c for c in wrong if c < "\u0300" or unicodedata.category(c)[0] == "Z" or "\u2000" <= c < "\u2100"]
    assert not common and not set(wrong) & set("，、；：。！？（）［］｛｝【】《》「」・～＃／－＿＝＋№℃·×÷§°±→←●★")
    assert len(wrong) < 9_000, len(wrong)


NAMES = [
    "q1",
    "底1",
    "𠮷1",
    "q1#",
    "q，1",
    "№1",
    "①",
    "ª",
    "é",
    "e\u0301x",
    "x\u200dy",
    "Ⅳ",
    "a·b",
    "a\u3000b",
    "a１",
    "_a",
    "a__b",
]


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_one_to_the_schema_and_to_the_language(name: str) -> None:
    text = (
        "interlock: 1\nname: x\nboundaries: {W: {approach: a0 600}}\nbuffers: [B]\n"
        f"tracks: {{t: [W, {name} 400, B]}}\nsignals: {{S1: {{from: W, into: {name}}}}}\n"
    )
    sink = Sink()
    load_text("name.yaml", text, sink)
    assert sink.has_errors == bool(problems(yaml.load(text, yaml.BaseLoader) | {"interlock": 1}, LANGUAGE))
