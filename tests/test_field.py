"""The soft PLC against real Modbus servers on the loopback: a train is driven, a server is killed in mid-scan."""

from __future__ import annotations

import time

import pytest

from interlock.app.run import BadCommand, Operator, Ready
from interlock.field.modbus import ModbusLink, _runs
from interlock.field.plc import Cycle, LinkLost
from tests.field import cycle, free_port, running, until_released, until_valid


def test_a_route_is_set_over_the_bus_and_closed_by_its_train(mine: Ready) -> None:
    with running(mine) as (plc, west, east):
        until_released(mine, plc)
        assert west.lamp("YS_X7") and not west.lamp("YP_X7")
        cycle(mine, plc, line="set X7-X1")
        for _ in range(4):
            result = cycle(mine, plc)
        assert result.valid and not result.lost
        assert west.lamp("YP_X7") and not west.lamp("YS_X7") and east.lamp("YS_X4")
        beats = set()
        for _ in range(2):
            beats.add((west.lamp("HO_west"), east.lamp("HO_east")))
            cycle(mine, plc)
        assert beats == {(False, False), (True, True)}  # our heartbeat goes out too
        west.put("CLR_ap_W", 0)
        west.put("CLR_q1", 0)
        cycle(mine, plc)
        assert west.lamp("YS_X7") and not west.lamp("YP_X7")  # the first axle closes it


def test_a_server_killed_in_mid_scan_puts_every_signal_to_stop_and_nothing_reopens(mine: Ready) -> None:
    with running(mine) as (plc, west, east):
        until_released(mine, plc)
        cycle(mine, plc, line="set X7-X1")
        for _ in range(4):
            cycle(mine, plc)
        assert west.lamp("YP_X7")
        scan = plc.scan

        def killing(inputs: dict[str, int], dt_ms: int) -> dict[str, bool]:
            east.kill()  # after it was read, before it is written
            plc.scan = scan
            return scan(inputs, dt_ms)

        plc.scan = killing
        first = cycle(mine, plc)
        assert [x.split(":")[0] for x in first.lost] == ["east"]
        second = cycle(mine, plc)
        assert not second.valid and second.outputs["YS_X7"] and not second.outputs["YP_X7"]
        assert west.lamp("YS_X7") and not west.lamp("YP_X7")  # told to the one that is left
        assert all(v for n, v in second.outputs.items() if n.startswith("YS_"))
        east.start()
        until_valid(mine, plc)
        for _ in range(5):
            assert cycle(mine, plc).outputs["YS_X7"]  # R14: it stays at stop until it is asked for again
        cycle(mine, plc, line="set X7-X1")


def test_numbers_step_with_the_sections_of_real_substations(mine: Ready) -> None:
    """A train is commanded, comes in and runs on: its number is told at each step.  One that comes from nowhere is an
    alarm, and one whose detection is lost is, too: nothing is asked for it until somebody has looked."""
    operator = Operator(mine)
    with running(mine) as (plc, west, _):
        until_released(mine, plc)
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


def test_no_connection_is_told_not_thrown(mine: Ready) -> None:
    assert mine.allocation is not None
    link = ModbusLink(mine.allocation, "west", "127.0.0.1", free_port())
    with pytest.raises(LinkLost):
        link.read()
    link.close()
    assert _runs([1, 2, 3, 5000], 2000) == [(1, 3), (5000, 1)]


def test_what_modbus_says_is_put_in_words(mine: Ready) -> None:
    from pymodbus.exceptions import ConnectionException, ModbusException, ModbusIOException

    assert mine.allocation is not None
    link = ModbusLink(mine.allocation, "west", "10.0.0.7", 502, 3)

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
