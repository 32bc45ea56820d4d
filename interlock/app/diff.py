"""What has changed between two layouts, or two versions of one: in the interlocking table, elements and principles."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields

from interlock.app.check import Checked, check_file
from interlock.dataclass import dataclass
from interlock.model.elements import Boundary, Condition, Device, NodeId, Point, Section, Signal, Work
from interlock.model.layout import Layout
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
    elsewhere: bool = False
    """The layouts differ in what is not compared, and in nothing else."""

    @property
    def ok(self) -> bool:
        """Whether both layouts are without errors."""
        return self.table is not None

    @property
    def same(self) -> bool:
        """Whether nothing that is compared differs."""
        return self.table is not None and self.table.none and not self.elements and not self.principles


def diff(old: str, new: str) -> Differences:
    """Compare two layout files."""
    a, b = check_file(old), check_file(new)
    if not (a.ok and b.ok) or a.table is None or b.table is None or a.layout is None or b.layout is None:
        return Differences(a, b)
    table = table_changes(a.table, b.table)
    elements = tuple(_elements(a.layout, b.layout))
    principles = tuple(_principles(a.layout, b.layout))
    alike = table.none and not elements and not principles
    return Differences(a, b, table, elements, principles, alike and a.layout.digest != b.layout.digest)


def _elements(old: Layout, new: Layout) -> Iterator[Change]:
    for what, texts in _KINDS.items():
        yield from named_changes(what, texts(old), texts(new))


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
        metres = sum(e.length for e in layout.track.edges_in.get(s.id, ()))
        return _words(
            "outside" if s.approach else f"{metres:g} m",
            "" if s.detected else "without detection",
            "" if s.speed is None else f"{s.speed} km/h",
            "berth: no" if s.id in layout.declared.no_berths else "",
        )

    return {s.id: text(s) for s in layout.track.sections}


def _signals(layout: Layout) -> Described:
    g, overlaps = layout.signalling, layout.overlaps
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
            f"overlap for {entry[s.id]} km/h" if s.id in entry else "",
            f"overlap released after {own[s.id]:g} s" if s.id in own else "",
        )

    return {s.id: text(s) for s in g.signals}


def _points(layout: Layout) -> Described:
    own = dict(layout.pointwork.supervision)

    def text(p: Point) -> tuple[str, ...]:
        return _words(
            "derailer" if p.derailer else "",
            f"in {layout.track.section_of(p.toe)}",
            f"machine {p.machine}" if str(p.machine) != str(p.id) else "",
            "" if p.work is Work.MOTOR else "worked by hand",
            f"fouling point {p.fouling:g} m",
            "" if p.speed is None else f"{p.speed} km/h",
            f"supervision {own[p.machine]:g} s" if p.machine in own else "",
        )

    return {p.id: text(p) for p in layout.pointwork.points}


def _ends(layout: Layout) -> Described:
    def text(b: Boundary) -> tuple[str, ...]:
        block = "" if b.block == "none" else f"block {b.block}"
        outside = "" if b.approach is None else f"approach {b.approach} {b.approach_m:g} m"
        return _words("" if b.kind == "both" else f"trains {b.kind}", outside, block)

    return {b.node: text(b) for b in layout.track.boundaries}


def _devices(layout: Layout) -> Described:
    def text(d: Device) -> tuple[str, ...]:
        return _words(str(d.kind), _over(d.over))

    return {d.id: text(d) for d in layout.signalling.devices}


def _conditions(layout: Layout) -> Described:
    def text(c: Condition) -> tuple[str, ...]:
        signals, exits = ", ".join(c.signals), ", ".join(map(NodeId, c.exits))
        return _words(_over(c.over), f"from {signals}" if signals else "", f"out at {exits}" if exits else "")

    return {c.id: text(c) for c in layout.signalling.conditions}


_KINDS: Mapping[str, Callable[[Layout], Described]] = {
    "boundary": _ends,
    "end of track": lambda layout: {b.node: (str(b.kind),) for b in layout.track.buffers},
    "section": _sections,
    "point": _points,
    "crossing": lambda layout: {
        c.id: (f"in {layout.track.section_of(c.arms[0][0])}",) for c in layout.pointwork.crossings
    },
    "signal": _signals,
    "distant signal": lambda layout: {d.id: (f"of {d.of}",) for d in layout.signalling.distants},
    "device": _devices,
    "condition": _conditions,
    "zone": lambda layout: {z.id: (f"trains {z.trains}", _over(z.sections)) for z in layout.declared.zones},
}
"""What an element is called, and its description: those that differ are told."""
