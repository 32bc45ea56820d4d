"""The time-distance graph of a shift as SVG: hours to the right, metres downwards, a line for each train.

The longest way through the layout is one axis; every other section (cross-cuts, the loaded exit) has a band of its own
below it, in which a train is shown by the metres that it has come in.  A train is drawn by its head, from joint to
joint; where it is loaded its line is thick.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from html import escape

from interlock.dataclass import dataclass
from interlock.record.log import Event
from interlock.record.shift import as_written

COLOURS = ("#0b5fa5", "#c2410c", "#15803d", "#7e22ce", "#b91c1c", "#0f766e", "#a16207", "#be185d", "#334155", "#4d7c0f")

DASHES = ("", "8 3", "8 3 2 3", "2 2")
"""Of the first ten trains, the second ten and so on."""

LEAST = 360.0
"""Pixels of a graph's width at least, for its legend."""

LEFT, TOP, HOUR, GAP = 120.0, 46.0, 150.0, 14.0

MOST_LINES = 1000
"""Lines of time at most: quarters of an hour of the longest shift that is simulated; a log may say anything
(our choice)."""

Spot = tuple[float, float]


@dataclass
class Line:
    """A train's line: pieces of time (seconds) and height; where it was loaded; where it went from band to band."""

    pieces: list[list[Spot]] = field(default_factory=list)
    loads: list[tuple[float, float, float]] = field(default_factory=list)
    jumps: list[tuple[Spot, Spot]] = field(default_factory=list)


class Axis:
    """Heights of sections: those of the main way by their metres, the others in bands below."""

    def __init__(self, heading: Event) -> None:
        metres: Mapping[str, Sequence[float]] = heading["metres"]
        main = [s for s in heading["main"] if s in metres]
        low = min((metres[s][0] for s in main), default=0.0)
        high = max((metres[s][1] for s in main), default=1.0)
        self.scale = 420.0 / max(1.0, high - low)
        self.of = {s: (TOP + (metres[s][0] - low) * self.scale, TOP + (metres[s][1] - low) * self.scale) for s in main}
        self.bands: list[tuple[str, float, float]] = [(s, *self.of[s]) for s in main]
        y = TOP + (high - low) * self.scale + GAP
        for s, (a, b) in sorted(metres.items(), key=lambda x: (x[1][0], x[0])):
            if s not in self.of:
                h = max(14.0, (b - a) * self.scale)
                self.of[s] = (y, y + h)
                self.bands.append((s, y, y + h))
                y += h + GAP
        self.bottom = y
        self.metres = metres

    def ends(self, before: str, section: str) -> Spot:
        """Heights at which a head comes into a section from another one, and at which it comes to its other end."""
        near, far = self.of[section]
        if before in self.metres:
            a, b = self.metres[section]
            low, high = self.metres[before]
            if min(abs(b - low), abs(b - high)) < min(abs(a - low), abs(a - high)):
                near, far = far, near
        return near, far


def lines(events: Sequence[Event], axis: Axis) -> dict[str, Line]:
    """The line of each train."""
    found: dict[str, Line] = {}
    at: dict[str, tuple[str, float]] = {}
    for e in events:
        train, kind, t = e.get("train"), e["kind"], e["t"] / 1000
        if train is None:
            continue
        line = found.setdefault(train, Line())
        section, far = at.get(train, ("", 0.0))
        if kind == "enters" and e["section"] in axis.of:
            near, far = axis.ends(section, e["section"])
            if section and line.pieces and e["section"] in axis.of:
                last = line.pieces[-1][-1]
                if abs(last[1] - near) > 1.0 and not _joined(axis, section, e["section"]):
                    line.pieces[-1].append((t, _out(axis, section, e["section"])))
                    line.jumps.append((line.pieces[-1][-1], (t, near)))
                    line.pieces.append([])
            if not section or not line.pieces:
                line.pieces.append([])
            line.pieces[-1].append((t, near))
            at[train] = (e["section"], far)
        elif kind == "stands" and section:
            line.pieces[-1].append((t, far))
        elif kind in ("runs", "loads", "loaded") and section and line.pieces[-1]:
            here = line.pieces[-1][-1]
            if kind == "loaded":
                line.loads.append((here[0], t, here[1]))
            line.pieces[-1].append((t, here[1]))
        elif kind == "leaves" and section:
            line.pieces[-1].append((t, far))
            at.pop(train)
            line.pieces.append([])
    return found


def _joined(axis: Axis, a: str, b: str) -> bool:
    """Two sections follow each other on the main way."""
    (la, ha), (lb, hb) = axis.of[a], axis.of[b]
    return abs(ha - lb) < 1.0 or abs(hb - la) < 1.0


def _out(axis: Axis, section: str, to: str) -> float:
    """The height at which a head leaves a section towards another one."""
    (a, b), (low, high) = axis.metres[section], axis.metres[to]
    near, far = axis.of[section]
    return far if min(abs(b - low), abs(b - high)) <= min(abs(a - low), abs(a - high)) else near


