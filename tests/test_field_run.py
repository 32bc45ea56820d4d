"""`interlock run` on real Modbus servers: its options, its end, a SCADA beside it, and the panel."""

from __future__ import annotations

import json
import queue
import threading
import time
from collections.abc import Callable

import pytest
from click.testing import CliRunner
from pymodbus.client import ModbusTcpClient

from interlock.app.run import Ready
from interlock.cli import lines
from interlock.cli.main import cli
from interlock.field.alone import InUse, hold
from interlock.field.modbus import ModbusLink
from interlock.field.operator_place import FIRST_ONE, TAKEN
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from tests.field import Station, free_port


def test_the_command_runs_proves_and_stops(mine: Ready, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lines, "LATE_S", 60.0)  # however slow the cycles are
    west, east = Station(mine, "west"), Station(mine, "east")
    try:
        path = mine.proved.checked.path
        args = ["run", path, "--modbus", f"west=127.0.0.1:{west.port}", "--modbus", f"east=127.0.0.1:{east.port}"]
        twice = CliRunner().invoke(cli, [*args, "--modbus", f"west=127.0.0.1:{east.port}", "--cycles", "1"])
        assert twice.exit_code == 2 and "--modbus says twice where west is" in twice.output
        typed = "\n" * 29 + "free\nrelease\nset X7-X1\nrubbish\n"  # a line a cycle
        done = CliRunner().invoke(cli, [*args, "--cycles", "50", "--cycle", "40"], input=typed)
        assert done.exit_code == 0, done.output
        assert mine.proved.seconds > 0.0  # it says how long that took, as `prove` does
        assert "PROVED" in done.output and "inputs valid" in done.output and "YP_X7 = 1" in done.output
        assert "BLK_q1=0 takes the block off one, free off all" in done.output and "held: nothing" in done.output
        assert "write set ROUTE" in done.output and "the longest cycle took" in done.output
        locks = hold([f"127.0.0.1:{east.port}/1"])  # the run has ended, and holds nothing
        with pytest.raises(InUse, match=f"127.0.0.1:{east.port}/1 is held"):
            hold([f"127.0.0.1:{east.port}/1"])
        second = CliRunner().invoke(cli, [*args, "--cycles", "1"])
        assert second.exit_code == 2 and "two may not write the same outputs" in second.output
        for lock in locks:
            lock.close()
        wrong = CliRunner().invoke(cli, ["run", path, "--modbus", "north=127.0.0.1:1"])
        assert wrong.exit_code == 2 and "substations: west, east" in wrong.output
        for more, told in (("--record x.log", "--record goes with --panel"), ("--port 0", "--port goes with --panel")):
            no = CliRunner().invoke(cli, [*args, *more.split()])
            assert no.exit_code == 2 and told in no.output, no.output
        missing = CliRunner().invoke(cli, [*args[:4]])
        assert missing.exit_code == 2 and "missing for east" in missing.output
    finally:
        west.kill()
        east.kill()


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("1.2.3.4", "1.2.3.4: write SUBSTATION=HOST:PORT[/DEVICE]; substations: main"),
        ("north=1.2.3.4:502", "substations: main"),
        ("1.2.3.4:99999", "a port is between 1 and 65535"),
    ],
)
def test_an_address_is_looked_at_before_the_proof(given: str, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A proof takes minutes."""
    monkeypatch.setattr("interlock.app.run.prove_derived", lambda *args: pytest.fail("it is being proved"))
    no = CliRunner().invoke(cli, ["run", "layouts/fig2_2.yaml", "--modbus", given])
    assert no.exit_code == 2 and said in no.output, no.output


def test_the_end_of_a_run_names_the_substations_that_could_not_be_written(mine: Ready) -> None:
    """It said that every output that could be reached is restrictive, and not which could not."""
    west, east = Station(mine, "west"), Station(mine, "east")
    path, args = mine.proved.checked.path, [f"west=127.0.0.1:{west.port}", f"east=127.0.0.1:{east.port}"]
    east.kill()
    try:
        run = ["run", path, "--modbus", args[0], "--modbus", args[1], "--cycles", "2"]
        done = CliRunner().invoke(cli, run)
        assert done.exit_code == 0 and "\nNOT WRITTEN: substation east: " in done.output, done.output
        assert "substation west: " not in done.output.split("NOT WRITTEN", 1)[1]
        done = CliRunner().invoke(cli, [*run, "--format", "json"])
        assert list(json.loads(done.output.splitlines()[-1])["not_written"]) == ["east"], done.output
    finally:
        west.kill()


def test_a_scada_asks_for_a_route_and_the_run_says_who_did(mine: Ready) -> None:
    west, east = Station(mine, "west"), Station(mine, "east")
    port, seen = free_port(), list[int]()

    def scada() -> None:
        client = ModbusTcpClient("127.0.0.1", port=port, timeout=2, retries=0)
        until = time.monotonic() + 10
        while not client.connect() and time.monotonic() < until:
            time.sleep(0.05)
        while not client.read_input_registers(2, count=1).registers[0] and time.monotonic() < until:
            time.sleep(0.05)
        for number in (1, 2):  # the first one since the start is not carried out
            client.write_registers(0, [number, 1, 1])
            time.sleep(0.3)
            seen.extend(client.read_input_registers(3, count=2).registers)
        client.close()

    other = threading.Thread(target=scada)
    other.start()
    try:
        path = mine.proved.checked.path
        args = ["run", path, "--modbus", f"west=127.0.0.1:{west.port}", "--modbus", f"east=127.0.0.1:{east.port}"]
        more = ["--operator-modbus", str(port), "--operator-requests", "--cycles", "60", "--cycle", "40"]
        done = CliRunner().invoke(cli, [*args, *more])
        other.join(10)
        assert done.exit_code == 0 and "modbus 127.0.0.1:" in done.output and " asks: set " in done.output, done.output
        assert seen == [1, FIRST_ONE, 2, TAKEN]
    finally:
        west.kill()
        east.kill()


def test_the_panel_works_real_substations_and_leaves_them_restrictive(mine: Ready) -> None:
    """With Modbus there is no railway to play with, and the end is restrictive."""
    assert mine.allocation is not None
    west, east = Station(mine, "west"), Station(mine, "east")
    desk = Desk(mine, {s.name: ModbusLink(mine.allocation, s.name, "127.0.0.1", s.port) for s in (west, east)}, 50)
    answers: queue.SimpleQueue[dict[str, object]] = queue.SimpleQueue()

    def ask(**command: object) -> dict[str, object]:
        desk.ask(Person("Hal", True), dict(command), answers.put)
        return answers.get(timeout=10)

    def until(so: Callable[[], object]) -> None:
        end = time.monotonic() + 20
        while not so():
            assert time.monotonic() < end, desk.broken
            time.sleep(0.02)

    try:
        desk.start()
        until(lambda: ask(do="release all")["ok"])
        until(lambda: not desk._last.memory.state.get("K_q1", True))
        assert not ask(do="put", section="q1", towards="X1")["ok"] and desk.browsers.still["simulated"] is False
        ask(do="set", route="X7-X1")
        until(lambda: west.lamp("YP_X7"))
        east.kill()
        desk.stop()
        assert west.lamp("YS_X7") and not west.lamp("YP_X7") and desk.broken == ""
        assert list(desk.ran.unwritten) == ["east"]
    finally:
        desk.stop()
        west.kill()
        east.kill()
