"""From the YAML tree to a `LayoutFile`, or to diagnostics IL1009-IL1017, each at the place of which it speaks."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ValidationError

from interlock.diag import Sink, Span
from interlock.diag.suggest import did_you_mean
from interlock.frontend import schema
from interlock.frontend.scalars import MAX_NAME
from interlock.frontend.yaml_tree import Mapping, Node, Scalar, Sequence


def plain(node: Node) -> Any:
    """The tree as plain Python data; every scalar is text."""
    if isinstance(node, Scalar):
        return node.text
    if isinstance(node, Sequence):
        return [plain(n) for n in node.items]
    return {k: plain(v) for k, (_, v) in node.items.items()}


def span_of(root: Node, path: tuple[str | int, ...], *, key: bool = False) -> Span:
    """The place of the value (or key) at a path; the nearest enclosing node when the path ends early."""
    node: Node = root
    span = root.span
    for step in path:
        if isinstance(node, Mapping) and str(step) in node.items:
            k, node = node.items[str(step)]
            span = k.span if key or not isinstance(node, Scalar) or not node.text else node.span
        elif isinstance(node, Sequence) and isinstance(step, int) and step < len(node.items):
            node = node.items[step]
            span = node.span
        else:
            break
    return span


def _names(*parts: type[BaseModel]) -> tuple[str, ...]:
    return tuple(f.alias or n for part in parts for n, f in part.model_fields.items())


_KEYS: dict[str, tuple[str, ...]] = {
    "": _names(schema.LayoutFile),
    "boundaries": _names(schema.BoundarySpec),
    "points": _names(schema.PointSpec),
    "crossings": _names(schema.CrossingSpec, schema.ArmSpec),
    "slips": _names(schema.SlipSpec),
    "derailers": _names(schema.DerailerSpec),
    "level_crossings": _names(schema.DeviceSpec),
    "interlocks": _names(schema.DeviceSpec),
    "signals": _names(schema.SignalSpec),
    "distants": _names(schema.DistantSpec),
    "principles": _names(schema.PrinciplesSpec),
    "overlaps": _names(schema.OverlapSpec),
    "exclude": _names(schema.ExcludeSpec),
    "sections": _names(schema.SectionSpec),
    "conditions": _names(schema.ConditionSpec),
    "zones": _names(schema.ZoneSpec),
    "routes": _names(schema.RouteSpec),
    "voyages": _names(schema.VoyageSpec),
    "automatic": _names(schema.RouteSpec),
    "waive": _names(schema.WaiverSpec),
}
_CODES = {
    "missing": "IL1010",
    "extra_forbidden": "IL1011",
    "number": "IL1013",
    "range": "IL1014",
    "version": "IL1015",
    "name": "IL1016",
    "choice": "IL1017",
    "reason": "IL2009",
}


def validate(root: Node, sink: Sink) -> schema.LayoutFile | None:
    """The file as typed data, or None with every shape error reported."""
    if not isinstance(root, Mapping):
        sink.add(
            "IL1009",
            "this is not a layout: a mapping of keys to values is expected",
            root.span,
            "a layout begins with `interlock: 1`",
        )
        return None
    if "interlock" not in root.items and not ({"tracks", "signals"} & set(root.items)):
        sink.add(
            "IL1009",
            "this is not a layout: the key `interlock` is missing",
            root.span,
            "a layout begins with `interlock: 1`",
        )
        return None
    try:
        return schema.LayoutFile.model_validate(plain(root), by_alias=True)
    except ValidationError as error:
        report_shape(root, error, _KEYS, sink)
        return None


def report_shape(root: Node, error: ValidationError, keys: dict[str, tuple[str, ...]], sink: Sink) -> None:
    """Every error of shape as a diagnostic at its place; `keys`: the known keys of each room, "" for the file's."""
    for e in error.errors(include_url=False):
        _report(root, e["type"], tuple(e["loc"]), e["msg"], e.get("ctx", {}), keys, sink)


def _report(
    root: Node,
    kind: str,
    loc: tuple[str | int, ...],
    text: str,
    ctx: dict[str, Any],
    keys: dict[str, tuple[str, ...]],
    sink: Sink,
) -> None:
    path = tuple(p for p in loc if p != "[key]" and not (isinstance(p, str) and p.startswith("function-")))
    on_key = "[key]" in loc
    code = _CODES.get(kind, "IL1012")
    room = str(path[0]) if len(path) > 1 else ""
    if kind == "missing":
        span, where = span_of(root, path[:-1], key=True), ".".join(map(str, path[:-1])) or "the file"
        sink.add(code, f"{where} lacks the key `{path[-1]}`", span, f"add `{path[-1]}: ...`")
    elif kind == "extra_forbidden":
        known = keys.get(room, ())
        sink.add(code, f"unknown key `{path[-1]}`", span_of(root, path, key=True), did_you_mean(str(path[-1]), known))
    elif code == "IL1012":
        got = _kind_at(root, path)
        want = _WANT.get(kind, "another shape")
        sink.add(
            code,
            f"{'.'.join(map(str, path))}: {want} is expected here, not {got}",
            span_of(root, path),
            "see `interlock explain IL1012`",
        )
    else:
        fix = ctx.get("fix", _FIX.get(code, ""))
        if code == "IL1017":
            fix = did_you_mean(str(ctx.get("v", "")), ctx.get("known", ()))
        sink.add(code, f"{'.'.join(map(str, path))}: {text}", span_of(root, path, key=on_key), fix)


_WANT = {
    "dict_type": "a mapping",
    "model_type": "a mapping",
    "model_attributes_type": "a mapping",
    "list_type": "a list",
    "string_type": "a text",
    "shape": "a text",
    "too_short": "a list of two",
    "too_long": "a list of two",
}
_FIX = {
    "IL1013": "write metres or seconds as a plain decimal number, for instance 350 or 12.5",
    "IL1014": "give a length above 0 and at most 100 km, or a time above 0 and at most a day",
    "IL1015": "this release reads `interlock: 1`",
    "IL1016": f"at most {MAX_NAME} ASCII letters and digits; put the full name into `title` or `label`",
    "IL2009": "say why a vehicle can never roll from there",
}


def _kind_at(root: Node, path: tuple[str | int, ...]) -> str:
    node: Node = root
    for step in path:
        if isinstance(node, Mapping) and str(step) in node.items:
            node = node.items[str(step)][1]
        elif isinstance(node, Sequence) and isinstance(step, int) and step < len(node.items):
            node = node.items[step]
        else:
            break
    if isinstance(node, Scalar):
        return f"the text '{node.text[:40]}'" if node.text else "nothing"
    return f"a list of {len(node.items)}" if isinstance(node, Sequence) else "a mapping"
