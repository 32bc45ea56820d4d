"""What the author states, and nothing in the layout ever asks: a principle without effect, a zone that is never full.

Warning IL7021: a principle that is stated other than the profile has it, for what this layout has not.  A profile, or
a delay, for what a layout lacks is told by nobody: it restricts as soon as there is something to restrict.

Warning IL7022: a zone into which no route leads, or that admits more trains than it has sections.
"""

from __future__ import annotations

from collections.abc import Sequence

from interlock.diag import Element, Sink
from interlock.diag.called import called
from interlock.model.elements import Lane
from interlock.model.layout import Layout
from interlock.model.principles import PROFILES, Caution
from interlock.table.cells import RouteKind
from interlock.table.rows import RouteRow


def check_idle(layout: Layout, rows: Sequence[RouteRow], sink: Sink) -> None:
    """Report principles that change nothing here, and zones that keep no train out."""
    if sink.has_errors:
        return
    _slow(layout, rows, sink)
    _order(layout, sink)
    _zones(layout, rows, sink)


def _slow(layout: Layout, rows: Sequence[RouteRow], sink: Sink) -> None:
    """A limit of speed below which signals show caution, where none can or no route has a speed (R11)."""
    own = layout.principles
    if not own.slow_below_kmh:
        return
    if own.caution is Caution.NEVER:
        why = "with `caution: never` no main signal shows caution instead of clear"
        fix = "state `caution: next`, or remove it: where speeds are stated, the indicator alone tells them"
    elif all(r.signal.speed.kmh is None for r in rows if r.kind is RouteKind.MAIN):
        why = "no train route has a speed, of its path or for its overlap"
        fix = "state the `speed` of sections, or of points over their reverse legs; or remove it"
    else:
        return
    _report("slow_below_kmh", f"{own.slow_below_kmh:g}", why, fix, sink)


def _order(layout: Layout, sink: Sink) -> None:
    """An order among voyages and requests, where they are all of one class (R18)."""
    lanes = any(s.lane is Lane.INCLINED for s in layout.track.sections)
    asked = layout.principles.priorities and not PROFILES[layout.profile].priorities
    if asked and not lanes and not layout.declared.voyages:
        why = "there is no voyage and no inclined lane, so that all requests are of one class"
        fix = "declare `voyages`, or say which section is an inclined lane (`lane: inclined`); or remove it"
        _report("priorities", "yes", why, fix, sink)


def _report(name: str, value: str, why: str, fix: str, sink: Sink) -> None:
    sink.add("IL7021", f"`{name}: {value}` has no effect: {why}", None, fix, about=Element("principles", name))


def _zones(layout: Layout, rows: Sequence[RouteRow], sink: Sink) -> None:
    """Zones of which no route asks for room, or of which every route finds some: a section counts once (R17)."""
    entered = {c.zone for r in rows for c in r.conditions.zones}
    for z in layout.declared.zones:
        many = len(z.sections)
        if z.id not in entered:
            why, fix = "no route leads into it from outside", "correct its sections, or remove it"
        elif z.trains > many:
            holds = "1 section, and that counts" if many == 1 else f"{many} sections, each of which counts"
            why = f"it has {holds} as one train at most, and room for {z.trains}"
            fix = (
                f"let fewer trains in, for instance `trains: {max(1, many - 1)}`, or name the sections that are missing"
            )
        else:
            continue
        sink.add("IL7022", f"{called('zone', z.id)} keeps no train out: {why}", None, fix, about=Element("zones", z.id))
