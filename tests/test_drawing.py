"""The track plan: everything drawn once, joined where the layout joins, no name over another, the same bytes always."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections import Counter
from itertools import pairwise
from pathlib import Path

import pytest
from click.testing import CliRunner

from interlock.app.check import check_file
from interlock.cli.main import cli
from interlock.diag import Sink
from interlock.emit.drawing import Drawing, place, plan_svg
from interlock.emit.drawing.canvas import arrow, device_spots, enters
from interlock.emit.drawing.slips import CHORDS, blades, double_slips
from interlock.frontend import load_text
from interlock.logic.controller import Controller
from interlock.logic.lower import lower
from interlock.model.elements import BufferKind, EdgeId, SectionId
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable
from tests.grow import grow
from tests.grow_all import grow_all
from tests.layouts import SHIPPED, SLIPS, built
from tests.plans import examine

SVG = "{http://www.w3.org/2000/svg}"


def _boxes_meet(d: Drawing) -> list[tuple[str, str]]:
    boxes = [(t.text, t.box) for t in d.labels]
    return [
        (s, t)
        for i, (s, a) in enumerate(boxes)
        for t, b in boxes[i + 1 :]
        if a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
    ]


def _check(layout: Layout, d: Drawing) -> None:
    assert _boxes_meet(d) == []
    assert set(d.edges) == {e.id for e in layout.track.edges}
    for e in layout.track.edges:
        line = d.edges[e.id]
        ends = {(round(x, 3), round(y, 3)) for x, y in (line[0], line[-1])}
        wanted = {(round(d.at[n][0], 3), round(d.at[n][1], 3)) for n in (e.a, e.b)}
        assert ends == wanted, e.id  # joined where the layout joins
        if not any("~turn" in n for n in d.plan.turns):
            assert all(a[0] <= b[0] + 1e-6 for a, b in pairwise(line)), e.id  # never back
    drawn = plan_svg(layout, d)
    root = ElementTree.fromstring(drawn)
    ids = [x.get("id") for x in root.iter() if x.get("id")]
    assert len(ids) == len(set(ids))
    wanted_ids = {f"edge-{e.id}" for e in layout.track.edges} | {f"point-{p.id}" for p in layout.pointwork.points}
    wanted_ids |= {f"signal-{g.id}" for g in (*layout.signalling.signals, *layout.signalling.distants)}
    wanted_ids |= {f"boundary-{b.node}" for b in layout.track.boundaries} | {
        f"buffer-{b.node}" for b in layout.track.buffers
    }
    wanted_ids |= {f"crossing-{c.id}" for c in layout.pointwork.crossings} | {
        f"device-{x.id}" for x in layout.signalling.devices
    }
    wanted_ids |= {f"section-{s.id}" for s in layout.track.sections}
    assert wanted_ids <= set(ids), wanted_ids - set(ids)
    names = {x.text for x in root.iter(f"{SVG}text")}
    names |= {str(x.text).split(" (")[0] for x in root.iter(f"{SVG}text") if x.get("class") == "point"}
    shared = {
        b.point
        for b in layout.pointwork.blades
        if sum(p.machine == layout.pointwork.point[b.point].machine for p in layout.pointwork.points) > 2
    }
    assert {s.id for s in layout.track.sections} | {
        p.machine if p.id in shared else p.id for p in layout.pointwork.points
    } <= names
    assert {g.id for g in layout.signalling.signals} <= names
    told = {x.get("data-of"): str(x.text) for x in root.iter(f"{SVG}text") if x.get("class") == "boundary"}
    for b in layout.track.boundaries:  # by its label, and by the id that routes have
        label = layout.printed.labels.get(b.node, b.node)
        assert told[b.node] in (label, f"{label} ({b.node})") and b.node in told[b.node]
    assert {str(c.id) for c in layout.pointwork.crossings if c.node not in d.plan.slips} <= names


@pytest.mark.parametrize("name", SHIPPED)
def test_every_shipped_layout_is_drawn_whole(name: str) -> None:
    layout, _, _ = built(name)
    d = place(layout)
    assert d.notes == []
    _check(layout, d)


@pytest.mark.parametrize("name", SHIPPED)
def test_the_same_layout_gives_the_same_bytes(name: str) -> None:
    layout, _, _ = built(name)
    assert plan_svg(layout) == plan_svg(layout)
    assert Path(f"generated/{name}/plan.svg").read_text("utf-8") == plan_svg(layout)


@pytest.mark.parametrize("name", SHIPPED)
def test_signals_stand_on_the_left_of_their_track_and_in_germany_on_the_right(name: str) -> None:
    layout, _, _ = built(name)
    root = ElementTree.fromstring(plan_svg(layout))
    d = place(layout)
    for g in layout.signalling.signals:
        mast = next(x for x in root.iter(f"{SVG}g") if x.get("id") == f"signal-{g.id}").find(f"{SVG}path")
        assert mast is not None
        ys = [float(y) for y in re.findall(r"[ML][-\d.]+ ([-\d.]+)", mast.get("d", ""))]
        to_the_right = d.edges[g.into][0] == d.at[g.node]
        above = max(ys) < d.at[g.node][1] + 1
        assert above is (to_the_right is (layout.profile != "de")), g.id


def test_a_scissors_lies_between_its_tracks_and_a_derailer_on_its_track() -> None:
    layout, _, _ = built("terminus")
    d = place(layout)
    middle = d.at[layout.pointwork.crossings[0].node]
    ends = sorted({d.at[p.node][1] for p in layout.pointwork.points if p.id.startswith(("201", "202"))})
    assert len(ends) == 2 and middle[1] == sum(ends) / 2
    layout, _, _ = built("depot")
    d = place(layout)
    for p in layout.pointwork.points:
        if p.derailer:
            assert d.edges[p.toe][-1][1] == d.at[p.node][1] and d.edges[p.reverse][-1][1] == d.at[p.node][1]
    assert sum(b.kind is BufferKind.DERAIL for b in layout.track.buffers) == 3


def test_layouts_that_grow_at_random_are_drawn_whole() -> None:
    drawn = 0
    for seed in range(50):
        layout, _ = load_text("grown.yaml", grow(seed), Sink())
        if layout is None:
            continue
        d = place(layout)
        assert set(d.edges) == {e.id for e in layout.track.edges}
        assert ElementTree.fromstring(plan_svg(layout, d)) is not None
        if not d.notes:
            _check(layout, d)
            drawn += 1
    assert drawn >= 30


def _turned(d: Drawing) -> EdgeId | None:
    """The edge on which the track turns back."""
    return next((e for e, line in d.edges.items() if len({a[0] < b[0] for a, b in pairwise(line)}) == 2), None)


def test_a_layout_that_runs_back_into_itself_is_drawn_and_not_refused() -> None:
    text = """
