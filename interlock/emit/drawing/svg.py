"""A placed plan as SVG: the same bytes for the same layout, and an id on everything that other parts may address.

Ids: `section-`, `edge-`, `point-`, `signal-`, `joint-`, `boundary-`, `buffer-`, `crossing-`, `device-` and the name; of
double slips with two machines also `rail-` with the two legs that a slip rail joins, and `arm-` with a leg.
The drawing needs nothing from a network.  Colours are left to the style sheet at its head, so that a page can light up
what it wants.
"""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from interlock.emit.drawing.canvas import Drawing, Label, Spot, arrow, bend, device_spots, fouling_mark, next_spot
from interlock.emit.drawing.lamps import FIRST, NEXT, lamps, unit
from interlock.emit.drawing.place import place
from interlock.emit.drawing.slips import CHORDS, DoubleSlip, blades, double_slips
from interlock.model.elements import (
    Blades,
    BoundaryKind,
    BufferKind,
    DeviceKind,
    EdgeId,
    Lane,
    Point,
    Section,
    Signal,
    Work,
)
from interlock.model.foul import foul_joints
from interlock.model.layout import Layout

STYLE = """
.plan { background: #fff; font: 11px Helvetica, Arial, "Noto Sans CJK SC", sans-serif; fill: #111 }
.plan .track { fill: none; stroke: #222; stroke-width: 2.6; stroke-linejoin: round }
.plan .hit { fill: none; stroke: transparent; stroke-width: 16; pointer-events: stroke }
.plan .outside { stroke-dasharray: 7 4 }
.plan .inclined { stroke-width: 4.2 }
.plan .blind { stroke-dasharray: 2 3 }
.plan .rail, .plan .arm { pointer-events: none }
.plan .arm:not(.used) { display: none }
.plan .mark, .plan .mast { fill: none; stroke: #222; stroke-width: 1.5 }
.plan .barrier, .plan .across { display: none }
.plan .leaf { fill: #fff }
.plan .foul { fill: none; stroke: #222; stroke-width: 1.2 }
.plan .mast.plate { stroke-width: 5 }
.plan .lamp { fill: #fff; stroke: #222; stroke-width: 1.3 }
.plan .lamp.main { fill: #222 }
.plan .gap { stroke: #fff; stroke-width: 5 }
.plan text { text-anchor: middle; pointer-events: none }
.plan text.section { font-weight: bold }
.plan text.length { font-size: 9px; fill: #666 }
.plan text.point { font-style: italic }
.plan text.signal { fill: #111 }
.plan .title { font-size: 14px; text-anchor: start }
"""


SCREEN = (2000.0, 1100.0)
"""Pixels of a plan that is seen with little scrolling (our choice); a larger one opens where its lines come in."""
OPENS = """<script>
(() => { // as a document of its own; a page that holds the plan moves it itself
  const root = document.documentElement, at = root.dataset.start;
  if (at) addEventListener("load", () => { const [x, y] = at.split(" "); scrollTo(x - 80, y - innerHeight / 2); });
})();
</script>
"""


def _n(x: float) -> str:
    return f"{x:.1f}".rstrip("0").rstrip(".")


def _path(line: list[Spot]) -> str:
    return "M" + " L".join(f"{_n(x)} {_n(y)}" for x, y in line)


def _id(text: str) -> str:
    """An id in quotes: HTML allows no space in one, so that a no-break space, which no name has, stands for it."""
    return quoteattr(text.replace(" ", "\u00a0"))


TITLE = '<text class="title" x="12" y="22">'


def plan_svg(layout: Layout, drawing: Drawing | None = None) -> str:
    """The plan, for a page that holds it; as a document of its own it is `opening(plan)`."""
    d = drawing or place(layout)
    body = "\n".join(plan_body(d))
    w, h = _n(d.width), _n(d.height)
    title = escape(layout.printed.title or layout.name)
    large = d.width > SCREEN[0] or d.height > SCREEN[1]
    x, y = min(spot for _, spot, _ in d.outside) if d.outside else min(d.at.values(), default=(0.0, 0.0))
    start = f' data-start="{_n(x)} {_n(y)}"' if large else ""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="plan" viewBox="0 0 {w} {h}" width="{w}" height="{h}" '
        f'role="img"{start}>\n'
        f"<title>{title}</title>\n<style>{STYLE}</style>\n"
        f'<rect width="{w}" height="{h}" fill="#fff"/>\n{TITLE}{title}</text>\n'
        f"{body}\n</svg>\n"
    )


