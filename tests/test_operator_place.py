"""The operator's place on Modbus: what a client on the loopback reads and asks, and who is told to have asked."""

from __future__ import annotations

import csv
import queue
import socket
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from click.testing import CliRunner
from pymodbus.client import ModbusTcpClient

import interlock
from interlock.app.alarms import HAZARD, RECORD, TRAIN, Watch, listed, possible
from interlock.app.run import Ready, prepare
from interlock.cli.main import cli
from interlock.cli.run import _Typed
from interlock.field.operator_place import (
    FIRST,
    FIRST_ONE,
    INCOMPLETE,
    NOT_COUNTED,
    NOT_KNOWN,
    REFUSED,
    TAKEN,
    WAITING,
    Ask,
    OperatorPlace,
    Registers,
    Reply,
    registers,
)
from interlock.field.plc import LATE_CYCLE, Cycle, Memory
from interlock.logic.cabinet import allocate
from interlock.logic.controller import Controller
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from tests.layouts import SHIPPED, built
from tests.test_diff import BASE

WORDS = {1: 1, 2: 3, 3: 10_001, 4: 2}
"""What is said of the four routes."""


def free_port() -> int:
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        port: int = s.getsockname()[1]
        return port


@contextmanager
def served(ask: Ask | None = None, clock: list[float] | None = None) -> Iterator[tuple[OperatorPlace, ModbusTcpClient]]:
    """The registers of fig2_2, and a client of them."""
    now = time.monotonic if clock is None else lambda: clock[0]
    place = OperatorPlace(place_of(*built("fig2_2")[::2]), "127.0.0.1", free_port(), ask, now)
    place.start()
    client = ModbusTcpClient("127.0.0.1", port=place.place[1], timeout=2, retries=0)
    try:
        assert client.connect()
        yield place, client
    finally:
        client.close()
        place.stop()


def place_of(layout: Layout, controller: Controller) -> Registers:
    """The registers, alarms among them."""
    return registers(controller, listed(possible(layout, controller, allocate(layout, controller))))


def said(valid: bool = True) -> Cycle:
    return Cycle({}, {"YP_X2": True}, valid, (), words=lambda: WORDS)


def words_of(client: ModbusTcpClient) -> list[int]:
    return list(client.read_input_registers(FIRST, count=4).registers)


def head_of(client: ModbusTcpClient) -> dict[str, int]:
    read = client.read_input_registers(0, count=6).registers
    return dict(zip(("form", "cycle", "valid", "seen", "answer", "may ask"), read, strict=True))


def test_a_client_reads_words_outputs_and_whether_the_controller_lives() -> None:
    clock = [0.0]
    with served(clock=clock) as (place, client):
        assert words_of(client) == [0, 0, 0, 0] and head_of(client)["valid"] == 0  # before the first scan
        place.publish(said(), ())
        assert words_of(client) == [1, 3, 10_001, 2]
        assert head_of(client) == {"form": 2, "cycle": 1, "valid": 1, "seen": 0, "answer": 0, "may ask": 0}
        bits = client.read_discrete_inputs(0, count=len(place.registers.bits)).bits
        lit = [name for (name, _), bit in zip(place.registers.bits, bits, strict=False) if bit]
        assert lit == ["YP_X2"]
        clock[0] = 2.1  # no scan for two seconds: what was said of routes is not so any more
        assert words_of(client) == [0, 0, 0, 0] and head_of(client)["valid"] == 0
        assert not any(client.read_discrete_inputs(0, count=16).bits)
        place.publish(said(), ())
        place.publish(None, ())  # no power
        assert words_of(client) == [0, 0, 0, 0] and head_of(client)["cycle"] == 2


def test_nothing_can_be_written_unless_it_is_allowed() -> None:
    with served() as (place, client):
        place.publish(said(), ())
        for answer in (
            client.write_registers(0, [1, 1, 1]),
            client.write_register(0, 1),
            client.write_coil(0, True),
            client.write_coils(0, [True]),
            client.mask_write_register(address=0, and_mask=0, or_mask=1),
            client.readwrite_registers(read_address=0, read_count=1, write_address=0, values=[1]),
        ):
            assert answer.isError()
        assert client.read_holding_registers(0, count=3).registers == [0, 0, 0]


