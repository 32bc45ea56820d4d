"""Plans on sheets of A3 with match lines, and folded: everything is there once, and what goes on says where."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections import Counter
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app.init import line, yard
from interlock.cli.main import cli
from interlock.diag import Sink
from interlock.emit.drawing import Drawing, folded, place, sheets
from interlock.emit.drawing.sheets import HIGH, WIDE, Window, marks, windows
from interlock.frontend import load_text

SVG = "{http://www.w3.org/2000/svg}"


@cache
def drawn(text: str) -> Drawing:
    layout, _ = load_text("large.yaml", text, Sink())
    assert layout is not None
    return place(layout)


def names(page: ElementTree.Element) -> list[str]:
    paper = ("onward", "foot", "title")
    return [str(t.text) for t in page.iter(f"{SVG}text") if t.get("class") not in paper]


def onward(page: ElementTree.Element) -> list[str]:
    return [str(t.text) for t in page.iter(f"{SVG}text") if t.get("class") == "onward"]


@pytest.mark.parametrize("text", [yard(20), line(12)], ids=["yard", "line"])
def test_every_name_stands_on_one_sheet_and_every_track_is_drawn(text: str) -> None:
    d = drawn(text)
    pages = [ElementTree.fromstring(s) for s in sheets(d)]
    assert len(pages) == len(windows(d)) > 2
    assert Counter(n for p in pages for n in names(p)) == Counter(t.text for t in d.labels)
    tracks = {x.get("id") for p in pages for x in p.iter(f"{SVG}path") if str(x.get("id")).startswith("edge-")}
    assert tracks == {f"edge-{e.id}" for e in d.layout.track.edges}
    for p in pages:
        ids = [x.get("id") for x in p.iter() if x.get("id")]
        assert len(ids) == len(set(ids))
        assert (p.get("width"), p.get("height")) == ("420mm", "297mm")


def test_what_goes_on_is_told_on_both_sheets() -> None:
    d = drawn(yard(20))
    pages = [ElementTree.fromstring(s) for s in sheets(d)]
    there = {(k, *t.split(" \u2192 ")) for k, p in enumerate(pages, 1) for t in onward(p)}
    assert there
    for k, section, other in there:
        assert (int(other), section, str(k)) in there, (k, section, other)
    for w in windows(d):
        left, top, right, low = w.box
        assert right - left <= WIDE + 0.1 and low - top <= HIGH + 0.1


@pytest.mark.parametrize(("wide", "high"), [(WIDE, HIGH), (500, 150)])
@pytest.mark.parametrize("name", ["munkerod", "swtbahnfull"])
def test_every_track_that_goes_on_is_told_and_no_mark_lies_over_another(name: str, wide: float, high: float) -> None:
    d = drawn(Path(f"tests/stations/{name}.yaml").read_text("utf-8"))
    aside = 0
    for w in windows(d, wide, high):
        there = marks(d, w, "row ")
        assert Counter(m.text.split(" \u2192 ")[0] for m in there) == _cut(d, w)
        for i, m in enumerate(there):
            for other in there[i + 1 :]:
                (a, b, c, e), (p, q, r, s) = m.box, other.box
                assert c <= p or r <= a or e <= q or s <= b, (m.text, other.text)
        aside += sum(m.aside for m in there)
    assert aside or name != "munkerod"


def _cut(d: Drawing, w: Window) -> Counter[str]:
    """How often the lines of each section leave a window towards another one, counted from the lines alone."""
    left, top, right, low = w.box
    spots: dict[tuple[str, int, int], str] = {}
    for e in d.layout.track.edges:
        for (x0, y0), (x1, y1) in pairwise(d.edges[e.id]):
            for side, at in (("left", left), ("right", right)):
                if side in w.after and min(x0, x1) <= at <= max(x0, x1) and x0 != x1:
                    y = y0 + (y1 - y0) * (at - x0) / (x1 - x0)
                    if top <= y <= low:
                        spots[side + e.section, round(at), round(y)] = e.section
            for side, at in (("top", top), ("bottom", low)):
                if side in w.after and min(y0, y1) <= at <= max(y0, y1) and y0 != y1:
                    x = x0 + (x1 - x0) * (at - y0) / (y1 - y0)
                    if left <= x <= right:
                        spots[side + e.section, round(x), round(at)] = e.section
    return Counter(map(str, spots.values()))


def test_a_small_plan_is_one_sheet_without_match_lines() -> None:
    layout, _ = load_text("x.yaml", Path("layouts/passing_loop.yaml").read_text("utf-8"), Sink())
    assert layout is not None
    (page,) = sheets(place(layout))
    assert 'class="match"' not in page and '<tspan dx="24">Sheet 1 of 1</tspan>' in page, "set apart"


def test_a_line_is_folded_into_rows_no_wider_than_a_sheet() -> None:
    d = drawn(line(12))
    page = ElementTree.fromstring(folded(d))
    assert float(str(page.get("width"))) < WIDE + 230 < d.width
    ids = [x.get("id") for x in page.iter() if x.get("id")]
    assert len(ids) == len(set(ids))
    assert Counter(names(page)) == Counter(t.text for t in d.labels)
    rows = [str(t.text) for t in page.iter(f"{SVG}text") if str(t.text).startswith("row ")]
    assert len(rows) > 2 and len(onward(page)) >= 2 * (len(rows) - 1)


def test_draw_writes_sheets_and_folds(tmp_path: Path) -> None:
    source = tmp_path / "yard.yaml"
    source.write_text(yard(20), "utf-8")
    done = CliRunner().invoke(cli, ["draw", str(source), "--sheets", "-o", str(tmp_path / "p.svg")])
    assert done.exit_code == 0
    written = sorted(p.name for p in tmp_path.glob("p-*.svg"))
    assert len(written) == len(re.findall(r"p-\d+\.svg: \d+ bytes", done.output)) > 2
    assert not (tmp_path / "p.svg").exists()
    done = CliRunner().invoke(cli, ["draw", str(source), "--fold", "-o", str(tmp_path / "f.svg")])
    assert done.exit_code == 0 and "row 2" in (tmp_path / "f.svg").read_text("utf-8")
