"""What the soft PLC does not believe: a heartbeat that stands still, an answer or a cycle that comes too late."""

from __future__ import annotations

import os
import random
import signal
import threading
import time
from collections.abc import Mapping

import pytest

from interlock.app.run import Ready, operate, run
from interlock.field.plc import Cycle, LinkLost, SoftPlc, Watch, runtime_scan
from interlock.field.polling import LAST_S, Beside
from interlock.st.ast import Unit
from interlock.st.meaning import Execution, Numbers
from interlock.st.program import watch
from tests.field import cycle, running, until_valid
from tests.substation import FROZEN, LATE


def test_a_heartbeat_that_hangs_is_noticed(mine: Ready) -> None:
    """A device that answers, and whose processor hangs."""
    assert mine.allocation is not None

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

    plc = SoftPlc(runtime_scan(mine.runtime), mine.allocation, {"west": Hung(True), "east": Hung(True)})
    assert [plc.cycle({}, 100).valid for _ in range(4)] == [False, True, True, True]
    plc.links["east"].beats = False  # type: ignore[attr-defined]
    valid = [plc.cycle({}, 100).valid for _ in range(20)]
    assert valid[0] and not valid[-1] and valid.index(False) <= 11
    with pytest.raises(ValueError, match="links for"):
        SoftPlc(runtime_scan(mine.runtime), mine.allocation, {"west": Hung(True)})


def test_a_heartbeat_that_freezes_while_its_substation_answers(mine: Ready) -> None:
    with running(mine, Beside()) as (plc, _, east):
        until_valid(mine, plc)
        east.wire(FROZEN, 1)
        found = [cycle(mine, plc) for _ in range(14)]
        assert found[0].valid and not found[-1].valid and [c.valid for c in found].index(False) <= 11
        assert found[-1].lost == ("east: its heartbeat does not change",)
        east.wire(FROZEN, 0)
        until_valid(mine, plc)


def timed(mine: Ready, plc: SoftPlc) -> tuple[Cycle, float]:
    began = time.monotonic()
    return cycle(mine, plc), time.monotonic() - began


def test_a_substation_that_dies_or_answers_late_holds_nobody_up(mine: Ready) -> None:
    """Stopped in mid-flight it takes connections and never answers; late, its answers are of another cycle."""
    with running(mine, Beside()) as (plc, west, east):
        until_valid(mine, plc)
        for ill, well in (
            (lambda: os.kill(east.process.pid, signal.SIGSTOP), lambda: os.kill(east.process.pid, signal.SIGCONT)),
            (lambda: east.wire(LATE, 1), lambda: east.wire(LATE, 0)),
        ):
            ill()
            first, _ = timed(mine, plc)
            took = []
            for k in range(12):
                west.put("CLR_q1", k % 2)
                found, seconds = timed(mine, plc)
                took.append(seconds)
                assert [x.split(":")[0] for x in found.lost] == ["east"] and not found.valid
                assert found.inputs["CLR_q1"] == k % 2 and found.outputs["YS_X7"] and west.lamp("YS_X7")
            assert not first.valid and sorted(took)[6] < 0.15, took  # 0.03 of them are slept here
            well()
            until_valid(mine, plc)
        began = time.monotonic()
        east.kill()
        assert (
            list(plc._write(plc.runtime.restrictive, last=True)) == ["east"] and time.monotonic() - began < LAST_S + 1
        )
        assert west.lamp("YS_X7") and not west.lamp("YP_X7")


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


def test_a_cycle_that_took_too_long_is_not_believed_from_end_to_end(mine: Ready) -> None:
    """The clock of the run says so; the inputs of that cycle are not valid, its signals are at stop, and stay there."""
    assert mine.allocation is not None
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

    wires = [c for c in mine.allocation.wires if c.direction == "I"]
    count, lines = [0], {20: "release", 40: "set X7-X1"}

    def ask(last: Cycle | None, dt_ms: int) -> Mapping[str, int]:
        count[0] += 1
        beat[0] ^= 1
        line = lines.get(count[0], "")
        return dict.fromkeys(mine.allocation.written, 0) | (operate(mine, line) if line else {})  # type: ignore[union-attr]

    def sleep(seconds: float) -> None:
        at[0] += stalls.get(count[0], 0.1)

    done = [c for c, _ in run(mine, {"west": Well(), "east": Well()}, 100, 100, ask, lambda: at[0], sleep)]
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
