"""Links that fail in ways that nobody has foreseen: whatever one substation does, every other one is written."""

from __future__ import annotations

import signal
import socket
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing, contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from pymodbus.exceptions import ModbusIOException
from pymodbus.pdu import ExceptionResponse, ModbusPDU
from pymodbus.pdu.bit_message import WriteMultipleCoilsResponse

from interlock.app.alarms import CYCLE, LOST, Watch, possible
from interlock.app.run import Ready, run
from interlock.cli.common import end_as_by_ctrl_c
from interlock.cli.main import cli
from interlock.field import polling
from interlock.field.modbus import ModbusLink
from interlock.field.plc import LATE_CYCLE, LinkLost, SoftPlc, runtime_scan
from interlock.field.polling import Beside, InTurn, Poll
from interlock.frontend.scalars import NAME
from tests.panels import unproved

STATION = """
interlock: 1
name: two
boundaries: {W: {approach: ap 600}, E: {trains: out}}
tracks: {t: [W, q1 200, q2 300, E]}
signals: {A: {from: W, into: q1}, B: {from: q1, into: q2}}
"""
SAID = "0 <= address 72000 <= 65535 !"


@pytest.fixture(scope="module")
def two() -> Ready:
    """A station with the substations `bad` and `good`."""
    return unproved(STATION + "substations: {bad: [q1], good: []}\n")


class Wire:
    """A substation that is well, until `breaks` does something else in its place."""

    def __init__(self, ready: Ready, name: str, breaks: Callable[[str, int], None] = lambda what, k: None) -> None:
        assert ready.allocation is not None
        self.breaks, self.reads, self.writes, self.closed = breaks, 0, 0, False
        self.inputs = [c.variable for c in ready.allocation.wires if c.direction == "I" and c.substation == name]
        self.lit: dict[str, bool] = {}

    def read(self) -> Mapping[str, int]:
        self.reads += 1
        self.breaks("read", self.reads)
        return {n: self.reads & 1 if n.startswith("HB") else 1 for n in self.inputs}

    def write(self, values: Mapping[str, bool], heartbeat: bool) -> None:
        self.writes += 1
        self.breaks("write", self.writes)
        self.lit = dict(values)

    def close(self) -> None:
        self.breaks("close", 1)
        self.closed = True


def in_the_third(what: str, k: int) -> None:
    if (what, k) == ("read", 3):
        raise ValueError(SAID)


@pytest.mark.parametrize("poll", [Beside, InTurn])
def test_an_unforeseen_exception_of_one_substation_is_a_lost_one(two: Ready, poll: Callable[[], Poll]) -> None:
    links = {"bad": Wire(two, "bad", in_the_third), "good": Wire(two, "good")}
    with closing(run(two, links, 10, 4, lambda last, dt_ms: {}, poll=poll())) as cycles:
        done = [c for c, _ in cycles]
    assert [c.valid for c in done][1:3] == [True, False]
    assert done[2].lost == (f"bad: it cannot be asked: ValueError: {SAID}",)
    assert links["good"].writes == 5 and links["good"].closed, "four cycles, and restrictive in the end"


@pytest.mark.parametrize("poll", [Beside, InTurn])
@pytest.mark.parametrize("what", ["write", "close"])
def test_the_last_write_reaches_every_station(two: Ready, poll: Callable[[], Poll], what: str) -> None:
    """Whatever another one does while the run ends, and in the scan before it."""
    assert two.allocation is not None

    def always(done: str, k: int) -> None:
        if done == what:
            raise RuntimeError("a defect")

    links = {"bad": Wire(two, "bad", always), "good": Wire(two, "good")}
    plc = SoftPlc(runtime_scan(two.runtime), two.allocation, links, poll=poll())
    for _ in range(3):
        plc.cycle({}, 100)
    unwritten = plc.close()
    assert unwritten == ({"bad": "it cannot be asked: RuntimeError: a defect"} if what == "write" else {})
    assert links["good"].writes == 4 and links["good"].closed
    assert links["good"].lit == {n: v for n, v in plc.runtime.restrictive.items() if n in links["good"].lit}


