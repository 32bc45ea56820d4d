"""Which variable goes over which wire: substation, slot, bit, address (document B 2.2; DI 1 = clear).

Every detection, detector contact, lamp proof and external condition is a digital input, every machine command and lamp
a digital output; each substation has a heartbeat input besides.  Everything else is written and read by the operator's
place.  Cards have 16 channels; every substation keeps at least a tenth of its channels spare.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from interlock.logic import names
from interlock.logic.controller import Controller
from interlock.model.elements import Position, Substation
from interlock.model.layout import Layout
from interlock.model.portable import portable

CARD = 16
SPARE = 0.1

_LAMPS = (names.STOP_ASPECT, names.CAUTION_ASPECT, names.CLEAR_ASPECT, names.SHUNT_ASPECT, names.CALL_ASPECT)


class BadAddress(Exception):
    """An address of the layout that cannot be given; the message says why."""

    def __init__(self, variable: str, text: str) -> None:
        super().__init__(text)
        self.variable = variable


@dataclass(frozen=True)
class Channel:
    """One wire: I or Q, the substation, the element at its other end, and what it means when it is 1.

    slot 0: the address was stated in the layout.  byte and bit count from 0 for inputs and outputs apart.
    """

    variable: str
    direction: str
    substation: str
    element: str
    note: str
    slot: int
    byte: int
    bit: int

    @property
    def address(self) -> str:
        """As TIA Portal and STEP 7 write it."""
        return f"{self.direction}{self.byte}.{self.bit}"

    @property
    def located(self) -> str:
        """As IEC 61131-3 writes it."""
        return f"%{self.direction}X{self.byte}.{self.bit}"


@dataclass(frozen=True)
class Allocation:
    """All channels in the order substation, slot, bit; what the operator's place writes and reads; the heartbeats."""

    channels: tuple[Channel, ...]
    heartbeats: tuple[Channel, ...]
    written: tuple[str, ...]
    read: tuple[str, ...]
    cards: tuple[tuple[str, int, str, int], ...]

    @cached_property
    def by_variable(self) -> dict[str, Channel]:
        """Channels by the controller's variable."""
        return {c.variable: c for c in self.channels}


def _wires(layout: Layout, controller: Controller) -> Iterator[tuple[str, str, str]]:
    """Variable, direction and element of everything that has a wire."""
    sym = controller.symbols
    outputs = {o.name for o in controller.outputs}
    for s, name in sym.clear.items():
        yield name, "I", s
    for s, name in sym.healthy.items():
        yield name, "I", s
    for (m, _), name in sym.detected.items():
        yield name, "I", m
    for lamps in (sym.stop_lamp, sym.clear_lamp, sym.caution_lamp):
        for g, name in lamps.items():
            yield name, "I", g
    for c, name in sym.condition.items():
        yield name, "I", c
    for b, x_ in sym.token.items():
        for name in (x_.asks, x_.gives, x_.keeps, x_.has, x_.clear):
            yield name, "I", b
        for tells in (names.TELLS_ASKS, names.TELLS_GIVES, names.TELLS_KEEPS, names.TELLS_HAS):
            yield tells(b), "Q", b
    for m in layout.machines:
        for x in Position:
            yield names.DRIVE(m, x), "Q", m
    for signal in layout.signals:
        for lit in _LAMPS:
            if (lamp := lit(signal.id)) in outputs:
                yield lamp, "Q", signal.id
        for (g, _), name in sym.speed_shown.items():
            if g == signal.id:
                yield name, "Q", g
    for distant in layout.distants:
        for lit in (names.DISTANT_CAUTION, names.DISTANT_CLEAR):
            yield lit(distant.id), "Q", distant.id


def _substations(layout: Layout) -> tuple[Substation, ...]:
    return layout.substations or (Substation("main", ()),)


