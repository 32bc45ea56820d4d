"""Kilometres: positions along the line, from which lengths of sections follow.

A post in a track (`12+345.6`) stands where it begins or ends, or where two of its sections meet; the `km` of a signal
is where its joint lies; that of a point is where its blades lie, a leg's length from the tracks that are joined to it.
Between two positions at most one section has no length of its own; where all have, they must agree.
Diagnostics IL3028, IL3029.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from itertools import pairwise

from pydantic_core import PydanticCustomError

from interlock.dataclass import dataclass
from interlock.diag import Element, Span
from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.frontend.ports import Port
from interlock.frontend.scalars import KILOMETRE, MAX_LENGTH_M, NAME, item_parts, number_text, position, written_km
from interlock.frontend.schema import LayoutFile

APART = 0.0005  # metres by which two positions of one place may differ: half a millimetre


@dataclass(frozen=True)
class Position:
    """Metres along the line, and who says so."""

    metres: float
    said: str
    span: Span


@dataclass
class Stretch:
    """A section's part of a track; its length may follow from positions."""

    section: str
    length: float | None
    span: Span


@dataclass
class Measured:
    """A track: its stretches, and the positions of its joints, of which there is one more."""

    stretches: list[Stretch]
    posts: dict[int, Position] = field(default_factory=dict)


def has_positions(f: LayoutFile) -> bool:
    """Whether anything in a file has a position, so that lengths may follow from it."""
    posts = (x for items in f.tracks.values() for x in items)
    stated = any(p.km is not None for p in f.points.values()) or any(g.km is not None for g in f.signals.values())
    return stated or any(KILOMETRE.fullmatch(x.strip()) for x in posts)


def is_section(item: str) -> bool:
    """Whether an item of a track can be a section by itself."""
    return NAME.fullmatch(item) is not None and not number_text(item) and not item_parts(item)[1]


def measured(ctx: Context, track: Measured, item: str, span: Span) -> bool:
    """Take the position that an item of a track is; whether it was meant for one.  Reports IL1013, IL3028."""
    if "+" not in item or len(item.split()) != 1:
        return False
    try:
        at = Position(position(item), "a position of the track", span)
    except PydanticCustomError as wrong:
        ctx.add("IL1013", wrong.message(), span, str((wrong.context or {})["fix"]))
        return True
    if len(track.stretches) in track.posts:
        text = f"two positions stand beside each other: {written_km(at.metres)} and the one before it"
        ctx.add("IL3028", text, span, "a section lies between two positions")
    track.posts[len(track.stretches)] = at
    return True