def opening(plan: str, mark: str = "") -> str:
    """A plan as a document of its own: a large one opens where its lines come in; before its title stands the mark."""
    if mark:
        told = f'<tspan fill="#b00020" font-weight="bold">{escape(mark)}</tspan>  '
        plan = plan.replace(TITLE, f"{TITLE}{told}", 1)
    return plan.replace("</style>\n", f"</style>\n{OPENS}", 1) if ' data-start="' in plan else plan


def plan_body(d: Drawing) -> list[str]:
    """What is drawn, part by part."""
    return [*_tracks(d), *_crossings(d), *_joints(d), *_points(d), *_ends(d), *_devices(d), *_signals(d), *_texts(d)]


def _tracks(d: Drawing) -> list[str]:
    layout = d.layout
    rails = _slip_rails(d)
    out = []
    for n, tip, _ in d.outside:
        boundary = layout.track.boundary_at[n]
        name = f" id={_id(f'section-{boundary.approach}')}" if boundary.approach else ""
        out.append(f'<g{name} class="section approach"><path class="track outside" d="{_path([d.at[n], tip])}"/></g>')
    for s in layout.track.sections:
        edges = layout.track.edges_in.get(s.id, ())
        if not edges:
            continue
        kind = _kind(s)
        paths = "".join(f'<path id={_id(f"edge-{e.id}")} class="{kind}" d="{_path(d.edges[e.id])}"/>' for e in edges)
        hit = f'<path class="hit" d="{" ".join(_path(d.edges[e.id]) for e in edges)}"/>'
        arrows = "".join(_arrow(d, e.id) for e in edges if e.one_way)
        slips = "".join(rails[e.id] for e in edges if e.id in rails)
        out.append(f'<g id={_id(f"section-{s.id}")} class="section">{hit}{paths}{slips}{arrows}</g>')
    return out


def _kind(s: Section) -> str:
    """The classes of what a section's track is drawn with."""
    return "track" + (" inclined" if s.lane is Lane.INCLINED else "") + ("" if s.detected else " blind")


def _slip_rails(d: Drawing) -> dict[EdgeId, str]:
    """Of double slips with two machines, by edge: the arm of a leg from its far end to the blades, which is seen only
    as `used`; at the first leg of a slip rail that rail, which tells the legs that it joins, and the edge in the middle
    of the diamond (`data-from`, `data-to`, `data-past`).  A way that joins those legs runs over the two arms and the
    rail; neither over the rest of the legs nor over the middle, which are drawn whole."""
    found: dict[EdgeId, str] = {}
    for s in double_slips(d.layout):
        past = d.layout.pointwork.point[s.blades[0].point].toe
        for b in blades(d, s):
            leg, to = s.legs[b.end], s.legs[CHORDS[b.end]]
            kind = _kind(d.layout.track.section[d.layout.track.edge[leg].section])
            found[leg] = f'<path id={_id(f"arm-{leg}")} class="{kind} arm" d="{_path(b.leg)}"/>'
            if b.end < CHORDS[b.end]:
                joins = f"data-from={quoteattr(leg)} data-to={quoteattr(to)} data-past={quoteattr(past)}"
                rail = _path([b.at, b.chord])
                found[leg] += f'<path id={_id(f"rail-{leg}-{to}")} class="{kind} rail" {joins} d="{rail}"/>'
    return found


def _arrow(d: Drawing, edge: EdgeId) -> str:
    """One-way track: an arrow on it."""
    (x, y), right = arrow(d, edge)
    way = 6 if right else -6
    return f'<path class="mark" d="M{_n(x - way)} {_n(y - 5)} L{_n(x)} {_n(y)} L{_n(x - way)} {_n(y + 5)}"/>'


