"""Which variable goes over which wire: substation, slot, bit, address (document B 2.2; DI 1 = clear).

Every detection, detector contact, lamp proof and external condition is a digital input, every machine command and lamp
a digital output.  Each substation besides has a heartbeat input, or a diagnosis bit, or both, and where it has outputs,
an output by which it sees that the controller is alive.  Everything else is written and read by the operator's
place.  Cards have 16 channels; every substation keeps spare a tenth of those that it needs.

What is pinned (`model/pins.py`) stays where it is, and so does the channel of what is gone.  What is new takes free
channels of its substation's cards, then those of a new card in bytes that nobody has.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Literal

from interlock.dataclass import dataclass
from interlock.exceptions import Whole
from interlock.logic import names
from interlock.logic.controller import Controller
from interlock.model.elements import Health, Position, Substation
from interlock.model.layout import Layout
from interlock.model.pins import CARD, Card, Pin, Pins, Place
from interlock.model.portable import portable

SPARE = 0.1

_LAMPS = (
    *(
        names.STOP_ASPECT,
        names.CAUTION_ASPECT,
        names.SECOND_YELLOW,
        names.CLEAR_ASPECT,
        names.SHUNT_ASPECT,
        names.CALL_ASPECT,
    ),
    names.ROUTE_INDICATOR,
    names.IDENTIFIER_ASPECT,
)


class BadAddress(Whole):
    """An address of the layout that cannot be given; the message says why."""

    def __init__(self, variable: str, text: str) -> None:
        super().__init__(text)
        self.variable = variable


@dataclass(frozen=True)
class Channel:
    """One wire: I or Q, the substation, the element at its other end, and what it means when it is 1.

    slot 0: the address was stated in the layout, or lies on no card.  byte and bit count from 0 for inputs and outputs
    apart.
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
    """All channels in the order substation, slot, bit; what the operator's place writes and reads; the cards, and
    channels that are kept for what the layout no longer has (on cards of substations that are gone, too).

    `health`: of each substation, in their order; `heartbeats` and `diagnoses` come from them, `sent` goes to them and
    changes in every cycle.
    """

    channels: tuple[Channel, ...]
    health: tuple[Health, ...]
    heartbeats: tuple[Channel, ...]
    diagnoses: tuple[Channel, ...]
    sent: tuple[Channel, ...]
    written: tuple[str, ...]
    read: tuple[str, ...]
    cards: tuple[Card, ...]
    reserved: tuple[Pin, ...] = ()
    left: tuple[Card, ...] = ()

    @property
    def stations(self) -> tuple[str, ...]:
        """The substations."""
        return tuple(h.substation for h in self.health)

    @cached_property
    def wires(self) -> tuple[Channel, ...]:
        """Everything that has a channel: first what tells that somebody is alive."""
        return (*self.heartbeats, *self.diagnoses, *self.sent, *self.channels)

    @cached_property
    def by_variable(self) -> dict[str, Channel]:
        """Channels by the controller's variable."""
        return {c.variable: c for c in self.channels}

    @property
    def pins(self) -> Pins:
        """All of it as pins, so that the next allocation moves nothing."""
        pinned = tuple(Pin(c.variable, c.substation, c.element, c.direction, c.byte, c.bit) for c in self.wires)
        return Pins((*self.cards, *self.left), pinned, self.reserved)


@dataclass(frozen=True)
class Wire:
    """A variable that hangs on a substation: I or Q, and the element at the wire's other end."""

    variable: str
    direction: str
    substation: str
    element: str


@dataclass(frozen=True)
class Clash:
    """A pin that the layout contradicts, by what the text says of a variable; `where` that stands: among the layout's
    `addresses` or `substations`, or in the pin itself."""

    pin: Pin
    variable: str
    text: str
    where: Literal["addresses", "substations", "pin"]


def _wires(layout: Layout, controller: Controller) -> Iterator[tuple[str, str, str]]:
    """Variable, direction and element of everything that has a wire."""
    sym = controller.symbols
    outputs = {o.name for o in controller.outputs}
    for s, name in sym.sections.clear.items():
        yield name, "I", s
    for s, name in sym.sections.healthy.items():
        yield name, "I", s
    for (m, _), name in sym.machines.detected.items():
        yield name, "I", m
    for lamps in (
        sym.lamp_proof.stop,
        sym.lamp_proof.clear,
        sym.lamp_proof.caution,
        sym.lamp_proof.identifier,
        sym.lamp_proof.second,
        sym.lamp_proof.speed,
    ):
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
    for signal in layout.signalling.signals:
        for lit in _LAMPS:
            if (lamp := lit(signal.id)) in outputs:
                yield lamp, "Q", signal.id
        for (g, _), name in sym.aspects.speed.items():
            if g == signal.id:
                yield name, "Q", g
    for distant in layout.signalling.distants:
        for lit in (names.DISTANT_CAUTION, names.DISTANT_CLEAR):
            yield lit(distant.id), "Q", distant.id


