"""Shifts of a fleet on the emitted runtime: their physics, their scans, their bytes, and what they must never show."""

from __future__ import annotations

import gc
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from math import ceil, inf
from multiprocessing import get_context
from pathlib import Path
from random import Random

import pytest
from click.testing import CliRunner

from interlock.app import shift as shift_module
from interlock.app.setting import Setting, prepared
from interlock.app.shift import Shift
from interlock.app.shifts import EXACT, many, mean, one, student
from interlock.app.worked import Options, Worked
from interlock.cli.simulate import command
from interlock.dispatch import Dispatcher
from interlock.dispatch.assign import Assigner, Assigning
from interlock.dispatch.causes import CAUSES
from interlock.emit.python.runtime import runtime_py
from interlock.logic.lower import lower
from interlock.model.stopping import MARGIN_M, SIGNAL_M
from interlock.record import read
from interlock.record.report import shift_html
from interlock.simulate.agenda import Agenda, not_before
from interlock.simulate.driving import Build, Rolling
from interlock.simulate.mishaps import TRIAL
from interlock.simulate.motion import Motion, runs, standing
from interlock.simulate.run import load
from interlock.simulate.scans import Scans
from interlock.simulate.track import NONE, Track
from interlock.simulate.yard import Yard
from tests.campaigns.shift import fleet_of
from tests.layouts import built
from tests.weakened import WEAKENED

HEISHAN = "layouts/heishan.yaml"
HOUR = Options(hours=1.0)


@lru_cache
def hour(seed: int, faults: bool = False) -> Worked:
    return Shift(prepared(HEISHAN, None), seed, replace(HOUR, faults=TRIAL) if faults else HOUR).run()


# --- physics ---------------------------------------------------------------------------------------


def motions() -> Iterator[tuple[Motion, float, float, float]]:
    """Motions from any state, with where they are to end, their top speed and their brakes."""
    rng = Random(1)
    for _ in range(400):
        speed, top = rng.choice((0.0, rng.uniform(0, 6))), rng.uniform(0.5, 6)
        to = rng.choice((inf, rng.uniform(0.1, 900)))
        brakes = rng.uniform(0.2, 1)
        yield runs(5.0, 0.0, speed, to, top, rng.uniform(0.1, 0.6), brakes), to, max(speed, top), brakes


def test_a_train_stands_where_it_means_to_or_as_soon_as_it_can() -> None:
    stopped = 0
    for m, to, top, brakes in motions():
        speed = m.phases[0].speed
        if to < inf:
            assert m.stands < inf
            assert m.at(m.stands + 1)[0] == pytest.approx(max(to, speed**2 / (2 * brakes)), abs=1e-6)
            stopped += speed**2 / (2 * brakes) <= to
        else:
            assert m.stands == inf and m.at(1e4)[1] <= top
    assert stopped > 100


def test_motion_is_continuous_and_when_is_the_inverse_of_at() -> None:
    for m, to, top, _ in motions():
        for p, q in pairwise(m.phases):
            dt = q.since - p.since
            assert dt >= -1e-9 and p.speed + p.rate * dt == pytest.approx(q.speed, abs=1e-6)
            assert p.metres + p.speed * dt + p.rate * dt**2 / 2 == pytest.approx(q.metres, abs=1e-6)
        end = min(m.at(1e6)[0], 500.0)
        for k in range(1, 20):
            metres = end * k / 20
            time = m.when(metres)
            assert m.at(time)[0] == pytest.approx(metres, abs=1e-4) and m.at(time)[1] <= top + 1e-6
        if to < inf:
            assert m.when(m.at(1e6)[0] + 1.0) == inf
    assert standing(0.0, 7.0).when(7.1) == inf and standing(0.0, 7.0).at(9.0) == (7.0, 0.0)


def test_a_planned_time_is_not_rounded_to_before_it() -> None:
    rng, rounded = Random(1), 0
    for _ in range(2000):
        m = runs(rng.randrange(30_000_000) / 1000, 0.0, 0.0, rng.randrange(1, 400), 2.5, 0.5, 0.5)
        ms = not_before(m.stands)
        assert ms / 1000 >= m.stands and m.at(ms / 1000)[1] == 0.0
        assert (ms - 2) / 1000 < m.stands
        rounded += ceil(1000 * m.stands) / 1000 < m.stands
    assert rounded > 5  # as often as this a train would have come to a stand a little too early


def yard_with_a_train(reaction: float = 1.0) -> tuple[Yard, Rolling]:
    """Heishan, and a train that comes in."""
    layout = prepared(HEISHAN, None).layout
    track = Track.of(layout)
    yard = Yard(track, {}, Agenda(), Random(0), lambda kind, **fields: None)
    way_in = next(b.name for b in track.beyond if b.comes != NONE)
    return yard, yard.comes("1", Build(20.0, layout.principles.line_speed_kmh / 3.6, 0.5, 0.5, reaction), way_in)