@dataclass(frozen=True)
class Kilometres:
    """The positions of a file; `mate`: what each end is joined to; `beyond`: the section there, or the boundary."""

    ctx: Context
    tracks: Mapping[str, Measured]
    mate: Mapping[Port, tuple[Port, Span]]
    beyond: Mapping[Port, str]
    leg_m: float

    def resolve(self) -> None:
        """Give every stretch its length, and report what cannot be."""
        for name, positions in self._signals():
            for track, joint in positions:
                spec = self.ctx.file.signals[name]
                assert spec.km is not None
                span = self.ctx.at("signals", name, "km")
                self._put(self.tracks[track], joint, Position(spec.km, called("signal", name), span))
        for name, t in self.tracks.items():
            self._points(name, t)
            self._lengths(name, t)

    def _put(self, t: Measured, joint: int, p: Position) -> None:
        old = t.posts.setdefault(joint, p)
        if abs(old.metres - p.metres) > APART:
            text = f"{p.said} says {written_km(p.metres)}, where {old.said} says {written_km(old.metres)}"
            self.ctx.add("IL3028", text, p.span, "correct one of them, or leave one out: the other follows")

    # --- signals ---------------------------------------------------------------------------------

    def _signals(self) -> Iterator[tuple[str, list[tuple[str, int]]]]:
        """For each signal with a position the joints of tracks at which it stands: one place, where tracks may meet."""
        joints: dict[frozenset[str], list[tuple[str, int]]] = {}
        for name, t in self.tracks.items():
            sides = [self.beyond.get(Port("track", name, "start"), "")]
            sides += [s.section for s in t.stretches]
            sides.append(self.beyond.get(Port("track", name, "end"), ""))
            for i, pair in enumerate(pairwise(sides)):
                joints.setdefault(frozenset(pair), []).append((name, i))
        for name, spec in self.ctx.file.signals.items():
            if spec.km is None:
                continue
            found = [x for x in joints.get(frozenset((spec.from_, spec.into)), ()) if self._next_to(x, spec.at)]
            if len({frozenset(self._place(x)) for x in found}) == 1:
                yield name, found
                continue
            text = f"the position of {called('signal', name)} says nothing of a length: its joint lies " + (
                f"at {len(found)} places of tracks" if found else "at no section of a track"
            )
            fix = "leave `km` out, and give positions in the tracks: `[q1, 12+345.6, q2]`"
            self.ctx.add("IL3029", text, self.ctx.at("signals", name, "km"), fix, about=Element("signals", name))

    def _port(self, joint: tuple[str, int]) -> Port | None:
        track, i = joint
        last = len(self.tracks[track].stretches)
        return Port("track", track, "start" if i == 0 else "end") if i in (0, last) else None

    def _place(self, joint: tuple[str, int]) -> tuple[str, ...]:
        """What tells a joint: the ends that meet there, or where it lies within its track."""
        port = self._port(joint)
        if port is None or port not in self.mate:
            return (f"{joint[0]} {joint[1]}",)
        return (str(port), str(self.mate[port][0]))

    def _next_to(self, joint: tuple[str, int], at: str | None) -> bool:
        port = self._port(joint)
        return at is None or (port is not None and port in self.mate and self.mate[port][0].name == at)

    # --- points ----------------------------------------------------------------------------------

    def _points(self, name: str, t: Measured) -> None:
        """Positions of the ends that are joined to points."""
        ends: dict[int, tuple[float, float, Position]] = {}
        for joint, end in ((0, "start"), (len(t.stretches), "end")):
            other = self.mate.get(Port("track", name, end))
            spec = self.ctx.file.points.get(other[0].name) if other and other[0].kind == "point" else None
            if other is None or spec is None or spec.km is None:
                continue
            legs = spec.legs if spec.legs is not None else self.leg_m
            span = self.ctx.at("points", other[0].name, "km")
            ends[joint] = (spec.km, legs, Position(spec.km, f"point {other[0].name}", span))
        for joint, (km, legs, told) in ends.items():
            others = [p.metres for k, p in t.posts.items() if k != joint and p not in (e[2] for e in ends.values())]
            others += [e[0] for k, e in ends.items() if k != joint]
            if not others:
                continue  # one position alone says nothing
            way = 1 if others[0] > km else -1
            said = f"{told.said}, {legs:g} m from it,"
            self._put(t, joint, Position(km + way * legs, said, told.span))

    # --- lengths ---------------------------------------------------------------------------------

    def _lengths(self, name: str, t: Measured) -> None:
        known = sorted(t.posts)
        rising = [t.posts[b].metres > t.posts[a].metres for a, b in pairwise(known)]
        for k, (a, b) in enumerate(pairwise(known)):
            if rising[k] is not rising[0] or abs(t.posts[b].metres - t.posts[a].metres) <= APART:
                there = t.posts[b]
                text = f"{called('track', name)}: {written_km(there.metres)} ({there.said}) does not lie beyond "
                text += f"{written_km(t.posts[a].metres)} ({t.posts[a].said})"
                self.ctx.add("IL3028", text, there.span, "along a track positions rise, or fall, all the way")
                return
        for a, b in pairwise(known):
            self._between(t, a, b)
        for s in t.stretches:
            if s.length is None and not self.ctx.sink.has_errors:
                text = f"{called('section', s.section)} has no length, and the positions of its ends do not give it"
                fix = f"write `{s.section} 100`, or a position at either side: `[12+000, {s.section}, 12+100]`"
                self.ctx.add("IL3029", text, s.span, fix)

    def _between(self, t: Measured, a: int, b: int) -> None:
        """The stretches between two positions."""
        one, two, those = t.posts[a], t.posts[b], t.stretches[a:b]
        apart = abs(two.metres - one.metres)
        free = [s for s in those if s.length is None]
        rest = apart - sum(s.length for s in those if s.length is not None)
        where = f"between {written_km(one.metres)} and {written_km(two.metres)}"
        if not free and abs(rest) > APART:
            what = those[0].section if len(those) == 1 else f"{those[0].section} to {those[-1].section}"
            text = f"{where} lie {apart:g} m, but {what} {'has' if len(those) == 1 else 'have'} {apart - rest:g} m"
            self.ctx.add("IL3028", text, those[0].span, "correct a position or a length, or leave the length out")
        if len(free) == 1:
            if not APART < rest <= MAX_LENGTH_M:
                text = (
                    f"{where} there is no room for {called('section', free[0].section)}: {round(rest, 3):g} m are left"
                )
                self.ctx.add("IL3028", text, free[0].span, "correct a position or a length")
            else:
                free[0].length = round(rest, 3)