def test_a_request_is_told_once_with_who_asks_and_answered() -> None:
    told: queue.SimpleQueue[tuple[str, str, str]] = queue.SimpleQueue()

    def ask(who: str, what: str, name: str, reply: object) -> None:
        told.put((who, what, name))
        assert callable(reply)
        reply(name != "X1-B")

    with served(ask) as (place, client):
        mine = f"modbus 127.0.0.1:{client.socket.getsockname()[1]}"
        assert not client.write_registers(0, [7, 1, 3]).isError()
        assert head_of(client)["answer"] == FIRST_ONE and told.empty()  # it may be one from before the start
        assert not client.write_registers(0, [6, 1, 3]).isError()
        assert head_of(client)["answer"] == REFUSED and told.empty()  # no valid scan yet
        client.write_registers(0, [7, 1, 3])
        place.publish(said(), ())
        client.write_registers(0, [7, 1, 3])  # the same number again is no new request
        assert told.empty()
        client.write_registers(0, [8, 1, 3])
        assert told.get(timeout=2) == (mine, "set", "X2-C")
        assert (head_of(client)["seen"], head_of(client)["answer"]) == (8, TAKEN)
        client.write_registers(1, [2, 1])
        assert told.empty()  # the number stands as it was
        client.write_register(0, 9)
        assert told.get(timeout=2) == (mine, "cancel", "X1")
        client.write_registers(0, [10, 1, 2])
        assert told.get(timeout=2)[1:] == ("set", "X1-B") and head_of(client)["answer"] == REFUSED
        for wrong in ([11, 1, 99], [12, 9, 1], [13, 0, 0]):
            client.write_registers(0, wrong)
            assert head_of(client)["answer"] == NOT_KNOWN
        assert told.empty() and client.write_coil(0, True).isError()
        assert client.mask_write_register(address=0, and_mask=0, or_mask=99).isError()
        place.publish(said(valid=False), ())
        client.write_registers(0, [14, 1, 3])
        assert head_of(client)["answer"] == REFUSED and told.empty()
        client.write_registers(0, [15, 2, 1])
        assert told.get(timeout=2)[1:] == ("cancel", "X1"), "to cancel does no harm whatever is known"


def test_what_was_asked_for_before_is_never_carried_out_again() -> None:
    """Whoever writes the registers one by one, the number first, would ask for what he wanted the time before."""
    told: list[tuple[str, str]] = []
    replies: list[Reply] = []

    def ask(who: str, what: str, name: str, reply: Reply) -> None:
        told.append((what, name))
        replies.append(reply)

    clock = [0.0]
    with served(ask, clock) as (place, client):
        place.publish(said(), ())
        client.write_registers(0, [6, 1, 1])

        def one_by_one(*registers: tuple[int, int]) -> int:
            for address, value in registers:
                assert not client.write_register(address, value).isError()
            return head_of(client)["answer"]

        client.write_registers(0, [7, 1, 1])
        assert told == [("set", "X1-A")] and client.read_holding_registers(0, count=3).registers == [7, 0, 0]
        replies.pop()(True)
        for number in (8, 9, 10):
            assert one_by_one((0, number), (1, 2), (2, 1)) == INCOMPLETE
        assert len(told) == 1
        client.write_registers(0, [11, 1, 3])
        assert one_by_one((1, 2), (2, 1), (0, 12)) == WAITING
        assert one_by_one((0, 13)) == INCOMPLETE, "both are cleared"
        assert one_by_one((1, 2), (2, 1), (0, 14)) == INCOMPLETE, "it may be the number of one who writes it first"
        assert one_by_one((0, 0), (1, 2), (2, 1), (0, 15)) == WAITING, "who writes 0 begins anew"
        client.write_registers(0, [15, 1, 3])
        assert one_by_one((0, 16)) == INCOMPLETE, "a request that is written again is none for the next number"
        assert told[1:] == [("set", "X2-C"), ("cancel", "X1"), ("cancel", "X1")]
        one_by_one((0, 0), (1, 2), (2, 1))
        clock[0] = 11.0
        place.publish(said(), ())
        assert one_by_one((0, 17)) == INCOMPLETE and len(told) == 4, "left there by one who did not go on"


