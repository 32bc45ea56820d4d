"""The soft PLC against real Modbus servers on the loopback: a train is driven, a server is killed in mid-scan."""

from __future__ import annotations

import json
import os
import queue
import random
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager

import pytest
from click.testing import CliRunner
from pymodbus.client import ModbusTcpClient

from interlock.app.presses import Presses
from interlock.app.run import BadCommand, Operator, Ready, operate, prepare, run
from interlock.cli.main import cli
from interlock.cli.run import _Typed
from interlock.field.alone import InUse, hold
from interlock.field.modbus import ModbusLink, _runs
from interlock.field.plc import Cycle, LinkLost, SoftPlc, Watch, runtime_scan
from interlock.field.polling import LAST_S, Beside, InTurn, Poll
from interlock.model.elements import Position
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from interlock.st.ast import Unit
from interlock.st.meaning import Execution, Numbers
from interlock.st.program import watch
from tests.layouts import built
from tests.substation import FROZEN, LATE, WIRE

TWO = """
substations:
  west: [ap_W, q1, q2, P1, X7, X1]
  east: []
principles: {restart_delay_s: 0.8, release_delay_s: 0.3, line_speed_kmh: 20000, braking_ms2: 50000,
             reaction_s: 0.01, output_delay_s: 0.01}
"""  # trains that stop so soon that the restart delay may be short


@pytest.fixture(scope="module")
def ready(tmp_path_factory: pytest.TempPathFactory) -> Ready:
    """mine11 with two substations, proved."""
    path = tmp_path_factory.mktemp("field") / "mine.yaml"
    with open("layouts/mine11.yaml", encoding="utf-8") as mine:
        path.write_text(mine.read() + TWO, "utf-8")
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


def test_a_route_is_set_over_the_bus_and_closed_by_its_train(ready: Ready) -> None:
    with running(ready) as (plc, west, east):
        until_released(ready, plc)
        assert west.lamp("YS_X7") and not west.lamp("YP_X7")
        cycle(ready, plc, line="set X7-X1")
        for _ in range(4):
            result = cycle(ready, plc)
        assert result.valid and not result.lost
        assert west.lamp("YP_X7") and not west.lamp("YS_X7") and east.lamp("YS_X4")
        beats = set()
        for _ in range(2):
            beats.add((west.lamp("HO_west"), east.lamp("HO_east")))
            cycle(ready, plc)
        assert beats == {(False, False), (True, True)}  # our heartbeat goes out too
        west.put("CLR_ap_W", 0)
        west.put("CLR_q1", 0)
        cycle(ready, plc)
        assert west.lamp("YS_X7") and not west.lamp("YP_X7")  # the first axle closes it


def test_a_server_killed_in_mid_scan_puts_every_signal_to_stop_and_nothing_reopens(ready: Ready) -> None:
    with running(ready) as (plc, west, east):
        until_released(ready, plc)
        cycle(ready, plc, line="set X7-X1")
        for _ in range(4):
            cycle(ready, plc)
        assert west.lamp("YP_X7")
        scan = plc.scan

        def killing(inputs: dict[str, int], dt_ms: int) -> dict[str, bool]:
            east.kill()  # after it was read, before it is written
            plc.scan = scan
            return scan(inputs, dt_ms)

        plc.scan = killing
        first = cycle(ready, plc)
        assert [x.split(":")[0] for x in first.lost] == ["east"]
        second = cycle(ready, plc)
        assert not second.valid and second.outputs["YS_X7"] and not second.outputs["YP_X7"]
        assert west.lamp("YS_X7") and not west.lamp("YP_X7")  # told to the one that is left
        assert all(v for n, v in second.outputs.items() if n.startswith("YS_"))
        east.start()
        until_valid(ready, plc)
        for _ in range(5):
            assert cycle(ready, plc).outputs["YS_X7"]  # R14: it stays at stop until it is asked for again
        cycle(ready, plc, line="set X7-X1")