def test_the_last_write_reaches_the_others_where_there_are_no_more_threads(
    two: Ready, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert two.allocation is not None
    links = {"bad": Wire(two, "bad"), "good": Wire(two, "good")}
    plc = SoftPlc(runtime_scan(two.runtime), two.allocation, links, poll=Beside())
    start = threading.Thread.start

    def refused(thread: threading.Thread) -> None:
        if thread.name == "substation bad":
            raise RuntimeError("can't start new thread")
        start(thread)

    monkeypatch.setattr(threading.Thread, "start", refused)
    assert plc.cycle({}, 100).lost[0] == "bad: it cannot be asked: RuntimeError: can't start new thread"
    assert list(plc.close()) == ["bad"] and links["good"].writes == 2


def test_what_hangs_is_left_behind(two: Ready, monkeypatch: pytest.MonkeyPatch) -> None:
    """A name that is looked up has no limit of its own; nothing is begun that waits behind it."""
    monkeypatch.setattr(polling, "LAST_S", 0.2)
    monkeypatch.setattr(polling, "CLOSE_S", 0.2)
    assert two.allocation is not None
    gate = threading.Event()

    def hangs(what: str, k: int) -> None:
        if what != "close":
            gate.wait(20)

    links = {"bad": Wire(two, "bad", hangs), "good": Wire(two, "good")}
    plc = SoftPlc(runtime_scan(two.runtime), two.allocation, links, poll=Beside())
    plc.cycle({}, 100)
    before = {t for t in threading.enumerate() if t.name == "substation bad"}
    began = time.monotonic()
    try:
        assert list(plc.close()) == ["bad"] and time.monotonic() - began < 5
        assert links["good"].writes == 2 and links["bad"].closed
        assert all(t.daemon for t in before), "nor does the process wait for it"
    finally:
        gate.set()
    for t in before:
        t.join(5)
    assert links["bad"].writes == 0


def test_what_the_library_does_not_take_is_told_not_thrown() -> None:
    """Its client checks what it is told, with exceptions of any kind."""
    ready = unproved(STATION)
    assert ready.allocation is not None
    link = ModbusLink(ready.allocation, "main", "10.0.0.7", 502)

    class Client:
        connected = True

        def read_discrete_inputs(self, *args: object, **more: object) -> object:
            raise ValueError(SAID)

        def close(self) -> None:
            raise RuntimeError("closed already")

    link._client = Client()
    with pytest.raises(LinkLost, match=r"10\.0\.0\.7:502 cannot be asked: ValueError: 0 <= address 72000"):
        link.read()


class Coils:
    """A client whose substation has cards that do not take their coils, or do not answer."""

    connected = True

    def __init__(self) -> None:
        self.held: dict[int, bool] = {}
        self.refused: set[int] = set()
        self.silent: set[int] = set()

    def write_coils(self, first: int, bits: list[bool], device_id: int) -> ModbusPDU:
        places = range(first, first + len(bits))
        if self.silent.intersection(places):
            raise ModbusIOException("No response received after 0 retries, continue with next request")
        if self.refused.intersection(places):
            return ExceptionResponse(15, 4)
        self.held |= zip(places, bits, strict=True)
        return WriteMultipleCoilsResponse(address=first, count=len(bits))

    def close(self) -> None:
        pass


def test_our_heartbeat_follows_only_when_every_output_was_taken() -> None:
    """Wherever it lies: a substation whose outputs are old lets go of them when it stands still."""
    ready = unproved(STATION + "addresses: {HO_main: Q0.0, YP_A: Q5.0, YS_A: Q5.1, YP_B: Q9.0, YS_B: Q9.1}\n")
    assert ready.allocation is not None
    link = ModbusLink(ready.allocation, "main", "10.0.0.7", 502)
    link._client = client = Coils()
    outputs = {c.variable: 8 * c.byte + c.bit for c in ready.allocation.channels if c.direction == "Q"}
    link.write(dict.fromkeys(outputs, True), heartbeat=True)
    assert client.held == dict.fromkeys([0, *outputs.values()], True)

    client.refused = {40}
    with pytest.raises(LinkLost, match="refuses the coils 40 to 41: it has failed inside"):
        link.write(dict.fromkeys(outputs, False), heartbeat=False)
    assert client.held[0] and client.held[40], "it still holds an old output, and no heartbeat says that all is well"
    assert not client.held[72], "what lies on another card is written all the same"

    client.refused, client.silent = set(), {72}
    with pytest.raises(LinkLost, match="does not answer"):
        link.write(dict.fromkeys(outputs, False), heartbeat=False)
    assert client.held[0]

    client.silent = set()
    link.write(dict.fromkeys(outputs, False), heartbeat=False)
    assert client.held == dict.fromkeys([0, *outputs.values()], False)


def test_the_last_write_leaves_the_heartbeat_where_it_is_when_an_output_is_refused() -> None:
    ready = unproved(STATION + "health: {main: {by: diagnosis}}\naddresses: {HO_main: Q0.0, YP_A: Q5.0, YS_A: Q5.1}\n")
    assert ready.allocation is not None
    link = ModbusLink(ready.allocation, "main", "10.0.0.7", 502)
    link._client = client = Coils()
    plc = SoftPlc(runtime_scan(ready.runtime), ready.allocation, {"main": link})
    plc.cycle({}, 100)
    before = client.held[0]
    client.refused = {40}
    plc.cycle({}, 100)
    assert list(plc.close()) == ["main"]
    assert client.held[0] == before


@pytest.mark.parametrize("health", ["heartbeat", "diagnosis", "both"])
@pytest.mark.parametrize("poll", [Beside, InTurn])
def test_a_substation_that_was_not_written_is_lost_in_the_next_cycle(health: str, poll: Callable[[], Poll]) -> None:
    """Also where no heartbeat has to come back: in every second cycle its inputs were valid."""
    ready = unproved(STATION + f"health: {{main: {{by: {health}}}}}\n")

    def refuses(what: str, k: int) -> None:
        if what == "write" and 4 <= k < 8:
            raise LinkLost("refuses the coils")

    link = Wire(ready, "main", refuses)
    with closing(run(ready, {"main": link}, 10, 14, lambda last, dt_ms: {}, poll=poll())) as cycles:
        done = [c for c, _ in cycles]
    broken = [k for k, c in enumerate(done) if "main: refuses the coils" in c.lost]
    assert broken == list(range(broken[0], broken[-1] + 1)) and len(broken) > 4
    assert not any(c.valid for c in done[broken[0] + 1 : broken[-1] + 1])
    assert done[-1].valid, "it is well again"


@contextmanager
def answering(answer: Callable[[bytes], bytes]) -> Iterator[int]:
    """A server on the loopback that answers each request as it is told; its port.  One connection, then it ends."""

    def serve() -> None:
        with suppress(OSError):
            held, _ = server.accept()
            held.settimeout(5)
            with held:
                while len(head := held.recv(7)) == 7:
                    said = answer(held.recv(int.from_bytes(head[4:6], "big") - 1))
                    held.sendall(head[:4] + (len(said) + 1).to_bytes(2, "big") + head[6:] + said)

    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(5)
        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        yield server.getsockname()[1]
    thread.join(10)
    assert not thread.is_alive()


@pytest.mark.parametrize(
    ("what", "said", "well"),
    [
        ("read", b"\x02\x01\xff", True),
        ("read", b"\x01\x01\xff", False),  # coils
        ("read", b"\x03\x02\xff\xff", False),  # registers
        ("read", b"\x0f\x00\x00\x00\x07", False),
        ("read", b"\x02\x02\xff", False),  # fewer bytes than are told
        ("read", b"\x02\x01\xff\xff", False),  # more
        ("read", b"\x02\x00\xff", False),
        ("read", b"\x02", False),
        ("read", b"\x02\x02\xff\xff", False),  # more than was asked for
        ("read", b"\x02\xfa" + b"\xff" * 250, False),
        ("write", b"\x0f\x00\x00\x00\x06", True),
        ("write", b"\x0f\x00\x01\x00\x06", False),  # elsewhere
        ("write", b"\x0f\x00\x00\x00\x05", False),  # not all of them
        ("write", b"\x0f\x00\x00\x00\x06\x00", False),
        ("write", b"\x10\x00\x00\x00\x06", False),
        ("write", b"\x02\x01\xff", False),
    ],
)
def test_an_answer_that_does_not_fit_its_question_is_none(what: str, said: bytes, well: bool) -> None:
    ready = unproved(STATION + "addresses: {HO_main: Q1.0}\n")
    assert ready.allocation is not None
    outputs = {c.variable for c in ready.allocation.channels if c.direction == "Q"}
    beat = b"\x0f\x00\x08\x00\x01"
    with answering(lambda asked: beat if asked.startswith(b"\x0f\x00\x08") else said) as port:
        link = ModbusLink(ready.allocation, "main", "127.0.0.1", port)
        ask = link.read if what == "read" else partial(link.write, dict.fromkeys(outputs, False), False)
        try:
            if well:
                ask()
            else:
                with pytest.raises(LinkLost, match=r"answers something else than what was asked|answers with 0 of"):
                    ask()
        finally:
            link.close()


PINNED = """
pins: 1
layout: two
cards: {main: {1: I9000, 2: Q0}}
channels:
  main:
    q1:
      CLR_q1: I9000.0
"""


@pytest.mark.parametrize(
    ("more", "pins", "said"),
    [
        (
            "addresses: {CLR_q1: I8192.0}\n",
            "",
            "two.yaml:7: `addresses: {CLR_q1: I8192.0}`: Modbus numbers the bits of",
        ),
        (
            "addresses:\n  CLR_q2: I1.0\n  YS_A: Q9999.7\n  YP_A: Q9999.6\n",
            "",
            "two.yaml:9: `addresses: {YS_A: Q9999.7}`",
        ),
        ("", PINNED, "two.pins:3: `cards`, slot 1 of main, for HB_main (and 3 more): "),
        (
            "",
            PINNED + "    main: {HB_main: I9000.1}\n",
            "two.pins:8: `channels`, main, `HB_main: I9000.1` (and 3",
        ),
        ("addresses: {CLR_q1: I8191.7}\n", "", ""),
    ],
)
def test_an_address_that_modbus_does_not_reach_is_refused_before_the_proof(
    more: str, pins: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "two.yaml"
    path.write_text(STATION.lstrip() + "# where things lie\n" + more, "utf-8")
    if pins:
        path.with_suffix(".pins").write_text(pins.lstrip(), "utf-8")
    monkeypatch.setattr("interlock.app.run.prove_derived", _proving)
    done = CliRunner().invoke(cli, ["run", str(path), "--modbus", "127.0.0.1:1"])
    if not said:
        assert isinstance(done.exception, Proving)
        return
    told = " ".join(done.output.replace("│", " ").split())
    assert done.exit_code == 2 and said in told and "give " in told, done.output


class Proving(Exception):
    """It is being proved."""


def _proving(*args: object) -> None:
    raise Proving


def test_a_substation_may_be_called_what_a_late_cycle_is() -> None:
    """Both are told, and both are alarms."""
    ready = unproved(STATION + "substations: {cycle: [q1], good: []}\n")
    assert ready.allocation is not None and ready.layout is not None and ready.controller is not None

    def cut(what: str, k: int) -> None:
        raise LinkLost("no connection")

    links = {"cycle": Wire(ready, "cycle", cut), "good": Wire(ready, "good")}
    plc = SoftPlc(runtime_scan(ready.runtime), ready.allocation, links)
    plc.cycle({}, 100)
    late = plc.cycle({}, 2000)
    assert sorted(late.lost) == ["cycle: no connection", f"{LATE_CYCLE}: 2000 ms since the last one, more than 1000"]
    assert NAME.fullmatch(LATE_CYCLE) is None
    watch = Watch(ready.layout, ready.controller, ready.allocation)
    watch.after(late, 2000)
    told = {key: text for key, (text, _) in watch.causes.items() if key in (CYCLE, f"{LOST} cycle")}
    assert told == {
        "cycle": f"{LATE_CYCLE}: 2000 ms since the last one, more than 1000",
        "lost cycle": "substation cycle: no connection",
    }
    keys = [p.key for p in possible(ready.layout, ready.controller, ready.allocation)]
    assert len(keys) == len(set(keys)) and set(told) <= set(keys)


@pytest.mark.parametrize("windows", [False, True])
def test_a_run_ends_where_there_is_no_sighup(windows: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """As on Windows."""
    kept: dict[int, Any] = {}
    monkeypatch.setattr(signal, "signal", kept.__setitem__)
    expected = {signal.SIGTERM} if windows else {signal.SIGTERM, signal.SIGHUP}
    if windows:
        monkeypatch.delattr(signal, "SIGHUP")
    end_as_by_ctrl_c()
    assert set(kept) == expected
    with pytest.raises(KeyboardInterrupt):
        kept[signal.SIGTERM](signal.SIGTERM, None)
