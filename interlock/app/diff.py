"""What has changed between two layouts, or two versions of one: in the interlocking table, elements and principles."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields

from interlock.app.check import Checked, check_file
from interlock.app.untold import untold
from interlock.dataclass import dataclass
from interlock.model.elements import (
    Boundary,
    Condition,
    Device,
    Lane,
    MachineId,
    NodeId,
    Overlap,
    Point,
    Section,
    SectionId,
    Signal,
    Work,
)
from interlock.model.figures import exact, metres
from interlock.model.layout import Layout
from interlock.model.pins import Pins
from interlock.model.principles import Principles, written
from interlock.table.changes import Change, TableChanges, named_changes, table_changes


@dataclass(frozen=True)
class Differences:
    """Two checked layouts, and what has changed from the first to the second; None where one of them has errors."""

    old: Checked
    new: Checked
    table: TableChanges | None = None
    elements: tuple[Change, ...] = ()
    principles: tuple[Change, ...] = ()
    channels: tuple[Change, ...] = ()
    """Channels and cards that the files of pins beside the layouts give otherwise."""
    elsewhere: tuple[str, ...] = ()
    """Facts in which the layouts differ beside all that is told above."""
    printed: tuple[str, ...] = ()
    """Of those the ones that are only printed, which no controller knows of."""

    @property
    def ok(self) -> bool:
        """Whether both layouts are without errors."""
        return self.table is not None

    @property
    def same(self) -> bool:
        """Whether nothing differs but what is only printed."""
        nothing = not (self.elements or self.principles or self.channels or self.elsewhere)
        return self.table is not None and self.table.none and nothing


def diff(old: str, new: str) -> Differences:
    """Compare two layout files."""
    a, b = check_file(old), check_file(new)
    if not (a.ok and b.ok) or a.table is None or b.table is None or a.layout is None or b.layout is None:
        return Differences(a, b)
    table = table_changes(a.table, b.table)
    elements = tuple(_elements(a.layout, b.layout))
    principles = tuple(_principles(a.layout, b.layout))
    elsewhere, printed = untold(a.layout, b.layout, table, _described_otherwise(a.layout, b.layout))
    channels = tuple(_channels(a.layout.hardware.pins, b.layout.hardware.pins))
    return Differences(a, b, table, elements, principles, channels, elsewhere, printed)


def _described_otherwise(old: Layout, new: Layout) -> set[str]:
    """The names of the elements of which something is told."""
    pairs = [(texts(old), texts(new)) for texts in _KINDS.values()]
    return {str(n) for was, now in pairs for n in was.keys() | now.keys() if was.get(n) != now.get(n)}


def _elements(old: Layout, new: Layout) -> Iterator[Change]:
    for what, texts in _KINDS.items():
        yield from named_changes(what, texts(old), texts(new))


def _channels(old: Pins, new: Pins) -> Iterator[Change]:
    """What two files of pins say otherwise: of channels, of those that are reserved, and in which slot a card is."""
    if bool(old) is not bool(new):
        pinned = {True: "channels are pinned", False: "none"}
        yield Change("pins", pinned[bool(old)], pinned[bool(new)])
        return

    def said(x: Pins) -> Iterator[tuple[str, str]]:
        yield from ((f"channel {p.variable}", f"{p.substation} {p.address}") for p in x.channels)
        yield from ((f"reserved channel {p.variable}", f"{p.substation} {p.address}") for p in x.reserved)
        yield from ((f"card in slot {c.slot} of {c.substation}", f"{c.direction}{c.byte}") for c in x.cards)

    was, now = dict(said(old)), dict(said(new))
    for what in {**was, **now}:
        if was.get(what) != now.get(what):
            yield Change(what, was.get(what), now.get(what))


def _principles(old: Layout, new: Layout) -> Iterator[Change]:
    if old.profile != new.profile:
        yield Change("profile", old.profile, new.profile)
    for f in fields(Principles):
        was, now = (written(getattr(x.principles, f.name)) for x in (old, new))
        if was != now:
            yield Change(f.name, was, now)


Described = dict[str, tuple[str, ...]]
"""Elements by name, each with what is said of it."""


def _words(*parts: str) -> tuple[str, ...]:
    return tuple(p for p in parts if p)


def _over(names: tuple[str, ...]) -> str:
    return f"over {', '.join(names)}" if names else ""


def _sections(layout: Layout) -> Described:
    def text(s: Section) -> tuple[str, ...]:
        length = sum(e.length for e in layout.track.edges_in.get(s.id, ()))
        return _words(
            "outside" if s.approach else f"{metres(length)}",
            "" if s.detected else "without detection",
            "" if s.speed is None else f"{s.speed} km/h",
            "inclined" if s.lane is Lane.INCLINED else "",
            _one_way(layout, s.id),
            "berth: no" if s.id in layout.declared.no_berths else "",
        )

    return {s.id: text(s) for s in layout.track.sections}


def _one_way(layout: Layout, s: SectionId) -> str:
    """Where trains run that run one way: into which sections, or to which end of the track."""
    track = layout.track
    ways = [e for e in track.edges_in.get(s, ()) if e.one_way]
    onward = {e.b: {x.section for x in track.edges_at[e.b]} - {s} for e in ways}
    ends = {str(n) for n in onward if n in track.boundary_at or n in track.buffer_at}
    to = sorted(ends.union(*onward.values()))
    return f"one way to {', '.join(to)}" if to else "one way" if ways else ""


def _supervision(layout: Layout, m: MachineId) -> str:
    own = dict(layout.pointwork.supervision)
    return f"supervision {exact(own[m])} s" if m in own else ""


def _overlap_ways(layout: Layout, s: Signal) -> tuple[str, ...]:
    """Alternatives of its overlap with values of their own, and over what none leads."""
    ways = [w for w in layout.overlaps.ways if w.signal == s.id]
    at = ["" if w.entry is None else f" for {w.entry} km/h" for w in ways]
    texts = [
        f"overlap over {', '.join(w.over)} {Overlap(s.id, w.length).text}{x}" for w, x in zip(ways, at, strict=True)
    ]
    return *texts, *(f"no overlap over {x}" for g, x in layout.overlaps.bars if g == s.id)


def _signals(layout: Layout) -> Described:
    g, overlaps = layout.signalling, layout.overlaps
    held = dict(g.releases)
    entry, own, stands = dict(overlaps.entry_speeds), dict(overlaps.releases), {o.signal: o for o in overlaps.all}

    def text(s: Signal) -> tuple[str, ...]:
        into = layout.track.section_of(s.into)
        rear = next((e.section for e in layout.track.edges_at[s.node] if e.id != s.into), s.node)
        o = stands.get(s.id)
        return _words(
            "board" if s.id in g.boards else str(s.kind),
            f"from {rear} into {into}",
            "call-on" if s.call_on else "",
            "stops trains" if s.id in g.stops else "",
            "identifier" if s.id in g.identifiers else "",
            "" if o is None else f"overlap {o.text}" + (", may swing" if o.swing else ""),
            *_overlap_ways(layout, s),
            f"overlap for {entry[s.id]} km/h" if s.id in entry else "",
            f"overlap released after {exact(own[s.id])} s" if s.id in own else "",
            f"held {exact(held[s.id])} s after a cancellation" if s.id in held else "",
        )

    return {s.id: text(s) for s in g.signals}


def _points(layout: Layout) -> Described:
    blades = {b.point: b for b in layout.pointwork.blades}

    def text(p: Point) -> tuple[str, ...]:
        lie, hand = blades.get(p.id), layout.pointwork.hand.get(p.id)
        return _words(
            "derailer" if p.derailer else "",
            f"in {layout.track.section_of(p.toe)}",
            f"machine {p.machine}" if str(p.machine) != str(p.id) else "",
            "" if p.work is Work.MOTOR else "worked by hand",
            f"fouling point {exact(p.fouling)} m",
            "" if p.speed is None else f"{p.speed} km/h",
            _supervision(layout, p.machine),
            "" if lie is None else f"blades at {' and '.join(lie.at)} to {lie.normal}, or to {lie.reverse}",
            "" if hand is None else f"reverse to the {hand}",
        )

    return {p.id: text(p) for p in layout.pointwork.points}


def _ends(layout: Layout) -> Described:
    def text(b: Boundary) -> tuple[str, ...]:
        block = "" if b.block == "none" else f"block {b.block}"
        outside = "" if b.approach is None else f"approach {b.approach} {exact(b.approach_m)} m"
        button, shown = f"button {b.button}" if b.button else "", "route indicator" if b.indicator else ""
        return _words("" if b.kind == "both" else f"trains {b.kind}", outside, block, button, shown)

    return {b.node: text(b) for b in layout.track.boundaries}


def _devices(layout: Layout) -> Described:
    def text(d: Device) -> tuple[str, ...]:
        lock = f"of air lock {d.air_lock}" if d.air_lock else ""
        return _words(str(d.kind), lock, d.text, _over(d.over), _supervision(layout, d.id))

    return {d.id: text(d) for d in layout.signalling.devices}


def _conditions(layout: Layout) -> Described:
    def text(c: Condition) -> tuple[str, ...]:
        signals, exits = ", ".join(c.signals), ", ".join(map(NodeId, c.exits))
        return _words(c.text, _over(c.over), f"from {signals}" if signals else "", f"out at {exits}" if exits else "")

    return {c.id: text(c) for c in layout.signalling.conditions}


_KINDS: Mapping[str, Callable[[Layout], Described]] = {
    "boundary": _ends,
    "end of track": lambda layout: {b.node: (str(b.kind),) for b in layout.track.buffers},
    "section": _sections,
    "point": _points,
    "crossing": lambda layout: {
        c.id: (f"in {layout.track.section_of(c.arms[0][0])}", f"fouling point {exact(c.fouling)} m")
        for c in layout.pointwork.crossings
    },
    "signal": _signals,
    "distant signal": lambda layout: {d.id: (f"of {d.of}",) for d in layout.signalling.distants},
    "device": _devices,
    "condition": _conditions,
    "zone": lambda layout: {z.id: (f"trains {z.trains}", _over(z.sections)) for z in layout.declared.zones},
}
"""What an element is called, and its description: those that differ are told."""
