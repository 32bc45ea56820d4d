"""From the YAML tree to a `LayoutFile`, or to diagnostics IL1009-IL1017, each at the place of which it speaks."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ValidationError

from interlock.diag import Sink
from interlock.frontend import schema
from interlock.frontend.principles import PrinciplesSpec
from interlock.frontend.shapes import report_shape, span_of
from interlock.frontend.yaml_tree import Mapping, Node, Scalar, Sequence

__all__ = ["plain", "report_shape", "span_of", "validate"]


def plain(node: Node) -> Any:
    """The tree as plain Python data; every scalar is text."""
    if isinstance(node, Scalar):
        return node.text
    if isinstance(node, Sequence):
        return [plain(n) for n in node.items]
    return {k: plain(v) for k, (_, v) in node.items.items()}


def _names(*parts: type[BaseModel]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(f.alias or n for part in parts for n, f in part.model_fields.items()))


_KEYS: dict[str, tuple[str, ...]] = {
    "": _names(schema.LayoutFile),
    "boundaries": _names(schema.BoundarySpec),
    "points": _names(schema.PointSpec),
    "crossings": _names(schema.CrossingSpec, schema.ArmSpec),
    "slips": _names(schema.SlipSpec),
    "derailers": _names(schema.DerailerSpec),
    "level_crossings": _names(schema.DeviceSpec),
    "interlocks": _names(schema.InterlockSpec),
    "signals": _names(schema.SignalSpec),
    "distants": _names(schema.DistantSpec),
    "principles": _names(PrinciplesSpec),
    "overlaps": _names(schema.OverlapSpec, schema.OverlapWaySpec),
    "exclude": _names(schema.ExcludeSpec),
    "sections": _names(schema.SectionSpec),
    "conditions": _names(schema.ConditionSpec),
    "zones": _names(schema.ZoneSpec),
    "health": _names(schema.HealthSpec),
    "hostile": _names(schema.HostileSpec, schema.ChoiceSpec),
    "demand": _names(schema.DemandSpec, schema.ChoiceSpec),
    "routes": _names(schema.NamedSpec),
    "voyages": _names(schema.VoyageSpec),
    "automatic": _names(schema.RouteSpec),
    "waive": _names(schema.WaiverSpec),
    "allow": _names(schema.AllowSpec),
    "target": _names(schema.TargetSpec),
    "title_block": _names(schema.TitleBlockSpec),
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
