"""Addresses that stay: what a layout's channels are, and what has changed since they were pinned.

What is kept keeps its channel, what is new is appended, and the channel of what is gone stays reserved until somebody
releases it.  Only the layout's own word moves a channel (another substation, another address), if that is allowed.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import replace
from pathlib import Path

from interlock.app.own import unchanged, write_own
from interlock.app.pinned import check_pins
from interlock.dataclass import dataclass
from interlock.derivation import derive
from interlock.diag import Diagnostic, Sink
from interlock.diag.suggest import did_you_mean
from interlock.emit.io.pins import pins_text
from interlock.frontend import Source, load
from interlock.frontend.pins import beside
from interlock.logic.cabinet import BadAddress, allocate, clashes, wires
from interlock.logic.controller import Controller
from interlock.logic.expr import interning
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.model.pins import Pin, Pins
from interlock.table.rows import InterlockingTable


class NotReserved(Exception):
    """Nothing of that name is reserved; the message says what is."""


@dataclass(frozen=True)
class Change:
    """What becomes of a channel: `new`, `moved`, `reserved` (its variable is gone), `back` (that has come back), or
    `released`."""

    kind: str
    pin: Pin
    before: Pin | None = None

    @property
    def text(self) -> str:
        """In words."""
        p = self.pin
        if self.kind == "moved" and self.before is not None:
            of = f"{self.before.substation} " if self.before.substation != p.substation else ""
            return f"{p.variable}: {of}{self.before.address} -> {p.substation} {p.address}"
        return f"{p.variable}: {p.substation} {p.address}"


@dataclass(frozen=True)
class Repinned:
    """The pins of a layout as they are to be, and what is different then; `pins` is None when there are errors."""

    source: Source
    file: Path
    diagnostics: tuple[Diagnostic, ...] = ()
    pins: Pins | None = None
    changes: tuple[Change, ...] = ()
    text: str = ""
    first: bool = False
    """Nothing was pinned before."""
    released: frozenset[str] = frozenset()
    """The variables whose channels were asked to be given back."""

    @property
    def moves(self) -> bool:
        """A channel of something that is kept would move, or one that is reserved be given away unasked."""
        return any(
            c.kind == "moved" or (c.kind == "released" and c.pin.variable not in self.released) for c in self.changes
        )

    def write(self, force: bool) -> int:
        """Write the file; its size.  Raises `NotOurs`, where it is no longer as it was read, too, and OSError."""
        unchanged(self.file, self.source.pins_data)
        return write_own(self.file, self.text.encode(), Path(self.source.file), force)


def pin_file(path: str, release: Sequence[str] = ()) -> Repinned:
    """The pins that a layout file would have.  `release`: elements or variables whose reserved channels are given back.

    Raises `NotReserved`.
    """
    sink, file = Sink(), Path(beside(path))
    layout, source = load(path, sink)
    table = None if layout is None else derive(layout, sink)
    if layout is None or table is None or sink.has_errors:
        return Repinned(source, file, sink.diagnostics)
    with interning():
        controller = lower(layout, table)
        try:
            released = _named(layout, table, controller, release)
            pins = repinned(layout, controller, released)
        except BadAddress as error:
            fix = "see io/channels.csv of a compiled layout for the variables with a wire"
            sink.add("IL2015", str(error), source.at("addresses", error.variable), fix)
            return Repinned(source, file, sink.diagnostics)
        check_pins(layout, wires(layout, controller), source, sink, gone=False)
    found = tuple(changes(layout.hardware.pins, pins))
    text = pins_text(layout, pins)
    return Repinned(source, file, sink.diagnostics, pins, found, text, not layout.hardware.pins, released)


def repinned(layout: Layout, controller: Controller, released: Set[str] = frozenset()) -> Pins:
    """The pins of a layout, made from those that it has but for what is released.  Raises `BadAddress`."""
    kept = _without(layout.hardware.pins, released)
    # where layout and pin contradict each other, the layout is right, once that is allowed
    wrong = {c.pin.variable for c in clashes(replace(layout, hardware=replace(layout.hardware, pins=kept)), controller)}
    return allocate(replace(layout, hardware=replace(layout.hardware, pins=_without(kept, wrong))), controller).pins


def _named(layout: Layout, table: InterlockingTable, controller: Controller, names: Sequence[str]) -> frozenset[str]:
    """The reserved variables of these names, or of elements of these names."""
    here = wires(layout, controller)
    gone = layout.hardware.pins.by_variable.keys() - {w.variable for w in here}
    reserved = [p for n, p in layout.hardware.pins.by_variable.items() if n in gone]
    kept = {x for w in here for x in (w.variable, w.element)}
    routes = {x for r in table.routes for x in (r.id, *r.names)}
    found: set[str] = set()
    for name in names:
        those = {p.variable for p in reserved if name in (p.variable, p.element)}
        if not those:
            known = sorted({x for p in reserved for x in (p.variable, p.element)})
            elements = ", ".join(sorted({p.element for p in reserved})) or "none"
            if name in kept:
                hint = f"the layout has it, and it keeps its channels; reserved are those of what is gone: {elements}"
            elif name in routes:
                hint = f"that is a route, and no wire leads to routes; reserved are those of elements: {elements}"
            else:
                hint = str(did_you_mean(name, known, f"reserved are those of {elements}")) if known else "nothing is"
            raise NotReserved(f"no channel is reserved for {name}: {hint}")
        found |= those
    return frozenset(found)


def _without(pins: Pins, variables: Set[str]) -> Pins:
    return replace(
        pins,
        channels=tuple(p for p in pins.channels if p.variable not in variables),
        reserved=tuple(p for p in pins.reserved if p.variable not in variables),
    )


def changes(old: Pins, new: Pins) -> list[Change]:
    """What becomes of each channel that does not stay as it is, what moves first."""
    was, kept = {p.variable: p for p in old.channels}, {p.variable: p for p in old.reserved}
    found = []
    for p in new.channels:
        before = was.get(p.variable) or kept.get(p.variable)
        if before is None:
            found.append(Change("new", p))
        elif (before.substation, before.place) != (p.substation, p.place):
            found.append(Change("moved", p, before))
        elif p.variable in kept:
            found.append(Change("back", p))
    found += [Change("reserved", p) for p in new.reserved if p.variable in was]
    found += [Change("released", p) for n, p in old.by_variable.items() if n not in new.by_variable]
    order = ("moved", "new", "back", "reserved", "released")
    return sorted(found, key=lambda c: (order.index(c.kind), c.pin.substation, c.pin.place))
