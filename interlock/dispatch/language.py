"""The language of dispatch: a file of its own beside the layout, which the layout's digest and proof never see.

Input: a YAML text.  Output: a `DispatchFile`, or diagnostics IL1004-IL1019 (shape) and IL6001-IL6002.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Any, Literal
from unicodedata import normalize

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError
from pydantic_core import PydanticCustomError

from interlock.dataclass import dataclass
from interlock.diag import Sink, Span
from interlock.diag.suggest import did_you_mean
from interlock.frontend.load import read
from interlock.frontend.scalars import Amount, Name, Text, choice, number, number_fix, slip_of, version
from interlock.frontend.validate import plain, report_shape, span_of
from interlock.frontend.yaml_tree import Mapping, Node, parse
from interlock.model.layout import Layout

SUFFIX = ".dispatch"
MOST_TRAINS = 200
"""Locomotives of a fleet, trains of an order, trains at a place (our choice)."""


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


_UNITS: dict[str, dict[str, float]] = {
    "minutes": {"min": 1, "minutes": 1, "h": 60, "s": 1 / 60},
    "hours": {"h": 1, "hours": 1, "min": 1 / 60},
    "tonnes": {"t": 1, "tonnes": 1, "kt": 1000, "kg": 0.001},
    "km/h": {"km/h": 1, "kmh": 1, "m/s": 3.6},
    "metres": {"m": 1, "km": 1000, "ft": 0.3048},
    "seconds": {"s": 1, "min": 60},
    "m/s^2": {"m/s2": 1, "m/s^2": 1},
}
_UNITS["minutes"] |= {"分": 1, "分钟": 1, "小时": 60, "秒": 1 / 60}
_UNITS["hours"] |= {"小时": 1, "时": 1, "分": 1 / 60, "分钟": 1 / 60}
_UNITS["tonnes"] |= {"吨": 1, "公斤": 0.001}
_UNITS["km/h"] |= {"km": 1, "公里": 1, "公里/小时": 1, "公里/时": 1, "千米/小时": 1, "米/秒": 3.6}
_UNITS["metres"] |= {"米": 1, "公里": 1000, "千米": 1000}
_UNITS["seconds"] |= {"秒": 1, "分": 60, "分钟": 60}
"""By the word of a quantity: units that are written with it, and how many of its own each is."""


def _as_number(text: str, what: str) -> float:
    """A number in ASCII; the fix of one that is none names the unit of this quantity."""
    try:
        return number(text)
    except PydanticCustomError as error:
        plain = normalize("NFKC", text)
        if number_fix(text).endswith("ASCII digits") or slip_of(text) == "a decimal comma":
            raise
        known = _UNITS.get(what.split()[0], {})
        found = re.fullmatch(r"([+-]?[0-9]+(?:\.[0-9]+)?)\s*(\S+)", plain)
        fix = f"write {what} as a plain decimal number, for instance 1.5"
        if found is not None and found[2].lower() in known:
            fix = f"write {float(found[1]) * known[found[2].lower()]:.10g}: {what}, without the unit"
        raise PydanticCustomError("number", "'{v}' is not a number", {"v": text, "fix": fix}) from error


def _between(low: float, high: float, what: str) -> BeforeValidator:
    """A number above `low` and at most `high`; `what`: the word of its unit, and more."""

    def check(value: object) -> float:
        if not isinstance(value, str):
            raise PydanticCustomError("number", "a number is expected")
        x = _as_number(value, what)
        if not low < x <= high:
            fix = f"{what}: above {low:g} and at most {high:g}"
            raise PydanticCustomError("range", "{v} is out of range", {"v": value, "fix": fix})
        return x

    return BeforeValidator(check)


Hours = Annotated[float, _between(0, 24, "hours")]
Minutes = Annotated[float, _between(0, 1440, "minutes")]
Tonnes = Annotated[float, _between(0, 1e9, "tonnes")]
Days = Annotated[float, _between(0, 366, "days a year")]
Shifts = Annotated[float, _between(0, 24, "shifts a day")]
Kmh = Annotated[float, _between(0, 400, "km/h")]


class LineSpec(_Part):
    """A main or branch line: tonnes a year, men and waste trains a shift, minutes a train at its bottleneck."""

    tonnes: Tonnes
    men: Amount = 0.0
    waste: Amount = 0.0
    minutes: Annotated[Minutes, Field(description="a train at the tippler (main) or at the loading place (branch)")]
    rounding: Annotated[Literal["up", "none"], choice("rounding", ("up", "none"))] = "up"
    sections: list[Name] = []


class TrafficSpec(_Part):
    """What the formulas 3-1 to 3-9 of document B need."""

    shift_h: Hours = 8.0
    shifts: Shifts
    days: Days
    train_t: Annotated[Tonnes, Field(description="tonnes a train, less what sticks to the floors of the wagons")]
    change_h: Annotated[Amount, Field(description="hours lost at a change of shift, 0.5 in the document")] = 0.5
    speed_kmh: Annotated[Kmh, Field(description="mean speed, usually 8")] = 8.0
    main: LineSpec | None = None
    branches: dict[Name, LineSpec] = {}


def _count(value: object) -> int:
    if not isinstance(value, str) or not re.fullmatch(r"[0-9]{1,4}", value) or not 1 <= int(value) <= MOST_TRAINS:
        digits = "" if str(value).isascii() else ", in ASCII digits"
        fix = f"write a whole number, 1 to {MOST_TRAINS}{digits}"
        raise PydanticCustomError("range", "{v} is out of range", {"v": str(value), "fix": fix})
    return int(value)


Count = Annotated[int, BeforeValidator(_count)]
Metres = Annotated[float, _between(0, 2000, "metres of a train")]
Rate = Annotated[float, _between(0.01, 5, "m/s^2")]
Seconds = Annotated[float, _between(0, 60, "seconds")]

LEADS = ("hauled", "propelled")
KINDS = ("loading", "tipping", "waiting", "crossing")


class TrainSpec(_Part):
    """A train, by its locomotive number: what it measures and how it runs."""

    length: Metres
    wagons: Count = 1
    tonnes: Annotated[Tonnes, Field(description="tonnes that it carries")] = 60.0
    speed: Kmh = 10.0
    acceleration: Rate = 0.2
    braking: Rate = 0.4
    reaction: Seconds = 2.0
    leads: Annotated[Literal["hauled", "propelled"], choice("kind of traction", LEADS)] = "hauled"
    at: Annotated[Name, Field(description="the waiting place where it begins")]


class PlaceSpec(_Part):
    """Where trains are loaded, tipped, wait or cross: a section, or a boundary beyond which it lies."""

    kind: Annotated[Literal["loading", "tipping", "waiting", "crossing"], choice("kind of place", KINDS)]
    at: Annotated[Name, Field(description="section or boundary")]
    minutes: Annotated[Minutes | None, Field(description="a train there, coupling included")] = None
    capacity: Annotated[Count, Field(description="trains that may stand there")] = 1
    ores: list[Name] = []
    back: Annotated[Minutes, Field(description="from there to the waiting place, outside the layout")] = 10.0


class OrderSpec(_Part):
    """What is to be brought: from a loading place to a tipping place, as trains or tonnes, within hours."""

    from_: Annotated[Name, Field(alias="from")]
    to: Name
    trains: Count | None = None
    tonnes: Tonnes | None = None
    ore: Name | None = None
    share: Annotated[float | None, _between(0, 1, "share of an ore in the blend")] = None
    by: Annotated[Hours | None, Field(description="hours after the beginning of the shift")] = None
    via: list[Name] = []
    only: Annotated[list[Name], Field(description="locomotives that may carry it out; empty: all")] = []


def _version(value: object) -> object:
    try:
        return version(value)
    except PydanticCustomError as error:
        fix = "this release reads `dispatch: 1`"
        raise PydanticCustomError("version", "version {v} is not supported", {"v": str(value), "fix": fix}) from error


class DispatchFile(_Part):
    """What is moved on a layout, by which trains."""

    dispatch: Annotated[int, BeforeValidator(_version)]
    layout: Name
    title: Text = ""
    shift_h: Hours = 8.0
    traffic: TrafficSpec | None = None
    fleet: dict[Name, TrainSpec] = {}
    places: dict[Name, PlaceSpec] = {}
    orders: dict[Name, OrderSpec] = {}
    blocked: Annotated[list[Name], Field(description="places and sections closed to trains in this shift")] = []

    @property
    def closed(self) -> set[str]:
        """The sections that are blocked, by name or as places; and the boundaries beyond which blocked places lie."""
        return {self.places[b].at if b in self.places else b for b in self.blocked}


_KEYS: dict[str, tuple[str, ...]] = {
    "": tuple(DispatchFile.model_fields),
    "traffic": (*TrafficSpec.model_fields, *LineSpec.model_fields),
    "fleet": tuple(TrainSpec.model_fields),
    "places": tuple(PlaceSpec.model_fields),
    "orders": tuple(f.alias or n for n, f in OrderSpec.model_fields.items()),
}


@dataclass(frozen=True)
class Orders:
    """A dispatch file as read, with places for later diagnostics."""

    file: DispatchFile
    root: Node
    name: str
    text: str

    def at(self, *path: str | int, key: bool = False) -> Span:
        """The place of a value (or key)."""
        return span_of(self.root, path, key=key)


def beside(layout: str) -> str:
    """The name of the dispatch file beside a layout file."""
    return str(Path(layout).with_suffix(SUFFIX))


def load(path: str, layout: Layout, sink: Sink, texts: dict[str, str], option: str = "--dispatch") -> Orders | None:
    """Read a dispatch file for a layout; None with every problem reported.  Its text is added to `texts`.  `option`
    names another file on the command line."""
    if not Path(path).exists():
        named = f"write it beside the layout, or name another one with `{option} FILE`"
        fix = f"{named}; `interlock explain dispatch` has its keys"
        sink.add("IL1001", f"there is no dispatch file {path}", None, fix)
        return None
    text, _, _ = read(path, sink)
    if text is not None:
        texts[path] = text
    return None if text is None else load_text(path, text, layout, sink)


def load_text(name: str, text: str, layout: Layout, sink: Sink) -> Orders | None:
    """The same from its text."""
    root = parse(name, text, sink)
    if root is None or sink.has_errors:
        return None
    if not isinstance(root, Mapping) or "dispatch" not in root.items:
        sink.add(
            "IL6001", "this is no dispatch file: the key `dispatch` is missing", root.span, "begin with `dispatch: 1`"
        )
        return None
    data = _typed(root, sink)
    if data is None:
        return None
    orders = Orders(data, root, name, text)
    if data.layout != layout.name:
        fix = "give the dispatch file of this layout, or change its key `layout`"
        what = f"this file is for the layout {data.layout}, not for {layout.name}"
        sink.add("IL6001", what, orders.at("layout"), fix)
        return None
    _check_sections(orders, layout, sink)
    return None if sink.has_errors else orders


def _typed(root: Node, sink: Sink) -> DispatchFile | None:
    content: Any = plain(root)
    try:
        return DispatchFile.model_validate(content, by_alias=True)
    except ValidationError as error:
        report_shape(root, error, _KEYS, sink)
        return None


def _check_sections(orders: Orders, layout: Layout, sink: Sink) -> None:
    traffic = orders.file.traffic
    if traffic is None:
        return
    known = [s.id for s in layout.track.sections]
    lines = [(("traffic", "branches", n), x) for n, x in traffic.branches.items()]
    if traffic.main is not None:
        lines.append((("traffic", "main"), traffic.main))  # type: ignore[arg-type]
    for path, line in lines:
        for i, s in enumerate(line.sections):
            if s not in known:
                here = orders.at(*path, "sections", i)
                sink.add("IL6002", f"there is no section {s}", here, did_you_mean(s, known))