def run_on(yard: Yard) -> list[Rolling]:
    """Who stands, once nothing is left to happen; which takes no more than twenty things."""
    stood: list[Rolling] = []
    yard.driving.stopped = stood.append
    for _ in range(20):
        due = yard.agenda.next_ms()
        if due is None:
            return stood
        yard.agenda.now_ms = due
        yard.agenda.step()
    raise AssertionError(f"time does not go on after {yard.agenda.now_ms} ms")


def test_a_train_that_comes_into_sight_of_a_signal_at_a_whole_millisecond_runs_on() -> None:
    """It would read the signal from where it is, but for the rounding: then no time went by until it did."""
    for k in range(500, 700):
        yard, _ = yard_with_a_train(k / 1000)
        stood = run_on(yard)
        assert len(stood) == 1, f"reacts within {k} ms"
        yard.sight.look(stood[0].train)
        assert stood[0].train.view.gap == pytest.approx(SIGNAL_M)


@pytest.mark.parametrize("accepted", [False, True])
def test_a_train_that_derails_stands_there_and_time_goes_on(accepted: bool) -> None:
    yard, r = yard_with_a_train()
    end = next(d for d, s in enumerate(yard.track.stretches) if s.on == NONE and s.facing is None and not s.outside)
    metres = yard.track.stretches[end].metres
    r.train.body[:], r.head_0, r.tail_0, r.accepted = [end], 8.0 - metres, 13.0 - metres, accepted
    r.train.speed, r.motion = 5.0, runs(0.0, 0.0, 5.0, 100.0, 5.0, 0.5, 0.5)
    yard.agenda.at(1600, lambda: yard.driving._happens(r), "train 1")  # eight metres at 5 m/s
    assert run_on(yard) == [r]
    assert yard.watch.found == ["1.6 s: train 1 runs off the rails"]
    assert r.train.body == [end] and not r.accepted


# --- scans -----------------------------------------------------------------------------------------


class Every(Scans):
    """Runs every scan of the cycle, whether or not it can change anything."""

    def due(self, changed_ms: int | None) -> int | None:
        return self.last_ms + self.cycle_ms


@pytest.mark.parametrize("faults", [False, True])
def test_what_is_left_out_changes_nothing(monkeypatch: pytest.MonkeyPatch, faults: bool) -> None:
    """An hour of which only those scans are run that can change something says the same as one with every scan."""
    few = hour(3, faults)
    monkeypatch.setattr(shift_module, "Scans", Every)
    every = Shift(prepared(HEISHAN, None), 3, replace(HOUR, faults=TRIAL) if faults else HOUR).run()
    assert 20 * few.scans < every.scans
    without = [[{k: v for k, v in e.items() if k != "scans"} for e in read(w.log).events] for w in (few, every)]
    assert without[0] == without[1]


# --- the same bytes --------------------------------------------------------------------------------


def test_the_same_seed_gives_the_same_bytes_in_any_executor() -> None:
    here = [hour(s).log for s in range(3)]
    assert len(set(here)) == 3 and all(read(x).ended for x in here)
    for executor in (ProcessPoolExecutor(2, get_context("spawn")), ThreadPoolExecutor(2)):
        told: list[int] = []
        with executor:
            done = many(HEISHAN, None, range(3), HOUR, executor, told.append)
        assert [w.log for w in done] == here and told == [1, 2, 3]


def killed_in_a_cluster() -> None:
    """What the test below asks, in a process of its own: Dask leaves threads behind, and a process with threads must
    not be forked."""
    from distributed import Client, LocalCluster

    options = replace(HOUR, hours=0.25)
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1") as cluster,
        Client(cluster) as client,
    ):
        pids = list(client.run(os.getpid).values())
        killed: list[int] = []

        def note(done: int) -> None:
            if done == 1:
                os.kill(pids[0], signal.SIGKILL)
                killed.append(done)

        found = many(HEISHAN, None, range(6), options, client.get_executor(pure=False), note)
    assert killed == [1]
    assert [w.log for w in found] == [one(HEISHAN, None, s, options).log for s in range(6)]


def test_a_cluster_whose_worker_is_killed_loses_nothing() -> None:
    process = get_context("spawn").Process(target=killed_in_a_cluster)
    process.start()
    process.join(300)
    if process.exitcode is None:
        process.kill()
    assert process.exitcode == 0


# --- what a shift shows ----------------------------------------------------------------------------