def substations(layout: Layout) -> tuple[Substation, ...]:
    """Those that the layout states, or one for everything."""
    return layout.hardware.substations or (Substation("main", ()),)


def _health(layout: Layout) -> tuple[Health, ...]:
    stated = {h.substation: h for h in layout.hardware.health}
    return tuple(stated.get(s.name, Health(s.name)) for s in substations(layout))


def wires(layout: Layout, controller: Controller) -> tuple[Wire, ...]:
    """Everything that hangs on a substation: first heartbeats and diagnosis bits, last what is sent to it."""
    stations = substations(layout)
    rest = next((s.name for s in stations if not s.elements), stations[0].name)
    holder = {e: s.name for s in stations for e in s.elements}
    health = _health(layout)
    beats = [Wire(f"HB_{portable(h.substation)}", "I", h.substation, h.substation) for h in health if h.beats]
    bits = [Wire(f"OK_{portable(h.substation)}", "I", h.substation, h.substation) for h in health if h.diagnosed]
    # a condition that a block makes has no name in the layout: it goes where all the rest goes
    found = [Wire(v, d, holder.get(e, rest), e) for v, d, e in _wires(layout, controller)]
    worked = {w.substation for w in found if w.direction == "Q"}
    sent = [Wire(f"HO_{portable(s.name)}", "Q", s.name, s.name) for s in stations if s.name in worked]
    return (*beats, *bits, *found, *sent)


_SIGNS = {
    "HB": "substation {} is alive: changes at least once in {} ms",
    "OK": "the master of the bus finds substation {} well",
    "HO": "the controller is alive: changes in every cycle; substation {} lets go of its outputs when it does not",
}


def clashes(layout: Layout, controller: Controller) -> tuple[Clash, ...]:
    """Pins that the layout contradicts: by another substation, by an address, or by what the variable is."""
    return tuple(_clashes(layout.hardware.pins, wires(layout, controller), layout.hardware.addresses))


def _clashes(pins: Pins, hanging: tuple[Wire, ...], addresses: tuple[tuple[str, str], ...]) -> Iterator[Clash]:
    at = {p.place: p for p in pins.by_variable.values()}
    stated = dict(addresses)
    for w in hanging:
        p = pins.by_variable.get(w.variable)
        address = stated.get(w.variable)
        if p is not None and p.direction != w.direction:
            kind = "an input" if w.direction == "I" else "an output"
            yield Clash(p, w.variable, f"{w.variable} is {kind}, but it is pinned to {p.address}", "pin")
        elif p is not None and p.substation != w.substation:
            said = f"{w.element} hangs on substation {w.substation}, but {w.variable} is pinned to {p.address} of"
            yield Clash(p, w.variable, f"{said} {p.substation}", "substations")
        elif p is not None and address is not None and address != p.address:
            said = f"{w.variable} is to lie at {address}, but it is pinned to {p.address}"
            yield Clash(p, w.variable, said, "addresses")
        other = None if address is None else at.get(_place(address))
        if other is not None and other.variable != w.variable:
            gone = "" if any(x.variable == other.variable for x in hanging) else ", which is gone"
            said = f"{w.variable} is to lie at {address}, but that is pinned to {other.variable}{gone}"
            yield Clash(other, w.variable, said, "addresses")


def _place(address: str) -> Place:
    byte, _, bit = address[1:].partition(".")
    return address[0], int(byte), int(bit)


def allocate(layout: Layout, controller: Controller) -> Allocation:
    """Addresses in the order substation, slot, bit: first what is pinned or stated.  Raises `BadAddress`."""
    notes: dict[str, str] = {i.name: i.note for i in controller.inputs}
    notes |= {o.name: o.note for o in controller.outputs}
    hanging = wires(layout, controller)
    stated = _stated(layout, {w.variable: w.direction for w in hanging})
    health = _health(layout)
    signs = {f"{kind}_{portable(h.substation)}": kind for h in health for kind in _SIGNS}
    for h in health:
        notes |= {f"{k}_{portable(h.substation)}": x.format(h.substation, h.within_ms) for k, x in _SIGNS.items()}
    for clash in _clashes(layout.hardware.pins, hanging, layout.hardware.addresses):
        raise BadAddress(clash.variable, clash.text)
    room = _Room(layout.hardware.pins, hanging, stated)
    channels: list[Channel] = []
    for station in substations(layout):
        for direction in ("I", "Q"):
            here = [w for w in hanging if (w.substation, w.direction) == (station.name, direction)]
            room.take(station.name, direction, [w for w in here if w.variable not in room.place])
            made = [_channel(w, room, notes[w.variable], w.variable in stated) for w in here]
            channels += [c for c in made if c.variable in stated]
            channels += sorted((c for c in made if c.variable not in stated), key=lambda c: (c.byte, c.bit))
    for c in channels:
        card = room.holder.get((c.direction, c.byte))
        if card is not None and card.substation != c.substation:
            text = f"{c.variable} belongs to substation {c.substation}, but {c.address} is on a card of"
            raise BadAddress(c.variable, f"{text} {card.substation}")
    used = {c.variable for c in channels}
    written = tuple(i.name for i in controller.inputs if i.name not in used and i.name != controller.symbols.valid)
    read = tuple(o.name for o in controller.outputs if o.name not in used)
    cards = tuple(c for s in substations(layout) for c in room.cards if c.substation == s.name)
    stations = {s.name for s in substations(layout)}
    left = tuple(c for c in room.cards if c.substation not in stations)
    beats, bits, sent = (tuple(c for c in channels if signs.get(c.variable) == kind) for kind in _SIGNS)
    plain = tuple(c for c in channels if c.variable not in signs)
    return Allocation(plain, health, beats, bits, sent, written, read, cards, room.reserved, left)