def _joints(d: Drawing) -> list[str]:
    fouls = {f.node for f in foul_joints(d.layout)}
    out = []
    for n, x, y, slope in d.joints:
        dx, dy = (0.0, 7.0) if abs(slope) < 0.05 else (5.0 if slope < 0 else -5.0, 5.0)
        ring = f'<circle class="foul" cx="{_n(x)}" cy="{_n(y)}" r="7"/>' if n in fouls else ""
        tick = f'<path class="mark" d="M{_n(x - dx)} {_n(y - dy)} L{_n(x + dx)} {_n(y + dy)}"/>'
        out.append(f'<g id={_id(f"joint-{n}")} class="joint">{tick}{ring}</g>')
    return out


def _points(d: Drawing) -> list[str]:
    """Each point with its machine; of a slip with a word on where its blades lie, and where they lead."""
    told = {b.point: b for b in d.layout.pointwork.blades}
    slips = double_slips(d.layout)
    parts = {s.blades[0].point: _double(d, s) for s in slips}
    shared = {b.point for s in slips for b in s.blades}
    for p in d.layout.pointwork.points:
        if p.id in shared:
            continue
        x, y = d.at[p.node]
        onward, near = bend(d, p.id), 14 if p.reverse in d.plan.rails else 5
        if p.derailer:  # in normal it leads off the rails: what is not set is the track
            onward, near = next_spot(d.edges[p.reverse], (x, y)), 9
        gap, uy = _gap((x, y), onward, near)
        words = _words(told[p.id]) if p.id in told else ""
        inner = f"{words}{gap}{_machine(p, x, y, uy)}{_fouling(d, p)}"
        parts[p.id] = f'<g id={_id(f"point-{p.id}")} class="point">{inner}</g>'
    return [parts[k] for k in sorted(parts)]


def _words(b: Blades) -> str:
    ends = " and ".join(b.at)
    return f"<title>{escape(f'{b.point}: blades at {ends}, N to {b.normal}, R to {b.reverse}')}</title>"


def _gap(a: Spot, b: Spot, near: float) -> tuple[str, float]:
    """The gap in a leg that is not set, and how the leg falls."""
    ux, uy = _towards(a, b)
    spots = [(a[0] + k * ux, a[1] + k * uy) for k in (near, near + 6)]
    return f'<path class="gap" d="{_path(spots)}"/>', uy


def _towards(a: Spot, b: Spot) -> Spot:
    length = max(1.0, ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5)
    return ((b[0] - a[0]) / length, (b[1] - a[1]) / length)


LIES = 17  # pixels of a leg that show how its point lies


def _double(d: Drawing, s: DoubleSlip) -> str:
    """The four pairs of blades of a double slip with two machines; how they lead in either position is told for
    whoever shows it (`data-n`, `data-r`)."""
    those = list(blades(d, s))
    out = list[str]()
    for lie in s.blades:
        p, own = d.layout.pointwork.point[lie.point], [b for b in those if b.point == lie.point]
        inner, lies = _words(lie), {True: list[str](), False: list[str]()}
        for b in own:
            gap, uy = _gap(b.at, b.chord, 14)
            inner += gap + _machine(p, *b.at, uy)
            for normal, paths in lies.items():
                ux, vy = _towards(b.at, b.towards(normal))
                paths.append(_path([b.at, (b.at[0] + LIES * ux, b.at[1] + LIES * vy)]))
        data = f'data-n="{" ".join(lies[True])}" data-r="{" ".join(lies[False])}"'
        out.append(f'<g id={_id(f"point-{p.id}")} class="point" {data}>{inner}</g>')
    return "\n".join(out)


def _machine(p: Point, x: float, y: float, uy: float) -> str:
    """A small square beside a worked point, a triangle for a derailer, a ring for a hand-worked one."""
    beside = y + (-5 if uy > 0 else 5)
    if p.derailer:
        return f'<path class="mark" d="M{_n(x - 6)} {_n(y - 6)} L{_n(x + 6)} {_n(y - 6)} L{_n(x)} {_n(y + 4)} Z"/>'
    if p.work is Work.HAND:
        return f'<circle class="mark" cx="{_n(x)}" cy="{_n(beside)}" r="3"/>'
    return f'<rect class="mark" x="{_n(x - 2.5)}" y="{_n(beside - 2.5)}" width="5" height="5"/>'