@pytest.fixture(scope="module")
def ready() -> Ready:
    return prepare("layouts/fig2_2.yaml")


def test_at_the_panel_a_request_goes_through_its_queue_and_is_noted(ready: Ready) -> None:
    assert ready.layout is not None and ready.controller is not None
    desk = Desk(ready)

    def ask(who: str, what: str, name: str, reply: object) -> None:
        assert callable(reply)
        desk.ask(Person(who, True), {"do": what, "signal": name}, lambda answer: reply(answer["ok"]))

    place = OperatorPlace(place_of(ready.layout, ready.controller), "127.0.0.1", free_port(), ask)
    desk.publish = place.publish
    place.start()
    desk.start()
    client = ModbusTcpClient("127.0.0.1", port=place.place[1], timeout=2, retries=0)
    try:
        assert client.connect()
        until = time.monotonic() + 10
        while not head_of(client)["valid"] and time.monotonic() < until:
            time.sleep(0.05)
        client.write_registers(0, [1, 2, 1])  # cancel at X1, from which no route is set
        while head_of(client)["answer"] == 1 and time.monotonic() < until:
            time.sleep(0.05)
        assert head_of(client)["answer"] == REFUSED
        time.sleep(0.3)
        (noted,) = [e for e in desk.browsers.events if e.kind == "refusal"]
        assert noted.who.startswith("modbus 127.0.0.1:") and "no route from X1 is set" in noted.text
    finally:
        client.close()
        place.stop()
        desk.stop()


OF_THE_DESK = {HAZARD, RECORD, TRAIN}
"""Alarms that no scan tells: of the simulated railway, of the panel's record, of numbers of trains."""


@pytest.mark.parametrize("name", ["flank_lab", "pit_bottom", "depot", "heishan"])
def test_whatever_can_be_wrong_after_a_scan_is_listed_and_nothing_else(name: str) -> None:
    """All goes wrong at once: what then stands is the list of what can."""
    layout, _, controller = built(name)
    cabinets = allocate(layout, controller)
    watch = Watch(layout, controller, cabinets)
    opened = {r.proceed: True for r in controller.symbols.routes}
    watch.after(Cycle({}, {}, True, (), Memory(opened, {})), 2000)
    state = {str(n): True for s in controller.state for n in [s.name]} | dict.fromkeys(opened, False)
    state |= dict.fromkeys((*controller.symbols.machines.command.values(),), False)
    state |= dict.fromkeys(controller.symbols.cancellation.cancelling.values(), False)
    outputs = {str(o.name): True for o in controller.outputs}
    lost = (f"{LATE_CYCLE}: 1200 ms since the last one", *(f"{s}: does not answer" for s in cabinets.stations))
    both = {str(n): 1 for (m, _), n in controller.symbols.machines.detected.items() if m in layout.machines.device}
    for _ in range(2):  # a crossing that is reported closed, and open as well
        closed = watch.after(Cycle(both, outputs, True, lost, Memory(state, {})), 600_000)
    assert not closed  # told once, and standing since
    found = {**watch.causes, **watch.past}
    assert set(found) == {p.key for p in watch.possible} - OF_THE_DESK
    watch.after(Cycle({}, {}, True, (), Memory(opened, {})), 100)
    assert not watch.past  # its signals are open again, and no section is locked since the restart


