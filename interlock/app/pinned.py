"""What a file of pins says that no cabinet and no layout bears out: IL2028, IL2029.

Both are warnings: where an element was taken away, or an address was stated once, the file says so rightly until the
next `interlock pin`.  Where a name or a number was mistyped it says so wrongly, and nothing else tells.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from interlock.diag import Sink, Span
from interlock.diag.suggest import nearest
from interlock.emit.io.pins import line_of
from interlock.frontend import Source
from interlock.frontend.pins import PinsRead
from interlock.frontend.shapes import span_of
from interlock.logic.cabinet import Wire
from interlock.model.layout import Layout
from interlock.model.pins import Card, Pin


def check_pins(layout: Layout, hanging: Sequence[Wire], source: Source, sink: Sink, *, gone: bool = True) -> None:
    """Report pins on no card, and pins and cards of what is not there.  `gone`: also those that look like nothing that
    the layout has, which `interlock pin` is about to reserve."""
    read = source.pins
    if read is None:
        return
    _on_no_card(layout, read, sink)
    known = {w.variable: w for w in hanging}
    new = tuple(n for n in known if n not in read.pins.by_variable)
    for p in read.pins.channels:
        if (wire := known.get(p.variable)) is None:
            _unknown(p, nearest(p.variable, new), source, read, sink, gone)
        elif wire.element != p.element:
            said = f"{p.variable} stands under {p.element} here, but it is a variable of {wire.element}"
            sink.add("IL2029", said, _at(read, p, 1), _moved(p, wire, known, read))
    _no_substation(read, sorted({w.substation for w in hanging}), sink)


def _moved(p: Pin, wire: Wire, known: Mapping[str, Wire], read: PinsRead) -> str:
    """The lines that the file should have where a variable stands under another element."""
    here = [x for x in read.pins.channels if x.substation == p.substation]
    hanging = {x.variable: known[x.variable].element for x in here if x.variable in known}
    own = [x for x in here if hanging.get(x.variable, x.element) == wire.element]
    left = [x for x in here if x.element == p.element and hanging.get(x.variable, x.element) == p.element]
    stays = f", and `{line_of(p.element, left)}`" if left else f", in place of the line of {p.element}"
    return f"write it under {wire.element}: `{line_of(wire.element, own)}`{stays}"


def _renamed(p: Pin, name: str, read: PinsRead) -> str:
    """The line of an element with another name for one of its variables."""
    own = (x for x in read.pins.channels if (x.substation, x.element) == (p.substation, p.element))
    return line_of(p.element, (replace(x, variable=name) if x == p else x for x in own))


def _on_no_card(layout: Layout, read: PinsRead, sink: Sink) -> None:
    stated = dict(layout.hardware.addresses)
    taken = {(c.direction, b) for c in read.pins.cards for b in c.bytes}
    for p in read.pins.channels:
        if (p.direction, p.byte) in taken or stated.get(p.variable) == p.address:
            continue
        own = [c for c in read.pins.cards if (c.substation, c.direction) == (p.substation, p.direction)]
        said = f"{p.variable} is pinned to {p.address}, and no card has byte {p.direction}{p.byte}"
        slot = max((c.slot for c in read.pins.cards if c.substation == p.substation), default=0) + 1
        card = f"{p.substation}: {{{slot}: {p.direction}{p.byte - p.byte % 2}}}"
        has = f" ({p.substation} has {_listed(own)})" if own else ""
        fix = f"correct the address{has}, or add the card that has it under `cards`, for instance `{card}`"
        sink.add("IL2028", said, read.at(p.variable), fix, cause=f"no card of {p.substation}", note=_told(p))


def _listed(cards: Sequence[Card]) -> str:
    """Which bytes cards have, in their order; of many the first and the last."""
    told = [f"{c.direction}{b}" for c in sorted(cards, key=lambda c: c.byte) for b in c.bytes]
    return ", ".join(told if len(told) <= 8 else [*told[:6], "...", told[-1]])


def _unknown(p: Pin, near: str | None, source: Source, read: PinsRead, sink: Sink, gone: bool) -> None:
    """A variable that the layout does not have, and perhaps the one that is meant."""
    said = f"{p.variable} is pinned to {p.address}, but the layout has no such variable"
    keeps = f"`interlock pin {source.file}` keeps {p.address} reserved"
    if near is not None:
        fix = (
            f"write {near} here if that is what is wired to {p.address}, `{_renamed(p, near, read)}`; otherwise {keeps}"
        )
        sink.add("IL2029", f"{said}; it has {near}, which is not pinned", _at(read, p, 2), fix)
    elif gone:
        fix = f"correct the name; if its element is gone, `interlock pin {source.file}` keeps the channel reserved"
        sink.add("IL2029", said, _at(read, p, 2), fix, cause="gone", note=_told(p))


def _told(p: Pin) -> str:
    return f"{p.variable} {p.address}"


def _no_substation(read: PinsRead, stations: Sequence[str], sink: Sink) -> None:
    """Cards of a substation that is not there, and on which nothing is kept: nobody would take any notice of them."""
    used = {(p.direction, p.byte) for p in read.pins.by_variable.values()}
    for c in read.pins.cards:
        if c.substation not in stations and not any((c.direction, b) in used for b in c.bytes):
            near = nearest(c.substation, tuple(stations))
            fix = (
                f"did you mean {near}? write `{_cards(read, near, c.substation)}`"
                if near
                else f"remove it; the layout has {', '.join(stations)}"
            )
            said = f"the card in slot {c.slot} of {c.substation}: the layout has no substation {c.substation}"
            sink.add("IL2029", said, span_of(read.root, ("cards", c.substation), key=True), fix)


def _cards(read: PinsRead, station: str, misspelt: str) -> str:
    """The line of the cards of a substation, with those that stand under a name that is none; these in slots that are
    free there."""
    own = {c.slot: c for c in read.pins.cards if c.substation == station}
    for c in (c for c in read.pins.cards if c.substation == misspelt):
        own[max(own) + 1 if c.slot in own else c.slot] = c
    return f"{station}: {{{', '.join(f'{slot}: {c.direction}{c.byte}' for slot, c in sorted(own.items()))}}}"


def _at(read: PinsRead, p: Pin, depth: int) -> Span:
    """Where the name of its element (1) or its own (2) stands."""
    path = ("channels", p.substation, p.element, p.variable)
    return span_of(read.root, path[: depth + 2], key=True)