def test_a_heartbeat_that_hangs_is_noticed(ready: Ready) -> None:
    """A device that answers, and whose processor hangs."""
    assert ready.allocation is not None

    class Hung:
        def __init__(self, beats: bool) -> None:
            self.beats, self.count = beats, 0

        def read(self) -> Mapping[str, int]:
            self.count += 1
            return {
                **{c.variable: 1 for c in plc.allocation.channels if c.direction == "I"},
                **{c.variable: self.count % 2 if self.beats else 1 for c in plc.allocation.heartbeats},
            }

        def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
            pass

        def close(self) -> None:
            pass

    plc = SoftPlc(runtime_scan(ready.runtime), ready.allocation, {"west": Hung(True), "east": Hung(True)})
    assert [plc.cycle({}, 100).valid for _ in range(4)] == [False, True, True, True]
    plc.links["east"].beats = False  # type: ignore[attr-defined]
    valid = [plc.cycle({}, 100).valid for _ in range(20)]
    assert valid[0] and not valid[-1] and valid.index(False) <= 11
    with pytest.raises(ValueError, match="links for"):
        SoftPlc(runtime_scan(ready.runtime), ready.allocation, {"west": Hung(True)})


def timed(ready: Ready, plc: SoftPlc) -> tuple[Cycle, float]:
    began = time.monotonic()
    return cycle(ready, plc), time.monotonic() - began


def test_a_substation_that_dies_or_answers_late_holds_nobody_up(ready: Ready) -> None:
    """Stopped in mid-flight it takes connections and never answers; late, its answers are of another cycle."""
    with running(ready, Beside()) as (plc, west, east):
        until_valid(ready, plc)
        for ill, well in (
            (lambda: os.kill(east.process.pid, signal.SIGSTOP), lambda: os.kill(east.process.pid, signal.SIGCONT)),
            (lambda: east.wire(LATE, 1), lambda: east.wire(LATE, 0)),
        ):
            ill()
            first, _ = timed(ready, plc)
            took = []
            for k in range(12):
                west.put("CLR_q1", k % 2)
                found, seconds = timed(ready, plc)
                took.append(seconds)
                assert [x.split(":")[0] for x in found.lost] == ["east"] and not found.valid
                assert found.inputs["CLR_q1"] == k % 2 and found.outputs["YS_X7"] and west.lamp("YS_X7")
            assert not first.valid and sorted(took)[6] < 0.15, took  # 0.03 of them are slept here
            well()
            until_valid(ready, plc)
        began = time.monotonic()
        east.kill()
        assert (
            list(plc._write(plc.runtime.restrictive, last=True)) == ["east"] and time.monotonic() - began < LAST_S + 1
        )
        assert west.lamp("YS_X7") and not west.lamp("YP_X7")


def test_a_heartbeat_that_freezes_while_its_substation_answers(ready: Ready) -> None:
    with running(ready, Beside()) as (plc, _, east):
        until_valid(ready, plc)
        east.wire(FROZEN, 1)
        found = [cycle(ready, plc) for _ in range(14)]
        assert found[0].valid and not found[-1].valid and [c.valid for c in found].index(False) <= 11
        assert found[-1].lost == ("east: its heartbeat does not change",)
        east.wire(FROZEN, 0)
        until_valid(ready, plc)


def test_what_comes_too_late_is_thrown_away_and_nobody_is_asked_twice_at_once() -> None:
    poll, gate, asked = Beside(limit_s=0.05), threading.Event(), [0]

    def slow() -> int:
        asked[0] += 1
        gate.wait(5)
        return asked[0]

    try:
        found = poll.ask({"slow": slow, "quick": lambda: 7})
        assert isinstance(found["slow"], LinkLost) and found["quick"] == 7
        began = time.monotonic()
        assert all(isinstance(poll.ask({"slow": slow})["slow"], LinkLost) for _ in range(20))
        assert asked == [1] and time.monotonic() - began < 0.05  # it is not waited for any more
        gate.set()
        poll._under_way["slow"].result(5)
        assert poll.ask({"slow": slow})["slow"] == 2  # not the first answer, which came too late
    finally:
        gate.set()
        poll.close()


