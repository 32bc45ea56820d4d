"""Trains in metres on the emitted runtime: no harm as shipped; every controller that is wrong as a class does harm."""

from __future__ import annotations

import pytest

from tests.campaigns.simulate import Case, drive
from tests.weakened import WEAKENED

SCANS = 12_000


@pytest.mark.parametrize("hostile", [False, True])
@pytest.mark.parametrize("name", ["fig2_3_split", "mine11", "passing_loop"])
def test_no_hazard_as_shipped(name: str, hostile: bool) -> None:
    outcome = drive(Case.of(f"layouts/{name}.yaml"), SCANS, 7, hostile)
    assert outcome.hazards == []
    assert outcome.passed_at_stop == []
    assert outcome.scans == SCANS and outcome.movements > 5


@pytest.mark.parametrize("kind", WEAKENED)
def test_each_class_of_wrong_controllers_comes_to_harm(kind: str) -> None:
    case = Case.of("layouts/mine11.yaml", kind)
    assert any(drive(case, SCANS, seed, True).hazards for seed in range(4))
