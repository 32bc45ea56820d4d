"""Lengths that are hardly meant.  IL7005.

A vehicle can stand over a section of less than 5 m and touch it with no axle, so that it is not detected; what is
longer than 30 km is no section of a station or a block, but a slip of the point or of the unit.  (Our choice, both.)
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby

from interlock.diag import Element, Span
from interlock.diag.called import called
from interlock.frontend.context import Context
from interlock.frontend.scalars import NAME, item_parts
from interlock.model.elements import EdgeId
from interlock.model.layout import Layout

SHORT_M, LONG_M = 5.0, 30_000.0
LEG_M = (2.0, 300.0)
"""Shortest and longest leg of a point or diamond, distance to a fouling point."""


def check_lengths(ctx: Context, layout: Layout) -> None:
    """Report each length outside the usual range."""
    said_of = set()
    for text, metres, written, at, about in _thousands(ctx):
        said_of.add(at)
        said = f"{text} is {_distance(metres)} long: no point divides thousands"
        fix = f"write {written.replace('.', '')}, or {metres:g} if that is meant"
        ctx.add("IL7005", said, at, fix, about=about)
    for text, metres, (least, most), at, about in (*_stated(ctx), *_sections(ctx, layout)):
        if not least <= metres <= most and at not in said_of:
            what = f"shorter than {least:g} m" if metres < least else f"longer than {_distance(most)}"
            ctx.add(
                "IL7005",
                f"{text} is {_distance(metres)} long, {what}",
                at,
                "lengths are metres, decimals follow a point: 0.6 km is 600",
                about=about,
            )


def _thousands(ctx: Context) -> Iterator[tuple[str, float, str, Span, Element]]:
    """Lengths of sections with a point and three digits after it, of which nobody tells whether thousands are meant:
    what it is of, metres, as written, place and element."""
    found: list[tuple[str, tuple[str, str, str | int]]] = [
        (item, ("tracks", t, i)) for t, those in ctx.file.tracks.items() for i, item in enumerate(those)
    ]
    found += [(b.approach or "", ("boundaries", n, "approach")) for n, b in ctx.file.boundaries.items()]
    for item, path in found:
        section, written = item_parts(item)
        if re.fullmatch(r"[1-9]\d{0,2}\.\d{3}", written):
            about = Element("sections", section) if path[0] == "tracks" else Element("boundaries", path[1])
            yield called("section", section), float(written), written, ctx.at(*path), about


def _stated(ctx: Context) -> Iterator[tuple[str, float, tuple[float, float], Span, Element]]:
    """Every stated length but those along tracks: what it is of, metres, the usual range, place and element."""
    f = ctx.file
    for name, b in f.boundaries.items():
        if b.approach is not None:
            section, metres = item_parts(b.approach)
            at = ctx.at("boundaries", name, "approach")
            yield f"approach section {section}", float(metres), (SHORT_M, LONG_M), at, Element("boundaries", name)
    for room, kind in (("points", "point"), ("crossings", "diamond"), ("slips", "slip"), ("derailers", "derailer")):
        for name, spec in getattr(f, room).items():
            for key, text in (
                ("legs", f"each leg of {kind} {name}"),
                ("fouling", f"the fouling part of {kind} {name}"),
            ):
                stated = getattr(spec, key, None)
                if stated is not None:
                    yield text, stated, LEG_M, ctx.at(room, name, key), Element(room, name)


def _sections(ctx: Context, layout: Layout) -> Iterator[tuple[str, float, tuple[float, float], Span, Element]]:
    """Sections along each track, whether their lengths are stated or follow from positions; what is written in pieces
    that follow one another is as long as all of them."""
    f = ctx.file
    ends = {*f.boundaries, *f.buffers, *f.traps}
    for track, items in f.tracks.items():
        pieces: list[tuple[str, float, int]] = []
        for i, item in enumerate(items):
            section, _ = item_parts(item)
            if item.strip() not in ends and NAME.fullmatch(section):
                pieces.append((section, layout.track.edge[EdgeId(f"{track}.{len(pieces)}")].length, i))
        for section, group in groupby(pieces, key=lambda piece: piece[0]):
            those = list(group)
            at, about = ctx.at("tracks", track, those[0][2]), Element("sections", section)
            yield called("section", section), sum(metres for _, metres, _ in those), (SHORT_M, LONG_M), at, about


def _distance(metres: float) -> str:
    return f"{metres:g} m" if metres < 10_000 else f"{metres / 1000:g} km"