def _fouling(d: Drawing, p: Point) -> str:
    """The fouling point: a cross between the legs, as far out as the layout's scale has no say in."""
    mark = fouling_mark(d, p.id)
    if mark is None:
        return ""
    cx, cy = mark
    return f'<path class="foul" d="M{_n(cx - 2.5)} {_n(cy - 2.5)} l5 5 M{_n(cx - 2.5)} {_n(cy + 2.5)} l5 -5"/>'


def _crossings(d: Drawing) -> list[str]:
    out = []
    for c in d.layout.pointwork.crossings:
        x, y = d.at[c.node]
        out.append(f'<circle id={_id(f"crossing-{c.id}")} class="mark" cx="{_n(x)}" cy="{_n(y)}" r="4"/>')
    return out


def _ends(d: Drawing) -> list[str]:
    out = []
    for n, (x, y), right in d.outside:
        tip = f'<path class="mark" d="{" ".join(_arrows(d.layout.track.boundary_at[n].kind, x, y, right))}"/>'
        out.append(f'<g id={_id(f"boundary-{n}")} class="boundary">{tip}</g>')
    for b in d.layout.track.buffers:
        x, y = d.at[b.node]
        left = all(next_spot(d.edges[e.id], (x, y))[0] > x for e in d.layout.track.edges_at[b.node])
        way = 5 if left else -5
        if b.kind is BufferKind.STOP:
            mark = f"M{_n(x + way)} {_n(y - 7)} L{_n(x)} {_n(y - 7)} L{_n(x)} {_n(y + 7)} L{_n(x + way)} {_n(y + 7)}"
        elif b.kind is BufferKind.TRAP:
            mark = f"M{_n(x)} {_n(y - 7)} L{_n(x)} {_n(y + 7)} M{_n(x - way)} {_n(y - 7)} L{_n(x - way)} {_n(y + 7)}"
        else:
            mark = (
                f"M{_n(x - 4)} {_n(y - 4)} L{_n(x + 4)} {_n(y + 4)} M{_n(x - 4)} {_n(y + 4)} L{_n(x + 4)} {_n(y - 4)}"
            )
        out.append(f'<g id={_id(f"buffer-{b.node}")} class="buffer"><path class="mark" d="{mark}"/></g>')
    return out


def _arrows(kind: BoundaryKind, x: float, y: float, right: bool) -> Iterator[str]:
    """Which way trains pass a boundary: out of the layout, into it, or both."""
    way = 5 if right else -5
    if kind is not BoundaryKind.IN:
        yield f"M{_n(x - way)} {_n(y - 5)} L{_n(x)} {_n(y)} L{_n(x - way)} {_n(y + 5)}"
    if kind is not BoundaryKind.OUT:
        near = x if kind is BoundaryKind.IN else x - 1.6 * way
        yield f"M{_n(near)} {_n(y - 5)} L{_n(near - way)} {_n(y)} L{_n(near)} {_n(y + 5)}"


def _devices(d: Drawing) -> list[str]:
    """A level crossing is a road across every track that it lies over, a door a leaf between two jambs; other
    interlocks are a frame around the track.  Where they lie is told for whoever shows how they are (`data-at`), with
    marks that the plan alone does not show: barriers across a road, a cross in a frame."""
    out = []
    for device in d.layout.signalling.devices:
        marks: dict[str, list[str]] = {}
        spots = device_spots(d, device.over)
        for x, y in spots:
            for part, stroke in _device(device.kind, x, y):
                marks.setdefault(part, []).append(stroke)
        paths = "".join(f'<path class="mark{part}" d="{" ".join(strokes)}"/>' for part, strokes in marks.items())
        told = f'data-kind="{device.kind}" data-at="{" ".join(f"{_n(x)},{_n(y)}" for x, y in spots)}"'
        name = f"<title>{escape(device.id)}</title>"
        out.append(f'<g id={_id(f"device-{device.id}")} class="device" {told}>{name}{paths}</g>')
    return out


