"""No line of a plan crosses another that it does not cross on the ground, and no name lies on a line or on a name.

Counted from the SVG by a checker that shares no code with the drawing; `tests/campaigns/plans.py` counts more.
"""

from __future__ import annotations

import json
import random
import re
import sys
from itertools import pairwise
from pathlib import Path
from types import FrameType

import pytest

from interlock.app.check import derive_file
from interlock.app.compile import build_derived
from interlock.app.draw import draw_file
from interlock.app.init import line, yard
from interlock.diag import Sink
from interlock.emit import drawing
from interlock.emit.drawing import opening, place, plan_svg
from interlock.emit.drawing.canvas import Box, entered, enters
from interlock.emit.drawing.embedding import SINK, SOURCE
from interlock.emit.drawing.slips import with_diamonds
from interlock.emit.drawing.strands import Plan
from interlock.emit.drawing.svg import OPENS
from interlock.emit.drawing.upward import joins, turned
from interlock.emit.report import player_html
from interlock.frontend import load, load_text
from interlock.model.layout import Layout
from tests.campaigns.plans import measured, random_layouts
from tests.grow import grow
from tests.layouts import SHIPPED
from tests.plans import examine
from tests.published import STATIONS

FIXED = [*(f"layouts/{n}.yaml" for n in SHIPPED), *map(str, sorted(Path("tests/layouts_for_tests").glob("*.yaml")))]
FIXED += [f"tests/stations/{n}.yaml" for n in STATIONS]
SPOILED = ("layouts/junction.yaml", "layouts/terminus.yaml")
BRIDGE = 12
"""Of the random layouts below, that whose tracks cannot lie in a plane: its plan crosses, and says so."""


def loaded(path: str) -> Layout:
    layout, _ = load(path, Sink())
    assert layout is not None
    return layout


@pytest.mark.parametrize("path", FIXED)
def test_fixed_layouts(path: str) -> None:
    found = examine(plan_svg(loaded(path)), loaded(path))
    assert found.clean, found


@pytest.mark.parametrize("text", [yard(20), yard(30), yard(50), yard(60), line(20)], ids=len)
def test_large_layouts(text: str) -> None:
    layout, _ = load_text("large.yaml", text, Sink())
    assert layout is not None
    counts, _, _, notes = measured(layout)
    assert not any(counts) and notes == ()


def _calls(text: str) -> int:
    """How many functions the drawing of a plan calls, those of networkx apart: on every machine the same."""
    layout, _ = load_text("large.yaml", text, Sink())
    assert layout is not None
    folder, count = str(Path(drawing.__file__).parent), 0

    def called(frame: FrameType, event: str, _: object) -> None:
        nonlocal count
        count += event in ("call", "c_call") and frame.f_code.co_filename.startswith(folder)

    before = sys.getprofile()
    sys.setprofile(called)
    try:
        plan_svg(layout, place(layout))
    finally:
        sys.setprofile(before)
    return count


def test_the_work_of_a_plan_grows_with_its_layout_and_not_with_its_square() -> None:
    """While every name was compared with every line, twice the stations took 3.4 times the calls."""
    assert _calls(line(40)) < 2.2 * _calls(line(20))


@pytest.mark.parametrize("text", [line(5), yard(12), *map(grow, range(8))], ids=len)
def test_names_that_lines_run_through_are_found_as_by_comparing_each_with_all(text: str) -> None:
    layout, _ = load_text("large.yaml", text, Sink())
    if layout is None:
        return
    d, rng = place(layout), random.Random(1)
    strokes, boxes = [s for track in d.edges.values() for s in pairwise(track)], list[Box]()
    for label in d.labels:
        for reach in (0, 5, 40, 200):
            boxes.append(label.moved(rng.uniform(-reach, reach), rng.uniform(-reach, reach)).box)
    found = {k for k, box in enumerate(boxes) if any(enters(a, b, box) for a, b in strokes)}
    assert entered(strokes, boxes) == found and 0 < len(found) < len(boxes)


def test_random_layouts() -> None:
    for seed, layout in random_layouts(30):
        counts, _, _, notes = measured(layout)
        if seed == BRIDGE:
            assert counts[0] > 0 and any("cross" in n for n in notes)
            covered = {name for name, _ in examine(plan_svg(layout), layout).on_lines}
            assert covered and {f"the name {x} lies over a line or symbol" for x in covered} <= set(notes)
        else:
            assert not any(counts) and notes == (), seed