def test_a_shift_does_all_that_is_ordered() -> None:
    w = one(HEISHAN, None, 0, Options())
    assert w.tipped == {"a": 6, "b": 8, "c": 4} and w.tonnes == {"lean": 480.0, "rich": 600.0}
    assert not any(w.wrong.counts().values()) and w.alarms == [] and w.late == {"b": 0}
    events = read(w.log).events
    assert {e["cause"] for e in events if e["kind"] == "waits"} <= set(CAUSES) - {"other"}
    inside, most = set[str](), 0
    for e in events:
        if e["kind"] == "enters" and e["section"] == "s3":
            inside.add(e["train"])
        elif e["kind"] == "leaves":
            inside.discard(e["train"])
        most = max(most, len(inside))
    assert most <= 4, "document D: with four inside, empties wait"


def test_no_standstill_whatever_fails(tmp_path: Path) -> None:
    w = one(HEISHAN, fleet_of(tmp_path, 8), 8, Options(hours=3.0, faults=TRIAL))
    assert not any(w.wrong.counts().values()) and w.trains > 3
    kinds = {e["kind"] for e in read(w.log).events}
    assert {"fault", "mended", "alarm", "pressed"} <= kinds


def test_a_route_that_nobody_uses_is_cancelled_before_its_sections_are_released() -> None:
    """Inputs are lost while a train passes XB, so that its route stays set for nobody: no section of it is released by
    hand before the route is cancelled, and the next train waits for them."""
    shift = Shift(prepared(HEISHAN, None), 0, Options(hours=1.5))
    say, write = shift.yard.say, shift.yard.inputs.write

    def told(kind: str, **fields: object) -> None:
        say(kind, **fields)
        if kind == "runs" and fields["section"] == "s1_wait" and not lost:
            lost.append(shift.agenda.now_ms)
            shift.agenda.after(3.0, lambda: write("VALID", 0))
            shift.agenda.after(33.0, lambda: write("VALID", 1))

    lost: list[int] = []
    shift.yard.say = told
    w = shift.run()
    released = [e for e in read(w.log).events if e["kind"] == "pressed" and e["button"] == "REL_s2"]
    assert lost and released and not any(w.wrong.counts().values()) and w.trains > 2


def back(tmp_path: Path, loading: Mapping[str, int]) -> str:
    """A dispatch file for heishan: the only way out is the one by which trains come in, over W."""
    file = tmp_path / "back.dispatch"
    file.write_text(
        "dispatch: 1\nlayout: heishan\nfleet: {1: {length: 60, at: house}, 2: {length: 60, at: house}}\nplaces:\n"
        "  house: {kind: waiting, at: W, capacity: 8}\n  crush: {kind: tipping, at: W, minutes: 6}\n"
        + "".join(f"  at_{s}: {{kind: loading, at: {s}, minutes: 20, capacity: {n}}}\n" for s, n in loading.items())
        + "orders:\n"
        + "".join(f"  to_{s}: {{from: at_{s}, to: crush, trains: 6}}\n" for s in loading),
        "utf-8",
    )
    return str(file)


def test_a_train_waits_outside_while_another_is_to_come_back_the_same_way(tmp_path: Path) -> None:
    """The first one stands in the approach section; it was taken for the second, which was let in behind it."""
    w = one(HEISHAN, back(tmp_path, {"s4_xc1": 2}), 0, Options())
    assert not any(w.wrong.counts().values()) and w.trains == 6
    entered = [(e["train"], e["kind"]) for e in read(w.log).events if e.get("section") == "s1_wait"]
    assert all(a[0] == b[0] for a, b in zip(entered[::2], entered[1::2], strict=True)), "one at a time on the line at W"


@pytest.mark.parametrize("look_ahead", [1, 2, 3])
def test_a_train_whose_way_out_is_set_far_ahead_is_not_out_yet(tmp_path: Path, look_ahead: int) -> None:
    """Its last route is taken back if a train comes in first; that one was let in, since the other counted as gone."""
    w = one(HEISHAN, back(tmp_path, {"s4_xc1": 1, "s5_xc2": 1}), 2, Options(look_ahead=look_ahead))
    assert not any(w.wrong.counts().values()) and w.trains == 12
    assert w.alarms == [], "who runs out over the boundary at which trains come in keeps its number"


LOOP = "tests/layouts_for_tests/turning_loop.yaml"


def looping(tmp_path: Path, load: str, length: int) -> str:
    """A dispatch file of two trains on the turning loop, which come in and leave over the same boundary."""
    file = tmp_path / "x.dispatch"
    file.write_text(
        f"dispatch: 1\nlayout: turning_loop\nfleet: {{1: {{length: {length}, at: out}}, 2: {{length: 60, at: out}}}}\n"
        f"places:\n  out: {{kind: waiting, at: W, capacity: 2}}\n  load: {{kind: loading, at: {load}, minutes: 5}}\n"
        "  tip: {kind: tipping, at: W, minutes: 5}\norders: {x: {from: load, to: tip, trains: 4}}\n",
        "utf-8",
    )
    return str(file)


