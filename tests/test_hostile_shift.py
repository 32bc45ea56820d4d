"""A hostile dispatcher harms nobody on the runtimes as shipped; on wrong ones it does."""

from __future__ import annotations

import pytest

from tests.campaigns.hostile_shift import Hostile, case_of, drive, path_of

SCANS = 6000


@pytest.mark.parametrize("name", ["mine11", "heishan", "pit_bottom", "two_loops"])
def test_nobody_is_harmed(name: str) -> None:
    found = drive(path_of(name), 0, SCANS // 2)
    assert found.hazards == [] and found.scans == SCANS // 2 and found.moves > 3 and found.trains > 5


@pytest.mark.parametrize(
    "kind",
    [
        "detection ignored",
        "locks ignored",
        "early release",
        "points moved while locked",
        "ungated grant",
        "signal not closed",
        "all signals clear",
        "driven both ways",
    ],
)
def test_a_wrong_controller_comes_to_harm(kind: str) -> None:
    assert Hostile(case_of(path_of("mine11"), kind), 1).run(SCANS).hazards


def test_the_same_seed_is_the_same_run() -> None:
    assert drive(path_of("mine11"), 3, 2000) == drive(path_of("mine11"), 3, 2000)
