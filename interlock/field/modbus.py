"""A substation on Modbus TCP: its inputs are discrete inputs, its outputs coils, numbered byte times 8 plus bit.

One of its coils (`HO_...`) is our heartbeat: it changes in every cycle, and a substation should let go of its outputs
when it does not.  Needs the extra `field` (pymodbus).
"""

from __future__ import annotations

import logging
from collections.abc import Mapping
from typing import Any

from interlock.field.plc import LinkLost
from interlock.logic.cabinet import Allocation


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
        self._device = device
        self._client: Any = ModbusTcpClient(host, port=port, timeout=timeout_s, retries=0)

    def _ask(self, what: str, *args: Any, **more: Any) -> Any:
        from pymodbus.exceptions import ModbusException

        try:
            if not self._client.connected and not self._client.connect():
                raise LinkLost("no connection")
            answer = getattr(self._client, what)(*args, device_id=self._device, **more)
        except (ModbusException, OSError) as error:
            self._client.close()
            raise LinkLost(str(error) or type(error).__name__) from None
        if answer is None or answer.isError():
            raise LinkLost(f"refuses {what}")
        return answer

    def read(self) -> Mapping[str, int]:
        """All inputs of the substation in as few requests as the protocol allows."""
        bits: dict[int, bool] = {}
        for first, count in _runs(self._inputs.values(), 2000):
            answer = self._ask("read_discrete_inputs", first, count=count)
            if len(answer.bits) < count:
                raise LinkLost("too few inputs")
            bits |= {first + k: bool(answer.bits[k]) for k in range(count)}
        return {n: int(bits[at]) for n, at in self._inputs.items()}

    def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
        """All outputs of the substation, our heartbeat among them; coils between them are not ours."""
        told = {**values, **dict.fromkeys(self._beats, heartbeat)}
        wanted = {at: told[n] for n, at in self._outputs.items()}
        for first, count in _runs(wanted, 1900, gaps=False):
            self._ask("write_coils", first, [wanted[first + k] for k in range(count)])

    def close(self) -> None:
        """Close the connection."""
        self._client.close()


def _runs(places: Any, most: int, gaps: bool = True) -> list[tuple[int, int]]:
    """Ranges that cover the places, each with at most so many; without `gaps` they cover nothing else."""
    out: list[tuple[int, int]] = []
    for at in sorted(places):
        if out and at - out[-1][0] < most and (gaps or at == sum(out[-1])):
            out[-1] = (out[-1][0], at - out[-1][0] + 1)
        else:
            out.append((at, 1))
    return out
