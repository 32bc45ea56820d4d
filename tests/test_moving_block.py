"""Zones of moving trains, positions with a bound, and parameters that contradict one another."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

from interlock.dispatch.moving_block import (
    Margins,
    MovingTrain,
    Position,
    contradictions,
    free,
    gap_m,
    stops_before,
    too_close,
)

EXACT = Position(0.0, error_m=0.0, drift_ms=0.0)


def train(number: str, at: float, **how: object) -> MovingTrain:
    base = MovingTrain(number, replace(EXACT, at_m=at), 40.0, 1, 3.0)
    return replace(base, **how)  # type: ignore[arg-type]


def test_the_documents_contradiction_is_told() -> None:
    said = contradictions(Margins(), empty_limit_m=79, loaded_limit_m=60, length_m=40)
    assert said[0].startswith("a loaded train at its limit of 60 m with 70 m in front reaches 10 m past the fork")
    assert "reaches 21 m past the fork" in said[1]
    assert contradictions(Margins(standing=False), empty_limit_m=79, loaded_limit_m=60, length_m=40) == ()
    fits = contradictions(Margins(), empty_limit_m=79, loaded_limit_m=70, length_m=19)
    assert fits == (), "79 - 19 = 60"
    assert len(contradictions(Margins(), empty_limit_m=79, loaded_limit_m=70, length_m=19.1)) == 1


def test_hauled_and_propelled_trains_lie_on_different_sides_of_the_beacon() -> None:
    assert train("a", 100.0).body == (60.0, 100.0)
    assert train("a", 100.0, propelled=True).body == (100.0, 140.0)
    assert train("a", 100.0, direction=-1).body == (100.0, 140.0)


def test_margins_as_largest_or_as_sum() -> None:
    behind, ahead = train("a", 100.0), train("b", 205.0, loaded=True)
    assert gap_m(behind, ahead) == 65.0
    (found,) = too_close((behind, ahead), Margins())
    assert (found.gap_m, found.missing_m) == (65.0, 5.0)
    (found,) = too_close((behind, ahead), Margins(disjoint=True))
    assert found.missing_m == 65.0
    standing = replace(ahead, speed_ms=0.0)
    assert too_close((behind, standing), Margins(standing=False)) == ()


def test_braking_against_the_limit_points() -> None:
    slow, fast = train("a", 0.0, speed_ms=10 / 3.6), train("a", 0.0, speed_ms=25 / 3.6)
    assert stops_before(slow, 60.0) and not stops_before(fast, 60.0)
    assert not stops_before(train("a", 0.0, speed_ms=20 / 3.6, propelled=True), 79.0)


@pytest.mark.parametrize("seed", range(200))
def test_a_section_is_never_free_while_a_tail_may_be_in_it(seed: int) -> None:
    """A train with inertia between beacons: wherever it really is within the bound, it is in no section told free."""
    rng = Random(seed)
    real, believed, age = 0.0, 0.0, 0.0
    length = rng.uniform(20, 120)
    drift = rng.uniform(-1, 1)
    for _ in range(200):
        v = rng.uniform(0, 5)
        real += v
        believed += v + drift * 0.05
        age += 1.0
        if rng.random() < 0.05:
            believed, age = real + rng.uniform(-0.5, 0.5), 0.0
        t = MovingTrain("1", Position(believed, age), length, 1, v)
        for low in range(0, 800, 100):
            inside = real > low and real - length < low + 100
            assert not (free((low, low + 100), [t]) and inside)
    assert free((real + 100, real + 200), [t]) and free((real - length - 200, real - length - 100), [t])
