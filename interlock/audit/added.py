"""What the author adds to the derivation, seen from the audit's own paths."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from interlock.audit.walk import Trip
from interlock.model.elements import Choice, of_points, of_sections
from interlock.model.layout import Layout
from interlock.table.rows import InterlockingTable


def chosen(x: Choice, t: Trip) -> bool:
    """Whether the author's choice fits a path."""
    return (
        (x.entry is None or x.entry == t.entry)
        and (x.exit is None or x.exit in (t.exit, t.sections[-1], t.moves[-1].node))
        and all(s in t.sections for s in x.via)
        and not any(s in t.sections for s in x.not_via)
        and (x.shunt is None or x.shunt == t.shunt)
        and (t.call_on or not x.called_on)
    )


def declared(layout: Layout, a: Trip, b: Trip) -> bool:
    """Whether the author declares two paths hostile."""
    return any(
        (chosen(x.one, a) and chosen(x.other, b)) or (chosen(x.one, b) and chosen(x.other, a))
        for x in layout.declared.barred
    )


def added(layout: Layout, table: InterlockingTable, matched: Mapping[str, Trip]) -> Iterator[tuple[str, str, str]]:
    """Route, column and text where an addition is not in the table, or the table says that there is one."""
    for r in table.routes:
        mine = matched.get(r.id)
        if mine is None:
            continue
        others = (o for o in table.routes if o is not r and o.id in matched) if layout.declared.barred else ()
        barred = {o.id for o in others if declared(layout, mine, matched[o.id])}
        if {c.route for c in r.locking.barred} != barred:
            yield r.id, "barred", f"declared hostile are {', '.join(sorted(barred)) or 'none'}"
        if not barred <= set(r.locking.hostile.routes):
            yield r.id, "hostile", f"hostile by declaration are {', '.join(sorted(barred))}"
        clear = {d.section for d in of_sections(layout.declared.demanded) if chosen(d.routes, mine)}
        if {c.section for c in r.clear.demanded or ()} != clear:
            yield r.id, "sections", f"demanded clear are {', '.join(sorted(clear)) or 'none'}"
        wishes = [d for d in of_points(layout.declared.demanded) if chosen(d.routes, mine)]
        longest = max((d.hold for d in wishes), default=0)
        if max((p.hold or 0 for p in r.locking.points if p.role == "added"), default=0) != longest:
            yield r.id, "points", f"what is demanded is held {longest:g} s longer"
        asked = {(d.machine, d.position) for d in wishes}
        lies = {(p.machine, p.position) for p in r.locking.points}
        for m, x in sorted(asked - lies):
            yield r.id, "points", f"{m} {x} is demanded"
        for m, x in sorted({(p.machine, p.position) for p in r.locking.points if p.role == "added"} - asked):
            yield r.id, "points", f"nobody demands {m} {x}"
