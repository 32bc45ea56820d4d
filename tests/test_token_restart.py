"""A power cut may come at any moment: the proof begins with all that the line and the neighbour can be then (R12)."""

from __future__ import annotations

import pytest

from interlock.logic.expr import disj
from interlock.logic.plant.block import at_a_restart, outside
from interlock.logic.plant.words import line, o
from interlock.proof.claims.kinds import Claim
from interlock.proof.induction.search import search
from interlock.proof.system.transition import System
from tests.layouts import built


@pytest.mark.parametrize("name", ["token", "token_one_track"])
def test_nothing_that_can_come_about_is_left_out_of_the_restart(name: str) -> None:
    """He gives the direction, we take it, and our train leaves before he has heard of it: a power cut there began a run
    that was not proved."""
    layout, _, controller = built(f"../tests/layouts_for_tests/{name}")
    system = System(layout, controller)
    for b in layout.track.boundaries:
        if b.node not in controller.symbols.token:
            continue
        kept = at_a_restart(b.node, disj((line(b.node, "in"), o(outside(b)))))
        run = search(system, [Claim("restart", f"{b.node} {k}", x) for k, x in enumerate(kept)], 12, 120)
        assert run is None