def looped(tmp_path: Path, load: str, length: int, planned: bool) -> Worked:
    return one(LOOP, looping(tmp_path, load, length), 0, Options(hours=4.0, planned=planned))


@pytest.mark.parametrize("length", [190, 250])
def test_the_tail_of_a_long_train_is_not_in_its_way(tmp_path: Path, length: int) -> None:
    """Its head is past the second signal while its tail is on the line outside, where it was taken for a stranger."""
    w = looped(tmp_path, "a", length, planned=False)
    assert w.trains == 4 and not any(w.wrong.counts().values()) and w.alarms == []


@pytest.mark.parametrize("load", ["w1", "w2", "a"])
def test_no_train_comes_towards_a_boundary_over_which_another_is_to_run_out(tmp_path: Path, load: str) -> None:
    """Its route was set, and it was not on the line yet: the other one came, and for good both stood.  What is set for
    a train that has not come yet is its own."""
    w = looped(tmp_path, load, 60, planned=True)
    assert w.trains == 4 and not any(w.wrong.counts().values()) and w.alarms == []


def test_a_train_that_comes_where_no_approach_section_reports_has_its_number(tmp_path: Path) -> None:
    """It was nowhere expected, and "no number in w1" was told of every train."""
    layout = tmp_path / "turning_loop.yaml"
    layout.write_text(Path(LOOP).read_text("utf-8").replace("W: {approach: w0 600}", "W: {}"), "utf-8")
    w = one(str(layout), looping(tmp_path, "a", 60), 0, Options(hours=2.0))
    assert w.trains > 2 and w.alarms == [] and not any(w.wrong.counts().values())


@pytest.mark.parametrize(("tip", "length", "refused"), [("W30", 60, 1), ("W30", 15, 0), ("W27", 15, 0)])
def test_a_route_refused_over_its_own_overlap_is_no_alarm(tmp_path: Path, tip: str, length: int, refused: int) -> None:
    """Points in the overlap of G33 lie otherwise, so that G33-G38 is refused until that is released.  Its sections are
    locked as overlap, as if it were set: it was told as taken back, which is for what fails.  A short train waits for
    less than a minute; its route was granted, and cancelled as it opened, since the time before was counted on."""
    file = tmp_path / "x.dispatch"
    file.write_text(
        f"dispatch: 1\nlayout: overlap_unused\nfleet: {{1: {{length: {length}, speed: 20, at: out}}}}\nplaces:\n"
        "  out: {kind: waiting, at: W}\n  load: {kind: loading, at: s7, minutes: 4}\n"
        f"  tip: {{kind: tipping, at: {tip}, minutes: 2, back: 2}}\n"
        "orders: {x: {from: load, to: tip, trains: 2}}\n",
        "utf-8",
    )
    shift = Shift(prepared("tests/layouts_for_tests/overlap_unused.yaml", str(file)), 0, Options(hours=1.0))
    w, said = shift.run(), shift._dispatcher.journal.said
    assert [x for x in said if "refused" in x] == ["1: G33-G38 was refused"] * refused * 2
    assert w.trains == 2 and w.alarms == [] and not any(w.wrong.counts().values())
    pressed = {e["button"] for e in read(w.log).events if e["kind"] == "pressed"}
    assert not pressed & {"REL_s13", "REL_s22"}  # the overlap of G33, on which no route was left over


def test_a_train_that_has_changed_ends_for_a_route_taken_back_changes_them_again(tmp_path: Path) -> None:
    """Loaded in a, with b falsely occupied, it changes ends for A2-WO; P fails, b is clear again, and A1-C1 is set: its
    signal stood behind the driver, for ever."""
    shift = Shift(prepared(LOOP, looping(tmp_path, "a", 60)), 0, Options(hours=1.5))
    say, b, done = shift.yard.say, shift.yard.track.sections.index("b"), set[str]()

    def told(kind: str, **fields: object) -> None:
        say(kind, **fields)
        if kind in ("loaded", "turns") and kind not in done:
            done.add(kind)
            shift.yard.inputs.hold(b, 1 if kind == "loaded" else -1)
        if kind == "turns" and len(done) == 2:
            done.add("P")
            shift.agenda.after(0.1, lambda: shift.yard.machines.fault(0, 1))
            shift.agenda.after(60.0, lambda: shift.yard.machines.fault(0, -1))

    shift._say = shift.yard.say = told  # type: ignore[method-assign]
    w = shift.run()
    assert done == {"loaded", "turns", "P"} and w.trains > 1 and not any(w.wrong.counts().values())
    assert w.alarms[0] == "1: A2-WO is taken back, since P is not detected"


def test_without_the_rule_a_fleet_stands_for_ever(tmp_path: Path) -> None:
    w = one(HEISHAN, fleet_of(tmp_path, 8), 0, Options(rule=False))
    assert w.wrong.standstill and w.seconds < 8 * 3600
    last = read(w.log).events[-2]
    assert last["kind"] == "standstill" and last["waiting"]