def test_a_railway_in_rings_lies_flat_whatever_its_tracks_measure() -> None:
    """The turns come from an embedding, and lengths only say which of equals turn."""
    text = Path("tests/stations/swtbahnfull.yaml").read_text("utf-8")
    start, end = text.index("tracks:"), text.index("points:")
    alike = re.sub(r"(seg\w+) \d+", r"\1 10", text[start:end])
    layout, _ = load_text("alike.yaml", text[:start] + alike + text[end:], Sink())
    assert layout is not None
    counts, _, _, notes = measured(layout)
    assert not any(counts) and notes == ()
    assert len(turned(with_diamonds(layout)).cut.turns) == 6


def test_the_turns_of_a_station_without_rings_are_none() -> None:
    for text in (yard(20), line(5)):
        layout, _ = load_text("plain.yaml", text, Sink())
        assert layout is not None
        t = turned(layout)
        assert not t.cut.turns
        ends = joins(Plan(t.cut.layout), t)
        assert len(ends) == len(layout.track.boundaries) + len(layout.track.buffers)
        assert all((a == SOURCE) is not (b == SINK) for a, b in ends.values()), "every track comes in from outside"


def test_a_track_outside_that_another_crosses_is_seen() -> None:
    layout, _ = load_text("grown.yaml", grow(273), Sink())
    assert layout is not None
    counts, _, _, notes = measured(layout)
    assert not any(counts) and notes == ()


@pytest.mark.parametrize("path", SPOILED)
def test_the_checker_sees_what_is_drawn_wrong(path: str) -> None:
    """Each line moved onto another place, and each name onto a line, is found."""
    layout = loaded(path)
    svg = plan_svg(layout)
    tracks = re.findall(r'id="edge-[^"]*" class="track[^"]*" d="([^"]*)"', svg)
    (left, top), (right, low) = (0, 100), map(float, re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg).groups())  # type: ignore[union-attr]
    across = f"M{left} {top} L{right} {low}"
    assert all(examine(svg.replace(f'd="{t}"', f'd="{across}"'), layout).crossings for t in tracks)
    x, y = re.findall(r"([-\d.]+) ([-\d.]+)", tracks[0])[0]
    moved = re.sub(r'(<text class="section"[^>]*) x="[^"]*" y="[^"]*"', rf'\1 x="{x}" y="{float(y) + 3}"', svg)
    found = examine(moved, layout)
    assert found.on_lines and found.on_names
    sections = re.findall(r'<text class="section" data-of="([^"]*)"', svg)
    strayed = re.sub(r'(<text class="section") data-of="[^"]*"', lambda m: f'{m[1]} data-of="{sections.pop()}"', svg)
    assert len(examine(strayed, layout).astray) > 3


def test_what_a_plan_cannot_show_is_told_by_draw_and_compile(tmp_path: Path) -> None:
    path = tmp_path / "passing_loop.yaml"  # a hint of the layout wins, even a bad one
    path.write_text(Path("layouts/passing_loop.yaml").read_text("utf-8") + "drawing: {1DG: 1}\n", "utf-8")
    assert any("cross" in note for note in draw_file(str(path)).notes)
    proved, _ = build_derived(derive_file(str(path)))
    assert [d.code for d in proved.notes if d.code == "IL5008"]
    assert not [d for d in build_derived(derive_file("layouts/fig2_2.yaml"))[0].notes if d.code == "IL5008"]


def test_a_plan_larger_than_a_screen_says_where_its_lines_come_in() -> None:
    layout, _ = load_text("yard.yaml", yard(30), Sink())
    assert layout is not None
    svg = plan_svg(layout)
    told = re.search(r'data-start="([-\d.]+) ([-\d.]+)"', svg)
    assert told is not None and re.search(rf'id="section-apW1".* L{told[1]} {told[2]}"', svg)
    assert "scrollTo" in opening(svg) and opening(svg).replace(OPENS, "") == svg
    state = {"#meta": {"text": "a train comes"}}  # a page that holds it, as that of a counterexample, moves it itself
    trace = {"#meta": {"plan": svg, "views": {}}, "vars": [], "states": [state]}
    assert svg.splitlines()[-2] in player_html(json.dumps(trace))
    small = plan_svg(loaded("layouts/cn6502.yaml"))
    assert "data-start" not in small and "<script" not in opening(small)


def test_what_cannot_lie_in_a_plane_is_drawn_whole() -> None:
    """A line led out of the picture at its top."""
    layout = dict(random_layouts(12))[BRIDGE]
    d = place(layout)
    assert all(0 <= x <= d.width and 0 <= y <= d.height for line in d.edges.values() for x, y in line)