interlock: 1
name: balloon
boundaries: {W: {approach: ap 100}}
tracks:
  west: [W, a 100]
  loop: [b 100, c 100]
points:
  P: {section: p, toe: west.end, normal: loop.start, reverse: loop.end}
signals:
  X: {from: W, into: a}
  Y: {from: b, into: c}
  Z: {from: c, into: p}
"""
    layout, _ = load_text("balloon.yaml", text, Sink())
    assert layout is not None
    d = place(layout)
    assert set(d.edges) == {e.id for e in layout.track.edges} and plan_svg(layout, d).startswith("<svg")
    assert d.notes == [] and examine(plan_svg(layout, d), layout).clean
    assert _turned(d) is not None  # it goes out to one side and comes back: an arc


def test_names_with_anything_in_them_do_not_break_the_drawing() -> None:
    sink = Sink()
    with open("layouts/fig2_2.yaml", encoding="utf-8") as f:
        text = f.read()
    title = '"<script>alert(1)</script> & co"'
    text = re.sub(r"(?m)^title:.*$", f"title: {title}", text)
    layout, _ = load_text("x.yaml", text, sink)
    assert layout is not None
    drawn = plan_svg(layout)
    assert "<script" not in drawn and ElementTree.fromstring(drawn) is not None


@pytest.mark.parametrize("name", ["mine11", "slip_junction", "depot", "flank_lab"])
def test_no_fouling_mark_stands_before_a_length_as_if_it_multiplied_it(name: str) -> None:
    svg = plan_svg(built(name)[0])
    crosses = [(float(x) + 2.5, float(y) + 2.5) for x, y in re.findall(r'class="foul" d="M([\d.]+) ([\d.]+) l5 5', svg)]
    lengths = re.findall(r'<text class="length"[^>]* x="([\d.]+)" y="([\d.]+)">([^<]*)', svg)
    assert crosses and lengths
    for x, y, text in ((float(x), float(y), text) for x, y, text in lengths):
        near = [c for c in crosses if abs(c[1] - y + 3) < 7 and abs(c[0] - x) < 2.9 * len(text) + 6]
        assert not near, (text, x, y, near)


def test_a_hint_of_the_layout_wins() -> None:
    with open("layouts/mine11.yaml", encoding="utf-8") as f:
        text = f.read()

    def height(extra: str) -> float:
        layout, _ = load_text("mine11.yaml", text + extra, Sink())
        assert layout is not None
        d = place(layout)
        _check(layout, d)
        return (
            d.edges[next(e.id for e in layout.track.edges if e.section == "q6")][0][1]
            - d.at[layout.pointwork.points[0].node][1]
        )

    assert height("") == 84 and height("drawing: {q6: 1}\n") == -84 and height("drawing: {q6: -2}\n") == 168
    sink = Sink()
    assert load_text("mine11.yaml", text + "drawing: {q66: 1, q6: up}\n", sink)[0] is None
    assert {d.code for d in sink.diagnostics} == {"IL1013"}
    sink = Sink()
    assert load_text("mine11.yaml", text + "drawing: {q66: 1}\n", sink)[0] is None
    assert {d.code for d in sink.diagnostics} == {"IL2004"}


def test_draw_writes_a_file_or_tells_why_not(tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("draw")
    done = CliRunner().invoke(cli, ["draw", "layouts/junction.yaml", "-o", str(folder / "j.svg")])
    written = (folder / "j.svg").read_text("utf-8")
    assert done.exit_code == 0 and written.startswith(plan_svg(built("junction")[0]))
    assert "written by interlock" in written.splitlines()[-1]
    broken = CliRunner().invoke(cli, ["draw", "tests/diagnostics/IL2004.yaml", "-o", str(folder / "k.svg")])
    assert broken.exit_code == 1 and "IL2004" in broken.output and not (folder / "k.svg").exists()
    nowhere = CliRunner().invoke(cli, ["draw", "layouts/junction.yaml", "-o", str(folder / "no" / "j.svg")])
    assert nowhere.exit_code == 1 and "Traceback" not in nowhere.output


def _slip(said: str) -> tuple[Layout, Drawing]:
    layout, _ = load_text("slips.yaml", SLIPS % said, Sink())
    assert layout is not None
    d = place(layout)
    _check(layout, d)
    assert examine(plan_svg(layout, d), layout).clean and d.notes == []
    return layout, d


@pytest.mark.parametrize(
    ("said", "ends"),
    [
        ("", {"7a": ("1b", "2b"), "7b": ("1a", "2a")}),
        (", blades: near", {"7a": ("1a", "2a"), "7b": ("1b", "2b")}),
        (", single: 1a-2b", {"7a": ("1a",), "7b": ("2b",)}),
        (", single: 2a-1b", {"7a": ("2a",), "7b": ("1b",)}),
        (", machines: [7]", {f"7/{end}": (end,) for end in ("1a", "1b", "2a", "2b")}),
    ],
)
def test_a_name_of_a_slip_stands_where_its_blades_lie(said: str, ends: dict[str, tuple[str, ...]]) -> None:
    layout, d = _slip(said)
    labels = {t.text: t for t in d.labels}
    spots = [d.at[p.node] for p in layout.pointwork.points]
    middle = sum(x for x, _ in spots) / len(spots)
    leftward = {end[1] for end in ("1a", "1b") if _outer_end(layout, d, end)[0] < middle}
    assert len(leftward) == 1
    if "machines" in said:  # one machine lays them all: it is named once
        assert [t.text for t in d.labels if t.kind == "point"] == ["7"]
    else:
        for name, own in ends.items():
            assert ({end[1] for end in own} == leftward) is (labels[name].x < middle), name
    marks = {
        p: re.search(rf'<g id="point-{p}" class="point"[^>]*><title>(.*?)</title>', plan_svg(layout, d)) for p in ends
    }
    for name, found in marks.items():
        assert found is not None and f"blades at {' and '.join(ends[name])}, N to" in found[1]


def _outer_end(layout: Layout, d: Drawing, end: str) -> tuple[float, float]:
    """Where the track begins that an end of slip 7 is joined to."""
    e = layout.track.edge[EdgeId(f"7.{end}")]
    return d.at[e.a if e.a in d.at and "@" in e.a else e.b]


def _written(spot: tuple[float, float]) -> str:
    return " ".join(f"{x:.1f}".rstrip("0").rstrip(".") for x in spot)


def test_a_slip_with_a_diamond_is_one_symbol() -> None:
    """All blades within a diamond's reach, slip rails between those that they join, arms that cross."""
    for said, rails in ((", single: 1a-2b", 1), (", machines: [7]", 2)):
        layout, d = _slip(said)
        (x, y) = d.at[layout.pointwork.crossings[0].node]
        spots = [d.at[p.node] for p in layout.pointwork.points]
        assert all(0 < abs(a - x) <= 41 and abs(b - y) <= 41 for a, b in spots)
        assert len(d.plan.rails) == rails
        for rail in d.plan.rails:
            (x0, _), (x1, _) = d.edges[rail]
            assert x0 < x < x1  # a slip leads on, never back