@as_written()
def graph_svg(events: Sequence[Event]) -> str:
    """The graph of a shift's record."""
    heading, axis = events[0], Axis(events[0])
    seconds, step = max(events[-1]["t"] / 1000, 1.0), 900
    while seconds / step > MOST_LINES:
        step *= 4

    def x(t: float) -> float:
        return LEFT + t / (4 * step) * HOUR

    trains = sorted(lines(events, axis).items(), key=lambda p: (len(p[0]), p[0]))
    width = max(x(seconds) + 30, LEAST)
    legend, low = _legend([train for train, _ in trains], width, axis.bottom + 24)
    height = low + 16
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
        f'height="{height:.0f}" font-family="sans-serif" font-size="11">',
        f"<title>{escape(heading['layout'])}: time-distance graph</title>",
        f'<rect width="{width:.0f}" height="{height:.0f}" fill="#fff"/>',
    ]
    out += _grid(axis, seconds, step, x)
    out += _bands(axis, x(0), x(seconds), heading)
    for k, (train, line) in enumerate(trains):
        out += _train(train, line, _ink(k), x)
    out += _named(trains, x)
    return "\n".join([*out, *legend, "</svg>", ""])


def _ink(k: int) -> str:
    """How the line of a train is drawn: in one of ten colours, and dashed where these were used already."""
    dash = DASHES[k // len(COLOURS) % len(DASHES)]
    return f'stroke="{COLOURS[k % len(COLOURS)]}"' + (f' stroke-dasharray="{dash}"' if dash else "")


def _wide(text: str) -> float:
    """Pixels of a text of 11 pixels, rather too many."""
    return sum(11.5 if ord(c) > 0x2E80 else 10.0 if c in "MWm" else 6.8 for c in text)


def _legend(trains: Sequence[str], width: float, y: float) -> tuple[list[str], float]:
    """Each train with its line, in rows no wider than the graph, and how far down the last one reaches."""
    out, x = [], LEFT
    for k, train in enumerate(trains):
        text = f"train {train}"
        if x > LEFT and x + 34 + _wide(text) > width:
            x, y = LEFT, y + 16
        out.append(f'<path d="M{x:.0f} {y - 4:.0f} h28" {_ink(k)} fill="none" stroke-width="1.6"/>')
        colour = COLOURS[k % len(COLOURS)]
        out.append(f'<text class="legend" x="{x + 34:.0f}" y="{y:.0f}" fill="{colour}">{escape(text)}</text>')
        x += 34 + _wide(text) + 18
    return out, y


def _named(trains: Sequence[tuple[str, Line]], x: Callable[[float], float]) -> list[str]:
    """The name of each train where a line of its begins, none over another."""
    out, taken = [], list[tuple[float, float, float]]()
    for k, (train, line) in enumerate(trains):
        onward = {spot for _, spot in line.jumps}
        for t, high in (piece[0] for piece in line.pieces if len(piece) > 1 and piece[0] not in onward):
            left, y, wide = x(t) + 3, high - 3, 0.82 * _wide(train)
            while any(abs(y - v) < 10 and left < u + w and u < left + wide for u, v, w in taken):
                y += 10
            taken.append((left, y, wide))
            place = f'x="{left:.1f}" y="{y:.1f}" font-size="9" fill="{COLOURS[k % len(COLOURS)]}"'
            out.append(f'<text class="train" {place}>{escape(train)}</text>')
    return out


def _grid(axis: Axis, seconds: float, step: int, x: Callable[[float], float]) -> list[str]:
    """A line every `step` seconds; every fourth one has its hour."""
    out = []
    for k in range(int((seconds + 1) // step) + 1):
        at, whole = x(k * step), k % 4 == 0
        ink = "#9ca3af" if whole else "#e5e7eb"
        out.append(
            f'<path d="M{at:.1f} {TOP} V{axis.bottom:.1f}" stroke="{ink}" stroke-width="{1 if whole else 0.5}"/>'
        )
        if whole:
            text = f"{k * step // 3600} h"
            out.append(f'<text x="{at:.1f}" y="{TOP - 16}" text-anchor="middle" fill="#374151">{text}</text>')
    return out


def _bands(axis: Axis, left: float, right: float, heading: Event) -> list[str]:
    """Sections with their names, and what is done in them."""
    work = {p["at"]: f" ({n})" for n, p in heading["places"].items() if p["kind"] == "loading"}
    out, written = [], -99.0
    for s, a, b in sorted(axis.bands, key=lambda band: band[1]):
        for y in (a, b):
            out.append(f'<path d="M{left:.1f} {y:.1f} H{right:.1f}" stroke="#d1d5db" stroke-width="0.7"/>')
        y = max((a + b) / 2 + 4, written + 11)
        written = y
        name, at = escape(s + work.get(s, "")), f'x="{left - 8:.1f}" y="{y:.1f}"'
        out.append(f'<text {at} text-anchor="end" fill="#374151">{name}</text>')
    return out


def _train(train: str, line: Line, ink: str, x: Callable[[float], float]) -> list[str]:
    """The line of a train."""
    out = [f'<g {ink} fill="none" stroke-width="1.6"><title>train {escape(train)}</title>']
    for piece in line.pieces:
        if len(piece) > 1:
            out.append('<path d="M' + " L".join(f"{x(t):.1f} {y:.1f}" for t, y in piece) + '"/>')
    for (t, y), (u, z) in line.jumps:
        out.append(f'<path d="M{x(t):.1f} {y:.1f} L{x(u):.1f} {z:.1f}" stroke-dasharray="2 3" stroke-width="0.9"/>')
    for t, u, y in line.loads:
        out.append(f'<path d="M{x(t):.1f} {y:.1f} H{x(u):.1f}" stroke-width="5" stroke-opacity="0.55"/>')
    return [*out, "</g>"]
