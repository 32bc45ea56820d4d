"""Joints, signals and names of a placed plan.

Those with a fixed place first, then the others where nothing else stands: moved along the track, or away from it, as
little as needed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import pairwise
from math import hypot

from interlock.emit.drawing.canvas import (
    DISTANT,
    UNIT,
    Box,
    Drawing,
    Label,
    Spot,
    announced,
    arrow,
    bend,
    boundary_name,
    device_spots,
    entered,
    flat,
    fouling_mark,
    point_name,
    reach,
    width,
)
from interlock.emit.drawing.lamps import symbol_width
from interlock.emit.drawing.slanting import Tracks, places
from interlock.emit.drawing.slips import blades, double_slips
from interlock.model.elements import BufferKind, DeviceKind, EdgeId, MachineId, SectionId

OVER_LINE = "the name {} lies over a line or symbol"


def put_names(d: Drawing, named: dict[EdgeId, SectionId]) -> None:
    """Joints, signals and names: those with a fixed place first, the others where nothing else stands."""
    _lines(d)
    _joints(d)
    _signals(d)
    _outside(d)
    _points(d)
    for slip in double_slips(d.layout):
        middle = d.at[slip.nodes[0]][0]
        for b in blades(d, slip):
            way, (x, y) = 1 if b.at[0] > middle else -1, b.at
            side, dy = "start" if way > 0 else "end", 15 if b.chord[1] < y else -8
            _put(d, Label("point", b.point, b.point, x + way * 8, y + dy, anchor=side))
    _diamonds(d)
    tracks = Tracks(d)
    for edge, section in sorted(named.items()):
        (x0, y0), (x1, y1) = flat(d.edges[edge])
        length = sum(e.length for e in d.layout.track.edges_in[section])
        x, y = (x0 + x1) / 2, (y0 + y1) / 2
        tilt = 10 if y0 != y1 else 0
        own = _stretch(d, section, edge)
        name = Label("section", section, section, x, y - 6 - tilt)
        metres = Label("length", section, f"{length:g}", x, y + 13 + tilt, small=True)
        for label in (name, metres):
            if not (tilt and _put_if(d, (p for p in places(d, label) if tracks.is_near(p, section)), 0)):
                _put(d, label, own)
    _devices(d)


BESIDE = 3.0 * UNIT
"""Pixels within which the places of a device have one name: over tracks or sections side by side."""


def _devices(d: Drawing) -> None:
    """Level crossings, doors and other interlocks by their names, above or below each place, where there is room; once
    for places that are beside each other."""
    for device in d.layout.signalling.devices:
        named: list[Spot] = []
        for x, y in device_spots(d, device.over):
            if all(hypot(x - u, y - v) > BESIDE for u, v in named):
                labels = [Label("of-device", device.id, device.id, x, y + dy) for dy in (-20, 28, -32, 40, -44, 52)]
                named += [(x, y)] if _put_if(d, labels) else []


def _put_if(d: Drawing, places: Iterable[Label], most: int = 24) -> bool:
    """A label in the first place where it covers nothing, moved along the track as little as needed, but by so many
    pixels at most; else nowhere."""
    moves = [0, *(dx for step in range(6, most + 1, 6) for dx in (step, -step))]
    tries = (label.moved(dx, 0) for label in places for dx in moves)
    label = next((x for x in tries if not d.taken.meets(_around(x))), None)
    if label is not None:
        d.labels.append(label)
        d.taken.add(label.box, name=True)
    return label is not None


def _points(d: Drawing) -> None:
    """Each point with its name; a slip whose blades one machine lays with that of the machine, once."""
    single = [d.layout.pointwork.point[b.point] for b in d.layout.pointwork.blades if len(b.at) == 1]
    laid = Counter(p.machine for p in single)
    of_slip = {p.id for p in single if laid[p.machine] > 1}
    named: set[MachineId] = set()
    for p in d.layout.pointwork.points:
        if p.id in of_slip and p.machine in named:
            continue
        named.add(p.machine)
        (x, y), far, text = d.at[p.node], bend(d, p.id), str(p.machine) if p.id in of_slip else point_name(p)
        below, way = far[1] < y, 1 if far[0] < x else -1
        side = "start" if way > 0 else "end"
        _put(d, Label("point", p.id, text, x + way * 8, y + 15 if below else y - 8, anchor=side))


def _diamonds(d: Drawing) -> None:
    """Each diamond by its name, above or below it, or beside it; a slip is named by its points."""
    for c in d.layout.pointwork.crossings:
        (x, y), half = d.at[c.node], width(c.id) / 2
        if c.node in d.plan.slips:
            continue
        beside = [(x + way * (half + k), y + 3.5) for k in (10, 16, 22) for way in (1, -1)]
        above = [(x, y + dy) for k in (8, 14, 20, 26, 32) for dy in (-k, k + 9)]
        labels = [Label("crossing", c.id, c.id, *spot) for spot in (*above, *beside)]
        if not _put_if(d, labels, 12):
            _put(d, labels[0])


def _lines(d: Drawing) -> None:
    """What names should keep away from: diagonals, and the marks of points."""
    for line in d.edges.values():
        for a, b in pairwise(line):
            if a[1] != b[1]:
                _keep_off(d, a, b)
            else:
                d.taken.add((min(a[0], b[0]), a[1] - 1.5, max(a[0], b[0]), a[1] + 1.5))
    for device in d.layout.signalling.devices:
        for x, y in device_spots(d, device.over):
            wide = 10 if device.kind is DeviceKind.LEVEL_CROSSING else 12
            d.taken.add((x - wide, y - 16, x + wide, y + 16))
    for e in d.layout.track.edges:
        if e.one_way:
            (x, y), _ = arrow(d, e.id)
            d.taken.add((x - 8, y - 6, x + 8, y + 6))
    for slip in double_slips(d.layout):
        for blade in blades(d, slip):
            (x, y), far = blade.at, blade.chord
            _keep_off(d, (x, y), far)
            d.taken.add((x - 6, y - 8, x + 6, y + 8))
    for p in d.layout.pointwork.points:
        x, y = d.at[p.node]
        d.taken.add((x - 6, y - 8, x + 6, y + 8))
        mark = fouling_mark(d, p.id)
        if mark is not None:
            # beside a number a cross would be read as a sign of multiplication
            d.taken.add((mark[0] - 8, mark[1] - 4, mark[0] + 8, mark[1] + 4))


def _keep_off(d: Drawing, a: Spot, b: Spot) -> None:
    """No name lies on this stroke."""
    steps = max(1, int(max(abs(b[0] - a[0]), abs(b[1] - a[1])) / 5))
    for k in range(steps + 1):
        x, y = a[0] + (b[0] - a[0]) * k / steps, a[1] + (b[1] - a[1]) * k / steps
        d.taken.add((x - 3, y - 3, x + 3, y + 3))


def _joints(d: Drawing) -> None:
    for n, (x, y) in d.at.items():
        if n in d.plan.knots and n not in d.layout.track.boundary_at:
            continue
        edges = d.layout.track.edges_at[n]
        if len({e.section for e in edges}) > 1 or n in d.layout.track.boundary_at:
            d.joints.append((n, x, y, _slope(d, edges[0].id, (x, y))))
            d.taken.add((x - 1, y - 7, x + 1, y + 7))


def _signals(d: Drawing) -> None:
    leftward = d.layout.profile != "de"  # signals stand on the left of their track, in Germany on the right
    for g in d.layout.signalling.signals:
        x, y = d.at[g.node]
        ahead = d.edges[g.into][0] == (x, y)
        up = ahead is leftward
        way = 1 if ahead else -1
        d.signals[g.id] = (x, y, ahead)
        far = x + way * symbol_width(d.layout, g)
        d.taken.add((min(x, far), y - 19 if up else y + 6, max(x, far), y - 6 if up else y + 19))
        anchor = "start" if ahead else "end"
        _put(d, Label("signal", g.id, g.id, x + way * 2, y - 22 if up else y + 30, anchor=anchor))
    for k in d.layout.signalling.distants:
        node = d.layout.signalling.signal[k.of].node
        x, y = d.at[node]
        ahead = d.signals[k.of][2]
        way = 1 if ahead else -1
        d.distants[k.id] = (x - way * 24, y, ahead)
        up = ahead is leftward
        d.taken.add((x - way * 24 - 7, y - 20 if up else y, x - way * 24 + 7, y if up else y + 20))
        _put(d, Label("signal", k.id, k.id, x - way * 24, y - 24 if ahead is leftward else y + 32))


def _outside(d: Drawing) -> None:
    layout = d.layout
    for b in layout.track.boundaries:
        x, y = d.at[b.node]
        right = all(d.edges[e.id][-1] == (x, y) for e in layout.track.edges_at[b.node])
        far = reach(layout, b.node)
        tip = x + (far if right else -far)
        d.outside.append((b.node, (tip, y), right))
        if b.approach is not None:
            beyond = DISTANT * announced(layout, b.node) * (1 if right else -1)
            _put(d, Label("section", b.approach, b.approach, (x + beyond + tip) / 2, y - 6))
        where = tip + (8 if right else -8)
        _put(
            d,
            Label("boundary", b.node, boundary_name(layout, b.node), where, y + 4, anchor="start" if right else "end"),
        )
    for stop in layout.track.buffers:
        x, y = d.at[stop.node]
        left = all(d.edges[e.id][0] == (x, y) for e in layout.track.edges_at[stop.node])
        if stop.kind is not BufferKind.DERAIL:
            where = x + (-9 if left else 9)
            _put(d, Label("buffer", stop.node, stop.node, where, y + 4, anchor="end" if left else "start"))


def _slope(d: Drawing, edge: EdgeId, at: Spot) -> float:
    """How a track runs where it meets a joint: 0 level, otherwise down or up to the right."""
    line = d.edges[edge]
    (x0, y0), (x1, y1) = (line[0], line[1]) if line[0] == at else (line[-2], line[-1])
    return 0.0 if y0 == y1 else (y1 - y0) / max(1.0, x1 - x0)


Along = tuple[float, float]
"""From where to where on its own track a name stands, from left to right."""


def _stretch(d: Drawing, section: SectionId, edge: EdgeId) -> Along:
    """How far the track of a section runs on at the height of the edge on which its name stands."""
    (left, y), (right, y1) = flat(d.edges[edge])
    parts = [p for e in d.layout.track.edges_in[section] for p in pairwise(d.edges[e.id])]
    level = sorted((min(a[0], b[0]), max(a[0], b[0])) for a, b in parts if a[1] == b[1] == y == y1)
    for low, high in level:  # to the right of what is joined already, then the same to the left
        right = max(right, high) if low <= right + 1 and high >= left else right
    for low, high in reversed(level):
        left = min(left, low) if high >= left - 1 and low <= right else left
    return (min(left, right), max(left, right))


def _along(label: Label, own: Along, whole: bool) -> bool:
    """Whether a name stands at its own track: with every letter, or with its middle (as one that is longer must)."""
    left, _, right, _ = label.box
    if whole and right - left <= own[1] - own[0]:
        return own[0] <= left and right <= own[1]
    return own[0] <= (left + right) / 2 <= own[1]


def _put(d: Drawing, label: Label, own: Along | None = None) -> None:
    """The label where nothing else stands: moved along the track, or away from it, as little as needed.  `own`: the
    track that it belongs to, and beyond whose ends it would name another."""
    moves = list(_tries())
    passes = [(False, True, True), (False, False, True), (False, False, False)] if own is not None else []
    for names_only, apart, whole in (*passes, (False, True, None), (False, False, None), (True, False, None)):
        for dx, dy in moves:
            moved = label.moved(dx, dy)
            if own is not None and whole is not None and not _along(moved, own, whole):
                continue
            beside = apart and d.taken.meets(_around(moved), names_only=True)
            if not beside and not d.taken.meets(moved.box, names_only):
                d.labels.append(moved)
                d.taken.add(moved.box, name=True)
                if names_only:
                    d.notes.append(OVER_LINE.format(label.text))
                return
    d.notes.append(f"the name {label.text} lies over another")
    d.labels.append(label)


def _around(label: Label) -> Box:
    """A name with room for a space before and after it: beside another it would be read as one with that."""
    left, top, right, bottom = label.box
    return (left - 6, top, right + 6, bottom)


def tell_covered(d: Drawing) -> None:
    """Names that a line runs through after all, in notes: where a plan bends back, a line may move after them."""
    boxes = (label.box for label in d.labels)
    letters = [(left, top + 1.5, right, bottom - 2.5) for left, top, right, bottom in boxes]
    for k in sorted(entered((stroke for line in d.edges.values() for stroke in pairwise(line)), letters)):
        note = OVER_LINE.format(d.labels[k].text)
        if note not in d.notes:
            d.notes.append(note)


def _tries() -> Iterator[tuple[float, float]]:
    yield (0, 0)
    for step in range(1, 8):
        yield from ((6.0 * step, 0), (-6.0 * step, 0))
    for dy in (-9, 9, -20, 20):
        for step in range(8):
            yield from ((6.0 * step, dy), (-6.0 * step, dy))
