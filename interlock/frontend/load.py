"""The front end as one function: text in, `Layout` out, every problem reported.

Order of passes: read, YAML tree, schema, names, wiring, resolve, checks.  A pass runs only when the ones
before it left something to work on, so that one mistake is reported once.
"""

from __future__ import annotations

import difflib
import os
from dataclasses import field, replace

from interlock.dataclass import dataclass
from interlock.diag import Element, Sink, Span
from interlock.frontend.added import named_kinds, resolve_barred, resolve_demanded, unlisted
from interlock.frontend.cabinets import (
    resolve_addresses,
    resolve_anchors,
    resolve_drawing,
    resolve_health,
    resolve_substations,
    resolve_target,
)
from interlock.frontend.checks import CHECKS
from interlock.frontend.context import Context
from interlock.frontend.encoding import decode
from interlock.frontend.names import check_names
from interlock.frontend.overlaps import resolve_overlaps, with_releases
from interlock.frontend.pins import PinsRead, beside, read_pins
from interlock.frontend.places import Places
from interlock.frontend.ports import Wiring
from interlock.frontend.resolve import (
    boards,
    check_signal_names,
    hands,
    identifiers,
    no_section,
    resolve_automatic,
    resolve_conditions,
    resolve_devices,
    resolve_distants,
    resolve_excludes,
    resolve_routes,
    resolve_signals,
    resolve_supervision,
    resolve_voyages,
    resolve_waivers,
    resolve_zones,
    signal_releases,
    stops,
    title_block,
)
from interlock.frontend.schema import LayoutFile
from interlock.frontend.validate import validate
from interlock.frontend.wiring import Wirer
from interlock.frontend.yaml_tree import parse
from interlock.model.elements import (
    Anchor,
    Barred,
    Condition,
    Demanded,
    DemandedClear,
    Device,
    Distant,
    Exclude,
    Health,
    Lane,
    NamedRoute,
    Section,
    SectionId,
    Signal,
    Substation,
    Voyage,
    Waiver,
    Zone,
)
from interlock.model.layout import Declared, Hardware, Layout, Printed
from interlock.model.principles import KNOBS, PROFILES, Principles
from interlock.model.signalling import Overlaps, Signalling
from interlock.model.too_many import TooManyWays
from interlock.model.track import Pointwork, Track

MAX_BYTES = 4_000_000


@dataclass(frozen=True)
class Source:
    """A layout file as read: its name, its text, and the context for later diagnostics; the same of the pins beside it
    (their text even where it cannot be read)."""

    file: str
    text: str
    context: Context | None = None
    pins: PinsRead | None = None
    beside: tuple[tuple[str, str], ...] = ()
    data: bytes = field(default=b"", repr=False)
    """The bytes of which the text was made.  Whoever asks for them later asks here: the file may be another by then."""
    pins_data: bytes | None = field(default=None, repr=False)
    """Those of the pins; None where none were read."""

    @property
    def texts(self) -> dict[str, str]:
        """The text of every file of which diagnostics may speak."""
        return {self.file: self.text, **dict(self.beside)}

    def check_allowed(self, sink: Sink) -> None:
        """Report what `allow` allows and nothing needs; all warnings have been given by now."""
        for i, x in enumerate(self.context.file.allow if self.context else ()):
            for k, name in enumerate(x.at):
                if self.context is not None and (x.lint, name) not in sink.spared:
                    text = f"{x.lint} would not be given at {name}: the allowance allows nothing"
                    span, fix = self.context.at("allow", i, "at", k), "remove it, or correct the name"
                    sink.add("IL2018", text, span, fix, cause=x.lint, note=name)

    def at(self, *path: str | int) -> Span:
        """The place of an element for diagnostics of later phases."""
        return self.context.at_key(*path) if self.context else Span(self.file, 1, 1)


def _beside(path: str) -> str:
    """The layout with nearly that name in the same folder; empty where there is none."""
    folder, name = os.path.split(path)
    try:
        there = [n for n in os.listdir(folder or ".") if n.endswith((".yaml", ".yml"))]
    except OSError:
        return ""
    return next((os.path.join(folder, n) for n in difflib.get_close_matches(name, there, n=1, cutoff=0.75)), "")


