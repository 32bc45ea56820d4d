"""The file beside a layout that says which addresses stay: `NAME.pins`, written by `interlock pin`.

Input: a YAML text.  Output: `PinsRead`, or diagnostics IL1004-IL1019 (shape), IL2020 and IL2021.  Whether layout and
pins agree is seen when addresses are given (`logic/cabinet.py`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, WithJsonSchema
from pydantic_core import PydanticCustomError

from interlock.dataclass import dataclass
from interlock.diag import Sink, Span
from interlock.frontend.scalars import ADDRESS, Name, Text
from interlock.frontend.shapes import report_shape, span_of
from interlock.frontend.validate import plain
from interlock.frontend.yaml_tree import Mapping, Node, parse
from interlock.model.pins import Card, Pin, Pins, Place

SUFFIX = ".pins"
_CARD = re.compile(r"([IQ])([0-9]{1,4})")


def _written(pattern: re.Pattern[str], what: str, how: str) -> BeforeValidator:
    """A text of a pattern."""

    def check(value: object) -> object:
        if not isinstance(value, str):
            raise PydanticCustomError("shape", "a text is expected")
        if not pattern.fullmatch(value):
            raise PydanticCustomError("address", "'{v}' is no {w}", {"v": value, "w": what, "fix": how})
        return value

    return BeforeValidator(check)


def _version(value: object) -> object:
    if value != "1":
        context = {"v": str(value), "fix": "this release reads `pins: 1`"}
        raise PydanticCustomError("version", "version {v} is not supported", context)
    return 1


def _as(pattern: str) -> WithJsonSchema:
    return WithJsonSchema({"type": ["string", "integer"], "pattern": f"^{pattern}$"})


Address = Annotated[
    str,
    _written(ADDRESS, "address", "write I or Q, the byte (to 9999), a point and the bit (0 to 7): I4.0, Q12.7"),
    _as(r"[IQ]\d{1,4}\.[0-7]"),
]
FirstByte = Annotated[
    str, _written(_CARD, "card", "write I or Q and the first byte (to 9999): I0, Q12"), _as(r"[IQ]\d{1,4}")
]
Slot = Annotated[
    str, _written(re.compile(r"[1-9]\d{0,2}"), "slot", "slots are numbers from 1 on"), _as(r"[1-9]\d{0,2}")
]
Channels = dict[Name, dict[Text, dict[Text, Address]]]


class PinFile(BaseModel):
    """Addresses of a layout that stay."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    pins: Annotated[int, BeforeValidator(_version), WithJsonSchema({"const": 1}), Field(description="version")]
    layout: Annotated[Name, Field(description="the layout's name")]
    cards: Annotated[
        dict[Name, dict[Slot, FirstByte]],
        Field(description="each substation's cards of 16 channels: slot, I or Q, and the first byte"),
    ] = {}
    channels: Annotated[
        Channels, Field(description="substation, element, and the address of each of its PLC variables")
    ] = {}
    reserved: Annotated[Channels, Field(description="the same of what is gone; nothing else is put there")] = {}


_KEYS = {"": tuple(PinFile.model_fields)}


@dataclass(frozen=True)
class PinsRead:
    """A file of pins as read, with places for later diagnostics."""

    file: str
    text: str
    root: Node
    pins: Pins

    def at(self, variable: str) -> Span:
        """Where the address of a variable stands."""
        p = self.pins.by_variable[variable]
        for kind, those in (("channels", self.pins.channels), ("reserved", self.pins.reserved)):
            if p in those:
                return span_of(self.root, (kind, p.substation, p.element, p.variable))
        return self.root.span

    def on_card(self, station: str, slot: int) -> Span:
        """Where a card stands."""
        return span_of(self.root, ("cards", station, slot))


def beside(layout: str) -> str:
    """The name of the file of pins beside a layout file."""
    return str(Path(layout).with_suffix(SUFFIX))


def read_pins(file: str, text: str, layout: str, sink: Sink) -> PinsRead | None:
    """The pins for the layout of that name, whose own text has no errors; None with every problem reported."""
    root = parse(file, text, sink)
    if root is None or sink.has_errors:
        return None
    if not isinstance(root, Mapping) or "pins" not in root.items:
        fix = "`interlock pin LAYOUT` writes it; it begins with `pins: 1`"
        sink.add("IL2020", "this is no file of pins: the key `pins` is missing", root.span, fix)
        return None
    try:
        data = PinFile.model_validate(plain(root))
    except ValidationError as error:
        report_shape(root, error, _KEYS, sink)
        return None
    if data.layout != layout:
        said = f"these pins are of the layout {data.layout}, not of {layout}"
        fix = "give the file of this layout; if the layout was renamed, change the key `layout` here"
        sink.add("IL2020", said, span_of(root, ("layout",)), fix)
        return None
    cards = tuple(_cards(data))
    channels, reserved = tuple(_pins(data.channels)), tuple(_pins(data.reserved))
    _check(root, cards, (("channels", channels), ("reserved", reserved)), sink)
    return None if sink.has_errors else PinsRead(file, text, root, Pins(cards, channels, reserved))


def _cards(data: PinFile) -> Iterator[Card]:
    for station, slots in data.cards.items():
        for slot, first in slots.items():
            yield Card(station, int(slot), first[0], int(first[1:]))


def _pins(data: Channels) -> Iterator[Pin]:
    for station, elements in data.items():
        for element, variables in elements.items():
            for variable, address in variables.items():
                byte, _, bit = address[1:].partition(".")
                yield Pin(variable, station, element, address[0], int(byte), int(bit))


def _check(root: Node, cards: tuple[Card, ...], kinds: tuple[tuple[str, tuple[Pin, ...]], ...], sink: Sink) -> None:
    """Nothing is there twice, and no channel lies on a card of another substation."""
    holder: dict[tuple[str, int], Card] = {}
    for c in cards:
        taken = {holder[c.direction, b] for b in c.bytes if (c.direction, b) in holder}
        for other in taken:
            said = f"this card of {c.substation} would lie over the one in slot {other.slot} of {other.substation}"
            fix = f"a card takes two bytes: {other.direction}{other.byte} takes byte {other.byte + 1} as well"
            sink.add("IL2021", said, span_of(root, ("cards", c.substation, str(c.slot))), fix)
        holder |= {(c.direction, b): c for b in c.bytes}
    names: dict[str, Span] = {}
    places: dict[Place, tuple[str, Span]] = {}
    for kind, pins in kinds:
        for p in pins:
            at = span_of(root, (kind, p.substation, p.element, p.variable))
            key = span_of(root, (kind, p.substation, p.element, p.variable), key=True)
            if p.variable in names:
                said = f"{p.variable} is pinned twice (first in line {names[p.variable].line})"
                sink.add("IL2021", said, key, "keep the one at which it is wired")
            names.setdefault(p.variable, key)
            if p.place in places:
                first, line = places[p.place][0], places[p.place][1].line
                said = f"{p.address} is given to {p.variable} and to {first} (line {line})"
                sink.add("IL2021", said, at, "give each its own; see where each of them is wired")
            places.setdefault(p.place, (p.variable, at))
            card = holder.get((p.direction, p.byte))
            if card is not None and card.substation != p.substation:
                said = f"{p.variable} hangs on substation {p.substation}, but {p.address} is on a card of"
                fix = f"give it a channel of {p.substation}, or correct the card"
                sink.add("IL2021", f"{said} {card.substation}", at, fix)
