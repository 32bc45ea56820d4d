"""Every scenario that the documents speak of is in the world of the proof: a run leads there."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scenarios import SCENARIOS, Scenario, run_to

PAGE = Path("proofs/scenarios.md")


@pytest.mark.parametrize("scenario", SCENARIOS, ids=lambda s: s.says)
def test_it_happens(scenario: Scenario) -> None:
    assert run_to(scenario) is not None


def test_the_page_tells_of_each() -> None:
    page = PAGE.read_text("utf-8")
    for number, scenario in enumerate(SCENARIOS, 1):
        assert f"## {number}. {scenario.says}\n" in page
    assert page.count("\n## ") == len(SCENARIOS) and "No run was found" not in page


def test_what_cannot_happen_is_not_found() -> None:
    assert (
        run_to(Scenario("Two trains come in at one end at once.", "fig2_3_split", ("head.B.SB", "head.D.SD"))) is None
    )
