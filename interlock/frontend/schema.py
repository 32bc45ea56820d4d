"""The layout language: keys, shapes and types.  One definition for validation and JSON Schema.

Input: the YAML tree.  Output: a `LayoutFile`, or diagnostics IL1009-IL1017.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Any, Literal

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    ValidationError,
    WithJsonSchema,
)

from interlock.diag import Sink
from interlock.diag.codes import LINTS
from interlock.frontend.scalars import (
    Amount,
    End,
    Length,
    Name,
    Reason,
    Seconds,
    Speed,
    Text,
    YesNo,
    choice,
    level,
    number,
    trains,
    version,
)
from interlock.frontend.shapes import report_shapes
from interlock.frontend.yaml_tree import Mapping, Node, Scalar, Sequence
from interlock.model.elements import BlockKind, SignalKind, TelegramForm, Work
from interlock.model.overlap import overlap_length
from interlock.model.principles import KNOBS, PROFILES, Caution, Closes, FlankChoice, Local, Principles


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class BoundarySpec(_Part):
    """Where trains come in or leave."""

    approach: Annotated[Text | None, Field(description="approach section outside: `name length`")] = None
    trains: Annotated[Literal["both", "in", "out"], choice("direction", ("both", "in", "out"))] = "both"
    label: Text = ""
    block: Annotated[Literal["none", "semi-automatic", "automatic", "token"], choice("block", tuple(BlockKind))] = (
        "none"
    )
    button: Annotated[Text, Field(description="button that ends departure routes here, as printed")] = ""
    indicator: Annotated[YesNo, Field(description="departures this way have a route indicator")] = False


class PointSpec(_Part):
    """A set of points; each end names what it is joined to (`track.start`, `point.toe`, a boundary)."""

    section: Name
    toe: End | None = None
    normal: End | None = None
    reverse: End | None = None
    machine: Annotated[Name | None, Field(description="machine, where one works two ends")] = None
    legs: Annotated[Length | None, Field(description="length of each of the three legs in metres")] = None
    fouling: Annotated[Length | None, Field(description="distance to the fouling point in metres")] = None
    speed: Annotated[Speed | None, Field(description="km/h permitted over the reverse leg")] = None
    work: Annotated[
        Literal["motor", "hand"],
        choice("kind of work", tuple(Work)),
        Field(description="hand: worked on the spot; a key locks it in normal"),
    ] = "motor"


class DerailerSpec(_Part):
    """A derailer between two ends: `outer` is where vehicles stand that must not run off, `inner` what it protects."""

    section: Name
    outer: End | None = None
    inner: End | None = None
    legs: Length | None = None


class SlipSpec(_Part):
    """A slip: a diamond whose arms are also joined by slip rails.

    Arms are pairs of ends, `[1a, 1b]` and `[2a, 2b]`.  A double slip joins 1a to 2b and 2a to 1b; `single` names the
    only pair that is joined.  Each side has a machine, `NAMEa` and `NAMEb` unless `machines` says otherwise; one name
    for both sides means one machine.
    """

    section: Name
    arms: Annotated[list[list[End]], Field(min_length=2, max_length=2)]
    single: Annotated[Literal["1a-2b", "2a-1b"] | None, choice("pair of ends", ("1a-2b", "2a-1b"))] = None
    machines: list[Name] = []
    legs: Length | None = None
    fouling: Length | None = None


class DeviceSpec(_Part):
    """A level crossing, or a bridge, door or hoist, closed for every movement over the sections."""

    over: Annotated[list[Name], Field(min_length=1)]
    text: Text = ""


class ArmSpec(_Part):
    """One arm of a diamond crossing."""

    section: Name
    ends: Annotated[list[End], Field(min_length=2, max_length=2)]


class CrossingSpec(_Part):
    """A diamond crossing of two arms."""

    arms: Annotated[list[ArmSpec], Field(min_length=2, max_length=2)]
    legs: Length | None = None


_KINDS = tuple(k.value for k in SignalKind)


class SignalSpec(_Part):
    """A signal at the joint between two sections, read by movements that go into `into`."""

    from_: Annotated[Name, Field(alias="from")]
    into: Name
    at: Annotated[Name | None, Field(description="a point next to the joint, if sections meet twice")] = None
    kind: Annotated[Literal["main", "shunt", "combined"], choice("kind of signal", _KINDS)] = "main"
    call_on: Annotated[YesNo, Field(description="it can call trains on over sections reported occupied")] = False


class DistantSpec(_Part):
    """A distant or repeating signal: what it announces."""

    of: Name


class SectionSpec(_Part):
    """More about a section."""

    speed: Annotated[Speed | None, Field(description="km/h permitted in the section")] = None
    lane: Annotated[Literal["level", "inclined"], choice("lane", ("level", "inclined"))] = "level"
    detected: Annotated[YesNo, Field(description="no: a siding without detection, always taken as occupied")] = True
    one_way: Annotated[
        Literal["forward", "backward"] | None,
        choice("direction", ("forward", "backward")),
        Field(description="only this way along the track as it is written"),
    ] = None


class ConditionSpec(_Part):
    """A named input from outside that routes require."""

    text: Text = ""
    over: list[Name] = []
    signals: list[Name] = []
    exits: list[Name] = []


class ZoneSpec(_Part):
    """Sections in which no more than so many trains may be."""

    sections: list[Name]
    trains: Annotated[int, BeforeValidator(trains), WithJsonSchema({"type": "integer", "minimum": 1, "maximum": 99})]


class OverlapSpec(_Part):
    """The overlap beyond a main signal: its length, or the speed and gradient from which the length follows."""

    length: Annotated[Text | None, Field(description="metres; 0 for no overlap")] = None
    speed: Annotated[Length | None, Field(description="km/h towards the signal")] = None
    falling: Annotated[Text, Field(description="permille falling towards the signal; negative when it rises")] = "0"
    successive: Annotated[YesNo, Field(description="as far as the next main signal, a boundary or the track's end")] = (
        False
    )
    swing: Annotated[YesNo, Field(description="another alternative can be taken while a route leads to the signal")] = (
        False
    )

    def metres(self) -> float:
        """The length, infinite for a successive route; raises PydanticCustomError when a number is malformed."""
        if self.successive:
            return float("inf")
        if self.length is not None:
            return number(self.length)
        return overlap_length(self.speed or 0.0, number(self.falling))


class ExcludeSpec(_Part):
    """Routes that shall not be: all that fit what is given; the reason says why."""

    from_: Annotated[Name | None, Field(alias="from")] = None
    to: Name | None = None
    via: list[Name] = []
    kind: Annotated[Literal["main", "shunt"] | None, choice("kind of route", ("main", "shunt"))] = None
    reason: Reason


class RouteSpec(_Part):
    """A name for a derived route."""

    from_: Annotated[Name, Field(alias="from")]
    to: Name
    via: list[Name] = []


class VoyageSpec(RouteSpec):
    """A chain of routes that one command sets."""

    kind: Annotated[Literal["main", "shunt"], choice("kind of route", ("main", "shunt"))] = "main"
    order: Annotated[Literal["near", "far"] | None, choice("order", ("near", "far"))] = None
    direction: Annotated[Literal["forward", "reverse"], choice("direction", ("forward", "reverse"))] = "forward"


class WaiverSpec(_Part):
    """Flank protection given up on purpose."""

    flank: Annotated[Text, Field(description="leg of a point: `point.normal` or `point.reverse`")]
    reason: Reason = ""


class AllowSpec(_Part):
    """Usual practice departed from on purpose: which warning is not to be given, at which elements, and why."""

    lint: Annotated[
        str,
        choice("warning of usual practice", LINTS),
        WithJsonSchema({"enum": list(LINTS)}),
        Field(description="code"),
    ]
    at: Annotated[list[Name], Field(min_length=1, description="the elements: sections, signals, boundaries, points")]
    reason: Reason


class PrinciplesSpec(_Part):
    """Single knobs of the profile, overridden."""

    release_delay_s: Seconds | None = None
    approach_release_s: Seconds | None = None
    shunt_release_s: Seconds | None = None
    point_supervision_s: Seconds | None = None
    point_start_gap_s: Amount | None = None
    fouling_m: Seconds | None = None
    clearance_m: Seconds | None = None
    leg_m: Seconds | None = None
    flank_by: Annotated[FlankChoice | None, choice("protection", tuple(FlankChoice))] = None
    flank_space: YesNo | None = None
    flank_lamp: YesNo | None = None
    drive_points: YesNo | None = None
    sensor_faults: YesNo | None = None
    lamp_proof: YesNo | None = None
    caution: Annotated[Caution | None, choice("use of caution", tuple(Caution))] = None
    overlap_m: Amount | None = None
    overlap_release_s: Seconds | None = None
    local_requests: Annotated[Local | None, choice("rule for local requests", tuple(Local))] = None
    priorities: YesNo | None = None
    priority_wait_s: Amount | None = None
    token_delay_s: Seconds | None = None
    token_agreed_s: Seconds | None = None
    line_speed_kmh: Seconds | None = None
    shunt_speed_kmh: Seconds | None = None
    braking_ms2: Seconds | None = None
    reaction_s: Seconds | None = None
    output_delay_s: Seconds | None = None
    point_run_s: Seconds | None = None
    restart_delay_s: Seconds | None = None
    slow_below_kmh: Amount | None = None
    main_closes: Annotated[Closes | None, choice("closing of signals", tuple(Closes))] = None
    shunt_closes: Annotated[Closes | None, choice("closing of signals", tuple(Closes))] = None

    def override(self, base: Principles) -> Principles:
        """The profile's principles with these knobs."""
        return replace(base, **{k: v for k in KNOBS if (v := getattr(self, k)) is not None})


