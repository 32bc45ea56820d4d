"""A checker of track plans that knows nothing of how they are drawn: it reads the SVG that was written.

Counted are lines that cross, touch or overprint one another without being joined on the ground, names that lie on
lines or on other names, and names of sections that stand nearer to another section than to their own.  What is joined
on the ground is asked of the layout; everything else comes from the picture.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

from interlock.model.layout import Layout

SVG = "{http://www.w3.org/2000/svg}"
HALF = 1.3  # pixels: half the width of a track's line
NEAR = 0.6  # pixels within which two spots are one

Spot = tuple[float, float]
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Stroke:
    """A straight piece of the line of an edge, or of the track outside a boundary."""

    edge: str
    a: Spot
    b: Spot

    @property
    def box(self) -> Box:
        """Left, top, right, bottom."""
        (x0, y0), (x1, y1) = self.a, self.b
        return (min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1))


@dataclass(frozen=True)
class Found:
    """What a plan shows that is not so: pairs of edges, and names with what they lie on."""

    crossings: tuple[tuple[str, str], ...]
    on_lines: tuple[tuple[str, str], ...]
    on_names: tuple[tuple[str, str], ...]
    astray: tuple[tuple[str, str], ...]
    """Names and lengths of sections with the section that they stand at instead."""

    @property
    def clean(self) -> bool:
        """Nothing found."""
        return not (self.crossings or self.on_lines or self.on_names or self.astray)


def examine(svg: str, layout: Layout) -> Found:
    """Count what is wrong in a plan of a layout."""
    root = ElementTree.fromstring(svg)
    strokes, rails = list(_strokes(root)), list(_strokes(root, "rail"))
    names = [(str(t.text), _box(t)) for t in root.iter(f"{SVG}text")]
    return Found(
        tuple(sorted(set(_false_crossings(strokes, layout)))),
        tuple((text, s.edge) for text, box in names for s in (*strokes, *rails) if _on(s, box)),
        tuple((s, t) for i, (s, a) in enumerate(names) for t, b in names[i + 1 :] if _over(a, b)),
        tuple(_astray(root)),
    )


# --- what is there -------------------------------------------------------------------------------


def _spots(path: str) -> list[Spot]:
    assert re.fullmatch(r"M[-\d.]+ [-\d.]+( L[-\d.]+ [-\d.]+)*", path), path
    return [(float(x), float(y)) for x, y in re.findall(r"([-\d.]+) ([-\d.]+)", path)]


def _strokes(root: ElementTree.Element, kind: str = "track") -> Iterator[Stroke]:
    """Every track that is drawn, without the invisible lines that only catch the pointer, and those that repeat the
    arms of a slip; apart from it the slip rails, which touch the arms and are of no edge."""
    for number, path in enumerate(root.iter(f"{SVG}path")):
        classes = path.get("class", "").split()
        if kind in classes and (kind == "rail" or not {"rail", "arm"} & set(classes)):
            edge = path.get("id", f"outside {number}").removeprefix("edge-").replace("\u00a0", " ")
            for a, b in pairwise(_spots(path.get("d", ""))):
                if a != b:
                    yield Stroke(edge, a, b)


def _box(text: ElementTree.Element) -> Box:
    """Where a name stands: widths as in Helvetica, rounded up to one for each kind of letter (W and M apart)."""
    kind = text.get("class", "")
    size = {"length": 9.0, "title": 14.0}.get(kind, 11.0)
    wide = size * sum(map(_width, str(text.text))) * (1.06 if kind == "section" else 1.0)
    style = re.search(r"text-anchor:(\w+)", text.get("style", ""))
    anchor = style[1] if style else "start" if kind == "title" else "middle"
    x, y = float(text.get("x", "nan")), float(text.get("y", "nan"))
    left = x - {"start": 0.0, "middle": wide / 2, "end": wide}[anchor]
    return (left, y - 0.72 * size, left + wide, y)


def _width(letter: str) -> float:
    if ord(letter) > 0x2E80:
        return 1.0
    if letter in "WMm":
        return 0.95 if letter == "W" else 0.84
    return 0.69 if letter.isupper() else 0.556 if letter.isdigit() else 0.52 if letter.isalpha() else 0.4


# --- what is wrong -------------------------------------------------------------------------------


def _false_crossings(strokes: list[Stroke], layout: Layout) -> Iterator[tuple[str, str]]:
    ends = {str(e.id): {e.a, e.b} for e in layout.track.edges}
    ordered = sorted(strokes, key=lambda s: s.box)
    for i, s in enumerate(ordered):
        for t in ordered[i + 1 :]:
            if t.box[0] > s.box[2] + NEAR:
                break
            if s.edge == t.edge or t.box[1] > s.box[3] + NEAR or s.box[1] > t.box[3] + NEAR:
                continue
            joined = bool(ends.get(s.edge, set()) & ends.get(t.edge, set())) or "outside" in s.edge + t.edge
            if _overprint(s, t) or _cross(s, t) or (not joined and _touch(s, t)):
                yield (min(s.edge, t.edge), max(s.edge, t.edge))


def _side(a: Spot, b: Spot, p: Spot) -> float:
    """On which side of a line a spot lies, and how many pixels away."""
    length = max(1e-9, ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5)
    return ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / length


def _cross(s: Stroke, t: Stroke) -> bool:
    """Each lies on both sides of the other."""
    p, q = _side(s.a, s.b, t.a), _side(s.a, s.b, t.b)
    u, v = _side(t.a, t.b, s.a), _side(t.a, t.b, s.b)
    return all(abs(k) > NEAR for k in (p, q, u, v)) and p * q < 0 and u * v < 0


def _along(s: Stroke, p: Spot) -> float:
    """How far along a stroke a spot lies, in pixels."""
    length = max(1e-9, ((s.b[0] - s.a[0]) ** 2 + (s.b[1] - s.a[1]) ** 2) ** 0.5)
    return ((p[0] - s.a[0]) * (s.b[0] - s.a[0]) + (p[1] - s.a[1]) * (s.b[1] - s.a[1])) / length


def _overprint(s: Stroke, t: Stroke) -> bool:
    """One lies on the other over more than two pixels."""
    if max(abs(_side(s.a, s.b, t.a)), abs(_side(s.a, s.b, t.b))) > NEAR:
        return False
    a, b = sorted((_along(s, t.a), _along(s, t.b)))
    return min(b, _along(s, s.b)) - max(a, 0.0) > 2.0


def _touch(s: Stroke, t: Stroke) -> bool:
    """An end of one lies on the other."""
    return any(
        abs(_side(u.a, u.b, p)) <= NEAR and -NEAR <= _along(u, p) <= _along(u, u.b) + NEAR
        for u, other in ((s, t), (t, s))
        for p in (other.a, other.b)
    )


def _on(s: Stroke, box: Box) -> bool:
    """Whether a line, as wide as it is drawn, enters a box."""
    left, top, right, bottom = box[0] - HALF, box[1] - HALF, box[2] + HALF, box[3] + HALF
    low, high = 0.0, 1.0
    for start, step, least, most in (
        (s.a[0], s.b[0] - s.a[0], left, right),
        (s.a[1], s.b[1] - s.a[1], top, bottom),
    ):
        if abs(step) < 1e-9:
            if not least < start < most:
                return False
            continue
        one, two = sorted(((least - start) / step, (most - start) / step))
        low, high = max(low, one), min(high, two)
    return low < high - 1e-9


def _over(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def _astray(root: ElementTree.Element) -> Iterator[tuple[str, str]]:
    """Names and lengths of sections that another section is nearer to than their own."""
    tracks = {
        str(g.get("id")).removeprefix("section-").replace("\u00a0", " "): list(_strokes(g))
        for g in root.iter(f"{SVG}g")
        if "section" in g.get("class", "").split() and g.get("id")
    }
    for text in root.iter(f"{SVG}text"):
        own = text.get("data-of", "")
        if text.get("class") in ("section", "length") and own in tracks:
            left, top, right, bottom = _box(text)
            middle = ((left + right) / 2, (top + bottom) / 2)
            far = {name: min(_far(s, middle) for s in strokes) for name, strokes in tracks.items() if strokes}
            near = min(far, key=lambda name: far[name])
            if far[near] + 2 * NEAR < far[own]:
                yield str(text.text), near


def _far(s: Stroke, p: Spot) -> float:
    """Pixels from a spot to a stroke."""
    along = min(max(_along(s, p), 0.0), _along(s, s.b))
    whole = max(1e-9, _along(s, s.b))
    x, y = (s.a[k] + (s.b[k] - s.a[k]) * along / whole for k in (0, 1))
    return float(((p[0] - x) ** 2 + (p[1] - y) ** 2) ** 0.5)