@pytest.mark.parametrize("name", SHIPPED)
def test_every_alarm_has_a_bit_behind_all_that_was_there_before(name: str) -> None:
    layout, _, controller = built(name)
    place = place_of(layout, controller)
    rows = [r for r in place.table() if r[0] == "discrete input"]
    names = [r[2] for r in rows]
    assert names[: len(controller.outputs)] == [o.name for o in controller.outputs] and len({*names}) == len(names)
    alarms = possible(layout, controller, allocate(layout, controller))
    assert rows[len(controller.outputs) :] == [
        ("discrete input", str(k), p.variable, f"alarm: {p.text}")
        for k, p in enumerate(alarms, len(controller.outputs))
    ]
    assert len({p.key for p in alarms}) == len(alarms) and {p.key for p in alarms} >= OF_THE_DESK


def test_an_alarm_lights_its_bit_alone_and_is_counted() -> None:
    clock = [0.0]
    with served(clock=clock) as (place, client):

        def lit() -> list[str]:
            count = len(place.registers.bits) + len(place.registers.alarms)
            bits = client.read_discrete_inputs(0, count=count).bits[len(place.registers.bits) : count]
            return [key for (key, _, _), bit in zip(place.registers.alarms, bits, strict=True) if bit]

        def counted() -> list[int]:
            return list(client.read_input_registers(6, count=2).registers)

        assert counted() == [NOT_COUNTED, 0]
        keys = [key for key, _, _ in place.registers.alarms]
        for k, key in enumerate(keys, 1):
            place.publish(said(), (key,))
            assert (lit(), counted()) == ([key], [1, k])
        place.publish(said(), ("train 12", "train 14", "of a kind that nobody has listed"))
        assert lit() == ["train"] and counted() == [3, len(keys) + 3]
        place.publish(said(), ())
        assert lit() == [] and counted() == [0, len(keys) + 3]
        clock[0] = 2.1
        assert counted() == [NOT_COUNTED, len(keys) + 3]
        place.publish(None, ())
        assert counted() == [NOT_COUNTED, len(keys) + 3]


def test_a_table_is_told_from_that_of_another_layout() -> None:
    with served() as (place, client):
        read = tuple(client.read_input_registers(8, count=2).registers)
        assert read == place.registers.digest
        told = {r[2]: r[3] for r in place.registers.table()}
        assert [told[n].partition(":")[0] for n in ("TABLE_HIGH", "TABLE_LOW")] == [f"always {x}" for x in read]
    assert len({place_of(*built(n)[::2]).digest for n in ("fig2_1", "fig2_2", "mine11")}) == 3


def test_a_code_that_says_something_else_is_told_from_before(tmp_path: Path) -> None:
    """A screen that shows its own copy of the sentences would give a wrong reason for a refusal."""
    hostile = "hostile: [{one: {from: LS}, other: {from: N2}, reason: the platform is narrow}]\nsignals:"
    found = []
    for name, text in (("old", BASE), ("new", BASE.replace("signals:", hostile))):
        (tmp_path / f"{name}.yaml").write_text(text, "utf-8")
        layout = interlock.load(str(tmp_path / f"{name}.yaml"))
        found.append(place_of(layout, interlock.lower(layout, interlock.derive(layout))))
    old, new = found
    assert [row[:3] for row in old.table()[10:]] == [row[:3] for row in new.table()[10:]]
    assert [c for c in old.codes if new.codes[c] != old.codes[c]] and old.digest != new.digest


def test_without_a_panel_alarms_are_said_and_reach_the_registers(ready: Ready) -> None:
    """Points that nobody has commanded lose their detection: said once, and once more when that is over."""
    told: list[dict[str, object]] = []
    typed = _Typed(ready, told.append)
    assert ready.controller is not None
    lies = {str(n): 1 for (_, x), n in ready.controller.symbols.machines.detected.items() if x is Position.NORMAL}
    (first, *_) = ready.controller.symbols.machines.detected.items()
    lost = {**lies, str(first[1]): 0}
    for inputs, dt_ms in ((lies, 2000), (lost, 1000), (lost, 60_000), (lost, 100)):
        typed.ask(None, dt_ms)
        stand = list(typed.after(Cycle(inputs, {}, True, ())))
    key, text = f"idle {first[0][0]}", f"points {first[0][0]} are not detected, and were not commanded"
    assert stand == [key] and told == [{"alarm": text, "stands": True}]
    typed.ask(None, 100)
    assert list(typed.after(Cycle(lies, {}, True, ()))) == [] and told[1:] == [{"alarm": text, "stands": False}]