def test_a_shift_that_stands_for_ever_says_why(tmp_path: Path) -> None:
    """One machine drives points on the way and others in the section in which its train stands, which do not move then
    (IL7011).  "G-L was refused" was all that was told, in the record alone."""
    layout, file, log = tmp_path / "under.yaml", tmp_path / "under.dispatch", tmp_path / "under-0.log"
    layout.write_text(UNDER, "utf-8")
    file.write_text(
        "dispatch: 1\nlayout: under\nfleet: {1: {length: 30, speed: 20, at: out}}\nplaces:\n"
        "  out: {kind: waiting, at: W}\n  load: {kind: loading, at: c, minutes: 4}\n"
        "  tip: {kind: tipping, at: E, minutes: 2, back: 2}\norders: {x: {from: load, to: tip, trains: 2}}\n",
        "utf-8",
    )
    done = CliRunner().invoke(command, [str(layout), "-o", str(tmp_path)])
    why = "G-L was refused: points M cannot move: section a is locked"
    assert done.exit_code == 1 and f"\n    seed 0: 1 stands for ever: {why}\n" in done.output
    assert read(log.read_bytes()).events[-2]["waiting"] == {"1": why}
    assert f"<td>1: {why}</td>" in shift_html(read(log.read_bytes()))


UNDER = """interlock: 1
name: under
boundaries: {W: {approach: w0 300, trains: in}, E: {approach: e0 300, trains: out}}
buffers: [B1, B2, B3]
tracks: {t: [W, a 100], u: [c 80, d 100, E], k: [k 30, B1], m: [m 30, B2], n: [B3, n 30]}
points:
  P: {section: a, toe: t.end, normal: Q.toe, reverse: R.reverse, legs: 20}
  Q: {section: a, normal: k.start, reverse: m.start, machine: M}
  R: {section: b, toe: u.start, normal: n.end, machine: M}
signals:
  X: {from: W, into: a}
  G: {from: a, into: b, at: P}
  L: {from: c, into: d}
"""


@pytest.mark.parametrize("kind", ["all signals clear", "points wired the wrong way round"])
def test_a_wrong_controller_comes_to_harm_in_a_shift(tmp_path: Path, kind: str) -> None:
    layout, table, _ = built("heishan")
    setting = prepared(HEISHAN, fleet_of(tmp_path, 8))
    wrong: Setting = replace(setting, names=load(runtime_py(WEAKENED[kind][1](lower(layout, table)), [])))
    w = Shift(wrong, 0, Options(rule=False, hours=2.0)).run()
    assert w.wrong.hazards or w.wrong.passed_at_stop


def test_a_decision_is_quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With eight trains, between a scan and what is written after it, in processor time of its thread.  The garbage
    collector is off, as in every command: it walks what all tests before have left, 0.18 s for 3 million lists."""
    took, step = [0.0], Dispatcher.step

    def timed(self: Dispatcher, seen: Mapping[str, int], dt_ms: int) -> dict[str, int]:
        began = time.thread_time()
        found = step(self, seen, dt_ms)
        took.append(time.thread_time() - began)
        return found

    monkeypatch.setattr(Dispatcher, "step", timed)
    gc.disable()
    try:
        one(HEISHAN, fleet_of(tmp_path, 8), 1, Options(hours=2.0))
    finally:
        gc.enable()
    assert max(took) < 0.05 and len(took) > 500


def test_orders_are_given_in_turn_by_distance_or_always_the_same() -> None:
    setting = prepared(HEISHAN, None)

    def given(how: Assigning) -> list[str]:
        a = Assigner(setting.orders.file, setting.derived, how)
        return [o.name if (o := a.next(t)) is not None else "" for t in ("1", "2", "3", "4")]

    assert given(Assigning.IN_TURN) == ["b", "a", "c", ""], "the one that is due comes first; three places"
    assert given(Assigning.NEAREST) == ["a", "b", "c", ""]
    assert given(Assigning.FIXED) == ["a", "b", "c", ""]
    assert given(Assigning.FIXED_FAR) == ["c", "b", "a", ""]
    a = Assigner(setting.orders.file, setting.derived)
    assert a.next("1") and a.next("2") and a.next("3") and a.why("4") == "no place to load is free"


PUBLISHED_T = dict(
    enumerate(
        (
            *(12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228),
            *(2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086),
            *(2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042),
        ),
        1,
    )
) | {40: 2.021, 60: 2.000, 120: 1.980}
"""By degrees of freedom: Student's t for 95 %, two-sided (Abramowitz and Stegun, table 26.10)."""