@pytest.mark.parametrize("said", ["", ", blades: near", ", machines: [7L, 7R]"])
def test_a_double_slip_with_two_machines_has_four_blades_that_lie_as_their_machines(said: str) -> None:
    layout, d = _slip(said)
    (slip,) = double_slips(layout)
    there = list(blades(d, slip))
    x = (d.at[slip.nodes[0]][0] + d.at[slip.nodes[1]][0]) / 2
    told = {b.point: b for b in layout.pointwork.blades}
    tips = {end: _outer_end(layout, d, end) for end in ("1a", "1b", "2a", "2b")}
    assert {tips[e][0] < x for e in ("1a", "2a")} == {tips["1a"][0] < x} != {tips["1b"][0] < x}
    assert (tips["2a"][1] < tips["1a"][1]) is (tips["2b"][1] > tips["1b"][1]), "its arms cross"
    assert Counter(b.point for b in there) == dict.fromkeys(told, 2)
    ends = [end for b in slip.blades for end in b.at]
    for b, end in zip(there, ends, strict=True):
        assert abs(b.at[0] - x) < 42 and (b.at[0] < x) is (tips[end][0] < x)
        for normal, to in ((True, told[b.point].normal), (False, told[b.point].reverse)):
            leads = b.towards(normal)  # straight on over the diamond, or over the slip rail to the blades across
            assert (leads == b.arm) is (to[0] == end[0]), (end, to)
            assert leads in (b.arm, next(o.at for o, e in zip(there, ends, strict=True) if e == CHORDS[end]))
    svg = plan_svg(layout, d)
    joins = r'data-from="7.(..)" data-to="7.(..)" data-past="([^"]*)"'
    joined = re.findall(rf'<path id="rail-[^"]*" class="track rail" {joins} d="(.*?)"', svg)
    assert sorted(x[:2] for x in joined) == [("1a", "2b"), ("1b", "2a")]
    assert {x[2] for x in joined} == {str(layout.pointwork.point[p].toe) for p in told}, "the middle of the diamond"
    arms = dict(re.findall(r'<path id="arm-7.(..)" class="track arm" d="(.*?)"', svg))
    for one, other, _, rail in joined:
        begins, ends_at = rail.removeprefix("M").split(" L")
        assert [arms[x].removeprefix("M").split(" L")[0] for x in (one, other)] == [begins, ends_at]
    for end, line in arms.items():
        assert line.split(" L")[-1] == _written(_outer_end(layout, d, end)), "no part of an arm lies within the diamond"
    for p in told:
        assert re.search(rf'<g id="point-{p}" class="point" data-n="M[^"]* M[^"]*" data-r="M[^"]* M', svg)


