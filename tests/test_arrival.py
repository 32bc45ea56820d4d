"""A train in a berth counts as arrived, where shunting movements come in towards it, only when it stands by time (R2):
wholly in, it may still run at speed to its signal, with every right to, and has no duty to look out for vehicles."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path

import pytest

from interlock.checker.check import check
from interlock.logic.controller import Controller, Timer
from interlock.logic.lower import lower
from interlock.logic.words import FREE, REFUSED
from interlock.model.elements import SignalId
from interlock.model.layout import Layout
from interlock.model.needs import arrival, needs, standing_s
from interlock.proof.engines.limits import Limits
from interlock.proof.mutation.movements import Fate, run_mutants
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.rows import InterlockingTable
from interlock.verify import Rejected
from tests.certified import certified, signed
from tests.layouts import grown
from tests.test_release_behind import Bench

STATION = """interlock: 1
name: arrival
principles: {line_speed_kmh: 60}
boundaries:
  W: {approach: wa 300}
  E: {approach: ea 300}
buffers: [A, B]
tracks:
  west: [W, w0 300]
  main: [w1 400]
  stub: [z1 100, A]
  east: [m3 300, E]
  bay:  [b1 200, B]
points:
  P0: {section: p0, toe: west.end, normal: main.start, reverse: stub.start}
  P1: {section: p1, toe: main.end, normal: east.start, reverse: bay.start}
signals:
  X0: {from: W,  into: w0}
  X2: {from: w0, into: p0, kind: combined}
  D:  {from: z1, into: p0, kind: shunt}
  S1: {from: w1, into: p0, kind: combined}
  X1: {from: w1, into: p1, kind: combined}
  S3: {from: m3, into: p1, kind: combined}
  SB: {from: b1, into: p1, kind: shunt}
  Y:  {from: E,  into: m3}
