"""Requests as they come over Modbus TCP, and who sends them.  Nothing is guessed: what is no request is none of it."""

from __future__ import annotations

import contextvars
from dataclasses import field

from interlock.dataclass import dataclass

HEADER, LARGEST = 7, 254
"""Bytes of the header, and the largest length that it may tell: the device and the request."""

FIXED = dict.fromkeys((1, 2, 3, 4, 6), 5)
"""Functions that are answered, but for that which writes several registers, and the bytes of their requests."""
WRITES = 16


@dataclass(eq=False)
class Caller:
    """Whoever is at the other end of a connection; `pair`: what he has written of a request, and when."""

    name: str
    pair: dict[int, tuple[int, float]] = field(default_factory=dict)
    number_first: bool = False
    last: tuple[int, int, int] | None = None
    """His last whole request."""


caller: contextvars.ContextVar[Caller] = contextvars.ContextVar("caller")
"""Who asks, while his request is taken."""


class NotModbus(Exception):
    """What came is no request of Modbus TCP."""


@dataclass(frozen=True)
class Frame:
    """A request as it came."""

    transaction: int
    device: int
    request: bytes


def frames(data: bytes) -> tuple[list[Frame], bytes]:
    """The requests that have come whole, and what has come of the next one.  Raises `NotModbus` at the first byte that
    cannot be of one, before or behind whole requests: nothing of it is taken then."""
    found = []
    while data:
        if any(data[2:4]) or any(data[4:5]):
            raise NotModbus
        if len(data) < HEADER - 1:
            break
        length = data[5]
        if not 2 <= length <= LARGEST:
            raise NotModbus
        request = data[HEADER : HEADER - 1 + length]
        if request:
            _checked(request, length - 1)
        if len(data) < HEADER - 1 + length:
            break
        found.append(Frame(int.from_bytes(data[:2], "big"), data[6], request))
        data = data[HEADER - 1 + length :]
    return found, data


def _checked(request: bytes, size: int) -> None:
    """A request of `size` bytes, of which these have come, is one.  Raises `NotModbus`."""
    function = request[0]
    if not 0 < function < 128 or size != FIXED.get(function, size):
        raise NotModbus
    if function == WRITES and len(request) >= 6:
        registers = int.from_bytes(request[3:5], "big")
        if not registers or request[5] != 2 * registers or size != 6 + request[5]:
            raise NotModbus