def test_a_road_that_waits_for_minutes_is_an_alarm() -> None:
    """However long a train stays within its route, the crossing stays closed; nobody was told that a road waits."""
    layout, _, controller = built("crossing_line")
    m = next(iter(layout.machines.device))
    watch = Watch(layout, controller, allocate(layout, controller))
    closed = {str(controller.symbols.machines.detected[m, Position.REVERSE]): 1}

    def stands(minutes: float, inputs: dict[str, int], valid: bool = True, **state: bool) -> bool:
        watch.after(Cycle(inputs, {}, valid, (), Memory(state, {})), round(minutes * 60_000))
        return f"closed {m}" in watch.causes

    assert not stands(9, {}) and not stands(9, {}), "open"
    assert not stands(1, closed) and not stands(4.9, closed) and stands(0.2, closed)
    assert watch.causes[f"closed {m}"] == (
        f"level crossing {m} has been closed to its road for more than 5 minutes",
        (f"m:{m}",),
    )
    assert not stands(0.1, {}), "the road is free"
    command = {str(controller.symbols.machines.command[m, Position.REVERSE]): True}
    assert not stands(1, {}, **command) and not stands(4, {}, valid=False), "time runs on while inputs are lost"
    assert stands(1.1, {}, **command), "commanded closed, whatever is reported: a road with a red light waits as well"
    assert not stands(9, {}) and not stands(9, {}, valid=False)


def test_a_port_that_is_taken_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with served() as (place, _):
        second = OperatorPlace(place.registers, *place.place)
        with pytest.raises(OSError, match="Address already in use"):
            second.start()
        second.stop()
        more = ["--panel", "--port", "0", "--operator-modbus", str(place.place[1])]
        layout = Path("layouts/fig2_2.yaml").resolve()
        monkeypatch.chdir(tmp_path)
        done = CliRunner().invoke(cli, ["run", str(layout), *more])
        assert done.exit_code == 2 and "Address already in use" in done.output
        assert not list(tmp_path.iterdir()), "a run that cannot begin leaves no record"


def test_the_table_of_registers_is_written(tmp_path: Path) -> None:
    file = tmp_path / "fig2_2.csv"
    done = CliRunner().invoke(cli, ["export", "layouts/fig2_2.yaml", "--registers", "-o", str(file)])
    assert done.exit_code == 0, done.output
    *rows, mark = list(csv.DictReader(file.open(encoding="utf-8")))
    assert mark["Kind"] == "note" and mark["Meaning"].startswith("written by interlock, sha256 ")
    assert CliRunner().invoke(cli, ["export", "layouts/fig2_2.yaml", "--registers", "-o", str(file)]).exit_code == 0
    file.write_text(file.read_text("utf-8").replace("YX_R1", "YX_R9"), "utf-8")
    assert CliRunner().invoke(cli, ["export", "layouts/fig2_2.yaml", "--registers", "-o", str(file)]).exit_code == 1
    at = {(r["Kind"], r["Name"]): r["Address"] for r in rows}
    assert at["input register", "YX_R1"] == str(FIRST) and at["holding register", "REQUEST"] == "0"
    assert at["request", "set X2-C"] == "1 3" and ("discrete input", "YP_X2") in at
    assert len({(r["Kind"], r["Address"]) for r in rows}) == len(rows)
    wrong = CliRunner().invoke(cli, ["export", "layouts/fig2_2.yaml", "--registers", "-o", str(tmp_path / "x.aig")])
    assert wrong.exit_code == 2


@pytest.mark.parametrize("more", [["--operator-requests"], ["--operator-modbus", "x"], ["--operator-modbus", "h:0"]])
def test_a_place_that_cannot_be_is_told(more: list[str]) -> None:
    done = CliRunner().invoke(cli, ["run", "layouts/fig2_2.yaml", "--panel", *more])
    assert done.exit_code == 2 and "--operator-modbus [HOST:]PORT" in done.output