def allocate(layout: Layout, controller: Controller) -> Allocation:
    """Addresses in the order substation, slot, bit; stated addresses first.  Raises `BadAddress`."""
    notes: dict[str, str] = {i.name: i.note for i in controller.inputs}
    notes |= {o.name: o.note for o in controller.outputs}
    stations = _substations(layout)
    rest = next((s.name for s in stations if not s.elements), stations[0].name)
    holder = {e: s.name for s in stations for e in s.elements}
    wires: dict[tuple[str, str], list[tuple[str, str]]] = {}
    for variable, direction, element in _wires(layout, controller):
        # a condition that a block makes has no name in the layout: it goes where all the rest goes
        wires.setdefault((holder.get(element, rest), direction), []).append((variable, element))
    stated = _stated(layout, {v: d for (_, d), ws in wires.items() for v, _ in ws})
    taken = {(d, byte, bit) for d, byte, bit in stated.values()}
    channels: list[Channel] = []
    heartbeats: list[Channel] = []
    cards: list[tuple[str, int, str, int]] = []
    first = {"I": 0, "Q": 0}
    owner: dict[tuple[str, int], str] = {}
    for station in stations:
        slot = 0
        for direction in ("I", "Q"):
            here = [(v, e) for v, e in wires.get((station.name, direction), []) if v not in stated]
            for variable, element in wires.get((station.name, direction), []):
                if variable in stated:
                    _, byte, bit = stated[variable]
                    channels.append(Channel(variable, direction, station.name, element, notes[variable], 0, byte, bit))
            if direction == "I":
                here = [(f"HB_{portable(station.name)}", station.name), *here]
            if not here:
                continue
            count = _cards(len(here), direction, first[direction], taken)
            places = _places(direction, first[direction], taken)
            for variable, element in here:
                card, byte, bit = next(places)
                note = notes.get(variable, f"substation {station.name} is alive: changes in every cycle")
                made = Channel(variable, direction, station.name, element, note, slot + card + 1, byte, bit)
                (heartbeats if variable not in notes else channels).append(made)
            for k in range(count):
                cards.append((station.name, slot + k + 1, direction, CARD))
                owner |= {(direction, first[direction] + b): station.name for b in range(2 * k, 2 * k + 2)}
            slot += count
            first[direction] += count * CARD // 8
    for c in channels:
        if not c.slot and owner.get((c.direction, c.byte), c.substation) != c.substation:
            holds = owner[c.direction, c.byte]
            text = f"{c.variable} belongs to substation {c.substation}, but {c.address} is on a card of {holds}"
            raise BadAddress(c.variable, text)
    used = {c.variable for c in channels}
    written = tuple(i.name for i in controller.inputs if i.name not in used and i.name != controller.symbols.valid)
    read = tuple(o.name for o in controller.outputs if o.name not in used)
    return Allocation(tuple(channels), tuple(heartbeats), written, read, tuple(cards))


def _cards(wires: int, direction: str, first: int, taken: set[tuple[str, int, int]]) -> int:
    """How many cards hold so many wires, with a tenth spare, beside the stated addresses that lie on them."""
    count = 1
    while True:
        on_them = sum(d == direction and first <= byte < first + count * CARD // 8 for d, byte, _ in taken)
        if (wires + on_them) * (1 + SPARE) <= count * CARD:
            return count
        count += 1


def _places(direction: str, first: int, taken: set[tuple[str, int, int]]) -> Iterator[tuple[int, int, int]]:
    """Card, byte and bit of each free channel from a byte on."""
    k = 0
    while True:
        byte, bit = first + k // 8, k % 8
        if (direction, byte, bit) not in taken:
            yield k // CARD, byte, bit
        k += 1


def _stated(layout: Layout, wires: dict[str, str]) -> dict[str, tuple[str, int, int]]:
    """The addresses that the layout states, by variable."""
    found = {}
    for variable, address in layout.addresses:
        direction = wires.get(variable)
        if direction is None:
            raise BadAddress(variable, f"{variable} is no variable with a wire")
        if address[0] != direction:
            kind = "an input" if direction == "I" else "an output"
            raise BadAddress(variable, f"{variable} is {kind}: its address begins with {direction}")
        byte, _, bit = address[1:].partition(".")
        found[variable] = (direction, int(byte), int(bit))
    return found