def test_a_cycle_that_took_too_long_is_not_believed_from_end_to_end(ready: Ready) -> None:
    """The clock of the run says so; the inputs of that cycle are not valid, its signals are at stop, and stay there."""
    assert ready.allocation is not None
    at, beat, stalls = [0.0], [0], {60: 1.0, 80: 1.001}

    class Well:
        def read(self) -> Mapping[str, int]:
            return {c.variable: beat[0] if c.variable.startswith("HB") else ones(c.variable) for c in wires}

        def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
            pass

        def close(self) -> None:
            pass

    def ones(name: str) -> int:
        return int(not name.startswith("DR_"))

    wires = [c for c in ready.allocation.wires if c.direction == "I"]
    count, lines = [0], {20: "release", 40: "set X7-X1"}

    def ask(last: Cycle | None, dt_ms: int) -> Mapping[str, int]:
        count[0] += 1
        beat[0] ^= 1
        line = lines.get(count[0], "")
        return dict.fromkeys(ready.allocation.written, 0) | (operate(ready, line) if line else {})  # type: ignore[union-attr]

    def sleep(seconds: float) -> None:
        at[0] += stalls.get(count[0], 0.1)

    done = [c for c, _ in run(ready, {"west": Well(), "east": Well()}, 100, 100, ask, lambda: at[0], sleep)]
    assert done[58].outputs["YP_X7"] and done[60].valid and done[60].outputs["YP_X7"]  # a second exactly
    assert not done[80].valid
    assert done[80].lost == ("the controller's cycle: 1001 ms since the last one, more than 1000",)
    assert all(c.outputs["YS_X7"] and not c.outputs["YP_X7"] for c in done[80:]) and done[81].valid


def test_the_watch_is_the_one_of_the_mapping_program() -> None:
    numbers = Numbers()
    text: Execution[int] = Execution(Unit((watch("W"),)), numbers)
    own, rng = Watch(), random.Random(8)
    beat = 0
    for _ in range(2000):
        beat ^= rng.random() < 0.3
        numbers.dt_ms = rng.choice((50, 100, 400))
        assert own.step(beat, numbers.dt_ms) == bool(text.scan({"HB": beat})["WELL"])


def test_what_the_operator_types(ready: Ready) -> None:
    assert operate(ready, "set j1") == operate(ready, "set X1-X5")
    assert operate(ready, "cancel X1") == {"CAN_X1": 1} and operate(ready, "BLK_q1=1") == {"BLK_q1": 1}
    for line in ("set nonsense", "voyage in", "cancel X99", "CLR_q1=1", "BLK_q1=2", "hello"):
        with pytest.raises(BadCommand):
            operate(ready, line)
    operator = Operator(ready)
    for line in ("voyage nowhere", "voyage in end", "voyage"):
        with pytest.raises(BadCommand, match="voyages: in, out"):
            operator.type(line)
    operator.type("voyage in")
    operator.type("voyage in end")


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("BLK_q1=2", "BLK_q1=2: BLK_q1 is 0 or 1"),
        ("BLK_q1 = x", "BLK_q1=x: BLK_q1 is 0 or 1"),
        ("BLK_q1=", "BLK_q1=: BLK_q1 is 0 or 1"),
        ("REQ=99", "REQ=99: REQ is a number from 0 to "),
        ("REQ=" + "9" * 5000, "REQ is a number from 0 to "),
        ("BLK_qq1=1", "there is no variable BLK_qq1: did you mean BLK_q1?"),
        (
            "BLK_ap_W=1",
            "no variable BLK_ap_W: section ap_W cannot be blocked: it is an approach section, which no route",
        ),
        ("CLR_q1=1", "CLR_q1 is read from a substation: it is not set by hand"),
        ("YP_X7=1", "YP_X7 is written by the controller: it is not set by hand"),
        ("VALID=1", "VALID says whether inputs are valid: it is not set by hand"),
        ("set X1-X55", "there is no route X1-X55: did you mean X1-X5?"),
        ("cancel", "write cancel SIGNAL"),
    ],
)
def test_what_is_wrong_with_a_command_is_said(ready: Ready, line: str, said: str) -> None:
    with pytest.raises(BadCommand) as told:
        operate(ready, line)
    assert said in str(told.value)
    assert operate(ready, "BLK_q1 = 1") == {"BLK_q1": 1}