def read(path: str, sink: Sink, layout: str = "") -> tuple[str | None, str, bytes]:
    """The text of a file, or None with IL1001, IL1002 or IL1003; what can be shown of it; and its bytes.

    `layout`: the layout file beside which this one is read as its pins; empty where this is the layout.
    """
    what = "file of pins" if layout else "layout"
    try:
        if os.path.isdir(path):
            said, fix = f"{path} is a folder", "name a layout file, for instance mine11.yaml"
            if layout:
                said += f"; the channels of {layout} are read from a file of that name"
                fix = "move the folder away, or give it another name"
            sink.add("IL1001", said, Span(path, 0, 0), fix)
            return None, "", b""
        if os.path.getsize(path) > MAX_BYTES:
            sink.add(
                "IL1003",
                f"{path} has {os.path.getsize(path) / 1e6:.0f} MB",
                Span(path, 0, 0),
                f"a {what} has at most {MAX_BYTES // 1_000_000} MB; is this another kind of file?",
            )
            return None, "", b""
        with open(path, "rb") as handle:
            data = handle.read(MAX_BYTES + 1)
    except OSError as error:
        near = "" if os.path.lexists(path) else _beside(path)
        fix = f"did you mean {near}?" if near else "check the name and the permissions"
        sink.add("IL1001", f"{path}: {error.strerror}", Span(path, 0, 0), fix)
        return None, "", b""
    return *decode(path, data, sink, what), data


def load(path: str, sink: Sink) -> tuple[Layout | None, Source]:
    """Read and resolve a layout file, and the pins beside it; the layout is None when there are errors."""
    text, shown, data = read(path, sink)
    if text is None:
        return None, Source(path, shown)
    layout, source = load_text(path, text, sink)
    source = replace(source, data=data)
    file = beside(path)
    if layout is None or not os.path.lexists(file):
        return layout, source
    text, shown, data = read(file, sink, path)
    pins = None if text is None else read_pins(file, text, layout.name, sink)
    shown = shown if text is None else text
    source = replace(source, pins=pins, beside=((file, shown),), pins_data=data)
    return None if pins is None else replace(layout, hardware=replace(layout.hardware, pins=pins.pins)), source


@dataclass(frozen=True)
class _Named:
    """What names elements of the wiring, without its signals."""

    conditions: tuple[Condition, ...]
    zones: tuple[Zone, ...]
    devices: tuple[Device, ...]
    routes: tuple[NamedRoute, ...]
    voyages: tuple[Voyage, ...]
    automatic: tuple[NamedRoute, ...]
    waivers: tuple[Waiver, ...]
    excluded: tuple[Exclude, ...]
    barred: tuple[Barred, ...]
    demanded: tuple[Demanded | DemandedClear, ...]

    @classmethod
    def of(cls, ctx: Context, wiring: Wiring) -> _Named:
        """Resolved in the order in which problems are reported."""
        return cls(
            resolve_conditions(ctx, wiring),
            resolve_zones(ctx, wiring),
            resolve_devices(ctx, wiring),
            resolve_routes(ctx, wiring),
            resolve_voyages(ctx, wiring),
            resolve_automatic(ctx, wiring),
            resolve_waivers(ctx),
            resolve_excludes(ctx, wiring),
            resolve_barred(ctx, wiring),
            resolve_demanded(ctx, wiring),
        )


@dataclass(frozen=True)
class _Placed:
    """Signals, and what is resolved when they are there."""

    signals: tuple[Signal, ...]
    overlaps: Overlaps
    distants: tuple[Distant, ...]
    substations: tuple[Substation, ...]
    health: tuple[Health, ...]
    drawing: tuple[tuple[SectionId, int], ...]
    anchors: tuple[Anchor, ...]

    @classmethod
    def of(cls, ctx: Context, principles: Principles, wiring: Wiring, signals: tuple[Signal, ...]) -> _Placed:
        """Resolved in the order in which problems are reported."""
        return cls(
            signals,
            resolve_overlaps(ctx, principles, signals, wiring),
            resolve_distants(ctx, signals),
            resolve_substations(ctx, wiring),
            resolve_health(ctx),
            resolve_drawing(ctx, wiring),
            resolve_anchors(ctx, wiring, signals),
        )


def _sections(ctx: Context, wiring: Wiring) -> list[Section]:
    """The sections inside the layout, and the approach sections outside of it."""
    stated = ctx.file.sections
    inside = [
        Section(SectionId(s), False, Lane(x.lane), x.detected, x.speed)
        if (x := stated.get(s))
        else Section(SectionId(s))
        for s in wiring.sections
    ]
    return inside + [Section(SectionId(s), True) for s in wiring.approaches]