def test_means_and_how_sure_they_are() -> None:
    for freedom, t in PUBLISHED_T.items():
        assert student(freedom) == pytest.approx(t, abs=5.001e-4), freedom
    for freedom, t in {1: 63.657, 2: 9.925, 3: 5.841, 4: 4.604, 10: 3.169, 30: 2.750, 120: 2.617}.items():
        assert student(freedom, 0.99) == pytest.approx(t, abs=5.001e-4), freedom
    assert student(3) == pytest.approx(3.182446, abs=1e-6)
    assert student(EXACT) == pytest.approx(student(EXACT + 1), rel=1e-4) and student(10**5) > 1.959964
    m = mean([30, 32, 34])
    assert m.value == 32 and m.half == pytest.approx(4.303 * 2 / 3**0.5, rel=1e-3)
    assert mean([5]).half == inf


# --- bad input -------------------------------------------------------------------------------------

SHIPPED = Path("layouts/heishan.dispatch").read_text("utf-8")
NOBODY = SHIPPED.replace(SHIPPED.partition("fleet:")[2].partition("\nplaces:")[0], "").replace("fleet:", "fleet: {}")
MANY = "".join(f"  {k}: {{length: 60, at: house}}\n" for k in range(10, 510))
BAD: dict[str, str | bytes] = {
    "an unknown locomotive": SHIPPED.replace("trains: 6, ore: rich}", "trains: 6, ore: rich, only: [99]}"),
    "an order for a blocked place": SHIPPED + "\nblocked: [c3]\n",
    "a fleet of 0": NOBODY,
    "a fleet of 500": SHIPPED.replace("fleet:\n", "fleet:\n" + MANY),
    "loading in no time": SHIPPED.replace("minutes: 20", "minutes: 0", 1),
    "a train that does not run": SHIPPED.replace("speed: 10", "speed: 0", 1),
    "a shift of no hours": SHIPPED.replace("shift_h: 8", "shift_h: 0"),
    "a file of another layout": SHIPPED.replace("layout: heishan", "layout: mine11"),
    "a tippler inside": SHIPPED.replace("at: OUT, minutes: 6", "at: s2_out, minutes: 6"),
    "a fleet that waits inside": SHIPPED.replace("at: W, capacity: 8", "at: s2_out, capacity: 4"),
    "minutes with a unit": SHIPPED.replace("minutes: 20", "minutes: 20 min", 1),
    "minutes as hours and minutes": SHIPPED.replace("minutes: 20", "minutes: 0:20", 1),
    "minutes in digits of full width": SHIPPED.replace("minutes: 20", "minutes: ２０", 1),
    "minutes of less than nothing": SHIPPED.replace("minutes: 20", "minutes: -20", 1),
    "no minutes": SHIPPED.replace(", minutes: 20", "", 1),
    "a speed that is no number": SHIPPED.replace("speed: 10", "speed: .nan", 1),
    "a speed in m/s": SHIPPED.replace("speed: 10", "speed: 2.8 m/s", 1),
    "a speed far too low": SHIPPED.replace("speed: 10", "speed: 0.05", 1),
    "an acceleration far too low": SHIPPED.replace("at: house}", "at: house, acceleration: 0.0001}", 1),
    "a train in millimetres": SHIPPED.replace("length: 60", "length: 60000", 1),
    "a train too long for its places": SHIPPED.replace("length: 60", "length: 500", 1),
    "a tonnage as text": SHIPPED.replace("tonnes: 480", "tonnes: sixty"),
    "a tonnage with its unit": SHIPPED.replace("tonnes: 480", "tonnes: 480 t"),
    "a tonnage as a power": SHIPPED.replace("tonnes: 480", "tonnes: 4.8e2"),
    "a locomotive twice": SHIPPED.replace("  2: {length", "  1: {length"),
    "two numbers that read alike": SHIPPED.replace("  2: {length", "  01: {length"),
    "a locomotive named twice": SHIPPED.replace("trains: 6, ore: rich}", "trains: 6, ore: rich, only: [1, 1]}"),
    "a place twice": SHIPPED.replace("  c2: {kind", "  c1: {kind"),
    "two places in one section": SHIPPED.replace("at: s5_xc2", "at: s4_xc1"),
    "a place that loads another ore": SHIPPED.replace("trains: 6, ore: rich}", "trains: 6, ore: lean}"),
    "an order from the tippler": SHIPPED.replace("from: c1, to: crush", "from: crush, to: c1"),
    "an order by when in the past": SHIPPED.replace("by: 6", "by: -1"),
    "an order by a time of day": SHIPPED.replace("by: 6", "by: '14:00'"),
    "an order by when after the shift": SHIPPED.replace("by: 6", "by: 12"),
    "a blocked section on every way": SHIPPED + "\nblocked: [s7]\n",
    "shares of more than the blend": SHIPPED.replace("ore: rich}", "ore: rich, share: 0.7}"),
    "a file of another version": SHIPPED.replace("dispatch: 1", "dispatch: 2"),
    "a layout": Path("layouts/heishan.yaml").read_text("utf-8"),
    "a title in GBK": SHIPPED.replace("shift_h: 8", "title: 黑山\nshift_h: 8").encode("gbk"),
    "a file cut off": SHIPPED[:700],
    "an empty file": "",
}