def test_where_trains_stand_is_not_known_while_inputs_are_lost(ready: Ready) -> None:
    operator = Operator(ready)
    with pytest.raises(BadCommand, match="no inputs have been read yet: whether a train stands in q1 is not known"):
        operator.type("train 12 q1")
    operator.inputs(Cycle({"VALID": 0}, {}, False, ("west: no connection",)), 100)
    with pytest.raises(
        BadCommand, match=r"inputs are lost \(west: no connection\): .* say it again when they are valid"
    ):
        operator.type("train 12 q1")
    operator.inputs(Cycle({"VALID": 1, "CLR_q1": 1}, {}, True, ()), 100)
    with pytest.raises(BadCommand, match="q1 is clear: no train stands there"):
        operator.type("train 12 q1")


def test_commands_are_for_one_cycle_and_values_stay(ready: Ready) -> None:
    operator = Operator(ready)
    operator.type("BLK_q1=1")
    operator.type("set j1")
    request = next(iter(operate(ready, "set j1")))
    quiet, heard = (Cycle({"VALID": 1}, {"YRQ": x}, True, ()) for x in (False, True))
    first, second = operator.inputs(quiet, 100), operator.inputs(heard, 100)
    assert first["BLK_q1"] == 1 and first[request] and second["BLK_q1"] == 1 and second[request] == 0
    operator.type("BLK_q1=0")
    assert operator.inputs(quiet, 100)["BLK_q1"] == 0 and not operator.held


def test_a_run_starts_with_every_section_blocked_as_the_text_does(ready: Ready) -> None:
    """What was blocked before a restart is not known: somebody may still work there."""
    assert ready.controller is not None
    text, blocked = dict[str, object](), ready.controller.symbols.sections.blocked
    typed = _Typed(ready, text.update)
    typed.begin()
    assert text == {"blocked": {str(s): str(n) for s, n in blocked.items()}} and len(blocked) > 3
    found = typed.ask(None, 100)
    assert all(found[n] for n in blocked.values())
    assert all(i.restrictive for i in ready.controller.inputs if i.name in blocked.values())
    typed.take("BLK_q1=0")
    assert [n for n in blocked.values() if not typed.ask(None, 100)[n]] == ["BLK_q1"]
    typed.take("free")
    assert not any(typed.ask(None, 100)[n] for n in blocked.values())


def test_a_button_is_pressed_and_does_not_stay(ready: Ready) -> None:
    """A release, a confirmation, a move by hand: what was forgotten acted hours later, when its conditions held."""
    assert ready.allocation is not None
    said: list[dict[str, object]] = []
    typed = _Typed(ready, said.append)
    for name in ("REL_q1", "RELALL", "TC_P1", "MN_P1", "MR_P1", "REQ", "CAN_X1"):
        assert name in ready.allocation.written
        seconds = 13 if name[0] == "M" else 2  # points turn as long as they are ordered to, where somebody works (R10)
        typed.take(f"{name}=1")
        read = [typed.ask(None, 500)[name] for _ in range(2 * seconds + 2)]
        assert read == [1] * (2 * seconds) + [0, 0], name
        assert said == [{"pressed": name, "value": 1, "for_s": float(seconds)}, {"let_go": name}]
        said.clear()
        typed.take(f"{name}=1")
        assert typed.ask(None, 60_000)[name], "a cycle reads it, however late"
        typed.take(f"{name}=0")
        assert not typed.ask(None, 100)[name] and {"let_go": name} in said
        said.clear()
    typed.take("BLK_q1=1")
    assert all(typed.ask(None, 60_000)["BLK_q1"] for _ in range(3)), "a switch"


def test_a_direction_is_pressed_until_it_is_here_and_a_crossing_is_held_closed() -> None:
    """The special manual change asks for a hold of a minute; a crossing opens by itself when nobody holds it closed."""
    layout, _, controller = built("passing_loop")
    presses = Presses(layout, controller.symbols)
    token = next(iter(controller.symbols.token.values()))
    presses.press(token.manual, 1)
    times = layout.principles.token_delay_s + 2
    assert presses.press_ms(token.manual) == 1000 * times
    assert all(presses.inputs({}, 1000) for _ in range(int(times)))
    assert not presses.inputs({}, 1000) and presses.let_go() == [token.manual]
    presses.press(token.manual, 1)
    assert presses.inputs({}, 100) and not presses.inputs({token.have: True}, 100)
    layout, _, controller = built("crossing_line")
    by_hand = controller.symbols.machines.by_hand
    presses = Presses(layout, controller.symbols)
    held = {(m in layout.machines.device, x) for (m, x), n in by_hand.items() if presses.is_switch(n)}
    assert held == {(True, Position.REVERSE)}