def test_of_a_three_way_point_both_machines_are_named() -> None:
    text = """interlock: 1
name: threeway
boundaries: {A: {approach: aa 300}, B: {trains: out}, C: {trains: out}, D: {trains: out}}
tracks: {a: [A, a1 200], b: [b1 200, B], c: [c1 200, C], d: [d1 200, D]}
points:
  1: {section: T, toe: a.end, normal: 2.toe, reverse: c.start, legs: 6}
  2: {section: T, normal: b.start, reverse: d.start, legs: 20}
signals:
  SA: {from: A, into: a1}
"""
    layout, _ = load_text("threeway.yaml", text, Sink())
    assert layout is not None
    d = place(layout)
    _check(layout, d)
    assert examine(plan_svg(layout, d), layout).clean
    labels = {t.text: t for t in d.labels if t.kind == "point"}
    one, two = (d.at[layout.pointwork.point[p].node] for p in layout.pointwork.point)
    assert abs(labels["1"].x - one[0]) < 40 and abs(labels["2"].x - two[0]) < 40
    up, down = sorted(d.at[n.node][1] for n in layout.track.boundaries if n.node in "CD")
    assert up < one[1] == two[1] < down, "its two curved ways lie on either side of the straight one"


LOOP = """interlock: 1
name: loop
boundaries: {W: {approach: aw 600, xy: [0, 300]}, E: {approach: ae 600}}
buffers: [B]
tracks: {west: [W, w1 200], main: [m1 300], side: [s2 300], east: [e1 250, E], dead: [d1 100, B]}
points:
  1: {section: T1, toe: west.end, normal: main.start, reverse: side.start, xy: [400, 300]}
  2: {section: T2, toe: 3.toe, normal: main.end, reverse: side.end}
  3: {section: T2, normal: east.start, reverse: dead.start, xy: [1000, 120]}
signals:
  A: {from: W, into: w1}
  C: {from: E, into: e1, xy: [1500, 150]}
  N1: {from: m1, into: T2, xy: [700, 180]}
"""