class LayoutFile(_Part):
    """A track layout for interlock."""

    interlock: Annotated[int, BeforeValidator(version), WithJsonSchema({"const": 1})]
    name: Name
    title: Text = ""
    profile: Annotated[str, choice("profile", tuple(PROFILES)), WithJsonSchema({"enum": list(PROFILES)})] = "generic"
    principles: PrinciplesSpec = PrinciplesSpec()
    boundaries: dict[Name, BoundarySpec] = {}
    buffers: list[Name] = []
    traps: list[Name] = []
    tracks: dict[Name, list[Text]] = {}
    points: dict[Name, PointSpec] = {}
    crossings: dict[Name, CrossingSpec] = {}
    slips: dict[Name, SlipSpec] = {}
    derailers: dict[Name, DerailerSpec] = {}
    level_crossings: dict[Name, DeviceSpec] = {}
    interlocks: dict[Name, DeviceSpec] = {}
    signals: dict[Name, SignalSpec] = {}
    distants: dict[Name, DistantSpec] = {}
    sections: dict[Name, SectionSpec] = {}
    conditions: dict[Name, ConditionSpec] = {}
    zones: dict[Name, ZoneSpec] = {}
    routes: dict[Name, RouteSpec] = {}
    voyages: dict[Name, VoyageSpec] = {}
    automatic: list[RouteSpec] = []
    exclude: list[ExcludeSpec] = []
    overlaps: dict[Name, OverlapSpec] = {}
    waive: list[WaiverSpec] = []
    allow: list[AllowSpec] = []
    substations: Annotated[
        dict[Name, list[Text]], Field(description="cabinets, each with the elements wired to it; one may be left empty")
    ] = {}
    drawing: Annotated[
        dict[Name, Annotated[int, BeforeValidator(level), WithJsonSchema({"type": "integer"})]],
        Field(description="hints for the plan, section: tracks above (or, negative, below) the longest run"),
    ] = {}
    telegram: Annotated[TelegramForm, choice("telegram", tuple(TelegramForm))] = TelegramForm.NONE
    addresses: Annotated[dict[Text, Text], Field(description="PLC variable: address, for instance `CLR_q1: I4.0`")] = {}