@pytest.mark.parametrize("valid", [True, False], ids=["refused", "inputs lost"])
def test_what_was_refused_is_not_asked_for_again(ready: Ready, valid: bool) -> None:
    """An operator who was refused has gone on to something else: a route that is set by itself later is no service."""
    operator = Operator(ready)
    request = next(iter(operate(ready, "set j1")))

    def asked(heard: bool, is_valid: bool = True) -> int:
        seen = Cycle({"VALID": int(is_valid)}, {"YRQ": heard}, is_valid, ())
        return operator.inputs(seen, 100)[request]

    operator.type("set j1")
    assert asked(False, valid), "asked for at once, so that the controller says why not"
    assert not asked(True, valid)
    assert not any(asked(False) for _ in range(200)), "20 s"
    operator.type("set j1")
    assert asked(False)


def test_numbers_step_with_the_sections_of_real_substations(ready: Ready) -> None:
    """A train is commanded, comes in and runs on: its number is told at each step.  One that comes from nowhere is an
    alarm, and one whose detection is lost is, too: nothing is asked for it until somebody has looked."""
    operator = Operator(ready)
    with running(ready) as (plc, west, _):
        until_released(ready, plc)
        last: Cycle | None = None
        told: list[str] = []

        def cycles(count: int = 4) -> None:
            nonlocal last
            for _ in range(count):
                time.sleep(0.03)
                last = plc.cycle(operator.inputs(last, 100), 100)
                told.extend(operator.news())

        cycles()
        west.put("CLR_q3", 0)
        cycles()
        assert told == [], "nobody has named a number: no train is in doubt"
        west.put("CLR_q3", 1)
        operator.type("voyage 7:W>E")
        west.put("CLR_ap_W", 0)
        cycles(30)
        assert "train 7 is in ap_W" in told and west.lamp("YP_X7"), told
        west.put("CLR_q1", 0)
        cycles(2)
        west.put("CLR_ap_W", 1)
        cycles(12)
        assert [x for x in told if x.startswith("train")] == ["train 7 is in ap_W", "train 7 is in q1"]
        assert operator.numbers.sections == {"7": ["q1"]} and not operator.numbers.alarms
        west.put("CLR_q1", 1)  # its detection is lost
        cycles()
        lost = "ALARM, train 7: it is lost: q1 became clear, and nothing beside it is occupied"
        assert told[-2:] == ["train 7 has left", lost]
        assert operator.dispatcher.held["7"].startswith("its number is in doubt")
        west.put("CLR_q1", 0)
        cycles()
        assert "ALARM, train ?q1: something stands in q1 that came from nowhere" in told
        asked = len(operator.dispatcher.journal.asked)
        cycles(10)
        assert len(operator.dispatcher.journal.asked) == asked
        for line, why in (("train 7 q9", "q9 is clear"), ("train 7 q99", "no section q99"), ("train 7", "write train")):
            with pytest.raises(BadCommand, match=why):
                operator.type(line)
        operator.type("train 7 q1")
        cycles(2)
        assert not operator.numbers.alarms and "7" not in operator.dispatcher.held
        assert operator.numbers.sections == {"7": ["q1"]}


def test_no_connection_is_told_not_thrown(ready: Ready) -> None:
    assert ready.allocation is not None
    link = ModbusLink(ready.allocation, "west", "127.0.0.1", free_port())
    with pytest.raises(LinkLost):
        link.read()
    link.close()
    assert _runs([1, 2, 3, 5000], 2000) == [(1, 3), (5000, 1)]