def test_what_has_coordinates_keeps_them_and_the_rest_moves_along() -> None:
    layout, _ = load_text("loop.yaml", LOOP, Sink())
    assert layout is not None
    d = place(layout)
    nodes = {"W": (0, 300), "1": (400, 300), "3": (1000, 120), "E": (1500, 150)}
    nodes[layout.signalling.signal["N1"].node] = (700, 180)  # type: ignore[index]
    (x0, y0) = d.at["W"]  # type: ignore[index]
    for n, (x, y) in nodes.items():
        assert d.at[n] == pytest.approx((x0 + x, y0 + y - 300)), n  # type: ignore[index]
    _check(layout, d)
    assert examine(plan_svg(layout, d), layout).clean and d.notes == []
    one, two, three = (d.at[layout.pointwork.point[p].node] for p in layout.pointwork.point)
    assert one[0] < two[0] < three[0], "what has none lies between its neighbours"
    assert layout.digest != load_text("loop.yaml", LOOP.replace(", xy: [400, 300]", ""), Sink())[0].digest  # type: ignore[union-attr]
    assert layout.bare.printed.anchors == (), "no proof depends on places on the plan"


def test_two_elements_in_one_place_have_one_pair_of_coordinates() -> None:
    sink = Sink()
    wrong = LOOP.replace("A: {from: W, into: w1", "A: {from: W, into: w1, xy: [0, 301]")
    assert load_text("loop.yaml", wrong, sink)[0] is None
    assert [d.code for d in sink.diagnostics if d.severity == "error"] == ["IL3030"]
    assert load_text("loop.yaml", wrong.replace("301", "300"), Sink())[0] is not None


