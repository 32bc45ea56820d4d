"""Point telegrams (document C): two bits a point, 10 normal, 01 reverse, most significant bit first, and a check byte.

Plain: four points a byte; unused places are 00; the last byte is the exclusive or of the others.  That check is blind
to the order of bytes: two of them exchanged pass.  Tagged: three points a byte, and the byte's number modulo 4 in its
last two bits, so that exchanged bytes do not pass (up to four of them).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import reduce
from operator import xor

from interlock.dataclass import dataclass
from interlock.model.elements import MachineId, Position


class BadTelegram(Exception):
    """A telegram that must not be carried out; the message says why."""


@dataclass(frozen=True)
class Form:
    """The machines in the order of their places, and whether bytes carry their number."""

    machines: tuple[MachineId, ...]
    tagged: bool = False

    @property
    def per_byte(self) -> int:
        """Points in a byte."""
        return 3 if self.tagged else 4

    @property
    def size(self) -> int:
        """Bytes of a telegram, with the check byte."""
        return -(-len(self.machines) // self.per_byte) + 1

    def tag(self, byte: int) -> int | None:
        """What the last two bits of a byte must be; None where they carry a point."""
        return byte % 4 if self.tagged else None


_CODE = {Position.NORMAL: 0b10, Position.REVERSE: 0b01}


def encode(form: Form, positions: Mapping[MachineId, Position]) -> bytes:
    """The telegram that commands every machine of the form.  Raises KeyError when one is missing."""
    out = []
    for k in range(form.size - 1):
        byte = 0
        for place in range(4):
            if form.tagged and place == 3:
                code = k % 4
            else:
                n = k * form.per_byte + place
                code = _CODE[positions[form.machines[n]]] if n < len(form.machines) else 0
            byte = byte << 2 | code
        out.append(byte)
    return bytes([*out, reduce(xor, out)])


def decode(form: Form, telegram: bytes) -> dict[MachineId, Position]:
    """The positions that a telegram commands.  Raises `BadTelegram` unless every code, place and check is right."""
    if len(telegram) != form.size:
        raise BadTelegram(f"{len(telegram)} bytes, not {form.size}")
    if reduce(xor, telegram) != 0:
        raise BadTelegram("the check byte is wrong")
    found: dict[MachineId, Position] = {}
    for k, byte in enumerate(telegram[:-1]):
        for place in range(4):
            code = byte >> (6 - 2 * place) & 0b11
            if form.tagged and place == 3:
                if code != k % 4:
                    raise BadTelegram(f"byte {k + 1} bears another number")
                continue
            n = k * form.per_byte + place
            if n >= len(form.machines):
                if code:
                    raise BadTelegram(f"byte {k + 1}: an unused place is not 00")
                continue
            if code not in _CODE.values():
                raise BadTelegram(f"{form.machines[n]}: {code:02b} is no position")
            found[form.machines[n]] = Position.NORMAL if code == 0b10 else Position.REVERSE
    return found


@dataclass
class Sender:
    """Sends a telegram until the receiver has said that it was right: again after a refusal or a silence, then alarm.

    tries: telegrams until the alarm.  wait_ms: time for an answer.
    """

    form: Form
    tries: int = 3
    wait_ms: int = 200
    alarm: bool = False
    _waiting: bytes | None = field(default=None, init=False)
    _sent: int = field(default=0, init=False)
    _silent_ms: int = field(default=0, init=False)
    _done: bytes | None = field(default=None, init=False)

    def step(
        self,
        own: Mapping[MachineId, Position],
        host: Mapping[MachineId, Position],
        answer: bool | None,
        dt_ms: int,
    ) -> bytes | None:
        """The telegram to send now, if any.

        own: what the controller commands; host: what the host computed by itself.  Nothing is sent unless both agree on
        every machine (double check, document C).  answer: the receiver's word since the last step.
        """
        if answer is True and self._waiting is not None:
            self._done, self._waiting, self._sent, self.alarm = self._waiting, None, 0, False
        if any(m not in own or host.get(m) is not own[m] for m in self.form.machines):
            self._waiting, self._sent, self._done = None, 0, None
            return None
        wanted = encode(self.form, own)
        if wanted != self._waiting:
            if wanted == self._done:
                return None
            self._waiting, self._sent, self._silent_ms, self._done = wanted, 1, 0, None
            return wanted
        self._silent_ms += dt_ms
        if answer is False or self._silent_ms >= self.wait_ms:
            if self._sent >= self.tries:
                self.alarm = True
                return None
            self._sent += 1
            self._silent_ms = 0
            return wanted
        return None


@dataclass
class Receiver:
    """Carries out right telegrams alone, and answers whether one was right; a wrong one changes nothing."""

    form: Form
    positions: dict[MachineId, Position] = field(default_factory=dict)
    refused: list[str] = field(default_factory=list)

    def receive(self, telegram: bytes) -> bool:
        """The answer to a telegram."""
        try:
            self.positions = decode(self.form, telegram)
        except BadTelegram as error:
            self.refused.append(str(error))
            return False
        return True


def form_of(machines: Sequence[MachineId], tagged: bool = False) -> Form:
    """The form for machines in their order."""
    return Form(tuple(machines), tagged)
