"""A substation on Modbus TCP: its inputs are discrete inputs, its outputs coils, numbered byte times 8 plus bit.

One of its coils (`HO_...`) is our heartbeat: it changes in every cycle in which the substation has taken all its other
outputs, and a substation should let go of its outputs when it does not.  Needs the extra `field` (pymodbus).
"""

from __future__ import annotations

import logging
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

from interlock.field.plc import LinkLost
from interlock.field.polling import in_short
from interlock.logic.cabinet import Allocation, Channel

MOST_BYTE = 8191
"""The last byte whose bits have a number: a number has 16 bits."""

REFUSALS = {
    1: "it does not know this function",
    2: "it has not that many addresses",
    3: "it does not take that many at once",
    4: "it has failed inside",
    6: "it is busy",
    10: "its gateway has no way to the device",
    11: "its gateway gets no answer from the device",
}
"""What the exceptions of Modbus say."""


class _Refused(LinkLost):
    """It answers, and does not do it; the connection is well."""


READ, WRITE = 2, 15
"""The functions that are used."""


def _exact() -> tuple[type, type]:
    """Answers to both that are as long as they say: the library counts neither bytes nor bits itself."""
    from pymodbus.pdu.bit_message import ReadDiscreteInputsResponse, WriteMultipleCoilsResponse

    class Inputs(ReadDiscreteInputsResponse):
        def decode(self, data: bytes) -> None:
            if len(data) != 1 + data[0]:
                raise ValueError(f"{data[0]} bytes are {len(data) - 1}")
            super().decode(data)

    class Coils(WriteMultipleCoilsResponse):
        def decode(self, data: bytes) -> None:
            if len(data) != 4:
                raise ValueError(f"an address and a count of {len(data)} bytes")
            super().decode(data)

    return Inputs, Coils


class ModbusLink:
    """One substation; connects when it is first used, and again after it was lost."""

    def __init__(
        self, a: Allocation, station: str, host: str, port: int = 502, device: int = 1, timeout_s: float = 0.2
    ) -> None:
        from pymodbus.client import ModbusTcpClient

        logging.getLogger("pymodbus").setLevel(logging.CRITICAL)  # what is lost is told by `Cycle.lost`
        own = [c for c in a.wires if c.substation == station]
        self._inputs = {c.variable: 8 * c.byte + c.bit for c in own if c.direction == "I"}
        self._outputs = {c.variable: 8 * c.byte + c.bit for c in own if c.direction == "Q"}
        self._beats = [c.variable for c in a.sent if c.substation == station]
        self._device, self._place, self._timeout_s = device, f"{host}:{port}", timeout_s
        self._client: Any = ModbusTcpClient(host, port=port, timeout=timeout_s, retries=0)
        for answer in _exact():
            self._client.register(answer)

    def _ask(self, what: str, which: str, *args: Any, **more: Any) -> Any:
        """Raises `LinkLost`, in words of whoever looks after the substation."""
        try:
            if not self._client.connected and not self._client.connect():
                raise LinkLost(f"no connection to {self._place}")
            answer = getattr(self._client, what)(*args, device_id=self._device, **more)
        except LinkLost:
            raise
        except Exception as error:  # the library checks what it is told, and raises what it likes
            with suppress(Exception):
                self._client.close()
            raise LinkLost(self._said(error)) from None
        if answer is None:
            raise LinkLost(f"no answer from {self._place}")
        if answer.isError():
            code = getattr(answer, "exception_code", 0)
            why = f"{REFUSALS.get(code, 'it does not say why')} (Modbus exception {code})"
            raise _Refused(f"{self._place} refuses {which}: {why}")
        return answer

    def _said(self, error: Exception) -> str:
        """What has happened on the way: the library has words of its own, for programmers."""
        from pymodbus.exceptions import ConnectionException, ModbusException, ModbusIOException

        if isinstance(error, ConnectionException):
            return f"the connection to {self._place} was broken off"
        if isinstance(error, ModbusIOException) and "No response" in str(error):
            return f"{self._place}, device {self._device}, does not answer within {self._timeout_s:g} s"
        if isinstance(error, OSError):
            return f"no connection to {self._place}: {error.strerror or type(error).__name__}"
        if isinstance(error, ModbusException):
            return self._something_else
        return f"{self._place} cannot be asked: {in_short(error)}"

    @property
    def _something_else(self) -> str:
        return f"{self._place} answers something else than what was asked: is it Modbus TCP?"

    def _check(self, fits: bool) -> None:
        """Raises `LinkLost` where an answer does not fit: whatever comes on that connection is doubtful."""
        if not fits:
            with suppress(Exception):
                self._client.close()
            raise LinkLost(self._something_else)

    def read(self) -> Mapping[str, int]:
        """All inputs of the substation in as few requests as the protocol allows."""
        bits: dict[int, bool] = {}
        for first, count in _runs(self._inputs.values(), 2000):
            which = f"the discrete inputs {first} to {first + count - 1}"
            answer = self._ask("read_discrete_inputs", which, first, count=count)
            self._check(answer.function_code == READ)
            if len(answer.bits) < count:
                raise LinkLost(f"{self._place} answers with {len(answer.bits)} of {count} inputs")
            self._check(len(answer.bits) == 8 * -(-count // 8))
            bits |= {first + k: bool(answer.bits[k]) for k in range(count)}
        return {n: int(bits[at]) for n, at in self._inputs.items()}

    def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
        """All outputs of the substation; our heartbeat behind them, and only if it has taken every one: while any
        output may be an old one the heartbeat stands still.  Coils between them are not ours."""
        refused = self._put({at: values[n] for n, at in self._outputs.items() if n not in self._beats})
        if refused is None:
            refused = self._put({self._outputs[n]: heartbeat for n in self._beats})
        if refused is not None:
            raise refused

    def _put(self, wanted: Mapping[int, bool]) -> _Refused | None:
        """Write coils; what is refused first.  The others are written all the same: they may belong to another card."""
        refused = None
        for first, count in _runs(wanted, 1900, gaps=False):
            which = f"the coils {first} to {first + count - 1}"
            try:
                answer = self._ask("write_coils", which, first, [wanted[first + k] for k in range(count)])
                self._check((answer.function_code, answer.address, answer.count) == (WRITE, first, count))
            except _Refused as error:
                refused = refused or error
        return refused

    def close(self) -> None:
        """Close the connection."""
        self._client.close()


def beyond(a: Allocation) -> tuple[Channel, ...]:
    """Channels at addresses for which Modbus has no number."""
    return tuple(c for c in a.wires if c.byte > MOST_BYTE)


def _runs(places: Any, most: int, gaps: bool = True) -> list[tuple[int, int]]:
    """Ranges that cover the places, each with at most so many; without `gaps` they cover nothing else."""
    out: list[tuple[int, int]] = []
    for at in sorted(places):
        if out and at - out[-1][0] < most and (gaps or at == sum(out[-1])):
            out[-1] = (out[-1][0], at - out[-1][0] + 1)
        else:
            out.append((at, 1))
    return out