def test_doors_stand_clear_of_the_signals_before_them_and_names_clear_of_distant_signals() -> None:
    text = Path("tests/layouts_for_tests/air_lock.yaml").read_text("utf-8")
    layout, _ = load_text("lock.yaml", f"{text}distants:\n  DX: {{of: X1}}\n  DY: {{of: Y1}}\n", Sink())
    assert layout is not None
    d = place(layout)
    for device in layout.signalling.devices:
        ((x, _),) = device_spots(d, device.over)
        joints = [d.at[g.node][0] for g in layout.signalling.signals if layout.track.section_of(g.into) in device.over]
        assert len(joints) == 2 and min(abs(x - at) for at in joints) > 9, "the frame is 18 pixels wide"
    for x, y, ahead in d.distants.values():
        mark = (x - 5, y - 19, x + 5, y) if ahead else (x - 5, y, x + 5, y + 19)
        assert not [
            t.text
            for t in d.labels
            if t.box[0] < mark[2] and mark[0] < t.box[2] and t.box[1] < mark[3] - 1 and mark[1] + 1 < t.box[3]
        ]


CROWDED = """interlock: 1
name: crowded
boundaries: {W: {approach: UA 600}, E: {approach: e0 600}}
tracks: {t: [W, D1 400, T1 150, R5 200, K1 60, K2 150, E]}
interlocks: {DOOR2: {over: [R5]}}
level_crossings: {LX2: {over: [K1]}}
signals: {1: {from: W, into: D1}, 2: {from: D1, into: T1}, 5: {from: E, into: K2}}
distants: {1R: {of: 1}, 2R: {of: 2}, 5R: {of: 5}}
sections: {T1: {one_way: forward}}
"""


def test_names_stand_apart_from_each_other_and_from_every_symbol() -> None:
    """Two were read as one; a distant, an arrow or the frame of a door stood on what was written."""
    layout, _ = load_text("x.yaml", CROWDED, sink := Sink())
    assert layout is not None, sink.diagnostics
    d = place(layout)
    assert _boxes_meet(d) == [] and not d.notes
    wider = [(t.text, (t.box[0] - 2, t.box[1], t.box[2] + 2, t.box[3])) for t in d.labels]
    marks = [(x - 5, y, x + 5, y + 19) for x, y, ahead in d.distants.values() if not ahead]
    marks += [(x - 5, y - 19, x + 5, y) for x, y, ahead in d.distants.values() if ahead]
    marks += [
        (x - 6, y - 5, x + 6, y + 5) for (x, y), _ in [arrow(d, EdgeId(e.id)) for e in layout.track.edges if e.one_way]
    ]
    marks += [(x - 9, y - 9, x + 9, y + 9) for x, y in device_spots(d, (SectionId("R5"),))]
    for k, (name, a) in enumerate(wider):
        those = [*marks, *(b for _, b in wider[k + 1 :])]
        over = [b for b in those if a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]]
        assert over == [], name


@pytest.mark.parametrize("name", ["depot", "crossing_line", "flank_lab"])
def test_crossings_and_doors_bear_their_names(name: str) -> None:
    """They stood in tooltips alone."""
    layout, _, _ = built(name)
    told = {t.text for t in place(layout).labels if t.kind == "of-device"}
    assert told == {str(x.id) for x in layout.signalling.devices} != set()


def test_a_crossing_over_two_sections_is_named_once_where_these_are_beside_each_other() -> None:
    """LC2 lies over the joint of two sections; L52 of the other layout is drawn over tracks that are far apart."""
    far = "tests/layouts_for_tests/overlaps_join"
    for name, device, times in (("layouts/crossing_line", "LC2", 1), (far, "L52", 2)):
        layout = check_file(f"{name}.yaml").layout
        assert layout is not None
        assert [t.text for t in place(layout).labels if t.kind == "of-device"].count(device) == times