def test_what_modbus_says_is_put_in_words(ready: Ready) -> None:
    from pymodbus.exceptions import ConnectionException, ModbusException, ModbusIOException

    assert ready.allocation is not None
    link = ModbusLink(ready.allocation, "west", "10.0.0.7", 502, 3)

    class Client:
        connected, answer = True, object()

        def close(self) -> None:
            pass

        def read_discrete_inputs(self, *args: object, **more: object) -> object:
            if isinstance(self.answer, Exception):
                raise self.answer
            return self.answer

    class Refusal:
        exception_code = 2
        isError = staticmethod(lambda: True)

    class Short:
        bits, function_code = (True,) * 3, 2
        isError = staticmethod(lambda: False)

    link._client = client = Client()
    for answer, said in (
        (
            ModbusIOException("No response received after 0 retries, continue with next request"),
            "does not answer within",
        ),
        (ModbusIOException("Unable to decode request"), "is it Modbus TCP?"),
        (ModbusException("Unknown response 99"), "is it Modbus TCP?"),
        (ConnectionException("ModbusTcpClient 10.0.0.7:502"), "the connection to 10.0.0.7:502 was broken off"),
        (
            ConnectionResetError(104, "Connection reset by peer"),
            "no connection to 10.0.0.7:502: Connection reset by peer",
        ),
        (Refusal(), "10.0.0.7:502 refuses the discrete inputs 0 to "),
        (Refusal(), "it has not that many addresses (Modbus exception 2)"),
        (Short(), "10.0.0.7:502 answers with 3 of "),
        (None, "no answer from 10.0.0.7:502"),
    ):
        client.answer = answer
        with pytest.raises(LinkLost) as told:
            link.read()
        assert said in str(told.value) and "Modbus Error" not in str(told.value)


def test_the_command_runs_proves_and_stops(ready: Ready) -> None:
    west, east = Station(ready, "west"), Station(ready, "east")
    try:
        path = ready.proved.checked.path
        args = ["run", path, "--modbus", f"west=127.0.0.1:{west.port}", "--modbus", f"east=127.0.0.1:{east.port}"]
        twice = CliRunner().invoke(cli, [*args, "--modbus", f"west=127.0.0.1:{east.port}", "--cycles", "1"])
        assert twice.exit_code == 2 and "--modbus says twice where west is" in twice.output
        typed = "\n" * 29 + "free\nrelease\nset X7-X1\nrubbish\n"  # a line a cycle
        done = CliRunner().invoke(cli, [*args, "--cycles", "50", "--cycle", "40"], input=typed)
        assert done.exit_code == 0, done.output
        assert ready.proved.seconds > 0.0  # it says how long that took, as `prove` does
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


def test_the_end_of_a_run_names_the_substations_that_could_not_be_written(ready: Ready) -> None:
    """It said that every output that could be reached is restrictive, and not which could not."""
    west, east = Station(ready, "west"), Station(ready, "east")
    path, args = ready.proved.checked.path, [f"west=127.0.0.1:{west.port}", f"east=127.0.0.1:{east.port}"]
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


def test_a_scada_asks_for_a_route_and_the_run_says_who_did(ready: Ready) -> None:
    west, east = Station(ready, "west"), Station(ready, "east")
    port, seen = free_port(), list[int]()

    def scada() -> None:
        client = ModbusTcpClient("127.0.0.1", port=port, timeout=2, retries=0)
        until = time.monotonic() + 10
        while not client.connect() and time.monotonic() < until:
            time.sleep(0.05)
        while not client.read_input_registers(2, count=1).registers[0] and time.monotonic() < until:
            time.sleep(0.05)
        client.write_registers(0, [1, 1, 1])
        time.sleep(0.3)
        seen.extend(client.read_input_registers(3, count=2).registers)
        client.close()

    other = threading.Thread(target=scada)
    other.start()
    try:
        path = ready.proved.checked.path
        args = ["run", path, "--modbus", f"west=127.0.0.1:{west.port}", "--modbus", f"east=127.0.0.1:{east.port}"]
        more = ["--operator-modbus", str(port), "--operator-requests", "--cycles", "60", "--cycle", "40"]
        done = CliRunner().invoke(cli, [*args, *more])
        other.join(10)
        assert done.exit_code == 0 and "modbus 127.0.0.1:" in done.output and " asks: set " in done.output, done.output
        assert seen == [1, 2]
    finally:
        west.kill()
        east.kill()


def test_the_panel_works_real_substations_and_leaves_them_restrictive(ready: Ready) -> None:
    """With Modbus there is no railway to play with, and the end is restrictive."""
    assert ready.allocation is not None
    west, east = Station(ready, "west"), Station(ready, "east")
    desk = Desk(ready, {s.name: ModbusLink(ready.allocation, s.name, "127.0.0.1", s.port) for s in (west, east)}, 50)
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
