"""A substation on Modbus TCP for tests: a process of its own, on the loopback only, that ends by itself.

    python -m tests.substation PORT SECONDS HEARTBEAT INPUT...

HEARTBEAT is the discrete input that changes every 130 ms: longer than a cycle of 100 ms, or it could be read at the
same value each time.  INPUT... are those that are 1.  A coil from 4000 on is a wire to the discrete input with 4000
less, so that a test can move the railway; while the one of FROZEN is 1 the heartbeat stands still, while the one of
LATE is 1 inputs are told half a second late.
"""

from __future__ import annotations

import asyncio
import sys
import time

from pymodbus.server import ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

WIRE = 4000
FROZEN, LATE = 3999, 3998
READ_INPUTS, WRITE_COIL, WRITE_COILS = 2, 5, 15


async def serve(port: int, seconds: float, heartbeat: int, ones: list[int]) -> None:
    """Answer for so many seconds."""
    inputs = [0] * WIRE
    for at in ones:
        inputs[at] = 1

    async def act(
        function: int, start: int, address: int, count: int, registers: list[int], values: list[bool] | None
    ) -> None:
        del start, count
        if function in (WRITE_COIL, WRITE_COILS) and address >= WIRE and values:
            inputs[address - WIRE : address - WIRE + len(values)] = [int(v) for v in values]
        if function == READ_INPUTS:
            if not inputs[FROZEN]:
                inputs[heartbeat] = int(time.monotonic() / 0.13) % 2
            if inputs[LATE]:
                await asyncio.sleep(0.5)
            for k in range(WIRE // 16):  # sixteen inputs a register
                registers[k] = sum(bit << n for n, bit in enumerate(inputs[16 * k : 16 * k + 16]))

    bits = [[SimData(0, values=[False] * 2 * WIRE, datatype=DataType.BITS)] for _ in range(2)]
    words = [[SimData(0, values=[0] * 8, datatype=DataType.REGISTERS)] for _ in range(2)]
    device = SimDevice(0, simdata=(bits[0], bits[1], words[0], words[1]), action=act)
    server = ModbusTcpServer(device, address=("127.0.0.1", port))
    await server.serve_forever(background=True)
    print("ready", flush=True)
    await asyncio.sleep(seconds)
    await server.shutdown()


if __name__ == "__main__":
    port_, seconds_, beat, *rest = sys.argv[1:]
    asyncio.run(serve(int(port_), float(seconds_), int(beat), [int(x) for x in rest]))