def test_a_crossing_over_sections_in_a_row_is_one_road_and_over_tracks_side_by_side_one_each() -> None:
    """LC2 lies over the joint of two sections: it is one road there, not two with one name."""
    layout, _, _ = built("crossing_line")
    d = place(layout)
    over = {str(x.id): x.over for x in layout.signalling.devices}
    assert device_spots(d, over["LC1"]) != device_spots(d, over["LC2"])
    (spot,) = device_spots(d, over["LC2"])
    s3, s4 = ({n for e in layout.track.edges_in[s] for n in (e.a, e.b)} for s in over["LC2"])
    assert spot == d.at[next(iter(s3 & s4))]
    text = Path("layouts/crossing_line.yaml").read_text("utf-8")
    three, _ = load_text("x.yaml", text.replace("over: [s3, s4]", "over: [s3, s4, ld]"), Sink())
    assert three is not None
    assert len(device_spots(place(three), next(x.over for x in three.signalling.devices if x.id == "LC2"))) == 2
    at_signal, _ = load_text("y.yaml", CROWDED.replace("over: [K1]", "over: [D1, T1]"), Sink())
    assert at_signal is not None
    assert len(device_spots(place(at_signal), (SectionId("D1"), SectionId("T1")))) == 2, "no road through a signal"


def test_a_machine_whose_name_is_not_that_of_its_points_is_named_with_them() -> None:
    """The table says `M R`: somewhere the plan must say what M is."""
    text = Path("tests/layouts_for_tests/driven.yaml").read_text("utf-8")
    for machine, told in (("M", {"A (M)", "B (M)"}), ("A/B", {"A", "B"})):
        layout, _ = load_text("driven.yaml", text.replace("machine: M", f"machine: {machine}"), Sink())
        assert layout is not None
        assert {t.text for t in place(layout).labels if t.kind == "point"} >= told
    layout, _, _ = built("terminus")
    assert "201A" in {t.text for t in place(layout).labels}, "201 works 201A and 201B"


def test_a_stop_board_and_a_limit_of_shunt_have_symbols_of_their_own() -> None:
    """Trains end at the one and run past the other."""
    layout, _ = load_text("boards.yaml", Path("tests/layouts_for_tests/boards.yaml").read_text("utf-8"), Sink())
    assert layout is not None
    svg = plan_svg(layout)
    stop, limit = (re.search(rf'<g id="signal-{name}".*?</g>', svg) for name in ("H", "LS"))
    assert stop is not None and limit is not None
    assert "plate" in stop[0] and "Z" not in stop[0] and "plate" not in limit[0] and " Z" in limit[0]


def test_an_arrow_at_a_boundary_points_the_way_of_the_trains() -> None:
    """It pointed outwards, wherever trains only come in, too."""
    layout, _, _ = built("junction")
    svg, d = plan_svg(layout), place(layout)
    seen = set()
    for n, (x, _), right in d.outside:
        mark = re.search(rf'<g id="boundary-{n}" class="boundary"><path class="mark" d="([^"]*)"', svg)
        assert mark is not None
        heads = [(float(a), float(b)) for a, b in re.findall(r"M([-\d.]+) \S+ L([-\d.]+) ", mark[1])]
        outward = {(tip > back) is right for back, tip in heads}
        kind = layout.track.boundary_at[n].kind
        assert outward == {"in": {False}, "out": {True}, "both": {True, False}}[str(kind)], n
        seen.add(str(kind))
        assert all(abs(a - x) < 15 for head in heads for a in head)
    assert seen >= {"in", "out"}


