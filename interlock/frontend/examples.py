"""One entry of each part of the language, as it is written: what a message shows to whoever wrote something else there.

Input: the path of the value.  Output: the example, empty where the language has no mapping at that place.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

EXAMPLES: Mapping[str, str] = {
    "boundaries": "{approach: ap_W 600}",
    "points": "{section: q2, toe: west.end, normal: main.start, reverse: loop.start}",
    "crossings": "{arms: [{section: AC, ends: [a.end, b.start]}, {section: BC, ends: [c.end, d.start]}]}",
    "slips": "{section: T5, arms: [[a.end, b.start], [c.end, d.start]]}",
    "derailers": "{section: w5, outer: siding.start, inner: P5.reverse}",
    "level_crossings": "{over: [q4], text: Mill Lane}",
    "interlocks": "{over: [q7], text: door of the shed}",
    "signals": "{from: q1, into: q2}",
    "distants": "{of: X1}",
    "sections": "{speed: 60}",
    "conditions": "{text: hoist stopped, over: [q4]}",
    "zones": "{sections: [q3, q4], trains: 4}",
    "routes": "{from: X1, to: X5}",
    "voyages": "{from: X1, to: E}",
    "overlaps": "{length: 180}",
    "health": "{by: both}",
    "automatic": "{from: X1, to: X3}",
    "exclude": "{from: X1, to: X5, reason: the platform is too short}",
    "hostile": "{one: {from: A, to: N1}, other: {from: E, to: S2}, reason: the platform between them is narrow}",
    "demand": "{point: P3, lies: normal, routes: {from: S1}, reason: loaded wagons stand in the siding}",
    "waive": "{flank: P1.reverse, reason: the siding falls away from the point}",
    "allow": "{lint: IL7007, at: [X1], reason: the points are worked by hand}",
    "principles": "{overlap_m: 180}",
    "target": "{cpu: s7-313}",
    "title_block": "{company: Upper Valley Railway}",
    "crossings.arms": "{section: AC, ends: [a.end, b.start]}",
    "hostile.one": "{from: A, to: N1}",
    "hostile.other": "{from: E, to: S2}",
    "demand.routes": "{from: S1}",
    "overlaps.ways": "{over: [q7], length: 150}",
}
"""By the key of the layout, `key.key` for what lies in an entry of it: the value of one entry."""

LISTS = frozenset({"automatic", "exclude", "hostile", "demand", "waive", "allow"})
"""Keys of the layout with a list of such entries; the others give each a name."""
BARE = frozenset({"boundaries", "sections", "health"})
"""Keys of the layout whose entries may say nothing more than their name."""
WHOLE = frozenset({"principles", "target", "title_block"})
"""Keys of the layout that are one mapping."""


def example_at(path: Sequence[str | int]) -> str:
    """How the value at a path is written, with its key where it has one: `E: {length: 180}`."""
    keys = [str(p) for p in path if isinstance(p, str)]
    if not keys:
        return ""
    room, inner = keys[0], keys[-1]
    deep = f"{room}.{inner}"
    if deep in EXAMPLES:
        return EXAMPLES[deep] if isinstance(path[-1], int) else f"{inner}: {EXAMPLES[deep]}"
    named = room in EXAMPLES and room not in LISTS | WHOLE
    if len(path) == 1 and named:
        return f"{room}: {{NAME: {EXAMPLES[room]}}}"
    if len(path) == 2 and room in LISTS:
        return EXAMPLES[room]
    if (len(path) == 1 and room in WHOLE) or (len(path) == 2 and named):
        return f"{inner}: {EXAMPLES[room]}"
    return ""