"""
OVERLAPPED = STATION + "overlaps:\n  X1: {length: 50, release: 40}\n"
LONG = STATION.replace("w1 400", "w1 1200").replace("60}", "60, restart_delay_s: 300}")
STANDS_S = 60
AHEAD, BEHIND, BAY = "S3-S1.s", "X2-X1.s", "X1-B.s"


@cache
def made(text: str) -> tuple[Layout, InterlockingTable, Controller]:
    found = grown(text)
    assert found is not None and not found[2].has_errors
    return found[0], found[1], lower(found[0], found[1])


def in_w1(text: str = STATION, next_one: int = 1) -> Bench:
    """A train has come from w0 into w1, towards X1; `next_one`: the approach to X2 reads clear behind it, or not."""
    b = Bench(made(text)[2])
    b.ask("X2-X1")
    b.go(10, CLR_w0=0)
    b.go(5, CLR_p0=0)
    b.go(5, CLR_w1=0)
    b.go(0.2, CLR_w0=next_one)
    b.go(0.2, CLR_p0=1)
    return b


def granted(b: Bench, route: str) -> bool:
    """Whether a shunting movement is let in now."""
    b.ask(route)
    return bool(FREE < b.controller.status(route)[0] < REFUSED)


def seconds_until_granted(b: Bench, route: str, most: float) -> float:
    """How long a shunting movement is refused from now on; asked for again and again."""
    seconds = 0.0
    while not granted(b, route) and seconds < most:
        seconds += 5.4
    return seconds


@pytest.mark.parametrize("route", [AHEAD, BEHIND], ids=["from ahead", "from the rear"])
def test_vehicles_are_shunted_to_a_train_when_it_stands(route: str) -> None:
    """As soon as the train was wholly in, S3 let a shunting movement past X1's joint into w1, and the train that ran on
    to X1 hit it, standing there on sight."""
    assert STANDS_S <= seconds_until_granted(in_w1(), route, 200) <= STANDS_S + 15


def test_the_operator_is_told_that_it_waits_for_the_train() -> None:
    b = in_w1()
    code, said = b.controller.status(AHEAD)
    assert (
        code > REFUSED and said == "section w1 is locked for a train, until it stands: 60 s after it has come in wholly"
    )
    b.go(STANDS_S + 5)
    assert b.controller.status(AHEAD)[0] == FREE


def test_the_time_counts_from_when_it_is_wholly_in() -> None:
    b = Bench(made(STATION)[2])
    b.ask("X2-X1")
    b.go(10, CLR_w0=0)
    b.go(5, CLR_p0=0)
    b.go(100, CLR_w1=0)
    b.go(5, CLR_w0=1)
    b.go(0.2, CLR_p0=1)
    assert seconds_until_granted(b, AHEAD, 200) >= STANDS_S - 5.4


def test_the_next_train_before_the_signal_in_rear_does_not_matter() -> None:
    """It is seen once that all of the train is in; who comes to X2 meanwhile finds stop."""
    b = in_w1()
    b.go(10)
    b.go(0.2, CLR_w0=0)
    assert STANDS_S - 11 <= seconds_until_granted(b, AHEAD, 200) <= STANDS_S


def test_a_train_that_goes_on_is_not_delayed() -> None:
    """Nor is the berth kept any longer behind it."""
    b = in_w1()
    b.ask("X1-E")
    assert b.outputs["YP_X1"]
    b.go(5, CLR_p1=0)
    b.go(5, CLR_m3=0)
    b.go(0.2, CLR_w1=1)
    assert b.seconds_until_free(20, "w1") <= 4
    b.go(5, CLR_p1=1)
    b.go(5, CLR_m3=1)


def test_in_a_bay_it_is_as_it_was() -> None:
    """Nobody comes towards a train that runs to a buffer: shunting follows it at once."""
    b = in_w1()
    b.ask("X1-B")
    b.go(5, DN_P1=0, DR_P1=1)
    assert not b.outputs["YS_X1"]
    b.go(5, CLR_p1=0)
    b.go(5, CLR_b1=0)
    b.go(5, CLR_w1=1)
    b.go(0.2, CLR_p1=1)
    assert seconds_until_granted(b, "X1-B.s", 200) <= 5.4


def timers(text: str) -> dict[str, Timer]:
    return {str(t.name): t for t in made(text)[2].timers}


def test_only_where_a_train_and_a_shunting_movement_meet() -> None:
    """Not before S3 and X2, once trains or shunting movements do not come there."""
    found = {name for name in timers(STATION) if name.startswith("OT_")}
    assert found == {"OT_X1", "OT_S1", "OT_S3", "OT_X2"}
    no_shunt_out = STATION + "exclude:\n  - {from: X1, to: E, kind: shunt, reason: none}\n"
    no_train_in = STATION.replace("E: {approach: ea 300}", "E: {trains: out}").replace(
        "  Y:  {from: E,  into: m3}\n", ""
    )
    for text in (no_shunt_out, no_train_in):
        assert {name for name in timers(text) if name.startswith("OT_")} == found - {"OT_S3"}


def test_its_time_is_the_principle_or_what_a_train_needs() -> None:
    """No layout is refused for it: a berth that is longer has a longer time."""
    assert timers(STATION)["OT_X1"].preset_ms == 1000 * STANDS_S
    layout = made(LONG)[0]
    need = arrival(layout)[SignalId("X1")]
    assert timers(LONG)["OT_X1"].preset_ms == need > 72_000
    assert need - 1 < 1000 * standing_s(layout, SignalId("X1")) <= need
    assert seconds_until_granted(in_w1(LONG), AHEAD, 300) >= need / 1000
    quick = made(STATION.replace("60}", "60, overlap_release_s: 5}"))[0]
    assert needs(quick).stand[SignalId("X1")] <= arrival(quick)[SignalId("X1")]


def test_where_its_signal_has_an_overlap_that_has_the_time() -> None:
    assert timers(OVERLAPPED)["OT_X1"].preset_ms == 40_000


@pytest.mark.parametrize("text", [STATION, OVERLAPPED, LONG], ids=["station", "overlapped", "long"])
def test_the_second_checker_says_so_too(text: str, tmp_path: Path) -> None:
    """By its own reading of the layout, with the time, and the sentence of the refusal."""
    (tmp_path / "layouts").mkdir()
    layout = tmp_path / "layouts/arrival.yaml"
    layout.write_text(text, "utf-8")
    found = check(layout, certified(layout, tmp_path))
    assert not found.left


def test_the_second_checker_refuses_a_time_that_is_too_short(tmp_path: Path) -> None:
    """The long berth's certificate beside a layout in which it is longer still."""
    (tmp_path / "layouts").mkdir()
    layout = tmp_path / "layouts/arrival.yaml"
    layout.write_text(LONG, "utf-8")
    folder = certified(layout, tmp_path)
    longer = LONG.replace("w1 1200", "w1 1210")
    layout.write_text(longer, "utf-8")
    manifest = folder / "manifest.json"
    old, new = (hashlib.sha256(x.encode()).hexdigest() for x in (LONG, longer))
    manifest.write_text(manifest.read_text("utf-8").replace(old, new), "utf-8")
    signed(folder)
    with pytest.raises(Rejected, match="the claim D-PRESET lacks what the specification asks"):
        check(layout, folder)


@pytest.mark.parametrize("text", [STATION, OVERLAPPED, LONG], ids=["station", "overlapped", "long"])
def test_it_is_proved_and_what_lets_a_shunter_in_before_is_not(text: str) -> None:
    layout, table, controller = made(text)
    result = prove(System(layout, controller), Limits(search_depth=0))
    assert result.proved and not result.dropped
    kinds = ("arrived-running", "delay-too-short")
    found = list(run_mutants(layout, table, 0, Limits(search_depth=0), only=kinds))
    running = [o for o in found if o.kind == kinds[0]]
    assert {o.place for o in running} >= {"M_w1 before X1", "M_w1 before S1"}
    assert all(o.fate is not Fate.REDUNDANT and "L-REASON" in o.claims for o in running)
    short = [o for o in found if o.place == "OT_X1"]
    assert short and all(o.claims == ("D-PRESET",) for o in short)


@pytest.mark.parametrize("kind", ["shunt, stops_trains: yes", "board"])
def test_a_board_or_a_shunt_signal_at_which_trains_end_is_no_other(kind: str) -> None:
    """The train has every right to run to it as well."""
    text = STATION.replace("X1: {from: w1, into: p1, kind: combined}", f"X1: {{from: w1, into: p1, kind: {kind}}}")
    layout, _, controller = made(text)
    assert STANDS_S <= seconds_until_granted(in_w1(text), AHEAD, 200) <= STANDS_S + 15
    assert prove(System(layout, controller), Limits(search_depth=0)).proved