def test_the_page_of_the_plans_explains_what_is_drawn() -> None:
    """Traps, tracks that are dotted, thick or dashed, and boards were not on it."""
    page = Path("interlock/docs/plans.md").read_text("utf-8")
    for word in (
        "trap",
        "without detection",
        "inclined lane",
        "beyond a boundary",
        "stop board",
        "limit-of-shunt board",
        "route indicator",
        "speed indicator",
    ):
        assert re.search(rf"^\| .* \|.*{word}", page, re.MULTILINE), word


@pytest.mark.parametrize(
    "path", ["layouts/terminus_slip.yaml", "tests/stations/hbg.yaml", "tests/stations/munkerod.yaml"]
)
def test_no_length_stands_so_near_to_a_name_that_they_are_read_as_one(path: str) -> None:
    """`80 205b` was read as one name."""
    layout = check_file(path).layout
    assert layout is not None
    labels = place(layout).labels
    for left, top, right, bottom in (t.box for t in labels if t.kind == "length"):
        row = [
            t for t in labels if t.box[1] < bottom - 2 and top + 2 < t.box[3] and t.box != (left, top, right, bottom)
        ]
        assert all(t.box[0] - right >= 5.9 or left - t.box[2] >= 5.9 for t in row)


WITH_SPEEDS = ("speeds", "entry_speeds", "overlap_inside")


def _with_speeds(name: str) -> tuple[Layout, InterlockingTable, Controller]:
    """A layout that states speeds: of sections and reverse legs, of overlaps."""
    checked = check_file(f"tests/layouts_for_tests/{name}.yaml")
    assert checked.layout is not None and checked.table is not None, checked.diagnostics
    return checked.layout, checked.table, lower(checked.layout, checked.table)


def test_the_second_of_two_yellows_and_the_indicators_of_route_and_speed_have_symbols() -> None:
    """The forms said UU, B and km/h of signals drawn as any other; where nothing lights them, there are none."""
    for name in (*SHIPPED, *WITH_SPEEDS):
        layout, _, controller = built(name) if name in SHIPPED else _with_speeds(name)
        svg, units = plan_svg(layout), {}
        for g in layout.signalling.signals:
            drawn = re.search(rf'<g id="signal-{re.escape(g.id)}".*?</g>', svg)
            assert drawn is not None
            units[g.id] = re.findall(r'class="lamp (\w+)"', drawn[0])
        aspects = controller.symbols.aspects
        assert {g for g, kinds in units.items() if "second" in kinds} == set(aspects.second)
        assert {g for g, kinds in units.items() if "indicator" in kinds} == set(aspects.indicator)
        assert {g for g, kinds in units.items() if "speed" in kinds} == {g for g, _ in aspects.speed}
        if name == "speeds":
            assert units["X2"] == ["main", "speed"]
        if name == "cn6502":
            assert units["X"] == ["main", "second"] and units["S5"] == ["main", "shunt", "indicator"]
            assert units["D1"] == ["shunt"]


@pytest.mark.parametrize("seed", [86, 88])
def test_nothing_is_drawn_over_the_lamps_of_a_signal(seed: int) -> None:
    """In a plan with a double slip there was room for two lamps of a signal, and too little before a diamond."""
    layout, _ = load_text("grown.yaml", grow_all(seed), Sink())
    assert layout is not None
    d = place(layout)
    lines = [(e, a, b) for e, line in d.edges.items() for a, b in pairwise(line)]
    units = re.findall(r'class="lamp \w+" (?:cx="(\S+)" cy="(\S+)"|d="M(\S+) (\S+) )', plan_svg(layout, d))
    assert any(path for _, _, path, _ in units), "an indicator is among them"
    for cx, cy, left, top in units:  # a box is told by its corner
        x, y = (float(cx), float(cy)) if cx else (float(left) + 4.2, float(top) + 4.2)
        box = (x - 4.2, y - 4.2, x + 4.2, y + 4.2)
        assert [e for e, a, b in lines if enters(a, b, box)] == []
        names = [(t.text, t.box) for t in d.labels]
        assert [
            n for n, b in names if b[0] < box[2] and box[0] < b[2] and b[1] + 1 < box[3] and box[1] < b[3] - 1
        ] == []
