"""A plan as an engineer reads it: how points lie in normal, which way signals and arrows apply, which joints are foul.

Everything is read from the SVG; only what it should say is asked of the layout.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from itertools import pairwise
from math import dist
from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.diag import Sink
from interlock.emit.drawing import place, plan_svg
from interlock.emit.drawing.slips import blades, double_slips
from interlock.frontend import load_text
from interlock.model.elements import BufferKind, EdgeId, NodeId, Point, Work
from interlock.model.foul import foul_joints
from interlock.model.layout import Layout
from tests.layouts import SHIPPED, SLIPS, built

SVG = "{http://www.w3.org/2000/svg}"
Spot = tuple[float, float]


class Picture:
    """What the SVG of a layout shows, by id."""

    def __init__(self, layout: Layout) -> None:
        self.layout, root = layout, ElementTree.fromstring(plan_svg(layout))
        self.by = {str(e.get("id")).replace("\u00a0", " "): e for e in root.iter() if e.get("id")}

    def line(self, edge: EdgeId) -> list[Spot]:
        """The spots of an edge."""
        return spots(self.by[f"edge-{edge}"].get("d", ""))

    def node(self, *edges: EdgeId) -> Spot:
        """Where edges meet."""
        ends = [{line[0], line[-1]} for line in map(self.line, edges)]
        (spot,) = set.intersection(*ends)
        return spot

    def strokes(self, name: str, kind: str) -> list[str]:
        """The paths of a kind in what has this id."""
        return [p.get("d", "") for p in self.by[name].iter(f"{SVG}path") if kind in p.get("class", "").split()]

    def points(self) -> list[tuple[Point, Spot]]:
        """The points that have a symbol of their own, and where they lie; of a double slip its four blades have."""
        shared = {b.point for s in double_slips(self.layout) for b in s.blades}
        points = [p for p in self.layout.pointwork.points if p.id not in shared]
        return [(p, self.node(p.toe, p.normal, p.reverse)) for p in points]


def spots(path: str) -> list[Spot]:
    return [(float(x), float(y)) for x, y in re.findall(r"[ML](\S+) (\S+)", path)]


def away(spot: Spot, line: list[Spot]) -> float:
    """Pixels from a spot to a line."""
    return min(_from_stroke(spot, a, b) for a, b in pairwise(line))


def _from_stroke(p: Spot, a: Spot, b: Spot) -> float:
    along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / max(1e-9, dist(a, b) ** 2)
    part = min(1.0, max(0.0, along))
    return dist(p, (a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])))


PICTURES = pytest.mark.parametrize("name", SHIPPED)


@PICTURES
def test_the_gap_is_in_the_leg_that_is_not_set_in_normal(name: str) -> None:
    """Of a derailer, which normally leads off the rails, it is in the track: it was in the way off them."""
    picture = Picture(built(name)[0])
    for p, at in picture.points():
        (path,) = picture.strokes(f"point-{p.id}", "gap")
        gap = spots(path)
        assert all(away(spot, picture.line(p.reverse)) < 1 and dist(spot, at) < 25 for spot in gap), p.id
        others = [picture.line(p.toe), picture.line(p.normal)]
        assert all(away(spot, line) > 1 for spot in gap for line in others), p.id


@PICTURES
def test_the_symbol_at_points_tells_how_they_are_worked_and_stands_off_their_reverse_leg(name: str) -> None:
    picture = Picture(built(name)[0])
    for p, (_, y) in picture.points():
        group = picture.by[f"point-{p.id}"]
        square, ring = group.find(f"{SVG}rect"), group.find(f"{SVG}circle")
        triangle = any(d.endswith("Z") for d in picture.strokes(f"point-{p.id}", "mark"))
        hand = p.work is Work.HAND and not p.derailer
        assert (square is not None, ring is not None, triangle) == (not hand and not p.derailer, hand, p.derailer)
        if not p.derailer:
            middle = float(ring.get("cy", "")) if ring is not None else float(square.get("y", "")) + 2.5  # type: ignore[union-attr]
            (_, gap), _ = spots(picture.strokes(f"point-{p.id}", "gap")[0])
            assert (middle - y) * (gap - y) < 0, p.id


@PICTURES
def test_a_fouling_point_is_marked_between_the_legs(name: str) -> None:
    """None is marked at a derailer, nor within a slip."""
    layout = built(name)[0]
    picture = Picture(layout)
    of_slips = {b.point for b in layout.pointwork.blades}
    for p, (x, y) in picture.points():
        crosses = picture.strokes(f"point-{p.id}", "foul")
        assert bool(crosses) is not (p.derailer or p.id in of_slips), p.id
        for (left, top), _ in (spots(path) for path in crosses):
            mark, gap = (left + 2.5, top), spots(picture.strokes(f"point-{p.id}", "gap")[0])[1]
            assert (mark[0] - x) * (gap[0] - x) > 0 < (top - y) * (gap[1] - y), p.id
            assert away(mark, picture.line(p.normal)) > 4, "between the legs, on neither"


def test_a_ring_is_around_the_joints_that_are_foul_and_around_no_other() -> None:
    ringed = {}
    for name in SHIPPED:
        layout = built(name)[0]
        joints = {k.removeprefix("joint-"): e for k, e in Picture(layout).by.items() if k.startswith("joint-")}
        ringed[name] = {k for k, e in joints.items() if e.find(f"{SVG}circle") is not None}
        assert ringed[name] == {str(f.node) for f in foul_joints(layout)}
    at = built("cn6502")[0].track.edges_at
    sections = {tuple(sorted(str(e.section) for e in at[NodeId(n)])) for n in ringed["cn6502"]}
    assert sections == {("3DG", "5DG"), ("21DG", "25DG")}


@pytest.mark.parametrize("name", [*SHIPPED, "profile: generic", "profile: de"])
def test_a_signal_points_the_way_of_the_movements_to_which_it_applies(name: str) -> None:
    """Its mast and its lamps lie ahead of its joint, over the track into which it leads; a distant signal in rear."""
    layout = built(name)[0] if name in SHIPPED else _ways(f"name: ways\n{name}\n")
    picture = Picture(layout)
    ahead = {}
    for g in layout.signalling.signals:
        line = picture.line(g.into)
        e = layout.track.edge[g.into]
        mast = spots(picture.strokes(f"signal-{g.id}", "mast")[0])
        foot, tip = mast[0][0], mast[3][0]
        lamps = [float(c.get("cx", "")) for c in picture.by[f"signal-{g.id}"].iter(f"{SVG}circle")]
        at = min(line[0], line[-1], key=lambda spot: abs(spot[0] - foot))
        assert at[0] == foot and g.node in (e.a, e.b)
        way = 1 if at == line[0] else -1
        assert all((x - foot) * way > 0 for x in (tip, *lamps)), g.id
        above = mast[0][1] < at[1]
        ahead[g.id] = (at, way, above)
    for k in layout.signalling.distants:
        (x, _), (_, y), *_ = spots(picture.strokes(f"signal-{k.id}", "mast")[0])
        at, way, above = ahead[k.of]
        assert (at[0] - x) * way > 0 and (y < at[1]) is above, "in rear of its main signal, on the same side"


WAYS = """interlock: 1
name: ways
boundaries: {W: {approach: aw 600}, E: {approach: ae 600}}
buffers: [B]
traps: [T]
tracks: {west: [W, w1 200], main: [m1 300], side: [s2 300], east: [e1 250, E], dead: [d1 100, B], trap: [T, t9 30]}
points:
  1: {section: P1, toe: west.end, normal: main.start, reverse: side.start}
  2: {section: P2, toe: 3.toe, normal: main.end, reverse: side.end}
  3: {section: P2, normal: 4.toe, reverse: dead.start}
  4: {section: P4, normal: east.start, reverse: trap.end}
