"""Names of sections that have no level track: beside their slanting tracks, nearer to them than to any other."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import dist, hypot

from interlock.emit.drawing.canvas import Drawing, Label, Spot
from interlock.model.elements import SectionId

CELL = 96.0
"""Pixels of the squares in which tracks are looked up; a name stands nearer than that to its own."""

ROOM = 12.0  # before and after a name
CLEAR = 5.0  # between a name and the line that it stands beside
PLAIN = 2.0  # by which its own track is nearer at least
PLACES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)  # along a track


class Tracks:
    """The lines of a plan by the squares through which they run, with their sections."""

    def __init__(self, d: Drawing) -> None:
        self._in: dict[tuple[int, int], set[tuple[Spot, Spot, SectionId]]] = {}
        for e in d.layout.track.edges:
            for a, b in pairwise(d.edges[e.id]):
                steps = int(dist(a, b) / (CELL / 2)) + 1
                for k in range(steps + 1):
                    x, y = (a[i] + (b[i] - a[i]) * k / steps for i in (0, 1))
                    self._in.setdefault((int(x // CELL), int(y // CELL)), set()).add((a, b, e.section))

    def is_near(self, label: Label, section: SectionId) -> bool:
        """Whether a name stands plainly nearer to the track of a section than to any other."""
        left, top, right, bottom = label.box
        spot = ((left + right) / 2, (top + bottom) / 2)
        near = (int(spot[0] // CELL), int(spot[1] // CELL))
        own, other = CELL, CELL
        for cell in ((near[0] + i, near[1] + j) for i in (-1, 0, 1) for j in (-1, 0, 1)):
            for a, b, of in self._in.get(cell, ()):
                far = _far(a, b, spot)
                own, other = (min(own, far), other) if of == section else (own, min(other, far))
        return own < CELL and own + PLAIN < other


def _far(a: Spot, b: Spot, p: Spot) -> float:
    """Pixels from a spot to a stroke."""
    long = max(1e-9, dist(a, b) ** 2)
    part = max(0.0, min(1.0, ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / long))
    return hypot(p[0] - a[0] - part * (b[0] - a[0]), p[1] - a[1] - part * (b[1] - a[1]))


def places(d: Drawing, label: Label) -> Iterator[Label]:
    """A name on either side of each slanting track of its section, in the middle first."""
    left, top, right, bottom = label.box
    wide, high = right - left, bottom - top
    strokes = [
        (a, b) for e in d.layout.track.edges_in[SectionId(label.id)] for a, b in pairwise(d.edges[e.id]) if a[1] != b[1]
    ]
    for part in PLACES:
        for a, b in sorted(strokes, key=lambda s: -dist(*s)):
            ux, uy = (b[0] - a[0]) / dist(a, b), (b[1] - a[1]) / dist(a, b)
            off = (
                (wide + ROOM) * abs(uy) + high * abs(ux)
            ) / 2 + CLEAR  # so that its nearest corner is clear of the line
            for side in (-1, 1) if not label.small else (1, -1):
                x = a[0] + (b[0] - a[0]) * part - side * uy * off * (1 if uy > 0 else -1)
                y = a[1] + (b[1] - a[1]) * part + side * ux * off * (1 if uy > 0 else -1)
                yield label.moved(x - (left + right) / 2, y - (top + bottom) / 2)
