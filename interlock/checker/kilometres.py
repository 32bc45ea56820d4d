"""Lengths of track that follow from positions along the line, read from the layout alone.

A position is `12+345.6`: in a track it lies where the next section begins, and before what follows the last one; the
`km` of a signal is that of the joint of its two sections, the `km` of a point that of its node, so that what is joined
to it begins a leg further on.  Positions must agree with each other and with the lengths that are stated.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import Any

from interlock.verify import need

Parts = list[tuple[str, float | None]]
NEAR = 0.0005  # metres


def place(text: str) -> float:
    """Metres of a position."""
    whole, _, rest = text.partition("+")
    need(whole.isdigit() and rest[:3].isdigit(), f"{text} is no position")
    return round(float(whole) * 1000 + float(rest), 3)


def item_parts(text: str) -> tuple[str, str]:
    """A section's name, in which spaces may be, and its length in metres: the last word, where that is a number."""
    words = text.rsplit(maxsplit=1)
    if len(words) == 2 and re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)", words[1]):
        return words[0].lstrip(), words[1]
    return text.strip(), ""


def parted(stated: Iterable[tuple[str, str]], ends: Iterable[str]) -> tuple[Parts, dict[int, float]]:
    """The sections of a track with the lengths that are stated, and the positions between them."""
    parts: Parts = []
    places: dict[int, float] = {}
    for name, metres in stated:
        if metres:
            parts.append((name, float(metres)))
        elif "+" in name:
            need(len(parts) not in places, f"{name} follows a position")
            places[len(parts)] = place(name)
        elif name not in ends and "." not in name:
            parts.append((name, None))
    return parts, places


class Measures:
    """Lengths of the tracks of one layout.  sides: for each track what lies at its start and at its end, as section or
    boundary, and the port that is joined there."""

    def __init__(
        self,
        body: Mapping[str, Any],
        tracks: Mapping[str, tuple[Parts, dict[int, float]]],
        sides: Mapping[str, tuple[tuple[str, str], tuple[str, str]]],
        leg_m: float,
    ) -> None:
        self.body, self.tracks, self.sides, self.leg_m = body, tracks, sides, leg_m
        for name, v in (body.get("signals") or {}).items():
            if "km" in v:
                self._signal(name, v)

    def _agree(self, track: str, joint: int, metres: float) -> None:
        told = self.tracks[track][1].setdefault(joint, metres)
        need(abs(told - metres) <= NEAR, f"two positions of one joint of track {track} differ")

    def _signal(self, name: str, v: Mapping[str, Any]) -> None:
        """Every joint between the two sections of a signal; it stands at one, which two tracks may share."""
        there: set[tuple[str, ...]] = set()
        for t, (parts, _) in self.tracks.items():
            (first, port), (last, other) = self.sides[t]
            row = [first, *(s for s, _ in parts), last]
            for i in range(len(row) - 1):
                ports = {0: port, len(parts): other}.get(i)
                aside = "at" in v and (ports is None or ports.partition(".")[0] != v["at"])
                if {row[i], row[i + 1]} == {v["from"], v["into"]} and not aside:
                    self._agree(t, i, place(v["km"]))
                    own = f"{t}.{'start' if i == 0 else 'end'}"
                    there.add((t, str(i)) if ports is None else tuple(sorted((own, ports))))
        need(len(there) == 1, f"the position of signal {name} is that of no joint, or of several")

    def lengths(self, track: str) -> list[tuple[str, float]]:
        """The sections of a track with their lengths."""
        parts, places = self.tracks[track]
        self._points(track)
        known = sorted(places)
        steps = [places[b] - places[a] for a, b in pairwise(known)]
        need(all(x > NEAR for x in steps) or all(x < -NEAR for x in steps), f"positions of {track} go back and forth")
        out = list(parts)
        for (a, b), step in zip(pairwise(known), steps, strict=True):
            free = [i for i in range(a, b) if out[i][1] is None]
            left = abs(step) - sum(x for _, x in out[a:b] if x is not None)
            need(len(free) < 2, f"positions do not tell the lengths of {track}")
            if free:
                need(left > NEAR, f"there is no room in {track}")
                out[free[0]] = (out[free[0]][0], round(left, 3))
            else:
                need(abs(left) <= NEAR, f"positions and lengths of {track} differ")
        need(all(x is not None for _, x in out), f"a length of {track} is missing")
        return [(s, float(x or 0.0)) for s, x in out]

    def _points(self, track: str) -> None:
        parts, places = self.tracks[track]
        found = {}
        for joint, (_, port) in zip((0, len(parts)), self.sides[track], strict=True):
            v = (self.body.get("points") or {}).get(port.partition(".")[0], {})
            if "km" in v:
                found[joint] = place(v["km"]), float(v.get("legs", self.leg_m))
        stated = dict(places)
        for joint, (km, legs) in found.items():
            others = [x for k, x in stated.items() if k != joint] or [x for k, (x, _) in found.items() if k != joint]
            if others:
                self._agree(track, joint, round(km + (legs if others[0] > km else -legs), 3))