def test_bad_input_has_a_code_and_a_place_and_asks_for_nothing(tmp_path: Path) -> None:
    """Each with its screen, in shift_screens.txt."""
    file, out, screens = tmp_path / "x.dispatch", tmp_path / "out", ""
    for name, text in BAD.items():
        file.write_bytes(text.encode() if isinstance(text, str) else text)
        done = CliRunner().invoke(command, [HEISHAN, "--dispatch", str(file), "-o", str(out)], catch_exceptions=False)
        assert done.exit_code == 1 and "Traceback" not in done.output and not out.exists(), name
        assert re.search(r"\[IL\d{4}\]", done.output) and re.search(r"x\.dispatch:\d+:\d+", done.output), done.output
        screens += f"--- {name}\n{done.output.replace(str(tmp_path) + '/', '')}"
    assert screens == Path("tests/shift_screens.txt").read_text("utf-8")


@pytest.mark.parametrize("option", ["--hours", "--optimum"])
def test_what_is_not_a_number_is_within_no_bounds(option: str) -> None:
    for value in ("nan", "inf", "-1", "0"):
        done = CliRunner().invoke(command, [HEISHAN, option, value, "--steady"], catch_exceptions=False)
        assert done.exit_code == 2 and "not in the range" in done.output, done.output


def test_a_restart_is_waited_for_and_told_where_it_does_not_end(tmp_path: Path) -> None:
    slow = tmp_path / "heishan.yaml"
    text = Path(HEISHAN).read_text("utf-8")
    slow.write_text(text.replace("profile: mine\n", "profile: mine\nprinciples: {restart_delay_s: 3600}\n"), "utf-8")
    assert one(str(slow), "layouts/heishan.dispatch", 0, HOUR).trains == hour(0).trains, "the shift begins after it"
    file = tmp_path / "x.dispatch"
    file.write_text(
        "dispatch: 1\nlayout: undetected\nfleet: {1: {length: 20, at: house}}\nplaces:\n"
        "  house: {kind: waiting, at: W}\n  load: {kind: loading, at: q1, minutes: 5}\n"
        "  tip: {kind: tipping, at: E, minutes: 6}\norders: {a: {from: load, to: tip, trains: 1}}\n",
        "utf-8",
    )
    done = CliRunner().invoke(command, ["tests/layouts_for_tests/undetected.yaml", "--dispatch", str(file)])
    assert done.exit_code == 1 and "error[IL6012]: sid cannot be released after the restart" in done.output, done.output


def test_what_comes_after_the_time_of_its_order_is_told(tmp_path: Path) -> None:
    file = tmp_path / "x.dispatch"
    file.write_text(
        Path("layouts/heishan.dispatch")
        .read_text("utf-8")
        .replace("tonnes: 480", "trains: 2")
        .replace("by: 6", "by: 0.75")
    )
    line = [HEISHAN, "--dispatch", str(file), "--hours", "2", "-o", str(tmp_path)]
    done = CliRunner().invoke(command, line, catch_exceptions=False)
    events = [json.loads(x) for x in (tmp_path / "heishan-0.log").read_text("utf-8").splitlines()]
    after = sum(e["kind"] == "tipped" and e["order"] == "b" and e["t"] > 0.75 * 3_600_000 for e in events)
    assert done.exit_code == 0 and after == 1, "as the record has it, which begins with the shift"
    assert f"order b: 2 of 2 trains from c3, {after} of them after 0.75 h" in done.output, done.output


def test_an_order_of_tonnes_is_done_when_they_are_there(tmp_path: Path) -> None:
    """Trains of unlike wagons: counted in the smallest of them, it would be 16 trains, and 720 t."""
    file = tmp_path / "x.dispatch"
    small = (
        Path("layouts/heishan.dispatch")
        .read_text("utf-8")
        .replace("3: {length: 60, wagons: 10, tonnes: 60", "3: {length: 60, wagons: 10, tonnes: 30")
    )
    for only in ("", "only: [1, 2, 4], "):
        file.write_text(small.replace("tonnes: 480", f"{only}tonnes: 480"))
        done = CliRunner().invoke(command, [HEISHAN, "--dispatch", str(file)], catch_exceptions=False)
        told = next(x for x in done.output.splitlines() if "order b" in x)
        assert done.exit_code == 0, done.output
        brought = float(told.split(" of 480 t")[0].rpartition(" ")[2])
        assert 480 <= brought < 540 and (not only or brought == 480), told