def _device(kind: DeviceKind, x: float, y: float) -> Iterator[tuple[str, str]]:
    """The strokes of a device at one of its places, each with the class of its part."""
    if kind is DeviceKind.LEVEL_CROSSING:
        yield "", " ".join(f"M{_n(x + k)} {_n(y - 16)} L{_n(x + k)} {_n(y + 16)}" for k in (-4, 4))
        yield " barrier", " ".join(f"M{_n(x - 9)} {_n(y + k)} h18" for k in (-13, 13))
    elif kind is DeviceKind.DOOR:
        ends = ((y - 12, 6), (y + 12, -6))
        yield "", " ".join(f"M{_n(x - 4)} {_n(end)} h8 M{_n(x)} {_n(end)} v{far}" for end, far in ends)
        yield " leaf", f"M{_n(x - 2.5)} {_n(y - 6)} h5 v12 h-5 Z"
    else:
        yield "", f"M{_n(x - 9)} {_n(y - 9)} h18 v18 h-18 Z"
        yield " across", f"M{_n(x - 9)} {_n(y - 9)} l18 18 M{_n(x - 9)} {_n(y + 9)} l18 -18"


def _signals(d: Drawing) -> list[str]:
    leftward = d.layout.profile != "de"
    out = [_signal(d.layout, g, *d.signals[g.id], leftward) for g in d.layout.signalling.signals]
    for k in d.layout.signalling.distants:  # a distant signal: an open square on its mast, in rear of its main signal
        x, y, ahead = d.distants[k.id]
        my = y + (-14 if ahead is leftward else 14)
        box = f'<path class="mast" d="M{_n(x)} {_n(y)} L{_n(x)} {_n(my)} M{_n(x - 5)} {_n(my)} l5 -5 l5 5 l-5 5 Z"/>'
        out.append(f'<g id={_id(f"signal-{k.id}")} class="signal distant">{box}</g>')
    return out


def _signal(layout: Layout, g: Signal, x: float, y: float, ahead: bool, leftward: bool) -> str:
    """A foot at the joint, a mast along the track in the direction of travel, and its lamps: full for main signals,
    open for shunt signals, both for combined ones; with a slash the second of two yellows (UU); one more, open, for an
    identifier light; a box for a route indicator (B), a triangle for a speed indicator.  A board has none, but a plate
    on its mast: full where trains end, open for a limit of shunt."""
    side, way = (-1 if ahead is leftward else 1), (1 if ahead else -1)
    my = y + side * 14
    mast = f"M{_n(x)} {_n(y + side * 4)} L{_n(x)} {_n(my + side * 4)} M{_n(x)} {_n(my)} L{_n(x + way * 12)} {_n(my)}"
    plate, px = "", x + way * 12
    if g.id in layout.signalling.boards and g.main:
        plate = f'<path class="mast plate" d="M{_n(px + way * 2.5)} {_n(my - 6)} L{_n(px + way * 2.5)} {_n(my + 6)}"/>'
    elif g.id in layout.signalling.boards:
        mast += f" M{_n(px)} {_n(my - 6)} L{_n(px + way * 5)} {_n(my - 6)} L{_n(px + way * 5)} {_n(my + 6)}"
        mast += f" L{_n(px)} {_n(my + 6)} Z"
    heads = "".join(unit(kind, x + way * (FIRST + NEXT * k), my) for k, kind in enumerate(lamps(layout, g)))
    return f'<g id={_id(f"signal-{g.id}")} class="signal {g.kind}"><path class="mast" d="{mast}"/>{plate}{heads}</g>'


def _texts(d: Drawing) -> list[str]:
    return [_text(t) for t in d.labels]


def _text(t: Label) -> str:
    anchor = "" if t.anchor == "middle" else f' style="text-anchor:{t.anchor}"'
    return (
        f'<text class="{t.kind}"{anchor} data-of={quoteattr(t.id)} x="{_n(t.x)}" y="{_n(t.y)}">{escape(t.text)}</text>'
    )


__all__ = ["plan_body", "plan_svg"]