def json_schema() -> dict[str, Any]:
    """The JSON Schema (draft-07 subset) of the layout language, for completion in editors."""
    schema = LayoutFile.model_json_schema(by_alias=True)
    schema["$schema"] = "http://json-schema.org/draft-07/schema#"
    schema["title"] = "interlock layout"
    text = _rename_defs(schema)
    assert isinstance(text, dict)
    return text


def _rename_defs(value: Any) -> Any:
    """draft-07 keeps shared parts under `definitions`; pydantic writes `$defs`."""
    if isinstance(value, dict):
        return {("definitions" if k == "$defs" else k): _rename_defs(v) for k, v in value.items()}
    if isinstance(value, list):
        return [_rename_defs(v) for v in value]
    if isinstance(value, str):
        return value.replace("#/$defs/", "#/definitions/")
    return value


def plain(node: Node) -> Any:
    """The tree as plain Python data; every scalar is text."""
    if isinstance(node, Scalar):
        return node.text
    if isinstance(node, Sequence):
        return [plain(n) for n in node.items]
    return {k: plain(v) for k, (_, v) in node.items.items()}


_KEYS: dict[str, tuple[str, ...]] = {
    "": tuple(f.alias or n for n, f in LayoutFile.model_fields.items()),
    "boundaries": tuple(BoundarySpec.model_fields),
    "points": tuple(PointSpec.model_fields),
    "crossings": (*CrossingSpec.model_fields, *ArmSpec.model_fields),
    "slips": tuple(SlipSpec.model_fields),
    "derailers": tuple(DerailerSpec.model_fields),
    "level_crossings": tuple(DeviceSpec.model_fields),
    "interlocks": tuple(DeviceSpec.model_fields),
    "signals": ("from", "into", "at", "kind", "call_on"),
    "distants": tuple(DistantSpec.model_fields),
    "principles": KNOBS,
    "overlaps": tuple(OverlapSpec.model_fields),
    "exclude": ("from", "to", "via", "kind", "reason"),
    "sections": tuple(SectionSpec.model_fields),
    "conditions": tuple(ConditionSpec.model_fields),
    "zones": tuple(ZoneSpec.model_fields),
    "routes": ("from", "to", "via"),
    "voyages": ("from", "to", "via", "kind", "order", "direction"),
    "automatic": ("from", "to", "via"),
    "waive": tuple(WaiverSpec.model_fields),
    "allow": tuple(AllowSpec.model_fields),
}


def validate(root: Node, sink: Sink) -> LayoutFile | None:
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
        return LayoutFile.model_validate(plain(root), by_alias=True)
    except ValidationError as error:
        report_shapes(root, error.errors(include_url=False, include_input=False), _KEYS, sink)
        return None
