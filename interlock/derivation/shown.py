"""Routes that would show a speed above the line's over sections that state none (R11).  IL4021."""

from __future__ import annotations

from collections.abc import Sequence

from interlock.diag import Element, Sink
from interlock.model.elements import SectionId, SignalId
from interlock.model.layout import Layout
from interlock.table.cells import RouteKind
from interlock.table.rows import RouteRow


def check_shown(layout: Layout, rows: Sequence[RouteRow], sink: Sink) -> None:
    """Report, signal by signal, where a speed that is stated of one part of a way would be shown for all of it, while
    every delay takes the line's speed for the sections that state none."""
    by_id = {r.id: r for r in rows}
    line = layout.principles.line_speed_kmh
    found: dict[SignalId, tuple[RouteRow, dict[SectionId, None]]] = {}
    for r in rows:
        kmh = r.signal.speed.kmh
        if r.kind not in (RouteKind.MAIN, RouteKind.IDENTIFIER) or kmh is None or kmh <= line:
            continue
        over = [*r.path.section_ids]
        onward = r.path.onward
        while onward is not None:
            over += by_id[onward].path.section_ids
            onward = by_id[onward].path.onward
        bare = [s for s in over if layout.track.section[s].speed is None]
        if bare:
            found.setdefault(r.entry, (r, {}))[1].update(dict.fromkeys(bare))
    for g, (r, sections) in found.items():
        names = ", ".join(list(sections)[:4]) + (f" and {len(sections) - 4} more" if len(sections) > 4 else "")
        state = "states" if len(sections) == 1 else "state"
        sink.add(
            "IL4021",
            f"{r.id} would show {r.signal.speed.kmh} km/h, and {names} {state} no speed: the delays there are made for "
            f"{line:g} km/h",
            None,
            f"state the speed of {names} (`sections`), or `principles: {{line_speed_kmh: {r.signal.speed.kmh}}}`",
            about=Element("signals", g),
        )
