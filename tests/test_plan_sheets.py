"""Plans on several sheets: what goes on at a match line is told, and a name stays with its symbol."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest

from interlock.diag import Sink
from interlock.emit.drawing import Drawing, place
from interlock.emit.drawing.sheets import marks, sheets, windows
from interlock.frontend import load


def drawn(name: str) -> Drawing:
    layout, _ = load(f"tests/stations/{name}.yaml", Sink())
    assert layout is not None
    return place(layout)


@pytest.mark.parametrize("name", ["edgware", "munkerod", "milton"])
def test_every_line_that_is_cut_is_marked_on_both_sheets(name: str) -> None:
    """Tracks outside a boundary, too: they ended at the match line without a word."""
    d = drawn(name)
    lines = [*d.edges.values(), *([d.at[n], tip] for n, tip, _ in d.outside)]
    cut = 0
    for w in windows(d):
        for side, at in (("left", w.box[0]), ("right", w.box[2])):
            if side not in w.after:
                continue
            told = {round(m.spot[1]) for m in marks(d, w, "") if abs(m.spot[0] - at) < 1}
            for (x0, y0), (x1, y1) in (s for line in lines for s in pairwise(line)):
                if min(x0, x1) < at < max(x0, x1):
                    y = y0 + (y1 - y0) * (at - x0) / (x1 - x0)
                    if w.box[1] <= y <= w.box[3]:
                        cut += 1
                        assert any(abs(y - t) <= 1 for t in told), (side, y)
    assert cut > 1


@pytest.mark.parametrize("name", ["edgware", "munkerod", "milton"])
def test_a_name_stands_on_the_sheet_of_its_symbol(name: str) -> None:
    d = drawn(name)
    pages = sheets(d)
    assert len(pages) > 1
    symbols = 0
    for page in pages:
        for kind, of in re.findall(
            r'<text class="(point|signal|boundary|buffer|crossing)"[^>]* data-of="([^"]*)"', page
        ):
            ids = f'id="{kind}-{of}"'.replace(" ", "\u00a0").replace("id=\u00a0", "id=")
            if any(ids in p for p in pages):  # a slip that one machine lays is named once
                symbols += 1
                assert ids in page, (kind, of)
    assert symbols > 30
