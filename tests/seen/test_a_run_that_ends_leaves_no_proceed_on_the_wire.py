"""When `interlock run` ended, a signal that showed proceed stayed so on the wire."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from interlock.app.run import Ready
from tests.field import TWO, Station


@pytest.fixture
def stations(mine: Ready) -> Iterator[tuple[Station, Station]]:
    """The substations, as processes."""
    west, east = Station(mine, "west"), Station(mine, "east")
    yield west, east
    west.kill()
    east.kill()


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM, None])
def test_a_run_that_ends_leaves_no_proceed_on_the_wire(
    stations: tuple[Station, Station], tmp_path: Path, how: signal.Signals | None
) -> None:
    west, east = stations
    path = tmp_path / "mine.yaml"
    path.write_text(Path("layouts/mine11.yaml").read_text("utf-8") + TWO, "utf-8")
    wires = [x for s in (west, east) for x in ("--modbus", f"{s.name}=127.0.0.1:{s.port}")]
    command = [sys.executable, "-c", "from interlock.cli.main import main; main()", "run", str(path), *wires]
    cycles = ["--cycles", "120"] if how is None else []
    run = subprocess.Popen(
        [*command, "--cycle", "40", *cycles], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert run.stdin is not None and run.stdout is not None
    try:
        for line in iter(run.stdout.readline, ""):
            if "inputs valid" in line:
                break
        time.sleep(1.2)  # the restart delay
        for typed in ("free\n", "release\n", "\n", "\n", "set X7-X1\n"):
            run.stdin.write(typed)
            run.stdin.flush()
        until = time.monotonic() + 5
        while not west.lamp("YP_X7") and time.monotonic() < until:
            time.sleep(0.02)
        assert west.lamp("YP_X7"), "the signal opens while the command runs"
        if how is not None:
            run.send_signal(how)
        run.wait(20)
    finally:
        run.kill()
        run.stdin.close()
        run.stdout.close()
    assert west.lamp("YS_X7") and not west.lamp("YP_X7"), "stop is lit on the wire, and nothing else"
