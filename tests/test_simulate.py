"""Trains in metres on the emitted runtime: no harm as shipped; every controller that is wrong as a class does harm."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest

from interlock.simulate.faults import Faults
from interlock.simulate.local_rules import power_cut
from interlock.simulate.run import load
from interlock.simulate.track import Track
from interlock.simulate.train import Driver, Train
from interlock.simulate.world import World
from tests.campaigns.simulate import Case, drive
from tests.weakened import WEAKENED

SCANS = 5000
SHIPPED_SCANS = 12_000


@pytest.mark.parametrize("hostile", [False, True])
@pytest.mark.parametrize("name", ["fig2_3_split", "mine11", "passing_loop", "junction"])
def test_no_hazard_as_shipped(name: str, hostile: bool) -> None:
    outcome = drive(Case.of(f"layouts/{name}.yaml"), SHIPPED_SCANS, 7, hostile)
    assert outcome.hazards == []
    assert outcome.passed_at_stop == []
    assert outcome.scans == SHIPPED_SCANS and outcome.movements > 5


MANY_CUTS = Faults(power=0.002)
"""Power cuts so often that some come while trains run."""

HARM = {
    "locks ignored": ("mine11", 0),
    "detection ignored": ("mine11", 0),
    "early release": ("mine11", 0),
    "ungated grant": ("mine11", 0),
    "points moved while locked": ("mine11", 0),
    "cancel without delay": ("passing_loop", 10),
    "signal not closed": ("mine11", 0),
    "points wired the wrong way round": ("mine11", 0),
    "lamps swapped": ("mine11", 0),
    "all signals clear": ("mine11", 0),
    "stop beside proceed": ("mine11", 0),
    "driven both ways": ("mine11", 0),
    "clear before stop": ("junction", 1),
    "delay from setting": ("mine11", 2),
    "delay always running": ("pit_bottom", 0),
    "presets of a millisecond": ("junction", 6),
    "one clear reading": ("junction", 4),
    "restart without delay": ("mine11", 1),
    "overlap ignored": ("slip_junction", 0),
    "points not detected": ("mine11", 3),
    "trailing forgotten": ("depot", 6),
    "blocks ignored": ("mine11", 2),
    "conditions ignored": ("incline_hoist", 10),
    "lost inputs ignored": ("depot", 18),
    "health ignored": ("pit_bottom", 2),
    "devices count as closed": ("flank_lab", 5),
    "zone never full": ("heishan", 7),
    "direction always given": ("passing_loop", 1),
}
"""For each class a layout and the seed of a run with harm; even seeds have a hostile operator."""


@pytest.mark.parametrize("kind", HARM)
def test_each_class_of_wrong_controllers_comes_to_harm(kind: str) -> None:
    name, seed = HARM[kind]
    faults = MANY_CUTS if kind == "restart without delay" else None
    assert drive(Case.of(f"layouts/{name}.yaml", kind), SCANS, seed, seed % 2 == 0, faults).hazards


def test_many_power_cuts_harm_nobody() -> None:
    """Those that harm somebody where sections are released at once after a restart."""
    case, cuts = Case.of(f"layouts/{HARM['restart without delay'][0]}.yaml"), 0
    for seed in (1, 3, 4, 18):
        outcome = drive(case, SCANS, seed, seed % 2 == 0, MANY_CUTS)
        assert outcome.hazards == []
        cuts += outcome.power_cuts
    assert cuts > 5


def test_points_that_were_trailed_before_a_power_cut_are_looked_at_before_sections_are_released() -> None:
    """The controller has forgotten them: their contacts met again, a train was called over them, and derailed (R10)."""
    case = Case.of("layouts/terminus.yaml")
    track, names = Track.of(case.layout), load(case.runtime)
    world = World(case.layout, track, names["INPUTS"], names["OUTPUTS"], Random(1), Faults())
    machines = world.machines
    machines.damage(0, 9.0)
    assert machines.lies[0] not in (0, 1)
    power_cut(world)
    assert not machines.damaged and machines.lies[0] == machines.position[0]


@pytest.mark.parametrize(("seed", "hostile"), [(0, True), (5, False)])
def test_whoever_overruns_a_signal_stops_before_the_next_one(seed: int, hostile: bool) -> None:
    """A successive overlap has no length, and ends at the next signal (R4, A-OVERRUN): trains ran on for 400 m."""
    case = Case.of("tests/layouts_for_tests/overlap_berth.yaml")
    assert drive(case, SCANS, seed, hostile).hazards == []


def test_every_class_has_its_run() -> None:
    assert set(HARM) == set(WEAKENED)


def test_a_train_comes_no_faster_than_it_can_stop_before_the_first_signal(tmp_path: Path) -> None:
    """A hundred metres of approach, and a signal at stop behind it: its driver knows the line."""
    text = Path("tests/layouts_for_tests/called_on_face_to_face.yaml").read_text("utf-8")
    fast = tmp_path / "fast.yaml"
    fast.write_text(text.replace("boundaries:", "principles: {line_speed_kmh: 120}\nboundaries:"), "utf-8")
    case = Case.of(str(fast))
    track, names = Track.of(case.layout), load(case.runtime)
    world = World(case.layout, track, names["INPUTS"], names["OUTPUTS"], Random(1), Faults())
    for _ in range(100):
        world.trains.clear()
        world.traffic.come(10.0)
        for t in world.trains:
            here = track.stretches[t.body[0]].metres - t.head + 100.0
            assert t.speed > 0 and t.speed**2 / (2 * t.handling.brakes) <= here - t.handling.margin + 1e-9
    assert world.traffic.numbers > 50


@pytest.mark.parametrize(("tail", "harm"), [("l2", True), ("g1", False)])
def test_the_simulator_sees_a_shunting_movement_before_a_train_that_is_still_running_in(tail: str, harm: bool) -> None:
    """In a berth, towards a train that is wholly in, on sight; towards one that is not, never (T-COLLISION)."""
    case = Case.of("tests/layouts_for_tests/shunt_yard.yaml")
    track, runtime = Track.of(case.layout), load(case.runtime)
    world = World(case.layout, track, runtime["INPUTS"], runtime["OUTPUTS"], Random(1), Faults())
    section = track.sections.index("g1")
    along = {track.sections[s.section]: d for d, s in reversed(list(enumerate(track.stretches))) if not s.outside}
    train = Train(1, [along[tail], along["g1"]], 50.0, 10.0, speed=5.0, driver=Driver(called=True))
    shunted = Train(2, [along["p1"]], 1.0, 0.0, speed=2.0, driver=Driver(called=True, shunting=True))
    for t in (train, shunted):
        t.under.looks(track, t.body)
    world.trains[:] = [train, shunted]
    world.watch.comes_in(world, shunted, section)
    assert bool(world.watch.found) is harm
