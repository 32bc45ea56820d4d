"""What leads out of a loop is known without running through the whole line from each of its points."""

from __future__ import annotations

import pytest

from interlock.app.init import line
from interlock.diag import Sink
from interlock.frontend import load_text
from interlock.frontend.checks.loops import _Exits, _ways
from interlock.model.elements import Position
from interlock.model.layout import Layout
from tests.grow_all import grow_all


def looked_at(layout: Layout) -> list[tuple[bool, bool]]:
    """Of each leg: whether it is said at once to lead out, and whether a search finds so."""
    exits, found = _Exits(layout), []
    for p in layout.pointwork.points:
        for x in Position:
            ways = _ways(layout, p, x)
            found.append((exits.leads_out(p, x), ways.ends or bool(ways.boundaries)))
    return found


@pytest.mark.parametrize("seed", range(60))
def test_what_is_said_at_once_a_search_finds(seed: int) -> None:
    layout, _ = load_text("grown.yaml", grow_all(seed), Sink())
    if layout is not None:
        assert [(quick, so) for quick, so in looked_at(layout) if quick and not so] == []


def test_of_a_line_everything_is_said_at_once() -> None:
    """No search from any of its points, each of which ran through the whole line."""
    layout, _ = load_text("line.yaml", line(30), Sink())
    assert layout is not None and all(quick for quick, _ in looked_at(layout))
