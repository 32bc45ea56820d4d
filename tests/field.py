"""The soft PLC and two substations on the loopback, for tests: mine11 in real Modbus servers."""

from __future__ import annotations

import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pymodbus.client import ModbusTcpClient

from interlock.app.run import Ready, operate, prepare
from interlock.field.modbus import ModbusLink
from interlock.field.plc import Cycle, SoftPlc, runtime_scan
from interlock.field.polling import InTurn, Poll
from tests.substation import WIRE

TWO = """
substations:
  west: [ap_W, q1, q2, P1, X7, X1]
  east: []
principles: {restart_delay_s: 0.8, release_delay_s: 0.3, line_speed_kmh: 20000, braking_ms2: 50000,
             reaction_s: 0.01, output_delay_s: 0.01}
"""  # trains that stop so soon that the restart delay may be short


def two_substations(folder: Path) -> Ready:
    """mine11 with two substations, proved."""
    path = folder / "mine.yaml"
    path.write_text(Path("layouts/mine11.yaml").read_text("utf-8") + TWO, "utf-8")
    found = prepare(str(path))
    assert found.proved.green and found.allocation is not None
    return found


def free_port() -> int:
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        port: int = s.getsockname()[1]
        return port


class Station:
    """A substation process, and a wire to its inputs."""

    lives_s = 60
    """Seconds after which it ends by itself."""

    def __init__(self, ready: Ready, name: str) -> None:
        assert ready.allocation is not None
        self.name = name
        wires = ready.allocation.wires
        self.places = {c.variable: 8 * c.byte + c.bit for c in wires}
        self.own = [c for c in ready.allocation.channels if c.substation == name]
        self.beat = next(c for c in ready.allocation.heartbeats if c.substation == name)
        self.port = free_port()
        self.start()

    def start(self) -> None:
        """Start the process; sections are clear and points lie normal."""
        ones = [str(self.places[c.variable]) for c in self.own if c.variable.startswith(("CLR_", "DN_"))]
        args = [str(self.port), str(self.lives_s), str(self.places[self.beat.variable]), *ones]
        command = [sys.executable, "-m", "tests.substation", *args]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        assert self.process.stdout is not None and self.process.stdout.readline().strip() == "ready"
        self.client = ModbusTcpClient("127.0.0.1", port=self.port, timeout=1, retries=0)
        assert self.client.connect()

    def put(self, variable: str, value: int) -> None:
        """Move the railway."""
        self.wire(self.places[variable], value)

    def wire(self, place: int, value: int) -> None:
        """Set an input."""
        self.client.write_coils(WIRE + place, [bool(value)], device_id=1)

    def lamp(self, variable: str) -> bool:
        """What hangs on an output."""
        return bool(self.client.read_coils(self.places[variable], count=1, device_id=1).bits[0])

    def kill(self) -> None:
        """The process dies at once."""
        self.client.close()
        self.process.kill()
        self.process.wait()
        assert self.process.stdout is not None
        self.process.stdout.close()


@contextmanager
def running(ready: Ready, poll: Poll | None = None) -> Iterator[tuple[SoftPlc, Station, Station]]:
    assert ready.allocation is not None
    west, east = Station(ready, "west"), Station(ready, "east")
    links = {s.name: ModbusLink(ready.allocation, s.name, "127.0.0.1", s.port) for s in (west, east)}
    plc = SoftPlc(runtime_scan(ready.runtime), ready.allocation, links, poll=poll or InTurn())
    try:
        yield plc, west, east
    finally:
        plc.close()
        west.kill()
        east.kill()


def cycle(ready: Ready, plc: SoftPlc, dt_ms: int = 100, line: str = "") -> Cycle:
    """One cycle with a command."""
    assert ready.allocation is not None
    operator = dict.fromkeys(ready.allocation.written, 0) | (operate(ready, line) if line else {})
    time.sleep(0.03)  # the servers' heartbeats go on in real time
    return plc.cycle(operator, dt_ms)


def until_valid(ready: Ready, plc: SoftPlc) -> None:
    for _ in range(40):
        if cycle(ready, plc).valid:
            return
    raise AssertionError("never valid")


def until_released(ready: Ready, plc: SoftPlc) -> None:
    """Valid inputs, the restart delay over, everything released."""
    until_valid(ready, plc)
    for _ in range(10):
        cycle(ready, plc)
    cycle(ready, plc, line="release")