@pytest.mark.parametrize("track", ["260", "260.1"])
def test_trains_as_long_as_a_loading_place_permits_are_loaded(tmp_path: Path, track: str) -> None:
    """The longest that are let through stood with their rear on the points, and were never loaded."""
    (tmp_path / "heishan.yaml").write_text(Path(HEISHAN).read_text("utf-8").replace("260", track), "utf-8")
    text = Path("layouts/heishan.dispatch").read_text("utf-8")
    longest = f"length: {float(track) - MARGIN_M:.1f}"
    (tmp_path / "heishan.dispatch").write_text(text.replace("length: 60", longest), "utf-8")
    w = one(str(tmp_path / "heishan.yaml"), None, 0, Options(hours=1.0))
    assert w.trains > 1 and not any(w.wrong.counts().values())


THROUGH = """dispatch: 1
layout: pit_bottom
fleet: {11: {length: 80, speed: 12, at: out}}
places:
  out: {kind: waiting, at: W, capacity: 4}
  heavy: {kind: loading, at: q3_heavy, minutes: 10, ores: [coal]}
  man: {kind: loading, at: q13_man, minutes: 8, ores: [men]}
  east: {kind: tipping, at: E, minutes: 5}
  west: {kind: tipping, at: W, minutes: 5}
orders:
  a: {from: heavy, to: east, trains: 1, ore: coal}
  c: {from: man, to: west, trains: 1, ore: men}
"""
"""Trains for the second loading place run through the first."""


def test_a_loading_place_on_the_way_of_others_is_no_wrong_place(tmp_path: Path) -> None:
    file = tmp_path / "x.dispatch"
    file.write_text(THROUGH, "utf-8")
    w = one("layouts/pit_bottom.yaml", str(file), 0, Options(hours=1.5))
    through = [e for e in read(w.log).events if e["kind"] == "enters" and e["section"] == "q3_heavy"]
    assert w.tipped == {"a": 1, "c": 1} and len(through) == 2 and not any(w.wrong.counts().values())


def test_what_cannot_be_compared_is_told_with_its_place_below_what_was_run(tmp_path: Path) -> None:
    file = tmp_path / "x.dispatch"
    file.write_text(THROUGH, "utf-8")
    arguments = ["layouts/pit_bottom.yaml", "--dispatch", str(file), "--hours", "0.5", "--steady", "--optimum", "1"]
    done = CliRunner().invoke(command, arguments, catch_exceptions=False)
    assert done.exit_code == 1 and "trains tipped a shift:" in done.output and "standstills: 0" in done.output
    said = f"{file}:12:3: error[IL6012]: `--optimum` makes no plan of this: train 11 has several ways from q1 on for"
    assert said in done.output and "fix: leave out `--optimum`" in done.output and "Place(" not in done.output
    body = json.loads(CliRunner().invoke(command, [*arguments, "--format", "json"]).stdout)
    assert not body["ok"] and body["shifts"] and [d["code"] for d in body["diagnostics"]] == ["IL6012"]


def test_a_confidence_interval_of_trains_has_nothing_below_0() -> None:
    found = mean([0, 0, 7])
    assert found.value - found.half < 0 and found.least == 0
    sure = mean([6, 7, 7])
    assert sure.least == sure.value - sure.half > 0


def test_the_command_writes_records_and_tells_its_counts(tmp_path: Path) -> None:
    arguments = [HEISHAN, "--hours", "0.5", "--shifts", "2", "-o", str(tmp_path)]
    done = CliRunner().invoke(command, arguments, catch_exceptions=False)
    assert done.exit_code == 0 and "heishan: 4 trains, 2 shifts, seeds 0 to 1" in done.output
    assert "standstills: 0" in done.output and "confidence interval" in done.output
    first = (tmp_path / "heishan-1.log").read_bytes()
    again = CliRunner().invoke(command, [*arguments, "--format", "json"], catch_exceptions=False)
    assert again.exit_code == 0 and (tmp_path / "heishan-1.log").read_bytes() == first
    body = json.loads(again.stdout)
    assert [s["chain"] for s in body["shifts"]] == [read(Path(f).read_bytes()).chain.digest for f in body["files"]]
    (tmp_path / "heishan-1.log").write_text("another")
    done = CliRunner().invoke(command, arguments, catch_exceptions=False)
    assert done.exit_code == 1 and "another record" in done.output
    assert (tmp_path / "heishan-1.log").read_text() == "another"


def test_an_address_without_a_cluster_is_told() -> None:
    asked = [sys.executable, "-m", "interlock", "simulate", HEISHAN, "--dask", "tcp://127.0.0.1:9"]
    done = subprocess.run(asked, capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 1 and "no cluster at" in done.stderr and "Traceback" not in done.stderr
