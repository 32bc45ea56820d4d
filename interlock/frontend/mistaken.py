"""A name that the file has, of another kind than is wanted: a track for its section, a section for an end of its track.

Input: the file and the name.  Output: a sentence that says what it is, and what to write instead; empty where nothing
of the file bears the name.
"""

from __future__ import annotations

from collections.abc import Iterable

from interlock.frontend.scalars import item_parts
from interlock.frontend.schema import LayoutFile

ENDS = {
    "point": ("toe", "normal", "reverse"),
    "crossing": ("1a", "1b", "2a", "2b"),
    "slip": ("1a", "1b", "2a", "2b"),
    "derailer": ("outer", "inner"),
}
"""The ends of what is no track, by kind."""


def ends_of_layout(f: LayoutFile) -> frozenset[str]:
    """Boundaries, buffers and traps: where tracks end, and no section begins."""
    return frozenset((*f.boundaries, *f.buffers, *f.traps))


def is_end(f: LayoutFile, item: str) -> bool:
    """Whether an item of a track is an end of something else: `west.end`, `P1.toe`."""
    name, dot, end = item.partition(".")
    rooms = {"point": {*f.points}, "crossing": {*f.crossings}, "slip": {*f.slips}, "derailer": {*f.derailers}}
    ends = {x for kind, names in rooms.items() if name in names for x in ENDS[kind]}
    return bool(dot) and (end in ends or (name in f.tracks and end in ("start", "end")))


def for_a_section(f: LayoutFile, name: str, *, of_a_signal: bool = False) -> str:
    """What to write where a section is wanted and `name` is something else."""
    if name in f.tracks:
        inside = _sections(f, name)
        if inside:
            return f"{name} is a track: write {_one_of('its section', inside)}"
    lying = _lying(f)
    if name in lying:
        kind, sections = lying[name]
        return f"{name} is a {kind}: write {_one_of('its section', sections)}"
    if name in f.boundaries and of_a_signal:
        return (
            f"{name} is a boundary: a signal leads into a section; give the road before {name} a section of its own, "
            f"with {name} behind it"
        )
    if name in f.boundaries:
        return f"{name} is a boundary, where the layout ends; name the section before it"
    if name in f.buffers or name in f.traps:
        what = f"{name} is a {'buffer' if name in f.buffers else 'trap'}, where a track ends"
        rest = "a signal stands at the joint between two sections" if of_a_signal else "name the section before it"
        return f"{what}; {rest}"
    return ""


def for_an_end(f: LayoutFile, name: str) -> str:
    """What to write where an end of a track, point, crossing, slip or derailer is wanted and `name` is a section."""
    for track in f.tracks:
        inside = _sections(f, track)
        if name in inside:
            free = [end for end, at in (("start", 0), ("end", -1)) if f.tracks[track][at] not in ends_of_layout(f)]
            ends = [end for end, at in (("start", 0), ("end", -1)) if inside[at] == name and end in free]
            written = " or ".join(f"{track}.{end}" for end in ends)
            where = f"{name} is a section of the track {track}"
            return f"{where}: write {written}" if written else f"{where}, which has ends of its own"
    for element, (kind, sections) in _lying(f).items():
        if name in sections:
            return f"{name} is the section of the {kind} {element}: write {_any_end(kind, element)}"
    return ""


def for_an_end_or_section(f: LayoutFile, name: str) -> str:
    """What to write where a section or one end of a point, crossing, slip or derailer is wanted (`P1.reverse`)."""
    element, _, end = name.partition(".")
    lying = _lying(f)
    if element in lying and (not end or end not in ENDS[lying[element][0]]):
        kind = lying[element][0]
        return f"{element} is a {kind}: write one of its ends, {_any_end(kind, element)}"
    return for_a_section(f, name)


def _any_end(kind: str, name: str) -> str:
    *others, last = (f"{name}.{end}" for end in ENDS[kind])
    return f"{', '.join(others)} or {last}"


def _sections(f: LayoutFile, track: str) -> tuple[str, ...]:
    """The sections of a track in order, as far as its items can be read."""
    parts = (item_parts(item) for item in f.tracks[track])
    return tuple(dict.fromkeys(name for name, metres in parts if metres))


def _lying(f: LayoutFile) -> dict[str, tuple[str, tuple[str, ...]]]:
    """What lies in sections, with its kind and those sections."""
    found: dict[str, tuple[str, tuple[str, ...]]] = {n: ("point", (p.section,)) for n, p in f.points.items()}
    found |= {n: ("derailer", (d.section,)) for n, d in f.derailers.items()}
    found |= {n: ("crossing", tuple(dict.fromkeys(a.section for a in c.arms))) for n, c in f.crossings.items()}
    return found | {n: ("slip", (s.section,)) for n, s in f.slips.items()}


def _one_of(what: str, names: Iterable[str]) -> str:
    listed = tuple(names)
    return f"{what}, {listed[0]}" if len(listed) == 1 else f"one of {what}s: {', '.join(listed)}"