def _channel(w: Wire, room: _Room, note: str, stated: bool) -> Channel:
    direction, byte, bit = room.place[w.variable]
    card = room.holder.get((direction, byte))
    slot = 0 if stated or card is None or card.substation != w.substation else card.slot
    return Channel(w.variable, direction, w.substation, w.element, note, slot, byte, bit)


class _Room:
    """The cards, what lies where, and what is still free."""

    def __init__(self, pins: Pins, hanging: tuple[Wire, ...], stated: Mapping[str, Place]) -> None:
        known, stations = {w.variable for w in hanging}, {w.substation for w in hanging}
        self.reserved = tuple(p for n, p in sorted(pins.by_variable.items()) if n not in known)
        self.place = {n: p.place for n, p in pins.by_variable.items() if n in known} | dict(stated)
        self.taken = {*self.place.values(), *(p.place for p in self.reserved)}
        kept = {(p.direction, p.byte) for p in self.reserved}
        self.cards: list[Card] = []
        self.holder: dict[tuple[str, int], Card] = {}
        for c in sorted(pins.cards, key=lambda c: (c.substation, c.slot)):
            # the cards of a substation that is gone stay as long as anything is kept on them
            if c.substation in stations or any((c.direction, b) in kept for b in c.bytes):
                self._add(c)
        self._closed = {(d, byte) for d, byte, _ in self.taken} if pins else set()
        self._looked: dict[str, int] = {}  # from where on bytes may be free: none becomes free again

    def _add(self, card: Card) -> None:
        self.cards.append(card)
        self.holder |= {(card.direction, b): card for b in card.bytes}

    def take(self, station: str, direction: str, new: list[Wire]) -> None:
        """Give channels to wires of a substation, on further cards where its own have no room, a tenth being spare."""
        if not new:
            return
        own = [c for c in self.cards if (c.substation, c.direction) == (station, direction)]
        needed = len(new) + self._used(own)
        slot = max((c.slot for c in self.cards if c.substation == station), default=0)
        while needed * (1 + SPARE) > len(own) * CARD:
            slot += 1
            own.append(Card(station, slot, direction, self._first(direction)))
            self._add(own[-1])
            needed += self._used(own[-1:])
        free = (x for x in _places(own) if x not in self.taken)
        self.place |= {w.variable: next(free) for w in new}
        self.taken |= {self.place[w.variable] for w in new}

    def _used(self, cards: list[Card]) -> int:
        """Channels on these cards that are taken."""
        return sum(x in self.taken for x in _places(cards))

    def _first(self, direction: str) -> int:
        """The first two bytes together in which there is no card, nor anything that is pinned."""
        byte = self._looked.get(direction, 0)
        while any((direction, b) in self.holder or (direction, b) in self._closed for b in (byte, byte + 1)):
            byte += CARD // 8
        self._looked[direction] = byte
        return byte


def _places(cards: list[Card]) -> Iterator[Place]:
    """The channels of cards in their order."""
    for c in sorted(cards, key=lambda c: c.byte):
        for byte in c.bytes:
            for bit in range(8):
                yield c.direction, byte, bit


def _stated(layout: Layout, known: Mapping[str, str]) -> dict[str, Place]:
    """The addresses that the layout states, by variable; `known`: the direction of what has a wire."""
    found = {}
    for variable, address in layout.hardware.addresses:
        direction = known.get(variable)
        if direction is None:
            raise BadAddress(variable, f"{variable} is no variable with a wire")
        if address[0] != direction:
            kind = "an input" if direction == "I" else "an output"
            raise BadAddress(variable, f"{variable} is {kind}: its address begins with {direction}")
        found[variable] = _place(address)
    return found
