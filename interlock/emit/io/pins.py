"""The file of pins, for people: substation by substation, element by element, in the order of their names."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator

from interlock.model.layout import Layout
from interlock.model.pins import Pin, Pins

_HEAD = """\
# The channels of {name}: they stay where they are.  Written by `interlock pin`, read whenever the layout is.
pins: 1
layout: {name}
"""


def pins_text(layout: Layout, pins: Pins) -> str:
    """The file that says these pins."""
    out = [_HEAD.format(name=layout.name)]
    if pins.cards:
        out.append("cards:  # substation, slot, and the first byte of its sixteen channels\n")
        for station in sorted({c.substation for c in pins.cards}):
            cards = sorted((c for c in pins.cards if c.substation == station), key=lambda c: c.slot)
            out.append(f"  {station}: {{{', '.join(f'{c.slot}: {c.direction}{c.byte}' for c in cards)}}}\n")
    out += _room("channels", "", pins.channels)
    out += _room("reserved", "  # of what is gone; `interlock pin --release NAME` gives them back", pins.reserved)
    return "".join(out)


def _room(name: str, note: str, pins: Iterable[Pin]) -> Iterator[str]:
    found: dict[str, dict[str, list[Pin]]] = {}
    for p in sorted(pins, key=lambda p: (p.substation, p.element, p.variable)):
        found.setdefault(p.substation, {}).setdefault(p.element, []).append(p)
    if found:
        yield f"{name}:{note}\n"
    for station, elements in found.items():
        yield f"  {station}:\n"
        for element, those in elements.items():
            yield f"    {line_of(element, those)}\n"


def line_of(element: str, pins: Iterable[Pin]) -> str:
    """The line of an element."""
    return f"{_key(element)}: {{{', '.join(f'{p.variable}: {p.address}' for p in pins)}}}"


def _key(element: str) -> str:
    """A name as it is, anything else in quotes."""
    return element if element.replace("_", "").replace("-", "").replace("/", "").isalnum() else json.dumps(element)
