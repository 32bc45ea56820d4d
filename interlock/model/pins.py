"""Addresses that stay: which cards a cabinet has, which channel each variable has, and which are kept for what is gone.

They lie beside a layout (`NAME.pins`), not in it: neither table nor proof sees them, and the layout's digest is the
same with and without.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from interlock.dataclass import dataclass
from interlock.model.contents import digest

CARD = 16
"""Channels of a card (document B 2.2)."""

Place = tuple[str, int, int]
"""I or Q, byte, bit."""


@dataclass(frozen=True)
class Card:
    """A card of a substation in its slot; its channels lie from bit 0 of `byte` on, inputs and outputs apart."""

    substation: str
    slot: int
    direction: str
    byte: int
    size: int = CARD

    @property
    def bytes(self) -> range:
        """The bytes that it takes."""
        return range(self.byte, self.byte + self.size // 8)


@dataclass(frozen=True)
class Pin:
    """The channel of a variable: I or Q, byte and bit; the element at the wire's other end."""

    variable: str
    substation: str
    element: str
    direction: str
    byte: int
    bit: int

    @property
    def place(self) -> Place:
        """Where it lies."""
        return self.direction, self.byte, self.bit

    @property
    def address(self) -> str:
        """As TIA Portal and STEP 7 write it."""
        return f"{self.direction}{self.byte}.{self.bit}"


@dataclass(frozen=True)
class Pins:
    """`reserved`: channels of variables that the layout no longer has; nothing else is put there."""

    cards: tuple[Card, ...] = ()
    channels: tuple[Pin, ...] = ()
    reserved: tuple[Pin, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.cards or self.channels or self.reserved)

    @cached_property
    def by_variable(self) -> Mapping[str, Pin]:
        """All of them, those that are kept for what is gone too: it may come back."""
        return {p.variable: p for p in (*self.reserved, *self.channels)}

    @cached_property
    def digest(self) -> str:
        """SHA-256 of what they say."""
        return digest(self)
