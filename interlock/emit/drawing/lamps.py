"""The lamps and other units of a signal's symbol, from its mast outwards."""

from __future__ import annotations

from interlock.derivation.lamps import beside_main
from interlock.emit.drawing.canvas import SIGNAL
from interlock.model.elements import Signal
from interlock.model.layout import Layout

FIRST, NEXT = 16, 9
"""Pixels from the joint to the middle of the first unit, and from one to the next."""


def lamps(layout: Layout, g: Signal) -> list[str]:
    """The units of a signal by kind: main, the second of two yellows, shunt, identifier light, route indicator, speed
    indicator."""
    beside = beside_main(layout).get(g.id, ())
    units = {
        "main": g.main and layout.signalling.opens(g.id, False),
        "second": "second" in beside,
        "shunt": g.shunt and layout.signalling.opens(g.id, True),
        "identifier": g.id in layout.signalling.identifiers,
        "indicator": "indicator" in beside,
        "speed": "speed" in beside,
    }
    return [kind for kind, there in units.items() if there]


def symbol_width(layout: Layout, g: Signal) -> float:
    """Pixels of a signal's symbol along its track."""
    return SIGNAL + NEXT * max(0, len(lamps(layout, g)) - 2)


def long_symbol(layout: Layout, g: Signal) -> bool:
    """Whether a signal has more units than the main and shunt lamps of a combined one."""
    return len(lamps(layout, g)) > 2


def unit(kind: str, x: float, y: float) -> str:
    """The stroke of a unit: a slash makes a lamp a yellow one; a route indicator is a box with three dots, a speed
    indicator a triangle on its base."""

    def n(v: float) -> str:
        return f"{v:.1f}".rstrip("0").rstrip(".")

    circle = f'<circle class="lamp {kind}" cx="{n(x)}" cy="{n(y)}" r="4.2"/>'
    if kind == "second":
        return f'{circle}<path class="foul" d="M{n(x - 3)} {n(y + 3)} L{n(x + 3)} {n(y - 3)}"/>'
    if kind == "indicator":
        dots = " ".join(f"M{n(x + k)} {n(y - 0.6)} v1.2" for k in (-2.2, 0, 2.2))
        box = f"M{n(x - 4.2)} {n(y - 4.2)} h8.4 v8.4 h-8.4 Z"
        return f'<path class="lamp {kind}" d="{box}"/><path class="foul" d="{dots}"/>'
    if kind == "speed":
        return f'<path class="lamp {kind}" d="M{n(x)} {n(y - 5)} L{n(x + 4.6)} {n(y + 4.2)} h-9.2 Z"/>'
    return circle