def _layout(ctx: Context, principles: Principles, wiring: Wiring, named: _Named, placed: _Placed) -> Layout:
    return Layout(
        name=ctx.file.name,
        profile=ctx.file.profile,
        principles=principles,
        overlaps=placed.overlaps,
        track=Track(
            sections=tuple(sorted(_sections(ctx, wiring), key=lambda s: s.id)),
            edges=tuple(sorted(wiring.edges, key=lambda e: e.id)),
            boundaries=tuple(sorted(wiring.boundaries, key=lambda b: b.node)),
            buffers=tuple(sorted(wiring.buffers, key=lambda b: b.node)),
        ),
        pointwork=Pointwork(
            points=tuple(sorted(wiring.points, key=lambda p: p.id)),
            crossings=tuple(sorted(wiring.crossings, key=lambda c: c.id)),
            supervision=resolve_supervision(ctx, wiring),
            hands=hands(ctx),
            blades=tuple(sorted(wiring.blades, key=lambda b: b.point)),
        ),
        signalling=Signalling(
            signals=placed.signals,
            conditions=named.conditions,
            devices=named.devices,
            distants=placed.distants,
            boards=boards(ctx),
            stops=stops(ctx),
            identifiers=identifiers(ctx),
            releases=signal_releases(ctx),
        ),
        declared=Declared(
            waivers=named.waivers,
            named_routes=named.routes,
            excluded=named.excluded,
            voyages=named.voyages,
            automatic=named.automatic,
            zones=named.zones,
            barred=named.barred,
            demanded=named.demanded,
            unlisted=unlisted(ctx),
            named_kinds=named_kinds(ctx),
            no_berths=tuple(sorted(SectionId(s) for s, x in ctx.file.sections.items() if not x.berth)),
        ),
        hardware=Hardware(
            substations=placed.substations,
            health=placed.health,
            addresses=resolve_addresses(ctx),
            telegram=ctx.file.telegram,
            target=resolve_target(ctx.file.target),
        ),
        printed=Printed(
            title=ctx.file.title,
            drawing=placed.drawing,
            anchors=placed.anchors,
            title_block=title_block(ctx),
            labels={n: b.label for n, b in ctx.file.boundaries.items() if b.label},
        ),
    )


def _principles(data: LayoutFile) -> Principles:
    """Those of the profile, but for what the layout states itself."""
    stated = {k: v for k in KNOBS if (v := getattr(data.principles, k)) is not None}
    return replace(PROFILES[data.profile], **stated)


def load_text(file: str, text: str, sink: Sink) -> tuple[Layout | None, Source]:
    """Resolve a layout from its text."""
    root = parse(file, text, sink)
    if root is None or sink.has_errors:
        return None, Source(file, text)
    data = validate(root, sink)
    if data is None:
        return None, Source(file, text)
    ctx = Context(data, root, sink)
    source = Source(file, text, ctx)
    sink.allowed = frozenset((x.lint, name) for x in data.allow for name in x.at)
    principles = _principles(data)
    wiring = Wirer(ctx, principles).run()
    sink.locate = Places(ctx, {**wiring.approaches, **wiring.sections})
    check_names(ctx, {**wiring.sections, **wiring.approaches})
    _check_sections(ctx, wiring)
    check_signal_names(ctx, wiring)
    named = _Named.of(ctx, wiring)
    if sink.has_errors:
        return None, source
    signals = resolve_signals(ctx, wiring)
    if sink.has_errors:
        return None, source
    placed = _Placed.of(ctx, principles, wiring, signals)
    if sink.has_errors:
        return None, source
    layout = _layout(ctx, principles, wiring, named, placed)
    try:
        layout = with_releases(ctx, layout)
        for check in CHECKS:
            check(ctx, layout)
    except TooManyWays as beyond:
        sink.add("IL3049", beyond.text, None, beyond.fix, about=Element(beyond.room, beyond.name))
    return (None if sink.has_errors else layout), source


def _check_sections(ctx: Context, wiring: Wiring) -> None:
    for name in ctx.file.sections:
        if not ctx.sink.has("IL1021"):
            no_section(ctx, wiring, name, ctx.at_key("sections", name), "")
    for name, span in wiring.approaches.items():
        if name in wiring.sections:
            ctx.add(
                "IL3013",
                f"{name} is an approach section and also lies inside the layout",
                span,
                "an approach section lies outside the boundary; give it a name of its own",
            )