sections: {m1: {one_way: forward}, s2: {one_way: backward}}
signals:
  A: {from: W, into: w1}
  C: {from: E, into: e1}
distants: {VA: {of: A}, VC: {of: C}}
"""


def _ways(said: str = "name: ways\n") -> Layout:
    layout, _ = load_text("ways.yaml", WAYS.replace("name: ways\n", said), sink := Sink())
    assert layout is not None, sink.diagnostics
    return layout


def test_an_arrow_on_a_track_points_the_one_way_and_the_ends_of_tracks_are_told_apart() -> None:
    layout = _ways()
    picture = Picture(layout)
    for edge, way in (("main.0", 1), ("side.0", -1)):  # from left to right, and against
        (a, tip, b), (path,) = spots(picture.strokes("section-m1" if way > 0 else "section-s2", "mark")[0]), [edge]
        assert a[0] == b[0] and (tip[0] - a[0]) * way > 0, path
    for b in layout.track.buffers:
        (path,) = picture.strokes(f"buffer-{b.node}", "mark")
        marks = spots(path)
        line = picture.line(layout.track.edges_at[b.node][0].id)
        end = next(s for s in (line[0], line[-1]) if s[0] in [x for x, _ in marks])
        inward = 1 if end == line[0] else -1
        feet = {(x - end[0]) * inward for x, _ in marks}
        assert feet == ({0, 5} if b.kind is BufferKind.STOP else {0, -5}), "a bracket around the track, or beyond it"
        assert path.count("M") == (1 if b.kind is BufferKind.STOP else 2)
    assert {str(b.kind) for b in layout.track.buffers} == {"stop", "trap"}


@pytest.mark.parametrize("said", ["", ", blades: near"])
def test_the_blades_of_a_double_slip_are_told_as_they_lie(said: str) -> None:
    layout, _ = load_text("slips.yaml", SLIPS % said, Sink())
    assert layout is not None
    picture, d = Picture(layout), place(layout)
    (slip,) = double_slips(layout)
    for lie in slip.blades:
        group = picture.by[f"point-{lie.point}"]
        assert group.findtext(f"{SVG}title") == (
            f"{lie.point}: blades at {' and '.join(lie.at)}, N to {lie.normal}, R to {lie.reverse}"
        )
        own = [b for b in blades(d, slip) if b.point == lie.point]
        for key, normal in (("data-n", True), ("data-r", False)):
            drawn = [spots(path) for path in re.findall(r"M\S+ \S+ L\S+ \S+", group.get(key, ""))]
            for b, (at, tip) in zip(own, drawn, strict=True):
                assert dist(at, b.at) < 0.1 and away(tip, [b.at, b.towards(normal)]) < 0.2, (key, b.end)


def test_a_title_and_names_with_signs_of_markup_are_read_as_they_are_written() -> None:
    said = 'name: ways\ntitle: "A < B & C"\n'
    text = WAYS.replace("name: ways\n", said).replace("W: {", 'W: {label: "a<b>&c", ')
    layout, _ = load_text("ways.yaml", text, Sink())
    assert layout is not None
    root = ElementTree.fromstring(plan_svg(layout))
    told = [t.text for t in root.iter(f"{SVG}text")]
    assert root.findtext(f"{SVG}title") == "A < B & C" == told[0] and "a<b>&c (W)" in told


def test_a_speed_indicator_is_a_triangle_beyond_the_lamp() -> None:
    layout = check_file("tests/layouts_for_tests/speeds.yaml").layout
    assert layout is not None
    picture = Picture(layout)
    (path,) = [p for p in picture.strokes("signal-X2", "lamp") if p.endswith("Z")]
    (x, top), (corner, base) = spots(path)
    mast = spots(picture.strokes("signal-X2", "mast")[0])
    assert top < base and corner > x > mast[3][0], "a triangle on its base, beyond the lamp"


def test_a_shunt_signal_has_no_speed_indicator() -> None:
    """A speed is shown to trains alone, though the shunt route runs over the same points."""
    text = Path("tests/layouts_for_tests/speeds.yaml").read_text("utf-8")
    layout, _ = load_text(
        "x.yaml", text.replace("X2: {from: q1, into: q2}", "X2: {from: q1, into: q2, kind: shunt}"), Sink()
    )
    assert layout is not None
    picture = Picture(layout)
    triangles = {name for name in picture.by if name.startswith("signal-") and picture.strokes(name, "speed")}
    assert "signal-X1" in triangles and "signal-X2" not in triangles
