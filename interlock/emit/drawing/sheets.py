"""A plan on several sheets of A3 with match lines, or folded: cut where fewest names and tracks are cut through.

Every sheet shows a window of the plan at the same scale; beside its edges stand the tracks that go on, each with the
sheet (folded: the row) on which it does.  Only tracks end at a match line: a name or symbol that it would cut stands
whole, over the line, on the sheet on which its middle lies.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import count, pairwise
from math import ceil, dist
from xml.sax.saxutils import escape

from interlock.dataclass import dataclass
from interlock.emit.drawing.canvas import SIGNAL, Box, Drawing, Spot, width
from interlock.emit.drawing.lamps import symbol_width
from interlock.emit.drawing.svg import STYLE, plan_body
from interlock.emit.tables.paper import title_block

PIXEL_MM = 0.24  # names of 11 pixels are printed with 7.5 points
SHEET = (420 / PIXEL_MM, 297 / PIXEL_MM)  # A3 landscape
EDGE = 40.0  # pixels of paper around everything
STRIP = 70.0  # beside a window: what goes on, and where
FOOT = 46.0  # the title block
WIDE = SHEET[0] - 2 * (EDGE + STRIP)
HIGH = SHEET[1] - 2 * EDGE - FOOT - 2 * 24
SLACK = 0.9  # windows as large as that would do: what is left lets them be cut where less is cut through
LEAST = 0.4  # of a window's size: no piece is smaller, but the last
STEP = 3.0
THROUGH = 100  # cutting through a name costs as much as through so many tracks


@dataclass(frozen=True)
class Window:
    """What a sheet shows, and its number."""

    number: int
    box: Box
    after: dict[str, int]
    """The sheets on its sides: left, right, top, bottom."""


def windows(d: Drawing, wide: float = WIDE, high: float = HIGH) -> list[Window]:
    """The plan in windows, from left to right and then downwards."""
    whole = _whole(d)
    lines = [(a, b) for line in _lines(d) for a, b in pairwise(line)]
    boxes = list(_boxes(d))
    columns = _cuts(whole[0], whole[2], wide, [(a[0], b[0]) for a, b in lines], [(b[0], b[2]) for b in boxes])
    rows = _cuts(whole[1], whole[3], high, [(a[1], b[1]) for a, b in lines], [(b[1], b[3]) for b in boxes])
    grid = [(x, y) for y in pairwise(rows) for x in pairwise(columns)]
    spots = [((b[0], b[1]), (b[2], b[3])) for b in boxes]
    wanted = [(x, y) for x, y in grid if any(_inside(a, b, (x[0], y[0], x[1], y[1])) for a, b in (*lines, *spots))]
    number = {place: k for k, place in enumerate(wanted, 1)}
    out = []
    for (x, y), k in number.items():
        sides = {
            "left": ((p, y) for p in pairwise(columns) if p[1] == x[0]),
            "right": ((p, y) for p in pairwise(columns) if p[0] == x[1]),
            "top": ((x, p) for p in pairwise(rows) if p[1] == y[0]),
            "bottom": ((x, p) for p in pairwise(rows) if p[0] == y[1]),
        }
        after = {side: number[place] for side, those in sides.items() for place in those if place in number}
        out.append(Window(k, (x[0], y[0], x[1], y[1]), after))
    return out


def _whole(d: Drawing) -> Box:
    boxes = [*_boxes(d), *((x, y, x, y) for line in _lines(d) for x, y in line)]
    left, top = min(b[0] for b in boxes) - 8, min(b[1] for b in boxes) - 8
    return (left, top, max(b[2] for b in boxes) + 8, max(b[3] for b in boxes) + 8)


def _lines(d: Drawing) -> Iterator[list[Spot]]:
    yield from d.edges.values()
    yield from ([d.at[n], tip] for n, tip, _ in d.outside)


def _boxes(d: Drawing) -> Iterator[Box]:
    """What shall not be cut: names, signals, points, joints."""
    yield from (t.box for t in d.labels)
    longest: dict[str, float] = {g.id: symbol_width(d.layout, g) + 4 for g in d.layout.signalling.signals}
    for name, (x, y, ahead) in (*d.signals.items(), *d.distants.items()):
        far = longest.get(name, SIGNAL + 4)
        yield (x - (4 if ahead else far), y - 22, x + (far if ahead else 4), y + 22)
    yield from ((x - 9, y - 9, x + 9, y + 9) for p in d.layout.pointwork.points for x, y in (d.at[p.node],))
    yield from ((x - 8, y - 8, x + 8, y + 8) for _, x, y, _ in d.joints)


def _cuts(
    low: float, high: float, most: float, lines: list[tuple[float, float]], boxes: list[tuple[float, float]]
) -> list[float]:
    """Where it is cut along one axis: no piece is longer than allowed, no more pieces than needed, and of these cuts
    those that cost least, one after the other."""
    pieces, out = max(1, ceil((high - low) / (SLACK * most))), [low]
    for left in range(pieces - 1, 0, -1):
        first, last = max(out[-1] + LEAST * most, high - left * most), out[-1] + most
        steps = [last - k * STEP for k in range(int((last - first) / STEP) + 1)]
        out.append(min(steps, key=lambda at: (_cost(at, lines, boxes), -at)))
    return [*out, high]


def _cost(at: float, lines: list[tuple[float, float]], boxes: list[tuple[float, float]]) -> int:
    through = sum(min(a, b) <= at <= max(a, b) for a, b in boxes)
    return THROUGH * through + sum(min(a, b) <= at <= max(a, b) for a, b in lines)


def _inside(a: Spot, b: Spot, box: Box) -> bool:
    """Whether a stroke has something in a window: its middle, an end, or where it crosses an edge."""
    for k in range(9):
        x, y = a[0] + (b[0] - a[0]) * k / 8, a[1] + (b[1] - a[1]) * k / 8
        if box[0] <= x <= box[2] and box[1] <= y <= box[3]:
            return True
    return False


# --- what goes on ---------------------------------------------------------------------------------


def _onward(d: Drawing, w: Window) -> Iterator[tuple[str, Spot, str]]:
    """Where tracks leave a window: side, place, section; of a line outside that has none, its boundary."""
    left, top, right, bottom = w.box
    sides = (("left", 0, left), ("right", 0, right), ("top", 1, top), ("bottom", 1, bottom))
    lines = [(str(e.section), d.edges[e.id]) for e in d.layout.track.edges]
    lines += [(str(d.layout.track.boundary_at[n].approach or n), [d.at[n], tip]) for n, tip, _ in d.outside]
    for name, line in lines:
        for a, b in pairwise(line):
            for side, axis, at in sides:
                low, high = sorted((a[axis], b[axis]))
                if side not in w.after or low == high or not low <= at <= high:
                    continue
                part = (at - a[axis]) / (b[axis] - a[axis])
                spot = (a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part)
                if left <= spot[0] <= right and top <= spot[1] <= bottom:
                    yield side, spot, name


# --- paper ----------------------------------------------------------------------------------------

MORE = """
.plan .match { stroke: #555; stroke-width: 1; stroke-dasharray: 12 4 2 4 }
.plan .lead { stroke: #555; stroke-width: 0.7 }
.plan .onward { font-size: 10px; fill: #333 }
.plan .frame { fill: none; stroke: #222; stroke-width: 1.2 }
.plan .foot { font-size: 11px; text-anchor: start }
"""


def _view(d: Drawing, w: Window, body: list[Part], x: float, y: float, known: set[str], word: str) -> str:
    """A window at a place of the paper, with match lines and what goes on beside it."""
    left, top, right, bottom = w.box
    wide, high = right - left, bottom - top
    tracks, whole = [], []
    for part in body:
        if part.track and part.box[0] <= right and part.box[2] >= left and part.box[1] <= bottom and part.box[3] >= top:
            tracks.append(_once(part.text, known))
        elif not part.track and left <= part.middle[0] < right and top <= part.middle[1] < bottom:
            whole.append(part.text)
    out = [
        f'<svg x="{x:.1f}" y="{y:.1f}" width="{wide:.1f}" height="{high:.1f}" '
        f'viewBox="{left:.1f} {top:.1f} {wide:.1f} {high:.1f}">',
        *tracks,
        "</svg>",
        f'<g transform="translate({x - left:.1f} {y - top:.1f})">',
        *whole,
        "</g>",
    ]
    for side in w.after:
        x0, x1 = (x, x) if side == "left" else (x + wide, x + wide) if side == "right" else (x, x + wide)
        y0, y1 = (y, y) if side == "top" else (y + high, y + high) if side == "bottom" else (y, y + high)
        out.append(f'<path class="match" d="M{x0:.1f} {y0:.1f} L{x1:.1f} {y1:.1f}"/>')
    return "\n".join([*out, *_told(d, w, (x - left, y - top), word)])


BESIDE = {"left": (-6, 3.5, "end"), "right": (6, 3.5, "start"), "top": (0, -6, "middle"), "bottom": (0, 14, "middle")}
LETTERS = 10.0  # pixels from one such word to the next below it
APART = 6.0  # between two beside each other


@dataclass(frozen=True)
class Mark:
    """What goes on at a spot of a window's side, where that is told, and the box of its letters."""

    text: str
    spot: Spot
    at: Spot
    anchor: str
    box: Box
    aside: bool
    """It stands further away than others do: a line leads to it."""


def marks(d: Drawing, w: Window, word: str) -> list[Mark]:
    """What goes on at the sides of a window, none over another."""
    out: list[Mark] = []
    for side, spot, section in sorted(set(_onward(d, w))):
        text = f"{section} \u2192 {word}{w.after[side]}"
        if any(m.text == text and dist(m.spot, spot) < 1 for m in out):
            continue  # two edges of the section meet there
        tries = (_mark(side, spot, text, step) for step in count())
        out.append(next(m for m in tries if not any(_over(m.box, other.box) for other in out)))
    return out


def _mark(side: str, spot: Spot, text: str, step: int) -> Mark:
    """A word so many steps away from its place beside a spot: along the side, of one that lies level in two rows."""
    x, y, anchor = spot[0] + BESIDE[side][0], spot[1] + BESIDE[side][1], BESIDE[side][2]
    long = width(text)
    if side in ("left", "right"):
        y += _either(step) * LETTERS
    else:
        x += _either(step // 2) * APART
        y += step % 2 * LETTERS * (-1 if side == "top" else 1)
    left = x - {"start": 0.0, "middle": long / 2, "end": long}[anchor]
    return Mark(text, spot, (x, y), anchor, (left, y - LETTERS, left + long, y), step > 0)


def _either(step: int) -> int:
    """0, 1, -1, 2, -2 and so on."""
    return (step + 1) // 2 * (1 if step % 2 else -1)


def _over(a: Box, b: Box) -> bool:
    return a[0] < b[2] + APART and b[0] < a[2] + APART and a[1] < b[3] and b[1] < a[3]


def _told(d: Drawing, w: Window, by: Spot, word: str) -> Iterator[str]:
    """The marks on paper, with lines from the tracks to those that stand aside."""
    for m in marks(d, w, word):
        x, y = m.at[0] + by[0], m.at[1] + by[1]
        if m.aside:
            x0, y0 = m.spot[0] + by[0], m.spot[1] + by[1]
            end = y - LETTERS if y - LETTERS > y0 else y + 2 if y + 2 < y0 else y - 3.5
            yield f'<path class="lead" d="M{x0:.1f} {y0:.1f} L{x:.1f} {end:.1f}"/>'
        place = f'x="{x:.1f}" y="{y:.1f}"'
        yield f'<text class="onward" style="text-anchor:{m.anchor}" {place}>{escape(m.text)}</text>'


def _once(text: str, known: set[str]) -> str:
    """A part of the plan without the ids that stand on the paper already."""

    def keep(m: re.Match[str]) -> str:
        if m[0] in known:
            return ""
        known.add(m[0])
        return m[0]

    return re.sub(r' id="[^"]*"| id=\'[^\']*\'', keep, text)


_NUMBERS = re.compile(r'(?:[ML]|\bc?x=")([-\d.]+)(?: |" c?y=")([-\d.]+)')


@dataclass(frozen=True)
class Part:
    """A part of the plan with the box around its spots."""

    text: str
    box: Box
    track: bool
    home: Spot | None = None
    """Of the name of a symbol, where most of the symbol lies: they stay together."""

    @property
    def middle(self) -> Spot:
        """Where most of it lies: of a name without a symbol, its middle."""
        if self.home is not None:
            return self.home
        anchor = re.search(r"text-anchor:(\w+)", self.text)
        half = 0.5 * width(label[1]) if (label := re.search(r">([^<]*)</text>", self.text)) else 0.0
        aside = {"start": half, "end": -half}.get(anchor[1] if anchor else "", 0.0)
        return ((self.box[0] + self.box[2]) / 2 + aside, (self.box[1] + self.box[3]) / 2)


def _placed(d: Drawing) -> list[Part]:
    """The parts of the plan."""
    out = []
    for text in plan_body(d):
        spots = [(float(x), float(y)) for x, y in _NUMBERS.findall(text)]
        xs, ys = [x for x, _ in spots], [y for _, y in spots]
        track = 'class="track' in text or 'class="device" ' in text
        out.append(Part(text, (min(xs), min(ys), max(xs), max(ys)), track))
    symbols = {name: part.middle for part in out if not part.track for name in _ID.findall(part.text)}
    return [replace(part, home=symbols.get(_symbol(part.text))) for part in out]


_ID = re.compile(r" id=[\"']((?:point|signal|boundary|buffer|crossing)-[^\"']*)[\"']")
_OF = re.compile(r"<text class=\"(\w+)\"[^>]* data-of=[\"']([^\"']*)[\"']")


def _symbol(text: str) -> str:
    """The id of the symbol whose name a part is."""
    name = _OF.match(text)
    return f"{name[1]}-{name[2]}".replace(" ", "\u00a0") if name else ""


def sheets(d: Drawing) -> list[str]:
    """The plan on sheets of A3, each a document of its own."""
    those, body = windows(d), _placed(d)
    return [_sheet(d, w, body, len(those)) for w in those]


def _sheet(d: Drawing, w: Window, body: list[Part], of: int) -> str:
    wide, high = SHEET
    title = d.layout.printed.title or d.layout.name
    facts = [f"{label}: {fact}" for label, fact in title_block(d.layout, d.layout.digest, "en")]
    foot = "".join(_set_apart(k, x) for k, x in enumerate([*facts, f"Sheet {w.number} of {of}"]))
    shown = _view(d, w, body, EDGE + STRIP, EDGE + 24, set(), "")
    frame = f'<rect class="frame" x="20" y="20" width="{wide - 40:.1f}" height="{high - 40:.1f}"/>'
    line = high - EDGE - FOOT / 2
    rule = f'<path class="frame" d="M20 {line - 18:.1f} L{wide - 20:.1f} {line - 18:.1f}"/>'
    text = f'<text class="foot" x="32" y="{line + 2:.1f}">{foot}</text>'
    return _document(title, (wide, high), ("420mm", "297mm"), [frame, rule, text, shown])


def _set_apart(k: int, fact: str) -> str:
    """A fact of the title block, with room before it: spaces beside each other are one in SVG."""
    return f'<tspan dx="24">{escape(fact)}</tspan>' if k else f"<tspan>{escape(fact)}</tspan>"


def _document(title: str, size: Spot, paper: tuple[str, str], parts: Iterable[str]) -> str:
    wide, high = size
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="plan" viewBox="0 0 {wide:.1f} {high:.1f}" '
        f'width="{paper[0]}" height="{paper[1]}" role="img">\n<title>{escape(title)}</title>\n'
        f'<style>{STYLE}{MORE}</style>\n<rect width="{wide:.1f}" height="{high:.1f}" fill="#fff"/>\n'
        + "\n".join(parts)
        + "\n</svg>\n"
    )


def folded(d: Drawing, wide: float = WIDE) -> str:
    """The plan in rows under each other, none wider than a sheet: for lines."""
    whole = _whole(d)
    those, body = windows(d, wide, whole[3] - whole[1]), _placed(d)
    known: set[str] = set()
    parts, y = [], 44.0
    for w in those:
        parts.append(f'<text class="foot" x="12" y="{y + 4:.1f}">row {w.number}</text>')
        parts.append(_view(d, w, body, EDGE + STRIP, y + 12, known, "row "))
        y += w.box[3] - w.box[1] + 48
    title = d.layout.printed.title or d.layout.name
    broad = max(w.box[2] - w.box[0] for w in those) + 2 * (EDGE + STRIP)
    head = f'<text class="title" x="12" y="22">{escape(title)}</text>'
    rows = ceil(y)
    return _document(title, (broad, rows), (f"{broad:.1f}", f"{rows}"), [head, *parts])
